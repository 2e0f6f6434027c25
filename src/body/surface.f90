!> The surface of a section as an implicit function of space. With the lines of the section's chord
!> and of its end tangents, as products `cross` in the plane of the section,
!>
!>     Lc(p) = (p - P1) x (P3 - P1),   L1(p) = (p - P1) x t1,   L3(p) = (p - P3) x t3
!>
!> and its shoulder point S, the arc lies on
!>
!>     F(p) = Lc(p)**2 L1(S) L3(S) - L1(p) L3(p) Lc(S)**2 = 0
!>
!> (the pencil of conics of R. A. Liming, "Practical Analytic Geometry with Applications to
!> Aircraft", 1944, ch. 4). P1, S, P3, t1 and t3 change with the station, so F is a function of all
!> three coordinates; its derivatives along any way are exact (`body_taylor`), and with them the
!> normal of the skin and the curvature of any plane cut.
module body_surface
    use base_constants, only: degrees
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use body_line, only: line_type
    use body_section, only: end_slope_type, section_type
    use body_taylor, only: cross, operator(*), operator(-), taylor_type
    use geom_arc, only: arc_type
    use geom_chain, only: chain_jet
    use geom_jet, only: jet_type
    implicit none (type, external)
    private

    public :: patch_type, patch_at, form_along, gradient_at

    !> A section about a station: its five conditions and how they change along STA.
    type :: patch_type
        real(dp) :: sta = 0.0_dp            !! the station, deck units
        type(jet_type) :: point(2, 3)       !! BL, WL of the three points, deck units
        type(jet_type) :: tangent(2, 2)     !! BL, WL of start and finish tangent
        logical :: is_vertical(3) = .false. !! a line has an infinite slope there
        logical :: is_straight = .false.    !! the section is a straight line
        real(dp) :: size = 1.0_dp           !! a power of two near its length, deck units
    end type patch_type

contains

    !> A section about a station of its range.
    pure type(patch_type) function patch_at(lines, section, sta, arc) result(patch)
        type(line_type), intent(in) :: lines(:)     !! of the body
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), intent(in) :: sta                 !! deck units
        type(arc_type), intent(in) :: arc           !! the arc of the section there
        integer :: i

        patch%sta = sta
        patch%size = arc%size
        patch%is_straight = arc%is_line
        do i = 1, 3
            call line_jets(lines(section%line(i)), sta, patch%point(:, i), patch%is_vertical(i))
        end do
        do i = 1, 2
            patch%tangent(:, i) = tangent_jets(lines, section%slope(i), sta)
        end do
        if (.not. section%is_port) return
        patch%point(1, :) = mirrored(patch%point(1, :))
        patch%tangent(1, :) = mirrored(patch%tangent(1, :))
    end function patch_at

    !> An ordinate seen in a mirror.
    elemental type(jet_type) function mirrored(jet)
        type(jet_type), intent(in) :: jet !! any
        mirrored = jet_type(-jet%value, -jet%first, -jet%second)
    end function mirrored

    !> BL and WL of a line about a station.
    pure subroutine line_jets(line, sta, jets, is_vertical)
        type(line_type), intent(in) :: line         !! a control line
        real(dp), intent(in) :: sta                 !! deck units
        type(jet_type), intent(out) :: jets(2)      !! BL and WL, deck units
        logical, intent(out) :: is_vertical         !! one of the two views is
        logical :: is_vertical_plan

        is_vertical_plan = .false.
        if (line%has_plan) call chain_jet(line%plan, sta, jets(1), is_vertical_plan)
        call chain_jet(line%side, sta, jets(2), is_vertical)
        is_vertical = is_vertical .or. is_vertical_plan
    end subroutine line_jets

    !> The direction of an end slope about a station.
    pure function tangent_jets(lines, slope, sta) result(jets)
        type(line_type), intent(in) :: lines(:)     !! of the body
        type(end_slope_type), intent(in) :: slope   !! of a section
        real(dp), intent(in) :: sta                 !! deck units
        type(jet_type) :: jets(2), angle
        logical :: is_vertical
        real(dp) :: turn, bend, c, s

        jets%value = slope%direction
        if (.not. slope%is_angle) return
        call chain_jet(lines(slope%line)%angle, sta, angle, is_vertical)
        turn = angle%first/degrees
        bend = angle%second/degrees
        c = cos(angle%value/degrees)
        s = sin(angle%value/degrees)
        jets(1) = jet_type(c, -s*turn, -c*turn**2 - s*bend)
        jets(2) = jet_type(s, c*turn, -s*turn**2 + c*bend)
    end function tangent_jets

    !> F along the way `at + s*way`, s in deck units, to a scale of its own.
    pure type(taylor_type) function form_along(patch, at, way) result(form)
        type(patch_type), intent(in) :: patch   !! the section about the station of `at`
        real(dp), intent(in) :: at(2)           !! BL, WL, deck units
        real(dp), intent(in) :: way(3)          !! along STA, BL, WL
        type(taylor_type), dimension(2) :: chord, start, finish, shoulder, first, last
        type(taylor_type) :: chord_of_p, chord_of_s

        start = from_start([taylor_type(at(1), way(2)), taylor_type(at(2), way(3))])
        chord = from_start(along(patch%point(:, 3)))
        chord_of_p = cross(start, chord)
        if (patch%is_straight) then
            form = chord_of_p
            return
        end if
        shoulder = from_start(along(patch%point(:, 2)))
        finish = start - chord
        first = along(patch%tangent(:, 1))
        last = along(patch%tangent(:, 2))
        chord_of_s = cross(shoulder, chord)
        form = chord_of_p*chord_of_p*cross(shoulder, first)*cross(shoulder - chord, last) &
            - cross(start, first)*cross(finish, last)*chord_of_s*chord_of_s
    contains
        !> A jet over STA as one along the way.
        elemental type(taylor_type) function along(jet)
            type(jet_type), intent(in) :: jet !! over STA
            along = taylor_type(jet%value, jet%first*way(1), jet%second*way(1)**2)
        end function along

        !> A point as seen from the start of the section, in `size`.
        pure function from_start(point) result(seen)
            type(taylor_type), intent(in) :: point(2) !! BL, WL, deck units
            type(taylor_type) :: seen(2), unit
            unit%value = 1.0_dp/patch%size
            seen = unit*(point - along(patch%point(:, 1)))
        end function from_start
    end function form_along

    !> The gradient of F, along STA, BL and WL, to a scale of its own. Its STA part does not exist
    !> where a line has an infinite slope.
    pure function gradient_at(patch, at) result(gradient)
        type(patch_type), intent(in) :: patch   !! the section about the station of `at`
        real(dp), intent(in) :: at(2)           !! BL, WL, deck units
        real(dp) :: gradient(3), way(3)
        type(taylor_type) :: form
        integer :: axis

        do axis = 1, 3
            way = 0.0_dp
            way(axis) = 1.0_dp
            form = form_along(patch, at, way)
            gradient(axis) = form%first
        end do
        if (any(.not. is_zero(gradient))) gradient = gradient/maxval(abs(gradient))
    end function gradient_at

end module body_surface
