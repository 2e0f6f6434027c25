!> A body in space: each section a grid of points of its exact arcs, a row a station, of the whole
!> body. gnuplot draws the grids and leaves out what is hidden behind them.
module export_body_view
    use base_constants, only: degrees
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body, smooth_stops
    use body_panel, only: panel_type
    use body_section, only: is_point, section_arc, section_type, trace_at, trace_type
    use export_body_curves, only: body_range
    use export_body_drawing, only: drawing_type
    use geom_arc, only: arc_type
    use geom_arc_point, only: point, tangent
    use geom_bspline_surface, only: surface_point
    use geom_length, only: places_by_length
    use geom_place, only: at_shoulder, place_type
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: view_drawing

    !> A section as a grid.
    type :: grid_type
        real(dp), allocatable :: at(:, :, :)    !! STA, BL, WL; along the arc; along the body
        logical, allocatable :: is_there(:)     !! the row has an arc
    end type grid_type

    !> Stations along the bodies, about; the largest turn of a section from point to point, degrees.
    integer, parameter :: rows = 36
    real(dp), parameter :: largest_turn = 11.25_dp
    !> Rows close to the ends of a body, in parts of the step of stations: a blunt end bends there.
    !> Cells of a panel along u and v.
    integer, parameter :: panel_columns = 16, panel_rows = 12
    real(dp), parameter :: close_rows(3) = [0.0625_dp, 0.25_dp, 0.5625_dp]

