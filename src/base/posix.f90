!> The few services of the operating system that Fortran lacks: reading what has arrived, writing
!> with an error that is seen, renaming, signals. Every name here is POSIX, without variable
!> arguments; the one exception is the number of the last error, which the Fortran runtime keeps.
!> Nothing here knows what a deck is.
module base_posix
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_funptr, c_int, &
        c_intptr_t, c_long, c_null_char, c_ptr, c_short, c_size_t
    implicit none (type, external)
    private

    public :: c_fopen, c_fileno, c_fclose, c_read, c_write, c_creat, c_close, c_rename, c_unlink
    public :: c_fsync, c_fchmod, c_access, c_link, c_readlink, c_mkdir, c_getpid, c_signal, c_raise
    public :: c_alarm, c_isatty, c_atexit, c_exit_now
    public :: c_text, last_error, are_one_file, can_try_again, is_needless, read_link

    !> Descriptor of standard input.
    integer(c_int), parameter, public :: standard_input = 0
    !> Descriptor of standard output.
    integer(c_int), parameter, public :: standard_output = 1
    !> Descriptor of standard error.
    integer(c_int), parameter, public :: standard_error = 2
    !> Bytes of the longest path, its null included.
    integer, parameter, public :: longest_path = 4096
    !> Bytes of the system's words for an error, at most.
    integer, parameter :: longest_error = 256

    !> A descriptor that is waited for.
    type, bind(c) :: poll_type
        integer(c_int) :: descriptor = 0
        integer(c_short) :: wanted = 0  !! to be read or written
        integer(c_short) :: ready = 0
    end type poll_type
    !> What a descriptor is waited for to do: to be read, to be written.
    integer(c_short), parameter, public :: to_read = 1_c_short, to_write = 4_c_short
    !> Numbers of errors that pass: interrupted by a signal; not now (on Linux, on BSD and macOS).
    integer(c_int), parameter :: interrupted = 4_c_int, not_now(2) = [11_c_int, 35_c_int]
    !> What a file that is on no disk says when it is to be brought there.
    integer(c_int), parameter :: invalid = 22_c_int

    interface
        !> Opens a file; a null pointer says that it can't be.
        type(c_ptr) function c_fopen(path, mode) bind(c, name='fopen')
            import :: c_char, c_ptr
            character(kind=c_char), intent(in) :: path(*) !! ends with a null
            character(kind=c_char), intent(in) :: mode(*) !! `r`; `wx`: a new one; ends with a null
        end function c_fopen

        !> The descriptor behind an open file.
        integer(c_int) function c_fileno(stream) bind(c, name='fileno')
            import :: c_int, c_ptr
            type(c_ptr), value :: stream !! from `c_fopen`
        end function c_fileno

        !> Closes a file of `c_fopen`.
        integer(c_int) function c_fclose(stream) bind(c, name='fclose')
            import :: c_int, c_ptr
            type(c_ptr), value :: stream !! from `c_fopen`
        end function c_fclose

        !> Reads what has arrived, at most `count` bytes; 0 at the end, -1 where it fails.
        integer(c_intptr_t) function c_read(descriptor, buffer, count) bind(c, name='read')
            import :: c_char, c_int, c_intptr_t, c_size_t
            integer(c_int), value :: descriptor                !! open for reading
            character(kind=c_char), intent(inout) :: buffer(*) !! where the bytes go
            integer(c_size_t), value :: count                  !! how many at most
        end function c_read

        !> Writes up to `count` bytes; the number written, or -1.
        integer(c_intptr_t) function c_write(descriptor, buffer, count) bind(c, name='write')
            import :: c_char, c_int, c_intptr_t, c_size_t
            integer(c_int), value :: descriptor             !! open for writing
            character(kind=c_char), intent(in) :: buffer(*) !! the bytes
            integer(c_size_t), value :: count               !! how many
        end function c_write

        !> Opens a file for writing, made or emptied; its descriptor, or -1.
        integer(c_int) function c_creat(path, mode) bind(c, name='creat')
            import :: c_char, c_int
            character(kind=c_char), intent(in) :: path(*) !! ends with a null
            integer(c_int), value :: mode                 !! permissions before the umask
        end function c_creat

        !> Closes a descriptor; -1 where a late write failed.
        integer(c_int) function c_close(descriptor) bind(c, name='close')
            import :: c_int
            integer(c_int), value :: descriptor !! from `c_creat`
        end function c_close

        !> Gives a file another name, replacing what had that name, in one step.
        integer(c_int) function c_rename(old, new) bind(c, name='rename')
            import :: c_char, c_int
            character(kind=c_char), intent(in) :: old(*) !! ends with a null
            character(kind=c_char), intent(in) :: new(*) !! ends with a null
        end function c_rename

        !> Removes a file. May be called in a signal handler.
        integer(c_int) function c_unlink(path) bind(c, name='unlink')
            import :: c_char, c_int
            character(kind=c_char), intent(in) :: path(*) !! ends with a null
        end function c_unlink

        !> Has all that was written to a descriptor brought to the disk; -1 where that fails.
        integer(c_int) function c_fsync(descriptor) bind(c, name='fsync')
            import :: c_int
            integer(c_int), value :: descriptor !! open for writing
        end function c_fsync

        !> Sets the permissions of an open file; -1 where they can't be set.
        integer(c_int) function c_fchmod(descriptor, mode) bind(c, name='fchmod')
            import :: c_int
            integer(c_int), value :: descriptor !! open
            integer(c_int), value :: mode       !! permissions; the umask has no part in them
        end function c_fchmod

        !> 0 where a file may be used so, else -1.
        integer(c_int) function c_access(path, use) bind(c, name='access')
            import :: c_char, c_int
            character(kind=c_char), intent(in) :: path(*) !! ends with a null
            integer(c_int), value :: use                  !! 2: to be written
        end function c_access

        !> Gives a file a second name; -1 where it can't be given.
        integer(c_int) function c_link(old, new) bind(c, name='link')
            import :: c_char, c_int
            character(kind=c_char), intent(in) :: old(*) !! ends with a null
            character(kind=c_char), intent(in) :: new(*) !! ends with a null
        end function c_link

        !> Reads what a symbolic link points to; -1 where the path is no link.
        integer(c_intptr_t) function c_readlink(path, buffer, count) bind(c, name='readlink')
            import :: c_char, c_intptr_t, c_size_t
            character(kind=c_char), intent(in) :: path(*)      !! ends with a null
            character(kind=c_char), intent(inout) :: buffer(*) !! where the target goes
            integer(c_size_t), value :: count                  !! room there
        end function c_readlink

        !> The path of a file from the root, without links; a null pointer where there is no file.
        type(c_ptr) function c_realpath(path, resolved) bind(c, name='realpath')
            import :: c_char, c_ptr
            character(kind=c_char), intent(in) :: path(*)        !! ends with a null
            character(kind=c_char), intent(inout) :: resolved(*) !! room for `longest_path`
        end function c_realpath

        !> Makes a folder; -1 where it can't be made or is there.
        integer(c_int) function c_mkdir(path, mode) bind(c, name='mkdir')
            import :: c_char, c_int
            character(kind=c_char), intent(in) :: path(*) !! ends with a null
            integer(c_int), value :: mode                 !! permissions before the umask
        end function c_mkdir

        !> The number of this process.
        integer(c_int) function c_getpid() bind(c, name='getpid')
            import :: c_int
        end function c_getpid

        !> Says which procedure a signal calls; a null pointer restores what the system does.
        type(c_funptr) function c_signal(number, handler) bind(c, name='signal')
            import :: c_funptr, c_int
            integer(c_int), value :: number  !! which signal
            type(c_funptr), value :: handler !! called with that number
        end function c_signal

        !> Sends a signal to this process.
        integer(c_int) function c_raise(number) bind(c, name='raise')
            import :: c_int
            integer(c_int), value :: number !! which signal
        end function c_raise

        !> Asks for the alarm signal after some seconds; 0 takes an alarm back. Seconds left before.
        integer(c_int) function c_alarm(seconds) bind(c, name='alarm')
            import :: c_int
            integer(c_int), value :: seconds !! not negative
        end function c_alarm

        !> 1 where a descriptor is a terminal.
        integer(c_int) function c_isatty(descriptor) bind(c, name='isatty')
            import :: c_int
            integer(c_int), value :: descriptor !! any
        end function c_isatty

        !> Has a procedure called when the program comes to its end; not 0 where it won't be.
        integer(c_int) function c_atexit(procedure) bind(c, name='atexit')
            import :: c_funptr, c_int
            type(c_funptr), value :: procedure !! without arguments
        end function c_atexit

        !> Ends the program at once, without anything that is done at an end.
        subroutine c_exit_now(status) bind(c, name='_exit')
            import :: c_int
            integer(c_int), value :: status !! the exit status
        end subroutine c_exit_now

        !> Waits until a descriptor is ready.
        integer(c_int) function c_poll(waited_for, count, milliseconds) bind(c, name='poll')
            import :: c_int, c_long, poll_type
            type(poll_type), intent(inout) :: waited_for(*) !! the descriptors
            integer(c_long), value :: count                 !! of them
            integer(c_int), value :: milliseconds           !! -1: as long as it takes
        end function c_poll

        !> The runtime's copy of C's `errno`, which is a macro and so has no name of its own.
        integer(c_int) function error_number() bind(c, name='_gfortran_ierrno_i4')
            import :: c_int
        end function error_number

        !> The system's words for an error number.
        type(c_ptr) function c_strerror(number) bind(c, name='strerror')
            import :: c_int, c_ptr
            integer(c_int), value :: number !! from `error_number`
        end function c_strerror
    end interface

