!> Text and numbers as gnuplot reads them. Text of a deck may be any bytes; here it becomes
!> harmless: one line of sound UTF-8, in which gnuplot finds no quotes, macros or commands.
module export_gnuplot_text
    use base_kinds, only: dp
    use base_utf8, only: character_length
    implicit none (type, external)
    private

    public :: quoted, plain, number_text

    !> What stands for itself in a gnuplot string.
    character(*), parameter :: harmless = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz'// &
        '0123456789 .,:;+-*/=()<>_&!?'

contains

    !> A text as a gnuplot string: in double quotes, every byte that could mean something to gnuplot
    !> by its octal number. (A quote in single quotes, doubled or joined, makes gnuplot 5.4 lose
    !> count of them, and it then obeys an `@`.)
    pure function quoted(text)
        character(*), intent(in) :: text !! any bytes
        character(:), allocatable :: quoted
        character(:), allocatable :: safe
        integer :: i

        safe = plain(text)
        quoted = '"'
        do i = 1, len(safe)
            if (index(harmless, safe(i:i)) > 0 .or. ichar(safe(i:i)) > 127) then
                quoted = quoted//safe(i:i)
            else
                quoted = quoted//octal(safe(i:i))
            end if
        end do
        quoted = quoted//'"'
    end function quoted

    !> A byte by its number, as in a double-quoted string: `\047`.
    pure function octal(byte) result(text)
        character, intent(in) :: byte !! any byte
        character(4) :: text
        write (text, '(a,o3.3)') '\', ichar(byte)
    end function octal

    !> A text as sound UTF-8 on one line: a control byte becomes a blank, a byte that is no UTF-8 a
    !> question mark.
    pure function plain(text) result(safe)
        character(*), intent(in) :: text !! any bytes
        character(:), allocatable :: safe
        integer :: i, length

        safe = text
        i = 1
        do while (i <= len(text))
            length = character_length(text(i:))
            if (length == 0) then
                safe(i:i) = '?'
            else if (is_control(text(i:i + length - 1))) then
                safe(i:i + length - 1) = ''
            end if
            i = i + max(1, length)
        end do
    end function plain

    !> True for the characters below blank, delete, and their like of Latin-1 (U+0080 to U+009F).
    pure logical function is_control(letter)
        character(*), intent(in) :: letter !! one character in UTF-8
        integer :: first
        first = ichar(letter(1:1))
        is_control = first < 32 .or. first == 127
        if (first == 194) is_control = ichar(letter(2:2)) < 160
    end function is_control

    !> A number with all its figures.
    pure function number_text(value) result(text)
        real(dp), intent(in) :: value !! a finite number
        character(24) :: text
        write (text, '(es24.16e3)') value
    end function number_text

end module export_gnuplot_text
