!> Text on its way out: gathered in memory, and written to files and devices.
program test_output
    use, intrinsic :: iso_c_binding, only: c_char, c_int, c_null_char, c_ptr, c_size_t
    use base_error, only: cause, error_type
    use base_kinds, only: i64
    use base_output, only: output_type
    use base_posix, only: c_close, c_creat, c_fclose, c_fileno, c_fopen, c_getpid, c_read, &
        c_text, c_unlink
    use base_text, only: to_text
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(*), parameter :: feed = new_line('a')

    call check_memory()
    call check_file()
    call check_full_device()
    call check_bad_descriptor()
    call tap%finish()

contains

    !> An output without descriptor.
    subroutine check_memory()
        type(output_type) :: out, large
        type(error_type), allocatable :: error
        type(output_type) :: several
        integer :: i

        call tap%same(out%text(), '', 'an output begins empty')
        call out%put('a')
        call out%put('')
        call out%line('b ')
        call out%line('')
        call out%put(c_null_char)
        call tap%same(out%text(), 'ab '//feed//feed//c_null_char, &
            'text and lines stand as they were put')
        call several%lines([character(3) :: 'a', '', ' b'])
        call tap%same(several%text(), 'a'//feed//feed//' b'//feed, &
            'several lines lose the blanks at their ends')
        call out%flush(error)
        call tap%ok(.not. allocated(error) .and. .not. out%has_failed(), 'memory does not fail')
        call tap%same(out%text(), 'ab '//feed//feed//c_null_char, &
            'what is gathered stays after a flush')
        do i = 1, 100000
            call large%line(to_text(i))
        end do
        ! 9*1 + 90*2 + 900*3 + 9000*4 + 90000*5 + 6 figures and 100000 line feeds.
        call tap%ok(len(large%text()) == 588895, 'more text than the first buffer holds is whole')
        call tap%ok(index(large%text(), feed//'13107'//feed//'13108'//feed) > 0, &
            'and in order where the buffer grew')
        call large%put(repeat('x', 1000000))
        call tap%ok(len(large%text()) == 1588895, 'a text larger than the buffer is kept')
    end subroutine check_memory

    !> An output to a file, in pieces small and large.
    subroutine check_file()
        character(:), allocatable :: path, expected
        type(output_type) :: out
        type(error_type), allocatable :: error
        integer(c_int) :: descriptor, ignored
        integer :: i

        path = '/tmp/loft_test_output_'//to_text(int(c_getpid()))
        descriptor = c_creat(c_text(path), int(o'600', c_int))
        call tap%ok(descriptor >= 0, 'a file can be made')
        call out%attach(descriptor)
        expected = ''
        do i = 1, 3000
            call out%line('line '//to_text(i)//' of a file that is longer than the buffer')
            expected = expected//'line '//to_text(i)// &
                ' of a file that is longer than the buffer'//feed
        end do
        call out%put(repeat('y', 65536*3 + 1))
        call out%put('end')
        expected = expected//repeat('y', 65536*3 + 1)//'end'
        call out%flush(error)
        call tap%ok(.not. allocated(error), 'a file takes all')
        call out%flush(error)
        call tap%ok(.not. allocated(error), 'a second flush has nothing to do')
        ignored = c_close(descriptor)
        call tap%ok(content(path) == expected .and. len(content(path)) == len(expected), &
            'the file holds every byte once, in order')
        ignored = c_unlink(c_text(path))
    end subroutine check_file

    !> A device that is always full.
    subroutine check_full_device()
        type(output_type) :: out, large
        type(error_type), allocatable :: error
        integer(c_int) :: descriptor, ignored

        descriptor = c_creat(c_text('/dev/full'), int(o'666', c_int))
        if (descriptor < 0) then
            call tap%note('no /dev/full on this system')
            return
        end if
        call out%attach(descriptor)
        call out%line('a line')
        call tap%ok(.not. out%has_failed(), 'a line in the buffer has not failed yet')
        call out%flush(error)
        call tap%ok(allocated(error) .and. out%has_failed(), 'a full device fails at the flush')
        if (allocated(error)) then
            call tap%ok(error%cause == cause%file_trouble, 'as file trouble')
            call tap%same(error%message, 'No space left on device', 'in the words of the system')
        end if
        call out%line('more')
        call out%flush(error)
        call tap%ok(allocated(error), 'it stays failed')
        call large%attach(descriptor)
        call large%put(repeat('x', 70000))
        call tap%ok(large%has_failed(), 'a text larger than the buffer fails at once')
        call large%put('more')
        call tap%ok(large%has_failed(), 'and what comes later does not mend it')
        ignored = c_close(descriptor)
    end subroutine check_full_device

    !> A descriptor that is not open.
    subroutine check_bad_descriptor()
        type(output_type) :: out, quiet
        type(error_type), allocatable :: error

        call out%attach(999_c_int)
        call out%line('a line')
        call out%flush(error)
        call tap%ok(allocated(error), 'a descriptor that is not open fails')
        if (allocated(error)) call tap%same(error%message, 'Bad file descriptor', 'with the reason')
        call quiet%attach(999_c_int)
        call quiet%flush(error)
        call tap%ok(.not. allocated(error), 'where nothing was put nothing fails')
    end subroutine check_bad_descriptor

    !> All bytes of a file, read without our own reader.
    function content(path) result(text)
        character(*), intent(in) :: path !! the file
        character(:), allocatable :: text
        character(kind=c_char) :: block(4096)
        type(c_ptr) :: stream
        integer(c_int) :: ignored
        integer(i64) :: got
        integer :: i

        text = ''
        stream = c_fopen(c_text(path), c_text('r'))
        do
            got = int(c_read(c_fileno(stream), block, int(size(block), c_size_t)), i64)
            if (got <= 0) exit
            do i = 1, int(got)
                text = text//block(i)
            end do
        end do
        ignored = c_fclose(stream)
    end function content

end program test_output
