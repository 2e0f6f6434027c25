!> A section at stations in a row: its conditions with their derivatives, and its arcs, as
!> `body_section` and `body_surface` have them of one station.
module body_section_row
    use base_constants, only: degrees
    use base_kinds, only: dp
    use body_line, only: line_type
    use body_section, only: end_slope_type, section_type, trace_at, trace_type
    use body_surface_row, only: patch_row_type
    use geom_arc_row, only: arc_row_type
    use geom_chain_row, only: jet_row_type, row_jets
    use geom_through_row, only: arcs_through, end_row_type
    use geom_twofold_short, only: width
    implicit none (type, external)
    private

    public :: row_patches, row_arcs, line_points, find_arcs, traces_at

contains

    !> A section about stations of its range.
    pure subroutine row_patches(lines, section, sta, has_second, patch, is_smooth)
        type(line_type), intent(in) :: lines(:)     !! of the body
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), intent(in) :: sta(width)          !! deck units
        logical, intent(in) :: has_second           !! second derivatives are asked for
        type(patch_row_type), intent(out) :: patch  !! see above, without `size`
        logical, intent(out) :: is_smooth(width)    !! no line has an infinite slope
        integer :: i

        is_smooth = .true.
        do i = 1, 3
            call line_jets(lines(section%line(i)), sta, has_second, patch%point(:, i), is_smooth)
        end do
        do i = 1, 2
            call tangent_jets(lines, section%slope(i), sta, has_second, patch%tangent(:, i))
        end do
        patch%size = 1.0_dp
        patch%is_straight = .false.
        if (.not. section%is_port) return
        do i = 1, 3
            patch%point(1, i) = mirrored(patch%point(1, i))
        end do
        do i = 1, 2
            patch%tangent(1, i) = mirrored(patch%tangent(1, i))
        end do
    end subroutine row_patches

    !> Ordinates seen in a mirror.
    pure type(jet_row_type) function mirrored(jet)
        type(jet_row_type), intent(in) :: jet !! any
        mirrored%value = -jet%value
        mirrored%first = -jet%first
        mirrored%second = -jet%second
    end function mirrored

    !> Ordinates that do not change.
    pure type(jet_row_type) function constant(value)
        real(dp), intent(in) :: value !! any number
        constant%value = value
        constant%first = 0.0_dp
        constant%second = 0.0_dp
    end function constant

    !> BL and WL of a line about stations.
    pure subroutine line_jets(line, sta, has_second, jets, is_smooth)
        type(line_type), intent(in) :: line             !! a control line
        real(dp), intent(in) :: sta(width)              !! deck units
        logical, intent(in) :: has_second               !! second derivatives are asked for
        type(jet_row_type), intent(out) :: jets(2)      !! BL and WL, deck units
        logical, intent(inout) :: is_smooth(width)      !! cleared where a slope is infinite
        logical :: is_vertical(width)

        if (line%has_plan) then
            call row_jets(line%plan, sta, has_second, jets(1), is_vertical)
            is_smooth = is_smooth .and. .not. is_vertical
        else
            jets(1) = constant(0.0_dp)
        end if
        call row_jets(line%side, sta, has_second, jets(2), is_vertical)
        is_smooth = is_smooth .and. .not. is_vertical
    end subroutine line_jets

    !> BL and WL of a line at stations, deck units; BL 0 where it has no plan.
    pure subroutine line_points(line, stations, at)
        type(line_type), intent(in) :: line         !! a control line with a side view
        real(dp), intent(in) :: stations(:)         !! deck units
        real(dp), intent(out) :: at(:, :)           !! shape (2, stations)
        type(jet_row_type) :: jets(2)
        real(dp) :: sta(width)
        logical :: is_smooth(width)
        integer :: i, last

        do i = 1, size(stations), width
            last = min(i + width - 1, size(stations))
            sta = stations(i)
            sta(:last - i + 1) = stations(i:last)
            is_smooth = .true.
            call line_jets(line, sta, .false., jets, is_smooth)
            at(1, i:last) = jets(1)%value(:last - i + 1)
            at(2, i:last) = jets(2)%value(:last - i + 1)
        end do
    end subroutine line_points

    !> The conditions of a section at stations.
    pure subroutine traces_at(lines, section, stations, traces)
        type(line_type), intent(in) :: lines(:)         !! of the body
        type(section_type), intent(in) :: section       !! one of its sections
        real(dp), intent(in) :: stations(:)             !! of its range, deck units
        type(trace_type), intent(out) :: traces(:)      !! one for each
        type(patch_row_type) :: patch
        real(dp) :: sta(width)
        logical :: is_smooth(width)
        integer :: i, k, last

        if (size(stations) == 0) return
        if (minval(stations) >= maxval(stations)) then
            traces = trace_at(lines, section, stations(1))
            return
        end if
        do i = 1, size(stations), width
            sta = stations(i)
            last = min(i + width - 1, size(stations))
            sta(:last - i + 1) = stations(i:last)
            call row_patches(lines, section, sta, .false., patch, is_smooth)
            do k = i, last
                traces(k) = trace_of(patch, k - i + 1)
            end do
        end do
    end subroutine traces_at

    !> The conditions of one section of a row.
    pure type(trace_type) function trace_of(patch, i) result(trace)
        type(patch_row_type), intent(in) :: patch   !! about the stations
        integer, intent(in) :: i                    !! which
        integer :: axis

        do axis = 1, 2
            trace%start%point(axis) = patch%point(axis, 1)%value(i)
            trace%shoulder(axis) = patch%point(axis, 2)%value(i)
            trace%finish%point(axis) = patch%point(axis, 3)%value(i)
            trace%start%tangent(axis) = patch%tangent(axis, 1)%value(i)
            trace%finish%tangent(axis) = patch%tangent(axis, 2)%value(i)
        end do
    end function trace_of

    !> True where a section has an arc beyond doubt; elsewhere `section_arc` has to say.
    pure subroutine find_arcs(lines, section, stations, is_sure)
        type(line_type), intent(in) :: lines(:)     !! of the body
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), intent(in) :: stations(:)         !! of its range, deck units
        logical, intent(out) :: is_sure(:)          !! see above, one for each
        type(patch_row_type) :: patch
        type(arc_row_type) :: arc
        real(dp) :: sta(width)
        logical :: is_good(width)
        integer :: i, last

        do i = 1, size(stations), width
            last = min(i + width - 1, size(stations))
            sta = stations(i)
            sta(:last - i + 1) = stations(i:last)
            call row_patches(lines, section, sta, .false., patch, is_good)
            call row_arcs(patch, arc, is_good)
            is_sure(i:last) = is_good(:last - i + 1)
        end do
    end subroutine find_arcs

    !> The directions of an end slope about stations. Sines in vectors would be those of the C
    !> library at hand, whose last digits differ from processor to processor.
    pure subroutine tangent_jets(lines, slope, sta, has_second, jets)
        type(line_type), intent(in) :: lines(:)     !! of the body
        type(end_slope_type), intent(in) :: slope   !! of a section
        real(dp), intent(in) :: sta(width)          !! deck units
        logical, intent(in) :: has_second           !! second derivatives are asked for
        type(jet_row_type), intent(out) :: jets(2)  !! along BL and WL
        type(jet_row_type) :: angle
        logical :: is_vertical(width)
        real(dp), dimension(width) :: turn, bend, c, s
        integer :: i

        jets(1) = constant(slope%direction(1))
        jets(2) = constant(slope%direction(2))
        if (.not. slope%is_angle) return
        call row_jets(lines(slope%line)%angle, sta, has_second, angle, is_vertical)
        turn = angle%first/degrees
        bend = angle%second/degrees
        !GCC$ novector
        do i = 1, width
            c(i) = cos(angle%value(i)/degrees)
            s(i) = sin(angle%value(i)/degrees)
        end do
        jets(1) = jet_row_type(c, -s*turn, -c*turn**2 - s*bend)
        jets(2) = jet_row_type(s, c*turn, -s*turn**2 + c*bend)
    end subroutine tangent_jets

    !> The arcs of a section, and their sizes for its patches. `is_sure` is false where
    !> `section_arc` has to say whether there is one.
    pure subroutine row_arcs(patch, arc, is_sure)
        type(patch_row_type), intent(inout) :: patch    !! about the stations; gets `size`
        type(arc_row_type), intent(out) :: arc          !! x is BL and y is WL
        logical, intent(out) :: is_sure(width)          !! see above
        type(end_row_type) :: start, finish
        real(dp) :: shoulder(width, 2)
        integer :: axis

        do axis = 1, 2
            start%point(:, axis) = patch%point(axis, 1)%value
            shoulder(:, axis) = patch%point(axis, 2)%value
            finish%point(:, axis) = patch%point(axis, 3)%value
            start%tangent(:, axis) = patch%tangent(axis, 1)%value
            finish%tangent(:, axis) = patch%tangent(axis, 2)%value
        end do
        call arcs_through(start, shoulder, finish, arc, is_sure)
        patch%size = arc%size
    end subroutine row_arcs

end module body_section_row
