!> Points of a cut in rows: what `cut_point` says of one is worked out for a row of them at once.
!> The figures are the same.
module cut_point_row
    use base_constants, only: degrees
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use body_body, only: body_type
    use body_skin_row, only: row_normals
    use body_surface, only: patch_at, patch_type
    use body_surface_row, only: patch_row_type, repeated_patch
    use cut_outline, only: cut_point_type
    use cut_plane, only: flange_normal, plane_type
    use cut_point, only: point_on_arc
    use cut_request, only: cut_fact, request_type
    use geom_arc, only: arc_type
    use geom_arc_row, only: arc_row_type, place_row, place_row_type, repeated_arc, &
        row_curvatures, row_points
    use geom_place, only: place_type
    use geom_twofold_short, only: width
    implicit none (type, external)
    private

    public :: points_on_arc, see, face

contains

    !> The points of a station at places of a section's arc, on an outline that goes as the section.
    !> Where a control line has an infinite slope they are worked out one by one.
    pure subroutine points_on_arc(body, section, arc, places, request, points)
        type(body_type), intent(in) :: body             !! finished
        integer, intent(in) :: section                  !! which of its sections
        type(arc_type), intent(in) :: arc               !! its arc there
        type(place_type), intent(in) :: places(:)       !! where on it
        type(request_type), intent(in) :: request       !! plane across STA, flange, facts
        type(cut_point_type), intent(inout) :: points(:) !! new ones, one for each place
        type(patch_type) :: patch
        type(arc_row_type) :: arcs
        type(patch_row_type) :: patches
        integer :: i, last

        if (request%facts > cut_fact%slope) then
            patch = patch_at(body%lines, body%sections(section), request%plane%through(1), arc)
            call repeated_patch(patch, patches)
        end if
        points%section = section
        if (any(patch%is_vertical)) then
            do i = 1, size(places)
                points(i) = point_on_arc(body, section, arc, places(i), request%plane, &
                    request%is_flange_forward)
            end do
            return
        end if
        call repeated_arc(arc, arcs)
        do i = 1, size(places), width
            last = min(i + width - 1, size(places))
            call row_on_arc(arcs, places(i:last), patches, body%sections(section)%outward, &
                request, points(i:last))
        end do
    end subroutine points_on_arc

    !> A row of points of a station.
    pure subroutine row_on_arc(arc, places, patch, outward, request, points)
        type(arc_row_type), intent(in) :: arc           !! the section's arc
        type(place_type), intent(in) :: places(:)       !! where on it, a row or less
        type(patch_row_type), intent(in) :: patch       !! the section about the station
        real(dp), intent(in) :: outward                 !! of the section
        type(request_type), intent(in) :: request       !! plane across STA, flange, facts
        type(cut_point_type), intent(inout) :: points(:) !! one for each place
        type(place_row_type) :: place
        real(dp) :: at(width, 2), along(width, 2), normal(width, 3), curvature(width)
        logical :: has_normal(width)
        integer :: i

        call place_row(places, place)
        call row_points(arc, place, at, along)
        do i = 1, size(places)
            points(i)%place = places(i)
            points(i)%at = [request%plane%through(1), at(i, 1), at(i, 2)]
            points(i)%has_slope = .true.
            points(i)%slope%is_vertical = abs(along(i, 1)) <= ulp*abs(along(i, 2))
            if (.not. points(i)%slope%is_vertical .and. abs(along(i, 2)) > 0.0_dp) &
                points(i)%slope%value = along(i, 2)/along(i, 1)
        end do
        call see(request%plane, points)
        if (request%facts < cut_fact%bevel) return
        call row_normals(patch, at, along, outward, normal, has_normal)
        call face(request, normal, has_normal, points)
        if (request%facts < cut_fact%all) return
        call row_curvatures(arc, place, curvature)
        do i = 1, size(places)
            points(i)%has_curvature = .true.
            points(i)%curvature = curvature(i)
        end do
    end subroutine row_on_arc

    !> Gives points their true-shape coordinates.
    pure subroutine see(plane, points)
        type(plane_type), intent(in) :: plane               !! in which they lie
        type(cut_point_type), intent(inout) :: points(:)    !! gets them
        real(dp) :: way(3)
        integer :: i

        do i = 1, size(points)
            way = points(i)%at - plane%origin
            points(i)%uv(1) = plane%u(1)*way(1) + plane%u(2)*way(2) + plane%u(3)*way(3)
            points(i)%uv(2) = plane%v(1)*way(1) + plane%v(2)*way(2) + plane%v(3)*way(3)
        end do
    end subroutine see

    !> Gives points their normals, where they have one, and the bevels.
    pure subroutine face(request, normal, has_normal, points)
        type(request_type), intent(in) :: request           !! plane and flange
        real(dp), intent(in) :: normal(width, 3)            !! outward unit normals
        logical, intent(in) :: has_normal(width)            !! there is one
        type(cut_point_type), intent(inout) :: points(:)    !! gets them
        real(dp) :: f(3), over(width), beside(width)
        integer :: i

        f = flange_normal(request%plane, request%is_flange_forward)
        over = normal(:, 1)*f(1) + normal(:, 2)*f(2) + normal(:, 3)*f(3)
        beside = sqrt((normal(:, 2)*f(3) - normal(:, 3)*f(2))**2 &
            + (normal(:, 3)*f(1) - normal(:, 1)*f(3))**2 &
            + (normal(:, 1)*f(2) - normal(:, 2)*f(1))**2)
        do i = 1, size(points)
            if (.not. has_normal(i)) cycle
            points(i)%has_normal = .true.
            points(i)%normal(1) = normal(i, 1)
            points(i)%normal(2) = normal(i, 2)
            points(i)%normal(3) = normal(i, 3)
            points(i)%bevel = -degrees*atan2(over(i), beside(i))
        end do
    end subroutine face

end module cut_point_row
