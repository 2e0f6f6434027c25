!> A fault as the user reads it: where, how grave, what is wrong and what would be right, the card
!> and a row of carets under its columns.
!>
!>     nose.crd:7:25-40: error: points 1 and 2 coincide; three different points fix a conic
!>         -30.    -10.    .114    -30.    -10.    50.     -4.     .0523   5.
!>                                 ^^^^^^^^^^^^^^^^
module report_fault
    use base_fault, only: fault_list_type, fault_type, severity
    use base_kinds, only: i64
    use base_output, only: output_type
    use base_text, only: printable, row_of, to_text
    implicit none (type, external)
    private

    public :: print_faults

    !> Columns of a card that are shown.
    integer, parameter :: shown_columns = 132
    !> Blanks before the card image.
    character(*), parameter :: margin = '    '

contains

    !> Prints faults in their order. Remarks are passed over unless asked for.
    subroutine print_faults(faults, deck, with_remarks, out)
        type(fault_list_type), intent(in) :: faults !! what was found
        character(*), intent(in) :: deck            !! name of the deck as the user gave it
        logical, intent(in) :: with_remarks         !! remarks are printed too, as warnings
        type(output_type), intent(inout) :: out     !! where they go
        integer :: i
        do i = 1, faults%count
            if (faults%item(i)%severity == severity%remark .and. .not. with_remarks) cycle
            call print_fault(faults%item(i), deck, out)
        end do
    end subroutine print_faults

    !> Prints one fault with its card.
    subroutine print_fault(fault, deck, out)
        type(fault_type), intent(in) :: fault   !! the fault
        character(*), intent(in) :: deck        !! name of the deck
        type(output_type), intent(inout) :: out !! where it goes
        character(:), allocatable :: place
        integer :: last

        place = printable(deck)
        if (fault%line > 0) place = place//':'//to_text(fault%line)
        if (fault%first > 0) place = place//':'//to_text(fault%first)//'-'//to_text(fault%last)
        call out%line(place//': '//grade(fault%severity)//': '//fault%message)
        if (fault%card == '') return
        call out%line(margin//shown(fault%card))
        if (fault%first == 0 .or. fault%first > shown_columns) return
        last = min(fault%last, shown_columns)
        call out%line(margin//row_of(' ', fault%first - 1)//row_of('^', last - fault%first + 1))
    end subroutine print_fault

    !> The word for a severity.
    pure function grade(level) result(word)
        integer, intent(in) :: level !! one of `severity%...`
        character(merge(5_i64, 7_i64, level == severity%error)) :: word
        word = 'warning'
        if (level == severity%error) word = 'error'
    end function grade

    !> A card image in which each byte is one column: what is not plain ASCII shows as `?`.
    pure function shown(card) result(image)
        character(*), intent(in) :: card !! the card image
        character(len_trim(card(:min(len(card), shown_columns)), i64)) :: image
        integer :: i
        image = card
        do i = 1, len(image)
            if (ichar(image(i:i)) < 32 .or. ichar(image(i:i)) > 126) image(i:i) = '?'
        end do
    end function shown

end module report_fault
