!> A B-spline in a plane as a curve that circular arcs can follow.
module geom_plane_spline
    use base_kinds, only: dp
    use geom_bspline, only: bspline_type, spline_from, spline_jet, spline_to
    use geom_plane_curve, only: plane_curve_type
    implicit none (type, external)
    private

    public :: plane_spline_type

    !> A spline of two dimensions, smooth and nowhere standing still.
    type, extends(plane_curve_type) :: plane_spline_type
        type(bspline_type) :: spline !! deck units
    contains
        procedure :: jet => jet_of_spline
    end type plane_spline_type

contains

    !> The point of a spline and its first two derivatives.
    pure subroutine jet_of_spline(f, t, point, first, second)
        class(plane_spline_type), intent(in) :: f   !! the spline
        real(dp), intent(in) :: t                   !! 0 to 1, whatever its knots are
        real(dp), intent(out) :: point(2)           !! deck units
        real(dp), intent(out) :: first(2)           !! first derivative by t
        real(dp), intent(out) :: second(2)          !! second derivative by t
        real(dp) :: from, length

        from = spline_from(f%spline)
        length = spline_to(f%spline) - from
        call spline_jet(f%spline, from + t*length, point, first, second)
        first = length*first
        second = length*length*second
    end subroutine jet_of_spline

end module geom_plane_spline
