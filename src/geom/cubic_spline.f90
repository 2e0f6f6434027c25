!> The parametric cubic spline through points: the elastic batten of the loft. Of all curves through
!> the points it has the least integral of |r''|**2, the small-slope energy of bending; slope and
!> curvature go on through every point. Being parametric it knows no large slopes.
!>
!> Between points i - 1 and i, h apart in the parameter, it is a cubic with dr/dt = T at the ends;
!> the T are the solution of a tridiagonal system:
!>
!>     T(i-1)/h(i) + 2 (1/h(i) + 1/h(i+1)) T(i) + T(i+1)/h(i+1)
!>         = 3 (P(i) - P(i-1))/h(i)**2 + 3 (P(i+1) - P(i))/h(i+1)**2
!>
!> with a condition at each end. The parameter is the cumulative length of the chords, which suits
!> points at any distances, or 1 from point to point.
!>
!> Source: seed 000, first article, equations (11) to (21), with (13) and (19) corrected
!> (doc/theory.md); the closed form is added.
module geom_cubic_spline
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: to_text
    use geom_lapack, only: solve_banded
    use geom_ring_band, only: folded
    implicit none (type, external)
    private

    public :: spline_end_type, cubic_spline_type, open_spline, closed_spline, spline_segment

    !> What is asked at an end.
    type, public :: end_list
        integer :: free = 1         !! no bending: r'' = 0
        integer :: clamped = 2      !! the tangent is given
        integer :: parabolic = 3    !! the segment at the end is a parabola
    end type end_list
    type(end_list), parameter, public :: spline_end = end_list()

    !> An end of a spline.
    type :: spline_end_type
        integer :: kind = 1                     !! one of `spline_end%...`
        real(dp), allocatable :: tangent(:)     !! clamped: dr/dt; by chords a unit vector
    end type spline_end_type

    !> A spline: its segments go from point to point; a closed one has a last segment back to its
    !> first point.
    type :: cubic_spline_type
        real(dp), allocatable :: point(:, :)    !! deck units: (dimensions, points)
        real(dp), allocatable :: tangent(:, :)  !! dr/dt at the points, same shape
        real(dp), allocatable :: length(:)      !! of the segments, in the parameter
        logical :: is_closed = .false.          !! the last segment leads back to the first point
    end type cubic_spline_type

