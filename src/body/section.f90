!> A section of a body: at each station of its range one conic arc in the plane of BL and WL, from
!> its start line through its shoulder line to its finish line, with two end slopes.
module body_section
    use base_constants, only: degrees
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use body_line, only: line_point, line_type
    use deck_job, only: name_length
    use geom_arc, only: arc_through, arc_type, line_between
    use geom_chain, only: chain_joints, chain_value
    use geom_triangle, only: end_type, is_flat, new_triangle, rounding
    implicit none (type, external)
    private

    public :: section_type, end_slope_type, trace_type, limit_section
    public :: trace_at, section_arc, is_point, section_joints

    !> The direction of a section at one of its ends.
    type :: end_slope_type
        logical :: is_angle = .false.                       !! it is the angle of a line
        integer :: line = 0                                 !! that line, in the body's list
        real(dp) :: direction(2) = [1.0_dp, 0.0_dp]         !! else (BL, WL), either way, not zero
    end type end_slope_type

    !> A section. Port sections are mirror images in BL 0 of what their lines and slopes say.
    type :: section_type
        character(name_length) :: name = ''     !! its name
        integer :: line(3) = 0                  !! start, shoulder, finish line, in the body's list
        type(end_slope_type) :: slope(2)        !! at the start and at the finish
        real(dp) :: from = 0.0_dp               !! least station, deck units
        real(dp) :: to = 0.0_dp                 !! greatest station, deck units
        logical :: is_port = .false.            !! mirrored
        real(dp) :: outward = 1.0_dp            !! outside is to the right (1) or left (-1) of the
                                                !! way from start to finish; `body_body` finds it
    end type section_type

    !> The five conditions of a section at a station, in BL and WL, deck units.
    type :: trace_type
        type(end_type) :: start         !! point and tangent
        real(dp) :: shoulder(2) = 0.0_dp !! shoulder point
        type(end_type) :: finish        !! point and tangent
    end type trace_type

    !> How many times the rounding of its points a section is across, at the most, that is nearly
    !> a point: its shape has three figures or less.
    real(dp), parameter :: nearly = 1.0e3_dp

