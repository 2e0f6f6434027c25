!> A rational B-spline surface in space: what CAD files carry.
!>
!> Source: L. Piegl and W. Tiller, "The NURBS Book", 2nd ed., Springer 1997, chapter 4.
module geom_bspline_surface
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: bspline_surface_type

    !> A rational B-spline surface over u and v; knots as in `geom_bspline`.
    type :: bspline_surface_type
        integer :: degree(2) = 0                !! along u, along v; 1 or more
        real(dp), allocatable :: u_knot(:)      !! not falling, shape (u poles + degree(1) + 1)
        real(dp), allocatable :: v_knot(:)      !! not falling, shape (v poles + degree(2) + 1)
        real(dp), allocatable :: pole(:, :, :)  !! STA, BL, WL, deck units: (3, u poles, v poles)
        real(dp), allocatable :: weight(:, :)   !! above zero: (u poles, v poles)
    end type bspline_surface_type

end module geom_bspline_surface
