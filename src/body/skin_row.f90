!> The skin at points in a row, as `body_skin` has it, where no line has an infinite slope.
module body_skin_row
    use base_kinds, only: dp
    use body_surface_row, only: patch_row_type, row_forms, row_gradients
    use body_taylor_row, only: taylor_row_type
    use geom_twofold_short, only: width
    implicit none (type, external)
    private

    public :: row_normals, row_normal_curvatures

contains

    !> The outward unit normals: in the plane of the section they are across the tangent of the
    !> arc, which is exact at its ends.
    pure subroutine row_normals(patch, at, along, outward, normal, has_normal)
        type(patch_row_type), intent(in) :: patch   !! the sections about the stations
        real(dp), intent(in) :: at(width, 2)        !! BL, WL, deck units
        real(dp), intent(in) :: along(width, 2)     !! tangents of the arcs, of any length
        real(dp), intent(in) :: outward             !! 1: outside is to the right, -1: left
        real(dp), intent(out) :: normal(width, 3)   !! STA, BL, WL; zero where there is none
        logical, intent(out) :: has_normal(width)   !! there is one
        real(dp) :: gradient(width, 3), out(2), steepness, sense, length
        integer :: i

        call row_gradients(patch, at, gradient)
        do i = 1, width
            length = max(sqrt(along(i, 1)**2 + along(i, 2)**2), tiny(1.0_dp))
            out(1) = outward*along(i, 2)/length
            out(2) = -outward*along(i, 1)/length
            steepness = gradient(i, 2)*out(1) + gradient(i, 3)*out(2)
            sense = sign(1.0_dp, steepness)
            has_normal(i) = abs(steepness) > 0.0_dp
            normal(i, 1) = sense*gradient(i, 1)
            normal(i, 2) = sense*(steepness*out(1))
            normal(i, 3) = sense*(steepness*out(2))
            length = sqrt(normal(i, 1)**2 + normal(i, 2)**2 + normal(i, 3)**2)
            length = merge(length, 1.0_dp, has_normal(i))
            sense = merge(1.0_dp, 0.0_dp, has_normal(i))
            normal(i, 1) = sense*normal(i, 1)/length
            normal(i, 2) = sense*normal(i, 2)/length
            normal(i, 3) = sense*normal(i, 3)/length
        end do
    end subroutine row_normals

    !> The curvatures of cuts with planes, along `way`, positive where they turn towards `left`.
    pure subroutine row_normal_curvatures(patch, at, way, left, curvature)
        type(patch_row_type), intent(in) :: patch   !! the sections about the stations
        real(dp), intent(in) :: at(width, 2)        !! BL, WL, deck units
        real(dp), intent(in) :: way(width, 3)       !! unit tangents of the cuts
        real(dp), intent(in) :: left(width, 3)      !! unit vectors across them, in the planes
        real(dp), intent(out) :: curvature(width)   !! 1/deck unit; zero where there is none
        type(taylor_row_type) :: form, slope
        integer :: i

        call row_forms(patch, at, way, form)
        call row_forms(patch, at, left, slope)
        do i = 1, width
            curvature(i) = -form%second(i) &
                /merge(slope%first(i), huge(1.0_dp), abs(slope%first(i)) > 0.0_dp)
        end do
    end subroutine row_normal_curvatures

end module body_skin_row
