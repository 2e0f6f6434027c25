!> Fields of settings, LINE and SECTION, in the order the design gives.
program test_body_line_fields
    use deck_body_line_fields, only: setting_fields, line_fields
    use deck_body_layout, only: body_card, body_field_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%same(names_of(setting_fields, body_card%output), 'UNIT', &
        'the fields of output')
    call tap%same(names_of(setting_fields, body_card%digits), 'N', &
        'the fields of digits')
    call tap%same(names_of(setting_fields, body_card%page), 'COLS LINES', &
        'the fields of page')
    call tap%same(names_of(setting_fields, body_card%nose), 'R', &
        'the fields of nose')
    call tap%same(names_of(line_fields, body_card%line), 'NAME VIEW FROM PARAM', &
        'the fields of line')
    call tap%same(names_of(line_fields, body_card%section), &
        'NAME LINE1 SHLDR LINE3 S1 S3 FROM TO SIDE', 'the fields of section')
    call tap%finish()

contains

    !> The names of the fields of a card, in the order of the table.
    pure function names_of(field, card) result(names)
        type(body_field_type), intent(in) :: field(:)
        integer, intent(in) :: card
        character(:), allocatable :: names
        integer :: i
        names = ''
        do i = 1, size(field)
            if (field(i)%card == card) names = names//' '//trim(field(i)%name)
        end do
        names = trim(adjustl(names))
    end function names_of

end program test_body_line_fields