contains

    !> Draws the range of a section in to where all its lines are. `to` comes out below `from` where
    !> there is no such station.
    pure subroutine limit_section(lines, section)
        type(line_type), intent(in) :: lines(:)       !! of the body
        type(section_type), intent(inout) :: section  !! with the range asked
        integer :: i

        do i = 1, 3
            associate (line => lines(section%line(i)))
                section%from = max(section%from, line%from)
                section%to = min(section%to, line%to)
            end associate
        end do
        do i = 1, 2
            if (.not. section%slope(i)%is_angle) cycle
            associate (line => lines(section%slope(i)%line))
                section%from = max(section%from, line%from)
                section%to = min(section%to, line%to)
            end associate
        end do
    end subroutine limit_section

    !> The five conditions at a station of the range.
    pure type(trace_type) function trace_at(lines, section, sta) result(trace)
        type(line_type), intent(in) :: lines(:)     !! of the body
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), intent(in) :: sta                 !! deck units

        trace%start%point = line_point(lines(section%line(1)), sta)
        trace%shoulder = line_point(lines(section%line(2)), sta)
        trace%finish%point = line_point(lines(section%line(3)), sta)
        trace%start%tangent = direction(lines, section%slope(1), sta)
        trace%finish%tangent = direction(lines, section%slope(2), sta)
        if (.not. section%is_port) return
        trace%start%point(1) = -trace%start%point(1)
        trace%shoulder(1) = -trace%shoulder(1)
        trace%finish%point(1) = -trace%finish%point(1)
        trace%start%tangent(1) = -trace%start%tangent(1)
        trace%finish%tangent(1) = -trace%finish%tangent(1)
    end function trace_at

    !> The direction of an end slope at a station.
    pure function direction(lines, slope, sta)
        type(line_type), intent(in) :: lines(:)     !! of the body
        type(end_slope_type), intent(in) :: slope   !! of a section
        real(dp), intent(in) :: sta                 !! deck units
        real(dp) :: direction(2), angle

        direction = slope%direction
        if (.not. slope%is_angle) return
        angle = chain_value(lines(slope%line)%angle, sta)/degrees
        direction = [cos(angle), sin(angle)]
    end function direction

    !> The arc of a section at a station of its range; x is BL and y is WL. Where the section has
    !> shrunk to a straight line at the end of its range, that line, whatever the end slopes.
    !>
    !> Fails with `cause%points_coincide` where it has shrunk to a point (`is_point`), and with the
    !> causes of `arc_through` where there is no such arc; where rounding alone may be why, it is
    !> said that the section is nearly a point.
    pure subroutine section_arc(lines, section, sta, arc, error)
        type(line_type), intent(in) :: lines(:)             !! of the body
        type(section_type), intent(in) :: section           !! one of its sections
        real(dp), intent(in) :: sta                         !! deck units
        type(arc_type), intent(out) :: arc                  !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(trace_type) :: trace

        trace = trace_at(lines, section, sta)
        if (is_point(trace)) then
            call fail(error, cause%points_coincide, 'section '//trim(section%name)// &
                ' is a point at station '//compact(sta))
            return
        end if
        call arc_through(trace%start, trace%shoulder, trace%finish, arc, error)
        if (.not. allocated(error)) return
        if (is_nearly_point(trace)) error%message = 'it has nearly shrunk to a point, '// &
            compact(extent(trace))//' across where rounding moves points by '// &
            compact(noise_of(trace))//': end the section before, or let it be larger'
        if (sta > section%from .and. sta < section%to) return
        if (.not. has_shrunk(trace)) return
        deallocate (error)
        arc = line_between(trace%start%point, trace%finish%point)
    end subroutine section_arc

    !> True where the three points are one, as far as decimals can say.
    pure logical function is_point(trace)
        type(trace_type), intent(in) :: trace !! of a section
        is_point = extent(trace) <= noise_of(trace)
    end function is_point

    !> True where rounding alone may be why there is no arc.
    pure logical function is_nearly_point(trace)
        type(trace_type), intent(in) :: trace !! of a section
        is_nearly_point = extent(trace) <= nearly*noise_of(trace)
    end function is_nearly_point

    !> How far the points are from the first, along BL or WL, deck units.
    pure real(dp) function extent(trace)
        type(trace_type), intent(in) :: trace !! of a section
        extent = max(maxval(abs(trace%shoulder - trace%start%point)), &
            maxval(abs(trace%finish%point - trace%start%point)))
    end function extent

    !> How far rounding may move the points, deck units.
    pure real(dp) function noise_of(trace)
        type(trace_type), intent(in) :: trace !! of a section
        noise_of = rounding(trace%start%point, trace%shoulder, trace%finish%point)
    end function noise_of

    !> True where the shoulder point is on the chord, from end to end.
    pure logical function has_shrunk(trace)
        type(trace_type), intent(in) :: trace !! of a section, not a point
        real(dp) :: chord(2), along

        chord = trace%finish%point - trace%start%point
        along = dot_product(trace%shoulder - trace%start%point, chord)
        has_shrunk = is_flat(new_triangle(trace%start, trace%shoulder, trace%finish)) &
            .and. any(abs(chord) > 0.0_dp) .and. along >= 0.0_dp &
            .and. along <= dot_product(chord, chord)
    end function has_shrunk

    !> The stations inside the range of a section where arcs of its lines meet, in no order.
    pure function section_joints(lines, section) result(joints)
        type(line_type), intent(in) :: lines(:)     !! of the body
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), allocatable :: joints(:)
        integer :: i

        allocate (joints(0))
        do i = 1, 3
            associate (line => lines(section%line(i)))
                if (line%has_side) joints = [joints, chain_joints(line%side)]
                if (line%has_plan) joints = [joints, chain_joints(line%plan)]
            end associate
        end do
        do i = 1, 2
            if (section%slope(i)%is_angle) &
                joints = [joints, chain_joints(lines(section%slope(i)%line)%angle)]
        end do
        joints = pack(joints, joints > section%from .and. joints < section%to)
    end function section_joints

end module body_section