contains

    !> A Fortran text as C wants it: with a null at its end. Trailing blanks are kept.
    pure function c_text(text)
        character(*), intent(in) :: text !! any text without a null
        character(len(text, c_size_t) + 1_c_size_t) :: c_text
        c_text = text//c_null_char
    end function c_text

    !> The system's words for why its last service failed, blanks behind them. Call it at once.
    function last_error() result(words)
        character(longest_error) :: words
        character(kind=c_char), pointer :: letter(:)
        type(c_ptr) :: text

        words = ''
        text = c_strerror(error_number())
        if (.not. c_associated(text)) return
        call c_f_pointer(text, letter, [longest_error])
        words = before_null(letter)
    end function last_error

    !> True where the last service on a descriptor failed only for now: a signal came, or it does
    !> not wait by itself, as some terminals and pipes, and is ready now. Call it at once.
    logical function can_try_again(descriptor, use)
        integer(c_int), intent(in) :: descriptor !! that was to be read or written
        integer(c_short), intent(in) :: use      !! `to_read` or `to_write`
        type(poll_type) :: waited_for(1)
        integer(c_int) :: number, ignored

        number = error_number()
        can_try_again = number == interrupted .or. any(number == not_now)
        if (.not. any(number == not_now)) return
        waited_for(1) = poll_type(descriptor, use, 0_c_short)
        ignored = c_poll(waited_for, 1_c_long, -1_c_int)
    end function can_try_again

    !> True where `c_fsync` failed only because there is no disk behind a file. Call it at once.
    logical function is_needless()
        is_needless = error_number() == invalid
    end function is_needless

    !> Reads what a symbolic link says: nothing where there is no link.
    subroutine read_link(path, target)
        character(*), intent(in) :: path                    !! any path
        character(:), allocatable, intent(out) :: target    !! the path in the link
        character(kind=c_char) :: letter(longest_path)
        integer :: length

        length = int(c_readlink(c_text(path), letter, int(longest_path, c_size_t)))
        target = joined(letter(:max(0, length)))
    end subroutine read_link

    !> True where two names lead to one file that is there, by whatever links, `.` and `..`.
    logical function are_one_file(name, other)
        character(*), intent(in) :: name    !! any path
        character(*), intent(in) :: other   !! any path
        character(kind=c_char), dimension(longest_path) :: path, other_path

        are_one_file = .false.
        if (.not. c_associated(c_realpath(c_text(name), path))) return
        if (.not. c_associated(c_realpath(c_text(other), other_path))) return
        are_one_file = before_null(path) == before_null(other_path)
    end function are_one_file

    !> Letters of a text of C; what is behind its null is not looked at.
    pure integer(c_size_t) function letters_before_null(letter) result(number)
        character(kind=c_char), intent(in) :: letter(:) !! the text, a null behind it
        do number = 0_c_size_t, size(letter, kind=c_size_t) - 1_c_size_t
            if (letter(number + 1_c_size_t) == c_null_char) return
        end do
    end function letters_before_null

    !> A text of C as Fortran has it.
    pure function before_null(letter) result(text)
        character(kind=c_char), intent(in) :: letter(:) !! the text, a null behind it
        character(letters_before_null(letter)) :: text
        text = joined(letter(:len(text)))
    end function before_null

    !> Letters as one text.
    pure function joined(letter) result(text)
        character(kind=c_char), intent(in) :: letter(:) !! any
        character(size(letter, kind=c_size_t)) :: text
        text = transfer(letter, text)
    end function joined

end module base_posix
