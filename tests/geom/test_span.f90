!> Spans: where points are in them, and the arcs of weights and through points.
program test_span
    use base_kinds, only: dp
    use geom_arc, only: arc_type, weight
    use geom_arc_point, only: point
    use geom_place, only: at_shoulder
    use geom_span, only: arc_of_weight, arc_past, has_corner, is_level, is_passed_before, &
        new_span, &
        share_type, shares_of, span_by_corner, span_type, way
    use geom_triangle, only: end_type
    use geom_twofold, only: to_real, twofold
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(span_type) :: span
    type(share_type) :: share
    type(arc_type) :: arc
    logical :: exists
    real(dp), parameter :: flat(2) = [1.0_dp, 0.0_dp], up(2) = [0.0_dp, 1.0_dp]

    call tap%ok(all(to_real(way([0.1_dp, 1.0_dp], [0.1_dp, 4.0_dp])) == [0.0_dp, 3.0_dp]), &
        'the way from a point to another is to less from')
    span = span_by_corner([0.0_dp, 0.0_dp], [2.0_dp, 4.0_dp], [4.0_dp, 0.0_dp])
    share = shares_of(span, [2.0_dp, 1.0_dp])
    call tap%near(to_real(share%start), 0.375_dp, 0.0_dp, 'shares are barycentric: of the start')
    call tap%near(to_real(share%finish), 0.375_dp, 0.0_dp, 'and of the finish')
    call tap%ok(to_real(share%off_chord) < 0.0_dp, &
        'a point to the left of the chord is off it, negative')
    share = shares_of(span, [1.0_dp, 2.0_dp])
    call tap%near(to_real(share%finish), 0.0_dp, 0.0_dp, &
        'a point on the tangent at the start has none of the finish')
    call tap%ok(is_passed_before(shares_of(span, [1.0_dp, 1.0_dp]), &
        shares_of(span, [3.0_dp, 1.0_dp])), &
        'a point near the start comes before one near the finish')
    call tap%ok(.not. is_passed_before(shares_of(span, [3.0_dp, 1.0_dp]), &
        shares_of(span, [1.0_dp, 1.0_dp])), 'and not the other way round')

    call tap%ok(has_corner(span) .and. .not. is_level(span), 'tangents of a corner meet there')
    arc = arc_of_weight(span, twofold(1.0_dp))
    call tap%ok(all(point(arc, at_shoulder) == [2.0_dp, 2.0_dp]), 'a parabola rises half way to it')
    arc = arc_of_weight(span, twofold(3.0_dp))
    call tap%ok(all(point(arc, at_shoulder) == [2.0_dp, 3.0_dp]), 'weight 3 three quarters')
    call arc_past(span, [2.0_dp, 3.0_dp], arc, exists)
    call tap%ok(exists, 'there is an arc past that point')
    call tap%near(weight(arc), 3.0_dp, 0.0_dp, 'it has this weight')
    call arc_past(span, [2.0_dp, 4.0_dp], arc, exists)
    call tap%ok(.not. exists, 'there is none past the corner')
    call arc_past(span, [2.0_dp, 0.0_dp], arc, exists)
    call tap%ok(.not. exists, 'nor past a point of the chord')
    call arc_past(span, [24.0_dp, -40.0_dp], arc, exists)
    call tap%ok(.not. exists, 'nor on the other branch')

    span = new_span(end_type([0.0_dp, 0.0_dp], up), end_type([4.0_dp, 0.0_dp], up))
    call tap%ok(.not. (has_corner(span) .or. is_level(span)), 'parallel tangents have no corner')
    call arc_past(span, [2.0_dp, 2.0_dp], arc, exists)
    call tap%ok(exists .and. weight(arc) == 0.0_dp, 'and half an ellipse past each point')
    span = new_span(end_type([0.0_dp, 0.0_dp], up), end_type([4.0_dp, 0.0_dp], flat))
    call tap%ok(is_level(span) .and. .not. has_corner(span), 'a tangent along the chord is level')
    call tap%finish()

end program test_span
