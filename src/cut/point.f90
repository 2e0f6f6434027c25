!> Points of a cut with all that is said of them.
module cut_point
    use base_constants, only: degrees
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_skin, only: normal_curvature, skin_at, skin_type
    use cut_event, only: happening
    use cut_outline, only: cut_point_type
    use cut_plane, only: cut_kind, flange_normal, height_over, in_view, plane_type, true_shape
    use cut_track, only: place_on, track_type
    use geom_arc, only: arc_type
    use geom_arc_point, only: curvature, slope, slope_along
    use geom_place, only: place_type
    use geom_space, only: across
    implicit none (type, external)
    private

    public :: point_on_track, point_on_arc, tangent_of, turned_back
    public :: left_of, give_bevel, steepest

    !> Sine of the least angle between plane and skin at which points are moved along the skin.
    real(dp), parameter :: steepest = 1.0e-3_dp
    !> Sine of the angle between plane and skin up to which they touch, and rounding alone would
    !> give their intersection a direction.
    real(dp), parameter :: touching = 1.0e-10_dp

contains

    !> The point of a track at a station, on an outline that goes aft along it.
    pure type(cut_point_type) function point_on_track(body, plane, track, sta, is_forward) &
        result(point)
        type(body_type), intent(in) :: body         !! finished
        type(plane_type), intent(in) :: plane       !! not across STA
        type(track_type), intent(in) :: track       !! of that body and plane
        real(dp), intent(in) :: sta                 !! from its beginning to its end, deck units
        logical, intent(in) :: is_forward           !! the flange is on the forward side
        type(skin_type) :: skin
        real(dp) :: way(3)
        logical :: is_arc

        point%section = track%section
        call place_on(body, plane, track, sta, point%place, is_arc)
        skin = skin_at(body%lines, body%sections(track%section), sta, point%place)
        point%at = settled(skin, plane)
        if (plane%kind == cut_kind%buttock) point%at(2) = plane%through(2)
        if (plane%kind == cut_kind%waterline) point%at(3) = plane%through(3)
        point%uv = true_shape(plane, point%at)
        call face(skin, plane, is_forward, point)
        way = tangent_of(skin%normal, plane, track, body%sections(track%section)%outward)
        if (is_turn(track, sta)) way(1) = 0.0_dp
        if (all(is_zero(way))) return
        point%has_slope = .true.
        point%slope = slope_along(in_view(plane, way))
        if (.not. skin%is_smooth) return
        point%has_curvature = .true.
        point%curvature = normal_curvature(skin, way, left_of(plane, way))
    end function point_on_track

    !> The point of the skin moved into the plane along the skin: what rounding left over. It keeps
    !> its STA where the plane crosses the section.
    pure function settled(skin, plane) result(at)
        type(skin_type), intent(in) :: skin     !! at a point next to the plane
        type(plane_type), intent(in) :: plane   !! any plane
        real(dp) :: at(3), n(3), along(3)

        at = skin%at
        if (.not. skin%has_normal) return
        n = plane%normal/norm2(plane%normal)
        along = [0.0_dp, -skin%normal(3), skin%normal(2)]
        along = dot_product(along, n)*along
        if (norm2(along) <= steepest) along = n - dot_product(n, skin%normal)*skin%normal
        if (norm2(along) > steepest) &
            at = at - height_over(plane, at)/dot_product(along, n)*along
    end function settled

    !> True where a track turns back in STA: its tangent is across STA.
    pure logical function is_turn(track, sta)
        type(track_type), intent(in) :: track   !! any
        real(dp), intent(in) :: sta             !! deck units
        is_turn = (track%from%kind == happening%turn .and. .not. sta > track%from%sta) &
            .or. (track%to%kind == happening%turn .and. .not. sta < track%to%sta)
    end function is_turn

    !> The unit tangent of a track, aft; zero where there is none, as where the plane touches the
    !> skin. With N the outward normal of the skin and n that of the plane it is N x n, which goes
    !> aft where the height over the plane rises along a section whose outside is to the right.
    pure function tangent_of(normal, plane, track, outward) result(way)
        real(dp), intent(in) :: normal(3)       !! outward unit normal of the skin, or zero
        type(plane_type), intent(in) :: plane   !! not across STA
        type(track_type), intent(in) :: track   !! of that plane
        real(dp), intent(in) :: outward         !! of the section: 1 right, -1 left
        real(dp) :: way(3)

        way = across(normal, plane%normal/norm2(plane%normal))
        if (norm2(way) <= touching) then
            way = 0.0_dp
            return
        end if
        way = way/norm2(way)
        way = outward*real(track%branch, dp)*way
    end function tangent_of

    !> The unit vector in a plane to the left of a tangent, in the plane's view.
    pure function left_of(plane, way) result(left)
        type(plane_type), intent(in) :: plane   !! any plane
        real(dp), intent(in) :: way(3)          !! unit vector in it
        real(dp) :: left(3), uv(2)
        uv = in_view(plane, way)
        left = uv(1)*plane%v - uv(2)*plane%u
    end function left_of

    !> The point of a station at a place of a section's arc, on an outline that goes as the section.
    pure type(cut_point_type) function point_on_arc(body, section, arc, place, plane, is_forward) &
        result(point)
        type(body_type), intent(in) :: body         !! finished
        integer, intent(in) :: section              !! which of its sections
        type(arc_type), intent(in) :: arc           !! its arc there
        type(place_type), intent(in) :: place       !! where on it
        type(plane_type), intent(in) :: plane       !! across STA
        logical, intent(in) :: is_forward           !! the flange is on the forward side
        type(skin_type) :: skin

        skin = skin_at(body%lines, body%sections(section), plane%through(1), place)
        point%section = section
        point%place = place
        point%at = skin%at
        point%uv = true_shape(plane, point%at)
        call face(skin, plane, is_forward, point)
        point%has_slope = .true.
        point%slope = slope(arc, place)
        point%has_curvature = .true.
        point%curvature = curvature(arc, place)
    end function point_on_arc

    !> Gives a point the skin's normal, where it has one, and the bevel.
    pure subroutine face(skin, plane, is_forward, point)
        type(skin_type), intent(in) :: skin             !! at the point
        type(plane_type), intent(in) :: plane           !! any plane
        logical, intent(in) :: is_forward               !! the flange is on the forward side
        type(cut_point_type), intent(inout) :: point    !! gets them

        if (skin%has_normal) call give_bevel(skin%normal, plane, is_forward, point)
    end subroutine face

    !> Gives a point a normal and its bevel.
    pure subroutine give_bevel(normal, plane, is_forward, point)
        real(dp), intent(in) :: normal(3)               !! outward unit normal
        type(plane_type), intent(in) :: plane           !! any plane
        logical, intent(in) :: is_forward               !! the flange is on the forward side
        type(cut_point_type), intent(inout) :: point    !! gets them

        point%has_normal = .true.
        point%normal = normal
        point%bevel = bevel_of(normal, flange_normal(plane, is_forward))
    end subroutine give_bevel

    !> The bevel -asin(n . f) in degrees, without loss where it is near a right angle.
    pure real(dp) function bevel_of(n, f) result(bevel)
        real(dp), intent(in) :: n(3) !! outward unit normal of the skin
        real(dp), intent(in) :: f(3) !! unit normal of the frame on the side of its flange
        bevel = -degrees*atan2(dot_product(n, f), norm2(across(n, f)))
    end function bevel_of

    !> The same point on the outline run through backwards.
    elemental type(cut_point_type) function turned_back(point) result(back)
        type(cut_point_type), intent(in) :: point !! any
        back = point
        back%curvature = -point%curvature
    end function turned_back

end module cut_point
