!> A cut of a body as it was asked for.
module cut_make
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use base_tolerances, only: meeting_tolerance
    use body_body, only: body_type, mirrored_body
    use body_section, only: trace_at, trace_type
    use cut_inside, only: inside_outlines
    use cut_lengthwise, only: lengthwise_outlines
    use cut_meeting, only: is_across
    use cut_note, only: note_disagreement, note_sections
    use cut_outline, only: cut_type, outline_type
    use cut_plane, only: cut_kind, plane_type
    use cut_request, only: cut_fact, request_type
    use cut_station, only: station_outlines
    use cut_twice, only: largest_disagreement
    implicit none (type, external)
    private

    public :: make_cut, needs_both_halves

contains

    !> Cuts a body. Of a symmetric body the starboard half is cut, unless the plane has an
    !> inclination to BL 0, or is a buttock to port: then the whole body is. A plane that misses
    !> the body gives a cut without outlines.
    !>
    !> Fails with `cause%beyond_lines` where no section is at the stations asked, and with the
    !> causes of points that can't be spread (`cut_spread`, `cut_arc_spread`).
    pure subroutine make_cut(body, request, cut, error)
        type(body_type), intent(in) :: body                     !! finished
        type(request_type), intent(in) :: request               !! what is asked
        type(cut_type), intent(out) :: cut                      !! where there is no error
        type(error_type), allocatable, intent(out) :: error     !! see above
        type(body_type) :: whole
        integer :: count

        call check_range(body, request, error)
        if (allocated(error)) return
        whole = body
        if (needs_both_halves(request%plane)) whole = mirrored_body(body)
        cut%plane = request%plane
        cut%name = request%name
        cut%is_flange_forward = request%is_flange_forward
        cut%skin = request%skin
        cut%arcs = request%arcs
        allocate (cut%inside(0))
        if (is_across(request%plane)) then
            call station_outlines(whole, request, meeting_tolerance*extent(body, request), &
                cut%outlines, error)
        else
            call lengthwise_outlines(whole, request, cut%outlines, error)
        end if
        if (allocated(error)) return
        call note_sections(body, cut%plane, range_asked(request), cut%notes)
        if (request%skin > 0.0_dp) call inside_outlines(mirrored_body(whole), cut)
        if (request%facts == cut_fact%all) then
            cut%disagreement = largest_disagreement(whole, cut%plane, cut%outlines)
            call note_disagreement(cut)
        end if
        count = size(body%sections)
        call name_originals(count, cut%outlines)
        call name_originals(count, cut%inside)
    end subroutine make_cut

    !> True for a plane that does not cut both halves of a symmetric body alike, or only to port.
    pure logical function needs_both_halves(plane)
        type(plane_type), intent(in) :: plane !! any
        needs_both_halves = abs(plane%normal(2)) > 0.0_dp
        if (plane%kind == cut_kind%buttock) needs_both_halves = plane%through(2) < 0.0_dp
    end function needs_both_halves

    !> The least and greatest station asked.
    pure function range_asked(request) result(range)
        type(request_type), intent(in) :: request !! any
        real(dp) :: range(2)
        range = [-huge(1.0_dp), huge(1.0_dp)]
        if (request%limit(1)%has_from) range(1) = request%limit(1)%from
        if (request%limit(1)%has_to) range(2) = request%limit(1)%to
        if (is_across(request%plane)) range = request%plane%through(1)
    end function range_asked

    !> Fails where no section is at any of the stations asked; the message names the line that is
    !> nearest to being there, and its range.
    pure subroutine check_range(body, request, error)
        type(body_type), intent(in) :: body                     !! finished
        type(request_type), intent(in) :: request               !! what is asked
        type(error_type), allocatable, intent(out) :: error     !! see above
        real(dp) :: asked(2)
        integer :: i, k

        asked = range_asked(request)
        do i = 1, size(body%sections)
            if (is_within(body%sections(i)%from, body%sections(i)%to)) return
        end do
        do i = 1, size(body%sections)
            do k = 1, 3
                associate (line => body%lines(body%sections(i)%line(k)))
                    if (is_within(line%from, line%to)) cycle
                    call fail(error, cause%beyond_lines, 'the cut is beyond line '// &
                        trim(line%name)//', which goes from station '//compact(line%from)// &
                        ' to '//compact(line%to)//'; cut there, or lengthen the line')
                    return
                end associate
            end do
        end do
        call fail(error, cause%beyond_lines, 'no section of the body is at the stations of the cut')
    contains
        !> True where a range has a station that is asked.
        pure logical function is_within(from, to)
            real(dp), intent(in) :: from    !! deck units
            real(dp), intent(in) :: to      !! deck units
            is_within = from <= asked(2) .and. to >= asked(1) .and. from <= to
        end function is_within
    end subroutine check_range

    !> A size of what is cut: the largest coordinate of a section's lines at the station.
    pure real(dp) function extent(body, request)
        type(body_type), intent(in) :: body         !! finished
        type(request_type), intent(in) :: request   !! plane across STA
        type(trace_type) :: trace
        integer :: i

        extent = 0.0_dp
        associate (sta => request%plane%through(1))
            do i = 1, size(body%sections)
                if (sta < body%sections(i)%from .or. sta > body%sections(i)%to) cycle
                trace = trace_at(body%lines, body%sections(i), sta)
                extent = max(extent, maxval(abs([trace%start%point, trace%finish%point])))
            end do
        end associate
    end function extent

    !> Names the sections of the mirrored half by those that they are the image of.
    pure subroutine name_originals(count, outlines)
        integer, intent(in) :: count                        !! sections of the body
        type(outline_type), intent(inout) :: outlines(:)    !! of the whole body
        integer :: i

        do i = 1, size(outlines)
            associate (points => outlines(i)%points, pieces => outlines(i)%pieces)
                where (pieces%section > count)
                    pieces%is_image = .true.
                    pieces%section = pieces%section - count
                end where
                where (points%section > count) points%section = points%section - count
            end associate
        end do
    end subroutine name_originals

end module cut_make
