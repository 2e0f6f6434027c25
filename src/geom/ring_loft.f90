!> A duct: a surface lofted through rings, closed uniform cubic B-splines at stations. Around it is
!> such a spline at every station, along it the parametric cubic spline through the vertices of one
!> number, with free ends; slope and curvature go on everywhere, and each ring is met exactly.
!>
!> All vertices have one parameter along, the length of the chords summed over the vertices as
!> squares. So STA depends on it alone: at a station the duct is the ring of the vertices there, and
!> its area and centroid are those of a ring, exactly.
!>
!> Source: seed 002 (around), seed 000, first article (along); tensor product: L. Piegl and W.
!> Tiller, "The NURBS Book", 2nd ed., Springer 1997, 3.4; poles by blossoms: 5.2 there.
module geom_ring_loft
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use geom_bezier, only: bezier_point
    use geom_bspline, only: bspline_type
    use geom_bspline_surface, only: bspline_surface_type
    use geom_cubic_spline, only: cubic_spline_type, open_spline, spline_end_type, spline_segment
    use geom_fairing_curve, only: uniform_bspline
    use geom_fairing_system, only: spline_area
    use geom_spline_fit, only: fit_knots
    implicit none (type, external)
    private

    public :: ring_loft_type, new_ring_loft, ring_loft_surface, ring_at, stretch_of
    public :: ring_loft_volume

    !> A duct.
    type :: ring_loft_type
        integer :: vertices = 0             !! of each ring
        type(cubic_spline_type) :: along    !! STA, BL, WL of all vertices of a ring are one point
    end type ring_loft_type

    !> Halvings that find the parameter of a station.
    integer, parameter :: halvings = 60
    !> Nodes and weights of Gauss's rule of five points over 0 to 1: exact up to degree 9.
    real(dp), parameter :: node(5) = 0.5_dp + 0.5_dp*[-0.9061798459386640_dp, &
        -0.5384693101056831_dp, 0.0_dp, 0.5384693101056831_dp, 0.9061798459386640_dp]
    real(dp), parameter :: weight(5) = 0.5_dp*[0.2369268850561891_dp, 0.4786286704993665_dp, &
        0.5688888888888889_dp, 0.4786286704993665_dp, 0.2369268850561891_dp]

