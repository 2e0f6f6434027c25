!> Samples of the skin of a body, made once: where to begin the search for a nearest point. Each
!> section is cut into sheets (`cut_measure_sheet`) at the stations where its lines join, and each
!> sheet is sampled on a grid that is even in u and t.
module cut_clearance_map
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type, smooth_stops
    use body_section, only: is_point, trace_at, trace_type
    use cut_measure_sheet, only: frame_at, frame_type, new_span, span_type, spot_at, spot_type, &
        station_of
    implicit none (type, external)
    private

    public :: map_type, sheet_type, new_map, row_parts, column_parts

    !> Parts of the grid along u and along t.
    integer, parameter :: row_parts = 32, column_parts = 24

    !> One sheet with its samples.
    type :: sheet_type
        integer :: section = 0                                  !! place in the body's list
        type(span_type) :: span                                 !! its stations
        logical :: is_there(0:row_parts) = .false.              !! the section exists at that u
        logical :: is_point(0:row_parts) = .false.              !! it is a point at that u
        real(dp) :: at(3, 0:column_parts, 0:row_parts) = 0.0_dp !! STA, BL, WL by t and u
        real(dp) :: spacing = 0.0_dp                            !! most between neighbours
    end type sheet_type

    !> The skin of a body, the starboard half of a symmetric one.
    type :: map_type
        type(sheet_type), allocatable :: sheets(:) !! none where nothing is to be found
    end type map_type

contains

    !> Samples a body.
    pure type(map_type) function new_map(body) result(map)
        type(body_type), intent(in) :: body !! finished
        real(dp), allocatable :: stops(:)
        integer :: i, k

        allocate (map%sheets(0), stops(0))
        do i = 1, size(body%sections)
            if (.not. body%sections(i)%from < body%sections(i)%to) cycle
            stops = smooth_stops(body, body%sections(i))
            do k = 1, size(stops) - 1
                map%sheets = [map%sheets, new_sheet(body, i, stops(k), stops(k + 1))]
            end do
        end do
    end function new_map

    !> Samples a section between two stations.
    pure type(sheet_type) function new_sheet(body, section, from, to) result(sheet)
        type(body_type), intent(in) :: body !! finished
        integer, intent(in) :: section      !! place in its list
        real(dp), intent(in) :: from        !! deck units
        real(dp), intent(in) :: to          !! deck units
        integer :: row

        sheet%section = section
        sheet%span = new_span(body, [section], from, to)
        do row = 0, row_parts
            call sample_row(body, row, sheet)
        end do
        sheet%spacing = widest(sheet)
    end function new_sheet

    !> Samples one u of a sheet.
    pure subroutine sample_row(body, row, sheet)
        type(body_type), intent(in) :: body         !! finished
        integer, intent(in) :: row                  !! which u
        type(sheet_type), intent(inout) :: sheet    !! gets the row
        type(frame_type) :: frame
        type(spot_type) :: spot
        type(trace_type) :: trace
        type(error_type), allocatable :: error
        integer :: k

        associate (section => body%sections(sheet%section), &
            sta => station_of(sheet%span, real(row, dp)/real(row_parts, dp)))
            trace = trace_at(body%lines, section, sta%value)
            sheet%is_point(row) = is_point(trace)
            if (sheet%is_point(row)) then
                sheet%at(1, :, row) = sta%value
                sheet%at(2, :, row) = trace%start%point(1)
                sheet%at(3, :, row) = trace%start%point(2)
                sheet%is_there(row) = .true.
                return
            end if
            call frame_at(body, section, sta, frame, error)
        end associate
        if (allocated(error)) return
        sheet%is_there(row) = .true.
        do k = 0, column_parts
            spot = spot_at(frame, real(k, dp)/real(column_parts, dp))
            sheet%at(:, k, row) = spot%at
        end do
    end subroutine sample_row

    !> The most between neighbours of a grid, deck units.
    pure real(dp) function widest(sheet)
        type(sheet_type), intent(in) :: sheet !! sampled
        integer :: i, k

        widest = 0.0_dp
        do i = 0, row_parts
            if (.not. sheet%is_there(i)) cycle
            do k = 1, column_parts
                widest = max(widest, norm2(sheet%at(:, k, i) - sheet%at(:, k - 1, i)))
            end do
        end do
        do i = 1, row_parts
            if (.not. (sheet%is_there(i) .and. sheet%is_there(i - 1))) cycle
            do k = 0, column_parts
                widest = max(widest, norm2(sheet%at(:, k, i) - sheet%at(:, k, i - 1)))
            end do
        end do
    end function widest

end module cut_clearance_map
