!> The exit statuses of LOFT.
module app_status
    implicit none (type, external)
    private

    !> What the shell is told at the end.
    type, public :: status_list
        integer :: done = 0     !! all done
        integer :: faulty = 1   !! some card was in error; the others ran and their output is whole
        integer :: unusable = 2 !! the command line is wrong, or a file can't be read or written
    end type status_list

    !> The statuses by name: `status%faulty`.
    type(status_list), parameter, public :: status = status_list()

end module app_status
