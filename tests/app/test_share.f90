!> Where the gnuplot scripts are looked for. The places beside the program are proved in plot.t.
program test_share
    use, intrinsic :: iso_c_binding, only: c_char, c_int
    use app_share, only: find_scripts
    use base_error, only: cause, error_type
    use base_posix, only: c_text
    use support_tap, only: tap_type
    implicit none (type, external)

    interface
        !> Sets a variable of the environment.
        integer(c_int) function c_setenv(name, value, overwrite) bind(c, name='setenv')
            import :: c_char, c_int
            character(kind=c_char), intent(in) :: name(*)  !! ends with a null
            character(kind=c_char), intent(in) :: value(*) !! ends with a null
            integer(c_int), value :: overwrite             !! not zero: also where it is set
        end function c_setenv
    end interface

    type(tap_type) :: tap
    character(:), allocatable :: folder
    type(error_type), allocatable :: error

    call name_folder('/no such folder')
    call find_scripts('style.gp', folder, error)
    call tap%ok(allocated(error), 'LOFT_PLOT is looked in, and nowhere else')
    if (allocated(error)) call tap%ok(error%cause == cause%file_trouble .and. &
        index(error%message, ' /no such folder;') > 0 .and. &
        index(error%message, 'style.gp') > 0, 'the message says for what and where')

    call name_folder('/')
    call find_scripts('dev/null', folder, error)
    call tap%ok(.not. allocated(error), 'a file that is in LOFT_PLOT is found')
    call tap%same(folder, '/', 'its folder is LOFT_PLOT')

    call name_folder('')
    call find_scripts('no such script', folder, error)
    call tap%ok(allocated(error), &
        'an empty LOFT_PLOT is none; a script that is nowhere is not found')
    if (allocated(error)) call tap%ok(index(error%message, '/tests/app/../plot ') > 0 .and. &
        index(error%message, '/tests/app/../../plot ') > 0 .and. &
        index(error%message, '/tests/app/../share/loft/plot;') > 0, &
        'it was looked for beside the program')
    call tap%finish()

contains

    !> Sets LOFT_PLOT.
    subroutine name_folder(name)
        character(*), intent(in) :: name !! its value
        integer(c_int) :: ignored
        ignored = c_setenv(c_text('LOFT_PLOT'), c_text(name), 1_c_int)
    end subroutine name_folder

end program test_share
