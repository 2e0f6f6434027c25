!> Areas and moments swept by arcs, in closed form.
program test_arc_integral
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type, line_between, reversed
    use geom_arc_integral, only: moments_type, operator(+), scaled, swept_by
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: up(2) = [0.0_dp, 1.0_dp], flat(2) = [1.0_dp, 0.0_dp]
    real(dp), parameter :: centre(2) = 0.0_dp, good = 1.0e-14_dp
    type(tap_type) :: tap
    type(arc_type) :: quarter, notched
    type(moments_type) :: whole
    real(dp) :: a, big

    quarter = card([1.0_dp, 0.0_dp], up, [0.6_dp, 0.8_dp], [0.0_dp, 1.0_dp], flat)
    call check(swept(quarter, centre), moments_type(0.25_dp*pi, [1.0_dp, 1.0_dp]/3.0_dp, &
        [pi/16.0_dp, pi/16.0_dp, 0.125_dp]), good, 'a quarter circle about its centre')
    call check(swept(reversed(quarter), centre), scaled(moments_type(0.25_dp*pi, &
        [1.0_dp, 1.0_dp]/3.0_dp, [pi/16.0_dp, pi/16.0_dp, 0.125_dp]), -1.0_dp), good, &
        'the same run through backwards')
    call check(swept(card([3.0_dp, 0.0_dp], up, [0.0_dp, 2.0_dp], [-3.0_dp, 0.0_dp], up), centre), &
        moments_type(3.0_dp*pi, [0.0_dp, 8.0_dp], [6.75_dp*pi, 3.0_dp*pi, 0.0_dp]), &
        10.0_dp*good, 'half an ellipse, its end tangents parallel')
    a = asin(0.28_dp)
    notched = card([-0.28_dp, 0.96_dp], -[0.96_dp, 0.28_dp], [0.0_dp, -1.0_dp], [0.28_dp, &
        0.96_dp], &
        [-0.96_dp, 0.28_dp])
    call check(swept(notched, centre), moments_type(pi - a, [0.0_dp, -0.56_dp/3.0_dp], &
        0.25_dp*[pi - a + 0.5_dp*sin(2.0_dp*a), pi - a - 0.5_dp*sin(2.0_dp*a), 0.0_dp]), &
        10.0_dp*good, 'a circle but for a notch')
    call check_area(card([0.0_dp, 0.0_dp], flat, [1.0_dp, 1.0_dp], [2.0_dp, 4.0_dp], &
        [1.0_dp, 4.0_dp]), 4.0_dp/3.0_dp, 'y = x**2 from 0 to 2')
    call check_area(card([1.0_dp, 1.0_dp], [1.0_dp, -1.0_dp], [2.0_dp, 0.5_dp], &
        [4.0_dp, 0.25_dp], [16.0_dp, -1.0_dp]), -log(4.0_dp), 'y = 1/x from 1 to 4')
    big = 2.0_dp**20
    call check_area(card([big, big], [1.0_dp, -1.0_dp], [2.0_dp*big, 0.5_dp*big], &
        [4.0_dp*big, 0.25_dp*big], [16.0_dp, -1.0_dp]), -log(4.0_dp)*big**2, &
        'the same, a million times')
    call check(swept(line_between([1.0_dp, 0.0_dp], [0.0_dp, 2.0_dp]), centre), &
        moments_type(1.0_dp, [1.0_dp, 2.0_dp]/3.0_dp, [1.0_dp/6.0_dp, 4.0_dp/6.0_dp, &
        1.0_dp/6.0_dp]), &
        good, 'a line: the triangle below it')

    whole = swept(quarter, [2.0_dp, -5.0_dp]) &
        + swept(card([0.0_dp, 1.0_dp], flat, [-0.6_dp, 0.8_dp], [-1.0_dp, 0.0_dp], up), &
        [2.0_dp, -5.0_dp]) + swept(card([-1.0_dp, 0.0_dp], up, [-0.6_dp, -0.8_dp], &
        [0.0_dp, -1.0_dp], flat), [2.0_dp, -5.0_dp]) &
        + swept(card([0.0_dp, -1.0_dp], flat, [0.6_dp, -0.8_dp], [1.0_dp, 0.0_dp], up), &
        [2.0_dp, -5.0_dp])
    call check(whole, moments_type(pi, [-2.0_dp, 5.0_dp]*pi, [4.25_dp, 25.25_dp, -10.0_dp]*pi), &
        100.0_dp*good, 'a circle by quarters about a point outside')
    call tap%finish()

contains

    !> The arc of a card that has one.
    type(arc_type) function card(p1, t1, p2, p3, t3) result(arc)
        real(dp), intent(in) :: p1(2), t1(2), p2(2), p3(2), t3(2)
        type(error_type), allocatable :: error
        call arc_through(end_type(p1, t1), p2, end_type(p3, t3), arc, error)
        if (allocated(error)) call tap%ok(.false., error%message)
    end function card

    !> What an arc sweeps.
    type(moments_type) function swept(arc, origin)
        type(arc_type), intent(in) :: arc
        real(dp), intent(in) :: origin(2)
        type(error_type), allocatable :: error
        call swept_by(arc, origin, swept, error)
        if (allocated(error)) call tap%ok(.false., error%message)
    end function swept

    !> Checks area and moments.
    subroutine check(found, expected, tolerance, name)
        type(moments_type), intent(in) :: found, expected
        real(dp), intent(in) :: tolerance
        character(*), intent(in) :: name
        call tap%near(found%area, expected%area, tolerance, 'area of '//name)
        call tap%near(maxval(abs(found%first - expected%first)), 0.0_dp, tolerance, &
            'first moments of '//name)
        call tap%near(maxval(abs(found%second - expected%second)), 0.0_dp, tolerance, &
            'second moments of '//name)
    end subroutine check

    !> Checks the area that an arc sweeps about the origin.
    subroutine check_area(arc, area, name)
        type(arc_type), intent(in) :: arc
        real(dp), intent(in) :: area
        character(*), intent(in) :: name
        type(moments_type) :: found
        found = swept(arc, centre)
        call tap%near(found%area/area, 1.0_dp, good, 'area of '//name)
    end subroutine check_area

end program test_arc_integral
