!> What a long job is doing, told on the last line of a terminal: nothing in the first two seconds,
!> nothing at all where standard error is no terminal. The line is written over in place and wiped
!> away at the end.
!>
!>     call begin_progress()
!>     call tell_progress('cut 3 of 40')
!>     call end_progress()
!>
!> A job that has been busy with one thing since its first second is told of by a signal handler,
!> which takes no arguments: what it says stands in variables of this module.
module app_progress
    use, intrinsic :: iso_c_binding, only: c_char, c_funloc, c_funptr, c_int, c_intptr_t, &
        c_size_t
    use base_kinds, only: i64
    use base_posix, only: c_alarm, c_isatty, c_signal, c_write, standard_error
    use base_text, only: first_bytes, printable, to_text
    implicit none (type, external)
    private

    public :: begin_progress, tell_progress, end_progress, time_words

    !> The alarm signal, numbered alike on Linux, macOS and the BSDs.
    integer(c_int), parameter :: alarm_signal = 14_c_int
    !> Seconds of silence.
    integer(c_int), parameter :: patience = 2_c_int
    !> Characters that are sure to fit a line of a terminal.
    integer, parameter :: widest = 72
    !> Back to the start of the line; wipe to its end.
    character(*), parameter :: to_start = achar(13), wipe = achar(27)//'[K'

    !> The line, and how many of its bytes count: 0 says that nothing is told.
    character(kind=c_char), volatile :: line(4*widest + 16)
    integer, volatile :: length = 0
    !> Someone is looking; the silence is over.
    logical, volatile :: is_watched = .false., is_late = .false.

contains

    !> A job begins.
    subroutine begin_progress()
        type(c_funptr) :: before
        integer(c_int) :: ignored

        is_watched = c_isatty(standard_error) == 1
        if (.not. is_watched) return
        is_late = .false.
        length = 0
        before = c_signal(alarm_signal, c_funloc(be_late))
        ignored = c_alarm(patience)
    end subroutine begin_progress

    !> Tells what is being done from now on.
    subroutine tell_progress(text)
        character(*), intent(in) :: text !! a few words
        character(:), allocatable :: shown
        integer :: i

        if (.not. is_watched) return
        shown = text
        shown = printable(shown)
        shown = to_start//'loft: '//shown(:first_bytes(shown, widest))//wipe
        length = 0
        do i = 1, len(shown)
            line(i) = shown(i:i)
        end do
        length = len(shown)
        if (is_late) call show_line()
    end subroutine tell_progress

    !> The job is done: the line is wiped away, so that what follows has it.
    subroutine end_progress()
        integer(c_int) :: ignored
        integer(c_intptr_t) :: taken

        if (.not. is_watched) return
        ignored = c_alarm(0_c_int)
        is_watched = .false.
        if (is_late) taken = c_write(standard_error, to_start//wipe, int(len(to_start//wipe), &
            c_size_t))
    end subroutine end_progress

    !> A time in words, to two parts: `1 h 20 min`, `2 min 5 s`, `7 s`.
    pure function time_words(seconds) result(words)
        integer(i64), intent(in) :: seconds !! not negative
        character(:), allocatable :: words

        if (seconds >= 3600) then
            words = to_text(seconds/3600)//' h '//to_text(mod(seconds, 3600_i64)/60)//' min'
        else if (seconds >= 60) then
            words = to_text(seconds/60)//' min '//to_text(mod(seconds, 60_i64))//' s'
        else
            words = to_text(seconds)//' s'
        end if
    end function time_words

    !> The handler: the silence is over. It calls only what POSIX allows in a handler.
    subroutine be_late(number) bind(c)
        integer(c_int), value :: number !! the alarm signal
        is_late = number == alarm_signal
        call show_line()
    end subroutine be_late

    !> Writes the line over what stands there.
    subroutine show_line()
        integer(c_intptr_t) :: taken
        if (length > 0) taken = c_write(standard_error, line, int(length, c_size_t))
    end subroutine show_line

end module app_progress
