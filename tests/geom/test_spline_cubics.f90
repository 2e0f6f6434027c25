!> Cubic arcs along circles, parabolas (which they are exactly), corners and fitted curves.
program test_spline_cubics
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_arc_spline, only: arc_spline, line_spline
    use geom_bspline, only: bspline_type, mapped_spline, spline_point
    use geom_curve_fit, only: fit_curve
    use geom_spline_cubics, only: cubics_of
    use support_curves, only: example_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(bspline_type) :: s, flat
    type(arc_type) :: arc
    type(error_type), allocatable :: error
    real(dp), allocatable :: control(:, :, :)
    real(dp) :: largest, place(2), worst, tolerance
    integer :: i

    call arc_through(end_type([5.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), [3.0_dp, 4.0_dp], &
        end_type([0.0_dp, 5.0_dp], [1.0_dp, 0.0_dp]), arc, error)
    s = arc_spline(arc)
    do i = 2, 10, 2
        tolerance = 10.0_dp**(-i)
        call cubics_of(s, tolerance, control, largest, place)
        call tap%ok(off_circle(control) <= tolerance, &
            'a quarter of a circle is within the tolerance')
        call tap%near(largest/off_circle(control), 1.0_dp, 0.02_dp, 'as far as it says')
        call tap%near(norm2(place), 5.0_dp, 1.0e-14_dp, 'at a place of the circle')
        call tap%ok(all(control(:, 1, 1) == arc%start) .and. &
            all(control(:, 4, size(control, 3)) == arc%finish), 'its ends are as given')
        call tap%ok(is_smooth(control), 'its arcs meet with one tangent')
        ! One cubic is off by 2.7e-4 radii at best of Hermite's kind, and by a sixth power.
        call tap%ok(size(control, 3) <= ceiling((1.4e-3_dp/tolerance)**(1.0_dp/6.0_dp)) + 1, &
            'it takes few arcs')
    end do

    call arc_through(end_type([0.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), [1.0_dp, 3.0_dp], &
        end_type([4.0_dp, 4.0_dp], [1.0_dp, 0.0_dp]), arc, error)
    call cubics_of(arc_spline(arc), 1.0e-9_dp, control, largest, place)
    call tap%ok(size(control, 3) == 1 .and. largest < 1.0e-14_dp, &
        'a parabola is one cubic, exactly')
    call tap%ok(all(abs(control(:, 2, 1) - [0.0_dp, 8.0_dp/3.0_dp]) < 1.0e-8_dp), &
        'whose handles are two thirds of the way to the corner')

    call cubics_of(line_spline([1.0_dp, 2.0_dp], [4.0_dp, 8.0_dp]), 1.0e-9_dp, control, largest, &
        place)
    call tap%ok(size(control, 3) == 1 .and. largest < 1.0e-15_dp .and. &
        all(abs(control(:, 2, 1) - [2.0_dp, 4.0_dp]) < 1.0e-15_dp), &
        'a line is one with even thirds')
    s = bspline_type(2, [0.0_dp, 0.0_dp, 0.0_dp, 0.5_dp, 0.5_dp, 1.0_dp, 1.0_dp, 1.0_dp], &
        reshape([0.0_dp, &
        0.0_dp, 1.0_dp, 2.0_dp, 2.0_dp, 0.0_dp, 3.0_dp, 2.0_dp, 4.0_dp, 0.0_dp], [2, 5]), &
        [(1.0_dp, i=1, 5)])
    call cubics_of(s, 0.1_dp, control, largest, place)
    call tap%ok(size(control, 3) == 2 .and. all(control(:, 4, 1) == [2.0_dp, 0.0_dp]) .and. &
        all(control(:, 1, 2) == [2.0_dp, 0.0_dp]), 'a corner is kept')
    call tap%ok(control(2, 3, 1) > 0.1_dp .and. control(2, 2, 2) > 0.1_dp, &
        'with a tangent on each side')

    do i = 1, 3
        tolerance = 1.0e-4_dp
        call fit_curve(example_type(i), 1.0e-6_dp, s, largest, worst, error)
        call mapped_spline(s, reshape([1.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.3_dp], [2, 3]), &
            [0.0_dp, 0.0_dp], flat)
        call cubics_of(flat, tolerance, control, largest, place)
        call tap%ok(off_spline(flat, control) <= 1.02_dp*tolerance, 'fitted curves are within')
        call tap%ok(is_smooth(control), 'and smooth')
        call tap%ok(size(control, 3) < size(flat%weight), &
            'and take fewer arcs than the spline has poles')
    end do
    call tap%finish()

contains

    !> A point of a Bezier arc by de Casteljau's construction.
    pure function casteljau(c, u) result(p)
        real(dp), intent(in) :: c(2, 4) !! control points
        real(dp), intent(in) :: u       !! 0 to 1
        real(dp) :: p(2), q(2, 4)
        integer :: k
        q = c
        do k = 3, 1, -1
            q(:, :k) = (1.0_dp - u)*q(:, :k) + u*q(:, 2:k + 1)
        end do
        p = q(:, 1)
    end function casteljau

    !> The largest distance of arcs from the circle of radius 5.
    real(dp) function off_circle(control)
        real(dp), intent(in) :: control(:, :, :) !! arcs
        integer :: j, k
        off_circle = 0.0_dp
        do j = 1, size(control, 3)
            do k = 0, 100
                off_circle = max(off_circle, abs(norm2(casteljau(control(:, :, j), &
                    real(k, dp)/100.0_dp)) - 5.0_dp))
            end do
        end do
    end function off_circle

    !> The largest distance from points of a spline to points of its arcs, both dense, less what
    !> these are apart.
    real(dp) function off_spline(s, control)
        type(bspline_type), intent(in) :: s         !! in a plane
        real(dp), intent(in) :: control(:, :, :)    !! its arcs
        real(dp), allocatable :: at(:, :)
        real(dp) :: p(2), way(2), chord(2), nearest
        integer :: j, k, points
        points = 400*size(control, 3)
        allocate (at(2, 0:points))
        do j = 0, points - 1
            at(:, j) = casteljau(control(:, :, j/400 + 1), real(mod(j, 400), dp)/400.0_dp)
        end do
        at(:, points) = control(:, 4, size(control, 3))
        off_spline = 0.0_dp
        do k = 0, 1000
            p = spline_point(s, real(k, dp)/1000.0_dp)
            j = minloc((at(1, :) - p(1))**2 + (at(2, :) - p(2))**2, dim=1) - 1
            nearest = norm2(at(:, j) - p)
            do j = max(j, 1), min(j + 1, points)
                chord = at(:, j) - at(:, j - 1)
                way = p - at(:, j - 1)
                way = way - chord*min(1.0_dp, max(0.0_dp, dot_product(way, chord)/sum(chord**2)))
                nearest = min(nearest, norm2(way))
            end do
            off_spline = max(off_spline, nearest)
        end do
    end function off_spline

    !> True where neighbours share their end and their tangent.
    logical function is_smooth(control)
        real(dp), intent(in) :: control(:, :, :) !! arcs
        real(dp) :: behind(2), ahead(2)
        integer :: j
        is_smooth = .true.
        do j = 2, size(control, 3)
            behind = control(:, 4, j - 1) - control(:, 3, j - 1)
            ahead = control(:, 2, j) - control(:, 1, j)
            is_smooth = is_smooth .and. all(control(:, 1, j) == control(:, 4, j - 1)) .and. &
                norm2(behind/norm2(behind) - ahead/norm2(ahead)) < 1.0e-10_dp
        end do
    end function is_smooth

end program test_spline_cubics
