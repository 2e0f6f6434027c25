!> What the skin is at a point of a section: its outward normal, and the curvature of a plane cut.
module body_skin
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use body_line, only: line_type
    use body_section, only: section_arc, section_type, trace_at, trace_type
    use body_surface, only: form_along, gradient_at, patch_at, patch_type
    use body_taylor, only: taylor_type
    use base_error, only: error_type
    use geom_arc, only: arc_type
    use geom_arc_point, only: point, tangent
    use geom_place, only: is_finish, is_start, place_type
    implicit none (type, external)
    private

    public :: skin_type, skin_at, normal_curvature

    !> The skin at a point.
    type :: skin_type
        real(dp) :: at(3) = 0.0_dp          !! STA, BL, WL, deck units
        logical :: has_normal = .false.     !! not at a point nose
        real(dp) :: normal(3) = 0.0_dp      !! outward, of unit length
        logical :: is_smooth = .false.      !! the derivatives of the surface exist
        type(patch_type) :: patch           !! where smooth: the section about the station
        real(dp) :: gradient(3) = 0.0_dp    !! where smooth: of the patch's F
    end type skin_type

    !> How far inside of an end with infinite slopes it is looked which way the skin faces there.
    real(dp), parameter :: inset = 1.0e-6_dp

contains

    !> The skin at a place of a section. Where control lines that bear on the point have infinite
    !> slopes the normal is along STA; a section that is a point has a normal only where all three
    !> of its lines have.
    pure type(skin_type) function skin_at(lines, section, sta, place) result(skin)
        type(line_type), intent(in) :: lines(:)     !! of the body
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), intent(in) :: sta                 !! deck units
        type(place_type), intent(in) :: place       !! where on its arc
        type(error_type), allocatable :: error
        type(trace_type) :: trace
        type(arc_type) :: arc

        call section_arc(lines, section, sta, arc, error)
        if (allocated(error)) then
            trace = trace_at(lines, section, sta)
            skin%at = [sta, trace%start%point]
            skin%patch = patch_at(lines, section, sta, arc)
            if (all(skin%patch%is_vertical)) call face_along(lines, section, place, skin)
            return
        end if
        skin%at = [sta, point(arc, place)]
        skin%patch = patch_at(lines, section, sta, arc)
        if (any(skin%patch%is_vertical .and. bears(place))) then
            call face_along(lines, section, place, skin)
        else
            call measure(arc, place, section%outward, skin)
        end if
    end function skin_at

    !> Which of the three lines a point of a section depends on.
    pure function bears(place)
        type(place_type), intent(in) :: place !! where on the arc
        logical :: bears(3)
        bears = .true.
        if (is_start(place)) bears(2:) = .false.
        if (is_finish(place)) bears(:2) = .false.
    end function bears

    !> The normal where the surface is smooth: in the plane of the section it is across the tangent
    !> of the arc, which is exact at its ends.
    pure subroutine measure(arc, place, outward, skin)
        type(arc_type), intent(in) :: arc           !! the section there
        type(place_type), intent(in) :: place       !! where on it
        real(dp), intent(in) :: outward             !! 1: outside is to the right, -1: left
        type(skin_type), intent(inout) :: skin      !! has point and patch
        real(dp) :: along(2), out(2), steepness

        along = tangent(arc, place)
        out = outward*[along(2), -along(1)]/sqrt(along(1)**2 + along(2)**2)
        skin%gradient = gradient_at(skin%patch, skin%at(2:))
        steepness = dot_product(skin%gradient(2:), out)
        if (is_zero(steepness)) return
        skin%normal = sign(1.0_dp, steepness)*[skin%gradient(1), steepness*out]
        skin%normal = skin%normal/norm2(skin%normal)
        skin%has_normal = .true.
        skin%is_smooth = .true.
    end subroutine measure

    !> The normal where lines have infinite slopes: along STA, and on the side to which the skin
    !> faces a little inside of the range.
    pure subroutine face_along(lines, section, place, skin)
        type(line_type), intent(in) :: lines(:)     !! of the body
        type(section_type), intent(in) :: section   !! one of its sections
        type(place_type), intent(in) :: place       !! where on its arc
        type(skin_type), intent(inout) :: skin      !! has point and patch
        type(error_type), allocatable :: error
        type(skin_type) :: near
        type(arc_type) :: arc
        real(dp) :: sta

        sta = skin%at(1) + sign(inset*(section%to - section%from), &
            0.5_dp*(section%from + section%to) - skin%at(1))
        call section_arc(lines, section, sta, arc, error)
        if (allocated(error)) return
        near%at = [sta, point(arc, place)]
        near%patch = patch_at(lines, section, sta, arc)
        if (any(near%patch%is_vertical)) return
        call measure(arc, place, section%outward, near)
        skin%has_normal = near%has_normal
        skin%normal = [sign(1.0_dp, near%normal(1)), 0.0_dp, 0.0_dp]
    end subroutine face_along

    !> The curvature of the cut with a plane, along `way`, positive where it turns towards `left`.
    pure real(dp) function normal_curvature(skin, way, left) result(curvature)
        type(skin_type), intent(in) :: skin     !! smooth
        real(dp), intent(in) :: way(3)          !! unit tangent of the cut
        real(dp), intent(in) :: left(3)         !! unit vector across it, in the plane
        type(taylor_type) :: form, slope

        form = form_along(skin%patch, skin%at(2:), way)
        slope = form_along(skin%patch, skin%at(2:), left)
        curvature = -form%second/slope%first
    end function normal_curvature

end module body_skin
