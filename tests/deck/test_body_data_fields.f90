!> Fields of the data cards: the conic card as in SAE 700202, the others by their points in order.
program test_body_data_fields
    use deck_body_data_fields, only: data_fields
    use deck_body_layout, only: body_card, body_field_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%same(names_of(data_fields, body_card%conic), 'X1 Y1 S1 X2 Y2 X3 Y3 S3', &
        'the fields of conic')
    call tap%same(names_of(data_fields, body_card%rho), 'X1 Y1 S1 X3 Y3 S3 RHO', &
        'the fields of rho')
    call tap%same(names_of(data_fields, body_card%tangent), 'X1 Y1 XT YT X2 Y2 X3 Y3', &
        'the fields of tangent')
    call tap%same(names_of(data_fields, body_card%tangent_rho), 'X1 Y1 XT YT X3 Y3 RHO', &
        'the fields of tangent_rho')
    call tap%same(names_of(data_fields, body_card%four_points), 'X1 Y1 S XA YA XB YB X3 Y3', &
        'the fields of four_points')
    call tap%same(names_of(data_fields, body_card%five_points), 'X1 Y1 XA YA XB YB XC YC X3 Y3', &
        'the fields of five_points')
    call tap%same(names_of(data_fields, body_card%straight), 'X1 Y1 X3 Y3', &
        'the fields of straight')
    call tap%same(names_of(data_fields, body_card%circle), 'X1 Y1 X2 Y2 X3 Y3', &
        'the fields of circle')
    call tap%same(names_of(data_fields, body_card%radius), 'X1 Y1 X3 Y3 R', &
        'the fields of radius')
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

end program test_body_data_fields
