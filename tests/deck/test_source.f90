!> Lines of a deck from memory and from files, with all that editors and keys do to them.
program test_source
    use, intrinsic :: iso_c_binding, only: c_int, c_ptr
    use base_error, only: cause, error_type
    use base_kinds, only: i64
    use base_output, only: output_type
    use base_posix, only: c_close, c_creat, c_fclose, c_fileno, c_fopen, c_getpid, c_text, c_unlink
    use base_text, only: to_text
    use deck_source, only: kept_length, line_type, source_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(*), parameter :: feed = achar(10), cr = achar(13), null = achar(0)
    character(*), parameter :: mark = char(239)//char(187)//char(191)

    call check_lines()
    call check_ends()
    call check_nulls()
    call check_lengths()
    call check_file()
    call check_put_back()
    call check_trouble()
    call check_checksum()
    call tap%finish()

contains

    !> Ordinary lines.
    subroutine check_lines()
        call reads('', '', 'nothing has no lines')
        call reads('a', '1:a|', 'a last line without line feed counts')
        call reads('a'//feed, '1:a|', 'a line feed at the end begins no line')
        call reads('a'//feed//feed//' b '//feed, '1:a|2:|3: b |', 'empty lines and blanks stay')
        call reads(feed, '1:|', 'a line feed alone is an empty line')
        call reads(feed//'a', '1:|2:a|', 'an empty first line')
    end subroutine check_lines

    !> Carriage returns and the byte order mark.
    subroutine check_ends()
        call reads('a'//cr//feed//'b'//cr//feed, '1:a|2:b|', &
            'a carriage return before the line feed goes')
        call reads('a'//cr//feed//cr//feed//'b'//cr, '1:a|2:|3:b|', &
            'also on an empty line and at the end')
        call reads('a'//cr//'b'//feed, '1:a'//cr//'b|', 'one inside a line stays')
        call reads(mark//'a'//feed//mark//'b', '1:a|2:'//mark//'b|', &
            'a byte order mark goes, but only in front')
        call reads(mark, '1:|', 'a byte order mark alone is an empty line')
        call reads(mark//cr//feed//'a', '1:|2:a|', 'so it is with an empty line behind')
        call reads('a'//mark, '1:a'//mark//'|', 'within a line it is text')
    end subroutine check_ends

    !> Null bytes.
    subroutine check_nulls()
        type(source_type) :: source
        type(line_type) :: line
        type(error_type), allocatable :: error
        logical :: found

        call source%from_text('text'//feed//'ab'//null//'cd'//feed//'end')
        call source%next_line(line, found, error)
        call tap%ok(found .and. .not. line%has_null, 'a line of text has no null byte')
        call source%next_line(line, found, error)
        call tap%ok(found .and. line%has_null .and. line%number == 2_i64, 'a null byte is seen')
    end subroutine check_nulls

    !> Long lines: what is kept, what is counted.
    subroutine check_lengths()
        call measures(repeat('x', kept_length), kept_length, kept_length, kept_length, &
            'of what is just kept')
        call measures(repeat('x', kept_length)//cr, kept_length, kept_length + 1, kept_length + 1, &
            'with a carriage return just past it')
        call measures(repeat('x', 100000), kept_length, 100000, 100000, 'of 100000 characters')
        call measures('x'//repeat(' ', 99999), kept_length, 100000, 1, 'of a character and blanks')
        call measures(repeat(' ', 99999)//'x', kept_length, 100000, 100000, &
            'of blanks and a character')
        call measures(repeat(' ', 100000), kept_length, 100000, 0, 'of blanks')
        call measures('  x  '//cr, 5, 5, 3, 'with a carriage return behind blanks')
        call measures(mark//' x ', 3, 3, 2, 'with a byte order mark')
        call measures(repeat(' ', 3000)//null, kept_length, 3001, 3001, &
            'with a null byte far behind')
    end subroutine check_lengths

    !> A file that is read in several blocks, cut anywhere.
    subroutine check_file()
        character(:), allocatable :: path
        type(c_ptr) :: stream
        type(source_type) :: source
        type(line_type) :: line
        type(error_type), allocatable :: error
        integer(c_int) :: ignored
        logical :: found, good
        integer :: i

        path = '/tmp/loft_test_source_'//to_text(int(c_getpid()))
        call write_lines(path)
        stream = c_fopen(c_text(path), c_text('r'))
        call source%attach(c_fileno(stream))
        good = .true.
        do i = 1, 500
            call source%next_line(line, found, error)
            good = good .and. found .and. .not. allocated(error) &
                .and. line%text == 'card '//to_text(i) &
                .and. len(line%text) == len('card '//to_text(i)) .and. line%number == int(i, i64)
        end do
        call tap%ok(good, 'lines before a long one are whole')
        call source%next_line(line, found, error)
        call tap%ok(found .and. line%length == 100000_i64 .and. line%filled == 99997 .and. &
            line%text == repeat('x', kept_length), &
            'of a line of 100000 characters the start is kept')
        call source%next_line(line, found, error)
        call tap%ok(found .and. line%length == 0_i64 .and. line%number == 502_i64, &
            'the line behind it is empty')
        do i = 501, 20000
            call source%next_line(line, found, error)
            good = good .and. found .and. line%text == 'card '//to_text(i) &
                .and. line%number == int(i + 2, i64)
        end do
        call tap%ok(good, 'all lines of a file of many blocks are whole')
        call source%next_line(line, found, error)
        call tap%ok(.not. found .and. .not. allocated(error), 'then the file is at its end')
        call source%next_line(line, found, error)
        call tap%ok(.not. found .and. .not. allocated(error), 'and stays there')
        ignored = c_fclose(stream)
        ignored = c_unlink(c_text(path))
    end subroutine check_file

    !> Writes 20000 cards with carriage returns; behind the 500th a long line and an empty one.
    subroutine write_lines(path)
        character(*), intent(in) :: path !! the file
        type(output_type) :: out
        type(error_type), allocatable :: error
        integer(c_int) :: descriptor, ignored
        integer :: i

        descriptor = c_creat(c_text(path), int(o'600', c_int))
        call out%attach(descriptor)
        do i = 1, 20000
            call out%line('card '//to_text(i)//cr)
            if (i == 500) call out%line(repeat('x', 99997)//'   ')
            if (i == 500) call out%line('')
        end do
        call out%flush(error)
        ignored = c_close(descriptor)
    end subroutine write_lines

    !> Lines put back are read again, the last first.
    subroutine check_put_back()
        type(source_type) :: source
        type(line_type) :: first, second, line
        type(error_type), allocatable :: error
        logical :: found

        call source%from_text('a'//feed//'b'//feed//'c')
        call source%next_line(first, found, error)
        call source%next_line(second, found, error)
        call source%put_back(second)
        call source%put_back(first)
        call source%next_line(line, found, error)
        call tap%ok(found .and. line%text == 'a' .and. line%number == 1, &
            'a line put back comes again')
        call source%next_line(line, found, error)
        call tap%ok(found .and. line%text == 'b' .and. line%number == 2, 'then the one before it')
        call source%next_line(line, found, error)
        call tap%ok(found .and. line%text == 'c' .and. line%number == 3, &
            'then what follows in the file')
        call source%put_back(line)
        call source%next_line(line, found, error)
        call tap%ok(found .and. line%text == 'c', 'the last line may be put back')
        call source%next_line(line, found, error)
        call tap%ok(.not. found, 'and is then the last again')
    end subroutine check_put_back

    !> Descriptors that can't be read.
    subroutine check_trouble()
        type(source_type) :: closed, folder
        type(line_type) :: line
        type(error_type), allocatable :: error
        type(c_ptr) :: stream
        integer(c_int) :: ignored
        logical :: found

        call closed%attach(999_c_int)
        call closed%next_line(line, found, error)
        call tap%ok(.not. found .and. allocated(error), 'a descriptor that is not open fails')
        if (allocated(error)) then
            call tap%ok(error%cause == cause%file_trouble, 'as file trouble')
            call tap%same(error%message, 'Bad file descriptor', 'with the reason')
        end if
        stream = c_fopen(c_text('/tmp'), c_text('r'))
        call folder%attach(c_fileno(stream))
        call folder%next_line(line, found, error)
        call tap%ok(.not. found .and. allocated(error), 'a folder is no deck')
        if (allocated(error)) call tap%same(error%message, 'Is a directory', 'and that is said')
        ignored = c_fclose(stream)
    end subroutine check_trouble

    !> The checksum of all bytes: none read, some, all; a file of many blocks; trouble. By
    !> `sha256sum`.
    subroutine check_checksum()
        character(*), parameter :: two = &
            '7e18f737311b2dc3b2f269dd78396b0351f14fb66efa879f768cb23181883c78'
        character(:), allocatable :: path
        type(source_type) :: source, closed
        type(error_type), allocatable :: error
        type(c_ptr) :: stream
        character(64) :: checksum
        integer(c_int) :: ignored
        integer :: lines

        do lines = 0, 3
            call sum_after('a'//feed//'b', lines, two, 'a text after '//to_text(lines)//' lines')
        end do
        call sum_after('', 1, 'e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855', &
            'nothing')
        path = '/tmp/loft_test_sum_'//to_text(int(c_getpid()))
        call write_lines(path)
        stream = c_fopen(c_text(path), c_text('r'))
        call source%attach(c_fileno(stream))
        call source%begin_checksum()
        call source%read_checksum(checksum, error)
        call tap%same(checksum, &
            'c0420369a4065180b9f6e80ceed895dc72a2297cec2e9f6063d2da24fe845b9c', &
            'a file of many blocks')
        ignored = c_fclose(stream)
        ignored = c_unlink(c_text(path))
        call closed%attach(999_c_int)
        call closed%begin_checksum()
        call closed%read_checksum(checksum, error)
        call tap%ok(allocated(error), 'no checksum of what can''t be read')
    end subroutine check_checksum

    !> Counts the check that a text has its checksum after some lines were read.
    subroutine sum_after(text, lines, expected, name)
        character(*), intent(in) :: text        !! the deck
        integer, intent(in) :: lines            !! how many are read
        character(*), intent(in) :: expected    !! the checksum
        character(*), intent(in) :: name        !! of the check
        type(source_type) :: source
        type(line_type) :: line
        type(error_type), allocatable :: error
        character(64) :: checksum
        logical :: found
        integer :: i

        call source%from_text(text)
        call source%begin_checksum()
        do i = 1, lines
            call source%next_line(line, found, error)
        end do
        call source%read_checksum(checksum, error)
        call tap%same(checksum, expected, 'the checksum of '//name)
    end subroutine sum_after

    !> The lines of a text, written with their numbers as `1:first|2:second|`.
    subroutine reads(text, expected, name)
        character(*), intent(in) :: text     !! the file
        character(*), intent(in) :: expected !! its lines
        character(*), intent(in) :: name     !! the check as a phrase
        type(source_type) :: source
        type(line_type) :: line
        type(error_type), allocatable :: error
        character(:), allocatable :: lines
        logical :: found, is_counted

        lines = ''
        is_counted = .true.
        call source%from_text(text)
        do
            call source%next_line(line, found, error)
            if (.not. found) exit
            lines = lines//to_text(line%number)//':'//line%text//'|'
            is_counted = is_counted .and. line%length == len(line%text, i64) &
                .and. line%filled == len_trim(line%text)
        end do
        call tap%same(lines, expected, name)
        if (lines /= '') call tap%ok(is_counted, name//': lengths')
    end subroutine reads

    !> The sizes of a single line, with and without a line feed at its end.
    subroutine measures(text, kept, length, filled, name)
        character(*), intent(in) :: text !! the line
        integer, intent(in) :: kept      !! bytes kept
        integer, intent(in) :: length    !! bytes in all
        integer, intent(in) :: filled    !! the last that is not blank
        character(*), intent(in) :: name !! which line
        type(source_type) :: source
        type(line_type) :: line
        type(error_type), allocatable :: error
        logical :: found

        call source%from_text(text//feed)
        call source%next_line(line, found, error)
        call tap%ok(len(line%text) == kept .and. line%length == int(length, i64) &
            .and. line%filled == filled, 'the sizes of a line '//name)
        call tap%ok(line%has_null .eqv. index(text, null) > 0, 'and whether it is text')
    end subroutine measures

end program test_source
