!> Points of a track in rows: what `point_on_track` of `cut_point` says of one is worked out for a
!> row of them at once. The figures are the same.
module cut_track_row
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use body_body, only: body_type
    use body_section_row, only: row_arcs, row_patches
    use body_skin_row, only: row_normal_curvatures, row_normals
    use body_surface_row, only: patch_row_type
    use cut_meeting_row, only: row_places
    use cut_outline, only: cut_point_type
    use cut_plane, only: cut_kind, plane_type
    use cut_point, only: point_on_track, steepest
    use cut_point_row, only: face, see
    use cut_request, only: cut_fact, request_type
    use cut_track, only: track_type
    use geom_arc_row, only: arc_row_type, place_of_row, place_row_type, row_points
    use geom_twofold_short, only: width
    implicit none (type, external)
    private

    public :: points_on_track, walk_on_track, step_type

    !> The skin at points in a row, next to the plane.
    type :: skin_row_type
        type(patch_row_type) :: patch   !! the sections
        type(place_row_type) :: place   !! where on their arcs
        real(dp) :: at(width, 2)        !! BL, WL, deck units
        real(dp) :: normal(width, 3)    !! outward unit normals
        logical :: is_sure(width)       !! nothing special about the point
    end type skin_row_type

    !> A point of a track.
    type :: step_type
        logical :: is_done = .false.    !! what follows is known; else `skin_on` of `cut_walk` is
                                        !! to say it
        real(dp) :: at(3) = 0.0_dp      !! STA, BL, WL, deck units
        real(dp) :: way(3) = 0.0_dp     !! unit tangent, aft
    end type step_type

