!> Threads and their stacks, as the environment asks for them. A stack that runs over ends a program
!> without a word, its unfinished results left, so one that is too small is refused at the start.
module app_threads
    use, intrinsic :: iso_c_binding, only: c_int
    use base_error, only: cause, error_type, fail
    use base_kinds, only: i64
    use base_memory, only: stack_room
    use base_text, only: to_text, upper
    implicit none (type, external)
    private

    public :: prepare_threads, bytes_asked

    integer(i64), parameter :: kibibyte = 1024_i64
    !> Least stack, of the program and of each thread: twice what any deck of cards/ takes.
    integer(i64), parameter :: least_stack = 512_i64*kibibyte
    !> Threads there is use for, unless there are more processors. The runtime lists those of a team
    !> on the stack.
    integer(c_int), parameter :: most_threads = 256_c_int

    interface
        !> Threads that the next team will have.
        integer(c_int) function c_max_threads() bind(c, name='omp_get_max_threads')
            import :: c_int
        end function c_max_threads

        !> Processors that threads can run on.
        integer(c_int) function c_processors() bind(c, name='omp_get_num_procs')
            import :: c_int
        end function c_processors

        !> Sets how many threads the next teams will have.
        subroutine c_set_threads(number) bind(c, name='omp_set_num_threads')
            import :: c_int
            integer(c_int), value :: number !! from 1
        end subroutine c_set_threads
    end interface

contains

    !> Limits the threads to those there is use for.
    !>
    !> Fails with `cause%usage` where the stacks are too small.
    subroutine prepare_threads(error)
        type(error_type), allocatable, intent(out) :: error !! see above
        integer(i64) :: room

        call c_set_threads(min(c_max_threads(), max(most_threads, c_processors())))
        room = stack_room()
        if (room < least_stack) then
            call fail(error, cause%usage, 'the stack is limited to '//to_text(room/kibibyte)// &
                ' KiB (ulimit -s); LOFT needs '//to_text(least_stack/kibibyte))
            return
        end if
        room = bytes_asked(stack_words())
        if (room < least_stack) call fail(error, cause%usage, 'OMP_STACKSIZE gives threads '// &
            'stacks of '//to_text(room/kibibyte)//' KiB; LOFT needs '// &
            to_text(least_stack/kibibyte))
    end subroutine prepare_threads

    !> What the environment says of the stacks of threads, for OpenMP and for GNU's alone.
    function stack_words() result(words)
        character(32) :: words
        integer :: status
        call get_environment_variable('OMP_STACKSIZE', words, status=status)
        if (status /= 0) call get_environment_variable('GOMP_STACKSIZE', words, status=status)
        if (status /= 0) words = ''
    end function stack_words

    !> Bytes that a stack size asks for: a number, of KiB or of what a letter B, K, M or G behind it
    !> says. What is none leaves the size to the system: `huge`.
    pure integer(i64) function bytes_asked(words) result(bytes)
        character(*), intent(in) :: words !! as in OMP_STACKSIZE
        character(*), parameter :: units = 'BKMG'
        integer(i64), parameter :: most = 2_i64**33
        character(len(words)) :: number
        integer(i64) :: unit
        integer :: status

        bytes = huge(bytes)
        number = adjustl(upper(words))
        unit = scan(units, right_end(number), kind=i64)
        if (unit > 0) number(len_trim(number):) = ''
        if (unit == 0) unit = 2
        if (number == '' .or. verify(trim(number), '0123456789') > 0) return
        read (number, *, iostat=status) bytes
        if (status /= 0) bytes = most
        bytes = min(bytes, most - 1)*kibibyte**(unit - 1)
    end function bytes_asked

    !> The last letter that is no blank; a blank where there is none.
    pure character function right_end(text) result(letter)
        character(*), intent(in) :: text !! any
        letter = ' '
        if (text /= '') letter = text(len_trim(text):len_trim(text))
    end function right_end

end module app_threads
