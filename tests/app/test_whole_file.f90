!> Files read whole.
program test_whole_file
    use app_whole_file, only: read_whole
    use base_error, only: error_type
    use base_posix, only: c_getpid
    use base_text, only: to_text
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(error_type), allocatable :: error
    character(:), allocatable :: text, name
    integer :: unit, i

    name = '/tmp/loft-test-whole-file-'//to_text(int(c_getpid()))
    open (newunit=unit, file=name, access='stream', form='unformatted')
    write (unit) [(char(mod(i, 256)), i = 1, 300000)]
    flush (unit)
    call read_whole(name, text, error)
    call tap%ok(.not. allocated(error) .and. len(text) == 300000, 'a file is read to its end')
    call tap%ok(all([(text(i:i) == char(mod(i, 256)), i = 1, len(text))]), 'byte for byte')
    call read_whole('/dev/null', text, error)
    call tap%ok(.not. allocated(error) .and. len(text) == 0, 'one with nothing in it')
    call read_whole('/nonexistent/deck', text, error)
    call tap%ok(allocated(error), 'none is an error')
    call tap%has(error%message, '/nonexistent/deck: No such file or directory', 'in words')
    call read_whole('/', text, error)
    call tap%has(error%message, '/: Is a directory', 'a folder is no file')
    close (unit, status='delete')
    call tap%finish()
end program test_whole_file
