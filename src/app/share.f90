!> Where LOFT finds the gnuplot scripts that came with it.
module app_share
    use base_error, only: cause, error_type, fail
    use base_posix, only: read_link
    implicit none (type, external)
    private

    public :: find_scripts

    !> One folder to look in.
    type :: folder_type
        character(:), allocatable :: path !! without a `/` at its end
    end type folder_type

contains

    !> Finds the folder with a script: the one LOFT_PLOT names, else `plot` above the program (as
    !> built), else `share/loft/plot` beside its folder (as installed).
    !>
    !> Fails with `cause%file_trouble` and the folders that were looked in.
    subroutine find_scripts(script, folder, error)
        character(*), intent(in) :: script                  !! file that must be there
        character(:), allocatable, intent(out) :: folder    !! path of the folder
        type(error_type), allocatable, intent(out) :: error !! see above
        type(folder_type), allocatable :: folders(:)
        character(:), allocatable :: looked
        integer :: i
        logical :: exists

        allocate (folders, source=candidates())
        looked = ''
        do i = 1, size(folders)
            folder = folders(i)%path
            inquire (file=folder//'/'//script, exist=exists)
            if (exists) return
            looked = looked//' '//folder
        end do
        call fail(error, cause%file_trouble, 'the gnuplot scripts of LOFT ('//script// &
            ') are not in any of:'//looked//'; set LOFT_PLOT to their folder')
    end subroutine find_scripts

    !> The folders to look in, best first.
    function candidates() result(folders)
        type(folder_type), allocatable :: folders(:)
        character(:), allocatable :: named, here

        named = variable('LOFT_PLOT')
        if (named /= '') then
            allocate (folders(1))
            folders(1)%path = named
        else
            here = folder_of(program_path())
            allocate (folders(3))
            folders(1)%path = here//'/../plot'
            folders(2)%path = here//'/../../plot'
            folders(3)%path = here//'/../share/loft/plot'
        end if
    end function candidates

    !> The file this program runs from: what the system says, where it says it (Linux), else the
    !> word it was called by, looked up in PATH as the shell did.
    function program_path() result(path)
        character(:), allocatable :: path
        integer :: length

        call read_link('/proc/self/exe', path)
        if (path /= '') return
        call get_command_argument(0, length=length)
        deallocate (path)
        allocate (character(length) :: path)
        call get_command_argument(0, path)
        if (index(path, '/') == 0) path = looked_up(path)
    end function program_path

    !> A program in the folders of PATH; its bare name where it is in none.
    function looked_up(name) result(path)
        character(*), intent(in) :: name !! without a `/`
        character(:), allocatable :: path
        character(:), allocatable :: rest
        integer :: colon
        logical :: exists

        rest = variable('PATH')
        do while (rest /= '')
            colon = index(rest//':', ':')
            path = rest(:colon - 1)//'/'//name
            rest = rest(min(colon, len(rest)) + 1:)
            inquire (file=path, exist=exists)
            if (exists) return
        end do
        path = name
    end function looked_up

    !> The folder a file is in.
    pure function folder_of(path) result(folder)
        character(*), intent(in) :: path !! a file
        character(:), allocatable :: folder
        folder = path(:max(0, index(path, '/', back=.true.) - 1))
        if (index(path, '/') == 0) folder = '.'
    end function folder_of

    !> A variable of the environment; nothing where it is not set.
    function variable(name) result(value)
        character(*), intent(in) :: name !! its name
        character(:), allocatable :: value
        integer :: length
        call get_environment_variable(name, length=length)
        allocate (character(length) :: value)
        if (length > 0) call get_environment_variable(name, value)
    end function variable

end module app_share
