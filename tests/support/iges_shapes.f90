!> Small drawings and skins made by hand, for tests of IGES files.
module support_iges_shapes
    use base_error, only: error_type
    use base_kinds, only: dp
    use cut_plane, only: in_space, oblique_plane, plane_type
    use export_drawing, only: curve_type, shape_kind, shape_type
    use export_shell, only: skin_model_type
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_arc_spline, only: arc_spline, line_spline
    use geom_bspline, only: mapped_spline
    use geom_bspline_surface, only: edge_spline, surface_side
    implicit none (type, external)
    private

    public :: arc_of_rho, curve_of, oblique, oblique_shape, box_lid

contains

    !> An arc from (4, 1) to (9, 6) with corner (4, 6) and some rho.
    type(arc_type) function arc_of_rho(rho) result(arc)
        real(dp), intent(in) :: rho !! 0 to 1
        type(error_type), allocatable :: error
        real(dp), parameter :: p(2) = [4.0_dp, 1.0_dp], q(2) = [9.0_dp, 6.0_dp]
        real(dp), parameter :: corner(2) = [4.0_dp, 6.0_dp]
        call arc_through(end_type(p, corner - p), 0.5_dp*(1.0_dp - rho)*(p + q) + rho*corner, &
            end_type(q, q - corner), arc, error)
    end function arc_of_rho

    !> An arc of a plane as a curve of a drawing.
    type(curve_type) function curve_of(arc, plane) result(curve)
        type(arc_type), intent(in) :: arc       !! in u and v
        type(plane_type), intent(in) :: plane   !! any
        real(dp) :: axes(3, 2)

        axes(:, 1) = plane%u
        axes(:, 2) = plane%v
        call mapped_spline(arc_spline(arc), axes, plane%origin, curve%spline)
        curve%section = 'UPPER'
        curve%is_exact = .true.
        curve%is_conic = .true.
        curve%arc = arc
    end function curve_of

    !> The plane through STA 3, WL 1 and STA 7, WL 9.
    type(plane_type) function oblique() result(plane)
        type(error_type), allocatable :: error
        call oblique_plane([3.0_dp, 1.0_dp], [7.0_dp, 9.0_dp], plane, error)
    end function oblique

    !> A cut of it: an arc, a straight line, a fitted curve; and a point.
    type(shape_type) function oblique_shape(rho) result(shape)
        real(dp), intent(in) :: rho !! of the arc
        integer :: i

        shape%name = 'OBL_1'
        shape%title = 'OBLIQUE 1'
        shape%kind = shape_kind%oblique
        shape%number = 12
        shape%plane = oblique()
        allocate (shape%contours(2))
        allocate (shape%contours(1)%curves(3), shape%contours(2)%curves(0))
        shape%contours(2)%at = [3.0_dp, 0.0_dp, 1.0_dp]
        associate (curves => shape%contours(1)%curves)
            curves(1) = curve_of(arc_of_rho(rho), shape%plane)
            curves(2)%spline = line_spline(in_space(shape%plane, [9.0_dp, 6.0_dp]), &
                in_space(shape%plane, [12.0_dp, 6.0_dp]))
            curves(2)%is_exact = .true.
            curves(3)%spline%degree = 3
            curves(3)%spline%knot = [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
            curves(3)%spline%weight = [1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
            allocate (curves(3)%spline%pole(3, 4))
            do i = 1, 4
                curves(3)%spline%pole(:, i) = in_space(shape%plane, [12.0_dp + real(i, dp), &
                    6.0_dp + real(mod(i, 3), dp)])
            end do
            curves(3)%error = 2.0e-4_dp
            curves(3)%worst = [5.0_dp, 13.0_dp, 6.0_dp]
        end associate
    end function oblique_shape

    !> A quarter of a cylinder from STA 0 to 10, radius 2, whose normal points inward, and a flat
    !> cap at STA 0 between its rib and two straight edges.
    type(skin_model_type) function box_lid() result(model)
        integer :: i

        allocate (model%faces(2), model%edges(3), model%vertices(3), model%shells(1))
        model%vertices(1)%at = [0.0_dp, 2.0_dp, 0.0_dp]
        model%vertices(2)%at = [0.0_dp, 0.0_dp, 2.0_dp]
        model%vertices(3)%at = 0.0_dp
        associate (round => model%faces(1), flat => model%faces(2))
            round%name = 'UPPER STA 0 TO 10'
            round%section = 'UPPER'
            round%surface%degree = [1, 2]
            round%surface%u_knot = [0.0_dp, 0.0_dp, 10.0_dp, 10.0_dp]
            round%surface%v_knot = [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
            allocate (round%surface%pole(3, 2, 3), round%surface%weight(2, 3))
            do i = 1, 2
                round%surface%pole(:, i, 1) = [10.0_dp*real(i - 1, dp), 2.0_dp, 0.0_dp]
                round%surface%pole(:, i, 2) = [10.0_dp*real(i - 1, dp), 2.0_dp, 2.0_dp]
                round%surface%pole(:, i, 3) = [10.0_dp*real(i - 1, dp), 0.0_dp, 2.0_dp]
                round%surface%weight(i, :) = [1.0_dp, sqrt(0.5_dp), 1.0_dp]
            end do
            round%is_outward = .false.
            round%spans = 1
            round%error = 3.0e-4_dp
            round%worst = [5.0_dp, 1.0_dp, 1.5_dp]
            model%edges(1)%curve = edge_spline(round%surface, surface_side%u_from)
            model%edges(2)%curve = line_spline([0.0_dp, 0.0_dp, 2.0_dp], [0.0_dp, 0.0_dp, 0.0_dp])
            model%edges(3)%curve = line_spline([0.0_dp, 2.0_dp, 0.0_dp], [0.0_dp, 0.0_dp, 0.0_dp])
            flat%name = 'CAP STA 0'
            flat%section = ''
            flat%is_flat = .true.
            flat%is_exact = .true.
            flat%origin = [0.0_dp, 1.0_dp, 1.0_dp]
            flat%normal = [-1.0_dp, 0.0_dp, 0.0_dp]
            allocate (flat%sides(4))
            flat%sides%edge = [1, 3, 0, 2]
            flat%sides%is_forward = [.false., .true., .true., .false.]
            flat%sides%vertex = [0, 0, 3, 0]
        end associate
    end function box_lid

end module support_iges_shapes
