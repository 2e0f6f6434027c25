!> A uniform cubic B-spline as Bezier curves, one a segment, and as the B-spline of a CAD file.
!>
!> Source: seed 002, equation (1); L. Piegl and W. Tiller, "The NURBS Book", 2nd ed., 5.2 and 5.3.
module geom_fairing_curve
    use base_kinds, only: dp
    use geom_bspline, only: bspline_type
    implicit none (type, external)
    private

    public :: uniform_segments, uniform_bspline

contains

    !> The segments as Bezier curves of degree 3: neighbours share a pole.
    pure function uniform_segments(vertex, is_closed) result(pole)
        real(dp), intent(in) :: vertex(:, :)    !! deck units, shape (dimensions, vertices)
        logical, intent(in) :: is_closed        !! behind the last vertex comes the first
        real(dp), allocatable :: pole(:, :, :)  !! shape (dimensions, 4, segments)
        real(dp), allocatable :: v(:, :)
        integer :: i

        allocate (v, source=unwound(vertex, is_closed))
        allocate (pole(size(v, 1), 4, size(v, 2) - 3))
        do i = 1, size(pole, 3)
            pole(:, 1, i) = (v(:, i) + 4.0_dp*v(:, i + 1) + v(:, i + 2))/6.0_dp
            pole(:, 2, i) = (2.0_dp*v(:, i + 1) + v(:, i + 2))/3.0_dp
            pole(:, 3, i) = (v(:, i + 1) + 2.0_dp*v(:, i + 2))/3.0_dp
            pole(:, 4, i) = (v(:, i + 1) + 4.0_dp*v(:, i + 2) + v(:, i + 3))/6.0_dp
        end do
    end function uniform_segments

    !> The same curve as a B-spline from its first pole to its last, its parameter 1 a segment.
    pure type(bspline_type) function uniform_bspline(vertex, is_closed) result(spline)
        real(dp), intent(in) :: vertex(:, :)    !! deck units, shape (dimensions, vertices)
        logical, intent(in) :: is_closed        !! behind the last vertex comes the first
        real(dp), allocatable :: v(:, :), pole(:, :, :)
        integer :: i, n, last

        allocate (v, source=unwound(vertex, is_closed))
        allocate (pole, source=uniform_segments(vertex, is_closed))
        n = size(v, 2)
        last = n - 3
        spline%degree = 3
        allocate (spline%knot(n + 4))
        spline%knot = [(real(min(max(i - 4, 0), last), dp), i = 1, n + 4)]
        allocate (spline%weight(n), source=1.0_dp)
        allocate (spline%pole, source=v)
        spline%pole(:, :2) = pole(:, :2, 1)
        spline%pole(:, n - 1:) = pole(:, 3:, last)
    end function uniform_bspline

    !> The vertices of the curve, those of a closed one with its first three again behind the last.
    pure function unwound(vertex, is_closed) result(v)
        real(dp), intent(in) :: vertex(:, :)    !! shape (dimensions, vertices)
        logical, intent(in) :: is_closed        !! behind the last vertex comes the first
        real(dp), allocatable :: v(:, :)
        integer :: i, n

        n = size(vertex, 2)
        allocate (v, source=vertex(:, [(1 + modulo(i - 1, n), i = 1, n + merge(3, 0, is_closed))]))
    end function unwound

end module geom_fairing_curve
