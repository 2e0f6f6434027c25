!> The outlines of a duct begin in the field that the layout says.
program test_duct
    use deck_body_fields, only: fields_of
    use deck_body_layout, only: body_card, body_field_type
    use deck_duct, only: first_outline
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_field_type), allocatable :: field(:)

    allocate (field, source=fields_of(body_card%duct))
    call tap%ok(size(field) == 3 .and. field(first_outline - 1)%field == first_outline, &
        'the second field of the card behind its word is the first outline')
    call tap%same(trim(field(first_outline - 1)%name), 'FROM', 'by its name')
    call tap%finish()
end program test_duct