contains

    !> The view of some bodies and of panels.
    pure type(drawing_type) function view_drawing(bodies, heading, unit, panels) result(drawing)
        type(body_type), intent(in) :: bodies(:)    !! finished
        character(*), intent(in) :: heading         !! title of the deck
        character(*), intent(in) :: unit            !! name of its unit
        type(panel_type), intent(in), optional :: panels(:) !! of the bodies, with their images
        type(body_type) :: whole
        real(dp), allocatable :: sta(:)
        real(dp) :: range(2)
        integer :: i, k, patch

        drawing%name = 'view3d'
        drawing%script = 'space'
        drawing%heading = heading
        drawing%note = ''
        drawing%view = 'The whole body, hidden lines left out; '//unit
        drawing%x_axis = 'STA'
        drawing%y_axis = 'BL'
        range = body_range(bodies)
        patch = 0
        do i = 1, size(bodies)
            whole = mirrored_body(bodies(i))
            sta = stations_of(all_stops(bodies(i)), (range(2) - range(1))/real(rows, dp))
            do k = 1, size(whole%sections)
                associate (section => whole%sections(k))
                    call draw_grid(new_grid(whole, section, &
                        pack(sta, sta >= section%from .and. sta <= section%to)), patch, drawing)
                end associate
            end do
        end do
        if (.not. present(panels)) return
        do i = 1, size(panels)
            call draw_grid(panel_grid(panels(i)), patch, drawing)
        end do
    end function view_drawing

    !> The grid of a panel.
    pure type(grid_type) function panel_grid(panel) result(grid)
        type(panel_type), intent(in) :: panel !! any
        integer :: i, k

        allocate (grid%at(3, panel_columns + 1, panel_rows + 1))
        allocate (grid%is_there(panel_rows + 1), source=.true.)
        do k = 0, panel_rows
            do i = 0, panel_columns
                grid%at(:, i + 1, k + 1) = surface_point(panel%surface, &
                    real(i, dp)/real(panel_columns, dp), real(k, dp)/real(panel_rows, dp))
            end do
        end do
    end function panel_grid

    !> The grid of a section.
    pure type(grid_type) function new_grid(body, section, sta) result(grid)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), intent(in) :: sta(:)              !! stations of its range, deck units
        type(arc_type), allocatable :: arcs(:)
        type(error_type), allocatable :: error
        type(trace_type) :: trace
        logical, allocatable :: has_arc(:)
        real(dp) :: turn
        integer :: i, columns

        allocate (arcs(size(sta)), has_arc(size(sta)))
        turn = 0.0_dp
        do i = 1, size(sta)
            call section_arc(body%lines, section, sta(i), arcs(i), error)
            has_arc(i) = .not. allocated(error)
            if (has_arc(i)) turn = max(turn, turn_of(arcs(i)))
        end do
        columns = max(2, ceiling(turn/largest_turn)) + 1
        allocate (grid%at(3, columns, size(sta)))
        allocate (grid%is_there, source=has_arc)
        do i = 1, size(sta)
            grid%at(1, :, i) = sta(i)
            if (has_arc(i)) then
                call set_row(arcs(i), grid%at(2:, :, i))
            else
                trace = trace_at(body%lines, section, sta(i))
                grid%is_there(i) = is_point(trace)
                grid%at(2:, :, i) = spread(trace%start%point, 2, columns)
            end if
        end do
    end function new_grid

    !> Sets points at equal lengths along an arc; on its chord where lengths can't be worked.
    pure subroutine set_row(arc, at)
        type(arc_type), intent(in) :: arc       !! of a section
        real(dp), intent(out) :: at(:, :)       !! BL and WL by columns
        type(place_type), allocatable :: places(:)
        type(error_type), allocatable :: error
        integer :: i

        call places_by_length(arc, size(at, 2), places, error)
        do i = 1, size(at, 2)
            if (allocated(error)) then
                at(:, i) = arc%start + &
                    (arc%finish - arc%start)*real(i - 1, dp)/real(size(at, 2) - 1, dp)
            else
                at(:, i) = point(arc, places(i))
            end if
        end do
    end subroutine set_row

    !> How far an arc turns, degrees.
    pure real(dp) function turn_of(arc)
        type(arc_type), intent(in) :: arc !! any arc
        real(dp) :: middle(2)
        middle = tangent(arc, at_shoulder)
        turn_of = (angle(arc%start_tangent, middle) + angle(middle, arc%finish_tangent))*degrees
    end function turn_of

    !> The angle between two directions, radians.
    pure real(dp) function angle(u, v)
        real(dp), intent(in) :: u(2) !! first direction, not zero
        real(dp), intent(in) :: v(2) !! second direction, not zero
        angle = atan2(abs(cross(u/norm2(u), v/norm2(v))), dot_product(u/norm2(u), v/norm2(v)))
    end function angle

    !> The stations where lines of a body join and where its sections end, rising, each once.
    pure function all_stops(body) result(stops)
        type(body_type), intent(in) :: body !! finished
        real(dp), allocatable :: stops(:), more(:)
        integer :: i

        allocate (more(0), stops(0))
        do i = 1, size(body%sections)
            if (body%sections(i)%to > body%sections(i)%from) &
                more = [more, smooth_stops(body, body%sections(i))]
        end do
        do while (size(more) > 0)
            stops = [stops, minval(more)]
            more = pack(more, more > stops(size(stops)))
        end do
    end function all_stops

    !> Stations from stop to stop in about equal steps, closer at both ends of all.
    pure function stations_of(stops, step) result(sta)
        real(dp), intent(in) :: stops(:)    !! rising, deck units
        real(dp), intent(in) :: step        !! about, deck units
        real(dp), allocatable :: sta(:)
        real(dp) :: even
        integer :: i, k, steps, last

        last = size(stops)
        allocate (sta(0))
        do i = 2, last
            steps = max(1, nint((stops(i) - stops(i - 1))/step))
            even = (stops(i) - stops(i - 1))/real(steps, dp)
            sta = [sta, stops(i - 1)]
            if (i == 2) sta = [sta, stops(1) + even*close_rows]
            sta = [sta, [(stops(i - 1) + even*real(k, dp), k = 1, steps - 1)]]
            if (i == last) sta = [sta, pack(stops(last) - even*close_rows(3:1:-1), &
                stops(last) - even*close_rows(3:1:-1) > sta(size(sta)))]
        end do
        if (last > 0) sta = [sta, stops(last)]
    end function stations_of

    !> Draws a grid; where rows are missing it falls apart into several.
    pure subroutine draw_grid(grid, patch, drawing)
        type(grid_type), intent(in) :: grid             !! a section
        integer, intent(inout) :: patch                 !! grids drawn so far
        type(drawing_type), intent(inout) :: drawing    !! gets it
        integer :: i
        logical :: is_new

        is_new = .true.
        do i = 1, size(grid%is_there)
            if (.not. grid%is_there(i)) then
                is_new = .true.
                cycle
            end if
            if (is_new) patch = patch + 1
            is_new = .false.
            call drawing%draw('skin', grid%at(:, :, i), patch)
        end do
    end subroutine draw_grid

end module export_body_view
