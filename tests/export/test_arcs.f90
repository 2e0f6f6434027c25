!> Contours as circular arcs. Oracles: circle and ellipse in closed form; sharp and smooth joints.
program test_arcs
    use base_constants, only: pi
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use cut_plane, only: plane_through, plane_type, station_plane
    use export_arcs, only: arc_contour_type, arc_rounding, arcs_of_contour, decimals_of_arcs, &
        parted_arcs
    use export_drawing, only: contour_type, curve_type
    use export_drawing_whole, only: mirrored_contour
    use geom_circular, only: circular_type, leaving, wrapped
    use support_sketch, only: ellipse, line_curve, new_contour
    use support_tap, only: tap_type
    implicit none (type, external)
    real(dp), parameter :: middle(2) = [0.0_dp, 5.0_dp], axes(2) = [12.0_dp, 7.0_dp]
    type(tap_type) :: tap

    call check_circle()
    call check_ellipse(1.0e-1_dp)
    call check_ellipse(1.0e-4_dp)
    call check_oblique()
    call check_corners()
    call check_mirror()
    call check_nearly_straight()
    call check_bad()
    call check_rounding()
    call tap%finish()

contains

    subroutine check_circle()
        type(arc_contour_type) :: chain
        type(circular_type), allocatable :: parts(:)
        type(error_type), allocatable :: error
        integer :: i

        call arcs_of_contour(station_plane(20.0_dp), ellipse(station_plane(20.0_dp), middle, &
            [9.0_dp, 9.0_dp]), 1.0e-3_dp, chain, error)
        call tap%ok(.not. allocated(error) .and. chain%is_closed, 'a circle')
        call tap%ok(size(chain%arcs) == 4 .and. all(chain%arcs%is_primary), &
            'is one arc for each of its four conics')
        call tap%near(maxval([(norm2(chain%arcs(i)%arc%centre - middle), i=1, 4)]), 0.0_dp, &
            1.0e-13_dp, 'about its centre')
        call tap%near(chain%error, 0.0_dp, 1.0e-13_dp, 'exactly')
        allocate (parts(0))
        parts = parted_arcs(chain)
        call tap%ok(size(parts) == 4, 'quarters need no parting')
        chain%arcs(1)%arc%turn = pi
        parts = parted_arcs(chain)
        call tap%ok(size(parts) == 5, 'a half circle is parted')
        call tap%near(abs(parts(2)%turn), 0.5_dp*pi, 1.0e-15_dp, 'in two')
    end subroutine check_circle

    !> Arcs of an ellipse: few, on it, smooth where the ellipse is.
    subroutine check_ellipse(tolerance)
        real(dp), intent(in) :: tolerance   !! of the arcs
        type(arc_contour_type) :: chain
        type(error_type), allocatable :: error
        real(dp) :: off, turn, angle, at(2), break
        integer :: i, k, next, count

        call arcs_of_contour(station_plane(20.0_dp), &
            ellipse(station_plane(20.0_dp), middle, axes), tolerance, chain, error)
        call tap%ok(.not. allocated(error), 'an ellipse')
        count = size(chain%arcs)
        call tap%ok(mod(count, 8) == 0, 'has as many arcs in each quarter, in pairs')
        call tap%ok(all(chain%arcs(2::2)%is_primary) .and. .not. any(chain%arcs(1::2)%is_primary), &
            'every other point is secondary')
        off = 0.0_dp
        turn = 0.0_dp
        break = 0.0_dp
        do i = 1, count
            next = 1 + mod(i, count)
            associate (arc => chain%arcs(i)%arc)
                do k = 0, 10
                    angle = arc%direction + 0.1_dp*real(k, dp)*arc%turn
                    at = arc%centre + arc%radius*[sin(angle), -cos(angle)] - middle
                    off = max(off, distance_to_ellipse(at))
                end do
                turn = turn + arc%turn
                break = max(break, abs(wrapped(leaving(arc) - chain%arcs(next)%arc%direction)), &
                    norm2(arc%finish - chain%arcs(next)%arc%start))
            end associate
        end do
        call tap%ok(off <= 0.75_dp*tolerance*(1.0_dp + 1.0e-6_dp), &
            'they are within three quarters of the tolerance')
        call tap%ok(off > 0.6_dp*chain%error .and. off <= 1.01_dp*chain%error, &
            'and as far off as is said')
        call tap%near(turn, 2.0_dp*pi, 1.0e-11_dp, 'they turn once')
        call tap%near(break, 0.0_dp, 1.0e-9_dp, 'end to end, and smooth everywhere')
        call tap%near(chain%worst(1), 20.0_dp, 0.0_dp, 'the largest deviation is in the plane')
        call tap%ok(distance_to_ellipse([chain%worst(2), chain%worst(3)] - middle) < 1.0e-12_dp, &
            'and on the ellipse')
    end subroutine check_ellipse

    !> The distance of a point near to the ellipse from it, by Newton's method for the foot.
    real(dp) function distance_to_ellipse(at) result(distance)
        real(dp), intent(in) :: at(2)   !! from its middle
        real(dp) :: t, foot(2), way(2), bend(2)
        integer :: i
        t = atan2(at(2)/axes(2), at(1)/axes(1))
        do i = 1, 20
            foot = axes*[cos(t), sin(t)]
            way = axes*[-sin(t), cos(t)]
            bend = -foot
            t = t - dot_product(foot - at, way) &
                /(dot_product(way, way) + dot_product(foot - at, bend))
        end do
        distance = norm2(axes*[cos(t), sin(t)] - at)
    end function distance_to_ellipse

    !> In another plane the arcs are the same.
    subroutine check_oblique()
        type(plane_type) :: plane
        type(arc_contour_type) :: chain, upright
        type(error_type), allocatable :: error

        call plane_through([1.0_dp, 2.0_dp, 3.0_dp], [1.0_dp, 0.4_dp, -0.7_dp], plane, error)
        call arcs_of_contour(plane, ellipse(plane, middle, axes), 1.0e-2_dp, chain, error)
        call arcs_of_contour(station_plane(0.0_dp), ellipse(station_plane(0.0_dp), middle, axes), &
            1.0e-2_dp, upright, error)
        call tap%ok(size(chain%arcs) == size(upright%arcs), 'an oblique plane has as many arcs')
        call tap%near(norm2(chain%start - upright%start), 0.0_dp, 1.0e-13_dp, 'from the same start')
        call tap%near(chain%error, upright%error, 1.0e-6_dp, 'with the same error')
    end subroutine check_oblique

    !> A sharp corner stays sharp, straight pieces stay straight, points between are left out.
    subroutine check_corners()
        type(curve_type) :: curves(3)
        type(arc_contour_type) :: chain
        type(error_type), allocatable :: error
        real(dp), parameter :: a(3) = [2.0_dp, 0.0_dp, 0.0_dp], b(3) = [2.0_dp, 3.0_dp, 0.0_dp], &
            c(3) = [2.0_dp, 3.0_dp, 4.0_dp]

        curves(1) = line_curve(a, b)
        curves(2) = line_curve(b, b)
        curves(3) = line_curve(b, c)
        call arcs_of_contour(station_plane(2.0_dp), new_contour(curves, .false.), 1.0e-3_dp, &
            chain, error)
        call tap%ok(size(chain%arcs) == 2 .and. all(chain%arcs%arc%is_line), &
            'two straight pieces; what is a point between them is left out')
        call tap%near(chain%arcs(2)%arc%direction - chain%arcs(1)%arc%direction, 0.5_dp*pi, &
            1.0e-15_dp, 'with their corner')
        call arcs_of_contour(station_plane(2.0_dp), new_contour(curves(2:2), .false.), 1.0e-3_dp, &
            chain, error)
        call tap%ok(size(chain%arcs) == 0, 'a point has no arc')
        call tap%near(norm2(chain%start - b(2:)), 0.0_dp, 0.0_dp, 'but a place')
    end subroutine check_corners

    !> The mirror image has the arcs of the original, backwards.
    subroutine check_mirror()
        type(arc_contour_type) :: own, image
        type(contour_type) :: contour
        type(plane_type) :: plane
        type(error_type), allocatable :: error
        real(dp) :: off
        integer :: i, count

        plane = station_plane(0.0_dp)
        contour = ellipse(plane, [1.0_dp, 5.0_dp], axes)
        contour%curves = contour%curves(1:1)
        contour%is_closed = .false.
        call arcs_of_contour(plane, contour, 1.0e-3_dp, own, error)
        call arcs_of_contour(plane, mirrored_contour(plane, contour), 1.0e-3_dp, image, error)
        count = size(own%arcs)
        call tap%ok(count > 4 .and. size(image%arcs) == count, 'a mirror image has as many arcs')
        off = 0.0_dp
        do i = 1, count
            off = max(off, norm2(image%arcs(i)%arc%start*[-1.0_dp, 1.0_dp] &
                - own%arcs(count + 1 - i)%arc%finish), abs(image%arcs(i)%arc%turn &
                - own%arcs(count + 1 - i)%arc%turn))
        end do
        call tap%near(off, 0.0_dp, 1.0e-9_dp, 'which are those of the original')
    end subroutine check_mirror

    !> A curve that is all but straight is a line, whatever its curvature does.
    subroutine check_nearly_straight()
        type(curve_type) :: curve
        type(arc_contour_type) :: chain
        type(error_type), allocatable :: error

        curve = line_curve([2.0_dp, 0.0_dp, 0.0_dp], [2.0_dp, 9.0_dp, 0.0_dp])
        curve%spline%degree = 3
        curve%spline%knot = [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
        curve%spline%weight = [1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
        curve%spline%pole = reshape([2.0_dp, 0.0_dp, 0.0_dp, 2.0_dp, 3.0_dp, 2.0e-6_dp, 2.0_dp, &
            6.0_dp, -1.0e-6_dp, 2.0_dp, 9.0_dp, 0.0_dp], [3, 4])
        call arcs_of_contour(station_plane(2.0_dp), new_contour([curve], .false.), 1.0e-3_dp, &
            chain, error)
        call tap%ok(size(chain%arcs) == 1 .and. chain%arcs(1)%arc%is_line, &
            'two millionths off a line is a line')
        call tap%near(chain%error, 2.0e-6_dp, 1.0e-18_dp, 'and says how far')
        curve%spline%pole(3, 2) = 2.0e-2_dp
        curve%spline%pole(3, 3) = -1.0e-2_dp
        call arcs_of_contour(station_plane(2.0_dp), new_contour([curve], .false.), 1.0e-3_dp, &
            chain, error)
        call tap%ok(size(chain%arcs) > 1, 'two hundredths are not')
    end subroutine check_nearly_straight

    subroutine check_bad()
        type(contour_type) :: contour
        type(arc_contour_type) :: chain
        type(error_type), allocatable :: error
        type(plane_type) :: plane

        plane = station_plane(0.0_dp)
        contour = ellipse(plane, middle, axes)
        contour%curves(3)%error = 0.8e-3_dp
        call arcs_of_contour(plane, contour, 1.0e-3_dp, chain, error)
        call tap%ok(allocated(error), 'a curve that takes all of the tolerance is refused')
        if (allocated(error)) then
            call tap%ok(error%cause == cause%no_convergence, 'with its cause')
            call tap%has(error%message, 'arcs within 0.001 take a better one', 'and says so')
        end if
        contour = ellipse(plane, middle, axes)
        contour%curves(3)%spline%pole(2, 1) = -12.01_dp
        call arcs_of_contour(plane, contour, 1.0e-3_dp, chain, error)
        call tap%ok(allocated(error), 'so are curves that do not meet')
        if (allocated(error)) call tap%ok(error%cause == cause%joint_gap, 'with their cause')
        call arcs_of_contour(plane, ellipse(plane, middle, axes), 1.0e-17_dp, chain, error)
        call tap%ok(allocated(error), 'and a tolerance below rounding')
        if (allocated(error)) call tap%ok(error%cause == cause%no_convergence, 'with its cause')
    end subroutine check_bad

    subroutine check_rounding()
        call tap%ok(decimals_of_arcs(1.0e-3_dp, 4) == 4, 'four decimals do for a thousandth')
        call tap%ok(decimals_of_arcs(0.025_dp, 3) == 3, 'three for .025 mm')
        call tap%ok(decimals_of_arcs(1.0e-4_dp, 4) == 5, 'a smaller tolerance takes more')
        call tap%ok(decimals_of_arcs(1.0_dp, 4) == 4, 'a large one no fewer than usual')
        call tap%near(arc_rounding(4), 1.5e-4_dp*sqrt(2.0_dp), 1.0e-18_dp, 'what rounding moves')
    end subroutine check_rounding

end program test_arcs
