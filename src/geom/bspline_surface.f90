!> A rational B-spline surface in space: what CAD files carry.
!>
!> Source: L. Piegl and W. Tiller, "The NURBS Book", 2nd ed., Springer 1997, chapter 4.
module geom_bspline_surface
    use base_kinds, only: dp
    use geom_bspline, only: bspline_type
    use geom_bspline_basis, only: basis, basis_jet, span_of
    implicit none (type, external)
    private

    public :: bspline_surface_type, surface_point, surface_jet, surface_line
    public :: edge_spline, mirrored_surface

    !> The sides of a surface, in the order of a loop around it.
    type, public :: surface_side_list
        integer :: v_from = 1   !! along u, where v begins
        integer :: u_to = 2     !! along v, where u ends
        integer :: v_to = 3     !! along u, where v ends
        integer :: u_from = 4   !! along v, where u begins
    end type surface_side_list

    !> The sides by name.
    type(surface_side_list), parameter, public :: surface_side = surface_side_list()

    !> A rational B-spline surface over u and v; knots as in `geom_bspline`.
    type :: bspline_surface_type
        integer :: degree(2) = 0                !! along u, along v; 1 or more
        real(dp), allocatable :: u_knot(:)      !! not falling, shape (u poles + degree(1) + 1)
        real(dp), allocatable :: v_knot(:)      !! not falling, shape (v poles + degree(2) + 1)
        real(dp), allocatable :: pole(:, :, :)  !! STA, BL, WL, deck units: (3, u poles, v poles)
        real(dp), allocatable :: weight(:, :)   !! above zero: (u poles, v poles)
    end type bspline_surface_type

contains

    !> The point of a surface, deck units.
    pure function surface_point(f, u, v) result(point)
        type(bspline_surface_type), intent(in) :: f !! any surface
        real(dp), intent(in) :: u                   !! parameter from its start to its end
        real(dp), intent(in) :: v                   !! parameter from its start to its end
        real(dp) :: point(3)
        real(dp) :: du(3), dv(3)
        call surface_jet(f, u, v, point, du, dv)
    end function surface_point

    !> The point of a surface with its derivatives along u and v; at inner knots those of the spans
    !> that begin there. The point is worked from the pole next to it, as in `geom_bspline`.
    pure subroutine surface_jet(f, u, v, point, du, dv)
        type(bspline_surface_type), intent(in) :: f !! any surface
        real(dp), intent(in) :: u                   !! parameter from its start to its end
        real(dp), intent(in) :: v                   !! parameter from its start to its end
        real(dp), intent(out) :: point(3)           !! deck units
        real(dp), intent(out) :: du(3)              !! derivative by u
        real(dp), intent(out) :: dv(3)              !! derivative by v
        real(dp) :: along_u(f%degree(1) + 1, 0:2), along_v(f%degree(2) + 1, 0:2)
        real(dp) :: sums(3), ways(3, 3), base(3), share(3)
        integer :: first(2), nearest(2), i, j

        first(1) = span_of(f%u_knot, f%degree(1), u) - f%degree(1)
        first(2) = span_of(f%v_knot, f%degree(2), v) - f%degree(2)
        along_u = basis_jet(f%u_knot, f%degree(1), first(1) + f%degree(1), u)
        along_v = basis_jet(f%v_knot, f%degree(2), first(2) + f%degree(2), v)
        nearest = first - 1 + [maxloc(along_u(:, 0), dim=1), maxloc(along_v(:, 0), dim=1)]
        base = f%pole(:, nearest(1), nearest(2))
        sums = 0.0_dp
        ways = 0.0_dp
        do j = 1, size(along_v, 1)
            do i = 1, size(along_u, 1)
                share = f%weight(first(1) + i - 1, first(2) + j - 1)* &
                    [along_u(i, 0)*along_v(j, 0), along_u(i, 1)*along_v(j, 0), &
                    along_u(i, 0)*along_v(j, 1)]
                sums = sums + share
                ways = ways + spread(f%pole(:, first(1) + i - 1, first(2) + j - 1) - base, 2, 3)* &
                    spread(share, 1, 3)
            end do
        end do
        ways(:, 1) = ways(:, 1)/sums(1)
        point = base + ways(:, 1)
        du = (ways(:, 2) - sums(2)*ways(:, 1))/sums(1)
        dv = (ways(:, 3) - sums(3)*ways(:, 1))/sums(1)
    end subroutine surface_jet

    !> The line of a polynomial surface along u at a v, as a curve.
    pure type(bspline_type) function surface_line(f, v) result(line)
        type(bspline_surface_type), intent(in) :: f !! all its weights are 1
        real(dp), intent(in) :: v                   !! parameter from its start to its end
        real(dp) :: share(f%degree(2) + 1)
        integer :: span, first, base, j

        span = span_of(f%v_knot, f%degree(2), v)
        first = span - f%degree(2)
        share = basis(f%v_knot, f%degree(2), span, v)
        base = first - 1 + maxloc(share, dim=1)
        line = bspline_type(f%degree(1), f%u_knot, f%pole(:, :, base), f%weight(:, base))
        do j = 1, size(share)
            line%pole = line%pole + share(j)*(f%pole(:, :, first + j - 1) - f%pole(:, :, base))
        end do
    end function surface_line

    !> The edge of a surface as a curve, along growing u or v.
    pure type(bspline_type) function edge_spline(f, side) result(edge)
        type(bspline_surface_type), intent(in) :: f !! any surface
        integer, intent(in) :: side                 !! one of `surface_side%...`
        integer :: last(2)

        last = shape(f%weight)
        ! Rows stand in parentheses, or gfortran 12 takes what stands behind their first element.
        select case (side)
        case (surface_side%v_from)
            edge = bspline_type(f%degree(1), f%u_knot, f%pole(:, :, 1), f%weight(:, 1))
        case (surface_side%u_to)
            edge = bspline_type(f%degree(2), f%v_knot, (f%pole(:, last(1), :)), &
                (f%weight(last(1), :)))
        case (surface_side%v_to)
            edge = bspline_type(f%degree(1), f%u_knot, f%pole(:, :, last(2)), f%weight(:, last(2)))
        case default
            edge = bspline_type(f%degree(2), f%v_knot, (f%pole(:, 1, :)), (f%weight(1, :)))
        end select
    end function edge_spline

    !> The mirror image in BL 0, over the same u and v.
    pure type(bspline_surface_type) function mirrored_surface(f) result(other)
        type(bspline_surface_type), intent(in) :: f !! any surface
        other = f
        other%pole(2, :, :) = 0.0_dp - f%pole(2, :, :)
    end function mirrored_surface

end module geom_bspline_surface
