!> Cuts of panels: the outlines of a plane on the surfaces of PATCH and DUCT cards.
!>
!> An open outline begins at its foremost end; where both are as far forward, at the one with the
!> lower BL, then WL. A closed one begins at the foremost of the points that it was found by (of a
!> duct, where many are as far forward, at the one next to its line u = 0), and runs
!> counter-clockwise in its view.
module cut_panel
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_panel, only: mirrored_panel, panel_noise, panel_reach, panel_type
    use cut_make, only: make_cut, needs_both_halves
    use cut_outline, only: cut_type, outline_type, panel_curve_type
    use cut_panel_curve, only: curve_of_walk
    use cut_panel_point, only: point_on_panel
    use cut_panel_spread, only: places_on, tracks_within
    use cut_panel_track, only: panel_track_type, panel_tracks
    use cut_panel_walk, only: last_place, point_at, turned_track, walk_type
    use cut_plane, only: height_over, true_shape
    use cut_request, only: request_type
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: cut_skin, cut_panels, panel_walks

contains

    !> Cuts the whole skin of a body: its sections and its panels.
    !>
    !> Fails with the causes of `make_cut`, unless it is that no section is there and panels are,
    !> and with those of `cut_panels`.
    pure subroutine cut_skin(body, panels, request, cut, error)
        type(body_type), intent(in) :: body                 !! finished
        type(panel_type), intent(in) :: panels(:)           !! of the body
        type(request_type), intent(in) :: request           !! what is asked
        type(cut_type), intent(out) :: cut                  !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        call make_cut(body, request, cut, error)
        call add_panels(panels, body, request, cut, error)
    end subroutine cut_skin

    !> Adds the outlines on panels to a cut of a body; where it meets a panel, or the body has
    !> nothing else, it does not matter that no section is there. An error of the cut stays, or
    !> becomes that of `cut_panels`.
    pure subroutine add_panels(panels, body, request, made, error)
        type(panel_type), intent(in) :: panels(:)                   !! of the body
        type(body_type), intent(in) :: body                         !! finished
        type(request_type), intent(in) :: request                   !! what is asked
        type(cut_type), intent(inout) :: made                       !! gets the outlines
        type(error_type), allocatable, intent(inout) :: error       !! of the cut of the sections
        type(error_type), allocatable :: trouble
        type(cut_type) :: cut

        if (size(panels) == 0) return
        if (allocated(error)) then
            if (error%cause /= cause%beyond_lines) return
            cut%plane = request%plane
            cut%name = request%name
            cut%is_flange_forward = request%is_flange_forward
            cut%arcs = request%arcs
            allocate (cut%outlines(0), cut%inside(0), cut%notes(0))
        else
            cut = made
        end if
        call cut_panels(panels, size(body%sections), body%is_symmetric, request, cut, trouble)
        if (allocated(trouble)) then
            error = trouble
        else if (.not. allocated(error) .or. size(cut%patched) > 0 .or. &
            size(body%sections) == 0) then
            made = cut
            if (allocated(error)) deallocate (error)
        end if
    end subroutine add_panels

    !> Adds the outlines of panels to a cut. Their points have the panel for a section, counted on
    !> from the sections of the body. Of a symmetric body the panels are cut as the deck has them,
    !> and their images too where the plane does not cut both halves alike.
    !>
    !> Fails with `cause%too_many` where a table is too long.
    pure subroutine cut_panels(panels, sections, is_symmetric, request, cut, error)
        type(panel_type), intent(in) :: panels(:)           !! of a body
        integer, intent(in) :: sections                     !! of the body
        logical, intent(in) :: is_symmetric                 !! so is the body
        type(request_type), intent(in) :: request           !! what is asked
        type(cut_type), intent(inout) :: cut                !! gets the outlines
        type(error_type), allocatable, intent(out) :: error !! see above
        type(walk_type), allocatable :: walks(:)
        type(outline_type) :: outline
        type(panel_curve_type) :: curve
        integer :: i, k, half

        cut%sections = sections
        cut%patches = count(.not. panels%is_round)
        if (.not. allocated(cut%patched)) allocate (cut%patched(0), cut%curves(0))
        do i = 1, size(panels)
            do half = 1, merge(2, 1, is_symmetric .and. panels(i)%has_image .and. &
                needs_both_halves(request%plane))
                if (half == 1) call panel_walks(panels(i), request, walks)
                if (half == 2) call panel_walks(mirrored_panel(panels(i)), request, walks)
                do k = 1, size(walks)
                    call spread_points(walks(k), request, sections + i, outline, error)
                    if (allocated(error)) return
                    cut%patched = [cut%patched, outline]
                    curve = curve_of_walk(walks(k))
                    curve%has_image = panels(i)%has_image
                    cut%curves = [cut%curves, curve]
                    cut%off_plane = max(cut%off_plane, off_plane(walks(k), outline))
                end do
            end do
        end do
    end subroutine cut_panels

    !> The tracks of a cut on a panel, within its limits, as they run.
    pure subroutine panel_walks(panel, request, walks)
        type(panel_type), intent(in) :: panel                   !! of a body
        type(request_type), intent(in) :: request               !! what is asked
        type(walk_type), allocatable, intent(out) :: walks(:)   !! in order of their first points
        type(panel_track_type), allocatable :: tracks(:), parts(:)
        type(walk_type) :: walk
        integer :: i, k

        allocate (walks(0))
        walk%panel = panel
        walk%plane = request%plane
        call panel_tracks(panel, request%plane, tracks)
        do i = 1, size(tracks)
            walk%track = tracks(i)
            call tracks_within(walk, request, parts)
            do k = 1, size(parts)
                walk%track = parts(k)
                call put_in_order(walk)
                walks = [walks, walk]
            end do
        end do
    end subroutine panel_walks

    !> Lets a track begin where an outline does, and run as it does.
    pure subroutine put_in_order(walk)
        type(walk_type), intent(inout) :: walk !! the track
        integer :: first, last

        associate (track => walk%track)
            last = size(track%at, 2)
            if (track%is_closed) then
                first = minloc(track%at(1, :last - 1), dim=1)
                if (walk%panel%is_round) first = minloc(track%uv(1, :last - 1), dim=1, &
                    mask=track%at(1, :last - 1) <= track%at(1, first) + panel_noise(walk%panel))
                track%uv(:, :last - 1) = cshift(track%uv(:, :last - 1), first - 1, dim=2)
                track%at(:, :last - 1) = cshift(track%at(:, :last - 1), first - 1, dim=2)
                track%uv(:, last) = track%uv(:, 1)
                track%at(:, last) = track%at(:, 1)
                if (area(walk) < 0.0_dp) track = turned_track(track)
            else if (comes_after(track%at(:, 1), track%at(:, last), panel_reach(walk%panel))) then
                track = turned_track(track)
            end if
        end associate
    end subroutine put_in_order

    !> Twice the area that a closed track runs round counter-clockwise.
    pure real(dp) function area(walk)
        type(walk_type), intent(in) :: walk !! closed
        real(dp) :: uv(2, 2)
        integer :: i
        area = 0.0_dp
        do i = 2, size(walk%track%at, 2)
            uv(:, 1) = true_shape(walk%plane, walk%track%at(:, i - 1))
            uv(:, 2) = true_shape(walk%plane, walk%track%at(:, i))
            area = area + cross(uv(:, 1), uv(:, 2))
        end do
    end function area

    !> True where a point is behind another; as far aft, more outboard; as far outboard, higher.
    pure logical function comes_after(one, other, noise)
        real(dp), intent(in) :: one(3)      !! deck units
        real(dp), intent(in) :: other(3)    !! deck units
        real(dp), intent(in) :: noise       !! by which ordinates that are one differ, deck units
        integer :: axis
        comes_after = .false.
        do axis = 1, 3
            if (abs(one(axis) - other(axis)) <= noise) cycle
            comes_after = one(axis) > other(axis)
            return
        end do
    end function comes_after

    !> The outline of a track with its points. Fails as `places_on`.
    pure subroutine spread_points(walk, request, section, outline, error)
        type(walk_type), intent(in) :: walk                 !! the track
        type(request_type), intent(in) :: request           !! how points are spread
        integer, intent(in) :: section                      !! what the points are said to be of
        type(outline_type), intent(out) :: outline          !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp), allocatable :: places(:)
        real(dp) :: next
        integer :: i, count_of

        call places_on(walk, request, places, error)
        if (allocated(error)) return
        outline%is_closed = walk%track%is_closed
        count_of = size(places)
        if (outline%is_closed) count_of = count_of - 1
        allocate (outline%pieces(0), outline%points(count_of))
        do i = 1, count_of
            next = min(places(i) + 0.01_dp, last_place(walk))
            outline%points(i) = point_on_panel(walk, places(i), &
                point_at(walk, next) - point_at(walk, next - 0.01_dp), request%is_flange_forward)
            outline%points(i)%section = section
        end do
    end subroutine spread_points

    !> The largest distance of the points of an outline, as the surface has them, from the plane.
    pure real(dp) function off_plane(walk, outline)
        type(walk_type), intent(in) :: walk             !! the track
        type(outline_type), intent(in) :: outline       !! of it
        integer :: i
        off_plane = 0.0_dp
        do i = 1, nint(last_place(walk))
            off_plane = max(off_plane, abs(height_over(walk%plane, &
                point_at(walk, real(i, dp) - 0.5_dp))))
        end do
        do i = 1, size(outline%points)
            off_plane = max(off_plane, abs(height_over(walk%plane, outline%points(i)%at)))
        end do
    end function off_plane

end module cut_panel
