!> Where two control lines meet in space: the stations at which both have the same BL and WL.
module body_meeting
    use base_kinds, only: dp
    use base_order, only: rising
    use body_line, only: line_point, line_type
    use geom_chain, only: chain_joints
    use geom_zeros, only: function_type, sample_points, zeros_of
    implicit none (type, external)
    private

    public :: meetings_of, nearest_gap

    !> The part of the gap within which two lines touch along an axis.
    real(dp), parameter :: touch = 1.0e-3_dp

    !> The difference of two lines along one axis.
    type, extends(function_type) :: difference_type
        type(line_type) :: first    !! a line
        type(line_type) :: second   !! another
        integer :: axis = 1         !! 1 BL, 2 WL
    contains
        procedure :: at => difference
    end type difference_type

contains

    !> The stations of a range where two lines meet, rising. Lines that keep together for a while
    !> meet at its ends.
    pure function meetings_of(first, second, range, gap) result(meetings)
        type(line_type), intent(in) :: first    !! a line
        type(line_type), intent(in) :: second   !! another
        real(dp), intent(in) :: range(2)        !! both are there, deck units
        real(dp), intent(in) :: gap             !! by which they may miss, deck units
        real(dp), allocatable :: meetings(:)
        real(dp), allocatable :: candidates(:), stops(:)
        type(difference_type) :: along
        real(dp) :: next
        integer :: i, k

        allocate (meetings(0))
        if (.not. range(1) <= range(2)) return
        allocate (stops(0))
        stops = stops_of(first, second, range)
        allocate (candidates, source=stops)
        along%first = first
        along%second = second
        do i = 1, size(stops) - 1
            along%axis = 1
            candidates = [candidates, zeros_of(along, stops(i), stops(i + 1), touch*gap)]
            along%axis = 2
            candidates = [candidates, zeros_of(along, stops(i), stops(i + 1), touch*gap)]
        end do
        candidates = rising(candidates)
        do k = 1, size(candidates)
            next = candidates(k)
            if (distance(first, second, next) > gap) cycle
            if (size(meetings) > 0) then
                if (all_near(meetings(size(meetings)), next)) then
                    i = size(meetings)
                    if (distance(first, second, next) < distance(first, second, meetings(i))) &
                        meetings(i) = next
                    cycle
                end if
            end if
            meetings = [meetings, next]
        end do
    contains
        !> True where two stations, and what is between them, are one meeting.
        pure logical function all_near(one, other)
            real(dp), intent(in) :: one     !! deck units
            real(dp), intent(in) :: other   !! deck units
            all_near = other - one <= gap .and. &
                distance(first, second, 0.5_dp*(one + other)) <= gap
        end function all_near
    end function meetings_of

    !> The ends of a range and the joints of two lines inside, rising, each once.
    pure function stops_of(first, second, range) result(stops)
        type(line_type), intent(in) :: first    !! a line
        type(line_type), intent(in) :: second   !! another
        real(dp), intent(in) :: range(2)        !! deck units
        real(dp), allocatable :: stops(:), joints(:)

        allocate (joints(0))
        joints = [chain_joints(first%side), chain_joints(second%side)]
        if (first%has_plan) joints = [joints, chain_joints(first%plan)]
        if (second%has_plan) joints = [joints, chain_joints(second%plan)]
        stops = rising([range, pack(joints, joints > range(1) .and. joints < range(2))])
    end function stops_of

    !> The station of a range where two lines are nearest to each other, among its samples, and how
    !> near they are there: deck units.
    pure function nearest_gap(first, second, range) result(nearest)
        type(line_type), intent(in) :: first    !! a line
        type(line_type), intent(in) :: second   !! another
        real(dp), intent(in) :: range(2)        !! both are there, deck units
        real(dp) :: nearest(2)
        real(dp), allocatable :: sta(:)
        integer :: i

        allocate (sta(0))
        sta = [range(1), sample_points(range(1), range(2)), range(2)]
        nearest = [range(1), huge(1.0_dp)]
        do i = 1, size(sta)
            if (distance(first, second, sta(i)) < nearest(2)) &
                nearest = [sta(i), distance(first, second, sta(i))]
        end do
    end function nearest_gap

    !> How far two lines are from each other at a station, deck units.
    pure real(dp) function distance(first, second, sta)
        type(line_type), intent(in) :: first    !! a line
        type(line_type), intent(in) :: second   !! another
        real(dp), intent(in) :: sta             !! deck units
        real(dp) :: way(2)
        way = line_point(first, sta) - line_point(second, sta)
        distance = hypot(way(1), way(2))
    end function distance

    !> The difference of two lines along an axis at a station, deck units.
    pure real(dp) function difference(f, x)
        class(difference_type), intent(in) :: f !! the lines
        real(dp), intent(in) :: x               !! STA
        real(dp) :: way(2)
        way = line_point(f%first, x) - line_point(f%second, x)
        difference = way(f%axis)
    end function difference

end module body_meeting
