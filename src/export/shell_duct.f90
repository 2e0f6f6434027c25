!> The surface of a DUCT card as two faces, an open shell of its own: it is the duct itself, a
!> B-spline surface, parted along its first points and half way round, so that no face meets itself.
module export_shell_duct
    use base_kinds, only: dp
    use body_panel, only: panel_type
    use export_shell, only: shell_type, skin_model_type
    use export_shell_panel_face, only: put_corners, put_face
    use geom_bspline_surface, only: bspline_surface_type, edge_spline, surface_side
    use geom_surface_split, only: split_surface
    implicit none (type, external)
    private

    public :: shell_of_duct

    !> Vertices are 1 and 2 at the fore end, 3 and 4 at the aft end, 1 and 4 where u is 0. Edges: 1
    !> and 2 around the fore end, 3 and 4 around the aft end, 5 along u = 0, 6 along the middle.
    integer, parameter :: from_of(6) = [1, 2, 4, 3, 1, 2], to_of(6) = [2, 1, 3, 4, 4, 3]
    !> The edges of each half: v_from, u_to, v_to, u_from.
    integer, parameter :: edges_of(4, 2) = reshape([1, 6, 3, 5, 2, 5, 4, 6], [4, 2])

contains

    !> The shell of a duct.
    pure subroutine shell_of_duct(panel, model)
        type(panel_type), intent(in) :: panel           !! of a body, or the image of one
        type(skin_model_type), intent(out) :: model     !! two faces
        type(bspline_surface_type) :: half(2)
        integer :: i

        call split_surface(panel%surface, middle_knot(panel%surface), half(1), half(2))
        allocate (model%vertices(4), model%edges(6), model%faces(2), model%shells(1))
        call put_corners(half(1), model%vertices)
        do i = 1, 2
            model%edges(i)%curve = edge_spline(half(i), surface_side%v_from)
            model%edges(2 + i)%curve = edge_spline(half(i), surface_side%v_to)
        end do
        model%edges(5)%curve = edge_spline(half(1), surface_side%u_from)
        model%edges(6)%curve = edge_spline(half(1), surface_side%u_to)
        model%edges%from = from_of
        model%edges%to = to_of
        do i = 1, 2
            call put_face(panel, half(i), edges_of(:, i), [0, 0, 0, 0], model%faces(i))
            model%faces(i)%is_exact = .true.
        end do
        model%shells(1) = shell_type(faces=[1, 2], is_closed=.false.)
    end subroutine shell_of_duct

    !> The knot half way round, or the one before.
    pure real(dp) function middle_knot(surface) result(knot)
        type(bspline_surface_type), intent(in) :: surface !! of a duct
        knot = surface%u_knot(surface%degree(1) + 1 + &
            (size(surface%u_knot) - 2*surface%degree(1) - 1)/2)
    end function middle_knot

end module export_shell_duct
