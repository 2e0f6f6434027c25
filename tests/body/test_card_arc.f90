!> From a conic card to its arc, and from what geometry finds wrong to columns of the card.
program test_card_arc
    use base_fault, only: fault_list_type, severity
    use base_kinds, only: dp, i64
    use body_card_arc, only: arc_of_card
    use deck_conic_card, only: conic_card_type, read_conic_card
    use deck_source, only: line_type
    use geom_arc, only: arc_type, rho
    use geom_arc_point, only: point
    use geom_place, only: at_shoulder
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_quarter_circle()
    call check_fault('0.      0.      .5      5.      5.      10.     10.     2.      1.', 25, 40, &
        'a shoulder point on the chord is blamed on X2 and Y2')
    call check_fault('0.      0.      .5      5.      3.      10.     0.      .4      1.', 17, 64, &
        'end slopes that need an inflection are blamed on S1 to S3')
    call check_fault('0.      0.      .5      5.      4.      10.     0.      -.5     1.', 25, 40, &
        'a shoulder point outside the end tangents is blamed on X2 and Y2')
    call check_fault('0.      0.      0.      5.      1.      10.     0.      -.5     1.', 17, 64, &
        'an end tangent along the chord is blamed on S1 to S3')
    call check_warning()
    call tap%finish()

contains

    !> A card of the deck, read.
    function card_of(text) result(card)
        character(*), intent(in) :: text !! the card image
        type(conic_card_type) :: card
        type(fault_list_type) :: faults
        type(line_type) :: line
        line%text = text
        line%length = len(text, i64)
        line%number = 7
        call read_conic_card(line, card, faults)
    end function card_of

    !> A quarter of a circle of radius 5: vertical at (-5, 0), level at (0, 5), through (-4, 3).
    subroutine check_quarter_circle()
        type(fault_list_type) :: faults
        type(arc_type) :: arc
        real(dp) :: middle(2)
        logical :: has_arc

        call arc_of_card(card_of('-5.     0.      999.999 -4.     3.      0.      5.      '), arc, &
            has_arc, faults)
        call tap%ok(has_arc .and. faults%count == 0, 'a card of a quarter circle has an arc')
        call tap%near(rho(arc), sqrt(2.0_dp) - 1.0_dp, 1.0e-15_dp, 'its rho is that of a circle')
        middle = point(arc, at_shoulder)
        call tap%near(norm2(middle), 5.0_dp, 1.0e-15_dp, 'its middle is on the circle')
    end subroutine check_quarter_circle

    !> A card without an arc has one error, on these columns, and the card it stands on.
    subroutine check_fault(text, first, last, name)
        character(*), intent(in) :: text !! the card image
        integer, intent(in) :: first     !! first column at fault
        integer, intent(in) :: last      !! last column at fault
        character(*), intent(in) :: name !! the check
        type(fault_list_type) :: faults
        type(arc_type) :: arc
        logical :: has_arc

        call arc_of_card(card_of(text), arc, has_arc, faults)
        call tap%ok(.not. has_arc .and. faults%count == 1, name//': one fault, no arc')
        if (faults%count == 0) return
        associate (fault => faults%item(1))
            call tap%ok(fault%severity == severity%error .and. fault%line == 7 .and. &
                fault%first == first .and. fault%last == last, name)
            call tap%same(trim(fault%card), trim(text), name//': with its card')
        end associate
    end subroutine check_fault

    !> An arc of more than 180 degrees runs, with a warning.
    subroutine check_warning()
        type(fault_list_type) :: faults
        type(arc_type) :: arc
        logical :: has_arc

        call arc_of_card(card_of('-3.     4.      .75     0.      -5.     3.      4.      -.75'), &
            arc, has_arc, faults)
        call tap%ok(has_arc, 'most of a circle is an arc')
        call tap%ok(faults%count == 1 .and. .not. faults%has_errors(0), &
            'an arc that turns by more than 180 degrees is warned of')
    end subroutine check_warning

end program test_card_arc