contains

    !> The duct through rings in order.
    !>
    !> Fails with `cause%not_single_valued` where the spline turns back in STA between two rings.
    pure subroutine new_ring_loft(ring, sta, loft, error)
        real(dp), intent(in) :: ring(:, :, :)               !! BL, WL: (2, vertices, rings)
        real(dp), intent(in) :: sta(:)                      !! of the rings, rising; two or more
        type(ring_loft_type), intent(out) :: loft           !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(spline_end_type), parameter :: free(2) = spline_end_type()
        real(dp), allocatable :: point(:, :, :)
        integer :: k

        loft%vertices = size(ring, 2)
        allocate (point(3, size(ring, 2), size(ring, 3)))
        do k = 1, size(sta)
            point(1, :, k) = sta(k)
            point(2:, :, k) = ring(:, :, k)
        end do
        call open_spline(reshape(point, [3*size(ring, 2), size(sta)]), .false., free, loft%along, &
            error)
        if (allocated(error)) return
        do k = 1, size(sta) - 1
            if (is_rising(stations_of(loft, k))) cycle
            call fail(error, cause%not_single_valued, 'the lines along the duct turn back '// &
                'between stations '//compact(sta(k))//' and '//compact(sta(k + 1))// &
                '; put an outline between, or take these further apart')
            return
        end do
    end subroutine new_ring_loft

    !> The stations of a stretch from ring to ring, as a Bezier cubic.
    pure function stations_of(loft, number) result(sta)
        type(ring_loft_type), intent(in) :: loft    !! any
        integer, intent(in) :: number               !! of the stretch, from 1
        real(dp) :: sta(4)
        real(dp), allocatable :: pole(:, :)
        allocate (pole, source=spline_segment(loft%along, number))
        sta = pole(1, :)
    end function stations_of

    !> True for a Bezier cubic whose derivative is above zero all the way.
    pure logical function is_rising(pole)
        real(dp), intent(in) :: pole(4) !! its ordinates
        real(dp) :: d(3)
        d = pole(2:) - pole(:3)
        is_rising = d(1) > 0.0_dp .and. d(3) > 0.0_dp .and. &
            (d(2) >= 0.0_dp .or. d(1)*d(3) > d(2)**2)
    end function is_rising

    !> The duct as a B-spline surface over 0 to 1: u around, v along.
    pure type(bspline_surface_type) function ring_loft_surface(loft) result(surface)
        type(ring_loft_type), intent(in) :: loft !! any
        real(dp), allocatable :: pole(:, :), breaks(:)
        type(bspline_type) :: around
        integer :: j, k

        allocate (pole, source=poles_along(loft%along))
        allocate (breaks(size(loft%along%length) + 1), source=0.0_dp)
        do k = 1, size(breaks) - 1
            breaks(k + 1) = breaks(k) + loft%along%length(k)
        end do
        surface%degree = 3
        allocate (surface%pole(3, loft%vertices + 3, size(pole, 2)))
        do j = 1, size(pole, 2)
            around = uniform_bspline(reshape(pole(:, j), [3, loft%vertices]), .true.)
            surface%pole(:, :, j) = around%pole
        end do
        surface%u_knot = around%knot/real(loft%vertices, dp)
        surface%v_knot = fit_knots(breaks/breaks(size(breaks)), 3)
        allocate (surface%weight(loft%vertices + 3, size(pole, 2)), source=1.0_dp)
    end function ring_loft_surface

    !> The poles of a cubic spline as a B-spline with single knots: the pole of knots a, b, c is the
    !> blossom f(a, b, c), on the line from f(a, b, a) to f(a, b, b), inner poles of the segment
    !> from a to b.
    pure function poles_along(along) result(pole)
        type(cubic_spline_type), intent(in) :: along    !! open
        real(dp), allocatable :: pole(:, :)
        real(dp), allocatable :: segment(:, :)
        integer :: k, last

        last = size(along%point, 2)
        allocate (pole(size(along%point, 1), last + 2))
        do k = 1, last - 1
            segment = spline_segment(along, k)
            if (k == 1) pole(:, :2) = segment(:, :2)
            if (k == last - 1) then
                pole(:, last + 1:) = segment(:, 3:)
            else
                pole(:, k + 2) = segment(:, 3) + (segment(:, 3) - segment(:, 2))* &
                    (along%length(k + 1)/along%length(k))
            end if
        end do
    end function poles_along

    !> Which stretch, from 1, has a station, and the parameter, 0 to 1, at which it is there.
    pure subroutine stretch_of(loft, sta, number, t)
        type(ring_loft_type), intent(in) :: loft    !! any
        real(dp), intent(in) :: sta                 !! from its first ring to its last
        integer, intent(out) :: number              !! the stretch
        real(dp), intent(out) :: t                  !! the parameter
        real(dp) :: ends(2), middle, pole(1, 4), at(1)
        integer :: k, last

        last = size(loft%along%length)
        number = max(1, min(last, count(loft%along%point(1, :) <= sta)))
        t = 0.0_dp
        if (sta <= loft%along%point(1, number)) return
        t = 1.0_dp
        if (sta >= loft%along%point(1, number + 1)) return
        pole(1, :) = stations_of(loft, number)
        ends = [0.0_dp, 1.0_dp]
        do k = 1, halvings
            middle = 0.5_dp*(ends(1) + ends(2))
            at = bezier_point(pole, middle)
            ends(merge(1, 2, at(1) <= sta)) = middle
        end do
        t = 0.5_dp*(ends(1) + ends(2))
    end subroutine stretch_of

    !> The vertices of the ring at a station, BL and WL: shape (2, vertices).
    pure function ring_at(loft, sta) result(ring)
        type(ring_loft_type), intent(in) :: loft    !! any
        real(dp), intent(in) :: sta                 !! from its first ring to its last
        real(dp), allocatable :: ring(:, :)
        integer :: number
        real(dp) :: t

        call stretch_of(loft, sta, number, t)
        allocate (ring, source=ring_of(spline_segment(loft%along, number), t))
    end function ring_at

    !> The vertices at a parameter of a stretch.
    pure function ring_of(segment, t) result(ring)
        real(dp), intent(in) :: segment(:, :)   !! poles of the stretch
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp), allocatable :: ring(:, :)
        real(dp) :: point(3, size(segment, 1)/3)

        point = reshape(bezier_point(segment, t), shape(point))
        allocate (ring, source=point(2:, :))
    end function ring_of

    !> The volume within from the first ring to the last, positive where the rings run
    !> counter-clockwise: the integral of area dSTA, a polynomial of degree 8 on each stretch.
    pure real(dp) function ring_loft_volume(loft) result(volume)
        type(ring_loft_type), intent(in) :: loft !! any
        real(dp), allocatable :: segment(:, :), ring(:, :)
        real(dp) :: d(3), t
        integer :: i, k

        volume = 0.0_dp
        do k = 1, size(loft%along%length)
            segment = spline_segment(loft%along, k)
            d = segment(1, 2:) - segment(1, :3)
            do i = 1, size(node)
                t = node(i)
                ring = ring_of(segment, t)
                volume = volume + weight(i)*spline_area(ring, .true.)*3.0_dp*(d(1)*(1.0_dp - t)**2 &
                    + 2.0_dp*d(2)*t*(1.0_dp - t) + d(3)*t**2)
            end do
        end do
    end function ring_loft_volume

end module geom_ring_loft
