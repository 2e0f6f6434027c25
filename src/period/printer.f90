!> The line printer: the first character of each line is carriage control and is not printed.
!>
!>     1  a new page    0  a blank line first    blank  the next line
!>
!> Source: IBM System/360 FORTRAN IV Language, form C28-6515, printing of formatted records.
module period_printer
    use base_output, only: output_type
    implicit none (type, external)
    private

    public :: printer_type

    !> How lines leave.
    type :: printer_type
        logical :: asa = .false. !! true: with the control character; false: as the paper shows it
    contains
        procedure :: print
    end type printer_type

contains

    !> Prints one line. Blanks at its end, which paper does not show, are dropped.
    subroutine print(printer, line, out)
        class(printer_type), intent(in) :: printer !! how
        character(*), intent(in) :: line           !! column 1 is carriage control; not empty
        type(output_type), intent(inout) :: out    !! where to
        character(*), parameter :: form_feed = achar(12)

        if (printer%asa) then
            call out%line(trim(line))
            return
        end if
        if (line(1:1) == '1') call out%put(form_feed)
        if (line(1:1) == '0') call out%line('')
        call out%line(trim(line(2:)))
    end subroutine print

end module period_printer
