!> Whether sections go round the body: which of them meet, whether the skin breaks there, and where
!> ends are left loose.
!>
!> Looked at are stops (ends of sections and of their gaps, joints of their lines) and stations in
!> even steps between them. What is said of a stretch between two stops is so at all of its
!> stations; the largest break is that of the stations looked at.
module body_ring
    use base_kinds, only: dp
    use base_order, only: rising
    use body_body, only: body_type, smooth_stops
    use body_gap, only: gap_type, section_gaps
    use body_ring_end, only: break_between, break_in_mirror, ends_at, is_centred, &
        section_end_type, section_of, touch
    use body_ring_list, only: add_loose, add_meeting, add_stretch, closure, loose_end_type, &
        meeting_type, ring_type, sort_meetings, stretch_type
    implicit none (type, external)
    private

    public :: ring_of

    !> Steps between two stops.
    integer, parameter :: steps = 32

contains

    !> Goes through the rings of a body.
    pure type(ring_type) function ring_of(body) result(ring)
        type(body_type), intent(in) :: body !! finished
        real(dp), allocatable :: stops(:)
        integer :: i

        allocate (ring%meetings(0), ring%loose(0), ring%stretches(0), stops(0))
        stops = all_stops(body)
        do i = 1, size(stops) - 1
            call go_through(body, stops(i), stops(i + 1), ring)
        end do
        call sort_meetings(ring%meetings)
    end function ring_of

    !> The stops of all sections, in order, each once.
    pure function all_stops(body) result(stops)
        type(body_type), intent(in) :: body !! finished
        type(gap_type), allocatable :: gaps(:)
        real(dp), allocatable :: stops(:), all(:)
        integer :: i

        allocate (stops(0), all(0))
        do i = 1, size(body%sections)
            gaps = section_gaps(body, body%sections(i))
            all = [all, smooth_stops(body, body%sections(i)), gaps%from, gaps%to]
        end do
        stops = rising(all)
    end function all_stops

    !> Goes through a stretch between two stops.
    pure subroutine go_through(body, from, to, ring)
        type(body_type), intent(in) :: body         !! finished
        real(dp), intent(in) :: from                !! deck units
        real(dp), intent(in) :: to                  !! deck units, above
        type(ring_type), intent(inout) :: ring      !! as far as `from`
        type(section_end_type) :: ends(0:steps, 2*size(body%sections))
        logical, dimension(2*size(body%sections)) :: meets, is_loose, is_here
        real(dp) :: sta(0:steps)
        integer :: i, j

        sta = [(from + (to - from)*(real(i, dp)/real(steps, dp)), i=0, steps)]
        sta(steps) = to
        do i = 0, steps
            ends(i, :) = ends_at(body, sta(i))
        end do
        is_here = any(ends(1:steps - 1, :)%is_there, dim=1)
        if (.not. any(is_here)) return
        meets = .false.
        do i = 1, size(meets)
            do j = i + 1, size(meets)
                if (.not. stay_together(ends(:, i), ends(:, j), i, j)) cycle
                meets([i, j]) = .true.
                call add_meeting(meeting_of([i, j], ends(:, i), ends(:, j), sta), ring%meetings)
            end do
            is_loose(i) = is_here(i) .and. .not. stays_centred(ends(:, i))
            is_loose(i) = is_loose(i) .and. .not. meets(i)
            if (body%is_symmetric .and. is_here(i) .and. .not. (is_loose(i) .or. meets(i))) &
                call add_meeting(meeting_of([i, 0], ends(:, i), ends(:, i), sta), ring%meetings)
        end do
        do i = 1, size(is_loose)
            if (is_loose(i)) call add_loose(loose_end_of(i, ends, is_loose, sta), ring%loose)
        end do
        call add_stretch(stretch_type(closure_of(is_here, meets, is_loose), from, to), &
            ring%stretches)
    end subroutine go_through

    !> How a stretch closes.
    pure integer function closure_of(is_here, meets, is_loose)
        logical, intent(in) :: is_here(:)   !! the end is there
        logical, intent(in) :: meets(:)     !! it meets another
        logical, intent(in) :: is_loose(:)  !! it meets none and is not at BL 0
        closure_of = closure%round
        if (any(is_here .and. .not. meets)) closure_of = closure%halves
        if (any(is_loose)) closure_of = closure%open
    end function closure_of

    !> True where two ends of different sections are in one point at all stations inside where both
    !> are.
    pure logical function stay_together(first, second, i, j)
        type(section_end_type), intent(in) :: first(0:)     !! over the stations of a stretch
        type(section_end_type), intent(in) :: second(0:)    !! too
        integer, intent(in) :: i                            !! which end the first is
        integer, intent(in) :: j                            !! which the second
        logical :: both(0:steps)

        stay_together = .false.
        if (section_of(i) == section_of(j)) return
        both = first%is_there .and. second%is_there
        both([0, steps]) = .false.
        stay_together = any(both) .and. all(touch(first, second) .or. .not. both)
    end function stay_together

    !> True where an end is at BL 0 at all stations inside where it is.
    pure logical function stays_centred(ends)
        type(section_end_type), intent(in) :: ends(0:) !! over the stations of a stretch
        associate (inner => ends(1:steps - 1))
            stays_centred = all(is_centred(inner) .or. .not. inner%is_there)
        end associate
    end function stays_centred

    !> The meeting of two ends, or of one with its mirror image, over a stretch.
    pure type(meeting_type) function meeting_of(which, first, second, sta) result(meeting)
        integer, intent(in) :: which(2)                     !! the ends; second 0: mirror image
        type(section_end_type), intent(in) :: first(0:)     !! over the stations of the stretch
        type(section_end_type), intent(in) :: second(0:)    !! too; not looked at for the image
        real(dp), intent(in) :: sta(0:)                     !! the stations, deck units
        real(dp) :: break(0:steps)
        logical :: both(0:steps)
        integer :: worst

        both = first%is_there .and. second%is_there
        break = -1.0_dp
        if (which(2) == 0) then
            where (both) break = break_in_mirror(first)
        else
            where (both) break = break_between(first, second)
        end if
        worst = maxloc(break, dim=1) - 1
        meeting = meeting_type(which, sta(0), sta(steps), break(worst), sta(worst))
    end function meeting_of

    !> A loose end over a stretch, with the other loose end that stays nearest.
    pure type(loose_end_type) function loose_end_of(number, ends, is_loose, sta) result(loose)
        integer, intent(in) :: number                       !! which end
        type(section_end_type), intent(in) :: ends(0:, :)   !! shape (stations, ends)
        logical, intent(in) :: is_loose(:)                  !! which ends are
        real(dp), intent(in) :: sta(0:)                     !! the stations, deck units
        real(dp) :: least, far
        integer :: i, k, worst

        loose = loose_end_type(end=number, from=sta(0), to=sta(steps), sta=sta(0))
        least = huge(1.0_dp)
        do i = 1, size(is_loose)
            if (.not. is_loose(i) .or. i == number) cycle
            far = -1.0_dp
            worst = 0
            do k = 0, steps
                if (.not. (ends(k, i)%is_there .and. ends(k, number)%is_there)) cycle
                if (norm2(ends(k, i)%point - ends(k, number)%point) <= far) cycle
                far = norm2(ends(k, i)%point - ends(k, number)%point)
                worst = k
            end do
            if (far < 0.0_dp .or. far >= least) cycle
            least = far
            loose%next = i
            loose%sta = sta(worst)
            loose%gap = ends(worst, i)%point - ends(worst, number)%point
        end do
    end function loose_end_of

end module body_ring
