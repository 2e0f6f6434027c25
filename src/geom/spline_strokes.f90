!> The way back from a B-spline of the plane to strokes, where it is exact: a polynomial span is a
!> Bezier curve, a rational quadratic span an arc of a conic, a span of degree 1 a straight line.
!> (`geom_stroke_spline` is the way there.)
!>
!> The poles of a span from u to v are its polar form with so many parameters u and v, found with
!> weights as a third coordinate. Source: L. Ramshaw, "Blossoms are polar forms", Computer Aided
!> Geometric Design 6 (1989), pp. 323-358.
module geom_spline_strokes
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: to_text
    use base_tolerances, only: decimal_noise, ulp
    use geom_arc, only: arc_type, line_between
    use geom_arc_by_rho, only: arc_by_corner_rho
    use geom_bspline, only: bspline_type, spline_breaks
    use geom_points, only: are_in_line
    use geom_stroke, only: bezier_stroke, conic_stroke, stroke_type
    implicit none (type, external)
    private

    public :: strokes_of

contains

    !> The strokes of a spline, one for each span.
    !>
    !> Fails with `cause%no_arc` where a span is rational of a degree above 2, or as
    !> `arc_by_corner_rho`.
    pure subroutine strokes_of(spline, strokes, error)
        type(bspline_type), intent(in) :: spline            !! of the plane, weights above 0
        type(stroke_type), allocatable, intent(out) :: strokes(:)   !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp), allocatable :: breaks(:)
        integer :: i

        allocate (breaks(0))
        breaks = spline_breaks(spline)
        allocate (strokes(size(breaks) - 1))
        do i = 1, size(strokes)
            call span_stroke(span_poles(spline, breaks(i), breaks(i + 1)), strokes(i), error)
            if (allocated(error)) return
        end do
    end subroutine strokes_of

    !> The stroke of one span. Fails as `strokes_of`.
    pure subroutine span_stroke(pole, stroke, error)
        real(dp), intent(in) :: pole(:, :)                  !! x w, y w, w of its poles
        type(stroke_type), intent(out) :: stroke            !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: at(2, size(pole, 2)), w
        type(arc_type) :: arc
        integer :: degree

        degree = size(pole, 2) - 1
        at = pole(:2, :)/spread(pole(3, :), 1, 2)
        if (degree == 1) then
            stroke = conic_stroke(line_between(at(:, 1), at(:, 2)))
        else if (all(abs(pole(3, :) - pole(3, 1)) <= decimal_noise*ulp*pole(3, 1))) then
            stroke = bezier_stroke(at)
        else if (degree > 2) then
            call fail(error, cause%no_arc, 'a rational curve of degree '//to_text(degree)// &
                ' is no line of LOFT; only rational quadratics are conics')
        else if (are_in_line(at)) then
            stroke = conic_stroke(line_between(at(:, 1), at(:, 3)))
        else
            w = pole(3, 2)/sqrt(pole(3, 1)*pole(3, 3))
            call arc_by_corner_rho(at(:, 1), at(:, 2), w/(1.0_dp + w), at(:, 3), arc, error)
            if (.not. allocated(error)) stroke = conic_stroke(arc)
        end if
    end subroutine span_stroke

    !> The poles of the span between two neighbouring breaks, with their weights.
    pure function span_poles(spline, u, v) result(pole)
        type(bspline_type), intent(in) :: spline    !! of the plane
        real(dp), intent(in) :: u                   !! where the span begins
        real(dp), intent(in) :: v                   !! where it ends
        real(dp) :: pole(3, spline%degree + 1)
        real(dp) :: row(3, spline%degree + 1), t, share
        integer :: degree, last, i, j, k

        degree = spline%degree
        last = count(spline%knot <= u)
        do k = 0, degree
            do j = 1, degree + 1
                i = last - degree - 1 + j
                row(:, j) = spline%weight(i)*[spline%pole(:2, i), 1.0_dp]
            end do
            do i = 1, degree
                t = merge(v, u, i <= k)
                do j = 1, degree + 1 - i
                    associate (low => spline%knot(last - degree + j + i - 1), &
                        high => spline%knot(last + j))
                        share = (t - low)/(high - low)
                    end associate
                    row(:, j) = (1.0_dp - share)*row(:, j) + share*row(:, j + 1)
                end do
            end do
            pole(:, k + 1) = row(:, 1)
        end do
    end function span_poles

end module geom_spline_strokes
