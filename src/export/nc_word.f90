!> Words and comments of an NC program, in what LinuxCNC, Fanuc and Grbl all read.
!>
!> Comments have capitals, figures, blanks and `. , - + _ = /` only: a closing parenthesis would end
!> them, `%` ends the program for Fanuc, and Grbl obeys `!`, `?` and `~` wherever they stand.
!>
!> Source: T. Kramer, F. Proctor, E. Messina, "The NIST RS274NGC Interpreter - Version 3", NISTIR
!> 6556 (2000), section 3; Grbl v1.1, "Real-time commands".
module export_nc_word
    use base_digits, only: fixed
    use base_kinds, only: dp
    use base_text, only: limited, upper
    implicit none (type, external)
    private

    public :: comment, word

    !> The longest comment, its parentheses included.
    integer, parameter :: longest = 70

contains

    !> A text as a comment: what may not stand there is `-`, what is too long is cut off.
    pure function comment(words) result(text)
        character(*), intent(in) :: words   !! any bytes
        character(:), allocatable :: text
        character(*), parameter :: good = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 .,-+_=/'

        text = limited(upper(words), good, '-')
        text = '('//trim(text(:min(len(text), longest - 2)))//')'
    end function comment

    !> A word: its letter and a number with a fixed count of decimals, without a sign where it is
    !> zero.
    pure function word(letter, value, decimals) result(text)
        character, intent(in) :: letter     !! X, Y, Z, F...
        real(dp), intent(in) :: value       !! below 1e5
        integer, intent(in) :: decimals     !! behind the point
        character(:), allocatable :: text
        text = letter//trim(adjustl(fixed(value, 20, decimals)))
    end function word

end module export_nc_word
