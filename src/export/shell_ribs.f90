!> What stands at the ends of stretches: corners, where tracks end, and ribs, the arcs of sections
!> there. Corners that are one point, and ribs that are one curve, count once, so that faces fore
!> and aft of a station, and of both sides, meet exactly. A corner at BL 0 is exactly there.
module export_shell_ribs
    use base_error, only: error_type
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_tolerances, only: meeting_tolerance
    use export_shell_limits, only: end_rows
    use export_shell_rows, only: form, rows_type
    use export_shell_stretch, only: stretch_type, track_at
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: rib_type, ends_type, ribs_type, ribs_of, settle_forms

    !> An arc of a section at an end of stretches.
    type :: rib_type
        integer :: corner(2) = 0            !! from where to where
        type(rows_type) :: rows             !! it
        logical :: is_straight = .false.    !! all of it is on its chord
    end type rib_type

    !> The ends of a stretch: 1 fore, 2 aft.
    type :: ends_type
        integer, allocatable :: corner(:, :)        !! shape (2, tracks)
        integer, allocatable :: rib(:, :)           !! 0: a point; shape (2, slots)
        logical, allocatable :: is_forward(:, :)    !! it runs as the rib does; shape (2, slots)
        type(rows_type), allocatable :: rows(:, :)  !! between the corners; shape (2, slots)
    end type ends_type

    !> Corners and ribs of a body, and who has them.
    type :: ribs_type
        real(dp), allocatable :: corner(:, :)   !! STA, BL, WL: shape (3, corners)
        type(rib_type), allocatable :: rib(:)   !! each once
        type(ends_type), allocatable :: ends(:) !! of each stretch
    end type ribs_type

    !> Places of an arc at which it is compared with another, and by how much their weights may
    !> differ.
    integer, parameter :: compared = 15
    real(dp), parameter :: weight_gap = 1.0e-2_dp

