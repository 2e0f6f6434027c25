!> What fairing did to measured points: the ordinate of each beside that of the faired line at its
!> station.
module body_faired
    use base_kinds, only: dp
    use body_line, only: line_type
    use body_points, only: points_of, weights_of
    use deck_job, only: body_type, name_length, origin, view, view_type
    use geom_chain, only: chain_has, chain_type, chain_value
    implicit none (type, external)
    private

    public :: faired_type, faired_point_type, faired_views

    !> A measured point.
    type :: faired_point_type
        real(dp) :: sta = 0.0_dp        !! its station, deck units
        real(dp) :: measured = 0.0_dp   !! its ordinate, deck units or degrees
        real(dp) :: weight = 0.0_dp     !! its weight; of an end, which is held, no matter
        logical :: is_held = .false.    !! the line is held here
        logical :: is_on = .false.      !! the line is at this station: a nose has not cut it off
        real(dp) :: faired = 0.0_dp     !! the line's ordinate, where it is
    end type faired_point_type

    !> A view of a line that was faired.
    type :: faired_type
        character(name_length) :: line = ''                 !! name of the line
        integer :: view = 0                                 !! one of `view%...`
        type(faired_point_type), allocatable :: point(:)    !! in the order of the cards
    end type faired_type

contains

    !> The faired views of a body, those that could be built.
    pure function faired_views(asked, lines) result(list)
        type(body_type), intent(in) :: asked    !! as the deck has it
        type(line_type), intent(in) :: lines(:) !! as built
        type(faired_type), allocatable :: list(:)
        type(faired_type) :: item
        integer :: i, j

        allocate (list(0))
        do i = 1, size(lines)
            do j = 1, 3
                if (asked%line(i)%view(j)%origin /= origin%fair) cycle
                if (.not. has_view(lines(i), j)) cycle
                item = faired_view(asked%line(i)%view(j), chain_of(lines(i), j))
                item%line = lines(i)%name
                item%view = j
                list = [list, item]
            end do
        end do
    end function faired_views

    !> True where a view of a line was built.
    pure logical function has_view(line, which)
        type(line_type), intent(in) :: line !! the line
        integer, intent(in) :: which        !! one of `view%...`
        has_view = merge(line%has_side, merge(line%has_plan, line%has_angle, which == view%plan), &
            which == view%side)
    end function has_view

    !> The chain of a view.
    pure type(chain_type) function chain_of(line, which) result(chain)
        type(line_type), intent(in) :: line !! the line
        integer, intent(in) :: which        !! one of `view%...`
        select case (which)
        case (view%side)
            chain = line%side
        case (view%plan)
            chain = line%plan
        case default
            chain = line%angle
        end select
    end function chain_of

    !> The points of a view and the chain at their stations.
    pure type(faired_type) function faired_view(given, chain) result(item)
        type(view_type), intent(in) :: given    !! a faired view
        type(chain_type), intent(in) :: chain   !! what it came to
        real(dp) :: at(2, size(given%piece))
        integer :: i, last

        last = size(given%piece)
        at = points_of(given%piece)
        allocate (item%point(last))
        item%point%sta = at(1, :)
        item%point%measured = at(2, :)
        item%point%weight = weights_of(given%piece, given%weight)
        do i = 1, last
            associate (point => item%point(i))
                point%is_held = i == 1 .or. i == last
                point%is_on = chain_has(chain, point%sta)
                if (point%is_on) point%faired = chain_value(chain, point%sta)
            end associate
        end do
    end function faired_view

end module body_faired
