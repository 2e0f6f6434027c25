!> What is found on the way round a body: meetings of sections, loose ends, stretches of stations;
!> as lists that grow from stretch to stretch aft.
module body_ring_list
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_tolerances, only: tangency_tolerance
    implicit none (type, external)
    private

    public :: ring_type, meeting_type, loose_end_type, stretch_type, is_broken
    public :: add_meeting, sort_meetings, add_loose, add_stretch

    !> How the sections of a stretch of stations close.
    type, public :: closure_list
        integer :: round = 1    !! every end meets another
        integer :: halves = 2   !! ends that meet none are at BL 0
        integer :: open = 3     !! some end is loose
    end type closure_list

    !> The ways to close by name.
    type(closure_list), parameter, public :: closure = closure_list()

    !> Two sections that meet, or one that meets its mirror image. An end is counted as in
    !> `body_ring_end`.
    type :: meeting_type
        integer :: end(2) = 0           !! the ends that meet; the second 0: the mirror image
        real(dp) :: from = 0.0_dp       !! least station, deck units
        real(dp) :: to = 0.0_dp         !! greatest station, deck units
        real(dp) :: break = -1.0_dp     !! largest angle between the end tangents, degrees
        real(dp) :: sta = 0.0_dp        !! where it is, deck units
    end type meeting_type

    !> An end that meets none and is not at BL 0.
    type :: loose_end_type
        integer :: end = 0              !! the end
        integer :: next = 0             !! the loose end that stays nearest, or 0
        real(dp) :: from = 0.0_dp       !! least station, deck units
        real(dp) :: to = 0.0_dp         !! greatest station, deck units
        real(dp) :: gap(2) = 0.0_dp     !! greatest distance to `next`, BL and WL, deck units
        real(dp) :: sta = 0.0_dp        !! where it is, deck units
    end type loose_end_type

    !> A stretch of stations with sections that close in one way.
    type :: stretch_type
        integer :: closure = 0          !! one of `closure%...`
        real(dp) :: from = 0.0_dp       !! least station, deck units
        real(dp) :: to = 0.0_dp         !! greatest station, deck units
    end type stretch_type

    !> All of a body.
    type :: ring_type
        type(meeting_type), allocatable :: meetings(:)  !! in order of their first ends
        type(loose_end_type), allocatable :: loose(:)   !! in order of stations
        type(stretch_type), allocatable :: stretches(:) !! in order of stations
    end type ring_type

contains

    !> True where a meeting breaks by more than slopes of few figures do.
    elemental logical function is_broken(meeting)
        type(meeting_type), intent(in) :: meeting !! any
        is_broken = meeting%break > tangency_tolerance
    end function is_broken

    !> Adds a meeting to those further forward; one that goes on is lengthened.
    pure subroutine add_meeting(new, meetings)
        type(meeting_type), intent(in) :: new                           !! further aft
        type(meeting_type), allocatable, intent(inout) :: meetings(:)   !! so far
        integer :: i

        do i = 1, size(meetings)
            if (any(meetings(i)%end /= new%end)) cycle
            if (.not. is_equal(meetings(i)%to, new%from)) cycle
            meetings(i)%to = new%to
            if (new%break <= meetings(i)%break) return
            meetings(i)%break = new%break
            meetings(i)%sta = new%sta
            return
        end do
        meetings = [meetings, new]
    end subroutine add_meeting

    !> Brings meetings in the order of their ends; the mirror image comes last. Those of the same
    !> ends stay in the order of stations.
    pure subroutine sort_meetings(meetings)
        type(meeting_type), intent(inout) :: meetings(:) !! in any order
        type(meeting_type) :: moved
        integer :: i, j

        do i = 2, size(meetings)
            moved = meetings(i)
            do j = i - 1, 1, -1
                if (.not. is_ahead(moved, meetings(j))) exit
                meetings(j + 1) = meetings(j)
            end do
            meetings(j + 1) = moved
        end do
    contains
        !> True where a meeting belongs before another.
        pure logical function is_ahead(one, other)
            type(meeting_type), intent(in) :: one   !! a meeting
            type(meeting_type), intent(in) :: other !! another
            integer :: last(2)
            last = [one%end(2), other%end(2)]
            where (last == 0) last = huge(1)
            is_ahead = one%end(1) < other%end(1) .or. &
                (one%end(1) == other%end(1) .and. last(1) < last(2))
        end function is_ahead
    end subroutine sort_meetings

    !> Adds a loose end to those further forward; one that goes on is lengthened.
    pure subroutine add_loose(new, loose)
        type(loose_end_type), intent(in) :: new                         !! further aft
        type(loose_end_type), allocatable, intent(inout) :: loose(:)    !! so far
        integer :: i

        do i = 1, size(loose)
            if (loose(i)%end /= new%end .or. loose(i)%next /= new%next) cycle
            if (.not. is_equal(loose(i)%to, new%from)) cycle
            loose(i)%to = new%to
            if (norm2(new%gap) <= norm2(loose(i)%gap)) return
            loose(i)%gap = new%gap
            loose(i)%sta = new%sta
            return
        end do
        loose = [loose, new]
    end subroutine add_loose

    !> Adds a stretch to those further forward; one of the same closure is lengthened.
    pure subroutine add_stretch(new, stretches)
        type(stretch_type), intent(in) :: new                           !! further aft
        type(stretch_type), allocatable, intent(inout) :: stretches(:)  !! so far
        integer :: last

        last = size(stretches)
        if (last > 0) then
            if (stretches(last)%closure == new%closure .and. &
                is_equal(stretches(last)%to, new%from)) then
                stretches(last)%to = new%to
                return
            end if
        end if
        stretches = [stretches, new]
    end subroutine add_stretch

end module body_ring_list
