!> A rational B-spline curve of any degree, in a plane or in space: what CAD files carry. A conic
!> arc is one exactly; other curves of LOFT are fitted by them.
!>
!> Source: L. Piegl and W. Tiller, "The NURBS Book", 2nd ed., Springer 1997.
module geom_bspline
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: bspline_type

    !> A rational B-spline curve from knot(1) to knot(size(knot)). The first and the last knot stand
    !> degree + 1 times, so that the curve goes from its first pole to its last; inner ones at most
    !> degree times. All weights are above zero; all are 1 where the curve is a polynomial one.
    type :: bspline_type
        integer :: degree = 0                   !! 1 or more
        real(dp), allocatable :: knot(:)        !! not falling, shape (poles + degree + 1)
        real(dp), allocatable :: pole(:, :)     !! control points, deck units: (dimensions, poles)
        real(dp), allocatable :: weight(:)      !! shape (poles)
    end type bspline_type

end module geom_bspline