contains

    !> The ribs of some stretches. Fails where a section has no conic that it nears at an end.
    pure subroutine ribs_of(stretches, ribs, error)
        type(stretch_type), intent(in) :: stretches(:)      !! of a body
        type(ribs_type), intent(out) :: ribs                !! theirs
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i, end, k

        allocate (ribs%corner(3, 0), ribs%rib(0), ribs%ends(size(stretches)))
        do i = 1, size(stretches)
            associate (ends => ribs%ends(i), slots => size(stretches(i)%slots))
                allocate (ends%corner(2, size(stretches(i)%tracks)), ends%rib(2, slots), &
                    ends%is_forward(2, slots), ends%rows(2, slots))
            end associate
            do end = 1, 2
                do k = 1, size(stretches(i)%tracks)
                    call find_corner(stretches(i), end, k, ribs%corner, ribs%ends(i)%corner(end, k))
                end do
                do k = 1, size(stretches(i)%slots)
                    call find_rib(stretches(i), end, k, ribs, ribs%ends(i), error)
                    if (allocated(error)) return
                end do
            end do
        end do
    end subroutine ribs_of

    !> The corner at an end of a track: one that stands there, or a new one.
    pure subroutine find_corner(stretch, end, track, corners, number)
        type(stretch_type), intent(in) :: stretch               !! any
        integer, intent(in) :: end                              !! 1: fore, 2: aft
        integer, intent(in) :: track                            !! which of its tracks
        real(dp), allocatable, intent(inout) :: corners(:, :)   !! so far
        integer, intent(out) :: number                          !! which corner it is
        real(dp) :: at(3)

        at(1) = merge(stretch%pace%from, stretch%pace%to, end == 1)
        at(2:) = track_at(stretch, stretch%tracks(track), at(1))
        if (abs(at(2)) <= stretch%join) at(2) = 0.0_dp
        do number = 1, size(corners, 2)
            if (.not. is_equal(corners(1, number), at(1))) cycle
            if (norm2(corners(2:, number) - at(2:)) <= stretch%join) return
        end do
        corners = reshape([corners, at], [3, number])
    end subroutine find_corner

    !> The rib at an end of a section: one that is the same curve, or a new one; none where the
    !> section is a point. Fails as `end_rows`.
    pure subroutine find_rib(stretch, end, slot, ribs, ends, error)
        type(stretch_type), intent(in) :: stretch           !! any
        integer, intent(in) :: end                          !! 1: fore, 2: aft
        integer, intent(in) :: slot                         !! which of its slots
        type(ribs_type), intent(inout) :: ribs              !! so far
        type(ends_type), intent(inout) :: ends              !! of the stretch, with corners
        type(error_type), allocatable, intent(out) :: error !! see above
        type(rib_type) :: new
        real(dp) :: spread_of
        integer :: i

        call end_rows(stretch, stretch%slots(slot), end, new%rows, error)
        if (allocated(error)) return
        new%corner = ends%corner(end, stretch%slots(slot)%track)
        new%rows%start = ribs%corner(2:, new%corner(1))
        new%rows%finish = ribs%corner(2:, new%corner(2))
        spread_of = norm2(shoulder_offset(new%rows))
        ends%rib(end, slot) = 0
        ends%is_forward(end, slot) = .true.
        if (new%corner(1) == new%corner(2) .and. spread_of <= stretch%join) &
            new%rows%middle = new%rows%weight*new%rows%start
        ends%rows(end, slot) = new%rows
        if (new%corner(1) == new%corner(2) .and. spread_of <= stretch%join) return
        new%is_straight = new%corner(1) /= new%corner(2) &
            .and. is_straight(new%rows)
        do i = 1, size(ribs%rib)
            if (.not. are_one(ribs%rib(i), new, stretch%join)) cycle
            ends%rib(end, slot) = i
            ends%is_forward(end, slot) = ribs%rib(i)%corner(1) == new%corner(1)
            if (ribs%rib(i)%is_straight) return
            ends%rows(end, slot)%middle = ribs%rib(i)%rows%middle
            ends%rows(end, slot)%weight = ribs%rib(i)%rows%weight
            return
        end do
        ribs%rib = [ribs%rib, new]
        ends%rib(end, slot) = size(ribs%rib)
    end subroutine find_rib

    !> From the middle of the chord to the shoulder of an arc, deck units.
    pure function shoulder_offset(rows) result(offset)
        type(rows_type), intent(in) :: rows !! any
        real(dp) :: offset(2)
        offset = (rows%middle - 0.5_dp*rows%weight*(rows%start + rows%finish))/ &
            (1.0_dp + rows%weight)
    end function shoulder_offset

    !> True where all of an arc is on its chord, but for rounding of limits.
    pure logical function is_straight(rows)
        type(rows_type), intent(in) :: rows !! any
        real(dp) :: chord(2)
        chord = rows%finish - rows%start
        is_straight = rows%is_line .or. &
            abs(cross(shoulder_offset(rows), chord)) <= meeting_tolerance*norm2(chord)**2
    end function is_straight

    !> True where two ribs are one curve, run through either way.
    pure logical function are_one(first, second, join)
        type(rib_type), intent(in) :: first     !! a rib
        type(rib_type), intent(in) :: second    !! another
        real(dp), intent(in) :: join            !! how near is one, deck units
        are_one = all(first%corner == second%corner) .or. &
            all(first%corner == second%corner([2, 1]))
        if (are_one) are_one = (first%is_straight .and. second%is_straight) &
            .or. is_near(first%rows, second%rows, join)
    end function are_one

    !> True where two arcs between the same points, either way, are one curve.
    pure logical function is_near(first, second, join)
        type(rows_type), intent(in) :: first    !! an arc
        type(rows_type), intent(in) :: second   !! another
        real(dp), intent(in) :: join            !! how near is one, deck units
        type(rows_type) :: other
        real(dp) :: t, way(2), along(2)
        integer :: i

        other = second
        if (norm2(second%finish - first%start) < norm2(second%start - first%start)) then
            other%start = second%finish
            other%finish = second%start
        end if
        is_near = abs(second%weight - first%weight) <= weight_gap
        do i = 1, compared
            t = real(i, dp)/real(compared + 1, dp)
            way = point_of(other, t) - point_of(first, t)
            along = (1.0_dp - t)**2*(first%middle - first%weight*first%start) &
                + t*(1.0_dp - t)*(first%finish - first%start) &
                + t**2*(first%weight*first%finish - first%middle)
            is_near = is_near .and. abs(cross(way, along)) <= join*norm2(along)
        end do
    end function is_near

    !> The point of an arc at t.
    pure function point_of(rows, t) result(point)
        type(rows_type), intent(in) :: rows !! any
        real(dp), intent(in) :: t           !! 0 to 1
        real(dp) :: point(2)
        point = ((1.0_dp - t)**2*rows%start + 2.0_dp*t*(1.0_dp - t)*rows%middle + &
            t**2*rows%finish)/((1.0_dp - t)**2 + 2.0_dp*t*(1.0_dp - t)*rows%weight + t**2)
    end function point_of

    !> Lets sections whose ribs are one have one form, unless they are straight there.
    pure subroutine settle_forms(stretches, ribs, forms)
        type(stretch_type), intent(in) :: stretches(:)  !! of a body
        type(ribs_type), intent(in) :: ribs             !! theirs
        integer, intent(inout) :: forms(:)              !! of each section: one of `form%...`
        integer :: i, k, end, highest(size(ribs%rib)), before

        highest = form%line
        do
            before = sum(forms)
            do i = 1, size(stretches)
                do k = 1, size(stretches(i)%slots)
                    do end = 1, 2
                        associate (rib => ribs%ends(i)%rib(end, k), &
                            number => stretches(i)%slots(k)%number)
                            if (rib == 0 .or. number == 0) cycle
                            if (ribs%rib(rib)%is_straight) cycle
                            highest(rib) = max(highest(rib), forms(number))
                            forms(number) = highest(rib)
                        end associate
                    end do
                end do
            end do
            if (sum(forms) == before) return
        end do
    end subroutine settle_forms

end module export_shell_ribs
