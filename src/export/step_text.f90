!> The text of a STEP file (ISO 10303-21:2002, "Clear text encoding of the exchange structure"): its
!> tokens, and the numbered instances of its data section.
!>
!>     call file%add('CARTESIAN_POINT('//step_string('')//','//step_list(at)//')', number)
module export_step_text
    use base_digits, only: shortest
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: to_text, upper
    use base_utf8, only: character_length, code_point
    implicit none (type, external)
    private

    public :: step_file_type, put_statement
    public :: step_string, step_real, step_list, step_reference, step_references, step_logical

    !> Columns of a line; only a longer token makes a longer one.
    integer, parameter :: widest = 80

    !> The data section of a file, as far as it is written.
    type :: step_file_type
        private
        type(output_type) :: data   !! in memory
        integer :: last = 0         !! number of the last instance
    contains
        procedure :: add
        procedure :: text
    end type step_file_type

    !> Numbers in parentheses.
    interface step_list
        module procedure real_list, integer_list
    end interface step_list

contains

    !> Adds an instance to the data section.
    subroutine add(file, record, number)
        class(step_file_type), intent(inout) :: file    !! the file
        character(*), intent(in) :: record              !! the entity and its values, or several
                                                        !! in parentheses (11.2.5.3)
        integer, intent(out) :: number                  !! by which others refer to it
        file%last = file%last + 1
        number = file%last
        call put_statement(file%data, step_reference(number)//'='//record)
    end subroutine add

    !> The lines of the data section.
    pure function text(file)
        class(step_file_type), intent(in) :: file   !! the file
        character(:), allocatable :: text
        text = file%data%text()
    end function text

    !> Puts a statement and its semicolon, broken into lines behind commas outside of strings.
    subroutine put_statement(out, statement)
        type(output_type), intent(inout) :: out     !! where to
        character(*), intent(in) :: statement       !! without semicolon
        integer :: i, first, comma
        logical :: is_string

        is_string = .false.
        first = 1
        comma = 0
        do i = 1, len(statement)
            if (i - first >= widest .and. comma >= first) then
                call out%line(statement(first:comma))
                first = comma + 1
            end if
            if (statement(i:i) == '''') is_string = .not. is_string
            if (statement(i:i) == ',' .and. .not. is_string) comma = i
        end do
        call out%line(statement(first:)//';')
    end subroutine put_statement

    !> A text in quotes. Letters beyond ASCII go by their number in Unicode, bytes that are no UTF-8
    !> and control characters by their own (ISO 10303-21:2002, 6.3.3).
    pure function step_string(text) result(string)
        character(*), intent(in) :: text !! any bytes
        character(:), allocatable :: string
        integer :: i, length

        string = ''''
        i = 1
        do while (i <= len(text))
            length = character_length(text(i:))
            if (length == 0) then
                string = string//byte_directive(text(i:i))
            else
                string = string//step_letter(text(i:i + length - 1))
            end if
            i = i + max(1, length)
        end do
        string = string//''''
    end function step_string

    !> A character as it stands in a string.
    pure function step_letter(letter) result(text)
        character(*), intent(in) :: letter !! one character in UTF-8
        character(:), allocatable :: text
        character(8) :: code

        if (len(letter) == 1) then
            text = letter
            if (letter == '''' .or. letter == '\') text = letter//letter
            if (ichar(letter) < 32 .or. ichar(letter) == 127) text = byte_directive(letter)
        else if (len(letter) < 4) then
            write (code, '(z4.4)') code_point(letter)
            text = '\X2\'//code(:4)//'\X0\'
        else
            write (code, '(z8.8)') code_point(letter)
            text = '\X4\'//code//'\X0\'
        end if
    end function step_letter

    !> A byte by its number: `\X\0A`.
    pure function byte_directive(byte) result(text)
        character, intent(in) :: byte !! any byte
        character(5) :: text
        write (text, '(a,z2.2)') '\X\', ichar(byte)
    end function byte_directive

    !> A number with the fewest figures that read back as the same double, and always with a point:
    !> `-30.`, `0.1`, `1.E-07`.
    pure function step_real(value) result(text)
        real(dp), intent(in) :: value !! a finite number
        character(:), allocatable :: text
        integer :: power

        text = upper(shortest(value))
        if (index(text, '.') > 0) return
        power = index(text, 'E')
        if (power == 0) power = len(text) + 1
        text = text(:power - 1)//'.'//text(power:)
    end function step_real

    !> Numbers in parentheses: `(1.,2.5)`.
    pure function real_list(values) result(text)
        real(dp), intent(in) :: values(:) !! finite numbers, at least one
        character(:), allocatable :: text
        integer :: i

        text = '('//step_real(values(1))
        do i = 2, size(values)
            text = text//','//step_real(values(i))
        end do
        text = text//')'
    end function real_list

    !> Whole numbers in parentheses: `(3,1,3)`.
    pure function integer_list(values) result(text)
        integer, intent(in) :: values(:) !! at least one
        character(:), allocatable :: text
        integer :: i

        text = '('//to_text(values(1))
        do i = 2, size(values)
            text = text//','//to_text(values(i))
        end do
        text = text//')'
    end function integer_list

    !> How other instances refer to one: `#12`.
    pure function step_reference(number) result(text)
        integer, intent(in) :: number !! its number
        character(:), allocatable :: text
        text = '#'//to_text(number)
    end function step_reference

    !> References in parentheses: `(#12,#13)`; where there are none `()`.
    pure function step_references(numbers) result(text)
        integer, intent(in) :: numbers(:) !! their numbers
        character(:), allocatable :: text
        integer :: i

        text = '('
        do i = 1, size(numbers)
            if (i > 1) text = text//','
            text = text//step_reference(numbers(i))
        end do
        text = text//')'
    end function step_references

    !> A truth value: `.T.` or `.F.`.
    pure character(3) function step_logical(flag) result(text)
        logical, intent(in) :: flag !! true or false
        text = merge('.T.', '.F.', flag)
    end function step_logical

end module export_step_text
