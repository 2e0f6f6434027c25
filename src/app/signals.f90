!> What happens when LOFT is stopped in mid-run: unfinished result files are removed. Told to stop
!> by a signal, LOFT says so and ends by the same signal, as the shell expects; SIGPIPE ends it in
!> any case, without a word.
!> Where the Fortran runtime gives up, for want of memory above all, the exit status is 2, as for
!> any other thing that can't be done.
!>
!> A signal handler is told nothing but a number, so the names of the unfinished files, and what is
!> to be said, have to stand where the handler finds them: in variables of this module.
module app_signals
    use, intrinsic :: iso_c_binding, only: c_char, c_funloc, c_funptr, c_int, c_intptr_t, &
        c_null_char, c_null_funptr, c_size_t
    use app_status, only: status
    use base_posix, only: c_atexit, c_exit_now, c_isatty, c_raise, c_signal, c_text, c_unlink, &
        c_write, longest_path, standard_error
    implicit none (type, external)
    private

    public :: guard_run, end_run, stop_for, guard_file, release_file, advise

    !> Hang-up, interrupt, quit, broken pipe, termination, time used up, and the crashes (illegal
    !> instruction, abort, bus error by two numbers, arithmetic, segmentation), numbered alike on
    !> Linux, BSD and macOS.
    integer(c_int), parameter :: caught(12) = [1_c_int, 2_c_int, 3_c_int, 13_c_int, 15_c_int, &
        24_c_int, 4_c_int, 6_c_int, 7_c_int, 10_c_int, 8_c_int, 11_c_int]
    !> What is said of those that are not crashes; of a broken pipe nothing.
    character(19), parameter :: said_of(6) = [character(19) :: 'hung up', 'interrupted', 'quit', &
        '', 'terminated', 'out of time']
    !> A file grows beyond what is allowed: without a handler LOFT would end before it can say so.
    integer(c_int), parameter :: file_too_large = 25_c_int
    !> What stands in the place of a handler where a signal is ignored, as by `nohup`: it stays so.
    integer(c_intptr_t), parameter :: ignored_signal = 1_c_intptr_t
    !> Unfinished files that can be guarded at a time.
    integer, parameter :: most_files = 1024
    !> Their paths, each with a null behind it; one that begins with a null is none.
    character(kind=c_char), volatile :: unfinished(longest_path, most_files)
    !> How many of these have been used.
    integer, volatile :: used = 0
    !> What follows on the message of a signal, and how many of its bytes count.
    character(kind=c_char), volatile :: advice(longest_path + 100)
    integer, volatile :: advised = 0
    !> What each signal did before it was caught; whether LOFT ends by itself; whether messages go
    !> to a terminal, where the line may have been begun.
    type(c_funptr) :: former(size(caught))
    logical, volatile :: has_ended = .false., is_watched = .false.

contains

    !> What the message of a signal says besides, from now on: what the user can do.
    subroutine advise(words)
        character(*), intent(in) :: words !! a few words; none: nothing
        integer :: i
        advised = 0
        do i = 1, min(len(words), size(advice))
            advice(i) = words(i:i)
        end do
        advised = min(len(words), size(advice))
    end subroutine advise

    !> From now on a signal that is not ignored removes this file. A path longer than 4095 bytes is
    !> not guarded, nor are more files than 1024 at a time.
    subroutine guard_file(path, guard)
        character(*), intent(in) :: path    !! the unfinished file
        integer, intent(out) :: guard       !! for `release_file`; 0: it is not guarded
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
    end subroutine guard_file

    !> Sets the handler of all signals that are not ignored.
    subroutine catch_signals()
        type(c_funptr) :: before
        integer :: i
        do i = 1, size(caught)
            former(i) = c_signal(caught(i), c_funloc(stop_by_signal))
            if (transfer(former(i), 0_c_intptr_t) == ignored_signal) then
                before = c_signal(caught(i), former(i))
            end if
        end do
    end subroutine catch_signals

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

    !> A run begins: signals are caught. A file that grows too large is from now on an error like
    !> any other.
    subroutine guard_run()
        type(c_funptr) :: before
        integer(c_int) :: ignored
        is_watched = c_isatty(standard_error) == 1
        call catch_signals()
        before = c_signal(file_too_large, c_funloc(go_on))
        if (transfer(before, 0_c_intptr_t) == ignored_signal) then
            before = c_signal(file_too_large, before)
        end if
        ignored = c_atexit(c_funloc(stop_at_exit))
    end subroutine guard_run

    !> A run has come to its end by itself.
    subroutine end_run()
        has_ended = .true.
    end subroutine end_run

    !> Removes the unfinished files.
    subroutine remove_unfinished() bind(c)
        integer(c_int) :: ignored
        integer :: i
        do i = 1, used
            if (unfinished(1, i) /= c_null_char) ignored = c_unlink(unfinished(1, i))
        end do
    end subroutine remove_unfinished

    !> The handler: removes the files, says what happened, then lets the signal do what it did
    !> before. It calls only what POSIX allows in a handler.
    subroutine stop_by_signal(number) bind(c)
        integer(c_int), value :: number !! the signal
        type(c_funptr) :: before
        integer(c_int) :: ignored
        integer :: i

        call remove_unfinished()
        call tell_signal(number)
        before = c_signal(number, c_null_funptr)
        do i = 1, size(caught)
            if (caught(i) == number) before = c_signal(number, former(i))
        end do
        ignored = c_raise(number)
    end subroutine stop_by_signal

    !> Says that a signal ended the run, where there is something to say.
    subroutine tell_signal(number)
        integer(c_int), intent(in) :: number !! the signal
        integer(c_intptr_t) :: taken
        integer :: i

        do i = 1, size(said_of)
            if (caught(i) /= number .or. said_of(i) == '') cycle
            if (is_watched) call tell(new_line('a'))
            call tell('loft: ')
            taken = c_write(standard_error, said_of(i), len_trim(said_of(i), c_size_t))
            taken = c_write(standard_error, advice, int(advised, c_size_t))
            call tell(new_line('a'))
        end do
    end subroutine tell_signal

    !> The handler of what is seen from the next write.
    subroutine go_on(number) bind(c)
        integer(c_int), value :: number !! the signal
        if (number /= file_too_large) return
    end subroutine go_on

    !> Called at every end: where the Fortran runtime gave up, it has said why.
    subroutine stop_at_exit() bind(c)
        if (.not. has_ended) call stop_for('out of memory, or at fault itself, as said above')
    end subroutine stop_at_exit

    !> Ends LOFT at once and says why; no result is left. It asks for no memory.
    subroutine stop_for(reason)
        character(*), intent(in) :: reason !! a few words
        call remove_unfinished()
        call tell('loft: ')
        call tell(reason)
        call tell(new_line('a'))
        call c_exit_now(int(status%unusable, c_int))
    end subroutine stop_for

    !> Writes on standard error.
    subroutine tell(words)
        character(*), intent(in) :: words !! any text
        integer(c_intptr_t) :: taken
        taken = c_write(standard_error, words, len(words, c_size_t))
    end subroutine tell

end module app_signals
