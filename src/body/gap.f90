!> Where a section has no arc though all its lines are there: the shoulder point is outside of the
!> end tangents, or the ends are on different branches of the conic. And where its arc goes the long
!> way round: the shoulder point is on the other side of the chord.
module body_gap
    use base_error, only: error_type
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_text, only: compact
    use body_body, only: body_type, smooth_stops
    use body_section, only: section_arc, section_type
    use body_section_row, only: find_arcs
    use geom_arc, only: arc_type, turns_past_180
    use geom_zeros, only: sample_points
    implicit none (type, external)
    private

    public :: gap_type, section_gaps, section_turns, has_arc

    !> A part of a section's range.
    type :: gap_type
        real(dp) :: from = 0.0_dp               !! least station, deck units
        real(dp) :: to = 0.0_dp                 !! greatest station, deck units
        character(:), allocatable :: reason     !! why it has no arc, as `arc_through` says it
    end type gap_type

    abstract interface
        !> What a section is at a station.
        pure logical function property(body, section, sta)
            import :: body_type, dp, section_type
            implicit none (type, external)
            type(body_type), intent(in) :: body         !! finished
            type(section_type), intent(in) :: section   !! one of its sections
            real(dp), intent(in) :: sta                 !! deck units
        end function property
    end interface

contains

    !> The parts of a section's range where it has no arc, in order, found to the last bit. Looked
    !> for at the samples of `geom_zeros` between joints: a gap shorter than 1/40 of such a stretch
    !> may be passed over here, and is met by the cut that falls into it.
    pure function section_gaps(body, section) result(gaps)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        type(gap_type), allocatable :: gaps(:)
        real(dp), allocatable :: sta(:)
        logical, allocatable :: is_sure(:)
        logical :: is_sound, was_sound
        integer :: i

        allocate (gaps(0), sta(0))
        sta = samples_of(body, section)
        allocate (is_sure(size(sta)))
        call find_arcs(body%lines, section, sta, is_sure)
        was_sound = is_sure(1)
        if (.not. was_sound) was_sound = has_arc(body, section, sta(1))
        if (.not. was_sound) call add_gap(body, section, section%from, sta(1), gaps)
        do i = 2, size(sta)
            is_sound = is_sure(i)
            if (.not. is_sound) is_sound = has_arc(body, section, sta(i))
            if (was_sound .and. .not. is_sound) call add_gap(body, section, &
                edge_between(body, section, has_arc, sta(i - 1), sta(i)), sta(i), gaps)
            if (is_sound .and. .not. was_sound) &
                gaps(size(gaps))%to = edge_between(body, section, has_arc, sta(i), sta(i - 1))
            was_sound = is_sound
        end do
        if (.not. was_sound) gaps(size(gaps))%to = section%to
    end function section_gaps

    !> The parts of a section's range where its arc turns by more than 180 degrees, in order, looked
    !> for at the same samples and found to the last bit; they have no reason.
    pure function section_turns(body, section) result(turns)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        type(gap_type), allocatable :: turns(:)
        real(dp), allocatable :: sta(:)
        logical :: is_long, was_long
        integer :: i

        allocate (turns(0), sta(0))
        sta = samples_of(body, section)
        was_long = is_long_way(body, section, sta(1))
        if (was_long) turns = [gap_type(section%from, section%to)]
        do i = 2, size(sta)
            is_long = is_long_way(body, section, sta(i))
            if (is_long .and. .not. was_long) turns = [turns, gap_type( &
                edge_between(body, section, is_long_way, sta(i), sta(i - 1)), section%to)]
            if (was_long .and. .not. is_long) turns(size(turns))%to = &
                edge_between(body, section, is_long_way, sta(i - 1), sta(i))
            was_long = is_long
        end do
    end function section_turns

    !> Where a section is looked at: the samples of `geom_zeros` between joints.
    pure function samples_of(body, section) result(sta)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), allocatable :: sta(:), stops(:)
        integer :: i

        allocate (sta(0), stops(0))
        stops = smooth_stops(body, section)
        do i = 1, size(stops) - 1
            sta = [sta, sample_points(stops(i), stops(i + 1))]
        end do
    end function samples_of

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

    !> True where a section has an arc that turns by more than 180 degrees.
    pure logical function is_long_way(body, section, sta)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), intent(in) :: sta                 !! deck units
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        call section_arc(body%lines, section, sta, arc, error)
        is_long_way = .false.
        if (.not. allocated(error)) is_long_way = turns_past_180(arc)
    end function is_long_way

    !> The last station from one with a property to one without that still has it.
    pure real(dp) function edge_between(body, section, has, with, without) result(edge)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        procedure(property) :: has                  !! the property
        real(dp), intent(in) :: with                !! a station where it holds
        real(dp), intent(in) :: without             !! one where it does not
        real(dp) :: outside, middle

        edge = with
        outside = without
        do
            middle = edge + 0.5_dp*(outside - edge)
            if (is_equal(middle, edge) .or. is_equal(middle, outside)) return
            if (has(body, section, middle)) then
                edge = middle
            else
                outside = middle
            end if
        end do
    end function edge_between

end module body_gap
