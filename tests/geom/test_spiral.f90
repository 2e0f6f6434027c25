!> Spirals between lines and circles: figures worked out in 2026 with 16 digits, what a spiral must
!> have (ends on line and circle, slope, curvature, monotone curvature) over the whole range of
!> angles, and what can't be joined.
program test_spiral
    use base_constants, only: degrees, pi
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_type, line_between, reversed
    use geom_arc_by_circle, only: circle_by_radius
    use geom_arc_by_rho, only: arc_by_corner_rho
    use geom_cyclic, only: cyclic_jet
    use geom_spiral, only: circle_spiral, line_spiral, spiral_between, unevenness
    use geom_vector, only: cross
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_line_figures(tap)
    call check_circle_figures(tap)
    call check_line_range(tap)
    call check_circle_range(tap)
    call check_placed(tap)
    call check_refused()
    call tap%finish()

contains

    !> alpha = 1, theta = 30 degrees, R = 100.
    subroutine check_line_figures(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp) :: pole(2, 4), reach, x, h, at(2), first(2), second(2)

        ! The centre of that spiral, from its last pole and direction.
        x = 83.3785771896_dp - 50.0_dp
        h = 15.6967365340_dp + 100.0_dp*sqrt(0.75_dp)
        call line_spiral(1.0_dp, h, 100.0_dp, pole, reach)
        call tap%near(reach, x, 1.0e-8_dp, 'where the centre is along the line')
        call tap%near(maxval(abs(pole - reshape([0.0_dp, 0.0_dp, 28.0955159998_dp, 0.0_dp, &
            56.1910319996_dp, 0.0_dp, 83.3785771896_dp, 15.6967365340_dp], [2, 4]))), 0.0_dp, &
            1.0e-8_dp, 'poles of a spiral from a line')
        call cyclic_jet(pole, 1.0_dp, 0.5_dp, at, first, second)
        call tap%near(cross(first, second)/norm2(first)**3, 0.006425772211_dp, 1.0e-12_dp, &
            'its curvature half way')
        call line_spiral(1.0e-3_dp, 1.2_dp, 1.0_dp, pole, reach)
        ! Walton and Meek's cubic spiral: the third side is 6/5 cos(theta) of the first.
        call tap%near(norm2(pole(:, 4) - pole(:, 3))**2/pole(1, 2)/(pole(1, 4) - pole(1, 3)), &
            1.2_dp, 1.0e-5_dp, 'towards alpha = 0 it is the cubic spiral')
    end subroutine check_line_figures

    !> alpha = 1, theta = .6.
    subroutine check_circle_figures(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp) :: pole(2, 4)

        pole = circle_spiral(1.0_dp, 0.6_dp, [50.0_dp, -100.0_dp], 87.62988567053_dp)
        call tap%near(maxval(abs(pole - reshape([0.0_dp, 0.0_dp, 41.6613896749_dp, 0.0_dp, &
            113.9854552492_dp, 49.4795553883_dp, 172.9035575547_dp, 49.4795553883_dp], &
            [2, 4]))), 0.0_dp, 1.0e-9_dp, 'poles of a curve of S shape')
        call tap%near(norm2(pole(:, 4) - [0.0_dp, 100.0_dp] - [0.0_dp, 50.0_dp]), 200.0_dp, &
            1.0e-9_dp, 'its circles are 200 apart')
        call tap%ok(unevenness(pole, 1.0_dp) < 10.0_dp, 'its curvature is monotone')
        pole = circle_spiral(1.0_dp, 0.6_dp, [50.0_dp, 120.0_dp], 90.83002432237_dp)
        call tap%near(maxval(abs(pole(:, 4) - [141.1908707253_dp, 112.5302841834_dp])), 0.0_dp, &
            1.0e-9_dp, 'last pole of a curve of C shape')
        call tap%ok(unevenness(pole, 1.0_dp) >= huge(1.0_dp), &
            'whose curvature has an extremum, for its circles lie apart')
    end subroutine check_circle_figures

    !> All of the card's range: ALPHA to 90 degrees, circles from next to touching to far off.
    subroutine check_line_range(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp) :: pole(2, 4), reach, alpha, apart, worst(3), largest
        integer :: i, j

        worst = 0.0_dp
        largest = 0.0_dp
        do i = 1, 90
            alpha = real(i, dp)/degrees
            do j = -6, 12
                apart = 1.0_dp + 10.0_dp**(0.5_dp*real(j, dp))
                call line_spiral(alpha, apart, 1.0_dp, pole, reach)
                largest = max(largest, unevenness(pole, alpha))
                call look_at_end(pole, alpha, [reach, apart], worst)
            end do
        end do
        call tap%ok(largest < huge(1.0_dp), 'curvature is monotone for ALPHA 1 to 90')
        call tap%near(worst(1), 0.0_dp, 1.0e-13_dp, 'the spiral ends on its circle')
        call tap%near(worst(2), 0.0_dp, 1.0e-12_dp, 'along it')
        call tap%near(worst(3), 0.0_dp, 1.0e-12_dp, 'with its curvature')
        call line_spiral(100.0_dp/degrees, 1.0001_dp, 1.0_dp, pole, reach)
        call tap%ok(unevenness(pole, 100.0_dp/degrees) >= huge(1.0_dp), &
            'beyond it is not everywhere: ALPHA 100')
    end subroutine check_line_range

    !> How a curve ends on the unit circle about a point: distance, direction, curvature.
    subroutine look_at_end(pole, alpha, centre, worst)
        real(dp), intent(in) :: pole(2, 4)          !! the curve
        real(dp), intent(in) :: alpha               !! radians
        real(dp), intent(in) :: centre(2)           !! of the circle
        real(dp), intent(inout) :: worst(3)         !! so far
        real(dp), dimension(2) :: at, first, second, out
        real(dp) :: size

        call cyclic_jet(pole, alpha, 1.0_dp, at, first, second)
        out = at - centre
        size = maxval(abs(pole))
        worst(1) = max(worst(1), abs(norm2(out) - 1.0_dp)/size)
        worst(2) = max(worst(2), abs(dot_product(out, first))/norm2(first)/size)
        worst(3) = max(worst(3), abs(cross(first, second)/norm2(first)**3 - 1.0_dp))
    end subroutine look_at_end

    !> Circles of both shapes: THETA is found, and the curvature is monotone.
    subroutine check_circle_range(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(arc_type) :: before, after
        real(dp) :: alpha, ratio, apart, least
        integer :: i, j, found(2), k

        found = 0
        least = huge(1.0_dp)
        do i = 1, 3
            alpha = 30.0_dp*real(i, dp)/degrees
            do j = 1, 4
                ratio = 0.2_dp*real(j, dp)
                do k = 1, 3
                    apart = (1.0_dp + ratio)*(1.0_dp + 0.1_dp*real(k, dp)**3)
                    before = on_circle([0.0_dp, 0.0_dp], 1.0_dp)
                    after = on_circle([apart, 0.0_dp], -ratio)
                    if (is_joined(before, after, alpha)) found(1) = found(1) + 1
                    apart = (1.0_dp - ratio)*(1.0_dp - (1.0_dp - ratio)*0.02_dp*real(k, dp))
                    after = on_circle([0.0_dp, -apart], ratio)
                    if (is_joined(before, after, alpha)) found(2) = found(2) + 1
                    if (is_joined(reversed(after), reversed(before), alpha)) &
                        found(2) = found(2) + 1
                end do
            end do
        end do
        call tap%ok(found(1) == 36, 'all circles that lie apart have a spiral of S shape')
        call tap%ok(found(2) == 72, 'all these that lie in each other one of C shape')
    end subroutine check_circle_range

    !> A part of a circle.
    type(arc_type) function on_circle(centre, radius) result(arc)
        real(dp), intent(in) :: centre(2)   !! of the circle
        real(dp), intent(in) :: radius      !! negative: it turns right
        type(error_type), allocatable :: error
        call circle_by_radius(centre - [0.0_dp, radius], centre + [abs(radius), 0.0_dp], radius, &
            arc, error)
    end function on_circle

    !> True where two arcs have a spiral that begins and ends as they go, in all respects.
    logical function is_joined(before, after, alpha)
        type(arc_type), intent(in) :: before    !! of a circle
        type(arc_type), intent(in) :: after     !! of a circle
        real(dp), intent(in) :: alpha           !! radians
        type(error_type), allocatable :: error
        real(dp) :: pole(2, 4)
        real(dp), dimension(2) :: at, first, second, centre
        real(dp) :: bend, radius
        integer :: i

        call spiral_between(before, after, alpha, 0.0_dp, pole, error)
        is_joined = .not. allocated(error)
        if (.not. is_joined) return
        do i = 0, 1
            call cyclic_jet(pole, alpha, real(i, dp), at, first, second)
            bend = cross(first, second)/norm2(first)**3
            call centre_of(merge(before, after, i == 0), centre, radius)
            is_joined = is_joined .and. abs(bend*radius - 1.0_dp) < 1.0e-11_dp .and. &
                norm2(at + radius*[-first(2), first(1)]/norm2(first) - centre) < 1.0e-11_dp
        end do
        is_joined = is_joined .and. unevenness(pole, alpha) < 30.0_dp
    end function is_joined

    !> Centre and radius of an arc of a circle by its two normals (no arc here turns by 180).
    subroutine centre_of(arc, centre, radius)
        type(arc_type), intent(in) :: arc       !! of a circle
        real(dp), intent(out) :: centre(2)      !! of it
        real(dp), intent(out) :: radius         !! of it, below zero where it turns right
        real(dp) :: t(2), u(2)

        t = arc%start_tangent/norm2(arc%start_tangent)
        u = arc%finish_tangent/norm2(arc%finish_tangent)
        radius = sign(norm2(arc%finish - arc%start)/norm2([u(2) - t(2), t(1) - u(1)]), cross(t, u))
        centre = arc%start + radius*[-t(2), t(1)]
    end subroutine centre_of

    !> A line and a circle anywhere, both ways and both hands, against the figures about the axis.
    subroutine check_placed(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(random_type) :: random
        type(arc_type) :: line, circle
        type(error_type), allocatable :: error
        real(dp) :: pole(2, 4), back(2, 4), plain(2, 4), reach, angle, side, worst(3)
        real(dp), dimension(2) :: along, left, origin, at
        integer :: i, j

        worst = 0.0_dp
        do i = 1, 200
            angle = random%between(-pi, pi)
            along = [cos(angle), sin(angle)]
            side = merge(1.0_dp, -1.0_dp, random%unit() > 0.5_dp)
            left = side*[-along(2), along(1)]
            origin = [random%between(-9.0_dp, 9.0_dp), random%between(-9.0_dp, 9.0_dp)]
            call line_spiral(1.0_dp, 2.5_dp, 2.0_dp, plain, reach)
            at = origin + reach*along + 2.5_dp*left
            line = line_between(origin - 7.0_dp*along, &
                origin + random%between(-3.0_dp, 3.0_dp)*along)
            call circle_by_radius(at + 2.0_dp*along, at - 2.0_dp*left + 4.0_dp*left, 2.0_dp*side, &
                circle, error)
            call spiral_between(line, circle, 1.0_dp, 0.0_dp, pole, error)
            call spiral_between(reversed(circle), reversed(line), 1.0_dp, 0.0_dp, back, error)
            do j = 1, 4
                worst(1) = max(worst(1), norm2(origin + plain(1, j)*along + plain(2, j)*left &
                    - pole(:, j)))
            end do
            worst(2) = max(worst(2), maxval(abs(back(:, 4:1:-1) - pole)))
        end do
        call tap%near(worst(1), 0.0_dp, 1.0e-13_dp, 'a line and a circle anywhere, to either hand')
        call tap%near(worst(2), 0.0_dp, 1.0e-13_dp, 'and from the circle to the line')
    end subroutine check_placed

    !> What has no spiral.
    subroutine check_refused()
        type(arc_type) :: level, circle, conic
        type(error_type), allocatable :: error

        level = line_between([-5.0_dp, 0.0_dp], [0.0_dp, 0.0_dp])
        circle = on_circle([3.0_dp, 2.0_dp], 1.0_dp)
        call refuse(level, level, 'both straight', 'two lines')
        call refuse(level, on_circle([3.0_dp, 0.5_dp], 1.0_dp), 'crosses or touches the line', &
            'a circle that crosses the line')
        call refuse(level, on_circle([3.0_dp, 1.0_dp], 1.0_dp), 'crosses or touches the line', &
            'a circle that touches it')
        call refuse(level, on_circle([3.0_dp, -2.0_dp], 1.0_dp), 'other side of the line', &
            'a circle on the wrong side')
        call refuse(circle, on_circle([4.0_dp, 2.5_dp], -1.0_dp), 'must lie apart', &
            'circles of S shape that cross')
        call refuse(circle, on_circle([4.0_dp, 2.5_dp], 1.2_dp), 'inside the other', &
            'circles of C shape that cross')
        call refuse(circle, circle, 'inside the other', 'one circle')
        call arc_by_corner_rho([0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp], 0.5_dp, [2.0_dp, 2.0_dp], &
            conic, error)
        call refuse(level, conic, 'behind it is neither', 'a parabola')
        call refuse(conic, circle, 'before it is neither', 'also before it')
        call refuse(circle, on_circle([6.0_dp, 2.0_dp], -1.0_dp), 'leave THETA blank', &
            'a THETA without monotone curvature', 75.0_dp/degrees)
    end subroutine check_refused

    !> Checks that two arcs are not joined, and what is said.
    subroutine refuse(before, after, words, name, theta)
        type(arc_type), intent(in) :: before    !! first arc
        type(arc_type), intent(in) :: after     !! second arc
        character(*), intent(in) :: words       !! that the message has
        character(*), intent(in) :: name        !! the check as a phrase
        real(dp), intent(in), optional :: theta !! radians
        type(error_type), allocatable :: error
        real(dp) :: pole(2, 4), angle

        angle = 0.0_dp
        if (present(theta)) angle = theta
        call spiral_between(before, after, 1.0_dp, angle, pole, error)
        call tap%ok(allocated(error), 'refused: '//name)
        if (.not. allocated(error)) return
        call tap%ok(error%cause == cause%no_arc, 'as no arc: '//name)
        call tap%has(error%message, words, 'and it is said why: '//name)
    end subroutine refuse

end program test_spiral
