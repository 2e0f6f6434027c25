!> Where a section has no arc though all its lines are there: the shoulder point is outside of the
!> end tangents, or the ends are on different branches of the conic.
module body_gap
    use base_error, only: error_type
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_text, only: compact
    use body_body, only: body_type, smooth_stops
    use body_section, only: section_arc, section_type
    use body_section_row, only: find_arcs
    use geom_arc, only: arc_type
    use geom_zeros, only: sample_points
    implicit none (type, external)
    private

    public :: gap_type, section_gaps, has_arc

    !> A part of a section's range where it has no arc.
    type :: gap_type
        real(dp) :: from = 0.0_dp               !! least station, deck units
        real(dp) :: to = 0.0_dp                 !! greatest station, deck units
        character(:), allocatable :: reason     !! why there is none, as `arc_through` says it
    end type gap_type

contains

    !> The parts of a section's range where it has no arc, in order, found to the last bit. Looked
    !> for at the samples of `geom_zeros` between joints: a gap shorter than 1/40 of such a stretch
    !> may be passed over here, and is met by the cut that falls into it.
    pure function section_gaps(body, section) result(gaps)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        type(gap_type), allocatable :: gaps(:)
        real(dp), allocatable :: stops(:), sta(:)
        logical, allocatable :: is_sure(:)
        logical :: is_sound, was_sound
        integer :: i

        allocate (gaps(0), sta(0), stops(0))
        stops = smooth_stops(body, section)
        do i = 1, size(stops) - 1
            sta = [sta, sample_points(stops(i), stops(i + 1))]
        end do
        allocate (is_sure(size(sta)))
        call find_arcs(body%lines, section, sta, is_sure)
        was_sound = is_sure(1)
        if (.not. was_sound) was_sound = has_arc(body, section, sta(1))
        if (.not. was_sound) call add_gap(body, section, section%from, sta(1), gaps)
        do i = 2, size(sta)
            is_sound = is_sure(i)
            if (.not. is_sound) is_sound = has_arc(body, section, sta(i))
            if (was_sound .and. .not. is_sound) call add_gap(body, section, &
                edge_between(body, section, sta(i - 1), sta(i)), sta(i), gaps)
            if (is_sound .and. .not. was_sound) &
                gaps(size(gaps))%to = edge_between(body, section, sta(i), sta(i - 1))
            was_sound = is_sound
        end do
        if (.not. was_sound) gaps(size(gaps))%to = section%to
    end function section_gaps

    !> Adds a gap that begins at a station; another inside says why.
    pure subroutine add_gap(body, section, from, inside, gaps)
        type(body_type), intent(in) :: body                     !! finished
        type(section_type), intent(in) :: section               !! one of its sections
        real(dp), intent(in) :: from                            !! deck units
        real(dp), intent(in) :: inside                          !! a station without an arc
        type(gap_type), allocatable, intent(inout) :: gaps(:)   !! gets it
        type(error_type), allocatable :: error
        type(gap_type) :: gap

        gap%from = from
        gap%to = inside
        call explain(body, section, inside, error)
        gap%reason = 'at station '//compact(inside)//': '//error%message
        gaps = [gaps, gap]
    end subroutine add_gap

    !> The error of a section at a station without an arc.
    pure subroutine explain(body, section, sta, error)
        type(body_type), intent(in) :: body                 !! finished
        type(section_type), intent(in) :: section           !! one of its sections
        real(dp), intent(in) :: sta                         !! deck units
        type(error_type), allocatable, intent(out) :: error !! why
        type(arc_type) :: arc
        call section_arc(body%lines, section, sta, arc, error)
    end subroutine explain

    !> True where a section has an arc.
    pure logical function has_arc(body, section, sta)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), intent(in) :: sta                 !! deck units
        type(error_type), allocatable :: error
        call explain(body, section, sta, error)
        has_arc = .not. allocated(error)
    end function has_arc

    !> The station nearest to a gap that still has an arc.
    pure real(dp) function edge_between(body, section, sound, missing) result(edge)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), intent(in) :: sound               !! a station with an arc
        real(dp), intent(in) :: missing             !! one without
        real(dp) :: outside, middle

        edge = sound
        outside = missing
        do
            middle = edge + 0.5_dp*(outside - edge)
            if (is_equal(middle, edge) .or. is_equal(middle, outside)) return
            if (has_arc(body, section, middle)) then
                edge = middle
            else
                outside = middle
            end if
        end do
    end function edge_between

end module body_gap
