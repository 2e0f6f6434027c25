!> The few services of the operating system that Fortran lacks: reading what has arrived, writing
!> with an error that is seen, renaming, signals. Every name here is POSIX, without variable
!> arguments; the one exception is the number of the last error, which the Fortran runtime keeps.
!> Nothing here knows what a deck is.
module base_posix
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_funptr, c_int, &
        c_intptr_t, c_int64_t, c_null_char, c_ptr, c_size_t
    implicit none (type, external)
    private

    public :: c_fopen, c_fileno, c_fclose, c_read, c_write, c_creat, c_close, c_rename, c_unlink
    public :: c_truncate, c_readlink, c_mkdir, c_getpid, c_signal, c_raise, c_alarm, c_isatty
    public :: c_text, last_error, real_path

    !> Descriptor of standard input.
    integer(c_int), parameter, public :: standard_input = 0
    !> Descriptor of standard output.
    integer(c_int), parameter, public :: standard_output = 1
    !> Descriptor of standard error.
    integer(c_int), parameter, public :: standard_error = 2
    !> Bytes of the longest path, its null included.
    integer, parameter, public :: longest_path = 4096

    interface
        !> Opens a file; a null pointer says that it can't be.
        type(c_ptr) function c_fopen(path, mode) bind(c, name='fopen')
            import :: c_char, c_ptr
            character(kind=c_char), intent(in) :: path(*) !! ends with a null
            character(kind=c_char), intent(in) :: mode(*) !! `r`, ends with a null
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

        !> Sets the length of a file; only a regular file has one to set.
        integer(c_int) function c_truncate(path, length) bind(c, name='truncate')
            import :: c_char, c_int, c_int64_t
            character(kind=c_char), intent(in) :: path(*) !! ends with a null
            integer(c_int64_t), value :: length           !! bytes
        end function c_truncate

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
        character(:), allocatable :: c_text
        c_text = text//c_null_char
    end function c_text

    !> The system's words for why its last service failed. Call it at once.
    function last_error() result(words)
        character(:), allocatable :: words
        character(kind=c_char), pointer :: letter(:)
        type(c_ptr) :: text

        words = ''
        text = c_strerror(error_number())
        if (.not. c_associated(text)) return
        call c_f_pointer(text, letter, [256])
        words = before_null(letter)
    end function last_error

    !> The path of a file from the root, without links, `.` and `..`: two names of one file have the
    !> same. Nothing where there is no such file.
    function real_path(name) result(path)
        character(*), intent(in) :: name !! any path
        character(:), allocatable :: path
        character(kind=c_char) :: letter(longest_path)

        path = ''
        if (c_associated(c_realpath(c_text(name), letter))) path = before_null(letter)
    end function real_path

    !> A text of C as Fortran has it.
    pure function before_null(letter) result(text)
        character(kind=c_char), intent(in) :: letter(:) !! the text, a null behind it
        character(:), allocatable :: text
        integer :: i

        text = ''
        do i = 1, size(letter)
            if (letter(i) == c_null_char) exit
            text = text//letter(i)
        end do
    end function before_null

end module base_posix