contains

    !> The spline through points in order, with a condition at each end. Two points with parabolic
    !> ends give the straight line between them.
    !>
    !> Fails with `cause%too_few` where there are less than two points, and with
    !> `cause%points_coincide` where neighbours are one.
    pure subroutine open_spline(points, is_uniform, ends, spline, error)
        real(dp), intent(in) :: points(:, :)                !! deck units: (dimensions, points)
        logical, intent(in) :: is_uniform                   !! 1 from point to point, not the chord
        type(spline_end_type), intent(in) :: ends(2)        !! at the first and the last point
        type(cubic_spline_type), intent(out) :: spline      !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: band(3, size(points, 2)), right(size(points, 2), size(points, 1))
        integer :: i, n

        n = size(points, 2)
        call measure_chords(points, 2, is_uniform, spline, error)
        if (allocated(error)) return
        band = 0.0_dp
        associate (h => spline%length)
            do i = 2, n - 1
                band(3, i - 1) = 1.0_dp/h(i - 1)
                band(2, i) = 2.0_dp*(1.0_dp/h(i - 1) + 1.0_dp/h(i))
                band(1, i + 1) = 1.0_dp/h(i)
                right(i, :) = inner_right(points(:, i - 1:i + 1), h(i - 1:i))
            end do
            call put_end(ends(1), points(:, 2) - points(:, 1), h(1), &
                band(2, 1), band(1, 2), right(1, :))
            call put_end(ends(2), points(:, n) - points(:, n - 1), h(n - 1), &
                band(2, n), band(3, n - 1), right(n, :))
        end associate
        if (n == 2 .and. all(ends%kind == spline_end%parabolic)) then
            band = reshape([0.0_dp, 2.0_dp, 0.0_dp, 0.0_dp, 2.0_dp, 0.0_dp], [3, 2])
        end if
        call solve_banded(band, 1, right, error)
        if (.not. allocated(error)) spline%tangent = transpose(right)
    end subroutine open_spline

    !> The closed spline through points in order and back to the first: slope and curvature go on
    !> there too.
    !>
    !> Fails with `cause%too_few` where there are less than three points, and with
    !> `cause%points_coincide` where neighbours, or the last and the first, are one.
    pure subroutine closed_spline(points, is_uniform, spline, error)
        real(dp), intent(in) :: points(:, :)                !! deck units: (dimensions, points)
        logical, intent(in) :: is_uniform                   !! 1 from point to point, not the chord
        type(cubic_spline_type), intent(out) :: spline      !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: band(5, size(points, 2)), right(size(points, 2), size(points, 1))
        integer :: place(size(points, 2)), i, n, before, after

        n = size(points, 2)
        call measure_chords(points, 3, is_uniform, spline, error)
        if (allocated(error)) return
        spline%is_closed = .true.
        place = folded(n)
        band = 0.0_dp
        associate (h => spline%length)
            do i = 1, n
                before = 1 + modulo(i - 2, n)
                after = 1 + modulo(i, n)
                call add_to(band, place(i), place(before), 1.0_dp/h(before))
                call add_to(band, place(i), place(i), 2.0_dp*(1.0_dp/h(before) + 1.0_dp/h(i)))
                call add_to(band, place(i), place(after), 1.0_dp/h(i))
                right(place(i), :) = inner_right(points(:, [before, i, after]), h([before, i]))
            end do
        end associate
        call solve_banded(band, 2, right, error)
        if (.not. allocated(error)) spline%tangent = transpose(right(place, :))
    end subroutine closed_spline

    !> Adds to an element of a matrix with two diagonals on either side.
    pure subroutine add_to(band, row, column, value)
        real(dp), intent(inout) :: band(:, :)   !! shape (5, n)
        integer, intent(in) :: row              !! of the element
        integer, intent(in) :: column           !! of the element
        real(dp), intent(in) :: value           !! what to add
        band(3 + row - column, column) = band(3 + row - column, column) + value
    end subroutine add_to

    !> Checks the points and sets the length of each segment.
    !>
    !> Fails with `cause%too_few` and `cause%points_coincide`.
    pure subroutine measure_chords(points, least, is_uniform, spline, error)
        real(dp), intent(in) :: points(:, :)                    !! in order
        integer, intent(in) :: least                            !! points: 2, of a closed spline 3
        logical, intent(in) :: is_uniform                       !! 1 from point to point
        type(cubic_spline_type), intent(inout) :: spline        !! gets both
        type(error_type), allocatable, intent(out) :: error     !! see above
        integer :: i, n, next

        n = size(points, 2)
        if (n < least) then
            call fail(error, cause%too_few, 'a spline through '//to_text(n)// &
                ' points; it takes at least '//to_text(least))
            return
        end if
        spline%point = points
        allocate (spline%length(merge(n, n - 1, least == 3)))
        do i = 1, size(spline%length)
            next = 1 + modulo(i, n)
            spline%length(i) = norm2(points(:, next) - points(:, i))
            if (spline%length(i) > 0.0_dp) cycle
            call fail(error, cause%points_coincide, 'points '//to_text(i)//' and '// &
                to_text(next)//' of the spline are one; leave one of them out')
            return
        end do
        if (is_uniform) spline%length = 1.0_dp
    end subroutine measure_chords

    !> The right side of the equation at a point inside.
    pure function inner_right(points, h) result(right)
        real(dp), intent(in) :: points(:, :)    !! the one before, the point, the one after
        real(dp), intent(in) :: h(2)            !! lengths before and after it
        real(dp) :: right(size(points, 1))
        right = 3.0_dp*(points(:, 2) - points(:, 1))/h(1)**2 &
            + 3.0_dp*(points(:, 3) - points(:, 2))/h(2)**2
    end function inner_right

    !> The equation at an end, the same at both: the way is from point to point along the curve.
    pure subroutine put_end(asked, way, h, own, other, right)
        type(spline_end_type), intent(in) :: asked  !! the condition
        real(dp), intent(in) :: way(:)              !! the chord of the segment at the end
        real(dp), intent(in) :: h                   !! its length in the parameter
        real(dp), intent(out) :: own                !! coefficient of the tangent at the end
        real(dp), intent(out) :: other              !! of that at the next point
        real(dp), intent(out) :: right(:)           !! right side

        own = 1.0_dp
        select case (asked%kind)
        case (spline_end%clamped)
            other = 0.0_dp
            right = asked%tangent
        case (spline_end%parabolic)
            other = 1.0_dp
            right = 2.0_dp*way/h
        case default
            own = 2.0_dp
            other = 1.0_dp
            right = 3.0_dp*way/h
        end select
    end subroutine put_end

    !> The poles of a segment as a Bezier curve, shape (dimensions, 4).
    pure function spline_segment(spline, number) result(pole)
        type(cubic_spline_type), intent(in) :: spline   !! any
        integer, intent(in) :: number                   !! which segment, from 1
        real(dp) :: pole(size(spline%point, 1), 4)
        real(dp) :: third
        integer :: next

        next = 1 + modulo(number, size(spline%point, 2))
        third = spline%length(number)/3.0_dp
        pole(:, 1) = spline%point(:, number)
        pole(:, 2) = spline%point(:, number) + third*spline%tangent(:, number)
        pole(:, 3) = spline%point(:, next) - third*spline%tangent(:, next)
        pole(:, 4) = spline%point(:, next)
    end function spline_segment

end module geom_cubic_spline
