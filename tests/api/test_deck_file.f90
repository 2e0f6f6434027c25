!> Decks open and give their lines, or say why not.
program test_deck_file
    use api_deck_file, only: deck_file_type
    use base_error, only: error_type
    use base_posix, only: c_getpid
    use base_text, only: to_text
    use deck_source, only: line_type, source_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(deck_file_type) :: file, folder, missing
    type(source_type) :: source, nothing, none
    type(line_type) :: line
    type(error_type), allocatable :: error
    character(:), allocatable :: path
    logical :: found
    integer :: unit

    path = '/tmp/loft test dÃ©ck '//to_text(int(c_getpid()))
    open (newunit=unit, file=path, action='write')
    write (unit, '(a)') 'two'
    close (unit)
    call file%open(path, source, error)
    call source%next_line(line, found, error)
    call tap%ok(found .and. line%text == 'two', 'a deck is opened and read')
    call file%close()
    call file%close()    ! once too often does no harm
    open (newunit=unit, file=path)
    close (unit, status='delete')

    call missing%open(path, none, error)
    call tap%ok(allocated(error), 'a deck that is not there is an error')
    if (allocated(error)) call tap%same(error%message, path//': No such file or directory', &
        'with its name and the system''s words')

    call folder%open('/tmp', nothing, error)
    if (.not. allocated(error)) call nothing%next_line(line, found, error)
    call tap%ok(allocated(error), 'a folder is no deck')
    if (allocated(error)) call tap%has(error%message, 'Is a directory', 'in the system''s words')
    call folder%close()
    call tap%finish()

end program test_deck_file
