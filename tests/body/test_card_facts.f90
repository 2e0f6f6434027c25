!> The facts of a card beside its tables, for a quarter of a circle where all are known.
program test_card_facts
    use base_constants, only: pi
    use base_decimal, only: decimal_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp, i64
    use body_card_arc, only: arc_of_card
    use body_card_facts, only: card_facts_type, facts_of_card
    use deck_conic_card, only: conic_card_type, read_conic_card
    use deck_source, only: line_type
    use geom_arc, only: arc_type
    use geom_conic, only: conic_kind
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(card_facts_type) :: facts
    real(dp) :: a

    facts = facts_of('-5.     0.      999.999 -4.     3.      0.      5.      0.      1.')
    call tap%ok(facts%has_arc .and. facts%conic%kind == conic_kind%circle, 'it is a circle')
    call tap%ok(facts%has_length, 'it has a length')
    call tap%near(facts%length, 2.5_dp*pi, 1.0e-10_dp, 'which is a quarter of 10 pi')
    call tap%ok(all(abs(facts%residual) < 1.0e-15_dp), 'all three points are on its equation')
    call tap%ok(facts%has_shifted, 'the five equations have a solution')
    ! (x - 100)**2 + (y - 100)**2 = 25: divided by 19975, x**2 + y**2 - 200 x - 200 y = -19975.
    a = 1.0_dp/19975.0_dp
    call tap%ok(all(abs(facts%shifted%coefficient - [a, 0.0_dp, a, -200.0_dp*a, -200.0_dp*a]) &
        < 1.0e-12_dp), 'it is that of the circle moved by 100')
    call tap%ok(facts%difference < 1.0e-9_dp, 'and it lies on the arc')
    facts = facts_of('0.      0.      .5      4.      2.      8.      4.      .5      1.')
    call tap%ok(facts%conic%kind == conic_kind%line, 'three points in line are a line')
    call tap%near(facts%length, sqrt(80.0_dp), 1.0e-13_dp, 'as long as its chord')
    call tap%ok(.not. facts%has_shifted, 'for which the five equations have no unique solution')
    call tap%finish()

contains

    !> The facts of a card image.
    function facts_of(text) result(facts)
        character(*), intent(in) :: text !! the card image
        type(card_facts_type) :: facts
        type(conic_card_type) :: card
        type(fault_list_type) :: faults
        type(line_type) :: line
        type(arc_type) :: arc
        logical :: has_arc

        line%text = text
        line%length = len(text, i64)
        call read_conic_card(line, card, faults)
        call arc_of_card(card, arc, has_arc, faults)
        if (has_arc) facts = facts_of_card(card, arc, decimal_type(100, 0))
    end function facts_of

end program test_card_facts
