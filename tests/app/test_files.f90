!> Results appear whole or not at all.
program test_files
    use app_files, only: base_name, make_folder, result_file_type
    use base_error, only: error_type
    use base_output, only: output_type
    use base_posix, only: c_getpid
    use base_text, only: to_text
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(:), allocatable :: folder

    folder = '/tmp/loft-test-files-'//to_text(int(c_getpid()))
    call check_folder()
    call check_result()
    call check_abandoned()
    call check_refused()
    call tap%same(base_name('cards/nose.crd'), 'nose.crd', 'the name of a path is its last part')
    call tap%same(base_name('nose.crd'), 'nose.crd', 'a path without folder is its own name')
    call execute_command_line('rm -r '//folder)
    call tap%finish()

contains

    !> A folder is made once; a second time it is simply there.
    subroutine check_folder()
        type(error_type), allocatable :: error
        call make_folder(folder, error)
        call tap%ok(.not. allocated(error), 'a folder is made')
        call make_folder(folder, error)
        call tap%ok(.not. allocated(error), 'a folder that is there will do')
        call make_folder(folder//'/no/such', error)
        call tap%ok(allocated(error), 'a folder in no folder is an error')
        if (allocated(error)) call tap%same(error%message, &
            folder//'/no/such: No such file or directory', 'with the name and the system''s words')
    end subroutine check_folder

    !> A result has its name only when it is complete, and replaces what had it.
    subroutine check_result()
        type(result_file_type) :: first, second
        type(output_type) :: out, later
        type(error_type), allocatable :: error

        call first%begin(folder//'/a', out, error)
        call out%line('one')
        call out%flush(error)
        call tap%ok(.not. is_there(folder//'/a'), 'an unfinished result has not its name')
        call first%complete(out, error)
        call tap%ok(.not. allocated(error), 'a result is completed')
        call tap%same(content(folder//'/a'), 'one', 'and holds what was put')
        call second%begin(folder//'/a', later, error)
        call later%line('two')
        call tap%same(content(folder//'/a'), 'one', 'the old result stays while a new one is made')
        call second%complete(later, error)
        call tap%same(content(folder//'/a'), 'two', 'and is replaced at the end')
        call tap%ok(.not. is_there(part_of('a')), 'no unfinished file is left')
    end subroutine check_result

    !> A result given up leaves nothing.
    subroutine check_abandoned()
        type(result_file_type) :: file
        type(output_type) :: out
        type(error_type), allocatable :: error
        call file%begin(folder//'/b', out, error)
        call out%line('half')
        call out%flush(error)
        call tap%ok(is_there(part_of('b')), 'an unfinished result stands beside its name')
        call file%abandon()
        call tap%ok(.not. is_there(folder//'/b') .and. .not. is_there(part_of('b')), &
            'a result given up leaves nothing')
    end subroutine check_abandoned

    !> Places where nothing can be written.
    subroutine check_refused()
        type(result_file_type) :: nowhere, full
        type(output_type) :: out, lost
        type(error_type), allocatable :: error

        call nowhere%begin(folder//'/no/such', out, error)
        call tap%ok(allocated(error), 'a result in no folder is an error')
        call full%begin('/dev/full', lost, error)
        call tap%ok(.not. allocated(error), 'a device is opened')
        call lost%line('lost')
        call full%complete(lost, error)
        call tap%ok(allocated(error), 'a full device is an error')
        if (allocated(error)) call tap%same(error%message, '/dev/full: No space left on device', &
            'with its name and the system''s words')
        call tap%ok(is_there('/dev/full'), 'and the device is still there')
    end subroutine check_refused

    !> The unfinished file of a result.
    function part_of(name) result(path)
        character(*), intent(in) :: name !! of the result
        character(:), allocatable :: path
        path = folder//'/'//name//'.part'//to_text(int(c_getpid()))
    end function part_of

    !> True where a path exists.
    logical function is_there(path)
        character(*), intent(in) :: path !! any path
        inquire (file=path, exist=is_there)
    end function is_there

    !> The first line of a file.
    function content(path) result(text)
        character(*), intent(in) :: path !! any path
        character(:), allocatable :: text
        character(80) :: line
        integer :: unit, status
        line = ''
        open (newunit=unit, file=path, action='read', status='old', iostat=status)
        if (status == 0) read (unit, '(a)', iostat=status) line
        if (status == 0) close (unit)
        text = trim(line)
    end function content

end program test_files
