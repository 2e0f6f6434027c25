!> General equations of arcs: coefficients of known conics, kinds, residuals, both roots.
program test_conic
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use geom_arc_point, only: point
    use geom_conic, only: conic_kind, conic_of, conic_type, distance_from, kind_name, roots_at, &
        value_at
    use geom_place, only: place_at
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(conic_type) :: conic
    type(arc_type) :: arc
    real(dp), parameter :: up(2) = [0.0_dp, 1.0_dp], flat(2) = [1.0_dp, 0.0_dp]
    real(dp) :: worst
    integer :: i

    conic = conic_of(card([1.0_dp, 0.0_dp], up, [0.0_dp, 1.0_dp], [-1.0_dp, 0.0_dp], up))
    call is_like([0.5_dp, 0.0_dp, 0.5_dp, 1.0_dp, 0.0_dp, 0.0_dp], 'unit circle about (-1, 0)')
    call tap%ok(all(conic%origin == [1.0_dp, 0.0_dp]), 'the origin is point 1')
    call tap%same(kind_name(conic%kind), 'circle', 'its kind is circle')
    call tap%near(value_at(conic, [-1.0_dp, 0.0_dp]), 0.0_dp, 0.0_dp, 'point 3 has no residual')
    call tap%near(value_at(conic, [0.0_dp, 0.0_dp]), -0.5_dp, 0.0_dp, 'the centre has -1/2')
    call tap%near(distance_from(conic, [0.0_dp, 1.001_dp]), 0.001_dp, 1.0e-6_dp, &
        'a point outside is as far as it is')
    call has_roots(0.6_dp, [-0.8_dp, 0.8_dp], 'a circle has two ordinates, the lesser first')
    call has_roots(1.1_dp, [real(dp) ::], 'and none beyond its extreme')

    conic = conic_of(card([0.0_dp, 1.0_dp], flat, [1.2_dp, 0.8_dp], [2.0_dp, 0.0_dp], up))
    call is_like([0.125_dp, 0.0_dp, 0.5_dp, 0.0_dp, 1.0_dp, 0.0_dp], &
        'x**2/4 + y**2 = 1 from its top')
    call tap%same(kind_name(conic%kind), 'ellipse', 'its kind is ellipse')
    conic = conic_of(card([0.0_dp, 0.0_dp], flat, [1.0_dp, 1.0_dp], [2.0_dp, 4.0_dp], &
        [1.0_dp, 4.0_dp]))
    call is_like([1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, -1.0_dp, 0.0_dp], 'y = x**2')
    call tap%same(kind_name(conic%kind), 'parabola', 'its kind is parabola')
    call has_roots(3.0_dp, [9.0_dp], 'a parabola along y has one ordinate')
    conic = conic_of(card([0.5_dp, 2.0_dp], [1.0_dp, -4.0_dp], [1.0_dp, 1.0_dp], &
        [2.0_dp, 0.5_dp], [1.0_dp, -0.25_dp]))
    call is_like([0.0_dp, 0.5_dp, 0.0_dp, 1.0_dp, 0.25_dp, 0.0_dp], 'x y = 1 from (.5, 2)')
    call tap%same(kind_name(conic%kind), 'hyperbola', 'its kind is hyperbola')
    call has_roots(4.0_dp, [0.25_dp], 'its ordinate at 4 is 1/4')
    conic = conic_of(line_between([1.0_dp, 1.0_dp], [3.0_dp, 5.0_dp]))
    call is_like([0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, -0.5_dp, 0.0_dp], 'y - 1 = 2 (x - 1)')
    call tap%same(kind_name(conic%kind), 'line', 'its kind is line')
    call has_roots(2.0_dp, [3.0_dp], 'a line has one ordinate')
    conic = conic_of(line_between([1.0_dp, 1.0_dp], [1.0_dp, 5.0_dp]))
    call has_roots(1.0_dp, [real(dp) ::], 'a vertical line has none that is one')

    conic = conic_of(card([1.0_dp, 0.0_dp], up, [-1.0_dp, 0.0_dp], [0.0_dp, -1.0_dp], flat))
    call tap%ok(conic%kind == conic_kind%circle, 'three quarters of a circle are one')
    conic = conic_of(card([1.0_dp, 0.0_dp], up, [0.600001_dp, 0.8_dp], [0.0_dp, 1.0_dp], flat))
    call tap%ok(conic%kind == conic_kind%ellipse, 'a shoulder off by a millionth makes an ellipse')
    conic = conic_of(card([0.0_dp, 0.0_dp], flat, [1.0_dp, 1.000001_dp], [2.0_dp, 4.0_dp], &
        [1.0_dp, 4.0_dp]))
    call tap%ok(conic%kind == conic_kind%ellipse, 'or of a parabola an ellipse')
    conic = conic_of(card([0.0_dp, 0.0_dp], flat, [1.0_dp, 0.999999_dp], [2.0_dp, 4.0_dp], &
        [1.0_dp, 4.0_dp]))
    call tap%ok(conic%kind == conic_kind%hyperbola, 'or a hyperbola')

    arc = card([4970.0_dp, -210.0_dp], [1.0_dp, 0.114_dp], [5000.0_dp, -207.1_dp], &
        [5050.0_dp, -204.0_dp], [1.0_dp, 0.0523_dp])
    conic = conic_of(arc)
    worst = 0.0_dp
    do i = 0, 20
        worst = max(worst, distance_from(conic, point(arc, place_at(0.05_dp*real(i, dp)))))
    end do
    call tap%near(worst, 0.0_dp, spacing(5050.0_dp), 'far from the datum the arc fits its equation')
    call tap%near(maxval(abs(conic%coefficient)), 1.0_dp, 0.0_dp, 'the largest coefficient is 1')
    call tap%finish()

contains

    !> The arc of a card that has one.
    type(arc_type) function card(p1, t1, p2, p3, t3) result(arc)
        real(dp), intent(in) :: p1(2), t1(2), p2(2), p3(2), t3(2)
        type(error_type), allocatable :: error
        call arc_through(end_type(p1, t1), p2, end_type(p3, t3), arc, error)
        if (allocated(error)) call tap%ok(.false., error%message)
    end function card

    !> Checks the ordinates of the current conic at an x.
    subroutine has_roots(x, expected, name)
        real(dp), intent(in) :: x, expected(:)
        character(*), intent(in) :: name
        logical :: right
        associate (roots => roots_at(conic, x))
            right = size(roots) == size(expected)
            if (right) right = all(abs(roots - expected) <= 2*ulp*abs(expected))
            call tap%ok(right, name)
        end associate
    end subroutine has_roots

    !> Checks the coefficients of the current conic, which may have the other sign.
    subroutine is_like(expected, name)
        real(dp), intent(in) :: expected(6)
        character(*), intent(in) :: name
        real(dp) :: factor
        factor = 1.0_dp
        if (dot_product(expected, conic%coefficient) < 0.0_dp) factor = -1.0_dp
        call tap%near(maxval(abs(factor*conic%coefficient - expected)), 0.0_dp, 4*ulp, name)
    end subroutine is_like

end program test_conic
