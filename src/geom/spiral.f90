!> Spirals, as C-Bezier cubics of monotone curvature that join a straight line and a circle, or two
!> circles, with slope and curvature going on at both ends.
!>
!> With K and M of `geom_cyclic` and c = K**2 M/(1 - cos alpha), a C-Bezier cubic of sides g, h, k
!> has at its start the curvature c h sin(theta)/g**2, theta the angle from the first side to the
!> second; at its end likewise. From a line to a circle of radius R the first two sides are on the
!> line and equal, the third is q times as long, and the curvature is level at the circle:
!>
!>     q = q0 cos(theta)       q0 = 3 M**2 K**2/((1 - cos alpha)(2 - M) + 3 M K sin alpha)
!>     h = R c sin(theta)/q**2
!>
!> so that the centre is D = R (cos(theta) + (e/cos(theta)) sin(theta)**2) from the line, e = c/q0,
!> which gives theta for any D > R. Of two circles the outer sides follow from the curvatures, and
!> the middle one from the distance of the centres, by bisection, for any theta: LOFT takes that of
!> whole degrees with the evenest change of curvature. Circles that turn the same way have such a
!> spiral only where one lies inside the other (A. Kneser, 1912).
!>
!> Sources: seed 001, contents of chapters 4 and 5 (C-Bezier spirals, line to circle, circle to
!> circle); the formulas were worked out for LOFT.
module geom_spiral
    use base_constants, only: degrees
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use base_tolerances, only: decimal_noise, ulp
    use geom_arc, only: arc_type
    use geom_cyclic, only: cyclic_jet, middle_ratio, start_ratio
    use geom_track, only: backwards, left_of, track_of, track_type
    use geom_vector, only: at_text, cross
    implicit none (type, external)
    private

    public :: spiral_between, line_spiral, circle_spiral, unevenness

    !> Places at which the change of curvature is looked at.
    integer, parameter :: samples = 240
    !> How much of the largest curvature a step back may be and still be rounding.
    real(dp), parameter :: bend_noise = 1.0e-9_dp
    !> Whole degrees that are tried for theta.
    integer, parameter :: most_degrees = 80
    !> Steps from the shortest middle side tried to the longest, in parts of all lengths given; and
    !> halvings of a step.
    integer, parameter :: steps = 800, halvings = 60
    real(dp), parameter :: shortest = 1.0e-6_dp, longest = 4.0_dp

