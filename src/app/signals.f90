!> What happens when LOFT is told to stop in mid-run: the unfinished result file is removed and LOFT
!> ends by the same signal, as the shell expects. SIGPIPE ends it in any case.
!>
!> A signal handler is told nothing but a number, so the name of the unfinished file has to stand
!> where the handler finds it: the one module variable of LOFT.
module app_signals
    use, intrinsic :: iso_c_binding, only: c_char, c_funloc, c_funptr, c_int, c_intptr_t, &
        c_null_char, c_null_funptr
    use base_posix, only: c_raise, c_signal, c_text, c_unlink, longest_path
    implicit none (type, external)
    private

    public :: guard_file, release_file

    !> Hang-up, interrupt, broken pipe and termination, numbered alike on every POSIX system.
    integer(c_int), parameter :: caught(4) = [1_c_int, 2_c_int, 13_c_int, 15_c_int]
    !> What stands in the place of a handler where a signal is ignored, as by `nohup`: it stays so.
    integer(c_intptr_t), parameter :: ignored_signal = 1_c_intptr_t
    !> The path of the unfinished file, or a null byte.
    character(kind=c_char), volatile :: unfinished(longest_path) = c_null_char

contains

    !> From now on a signal that is not ignored removes this file. A path longer than 4095 bytes is
    !> not guarded.
    subroutine guard_file(path)
        character(*), intent(in) :: path !! the unfinished file
        type(c_funptr) :: before
        character(:), allocatable :: text
        integer :: i

        text = c_text(path)
        if (len(text) > longest_path) return
        do i = len(text), 1, -1
            unfinished(i) = text(i:i)
        end do
        do i = 1, size(caught)
            before = c_signal(caught(i), c_funloc(stop_by_signal))
            if (transfer(before, 0_c_intptr_t) == ignored_signal) then
                before = c_signal(caught(i), before)
            end if
        end do
    end subroutine guard_file

    !> From now on a signal finds nothing to remove: the file is finished or gone.
    subroutine release_file()
        unfinished(1) = c_null_char
    end subroutine release_file

    !> The handler: removes the file, then lets the signal do what it does by nature. It calls
    !> only what POSIX allows in a handler.
    subroutine stop_by_signal(number) bind(c)
        integer(c_int), value :: number !! the signal
        type(c_funptr) :: before
        integer(c_int) :: ignored
        if (unfinished(1) /= c_null_char) ignored = c_unlink(unfinished)
        before = c_signal(number, c_null_funptr)
        ignored = c_raise(number)
    end subroutine stop_by_signal

end module app_signals
