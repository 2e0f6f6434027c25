!> Tests of contours as polygons. Oracles: the circle and the ellipse in closed form; the least
!> number of chords of a circle, pi/acos(1 - tolerance/radius).
program test_chords
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use cut_plane, only: plane_type, station_plane
    use export_chords, only: chord_polygon, decimals_for, polygon_type, round_polygon, rounded, &
        rounding_error, widest_gap
    use export_drawing, only: contour_type, curve_type
    use support_sketch, only: ellipse, line_curve, new_contour, segment
    use support_tap, only: tap_type
    implicit none (type, external)
    type(tap_type) :: tap

    call check_circle(1.0e-1_dp, 'a tenth')
    call check_circle(1.0e-3_dp, 'a thousandth')
    call check_circle(1.0e-6_dp, 'a millionth')
    call check_ellipse()
    call check_straight()
    call check_gaps()
    call check_rounding()
    call check_errors()
    call check_bad()
    call tap%finish()

contains

    subroutine check_circle(tolerance, name)
        real(dp), intent(in) :: tolerance   !! deck units
        character(*), intent(in) :: name    !! of the tolerance
        real(dp), parameter :: radius = 10.0_dp, pi = acos(-1.0_dp)
        type(polygon_type) :: polygon
        type(error_type), allocatable :: error
        real(dp) :: middle(2), miss, off
        integer :: i, next, count

        call chord_polygon(ellipse(station_plane(20.0_dp), [0.0_dp, 5.0_dp], [radius, radius]), &
            tolerance, polygon, error)
        call tap%ok(.not. allocated(error) .and. polygon%is_closed, name//': a closed polygon')
        count = size(polygon%at, 2)
        miss = 0.0_dp
        off = 0.0_dp
        do i = 1, count
            next = 1 + mod(i, count)
            off = max(off, abs(norm2(polygon%at(2:, i) - [0.0_dp, 5.0_dp]) - radius))
            middle = 0.5_dp*(polygon%at(2:, i) + polygon%at(2:, next)) - [0.0_dp, 5.0_dp]
            miss = max(miss, radius - norm2(middle))
        end do
        call tap%ok(off < 1.0e-13_dp, name//': its corners are on the circle')
        call tap%ok(miss <= tolerance, name//': its chords stay within the tolerance')
        call tap%near(polygon%error, miss, 0.05_dp*miss, name//': the error it states is this one')
        call tap%ok(real(count, dp) < 1.15_dp*pi/acos(1.0_dp - tolerance/radius) + 4.0_dp, &
            name//': it has few corners')
        call tap%near(norm2(polygon%worst - [20.0_dp, 0.0_dp, 5.0_dp]), radius, 1.0e-12_dp, &
            name//': the place of the largest error is on the circle')
        call tap%ok(all(abs(polygon%at(1, :) - 20.0_dp) <= 0.0_dp), name//': all at the station')
    end subroutine check_circle

    subroutine check_gaps()
        type(contour_type) :: contour
        type(curve_type) :: curves(2)
        real(dp), parameter :: o(3) = [0.0_dp, 0.0_dp, 0.0_dp], a(3) = [0.0_dp, 3.0_dp, 4.0_dp]

        curves(1) = line_curve(o, a)
        curves(2) = line_curve(a + [0.0_dp, 0.0_dp, 0.5_dp], a)
        contour = new_contour(curves, .false.)
        call tap%near(widest_gap(contour), 0.5_dp, 1.0e-15_dp, 'curves that are apart')
        contour%is_closed = .true.
        call tap%near(widest_gap(contour), 5.0_dp, 1.0e-15_dp, 'an end that should be the start')
        call tap%near(rounded(-1.23456_dp, 3), -1.235_dp, 0.0_dp, 'a number rounded')
    end subroutine check_gaps

    subroutine check_ellipse()
        type(polygon_type) :: polygon
        type(error_type), allocatable :: error
        real(dp), parameter :: a = 12.0_dp, b = 1.0_dp, tolerance = 1.0e-4_dp
        real(dp) :: way(2), normal(2), along(2), miss, centre
        integer :: i, next, count

        call chord_polygon(ellipse(station_plane(0.0_dp), [0.0_dp, 0.0_dp], [a, b]), tolerance, &
            polygon, error)
        count = size(polygon%at, 2)
        miss = 0.0_dp
        do i = 1, count
            next = 1 + mod(i, count)
            along = polygon%at(2:, next) - polygon%at(2:, i)
            normal = [along(2), -along(1)]/norm2(along)
            ! The tangent parallel to the chord is at distance sqrt((a nx)^2 + (b ny)^2).
            way = polygon%at(2:, i)
            centre = sqrt((a*normal(1))**2 + (b*normal(2))**2)
            miss = max(miss, centre - abs(dot_product(way, normal)))
        end do
        call tap%ok(.not. allocated(error), 'a flat ellipse has a polygon')
        call tap%ok(miss <= tolerance, 'no chord is farther from its ellipse than allowed')
        call tap%near(polygon%error, miss, 0.02_dp*tolerance, 'the error it states is this one')
    end subroutine check_ellipse

    subroutine check_straight()
        type(polygon_type) :: polygon
        type(error_type), allocatable :: error
        type(curve_type) :: curves(2)
        type(contour_type) :: contour

        call chord_polygon(segment([0.0_dp, 1.0_dp, 2.0_dp], [3.0_dp, 5.0_dp, 2.0_dp]), 1.0e-3_dp, &
            polygon, error)
        call tap%ok(size(polygon%at, 2) == 2 .and. polygon%error < 1.0e-15_dp, &
            'a straight piece has two corners and no error')
        call tap%ok(.not. polygon%is_closed, 'and is not closed')
        curves(1) = line_curve([0.0_dp, 0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp, 0.0_dp])
        curves(2) = line_curve([1.0_dp, 0.0_dp, 0.0_dp], [1.0_dp, 1.0_dp, 0.0_dp])
        call chord_polygon(new_contour(curves, .false.), 1.0e-3_dp, polygon, error)
        call tap%ok(size(polygon%at, 2) == 3, 'where two curves meet there is one corner')
        curves(1) = line_curve([7.0_dp, 0.0_dp, 1.0_dp], [7.0_dp, 0.0_dp, 1.0_dp])
        call chord_polygon(new_contour(curves(:1), .false.), 1.0e-3_dp, polygon, error)
        call tap%ok(size(polygon%at, 2) == 1, 'a curve that is a point has one corner')
        allocate (contour%curves(0))
        contour%at = [1.0_dp, 2.0_dp, 3.0_dp]
        call chord_polygon(contour, 1.0e-3_dp, polygon, error)
        call tap%ok(size(polygon%at, 2) == 1 .and. all(abs(polygon%at(:, 1) - contour%at) <= &
            0.0_dp), 'a contour without curves has its point')
    end subroutine check_straight

    subroutine check_rounding()
        type(polygon_type) :: polygon
        call tap%ok(decimals_for(1.0e-3_dp, 4) == 4, 'four decimals do for a thousandth')
        call tap%ok(decimals_for(1.0e-6_dp, 4) == 7, 'seven for a millionth')
        call tap%ok(decimals_for(1.0_dp, 3) == 3, 'not fewer than usual')
        call tap%near(rounding_error(3, 2), sqrt(2.0_dp)*0.0005_dp, 1.0e-18_dp, &
            'a corner moves half the last decimal along each axis')
        polygon%at = reshape([1.23456_dp, -0.00004_dp, 1.23461_dp, 0.00001_dp, 1.0e20_dp, 2.0_dp], &
            [2, 3])
        call round_polygon(polygon, 4)
        call tap%ok(size(polygon%at, 2) == 2, 'corners that fall together become one')
        call tap%ok(all(abs(polygon%at(:, 1) - [1.2346_dp, 0.0_dp]) <= 0.0_dp), &
            'numbers are rounded')
        call tap%ok(abs(polygon%at(1, 2) - 1.0e20_dp) <= 0.0_dp, 'a number without decimals stays')
        call tap%near(polygon%error, sqrt(0.5_dp)*1.0e-4_dp, 1.0e-18_dp, 'the error says so')
    end subroutine check_rounding

    subroutine check_errors()
        type(contour_type) :: contour
        type(polygon_type) :: polygon
        type(error_type), allocatable :: error

        contour = ellipse(station_plane(0.0_dp), [0.0_dp, 0.0_dp], [10.0_dp, 10.0_dp])
        contour%curves(3)%error = 0.6e-3_dp
        contour%curves(3)%worst = [0.0_dp, 1.0_dp, 2.0_dp]
        call chord_polygon(contour, 1.0e-3_dp, polygon, error)
        call tap%ok(polygon%error > 0.9e-3_dp .and. polygon%error <= 1.0e-3_dp, &
            'chords leave room for the error of their curve')
        contour%curves(3)%error = 0.0_dp
        contour%curves(2)%spline%pole(2, 1) = contour%curves(2)%spline%pole(2, 1) + 1.0e-4_dp
        call chord_polygon(contour, 1.0e-3_dp, polygon, error)
        call tap%ok(polygon%error > 0.9e-3_dp .and. polygon%error <= 1.0e-3_dp, &
            'and for a gap between curves')
    end subroutine check_errors

    subroutine check_bad()
        type(contour_type) :: contour
        type(polygon_type) :: polygon
        type(error_type), allocatable :: error

        contour = ellipse(station_plane(0.0_dp), [0.0_dp, 0.0_dp], [10.0_dp, 10.0_dp])
        contour%curves(1)%error = 2.0e-3_dp
        call chord_polygon(contour, 1.0e-3_dp, polygon, error)
        call tap%ok(allocated(error), 'a curve that is off by more than the tolerance is refused')
        if (allocated(error)) call tap%ok(error%cause == cause%no_convergence, 'by its cause')
        contour%curves(1)%error = 0.0_dp
        contour%curves(4)%spline%pole(2, 3) = 9.0_dp
        call chord_polygon(contour, 1.0e-3_dp, polygon, error)
        call tap%ok(allocated(error), 'a closed contour that does not close is refused')
        if (allocated(error)) call tap%ok(error%cause == cause%joint_gap, 'as a gap')
        contour = ellipse(station_plane(0.0_dp), [0.0_dp, 0.0_dp], [10.0_dp, 10.0_dp])
        call chord_polygon(contour, 1.0e-12_dp, polygon, error)
        call tap%ok(allocated(error), 'chords in their millions are refused')
        if (allocated(error)) call tap%ok(error%cause == cause%too_many, 'as too many')
    end subroutine check_bad

end program test_chords
