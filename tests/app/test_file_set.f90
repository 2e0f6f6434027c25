!> Results that belong together appear together or not at all.
program test_file_set
    use app_file_set, only: file_set_type
    use app_files, only: make_folder
    use base_error, only: error_type
    use base_output, only: output_type
    use base_posix, only: c_getpid
    use base_text, only: to_text
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(error_type), allocatable :: error
    character(:), allocatable :: folder

    folder = '/tmp/loft-test-file-set-'//to_text(int(c_getpid()))
    call make_folder(folder, error)
    call check_published()
    call check_abandoned()
    call check_failing()
    call check_devices()
    call execute_command_line('rm -r '//folder)
    call tap%finish()

contains

    !> Three results get their names together; old ones are replaced.
    subroutine check_published()
        type(file_set_type) :: set, again
        call put(set, 'a', 'one')
        call put(set, 'b', 'two')
        call put(set, 'c', 'three')
        call tap%ok(.not. (is_there('a') .or. is_there('b') .or. is_there('c')), &
            'finished results have not their names')
        call set%publish(error)
        call tap%same(content('a')//content('b')//content('c'), 'onetwothree', &
            'then all have them')
        call put(again, 'b', 'new')
        call put(again, 'c', 'newer')
        call tap%same(content('b')//content('c'), 'twothree', 'old ones stay meanwhile')
        call again%publish(error)
        call tap%same(content('a')//content('b')//content('c'), 'onenewnewer', &
            'and are replaced together')
        call tap%ok(.not. (is_there(part('a')) .or. is_there(part('b'))), 'nothing else is left')
    end subroutine check_published

    !> A set given up: finished and unfinished results go, old ones stay.
    subroutine check_abandoned()
        type(file_set_type) :: set, empty
        type(output_type) :: out
        call put(set, 'a', 'lost')
        call set%begin(folder//'/d', out, error)
        call out%line('half')
        call out%flush(error)
        call tap%ok(is_there(part('a')) .and. is_there(part('d')), &
            'results on their way stand beside their names')
        call set%abandon()
        call tap%ok(content('a') == 'one' .and. .not. (is_there('d') .or. is_there(part('a')) .or. &
            is_there(part('d'))), 'a set given up leaves what was')
        call empty%abandon()
        call tap%ok(content('a') == 'one', 'a set without results can be given up')
    end subroutine check_abandoned

    !> The second result can't be written, or not be renamed.
    subroutine check_failing()
        type(file_set_type) :: set, full, renamed
        type(output_type) :: out, lost
        call put(set, 'e', 'lost')
        call set%begin(folder//'/no/such', out, error)
        call tap%ok(allocated(error), 'a result in no folder is an error')
        call set%abandon()
        call put(full, 'e', 'lost')
        call full%begin('/dev/full', lost, error)
        call lost%line('lost')
        call full%finish(lost, error)
        call tap%same(error%message, '/dev/full: No space left on device', 'so is a full device')
        call full%abandon()
        call tap%ok(.not. (is_there('e') .or. is_there(part('e'))), 'the others are gone')
        call put(renamed, 'f', 'lost')
        call put(renamed, 'g', 'lost')
        call execute_command_line('mkdir -p '//folder//'/f/full')
        call renamed%publish(error)
        call tap%ok(allocated(error), 'a name taken meanwhile by a folder is an error')
        call tap%ok(.not. (is_there('g') .or. is_there(part('f')) .or. is_there(part('g'))), &
            'nothing is left then')
    end subroutine check_failing

    !> What has no folder to put another file in.
    subroutine check_devices()
        type(file_set_type) :: device, file, link, standard
        type(output_type) :: out(4)
        call device%begin('/dev/null', out(1), error)
        call tap%ok(device%is_device(), '/dev/null is a device')
        call file%begin(folder//'/h', out(2), error)
        call tap%ok(.not. file%is_device(), 'a new file is none')
        call execute_command_line('ln -s a '//folder//'/link')
        call link%begin(folder//'/link', out(3), error)
        call tap%ok(.not. link%is_device(), 'nor is a link to a file')
        call standard%begin('-', out(4), error)
        call tap%ok(standard%is_device(), 'standard output is taken for one')
        call device%abandon()
        call file%abandon()
        call link%abandon()
        call standard%abandon()
        call tap%ok(is_there('/dev/null'), 'a device given up is still there')
    end subroutine check_devices

    !> Writes a result of a set.
    subroutine put(set, name, line)
        type(file_set_type), intent(inout) :: set   !! the set
        character(*), intent(in) :: name            !! in the folder
        character(*), intent(in) :: line            !! what it holds
        type(output_type) :: out
        call set%begin(folder//'/'//name, out, error)
        call out%line(line)
        call set%finish(out, error)
    end subroutine put

    !> The name of an unfinished file.
    function part(name)
        character(*), intent(in) :: name !! of the result
        character(:), allocatable :: part
        part = name//'.part'//to_text(int(c_getpid()))
    end function part

    !> True where a path is there, in the folder or from the root.
    logical function is_there(name)
        character(*), intent(in) :: name !! any path
        if (index(name, '/') == 1) then
            inquire (file=name, exist=is_there)
        else
            inquire (file=folder//'/'//name, exist=is_there)
        end if
    end function is_there

    !> The first line of a file in the folder.
    function content(name) result(text)
        character(*), intent(in) :: name !! of the file
        character(:), allocatable :: text
        character(80) :: line
        integer :: unit, status
        line = ''
        open (newunit=unit, file=folder//'/'//name, action='read', status='old', iostat=status)
        if (status == 0) read (unit, '(a)', iostat=status) line
        if (status == 0) close (unit)
        text = trim(line)
    end function content

end program test_file_set
