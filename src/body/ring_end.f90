!> The ends of all sections of a body at a station: where they are and which way they leave, so that
!> it can be seen which of them meet, and how.
module body_ring_end
    use base_constants, only: degrees
    use base_error, only: error_type
    use base_kinds, only: dp, i64
    use base_tolerances, only: outline_gap, slope_resolution
    use body_body, only: body_type
    use body_section, only: section_arc, trace_at, trace_type
    use geom_arc, only: arc_type
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: section_end_type, ends_at, section_of, name_of_end, line_of_end, is_on_chine
    public :: touch, is_centred, break_between, break_in_mirror

    !> What stands behind the name of a section on the port side.
    character(*), parameter :: port_mark = ' P'

    !> An end of a section at a station. Ends 2i - 1 and 2i of a list are start and finish of
    !> section i.
    type :: section_end_type
        logical :: is_there = .false.       !! the section has an arc at the station
        real(dp) :: point(2) = 0.0_dp       !! BL, WL, deck units
        real(dp) :: out(2) = 0.0_dp         !! end tangent, pointed out of the section
        real(dp) :: reach = 0.0_dp          !! how near another end must be to be the same
    end type section_end_type

contains

    !> The ends of all sections at a station. A section that is not there, is a point, or has shrunk
    !> to a line that its end slopes do not follow, has none.
    pure function ends_at(body, sta) result(ends)
        type(body_type), intent(in) :: body     !! finished
        real(dp), intent(in) :: sta             !! deck units
        type(section_end_type) :: ends(2*size(body%sections))
        real(dp) :: longest
        integer :: i

        longest = 0.0_dp
        do i = 1, size(body%sections)
            if (sta < body%sections(i)%from .or. sta > body%sections(i)%to) cycle
            ends(2*i - 1:2*i) = ends_of(body, i, sta)
            if (ends(2*i)%is_there) &
                longest = max(longest, norm2(ends(2*i)%point - ends(2*i - 1)%point))
        end do
        ends%reach = outline_gap*longest
    end function ends_at

    !> The ends of one section at a station of its range.
    pure function ends_of(body, number, sta) result(ends)
        type(body_type), intent(in) :: body     !! finished
        integer, intent(in) :: number           !! which section
        real(dp), intent(in) :: sta             !! deck units
        type(section_end_type) :: ends(2)
        type(error_type), allocatable :: error
        type(trace_type) :: trace
        type(arc_type) :: arc

        call section_arc(body%lines, body%sections(number), sta, arc, error)
        if (allocated(error)) return
        trace = trace_at(body%lines, body%sections(number), sta)
        if (.not. follows(arc%start_tangent, trace%start%tangent)) return
        if (.not. follows(arc%finish_tangent, trace%finish%tangent)) return
        ends%is_there = .true.
        ends(1)%point = arc%start
        ends(1)%out = -arc%start_tangent
        ends(2)%point = arc%finish
        ends(2)%out = arc%finish_tangent
    end function ends_of

    !> True where two vectors have one direction, either way, as well as slopes are punched.
    pure logical function follows(first, second)
        real(dp), intent(in) :: first(2)    !! not zero
        real(dp), intent(in) :: second(2)   !! not zero
        follows = abs(cross(first, second)) <= slope_resolution*norm2(first)*norm2(second)
    end function follows

    !> The section of an end of a list.
    elemental integer function section_of(number)
        integer, intent(in) :: number !! place in the list
        section_of = (number + 1)/2
    end function section_of

    !> True where two ends are in one point.
    elemental logical function touch(first, second)
        type(section_end_type), intent(in) :: first     !! there
        type(section_end_type), intent(in) :: second    !! there, at the same station
        touch = norm2(second%point - first%point) <= first%reach
    end function touch

    !> True for an end at BL 0.
    elemental logical function is_centred(end)
        type(section_end_type), intent(in) :: end !! there
        is_centred = abs(end%point(1)) <= end%reach
    end function is_centred

    !> The angle by which the skin breaks from a section to another that it meets, degrees, 0 where
    !> it goes on, 180 where it goes back.
    elemental real(dp) function break_between(first, second) result(angle)
        type(section_end_type), intent(in) :: first     !! there
        type(section_end_type), intent(in) :: second    !! there, in the same point
        angle = angle_between(first%out, -second%out)
    end function break_between

    !> The angle by which the skin breaks at BL 0 from a section to its mirror image, degrees.
    elemental real(dp) function break_in_mirror(end) result(angle)
        type(section_end_type), intent(in) :: end !! there, at BL 0
        angle = angle_between(end%out, [end%out(1), -end%out(2)])
    end function break_in_mirror

    !> The angle between two directions, degrees.
    pure real(dp) function angle_between(first, second) result(angle)
        real(dp), intent(in) :: first(2)    !! not zero
        real(dp), intent(in) :: second(2)   !! not zero
        angle = degrees*atan2(abs(cross(first, second)), dot_product(first, second))
    end function angle_between

    !> The name of the section of an end, `P` behind it on the port side.
    pure function name_of_end(body, end) result(name)
        type(body_type), intent(in) :: body !! the body
        integer, intent(in) :: end          !! place in the list
        character(len_trim(body%sections(section_of(end))%name, i64) + &
            merge(len(port_mark, i64), 0_i64, body%sections(section_of(end))%is_port)) :: name
        name = trim(body%sections(section_of(end))%name)//port_mark
    end function name_of_end

    !> The line on which an end is: the first or the third of its section.
    pure integer function line_number(body, end) result(number)
        type(body_type), intent(in) :: body !! the body
        integer, intent(in) :: end          !! place in the list
        number = body%sections(section_of(end))%line(merge(1, 3, mod(end, 2) == 1))
    end function line_number

    !> The name of the line on which an end is.
    pure function line_of_end(body, end) result(name)
        type(body_type), intent(in) :: body !! the body
        integer, intent(in) :: end          !! place in the list
        character(len_trim(body%lines(line_number(body, end))%name, i64)) :: name
        name = body%lines(line_number(body, end))%name
    end function line_of_end

    !> True where the line on which an end is, is a chine.
    pure logical function is_on_chine(body, end)
        type(body_type), intent(in) :: body !! the body
        integer, intent(in) :: end          !! place in the list
        is_on_chine = body%lines(line_number(body, end))%is_chine
    end function is_on_chine

end module body_ring_end
