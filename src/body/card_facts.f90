!> What the listing says of a conic card beside its tables: what kind of conic it is, its equation,
!> its length, and the same conic found the way of 1970 as a check.
module body_card_facts
    use base_decimal, only: decimal_type, to_real
    use base_error, only: error_type
    use base_kinds, only: dp
    use deck_conic_card, only: conic_card_type
    use deck_layout, only: conic
    use geom_arc, only: arc_type, direction_of_slope, end_type
    use geom_conic, only: conic_of, conic_type, value_at
    use geom_length, only: arc_length
    use geom_shifted, only: difference_from, shifted_type, solve_shifted
    implicit none (type, external)
    private

    public :: card_facts_type, facts_of_card

    !> The facts of a card.
    type :: card_facts_type
        logical :: has_arc = .false.            !! false: nothing else here means anything
        type(arc_type) :: arc                   !! the arc
        type(conic_type) :: conic               !! its general equation, point 1 as origin
        real(dp) :: residual(3) = 0.0_dp        !! of that equation at points 1, 2, 3
        real(dp) :: length = 0.0_dp             !! arc length, deck units
        logical :: has_length = .false.         !! the quadrature converged
        type(shifted_type) :: shifted           !! the conic in the shifted frame
        logical :: has_shifted = .false.        !! its five equations have a unique solution
        real(dp) :: difference = 0.0_dp         !! of that conic from the arc, at most, deck units
    end type card_facts_type

contains

    !> The facts of a card that has an arc.
    pure type(card_facts_type) function facts_of_card(card, arc, shift) result(facts)
        type(conic_card_type), intent(in) :: card   !! a readable card
        type(arc_type), intent(in) :: arc           !! its arc
        type(decimal_type), intent(in) :: shift     !! of the book's frame, deck units
        type(error_type), allocatable :: error
        real(dp) :: shoulder(2)

        shoulder = card%real([conic%x2, conic%y2])
        facts%has_arc = .true.
        facts%arc = arc
        facts%conic = conic_of(arc)
        facts%residual = [value_at(facts%conic, arc%start), value_at(facts%conic, shoulder), &
            value_at(facts%conic, arc%finish)]
        call arc_length(arc, facts%length, error)
        facts%has_length = .not. allocated(error)
        call solve_shifted( &
            end_type(arc%start, direction_of_slope(card%real(conic%s1))), shoulder, &
            end_type(arc%finish, direction_of_slope(card%real(conic%s3))), &
            to_real(shift), facts%shifted, error)
        facts%has_shifted = .not. allocated(error)
        if (facts%has_shifted) facts%difference = difference_from(facts%shifted, arc)
    end function facts_of_card

end module body_card_facts
