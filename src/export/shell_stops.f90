!> The stations at which the skin of a body is parted into faces: where a section begins, ends or
!> has a joint of one of its lines, and where it loses and regains its conic.
module export_shell_stops
    use base_kinds, only: dp
    use base_order, only: rising
    use base_tolerances, only: decimal_noise, ulp
    use body_body, only: body_type, smooth_stops
    use body_gap, only: gap_type, section_gaps
    implicit none (type, external)
    private

    public :: find_gaps, stops_of, sections_between

    !> How far a face keeps from a gap, where the conic is lost: parts of the section's range.
    real(dp), parameter :: gap_margin = 1.0e-3_dp
    !> How near stops are one: ulp of the largest.
    real(dp), parameter :: stop_noise = 4.0_dp*decimal_noise

contains

    !> Where sections have no conic, and a little more.
    pure subroutine find_gaps(body, gaps, owner)
        type(body_type), intent(in) :: body                     !! finished
        type(gap_type), allocatable, intent(out) :: gaps(:)     !! of all sections
        integer, allocatable, intent(out) :: owner(:)           !! the section of each
        type(gap_type), allocatable :: found(:)
        real(dp) :: margin
        integer :: i, k

        allocate (gaps(0), owner(0))
        do i = 1, size(body%sections)
            if (.not. body%sections(i)%from < body%sections(i)%to) cycle
            margin = gap_margin*(body%sections(i)%to - body%sections(i)%from)
            found = section_gaps(body, body%sections(i))
            do k = 1, size(found)
                gaps = [gaps, gap_type(max(body%sections(i)%from, found(k)%from - margin), &
                    min(body%sections(i)%to, found(k)%to + margin))]
                owner = [owner, i]
            end do
        end do
    end subroutine find_gaps

    !> All stops of a body, in order. Those that are one but for rounding count once.
    pure function stops_of(body, gaps) result(stops)
        type(body_type), intent(in) :: body     !! finished
        type(gap_type), intent(in) :: gaps(:)   !! of all sections
        real(dp), allocatable :: stops(:), known(:)
        real(dp) :: noise
        integer :: i

        allocate (known(0))
        known = [gaps%from, gaps%to]
        do i = 1, size(body%sections)
            if (body%sections(i)%from < body%sections(i)%to) &
                known = [known, smooth_stops(body, body%sections(i))]
        end do
        known = rising(known)
        noise = stop_noise*ulp*maxval(abs(known))
        stops = known(:min(1, size(known)))
        do i = 2, size(known)
            if (known(i) - stops(size(stops)) > noise) stops = [stops, known(i)]
        end do
    end function stops_of

    !> The sections that have an arc between two stops.
    pure function sections_between(body, gaps, owner, ends) result(chosen)
        type(body_type), intent(in) :: body     !! finished
        type(gap_type), intent(in) :: gaps(:)   !! of all sections
        integer, intent(in) :: owner(:)         !! the section of each
        real(dp), intent(in) :: ends(2)         !! neighbouring stops
        integer, allocatable :: chosen(:)
        logical :: is_there(size(body%sections))
        real(dp) :: middle
        integer :: i

        middle = 0.5_dp*(ends(1) + ends(2))
        is_there = body%sections%from < middle .and. body%sections%to > middle
        do i = 1, size(gaps)
            if (gaps(i)%from < middle .and. gaps(i)%to > middle) is_there(owner(i)) = .false.
        end do
        chosen = pack([(i, i=1, size(is_there))], is_there)
    end function sections_between

end module export_shell_stops
