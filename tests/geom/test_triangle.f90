!> Control triangles: predicates at and beside their limits.
program test_triangle
    use base_kinds, only: dp
    use geom_triangle, only: corner_of, end_type, has_arc, is_flat, is_straight, new_triangle, &
        rounding, triangle_type
    use geom_twofold, only: to_real, twofold_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(triangle_type) :: it
    type(twofold_type) :: leaving(2), arriving(2)
    real(dp), parameter :: up(2) = [0.0_dp, 1.0_dp], flat(2) = [1.0_dp, 0.0_dp]

    it = card([0.0_dp, 0.0_dp], up, [0.25_dp, 0.75_dp], [1.0_dp, 1.0_dp], flat)
    call tap%near(to_real(it%weight), 1.0_dp, 0.0_dp, &
        'a shoulder half way to the corner has weight 1')
    call tap%ok(has_arc(it) .and. .not. is_flat(it), 'and an arc')
    call corner_of(it, leaving, arriving)
    call tap%ok(all(to_real(leaving)*it%size == [0.0_dp, 1.0_dp]), &
        'it leaves towards the corner (0, 1)')
    call tap%ok(all(to_real(arriving)*it%size == [1.0_dp, 0.0_dp]), 'and arrives from there')

    it = card([0.0_dp, 0.0_dp], up, [1.0_dp, 1.0_dp], [2.0_dp, 0.0_dp], up)
    call tap%ok(has_arc(it) .and. to_real(it%weight) == 0.0_dp, &
        'parallel end tangents have weight 0')
    it = card([1.0_dp, 0.0_dp], up, [-1.0_dp, 0.0_dp], [0.0_dp, -1.0_dp], flat)
    call tap%near(to_real(it%weight), -sqrt(0.5_dp), 1.0e-16_dp, &
        'three quarters of a circle: -cos 45')

    it = card([0.0_dp, 0.0_dp], up, [0.0_dp, 0.5_dp], [1.0_dp, 1.0_dp], flat)
    call tap%ok(.not. has_arc(it), 'a shoulder on an end tangent has no arc')
    it = card([0.0_dp, 0.0_dp], up, [1.0e-9_dp, 0.5_dp], [1.0_dp, 1.0_dp], flat)
    call tap%ok(has_arc(it), 'one just inside has')
    it = card([0.0_dp, 0.0_dp], up, [-1.0e-9_dp, 0.5_dp], [1.0_dp, 1.0_dp], flat)
    call tap%ok(.not. has_arc(it), 'one just outside has not')

    it = card([0.0_dp, 0.0_dp], [1.0_dp, 3.0_dp], [0.1_dp, 0.3_dp], [0.2_dp, 0.6_dp], [1.0_dp, &
        3.0_dp])
    call tap%ok(is_flat(it) .and. is_straight(it), 'decimals meant to be in line are straight')
    it = card([5000.0_dp, 0.0_dp], [1.0_dp, 3.0_dp], [5000.1_dp, 0.3_dp], [5000.2_dp, 0.6_dp], &
        [1.0_dp, 3.0_dp])
    call tap%ok(is_straight(it), 'also far from the datum')
    it = card([0.0_dp, 0.0_dp], [1.0_dp, 3.0_dp], [0.1_dp, 0.3001_dp], [0.2_dp, 0.6_dp], &
        [1.0_dp, 3.0_dp])
    call tap%ok(.not. is_flat(it), 'a shoulder off by a punched decimal is not')
    it = card([0.0_dp, 0.0_dp], [3.0_dp, 1.00002_dp], [1.5_dp, 0.5_dp], [3.0_dp, 1.0_dp], &
        [3.0_dp, 1.0_dp])
    call tap%ok(.not. is_straight(it) .and. is_flat(it), &
        'a slope off by more than half a decimal is not straight')
    it = card([0.0_dp, 0.0_dp], [1.0_dp, 0.33333_dp], [1.5_dp, 0.5_dp], [3.0_dp, 1.0_dp], &
        [1.0_dp, 0.33333_dp])
    call tap%ok(is_straight(it), 'a third punched as .33333 is')
    it = card([0.0_dp, 0.0_dp], flat, [4.0_dp, 0.0_dp], [3.0_dp, 0.0_dp], flat)
    call tap%ok(.not. is_straight(it) .and. is_flat(it), &
        'a shoulder beyond the end is not straight')

    it = card([1.0e200_dp, 0.0_dp], up, [1.75e200_dp, 0.75e200_dp], [2.0e200_dp, 1.0e200_dp], flat)
    call tap%ok(has_arc(it), 'large units do not overflow')
    it = card([1.0e-200_dp, 0.0_dp], up, [1.25e-200_dp, 0.75e-200_dp], [2.0e-200_dp, &
        1.0e-200_dp], flat)
    call tap%near(to_real(it%weight), 1.0_dp, 1.0e-14_dp, 'small units do not underflow')
    call tap%near(rounding([1.0_dp, -2.0_dp], flat, up), 2.0_dp**(-49), 0.0_dp, &
        'rounding is 4 ulp of the largest')
    call tap%finish()

contains

    !> A triangle by its points and tangents.
    pure type(triangle_type) function card(p1, t1, p2, p3, t3) result(it)
        real(dp), intent(in) :: p1(2), t1(2), p2(2), p3(2), t3(2)
        it = new_triangle(end_type(p1, t1), p2, end_type(p3, t3))
    end function card

end program test_triangle
