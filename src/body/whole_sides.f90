!> The sides of a patch between lines and stations. Lines meet where they have the same BL and WL at
!> a station; a line has the corner with a station side there, which is the arc of the section that
!> goes from the one line to the other; a POINT is where the sides beside it meet.
module body_whole_sides
    use base_decimal, only: to_real
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use body_body, only: body_type
    use body_line, only: line_point, line_type
    use body_meeting, only: meetings_of, nearest_gap
    use body_panel_side, only: arc_side, line_side, point_side, side_type
    use body_section, only: section_arc
    use deck_job, only: bound, patch_type
    use geom_arc, only: arc_type, reversed
    implicit none (type, external)
    private

    public :: whole_sides

contains

    !> The sides between corners of lines. Fails where a corner or a side can't be found.
    pure subroutine whole_sides(asked, body, gap, side, error)
        type(patch_type), intent(in) :: asked               !! as the deck has it
        type(body_type), intent(in) :: body                 !! with its lines and sections
        real(dp), intent(in) :: gap                         !! by which sides may miss, deck units
        type(side_type), intent(out) :: side(4)             !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: corner(4)
        integer :: i, line

        do i = 1, 4
            call find_corner(asked, body%lines, i, gap, corner(i), error)
            if (allocated(error)) return
        end do
        do i = 1, 4
            associate (first => corner(i), last => corner(1 + mod(i, 4)))
                line = asked%side(i)%line
                select case (asked%side(i)%kind)
                case (bound%line)
                    side(i) = line_side(body%lines(line), first, last)
                    if (abs(last - first) <= 0.0_dp) call fail(error, cause%points_coincide, &
                        'both corners of side '//to_text(i)//' are at station '//compact(first))
                case (bound%station)
                    call find_arc(asked, body, i, first, side(i), error)
                case default
                    line = asked%side(1 + mod(i, 4))%line
                    side(i) = point_side([first, line_point(body%lines(line), first)])
                end select
            end associate
            if (allocated(error)) return
        end do
    end subroutine whole_sides

    !> The station of a corner, between a side and the one before it.
    pure subroutine find_corner(asked, lines, number, gap, corner, error)
        type(patch_type), intent(in) :: asked               !! the patch
        type(line_type), intent(in) :: lines(:)             !! of the body
        integer, intent(in) :: number                       !! which corner, the side that begins
        real(dp), intent(in) :: gap                         !! by which lines may miss, deck units
        real(dp), intent(out) :: corner                     !! its station, deck units
        type(error_type), allocatable, intent(out) :: error !! none, or more than one
        real(dp), allocatable :: meetings(:)
        real(dp) :: range(2)
        integer :: before, after

        before = past_point(asked, number - 1, -1)
        after = past_point(asked, number, 1)
        corner = 0.0_dp
        if (asked%side(after)%kind == bound%station) then
            corner = to_real(asked%side(after)%station)
            call check_station(corner, lines(asked%side(before)%line), error)
        else if (asked%side(before)%kind == bound%station) then
            corner = to_real(asked%side(before)%station)
            call check_station(corner, lines(asked%side(after)%line), error)
        else
            associate (first => lines(asked%side(before)%line), &
                second => lines(asked%side(after)%line))
                range = [max(first%from, second%from), min(first%to, second%to)]
                if (asked%range%has_from) range(1) = max(range(1), to_real(asked%range%from))
                if (asked%range%has_to) range(2) = min(range(2), to_real(asked%range%to))
                if (range(1) <= -huge(1.0_dp) .or. range(2) >= huge(1.0_dp)) then
                    call fail(error, cause%joint_gap, 'lines '//trim(first%name)//' and '// &
                        trim(second%name)//' go on without end; say in FROM and TO where they '// &
                        'may meet')
                    return
                end if
                meetings = meetings_of(first, second, range, gap)
                if (size(meetings) == 1) then
                    corner = meetings(1)
                else
                    call blame_meetings(first, second, range, meetings, error)
                end if
            end associate
        end if
    end subroutine find_corner

    !> The number of a side, or, where that is a point, of the one behind it on the way round.
    pure integer function past_point(asked, number, way) result(side)
        type(patch_type), intent(in) :: asked   !! the patch
        integer, intent(in) :: number           !! 0 to 5: 0 is side 4, 5 is side 1
        integer, intent(in) :: way              !! 1: as the sides go round; -1: back
        side = 1 + modulo(number - 1, 4)
        if (asked%side(side)%kind == bound%point) side = 1 + modulo(side - 1 + way, 4)
    end function past_point

    !> Fails with `cause%beyond_lines` where a line is not at a station.
    pure subroutine check_station(sta, line, error)
        real(dp), intent(in) :: sta                         !! deck units
        type(line_type), intent(in) :: line                 !! a control line
        type(error_type), allocatable, intent(out) :: error !! see above
        if (sta >= line%from .and. sta <= line%to) return
        call fail(error, cause%beyond_lines, 'station '//compact(sta)//' is beyond line '// &
            trim(line%name)//', which goes from station '//compact(line%from)//' to '// &
            compact(line%to))
    end subroutine check_station

    !> Says what is wrong with the meetings of two lines.
    pure subroutine blame_meetings(first, second, range, meetings, error)
        type(line_type), intent(in) :: first                !! a line
        type(line_type), intent(in) :: second               !! another
        real(dp), intent(in) :: range(2)                    !! where they are looked for, deck units
        real(dp), intent(in) :: meetings(:)                 !! stations, none or more than one
        type(error_type), allocatable, intent(out) :: error !! `cause%joint_gap`
        character(:), allocatable :: words
        real(dp) :: nearest(2)
        integer :: i

        if (size(meetings) > 1) then
            words = ' meet at stations '//compact(meetings(1))
            do i = 2, size(meetings)
                words = words//', '//compact(meetings(i))
            end do
            words = words//'; say in FROM and TO which of them is a corner'
        else if (.not. range(1) <= range(2)) then
            words = ' have no station in common'
        else
            nearest = nearest_gap(first, second, range)
            words = ' do not meet from station '//compact(range(1))//' to '//compact(range(2))// &
                ': the gap is '//compact(nearest(2))//' at station '//compact(nearest(1))
        end if
        call fail(error, cause%joint_gap, 'lines '//trim(first%name)//' and '// &
            trim(second%name)//words)
    end subroutine blame_meetings

    !> The arc at a station side: of the section that goes from the line before it to the one after
    !> it, or back.
    pure subroutine find_arc(asked, body, number, sta, side, error)
        type(patch_type), intent(in) :: asked               !! the patch
        type(body_type), intent(in) :: body                 !! with its sections
        integer, intent(in) :: number                       !! which side
        real(dp), intent(in) :: sta                         !! deck units
        type(side_type), intent(out) :: side                !! the arc as it runs
        type(error_type), allocatable, intent(out) :: error !! none there
        type(arc_type) :: arc
        integer :: ends(2), i

        ends = [past_point(asked, number - 1, -1), past_point(asked, number + 1, 1)]
        ends = asked%side(ends)%line
        do i = 1, size(body%sections)
            associate (section => body%sections(i))
                if (sta < section%from .or. sta > section%to) cycle
                if (.not. (all(section%line([1, 3]) == ends) .or. &
                    all(section%line([3, 1]) == ends))) cycle
                call section_arc(body%lines, section, sta, arc, error)
                if (allocated(error)) return
                if (section%line(1) == ends(2)) arc = reversed(arc)
                side = arc_side(arc, sta)
                return
            end associate
        end do
        call fail(error, cause%beyond_lines, 'no section goes from line '// &
            trim(body%lines(ends(1))%name)//' to '//trim(body%lines(ends(2))%name)// &
            ' at station '//compact(sta)//'; its arc would be side '//to_text(number))
    end subroutine find_arc

end module body_whole_sides
