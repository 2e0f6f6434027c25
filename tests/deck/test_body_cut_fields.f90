!> Fields of cuts and checks, in the order the design gives.
program test_body_cut_fields
    use deck_body_cut_fields, only: check_fields, cut_fields
    use deck_body_layout, only: body_card, body_field_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%same(names_of(cut_fields, body_card%station), 'FROM TO STEP NAME', &
        'the fields of station')
    call tap%same(names_of(cut_fields, body_card%stations), 'LIST STA', &
        'the fields of stations')
    call tap%same(names_of(cut_fields, body_card%buttock), 'BL FROM TO STEP NAME', &
        'the fields of buttock')
    call tap%same(names_of(cut_fields, body_card%waterline), 'WL FROM TO STEP NAME', &
        'the fields of waterline')
    call tap%same(names_of(cut_fields, body_card%oblique), 'STA1 WL1 STA2 WL2 STEP NAME', &
        'the fields of oblique')
    call tap%same(names_of(cut_fields, body_card%plane), 'X Y Z NX NY NZ FROM TO STEP NAME', &
        'the fields of plane')
    call tap%same(names_of(check_fields, body_card%check_point), 'KIND STA BL WL CLEAR NAME', &
        'the fields of check_point')
    call tap%same(names_of(check_fields, body_card%check_sphere), 'KIND STA BL WL R CLEAR NAME', &
        'the fields of check_sphere')
    call tap%same(names_of(check_fields, body_card%check_box), &
        'KIND STA1 BL1 WL1 STA2 BL2 WL2 CLEAR NAME', 'the fields of check_box')
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

end program test_body_cut_fields
