!> Flat faces of an IGES file: 144 trimmed surface, a rectangle of the plane (128) within its
!> boundary (142), which is given in space and over the rectangle's parameters, both as composite
!> curves (102) of B-splines (126). IGES 5.3, 4.3, 4.31, 4.33.
module export_iges_cap
    use base_kinds, only: dp
    use export_iges_curve, only: add_spline, name_with
    use export_iges_file, only: entry_type, iges_file_type, iges_status
    use export_iges_record, only: record_type
    use export_iges_surface, only: add_surface
    use export_shell, only: face_type, skin_model_type
    use geom_bspline, only: bspline_type, mapped_spline, reversed_spline
    use geom_bspline_surface, only: bspline_surface_type
    implicit none (type, external)
    private

    public :: add_cap

    !> The normal of the parameter plane.
    real(dp), parameter :: upright(3) = [0.0_dp, 0.0_dp, 1.0_dp]

contains

    !> Adds a flat face; its normal points out of the body.
    subroutine add_cap(file, entry, model, face, name, pointer)
        type(iges_file_type), intent(inout) :: file     !! gets it
        type(entry_type), intent(in) :: entry           !! for the directory
        type(skin_model_type), intent(in) :: model      !! has its edges
        type(face_type), intent(in) :: face             !! flat
        integer, intent(in) :: name                     !! pointer to its name; 0: none
        integer, intent(out) :: pointer                 !! to the entity
        type(bspline_type), dimension(count(face%sides%edge > 0)) :: in_space, in_plane
        type(record_type) :: record
        type(entry_type) :: part
        integer :: plane, boundary, above, over

        call boundary_of(model, face, in_space, in_plane)
        part = entry
        part%status = iges_status%part
        call add_surface(file, part, rectangle_of(face, in_plane), 0, plane)
        call add_composite(file, part, in_space, face%normal, above)
        part%status = iges_status%parametric
        call add_composite(file, part, in_plane, upright, over)
        call record%whole(142)
        call record%whole(0)
        call record%whole(plane)
        call record%whole(over)
        call record%whole(above)
        call record%whole(3)
        part%status = iges_status%part
        call file%add(142, part, record, boundary)
        call add_trimmed(file, entry, [plane, boundary], name, pointer)
    end subroutine add_cap

    !> Adds a surface within a boundary, which is not the surface's own, without holes.
    subroutine add_trimmed(file, entry, parts, name, pointer)
        type(iges_file_type), intent(inout) :: file     !! gets it
        type(entry_type), intent(in) :: entry           !! for the directory
        integer, intent(in) :: parts(2)                 !! pointers to surface and boundary
        integer, intent(in) :: name                     !! pointer to its name; 0: none
        integer, intent(out) :: pointer                 !! to the entity
        type(record_type) :: record

        call record%whole(144)
        call record%whole(parts(1))
        call record%whole(1)
        call record%whole(0)
        call record%whole(parts(2))
        call name_with(record, name)
        call file%add(144, entry, record, pointer)
    end subroutine add_trimmed

    !> Adds curves end to end as one.
    subroutine add_composite(file, entry, splines, normal, pointer)
        type(iges_file_type), intent(inout) :: file     !! gets it
        type(entry_type), intent(in) :: entry           !! for the directory
        type(bspline_type), intent(in) :: splines(:)    !! in order, in three dimensions
        real(dp), intent(in) :: normal(3)               !! of their plane
        integer, intent(out) :: pointer                 !! to the entity
        type(record_type) :: record
        integer :: i, curve

        call record%whole(102)
        call record%whole(size(splines))
        do i = 1, size(splines)
            call add_spline(file, entry, splines(i), normal, 0, curve)
            call record%whole(curve)
        end do
        call file%add(102, entry, record, pointer)
    end subroutine add_composite

    !> The boundary of a flat face, counter-clockwise seen from outside.
    pure subroutine boundary_of(model, face, in_space, in_plane)
        type(skin_model_type), intent(in) :: model      !! has its edges
        type(face_type), intent(in) :: face             !! flat
        type(bspline_type), intent(out) :: in_space(:)  !! STA, BL, WL; for each side with an edge
        type(bspline_type), intent(out) :: in_plane(:)  !! along the axes, and zero
        real(dp) :: axes(3, 3)
        integer :: i, met

        axes = 0.0_dp
        axes(:2, :) = transpose(axes_of(face%normal))
        met = 0
        do i = 1, size(face%sides)
            if (face%sides(i)%edge == 0) cycle
            met = met + 1
            in_space(met) = model%edges(face%sides(i)%edge)%curve
            if (.not. face%sides(i)%is_forward) in_space(met) = reversed_spline(in_space(met))
            call mapped_spline(in_space(met), axes, -matmul(axes, face%origin), in_plane(met))
        end do
    end subroutine boundary_of

    !> Two unit vectors at right angles in a plane; the normal is to their left.
    pure function axes_of(normal) result(axes)
        real(dp), intent(in) :: normal(3)   !! unit vector
        real(dp) :: axes(3, 2)
        integer :: axis

        axis = minloc(abs(normal), dim=1)
        axes(:, 1) = -normal(axis)*normal
        axes(axis, 1) = axes(axis, 1) + 1.0_dp
        axes(:, 1) = axes(:, 1)/norm2(axes(:, 1))
        axes(:, 2) = [normal(2)*axes(3, 1) - normal(3)*axes(2, 1), &
            normal(3)*axes(1, 1) - normal(1)*axes(3, 1), &
            normal(1)*axes(2, 1) - normal(2)*axes(1, 1)]
    end function axes_of

    !> The rectangle of a plane around a boundary; its parameters are lengths along the axes.
    pure type(bspline_surface_type) function rectangle_of(face, in_plane) result(surface)
        type(face_type), intent(in) :: face             !! flat
        type(bspline_type), intent(in) :: in_plane(:)   !! its boundary
        real(dp) :: low(2), high(2), axes(3, 2)
        integer :: i, j

        low = in_plane(1)%pole(:2, 1)
        high = low
        do i = 1, size(in_plane)
            low = min(low, minval(in_plane(i)%pole(:2, :), dim=2))
            high = max(high, maxval(in_plane(i)%pole(:2, :), dim=2))
        end do
        axes = axes_of(face%normal)
        surface%degree = 1
        allocate (surface%u_knot(4), surface%v_knot(4), surface%pole(3, 2, 2))
        allocate (surface%weight(2, 2), source=1.0_dp)
        surface%u_knot = [low(1), low(1), high(1), high(1)]
        surface%v_knot = [low(2), low(2), high(2), high(2)]
        do j = 1, 2
            do i = 1, 2
                surface%pole(:, i, j) = face%origin + surface%u_knot(2*i)*axes(:, 1) + &
                    surface%v_knot(2*j)*axes(:, 2)
            end do
        end do
    end function rectangle_of

end module export_iges_cap
