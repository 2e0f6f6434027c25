!> How finely a panel is divided for a mesh: columns along u and rows along v, in even steps, so
!> that flat triangles keep a tolerance and do not turn too far from one to the next.
!>
!> A chord over a step h of u is h**2 |Suu.n|/8 from the surface, and so along v; the diagonal has
!> both and the twist. Each gets a third of the tolerance.
module export_mesh_grid
    use base_constants, only: degrees
    use base_kinds, only: dp
    use body_panel, only: panel_type
    use geom_coons, only: patch_jet_type
    use geom_space, only: across, angle_between
    use geom_surface_jet, only: second_jet
    implicit none (type, external)
    private

    public :: grid_cells, panel_place_normal

    !> Places each way, less one, where the surface is looked at.
    integer, parameter :: looks = 32
    !> Cells each way at least and at most.
    integer, parameter :: fewest = 2, most = 1000
    !> Where tangents span less than this of the square on the longer one there is no normal.
    real(dp), parameter :: no_area = 1.0e-9_dp

contains

    !> The cells along u and v for a tolerance and an angle.
    pure function grid_cells(panel, tolerance, angle) result(cells)
        type(panel_type), intent(in) :: panel   !! any
        real(dp), intent(in) :: tolerance       !! deck units, above zero
        real(dp), intent(in) :: angle           !! degrees, above zero
        integer :: cells(2)
        real(dp) :: bend(3), turn(2), part
        integer :: steps(2), k

        call look(panel, bend, turn)
        part = tolerance/3.0_dp
        do k = 1, 2
            steps(k) = nint(min(real(most, dp), max(sqrt(bend(k)/(8.0_dp*part)), &
                turn(k)*degrees/angle)) + 0.5_dp)
        end do
        cells = min(max(steps, fewest), most)
        ! The twist bends diagonals: h k |Suv.n|/4.
        do while (bend(3)/(4.0_dp*real(cells(1), dp)*real(cells(2), dp)) > part .and. &
            any(cells < most))
            cells = min(cells + max(cells/8, 1), most)
        end do
    end function grid_cells

    !> How the surface bends: largest parts of second derivatives along the normal, by u, by v, by
    !> both; and how far the normal turns along u and along v, radians, at most.
    pure subroutine look(panel, bend, turn)
        type(panel_type), intent(in) :: panel   !! any
        real(dp), intent(out) :: bend(3)        !! deck units
        real(dp), intent(out) :: turn(2)        !! see above
        type(patch_jet_type) :: jet
        real(dp) :: normal(3, 0:looks, 0:looks)
        integer :: i, j

        bend = 0.0_dp
        do j = 0, looks
            do i = 0, looks
                jet = second_jet(panel%surface, real(i, dp)/real(looks, dp), &
                    real(j, dp)/real(looks, dp))
                normal(:, i, j) = normal_of(panel, jet)
                if (norm2(normal(:, i, j)) > 0.0_dp) bend = max(bend, abs([ &
                    dot_product(jet%uu, normal(:, i, j)), dot_product(jet%vv, normal(:, i, j)), &
                    dot_product(jet%uv, normal(:, i, j))]))
            end do
        end do
        turn = 0.0_dp
        do j = 0, looks - 1
            do i = 0, looks - 1
                turn(1) = max(turn(1), angle_between(normal(:, i, j), normal(:, i + 1, j)))
                turn(2) = max(turn(2), angle_between(normal(:, i, j), normal(:, i, j + 1)))
            end do
        end do
        turn = turn*real(looks, dp)
    end subroutine look

    !> The outward unit normal; zero where there is none.
    pure function normal_of(panel, jet) result(normal)
        type(panel_type), intent(in) :: panel       !! any
        type(patch_jet_type), intent(in) :: jet     !! of its surface
        real(dp) :: normal(3)
        normal = across(jet%u, jet%v)
        if (norm2(normal) > no_area*max(dot_product(jet%u, jet%u), dot_product(jet%v, jet%v))) then
            normal = panel%outward*normal/norm2(normal)
        else
            normal = 0.0_dp
        end if
    end function normal_of

    !> A point of a panel and its outward unit normal, which next to a side that is a point is that
    !> a little inside.
    pure subroutine panel_place_normal(panel, uv, at, normal)
        type(panel_type), intent(in) :: panel   !! any
        real(dp), intent(in) :: uv(2)           !! 0 to 1
        real(dp), intent(out) :: at(3)          !! deck units
        real(dp), intent(out) :: normal(3)      !! see above
        type(patch_jet_type) :: jet
        real(dp), parameter :: inset = 1.0e-6_dp

        jet = second_jet(panel%surface, uv(1), uv(2))
        at = jet%at
        normal = normal_of(panel, jet)
        if (norm2(normal) > 0.0_dp) return
        jet = second_jet(panel%surface, uv(1) + inset*(0.5_dp - uv(1)), &
            uv(2) + inset*(0.5_dp - uv(2)))
        normal = across(jet%u, jet%v)
        if (norm2(normal) > 0.0_dp) normal = panel%outward*normal/norm2(normal)
    end subroutine panel_place_normal

end module export_mesh_grid
