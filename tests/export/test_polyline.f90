!> Arcs as lines of points. The oracle is the circle: every point's distance from its middle is
!> known, and so is how far the middle of a piece is from it.
program test_polyline
    use base_kinds, only: dp
    use base_error, only: error_type
    use export_polyline, only: polyline
    use geom_arc, only: arc_through, arc_type, direction_of_slope, end_type, line_between
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), parameter :: half = sqrt(0.5_dp), far = 5000.0_dp
    !> A turn that an eye would see as a corner, radians.
    real(dp), parameter :: seen_corner = 0.15_dp

    call try_circle()
    call try_far_circle()
    call try_long_way_round()
    call try_straight()
    call try_corner()
    call tap%finish()

contains

    !> An arc from three points and two slopes that have one.
    type(arc_type) function arc_of(points, slopes) result(arc)
        real(dp), intent(in) :: points(2, 3) !! points 1, 2, 3
        real(dp), intent(in) :: slopes(2)    !! at 1 and 3
        type(error_type), allocatable :: error
        call arc_through(end_type(points(:, 1), direction_of_slope(slopes(1))), points(:, 2), &
            end_type(points(:, 3), direction_of_slope(slopes(2))), arc, error)
        if (allocated(error)) call tap%ok(.false., 'the arc of the test exists: '//error%message)
    end function arc_of

    !> The largest turn from a piece to the next, radians.
    pure real(dp) function largest_turn(line)
        real(dp), intent(in) :: line(:, :) !! the points
        real(dp) :: u(2), v(2)
        integer :: i
        largest_turn = 0.0_dp
        do i = 2, size(line, 2) - 1
            u = line(:, i) - line(:, i - 1)
            v = line(:, i + 1) - line(:, i)
            largest_turn = max(largest_turn, &
                abs(atan2(u(1)*v(2) - u(2)*v(1), dot_product(u, v))))
        end do
    end function largest_turn

    subroutine try_circle()
        real(dp), allocatable :: line(:, :)
        real(dp) :: off, sag
        integer :: i

        allocate (line, source=polyline(arc_of(reshape( &
            [0.0_dp, -1.0_dp, half, -half, 1.0_dp, 0.0_dp], [2, 3]), [0.0_dp, 999.999_dp])))
        off = maxval(abs(norm2(line, dim=1) - 1.0_dp))
        sag = 0.0_dp
        do i = 2, size(line, 2)
            sag = max(sag, 1.0_dp - norm2(0.5_dp*(line(:, i) + line(:, i - 1))))
        end do
        call tap%near(off, 0.0_dp, 1.0e-15_dp, 'every point of a quarter circle is on the circle')
        call tap%near(sag, 0.0_dp, 1.0e-4_dp, &
            'no piece is further from it than .0001 of the radius')
        call tap%ok(largest_turn(line) < seen_corner, 'no corner is seen')
        call tap%ok(size(line, 2) < 150, 'a quarter circle needs no 150 points')
        call tap%ok(all(line(:, 1) == [0.0_dp, -1.0_dp]) .and. &
            all(line(:, size(line, 2)) == [1.0_dp, 0.0_dp]), 'the ends are exactly as given')
    end subroutine try_circle

    subroutine try_far_circle()
        real(dp), allocatable :: line(:, :)
        integer :: count

        allocate (line, source=polyline(arc_of(reshape([0.0_dp, -1.0_dp, 0.6_dp, -0.8_dp, 1.0_dp, &
            0.0_dp], [2, 3]), [0.0_dp, 999.999_dp])))
        count = size(line, 2)
        deallocate (line)
        allocate (line, source=polyline(arc_of(reshape([far, -1.0_dp - far, far + 0.6_dp, &
            -0.8_dp - far, far + 1.0_dp, -far], [2, 3]), [0.0_dp, 999.999_dp])))
        call tap%ok(size(line, 2) == count, 'far from the origin an arc has the same points')
    end subroutine try_far_circle

    !> 340 degrees of a circle about (0, 0), from 10 degrees right of the bottom, clockwise.
    subroutine try_long_way_round()
        real(dp), parameter :: s = sin(acos(-1.0_dp)/18.0_dp), c = cos(acos(-1.0_dp)/18.0_dp)
        real(dp), allocatable :: line(:, :)

        allocate (line, source=polyline(arc_of(reshape([s, -c, 0.0_dp, 1.0_dp, -s, -c], [2, 3]), &
            [s/c, -s/c])))
        call tap%near(maxval(abs(norm2(line, dim=1) - 1.0_dp)), 0.0_dp, 1.0e-14_dp, &
            'an arc of 340 degrees keeps to its circle')
        call tap%ok(largest_turn(line) < seen_corner, 'and shows no corner on the long way round')
        call tap%near(maxval(line(1, :)), 1.0_dp, 1.0e-3_dp, 'it reaches the right')
        call tap%near(minval(line(1, :)), -1.0_dp, 1.0e-3_dp, 'and the left')
    end subroutine try_long_way_round

    subroutine try_straight()
        real(dp), allocatable :: line(:, :)
        allocate (line, source=polyline(line_between([1.0_dp, 2.0_dp], [5.0_dp, 10.0_dp])))
        call tap%ok(size(line, 2) <= 3, 'a straight line needs no more than three points')
        call tap%ok(all(abs(line(2, :) - 2.0_dp*line(1, :)) <= 1.0e-15_dp), 'and they are on it')
    end subroutine try_straight

    !> A hyperbola that is nearly its two asymptotes; its corner is at (5, 5).
    subroutine try_corner()
        real(dp), allocatable :: line(:, :)
        allocate (line, source=polyline(arc_of(reshape([0.0_dp, 0.0_dp, 5.0_dp, 4.9999_dp, &
            10.0_dp, 0.0_dp], [2, 3]), [1.0_dp, -1.0_dp])))
        call tap%ok(largest_turn(line) < seen_corner, 'a sharp bend is rounded by enough points')
        call tap%ok(size(line, 2) < 300, 'without spending them where the arc is straight')
        call tap%near(maxval(line(2, :)), 4.9999_dp, 1.0e-12_dp, 'and its crest is among them')
    end subroutine try_corner

end program test_polyline
