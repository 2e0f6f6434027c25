!> Tables of offsets as lofts print them: heights (rows of butt lines) and half-breadths (rows of
!> waterlines) over columns of stations. Every figure is a point of the section's conic itself.
module cut_offsets
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: section_arc
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_crossing, only: crossing, turning_places
    use geom_place, only: at_finish, at_start, place_type
    implicit none (type, external)
    private

    public :: offset_table_type, offset_row_type, heights, half_breadths

    !> One row: an ordinate on one section, and where it is met at each station.
    type :: offset_row_type
        real(dp) :: ordinate = 0.0_dp           !! butt line or waterline, deck units
        integer :: section = 0                  !! place in the body's list of sections
        integer :: passage = 1                  !! the first, second time along the section
        logical, allocatable :: is_met(:)       !! by station
        real(dp), allocatable :: figure(:)      !! height or half-breadth by station, deck units
    end type offset_row_type

    !> One table.
    type :: offset_table_type
        integer :: axis = 1                             !! rows are 1: butt lines, 2: waterlines
        real(dp), allocatable :: stations(:)            !! columns, deck units
        type(offset_row_type), allocatable :: rows(:)   !! by ordinate, then by section
    end type offset_table_type

    !> A section's conic is met by a line of one ordinate at most so often.
    integer, parameter :: most_passages = 2

contains

    !> The heights (WL) of the skin on butt lines. Rows that are met nowhere are left out.
    pure type(offset_table_type) function heights(body, butt_lines, stations) result(table)
        type(body_type), intent(in) :: body         !! the body
        real(dp), intent(in) :: butt_lines(:)       !! BL, deck units
        real(dp), intent(in) :: stations(:)         !! STA, deck units
        table = offsets(body, butt_lines, stations, 1)
    end function heights

    !> The half-breadths (BL) of the skin on waterlines. Rows that are met nowhere are left out.
    pure type(offset_table_type) function half_breadths(body, waterlines, stations) result(table)
        type(body_type), intent(in) :: body         !! the body
        real(dp), intent(in) :: waterlines(:)       !! WL, deck units
        real(dp), intent(in) :: stations(:)         !! STA, deck units
        table = offsets(body, waterlines, stations, 2)
    end function half_breadths

    !> Where ordinates along one axis of the sections are met.
    pure type(offset_table_type) function offsets(body, ordinates, stations, axis) result(table)
        type(body_type), intent(in) :: body     !! the body
        real(dp), intent(in) :: ordinates(:)    !! deck units
        real(dp), intent(in) :: stations(:)     !! deck units
        integer, intent(in) :: axis             !! 1: ordinates are BL, 2: WL
        type(offset_row_type) :: rows(most_passages)
        integer :: i, k, n

        table%axis = axis
        allocate (table%stations, source=stations)
        allocate (table%rows(0))
        do i = 1, size(ordinates)
            do k = 1, size(body%sections)
                rows = rows_of(body, k, ordinates(i), stations, axis)
                do n = 1, most_passages
                    if (any(rows(n)%is_met)) table%rows = [table%rows, rows(n)]
                end do
            end do
        end do
    end function offsets

    !> The rows of one ordinate on one section.
    pure function rows_of(body, section, ordinate, stations, axis) result(rows)
        type(body_type), intent(in) :: body     !! the body
        integer, intent(in) :: section          !! which section
        real(dp), intent(in) :: ordinate        !! deck units
        real(dp), intent(in) :: stations(:)     !! deck units
        integer, intent(in) :: axis             !! 1: the ordinate is BL, 2: WL
        type(offset_row_type) :: rows(most_passages)
        type(place_type), allocatable :: places(:)
        type(error_type), allocatable :: error
        type(arc_type) :: arc
        real(dp) :: at(2)
        integer :: j, n

        do n = 1, most_passages
            rows(n)%ordinate = ordinate
            rows(n)%section = section
            rows(n)%passage = n
            allocate (rows(n)%is_met(size(stations)), source=.false.)
            allocate (rows(n)%figure(size(stations)), source=0.0_dp)
        end do
        do j = 1, size(stations)
            associate (it => body%sections(section))
                if (stations(j) < it%from .or. stations(j) > it%to) cycle
                call section_arc(body%lines, it, stations(j), arc, error)
            end associate
            if (allocated(error)) cycle
            places = places_at(arc, axis, ordinate)
            do n = 1, min(size(places), most_passages)
                at = point(arc, places(n))
                rows(n)%is_met(j) = .true.
                rows(n)%figure(j) = at(3 - axis)
            end do
        end do
    end function rows_of

    !> Where an arc has an ordinate, in order along it.
    pure function places_at(arc, axis, ordinate) result(places)
        type(arc_type), intent(in) :: arc   !! any arc
        integer, intent(in) :: axis         !! 1: x, 2: y
        real(dp), intent(in) :: ordinate    !! deck units
        type(place_type), allocatable :: places(:), ends(:)
        real(dp) :: from, to
        integer :: i

        allocate (places(0), ends(0))
        ends = [at_start, turning_places(arc, axis), at_finish]
        do i = 2, size(ends)
            from = coordinate(arc, axis, ends(i - 1))
            to = coordinate(arc, axis, ends(i))
            if (.not. abs(to - from) > 0.0_dp) cycle
            if (i == 2 .and. .not. abs(from - ordinate) > 0.0_dp) then
                places = [places, ends(1)]
            else if (.not. abs(to - ordinate) > 0.0_dp) then
                places = [places, ends(i)]
            else if ((ordinate - from)*(ordinate - to) < 0.0_dp) then
                places = [places, crossing(arc, axis, ordinate, to > from)]
            end if
        end do
    end function places_at

    !> One coordinate of a place.
    pure real(dp) function coordinate(arc, axis, place)
        type(arc_type), intent(in) :: arc       !! any arc
        integer, intent(in) :: axis             !! 1: x, 2: y
        type(place_type), intent(in) :: place   !! where on it
        real(dp) :: at(2)
        at = point(arc, place)
        coordinate = at(axis)
    end function coordinate

end module cut_offsets
