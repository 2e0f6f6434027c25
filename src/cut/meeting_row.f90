!> Where a plane meets the arcs of a section at stations in a row: `cut_meeting` on rows of numbers.
!> The figures are the same.
module cut_meeting_row
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use body_line, only: line_type
    use body_section, only: section_type
    use body_section_row, only: row_arcs, row_patches
    use body_surface_row, only: patch_row_type
    use cut_meeting, only: meeting_type
    use cut_plane, only: plane_type
    use geom_arc_row, only: arc_row_type, place_row_type
    use geom_twofold, only: twofold, twofold_type
    use geom_twofold_short, only: chosen, exact_row, negative, number_of, operator(*), &
        operator(+), operator(-), row_of, row_type, scaled, sqrt, square, width
    implicit none (type, external)
    private

    public :: row_places, meetings_at

    !> The quadratic forms of the heights of arcs, as `meeting_type` has one.
    type :: form_row_type
        type(row_type) :: start     !! e1
        type(row_type) :: middle    !! e2
        type(row_type) :: finish    !! e3
    end type form_row_type

    !> What takes 1 off a row.
    type(twofold_type), parameter :: minus_one = twofold_type(-1.0_dp, 0.0_dp)
    !> Heights whose squares are numbers, and products of these with others.
    real(dp), parameter :: largest = 1.0e140_dp
    !> One, for each.
    real(dp), parameter :: one_each(width) = 1.0_dp

contains

    !> The places of a branch on arcs. `is_sure` is false where rounding took it beyond an end.
    pure subroutine row_places(arc, sta, plane, branch, place, is_sure)
        type(arc_row_type), intent(in) :: arc           !! x is BL, y is WL; no edge in the plane
        real(dp), intent(in) :: sta(width)              !! deck units
        type(plane_type), intent(in) :: plane           !! any plane but a station
        integer, intent(in) :: branch                   !! one of `cut_branch%...`
        type(place_row_type), intent(out) :: place      !! where on each arc
        logical, intent(out) :: is_sure(width)          !! see above
        type(form_row_type) :: it
        type(row_type) :: root
        logical :: is_first(width)

        call row_forms(arc, sta, plane, real(branch, dp), it)
        is_sure = max(abs(it%start%high), abs(it%middle%high), abs(it%finish%high)) < largest
        if (.not. all(is_sure)) then
            it%start = chosen(it%start, row_of(one_each), is_sure)
            it%middle = chosen(it%middle, row_of(one_each), is_sure)
            it%finish = chosen(it%finish, row_of(one_each), is_sure)
        end if
        root = sqrt(square(it%middle) - it%start*it%finish)
        is_first = it%middle%high > 0.0_dp
        place%alpha = chosen(it%middle + root, it%finish, is_first)
        place%beta = chosen(negative(it%start), root - it%middle, is_first)
        is_sure = is_sure .and. place%alpha%high > 0.0_dp .and. place%beta%high > 0.0_dp
        if (all(is_sure)) return
        place%alpha = chosen(place%alpha, row_of(one_each), is_sure)
        place%beta = chosen(place%beta, row_of(one_each), is_sure)
    end subroutine row_places

    !> The quadratic forms of the heights of arcs.
    pure subroutine row_forms(arc, sta, plane, sense, it)
        type(arc_row_type), intent(in) :: arc           !! x is BL, y is WL; no edge in the plane
        real(dp), intent(in) :: sta(width)              !! deck units
        type(plane_type), intent(in) :: plane           !! any plane but a station
        real(dp), intent(in) :: sense                   !! 1, or -1: heights on the other side
        type(form_row_type), intent(out) :: it          !! the forms
        type(twofold_type) :: n(3)
        type(row_type) :: level

        n = twofold(sense*plane%normal)
        level = n(1)*exact_row(sta, plane%through(1))
        it%start = level + heights(n(2:), plane%through(2:), arc%start)
        it%finish = level + heights(n(2:), plane%through(2:), arc%finish)
        it%middle = (arc%fullness + minus_one)*it%start &
            + scaled(arc%size, multiples(n(2:), arc%leaving))
    end subroutine row_forms

    !> The forms of a section at stations. `is_sure` is false where they are to be worked out one
    !> by one.
    pure subroutine meetings_at(lines, section, plane, stations, it, is_sure)
        type(line_type), intent(in) :: lines(:)         !! of the body
        type(section_type), intent(in) :: section       !! one of its sections
        type(plane_type), intent(in) :: plane           !! any plane but a station
        real(dp), intent(in) :: stations(:)             !! deck units
        type(meeting_type), intent(out) :: it(:)        !! one for each
        logical, intent(out) :: is_sure(:)              !! see above
        type(patch_row_type) :: patch
        type(arc_row_type) :: arc
        type(form_row_type) :: form
        real(dp) :: sta(width)
        logical :: is_good(width)
        integer :: i, k, last

        do i = 1, size(stations), width
            last = min(i + width - 1, size(stations))
            sta = stations(i)
            sta(:last - i + 1) = stations(i:last)
            call row_patches(lines, section, sta, .false., patch, is_good)
            call row_arcs(patch, arc, is_good)
            call row_forms(arc, sta, plane, 1.0_dp, form)
            do k = i, last
                it(k)%start = number_of(form%start, k - i + 1)
                it(k)%middle = number_of(form%middle, k - i + 1)
                it(k)%finish = number_of(form%finish, k - i + 1)
            end do
            is_sure(i:last) = is_good(:last - i + 1)
        end do
    end subroutine meetings_at

    !> The heights of points in their sections over a plane, times the length of its normal.
    pure type(row_type) function heights(n, through, at)
        type(twofold_type), intent(in) :: n(2)  !! normal of the plane, along BL and WL
        real(dp), intent(in) :: through(2)      !! a point of the plane, deck units
        real(dp), intent(in) :: at(width, 2)    !! BL, WL, deck units
        type(row_type) :: way(2)
        way(1) = exact_row(at(:, 1), through(1))
        way(2) = exact_row(at(:, 2), through(2))
        heights = multiples(n, way)
    end function heights

    !> Vectors along BL and WL times the normal of a plane, most of which have one part only.
    pure type(row_type) function multiples(n, v) result(along)
        type(twofold_type), intent(in) :: n(2)  !! along BL and WL, not both zero
        type(row_type), intent(in) :: v(2)      !! the vectors
        if (is_zero(n(1)%high)) then
            along = n(2)*v(2)
        else if (is_zero(n(2)%high)) then
            along = n(1)*v(1)
        else
            along = n(1)*v(1) + n(2)*v(2)
        end if
    end function multiples

end module cut_meeting_row