contains

    !> The spiral from an arc or line to another, on the way along them.
    !>
    !> Fails with `cause%no_arc`: an arc is of no circle, both are lines, the circle crosses the
    !> line or lies on the wrong side, circles cross or lie wrong, or no curvature is monotone.
    pure subroutine spiral_between(before, after, alpha, theta, pole, error)
        type(arc_type), intent(in) :: before                !! where it begins
        type(arc_type), intent(in) :: after                 !! where it ends
        real(dp), intent(in) :: alpha                       !! radians, above 0, to pi/2
        real(dp), intent(in) :: theta                       !! circle to circle: radians; 0: found
        real(dp), intent(out) :: pole(2, 4)                 !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(track_type) :: first, last

        call track_of(before, 'before', first, error)
        if (.not. allocated(error)) call track_of(after, 'behind', last, error)
        if (allocated(error)) return
        if (first%is_line .and. last%is_line) then
            call fail(error, cause%no_arc, 'a spiral joins a straight line and a circular arc, '// &
                'or two arcs; the cards before and behind it are both straight lines')
        else if (first%is_line) then
            call join_line(first, last, alpha, pole, error)
        else if (last%is_line) then
            call join_line(backwards(last), backwards(first), alpha, pole, error)
            pole = pole(:, 4:1:-1)
        else
            call join_circles(first, last, alpha, theta, pole, error)
        end if
    end subroutine spiral_between

    !> From a line to a circle. Fails with `cause%no_arc`.
    pure subroutine join_line(line, circle, alpha, pole, error)
        type(track_type), intent(in) :: line                !! where it begins
        type(track_type), intent(in) :: circle              !! where it ends
        real(dp), intent(in) :: alpha                       !! radians
        real(dp), intent(out) :: pole(2, 4)                 !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: off(2), apart, radius, side, reach

        side = sign(1.0_dp, circle%radius)
        radius = abs(circle%radius)
        off = circle%centre - line%start
        apart = side*cross(line%along, off)
        pole = 0.0_dp
        if (apart < 0.0_dp) then
            call fail(error, cause%no_arc, 'the circle about '//at_text(circle%centre)// &
                ' lies on the other side of the line than it turns to; a spiral turns as it does')
        else if (apart <= radius*(1.0_dp + decimal_noise*ulp)) then
            call fail(error, cause%no_arc, 'the circle of radius '//compact(radius)//' about '// &
                at_text(circle%centre)//' crosses or touches the line, which is '// &
                compact(apart)//' from its centre; a spiral needs it further off than the radius')
        else
            call line_spiral(alpha, apart, radius, pole, reach)
            pole = placed(pole, line%start + (dot_product(off, line%along) - reach)*line%along, &
                line%along, side)
        end if
    end subroutine join_line

    !> The spiral from the x axis, where it begins at the origin, to a circle above it.
    pure subroutine line_spiral(alpha, apart, radius, pole, reach)
        real(dp), intent(in) :: alpha       !! radians
        real(dp), intent(in) :: apart       !! of the centre from the axis, more than `radius`
        real(dp), intent(in) :: radius      !! of the circle, deck units
        real(dp), intent(out) :: pole(2, 4) !! of the spiral
        real(dp), intent(out) :: reach      !! x of the centre
        real(dp) :: k, m, q, c, e, z, s, side

        k = start_ratio(alpha)
        m = middle_ratio(alpha)
        c = bend_ratio(alpha)
        q = 3.0_dp*(m*k)**2/(2.0_dp*sin(0.5_dp*alpha)**2*(2.0_dp - m) + 3.0_dp*m*k*sin(alpha))
        e = c/q
        ! (1 - e) z**2 - (D/R) z + e = 0 for z = cos(theta).
        z = apart/radius
        z = 2.0_dp*e/(z + sqrt(z**2 - 4.0_dp*e*(1.0_dp - e)))
        s = sqrt((1.0_dp - z)*(1.0_dp + z))
        q = q*z
        side = radius*c*s/q**2
        pole = 0.0_dp
        pole(1, 2:) = [side, 2.0_dp*side, side*(2.0_dp + q*z)]
        pole(2, 4) = side*q*s
        reach = pole(1, 4) - radius*s
    end subroutine line_spiral

    !> c, see above: 2/3 towards alpha = 0.
    elemental real(dp) function bend_ratio(alpha) result(c)
        real(dp), intent(in) :: alpha !! radians
        c = start_ratio(alpha)**2*middle_ratio(alpha)/(2.0_dp*sin(0.5_dp*alpha)**2)
    end function bend_ratio

    !> From a circle to another. Fails with `cause%no_arc`.
    pure subroutine join_circles(first, last, alpha, theta, pole, error)
        type(track_type), intent(in) :: first               !! where it begins
        type(track_type), intent(in) :: last                !! where it ends
        real(dp), intent(in) :: alpha                       !! radians
        real(dp), intent(in) :: theta                       !! radians; 0: to be found
        real(dp), intent(out) :: pole(2, 4)                 !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: radius(2), way(2), local(2), side, along(2), least
        integer :: i

        way = last%centre - first%centre
        side = sign(1.0_dp, first%radius)
        radius = side*[first%radius, last%radius]
        pole = 0.0_dp
        call check_apart(radius, norm2(way), error)
        if (allocated(error)) return
        least = huge(1.0_dp)
        if (theta > 0.0_dp) call try_angle(alpha, theta, radius, norm2(way), pole, least)
        do i = 1, merge(0, most_degrees, theta > 0.0_dp)
            call try_angle(alpha, real(i, dp)/degrees, radius, norm2(way), pole, least)
        end do
        if (least >= huge(1.0_dp)) then
            call fail(error, cause%no_arc, 'no spiral between the two circles has monotone '// &
                'curvature with this ALPHA and THETA; leave THETA blank, or move the circles')
            return
        end if
        local = to_centre(pole, radius)*[1.0_dp, side]
        along = [dot_product(local, way), cross(local, way)]
        along = along/norm2(along)
        pole = placed(pole, first%centre - first%radius*left_of(along), along, side)
    end subroutine join_circles

    !> Fails with `cause%no_arc` where no curve of monotone curvature joins two circles.
    pure subroutine check_apart(radius, apart, error)
        real(dp), intent(in) :: radius(2)                   !! the second below 0: it turns right
        real(dp), intent(in) :: apart                       !! of the centres
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: touch
        character(:), allocatable :: words

        touch = abs(radius(1) - radius(2))
        words = ': the radii are '//compact(abs(radius(1)))//' and '//compact(abs(radius(2)))// &
            ', the centres '//compact(apart)//' apart'
        if (radius(2) < 0.0_dp) then
            if (apart <= touch*(1.0_dp + decimal_noise*ulp)) call fail(error, cause%no_arc, &
                'circles that turn opposite ways must lie apart for a spiral from one to the '// &
                'other; these meet'//words)
        else if (apart >= touch*(1.0_dp - decimal_noise*ulp)) then
            call fail(error, cause%no_arc, 'of two circles that turn the same way one must lie '// &
                'inside the other for a spiral of monotone curvature; these do not'//words)
        end if
    end subroutine check_apart

    !> Looks for spirals of one theta, and keeps the evenest.
    pure subroutine try_angle(alpha, theta, radius, apart, pole, least)
        real(dp), intent(in) :: alpha           !! radians
        real(dp), intent(in) :: theta           !! radians
        real(dp), intent(in) :: radius(2)       !! as `circle_spiral`
        real(dp), intent(in) :: apart           !! of the centres
        real(dp), intent(inout) :: pole(2, 4)   !! the evenest so far
        real(dp), intent(inout) :: least        !! its unevenness
        real(dp) :: side(2), middle, new(2, 4), pace, uneven
        integer :: i, k

        pace = (longest/shortest)**(1.0_dp/real(steps, dp))
        side(2) = shortest*(apart + maxval(abs(radius)))
        do i = 1, steps
            side = [side(2), side(2)*pace]
            if (is_short(side(1)) .eqv. is_short(side(2))) cycle
            do k = 1, halvings
                middle = 0.5_dp*(side(1) + side(2))
                if (is_short(middle) .eqv. is_short(side(1))) then
                    side(1) = middle
                else
                    side(2) = middle
                end if
            end do
            new = circle_spiral(alpha, theta, radius, middle)
            uneven = unevenness(new, alpha)
            if (uneven >= least) cycle
            least = uneven
            pole = new
        end do
    contains
        !> True where the centres are too near to each other with a middle side.
        pure logical function is_short(length)
            real(dp), intent(in) :: length !! of the middle side, deck units
            is_short = norm2(to_centre(circle_spiral(alpha, theta, radius, length), radius)) < apart
        end function is_short
    end subroutine try_angle

    !> The curve from a circle on which it begins, in the origin along x and turning left, to one
    !> that turns left (C-shaped, by 2 theta in all) or right (S-shaped, parallel at the ends).
    pure function circle_spiral(alpha, theta, radius, side) result(pole)
        real(dp), intent(in) :: alpha       !! radians
        real(dp), intent(in) :: theta       !! radians, at both ends
        real(dp), intent(in) :: radius(2)   !! above 0; the second below 0 where it turns right
        real(dp), intent(in) :: side        !! length of the middle side, deck units
        real(dp) :: pole(2, 4)
        real(dp) :: outer(2)

        outer = sqrt(bend_ratio(alpha)*abs(radius)*side*sin(theta))
        pole(:, 1) = 0.0_dp
        pole(:, 2) = [outer(1), 0.0_dp]
        pole(:, 3) = pole(:, 2) + side*[cos(theta), sin(theta)]
        pole(:, 4) = pole(:, 3) + outer(2)*end_direction(theta, radius)
    end function circle_spiral

    !> The direction in which a curve of `circle_spiral` ends.
    pure function end_direction(theta, radius) result(along)
        real(dp), intent(in) :: theta       !! radians
        real(dp), intent(in) :: radius(2)   !! as `circle_spiral`
        real(dp) :: along(2)
        along = [1.0_dp, 0.0_dp]
        if (radius(2) > 0.0_dp) along = [cos(2.0_dp*theta), sin(2.0_dp*theta)]
    end function end_direction

    !> The way from the centre of the first circle of a curve to that of the second.
    pure function to_centre(pole, radius) result(way)
        real(dp), intent(in) :: pole(2, 4)  !! by `circle_spiral`
        real(dp), intent(in) :: radius(2)   !! of both
        real(dp) :: way(2), along(2)
        along = [1.0_dp, 0.0_dp]
        if (radius(2) > 0.0_dp) along = (pole(:, 4) - pole(:, 3))/norm2(pole(:, 4) - pole(:, 3))
        way = pole(:, 4) + radius(2)*left_of(along) - [0.0_dp, radius(1)]
    end function to_centre

    !> Poles in their place.
    pure function placed(pole, origin, along, side)
        real(dp), intent(in) :: pole(2, 4)  !! about the origin, along x, to the left
        real(dp), intent(in) :: origin(2)   !! where the origin is to be
        real(dp), intent(in) :: along(2)    !! unit vector of x
        real(dp), intent(in) :: side        !! 1, or -1 where left becomes right
        real(dp) :: placed(2, 4)
        integer :: i
        do i = 1, 4
            placed(:, i) = origin + pole(1, i)*along + side*pole(2, i)*left_of(along)
        end do
    end function placed

    !> The largest change of curvature over length, in parts of the mean: 1 of a clothoid; `huge`
    !> where the curvature is not monotone.
    pure real(dp) function unevenness(pole, alpha) result(uneven)
        real(dp), intent(in) :: pole(2, 4)  !! of a C-Bezier cubic
        real(dp), intent(in) :: alpha       !! radians
        real(dp) :: at(2, 0:samples), first(2), second(2), step(samples), rise(samples)
        real(dp) :: bend(0:samples), noise
        integer :: i

        do i = 0, samples
            call cyclic_jet(pole, alpha, real(i, dp)/real(samples, dp), at(:, i), first, second)
            bend(i) = cross(first, second)/norm2(first)**3
        end do
        step = norm2(at(:, 1:) - at(:, :samples - 1), dim=1)
        rise = (bend(1:) - bend(:samples - 1))*sign(1.0_dp, bend(samples) - bend(0))
        noise = bend_noise*maxval(abs(bend))
        uneven = huge(1.0_dp)
        if (all(rise >= -noise) .and. abs(bend(samples) - bend(0)) > noise) &
            uneven = maxval(rise/step)*sum(step)/abs(bend(samples) - bend(0))
    end function unevenness

end module geom_spiral
