!> What there is to say of a cut: where sections have no arc, or lie in the plane; where the two
!> ways do not agree.
module cut_note
    use base_kinds, only: dp, i64
    use base_text, only: compact, compact_length
    use base_tolerances, only: agreement_tolerance, agreement_ulps, ulp
    use body_body, only: body_type, is_image, smooth_stops
    use body_gap, only: gap_type, has_arc, section_gaps
    use body_section, only: section_type, trace_at, trace_type
    use cut_meeting, only: edge_height, height_noise, is_across
    use cut_outline, only: cut_type, note_type
    use cut_plane, only: height_over, plane_type
    use geom_twofold, only: to_real
    implicit none (type, external)
    private

    public :: note_sections, note_disagreement, add_note

contains

    !> Notes of the sections at the stations asked: gaps, which are errors, those of a section of
    !> BOTH sides once; and parts that lie in the plane as a whole, of which there is no outline.
    pure subroutine note_sections(body, plane, asked, notes)
        type(body_type), intent(in) :: body                         !! finished
        type(plane_type), intent(in) :: plane                       !! any plane
        real(dp), intent(in) :: asked(2)                            !! stations, deck units
        type(note_type), allocatable, intent(inout) :: notes(:)     !! gets one for each
        type(gap_type), allocatable :: gaps(:)
        real(dp), allocatable :: stops(:)
        integer :: i, k

        if (.not. allocated(notes)) allocate (notes(0))
        allocate (gaps(0), stops(0))
        do i = 1, size(body%sections)
            associate (section => body%sections(i))
                if (is_across(plane) .and. has_arc(body, section, plane%through(1))) cycle
                gaps = section_gaps(body, section)
                do k = 1, merge(0, size(gaps), is_image(body, i))
                    if (gaps(k)%from > asked(2) .or. gaps(k)%to < asked(1)) cycle
                    if (.not. comes_near(body, section, plane, [max(gaps(k)%from, asked(1)), &
                        min(gaps(k)%to, asked(2))])) cycle
                    call add_note(notes, .true., 'section '//trim(section%name)// &
                        ' does not exist'//between(gaps(k)%from, gaps(k)%to)// &
                        '; what is said of its SECTION card says why')
                end do
                stops = smooth_stops(body, section)
                do k = 1, size(stops) - 1
                    if (stops(k) > asked(2) .or. stops(k + 1) < asked(1)) cycle
                    if (.not. lies_in(body, section, plane, stops(k:k + 1))) cycle
                    call add_note(notes, .false., 'section '//trim(section%name)// &
                        ' lies in the plane of the cut'//between(stops(k), stops(k + 1))// &
                        '; it has no outline there, but those of its neighbours')
                end do
            end associate
        end do
    end subroutine note_sections

    !> A range of stations in words.
    pure function between(from, to) result(words)
        real(dp), intent(in) :: from    !! deck units
        real(dp), intent(in) :: to      !! deck units
        character(len(' from station  to ', i64) + sum(compact_length([from, to]))) :: words
        words = ' from station '//compact(from)//' to '//compact(to)
    end function between

    !> True where a plane comes between the points of a section's lines, or of their mirror images,
    !> on a stretch of stations: where the section would be.
    pure logical function comes_near(body, section, plane, ends)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        type(plane_type), intent(in) :: plane       !! any plane
        real(dp), intent(in) :: ends(2)             !! stations, deck units
        integer, parameter :: steps = 40
        type(trace_type) :: trace
        real(dp) :: sta, at(2, 3), height(6)
        logical :: is_below, is_above
        integer :: i, k

        is_below = .false.
        is_above = .false.
        do i = 0, steps
            sta = ends(1) + (real(i, dp)/real(steps, dp))*(ends(2) - ends(1))
            trace = trace_at(body%lines, section, sta)
            at = reshape([trace%start%point, trace%shoulder, trace%finish%point], [2, 3])
            height = [(height_over(plane, [sta, at(:, k)]), &
                height_over(plane, [sta, -at(1, k), at(2, k)]), k = 1, 3)]
            is_below = is_below .or. any(height <= 0.0_dp)
            is_above = is_above .or. any(height >= 0.0_dp)
        end do
        comes_near = is_below .and. is_above
    end function comes_near

    !> True where a section is all in a plane, between two joints of its lines: its three points
    !> are, at four stations of which no three are special.
    pure logical function lies_in(body, section, plane, ends)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        type(plane_type), intent(in) :: plane       !! any plane
        real(dp), intent(in) :: ends(2)             !! stations, deck units
        real(dp), parameter :: share(4) = [0.13_dp, 0.37_dp, 0.61_dp, 0.89_dp]
        type(trace_type) :: trace
        real(dp) :: sta
        integer :: i

        lies_in = .true.
        do i = 1, size(share)
            sta = ends(1) + share(i)*(ends(2) - ends(1))
            trace = trace_at(body%lines, section, sta)
            lies_in = is_in(trace%start%point) .and. is_in(trace%shoulder) &
                .and. is_in(trace%finish%point)
            if (.not. lies_in) return
        end do
    contains
        !> True for a point of the plane, as far as decimals can say.
        pure logical function is_in(at)
            real(dp), intent(in) :: at(2) !! BL, WL, deck units
            is_in = abs(to_real(edge_height(plane, sta, at))) <= height_noise(plane, sta, at)
        end function is_in
    end function lies_in

    !> Notes, as an error, that the two ways to the points of a cut do not agree.
    pure subroutine note_disagreement(cut)
        type(cut_type), intent(inout) :: cut !! has outlines and disagreement
        real(dp) :: largest
        integer :: i

        largest = 0.0_dp
        do i = 1, size(cut%outlines)
            largest = max(largest, maxval(abs(cut%outlines(i)%points%at(1))), &
                maxval(abs(cut%outlines(i)%points%at(2))), &
                maxval(abs(cut%outlines(i)%points%at(3))))
        end do
        if (cut%disagreement <= max(agreement_tolerance, agreement_ulps*ulp*largest)) return
        call add_note(cut%notes, .true., 'the two ways to the points of the cut differ by '// &
            compact(cut%disagreement)//'; its figures can''t be relied upon')
    end subroutine note_disagreement

    !> Adds a note.
    pure subroutine add_note(notes, is_error, message)
        type(note_type), allocatable, intent(inout) :: notes(:)     !! gets it
        logical, intent(in) :: is_error                             !! the cut can't be relied upon
        character(*), intent(in) :: message                         !! plain words, no final point
        type(note_type) :: note
        note%is_error = is_error
        note%message = message
        notes = [notes, note]
    end subroutine add_note

end module cut_note
