!> A point of a polynomial B-spline surface with its derivatives up to the second.
!>
!> Source: L. Piegl and W. Tiller, "The NURBS Book", 2nd ed., Springer 1997, 3.4.
module geom_surface_jet
    use base_kinds, only: dp
    use geom_bspline_basis, only: basis_jet, span_of
    use geom_bspline_surface, only: bspline_surface_type
    use geom_coons, only: patch_jet_type
    implicit none (type, external)
    private

    public :: second_jet

contains

    !> A point with its derivatives, worked from the pole next to it, as in `geom_bspline_surface`;
    !> at inner knots the derivatives are those of the spans that begin there.
    pure type(patch_jet_type) function second_jet(f, u, v) result(jet)
        type(bspline_surface_type), intent(in) :: f !! all its weights are 1
        real(dp), intent(in) :: u                   !! parameter from its start to its end
        real(dp), intent(in) :: v                   !! parameter from its start to its end
        real(dp) :: along_u(f%degree(1) + 1, 0:2), along_v(f%degree(2) + 1, 0:2)
        real(dp) :: row(3, 0:2), base(3)
        integer :: first(2), nearest(2), i, j

        first(1) = span_of(f%u_knot, f%degree(1), u) - f%degree(1)
        first(2) = span_of(f%v_knot, f%degree(2), v) - f%degree(2)
        along_u = basis_jet(f%u_knot, f%degree(1), first(1) + f%degree(1), u)
        along_v = basis_jet(f%v_knot, f%degree(2), first(2) + f%degree(2), v)
        nearest = first - 1 + [maxloc(along_u(:, 0), dim=1), maxloc(along_v(:, 0), dim=1)]
        base = f%pole(:, nearest(1), nearest(2))
        do j = 1, size(along_v, 1)
            row = 0.0_dp
            do i = 1, size(along_u, 1)
                row = row + spread(f%pole(:, first(1) + i - 1, first(2) + j - 1) - base, 2, 3)* &
                    spread(along_u(i, :), 1, 3)
            end do
            jet%at = jet%at + along_v(j, 0)*row(:, 0)
            jet%u = jet%u + along_v(j, 0)*row(:, 1)
            jet%v = jet%v + along_v(j, 1)*row(:, 0)
            jet%uu = jet%uu + along_v(j, 0)*row(:, 2)
            jet%uv = jet%uv + along_v(j, 1)*row(:, 1)
            jet%vv = jet%vv + along_v(j, 2)*row(:, 0)
        end do
        jet%at = base + jet%at
    end function second_jet

end module geom_surface_jet
