!> The surface of a PATCH card as a face, an open shell of its own: it is the patch itself, a
!> B-spline surface, and shares no edge with the skin of sections.
module export_shell_patch
    use body_panel, only: panel_type
    use export_shell, only: shell_type, skin_model_type
    use export_shell_panel_face, only: put_corners, put_face
    use geom_bspline_surface, only: edge_spline, surface_side
    implicit none (type, external)
    private

    public :: shell_of_patch

    !> The sides of a surface in the order of a patch's sides, with the vertices they run between
    !> along growing u or v: vertex 1 is u = v = 0, 2 is u = 1, v = 0, 3 is u = v = 1.
    integer, parameter :: side_of(4) = [surface_side%v_from, surface_side%u_to, &
        surface_side%v_to, surface_side%u_from]
    integer, parameter :: from_of(4) = [1, 2, 4, 1], to_of(4) = [2, 3, 3, 4]

contains

    !> The shell of a patch. Its error is that of its sides; between them it is exact.
    pure subroutine shell_of_patch(panel, model)
        type(panel_type), intent(in) :: panel           !! of a body, or the image of one
        type(skin_model_type), intent(out) :: model     !! one face
        integer :: edge_of(4), i

        allocate (model%vertices(4), model%edges(count([1, 2, 3, 4] /= panel%point)), &
            model%faces(1), model%shells(1))
        call put_corners(panel%surface, model%vertices)
        edge_of = 0
        do i = 1, 4
            if (i == panel%point) cycle
            edge_of(i) = maxval(edge_of) + 1
            associate (edge => model%edges(edge_of(i)))
                edge%curve = edge_spline(panel%surface, side_of(i))
                edge%from = joined(from_of(i), panel%point)
                edge%to = joined(to_of(i), panel%point)
            end associate
        end do
        call put_face(panel, panel%surface, edge_of, from_of, model%faces(1))
        model%shells(1) = shell_type(faces=[1], is_closed=.false.)
    end subroutine shell_of_patch

    !> Both ends of a side that is a point are one vertex, the first.
    elemental integer function joined(vertex, point)
        integer, intent(in) :: vertex   !! 1 to 4
        integer, intent(in) :: point    !! the side that is a point; 0: none
        joined = vertex
        if (point > 0) then
            if (vertex == to_of(max(point, 1))) joined = from_of(max(point, 1))
        end if
    end function joined

end module export_shell_patch
