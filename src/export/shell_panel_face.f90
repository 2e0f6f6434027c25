!> What the shells of patches and ducts have alike: a face whose four sides are those of a surface,
!> and vertices in its corners.
module export_shell_panel_face
    use base_kinds, only: dp
    use body_panel, only: panel_type
    use export_shell, only: face_type, side_type, vertex_type
    use geom_bspline_surface, only: bspline_surface_type
    implicit none (type, external)
    private

    public :: put_corners, put_face

contains

    !> Puts vertices in the corners of a surface: u = v = 0, u = 1, both, v = 1.
    pure subroutine put_corners(surface, vertices)
        type(bspline_surface_type), intent(in) :: surface   !! any
        type(vertex_type), intent(inout) :: vertices(4)     !! get their places
        associate (pole => surface%pole)
            vertices(1)%at = pole(:, 1, 1)
            vertices(2)%at = pole(:, size(pole, 2), 1)
            vertices(3)%at = pole(:, size(pole, 2), size(pole, 3))
            vertices(4)%at = pole(:, 1, size(pole, 3))
        end associate
    end subroutine put_corners

    !> Fills a face: its surface and its loop, counter-clockwise seen from outside.
    pure subroutine put_face(panel, surface, edges, points, face)
        type(panel_type), intent(in) :: panel               !! the patch or duct
        type(bspline_surface_type), intent(in) :: surface   !! of it, or of a part
        integer, intent(in) :: edges(4)                     !! v_from, u_to, v_to, u_from; or 0
        integer, intent(in) :: points(4)                    !! vertices of sides without an edge
        type(face_type), intent(inout) :: face              !! gets all
        integer :: order(4), i
        logical :: is_outward

        is_outward = panel%outward > 0.0_dp
        face%name = trim(panel%name)
        if (.not. is_outward) face%name = face%name//' PORT'
        face%section = trim(panel%name)
        face%is_port = .not. is_outward
        face%surface = surface
        face%is_outward = is_outward
        face%error = panel%error
        face%worst = panel%worst
        face%spans = size(surface%u_knot) - 2*surface%degree(1) - 1
        order = [1, 2, 3, 4]
        if (.not. is_outward) order = [1, 4, 3, 2]
        allocate (face%sides(4))
        do i = 1, 4
            face%sides(i) = side_type(edge=edges(order(i)), &
                is_forward=(order(i) <= 2) .eqv. is_outward, &
                vertex=merge(points(order(i)), 0, edges(order(i)) == 0))
        end do
    end subroutine put_face

end module export_shell_panel_face
