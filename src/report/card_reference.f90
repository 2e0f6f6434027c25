!> The card reference: every card with its columns, printed from the table the reader uses.
module report_card_reference
    use base_output, only: output_type
    use base_text, only: right, to_text
    use deck_layout, only: conic_fields, field_layout_type, title_fields, units_fields
    implicit none (type, external)
    private

    public :: print_card_reference

contains

    !> Prints the columns of every card.
    subroutine print_card_reference(out)
        type(output_type), intent(inout) :: out !! where it goes

        call print_layout('The conic card of a 1970 deck', conic_fields, out)
        call out%line('Columns 79-80 are free for a sequence number.')
        call out%line('')
        call print_layout('TITLE', title_fields, out)
        call out%line('')
        call print_layout('UNITS', units_fields, out)
    end subroutine print_card_reference

    !> Prints the columns of one card.
    subroutine print_layout(name, fields, out)
        character(*), intent(in) :: name                 !! what the card is called
        type(field_layout_type), intent(in) :: fields(:) !! its fields
        type(output_type), intent(inout) :: out          !! where it goes
        integer :: i

        call out%line(name)
        call out%line('')
        call out%line('  columns  field  form   unit       meaning')
        do i = 1, size(fields)
            associate (field => fields(i))
                call out%line('  '//right(to_text(field%first)//'-'//to_text(field%last), 7)//'  '// &
                    field%name//'  '//form_text(field)//'  '//field%unit//'  '//trim(field%meaning))
            end associate
        end do
    end subroutine print_layout

    !> The FORTRAN format of a field in five columns: `F8.3`, `I2`, `A8`.
    pure function form_text(field) result(text)
        type(field_layout_type), intent(in) :: field !! the field
        character(5) :: text
        text = field%form//to_text(field%last - field%first + 1)
        if (field%form == 'F') text = trim(text)//'.'//to_text(field%decimals)
    end function form_text

end module report_card_reference
