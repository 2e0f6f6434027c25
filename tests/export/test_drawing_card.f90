!> Tests of cards of a 1970 deck as shapes.
program test_drawing_card
    use base_error, only: error_type
    use base_kinds, only: dp
    use export_drawing, only: shape_kind, shape_type
    use export_drawing_card, only: draw_card
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_bspline, only: spline_point
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc
    type(shape_type) :: shape
    type(error_type), allocatable :: error
    real(dp) :: at(3), off
    integer :: k

    call arc_through(end_type([0.0_dp, 5.0_dp], [1.0_dp, 0.0_dp]), [3.0_dp, 4.0_dp], &
        end_type([5.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), arc, error)
    call draw_card(arc, 7, 'CARD_7', shape)
    call tap%ok(shape%kind == shape_kind%card .and. shape%number == 7 .and. .not. shape%is_half, &
        'it is a card, with its number')
    call tap%same(shape%name//shape%title, 'CARD_7CARD_7', 'and its name')
    associate (curve => shape%contours(1)%curves(1))
        call tap%ok(curve%is_exact .and. curve%is_conic .and. curve%spline%degree == 2, &
            'it is exact')
        off = 0.0_dp
        do k = 0, 100
            at = spline_point(curve%spline, real(k, dp)/100.0_dp)
            off = max(off, abs(norm2(at) - 5.0_dp), abs(at(2)))
        end do
        call tap%near(off, 0.0_dp, 2.0e-15_dp, 'a circle of radius 5 in BL 0: x is STA, y is WL')
        call tap%ok(all(abs(curve%spline%pole(:, 1) - [0.0_dp, 0.0_dp, 5.0_dp]) <= 0.0_dp), &
            'from its first point')
        call tap%ok(all(abs(curve%arc%start - [0.0_dp, 5.0_dp]) <= 0.0_dp), 'u is STA, v is WL')
    end associate
    call tap%finish()
end program test_drawing_card
