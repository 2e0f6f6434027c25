!> What happens when LOFT is told to stop in mid-run: unfinished result files are removed and LOFT
!> ends by the same signal, as the shell expects. SIGPIPE ends it in any case.
!>
!> A signal handler is told nothing but a number, so the names of the unfinished files have to stand
!> where the handler finds them: the only module variables of LOFT.
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
    !> Unfinished files that can be guarded at a time.
    integer, parameter :: most_files = 1024
    !> Their paths, each with a null behind it; one that begins with a null is none.
    character(kind=c_char), volatile :: unfinished(longest_path, most_files)
    !> How many of these have been used.
    integer, volatile :: used = 0

contains

    !> From now on a signal that is not ignored removes this file. A path longer than 4095 bytes is
    !> not guarded, nor are more files than 1024 at a time.
    subroutine guard_file(path, guard)
        character(*), intent(in) :: path    !! the unfinished file
        integer, intent(out) :: guard       !! for `release_file`; 0: it is not guarded
        type(c_funptr) :: before
        character(:), allocatable :: text
        integer :: i

        guard = 0
        text = c_text(path)
        if (len(text) > longest_path .or. free_place() > most_files) return
        guard = free_place()
        do i = len(text), 1, -1
            unfinished(i, guard) = text(i:i)
        end do
        used = max(used, guard)
        do i = 1, size(caught)
            before = c_signal(caught(i), c_funloc(stop_by_signal))
            if (transfer(before, 0_c_intptr_t) == ignored_signal) then
                before = c_signal(caught(i), before)
            end if
        end do
    end subroutine guard_file

    !> The first place for a path that is not taken.
    integer function free_place()
        do free_place = 1, used
            if (unfinished(1, free_place) == c_null_char) return
        end do
    end function free_place

    !> From now on a signal leaves this file alone: it is finished or gone.
    subroutine release_file(guard)
        integer, intent(in) :: guard !! from `guard_file`
        if (guard > 0) unfinished(1, guard) = c_null_char
    end subroutine release_file

    !> The handler: removes the files, then lets the signal do what it does by nature. It calls
    !> only what POSIX allows in a handler.
    subroutine stop_by_signal(number) bind(c)
        integer(c_int), value :: number !! the signal
        type(c_funptr) :: before
        integer(c_int) :: ignored
        integer :: i
        do i = 1, used
            if (unfinished(1, i) /= c_null_char) ignored = c_unlink(unfinished(1, i))
        end do
        before = c_signal(number, c_null_funptr)
        ignored = c_raise(number)
    end subroutine stop_by_signal

end module app_signals