contains

    !> The points of a track at stations, on an outline that goes aft along it. The ends of the
    !> track, and points where the skin is not smooth or the plane touches it, are worked out one by
    !> one.
    pure subroutine points_on_track(body, track, stations, request, points)
        type(body_type), intent(in) :: body                 !! finished
        type(track_type), intent(in) :: track               !! of that body and plane
        real(dp), intent(in) :: stations(:)                 !! in order, deck units
        type(request_type), intent(in) :: request           !! plane, flange, facts
        type(cut_point_type), intent(inout) :: points(:)    !! new ones, one for each station
        logical :: is_done(width)
        integer :: i, k, last

        do i = 1, size(stations), width
            last = min(i + width - 1, size(stations))
            is_done = .false.
            if (.not. any(track%lies)) &
                call row_on_track(body, track, stations(i:last), request, points(i:last), is_done)
            do k = i, last
                if (is_done(k - i + 1)) cycle
                points(k) = point_on_track(body, request%plane, track, stations(k), &
                    request%is_flange_forward)
            end do
        end do
    end subroutine points_on_track

    !> The points of a track at stations, before they are moved into the plane.
    pure subroutine walk_on_track(body, plane, track, stations, steps)
        type(body_type), intent(in) :: body             !! finished
        type(plane_type), intent(in) :: plane           !! not across STA
        type(track_type), intent(in) :: track           !! of that body and plane
        real(dp), intent(in) :: stations(:)             !! deck units
        type(step_type), intent(out) :: steps(:)        !! one for each
        type(skin_row_type) :: skin
        real(dp) :: sta(width), ways(width, 3), left(width, 3), slope(width, 2), moved(width, 3)
        integer :: i, k, last

        if (any(track%lies)) return
        do i = 1, size(stations), width
            last = min(i + width - 1, size(stations))
            sta = 0.5_dp*(track%from%sta + track%to%sta)
            sta(:last - i + 1) = stations(i:last)
            call skin_at(body, track, sta, plane, .false., skin)
            call settle(skin, plane, sta, moved)
            call tangents(skin, plane, real(track%branch, dp) &
                *body%sections(track%section)%outward, ways, left, slope)
            do k = i, last
                steps(k)%at = [stations(k), skin%at(k - i + 1, :)]
                steps(k)%way = ways(k - i + 1, :)
                steps(k)%is_done = skin%is_sure(k - i + 1)
            end do
        end do
    end subroutine walk_on_track

    !> A row of points of a track.
    pure subroutine row_on_track(body, track, stations, request, points, is_done)
        type(body_type), intent(in) :: body                 !! finished
        type(track_type), intent(in) :: track               !! of that body and plane; no edge in it
        real(dp), intent(in) :: stations(:)                 !! as many as fill a row or less
        type(request_type), intent(in) :: request           !! plane, flange, facts
        type(cut_point_type), intent(inout) :: points(:)    !! one for each station
        logical, intent(out) :: is_done(width)              !! which points are worked out
        type(skin_row_type) :: skin
        real(dp) :: sta(width), at(width, 3), way(width, 3), left(width, 3), curvature(width)
        real(dp) :: slope(width, 2)
        integer :: i

        sta = 0.5_dp*(track%from%sta + track%to%sta)
        sta(:size(stations)) = stations
        call skin_at(body, track, sta, request%plane, request%facts == cut_fact%all, skin)
        call settle(skin, request%plane, sta, at)
        call tangents(skin, request%plane, real(track%branch, dp) &
            *body%sections(track%section)%outward, way, left, slope)
        is_done = skin%is_sure
        do i = 1, size(points)
            points(i)%section = track%section
            points(i)%place = place_of_row(skin%place, i)
            points(i)%at(1) = at(i, 1)
            points(i)%at(2) = at(i, 2)
            points(i)%at(3) = at(i, 3)
            points(i)%has_slope = .true.
            points(i)%slope%is_vertical = abs(slope(i, 1)) <= ulp*abs(slope(i, 2))
            if (.not. points(i)%slope%is_vertical .and. abs(slope(i, 2)) > 0.0_dp) &
                points(i)%slope%value = slope(i, 2)/slope(i, 1)
        end do
        call see(request%plane, points)
        if (request%facts < cut_fact%bevel) return
        call face(request, skin%normal, is_done, points)
        if (request%facts < cut_fact%all) return
        call row_normal_curvatures(skin%patch, skin%at, way, left, curvature)
        do i = 1, size(points)
            points(i)%has_curvature = .true.
            points(i)%curvature = curvature(i)
        end do
    end subroutine row_on_track

    !> The skin where a track passes stations.
    pure subroutine skin_at(body, track, sta, plane, has_second, skin)
        type(body_type), intent(in) :: body             !! finished
        type(track_type), intent(in) :: track           !! of that body and plane
        real(dp), intent(in) :: sta(width)              !! deck units
        type(plane_type), intent(in) :: plane           !! not across STA
        logical, intent(in) :: has_second               !! curvatures are asked for
        type(skin_row_type), intent(out) :: skin        !! see above
        type(arc_row_type) :: arc
        real(dp) :: along(width, 2)
        logical :: is_good(width)

        associate (section => body%sections(track%section))
            call row_patches(body%lines, section, sta, has_second, skin%patch, skin%is_sure)
            call row_arcs(skin%patch, arc, is_good)
            skin%is_sure = skin%is_sure .and. is_good
            call row_places(arc, sta, plane, track%branch, skin%place, is_good)
            skin%is_sure = skin%is_sure .and. is_good
            call row_points(arc, skin%place, skin%at, along)
            call row_normals(skin%patch, skin%at, along, section%outward, skin%normal, is_good)
            skin%is_sure = skin%is_sure .and. is_good
        end associate
        skin%is_sure = skin%is_sure .and. sta > track%from%sta .and. sta < track%to%sta
    end subroutine skin_at

    !> The points moved into the plane along the skin, within their sections. Where plane and
    !> section are nearly one they are left to `point_on_track`.
    pure subroutine settle(skin, plane, sta, at)
        type(skin_row_type), intent(inout) :: skin      !! loses points that can't be moved so
        type(plane_type), intent(in) :: plane           !! not across STA
        real(dp), intent(in) :: sta(width)              !! deck units
        real(dp), intent(out) :: at(width, 3)           !! STA, BL, WL, deck units
        real(dp), dimension(width) :: along, over, height, step
        real(dp) :: n(3), length

        length = norm2(plane%normal)
        n = plane%normal/length
        along = -skin%normal(:, 3)*n(2) + skin%normal(:, 2)*n(3)
        at(:, 2) = along*(-skin%normal(:, 3))
        at(:, 3) = along*skin%normal(:, 2)
        skin%is_sure = skin%is_sure .and. sqrt(at(:, 2)**2 + at(:, 3)**2) > steepest
        over = merge(at(:, 2)*n(2) + at(:, 3)*n(3), 1.0_dp, skin%is_sure)
        height = (plane%normal(1)*(sta - plane%through(1)) &
            + plane%normal(2)*(skin%at(:, 1) - plane%through(2)) &
            + plane%normal(3)*(skin%at(:, 2) - plane%through(3)))/length
        step = height/over
        at(:, 1) = sta
        at(:, 2) = skin%at(:, 1) - step*at(:, 2)
        at(:, 3) = skin%at(:, 2) - step*at(:, 3)
        if (plane%kind == cut_kind%buttock) at(:, 2) = plane%through(2)
        if (plane%kind == cut_kind%waterline) at(:, 3) = plane%through(3)
    end subroutine settle

    !> The unit tangents of the track, aft, the unit vectors to the left of them in the plane, and
    !> the tangents as seen in it.
    pure subroutine tangents(skin, plane, sense, way, left, slope)
        type(skin_row_type), intent(in) :: skin     !! the skin; where it is sure, across the plane
        type(plane_type), intent(in) :: plane       !! not across STA
        real(dp), intent(in) :: sense               !! along normal of the skin x that of the
                                                    !! plane (1), or against it (-1)
        real(dp), intent(out) :: way(width, 3)      !! STA, BL, WL
        real(dp), intent(out) :: left(width, 3)     !! STA, BL, WL
        real(dp), intent(out) :: slope(width, 2)    !! along u and v
        real(dp) :: n(3), length(width)
        integer :: axis

        n = plane%normal/norm2(plane%normal)
        way(:, 1) = skin%normal(:, 2)*n(3) - skin%normal(:, 3)*n(2)
        way(:, 2) = skin%normal(:, 3)*n(1) - skin%normal(:, 1)*n(3)
        way(:, 3) = skin%normal(:, 1)*n(2) - skin%normal(:, 2)*n(1)
        length = sqrt(way(:, 1)**2 + way(:, 2)**2 + way(:, 3)**2)
        length = merge(length, 1.0_dp, skin%is_sure)
        do axis = 1, 3
            way(:, axis) = sense*(way(:, axis)/length)
        end do
        slope(:, 1) = plane%u(1)*way(:, 1) + plane%u(2)*way(:, 2) + plane%u(3)*way(:, 3)
        slope(:, 2) = plane%v(1)*way(:, 1) + plane%v(2)*way(:, 2) + plane%v(3)*way(:, 3)
        do axis = 1, 3
            left(:, axis) = slope(:, 1)*plane%v(axis) - slope(:, 2)*plane%u(axis)
        end do
    end subroutine tangents

end module cut_track_row
