!> Polygons along circles, whose chords are known in closed form, and along splines with corners.
program test_spline_polygon
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_arc_spline, only: arc_spline, line_spline
    use geom_bspline, only: bspline_type, spline_breaks, spline_point
    use geom_curve_fit, only: fit_curve
    use geom_spline_polygon, only: polygon_of
    use support_curves, only: example_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(bspline_type) :: s
    type(arc_type) :: arc
    type(error_type), allocatable :: error
    real(dp), allocatable :: t(:)
    real(dp) :: largest, worst, tolerance
    integer :: i, fewest

    call arc_through(end_type([5.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), [3.0_dp, 4.0_dp], &
        end_type([0.0_dp, 5.0_dp], [1.0_dp, 0.0_dp]), arc, error)
    s = arc_spline(arc)
    do i = 1, 6
        tolerance = 10.0_dp**(-i)
        call polygon_of(s, tolerance, t, largest)
        fewest = ceiling(0.25_dp*pi/acos(1.0_dp - tolerance/5.0_dp))
        call tap%ok(t(1) == 0.0_dp .and. t(size(t)) == 1.0_dp .and. all(t(2:) > t(:size(t) - 1)), &
            'a circle: its ends are in the polygon, which goes forward')
        call tap%ok(sagitta(s, t) <= tolerance, 'its chords are within the tolerance')
        call tap%near(largest/sagitta(s, t), 1.0_dp, 0.01_dp, 'as far as it says')
        call tap%ok(size(t) - 1 >= fewest .and. real(size(t) - 2, dp) <= 1.03_dp*real(fewest, dp), &
            'and as few as can be, or 3 in a hundred more')
    end do

    call polygon_of(line_spline([1.0_dp, 2.0_dp, 3.0_dp], [4.0_dp, 4.0_dp, 4.0_dp]), 1.0e-9_dp, &
        t, largest)
    call tap%ok(size(t) == 2 .and. largest < 1.0e-15_dp, 'a line is one chord')
    s = bspline_type(1, [0.0_dp, 0.0_dp, 0.3_dp, 1.0_dp, 1.0_dp], reshape([0.0_dp, 0.0_dp, &
        1.0_dp, 0.0_dp, &
        1.0_dp, 3.0_dp], [2, 3]), [1.0_dp, 1.0_dp, 1.0_dp])
    call polygon_of(s, 1.0_dp, t, largest)
    call tap%ok(all(t == [0.0_dp, 0.3_dp, 1.0_dp]), 'corners are kept however wide the tolerance')
    s = bspline_type(3, [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp], &
        reshape([0.0_dp, 0.0_dp, 4.0_dp, 3.0_dp, -4.0_dp, 3.0_dp, 0.0_dp, 0.0_dp], [2, 4]), &
        [1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp])
    call polygon_of(s, 1.0e-3_dp, t, largest)
    call tap%ok(size(t) > 20 .and. distance(s, t) <= 1.0e-3_dp, 'a loop that ends where it begins')

    call fit_curve(example_type(2), 1.0e-6_dp, s, largest, worst, error)
    call polygon_of(s, 1.0e-3_dp, t, largest)
    call tap%ok(distance(s, t) <= 1.0e-3_dp, 'a peak is followed')
    call tap%ok(all([(any(t == worst_break(i)), i=1, size(spline_breaks(s)))]), 'breaks are in it')
    call tap%finish()

contains

    !> A break of the spline.
    real(dp) function worst_break(number)
        integer, intent(in) :: number !! which
        real(dp), allocatable :: breaks(:)
        allocate (breaks, source=spline_breaks(s))
        worst_break = breaks(number)
    end function worst_break

    !> The largest height of a circle of radius 5 over the chords of a polygon.
    real(dp) function sagitta(s, t)
        type(bspline_type), intent(in) :: s !! on the circle
        real(dp), intent(in) :: t(:)        !! the polygon
        integer :: j
        sagitta = 0.0_dp
        do j = 2, size(t)
            sagitta = max(sagitta, 5.0_dp - sqrt(25.0_dp - 0.25_dp*sum((spline_point(s, t(j)) - &
                spline_point(s, t(j - 1)))**2)))
        end do
    end function sagitta

    !> The largest distance of a spline from a polygon, at 97 points of each chord.
    real(dp) function distance(s, t)
        type(bspline_type), intent(in) :: s !! any spline
        real(dp), intent(in) :: t(:)        !! the polygon
        real(dp), dimension(size(s%pole, 1)) :: from, chord, way
        integer :: j, k
        distance = 0.0_dp
        do j = 2, size(t)
            from = spline_point(s, t(j - 1))
            chord = spline_point(s, t(j)) - from
            do k = 1, 97
                way = spline_point(s, t(j - 1) + real(k, dp)/98.0_dp*(t(j) - t(j - 1))) - from
                way = way - chord*min(1.0_dp, max(0.0_dp, dot_product(way, chord)/sum(chord**2)))
                distance = max(distance, norm2(way))
            end do
        end do
    end function distance

end program test_spline_polygon
