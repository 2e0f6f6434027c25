!> Fields of the cards of a sweep.
program test_body_sweep_fields
    use deck_body_layout, only: body_card, body_field_type, need
    use deck_body_sweep_fields, only: sweep_fields
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%same(names_of(body_card%vary), 'FIELD NAME FROM TO COUNT ', 'VARY')
    call tap%same(names_of(body_card%vary_list), 'LIST FIELD NAME VALUE ', 'VARY LIST')
    call tap%same(names_of(body_card%vary_tied), 'TIED FIELD NAME FACTOR ADD ', 'VARY TIED')
    call tap%same(names_of(body_card%sweep), 'METHOD COUNT SEED ', 'SWEEP')
    call tap%same(names_of(body_card%object), 'WHAT GOAL VALUE OF AT NAME ', 'OBJECT')
    call tap%same(names_of(body_card%limit_measure), 'WHAT FROM TO OF AT NAME ', 'LIMIT')
    call tap%ok(count(sweep_fields%need == need%repeated) == 1, 'only a list goes on')
    call tap%finish()

contains

    !> The fields of a card, a blank behind each.
    function names_of(card) result(names)
        integer, intent(in) :: card
        character(:), allocatable :: names
        type(body_field_type) :: field
        integer :: i
        names = ''
        do i = 1, size(sweep_fields)
            field = sweep_fields(i)
            if (field%card == card) names = names//trim(field%name)//' '
        end do
    end function names_of

end program test_body_sweep_fields
