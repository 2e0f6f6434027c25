!> The points of one track as an outline has them: its two ends, worked out first, since they say
!> whether its neighbours have them already, and the points inside.
module cut_strand
    use base_error, only: error_type
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_outline, only: cut_point_type
    use cut_point, only: point_on_track, turned_back
    use cut_request, only: request_type
    use cut_spread, only: stations_on
    use cut_track, only: track_type
    use cut_track_row, only: points_on_track
    implicit none (type, external)
    private

    public :: strand_type, spread_on, join, close_at, points_said, say_points

    !> A track in the order of an outline.
    type :: strand_type
        logical :: is_aft = .true.              !! the outline goes aft on it
        real(dp), allocatable :: inside(:)      !! stations of the points but for its ends
        type(cut_point_type) :: ends(2)         !! its first and its last point
        logical :: says(2) = .true.             !! the outline has this end from it
    end type strand_type

contains

    !> Spreads the points of a track, and works out its ends. Fails with the causes of
    !> `stations_on`.
    pure subroutine spread_on(body, request, track, is_aft, strand, error)
        type(body_type), intent(in) :: body                     !! finished
        type(request_type), intent(in) :: request               !! plane and rule
        type(track_type), intent(in) :: track                   !! of both
        logical, intent(in) :: is_aft                           !! the outline goes aft on it
        type(strand_type), intent(out) :: strand                !! says both its ends
        type(error_type), allocatable, intent(out) :: error     !! see above
        real(dp), allocatable :: stations(:)
        integer :: i, count

        call stations_on(body, track, request, stations, error)
        if (allocated(error)) return
        count = size(stations)
        if (.not. is_aft) stations = stations(count:1:-1)
        strand%is_aft = is_aft
        strand%inside = stations(2:count - 1)
        do i = 1, 2
            strand%ends(i) = point_on_track(body, request%plane, track, &
                stations(merge(1, count, i == 1)), request%is_flange_forward)
            if (.not. is_aft) strand%ends(i) = turned_back(strand%ends(i))
        end do
    end subroutine spread_on

    !> Leaves the point in which a strand turns back into the next, on the same section, to the
    !> first of the two.
    pure subroutine join(strand, next)
        type(strand_type), intent(in) :: strand     !! of an outline
        type(strand_type), intent(inout) :: next    !! behind it
        next%says(1) = .not. is_same(strand%ends(2), next%ends(1))
    end subroutine join

    !> The same of the last strand of a closed outline and its first.
    pure subroutine close_at(last, first)
        type(strand_type), intent(inout) :: last    !! of a closed outline
        type(strand_type), intent(in) :: first      !! of the same
        last%says(2) = .not. is_same(last%ends(2), first%ends(1))
    end subroutine close_at

    !> True for points of one section that are one.
    pure logical function is_same(first, second)
        type(cut_point_type), intent(in) :: first   !! a point
        type(cut_point_type), intent(in) :: second  !! another
        is_same = first%section == second%section .and. all(is_equal(first%at, second%at))
    end function is_same

    !> How many points an outline has from a strand.
    pure integer function points_said(strand)
        type(strand_type), intent(in) :: strand !! any
        points_said = size(strand%inside) + count(strand%says)
    end function points_said

    !> The points that an outline has from a strand.
    pure subroutine say_points(body, request, track, strand, points)
        type(body_type), intent(in) :: body                 !! finished
        type(request_type), intent(in) :: request           !! plane, flange, facts
        type(track_type), intent(in) :: track               !! of both
        type(strand_type), intent(in) :: strand             !! of that track
        type(cut_point_type), intent(inout) :: points(:)    !! new ones, as many as it says
        integer :: first, last, i

        first = 1
        last = size(points)
        if (strand%says(1)) then
            points(1) = strand%ends(1)
            first = 2
        end if
        if (strand%says(2)) then
            points(last) = strand%ends(2)
            last = last - 1
        end if
        call points_on_track(body, track, strand%inside, request, points(first:last))
        if (strand%is_aft) return
        do i = first, last
            points(i) = turned_back(points(i))
        end do
    end subroutine say_points

end module cut_strand
