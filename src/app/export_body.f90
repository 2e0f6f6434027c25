!> A body deck made ready for export: its bodies built, the cuts that are wanted made and drawn as
!> curves.
module app_export_body
    use api_computed_body, only: computed_body_type, cut_body, how_type
    use app_export_choice, only: choose_cuts
    use app_export_parts, only: begin_parts, parts_type, station_type
    use app_export_request, only: curve_tolerance, request_type
    use app_input, only: deck_input_type
    use app_option_table, only: is_one_of
    use app_progress, only: tell_progress
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use body_body, only: body_type
    use cut_faired, only: measured_cut
    use body_panel, only: mirrored_panel, panel_type
    use cut_outline, only: cut_type
    use cut_plane, only: cut_kind
    use cut_request, only: cut_fact
    use deck_job, only: job_type, name_length
    use deck_job_reader, only: read_job
    use export_arcs, only: part_for_curves
    use export_drawing, only: drawing_type, shape_type
    use export_drawing_cut, only: draw_cut
    use export_drawing_faired, only: outline_shape
    use export_drawing_line, only: draw_line
    use export_drawing_name, only: cut_name, make_unique
    implicit none (type, external)
    private

    public :: read_bodies, draw_curves

contains

    !> Reads a body deck and builds its bodies. `computed` has a place for each body of the deck.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read.
    subroutine read_bodies(input, deck_name, computed, parts, faults, error)
        type(deck_input_type), intent(inout) :: input                       !! at its first card
        character(*), intent(in) :: deck_name                               !! without folders
        type(computed_body_type), allocatable, intent(out) :: computed(:)   !! bodies and cuts
        type(parts_type), intent(out) :: parts                              !! gets the bodies
        type(fault_list_type), intent(inout) :: faults                      !! what is wrong
        type(error_type), allocatable, intent(out) :: error                 !! see above
        type(job_type) :: job
        type(body_type) :: body
        character(:), allocatable :: title
        integer :: i

        call read_job(input%source, input%opening%heading, job, faults, error)
        if (allocated(error)) then
            error%message = input%name//': '//error%message
            return
        end if
        title = ''
        if (allocated(job%title)) title = job%title
        call begin_parts(deck_name, title, trim(job%units), parts)
        parts%is_body_deck = .true.
        allocate (computed(size(job%body)))
        do i = 1, size(computed)
            call tell_progress('building body '//to_text(i)//' of '//to_text(size(computed)))
            call cut_body(job, i, computed(i), faults, how_type(cut_fact%slope, .true.))
            call add_panels(computed(i), parts)
            if (size(computed(i)%body%sections) == 0) cycle
            body = computed(i)%body
            parts%bodies = [parts%bodies, body]
            call add_stations(computed(i)%cuts, parts)
        end do
        parts%is_faulty = faults%has_errors(0)
    end subroutine read_bodies

    !> Takes the patches of a body, with their images where it is symmetric.
    pure subroutine add_panels(computed, parts)
        type(computed_body_type), intent(in) :: computed    !! the body
        type(parts_type), intent(inout) :: parts            !! gets them
        type(panel_type) :: panel
        integer :: i, owner
        logical :: is_half

        owner = 0
        if (size(computed%body%sections) > 0) owner = size(parts%bodies) + 1
        do i = 1, size(computed%panels)
            panel = computed%panels(i)
            is_half = computed%body%is_symmetric .and. panel%has_image
            parts%panels = [parts%panels, panel]
            parts%owner = [parts%owner, merge(owner, 0, is_half .or. &
                .not. computed%body%is_symmetric)]
            if (.not. is_half) cycle
            panel = mirrored_panel(panel)
            parts%panels = [parts%panels, panel]
            parts%owner = [parts%owner, merge(-1, 0, owner > 0)]
        end do
    end subroutine add_panels

    !> Notes the stations that the last body is cut at.
    pure subroutine add_stations(cuts, parts)
        type(cut_type), intent(in) :: cuts(:)       !! of the body
        type(parts_type), intent(inout) :: parts    !! gets them
        integer :: k

        parts%stations = [parts%stations, pack([(station_type(size(parts%bodies), &
            cuts(k)%plane%through(1)), k=1, size(cuts))], cuts%plane%kind == cut_kind%station)]
    end subroutine add_stations

    !> Draws the cuts and faired outlines that are wanted and, for files that have them, the control
    !> lines.
    !>
    !> Fails with `cause%usage` where a cut is asked that the deck has not, and where a curve can't
    !> be drawn.
    subroutine draw_curves(computed, request, has_lines, parts, error)
        type(computed_body_type), intent(in) :: computed(:) !! the bodies of a deck
        type(request_type), intent(in) :: request           !! tolerance; which cuts
        logical, intent(in) :: has_lines                    !! control lines too
        type(parts_type), intent(inout) :: parts            !! gets the curves
        type(error_type), allocatable, intent(out) :: error !! see above
        type(drawing_type) :: named
        character(name_length), allocatable :: cards(:)
        logical, allocatable :: is_chosen(:)
        integer :: i, k, number, drawn

        call name_cuts(computed, named, cards)
        call choose_cuts(request%cuts, named%cuts, cards, is_chosen, error)
        number = 0
        drawn = 0
        parts%drawing%tolerance = request%tolerance
        deallocate (parts%drawing%cuts)
        allocate (parts%drawing%cuts(count(is_chosen)))
        do i = 1, size(computed)
            do k = 1, size(computed(i)%cuts)
                number = number + 1
                if (allocated(error)) return
                if (.not. is_chosen(number)) cycle
                call tell_progress('drawing cut '//to_text(number)//' of '// &
                    to_text(size(is_chosen)))
                drawn = drawn + 1
                call take_cut(computed(i)%body, computed(i)%cuts(k), named%cuts(number), request, &
                    parts%drawing%cuts(drawn), error)
            end do
            do k = 1, size(computed(i)%outlines)
                number = number + 1
                if (allocated(error)) return
                if (.not. is_chosen(number)) cycle
                drawn = drawn + 1
                parts%drawing%cuts(drawn) = outline_shape(computed(i)%outlines(k))
                parts%drawing%cuts(drawn)%name = named%cuts(number)%name
                parts%drawing%cuts(drawn)%number = number
            end do
            if (has_lines .and. .not. allocated(error)) &
                call add_lines(computed(i)%body, request, parts, error)
        end do
        if (.not. allocated(error)) call make_unique(parts%drawing)
    end subroutine draw_curves

    !> Gives the cuts and faired outlines of a deck their names and numbers; both stay where only
    !> some are exported.
    pure subroutine name_cuts(computed, named, cards)
        type(computed_body_type), intent(in) :: computed(:)             !! the bodies of a deck
        type(drawing_type), intent(out) :: named                        !! a shape for each, with
                                                                        !! nothing else
        character(name_length), allocatable, intent(out) :: cards(:)    !! names on the cards
        type(cut_type) :: cut
        integer :: i, k, number

        number = sum([(size(computed(i)%cuts) + size(computed(i)%outlines), i=1, size(computed))])
        allocate (named%cuts(number), named%lines(0), cards(number))
        number = 0
        do i = 1, size(computed)
            do k = 1, size(computed(i)%cuts)
                number = number + 1
                named%cuts(number)%name = trim(cut_name(computed(i)%cuts(k)))
                cards(number) = computed(i)%cuts(k)%name
            end do
            do k = 1, size(computed(i)%outlines)
                number = number + 1
                cut = measured_cut(computed(i)%outlines(k))
                named%cuts(number)%name = trim(cut_name(cut))
                cards(number) = cut%name
            end do
        end do
        named%cuts%number = [(k, k=1, number)]
        call make_unique(named)
    end subroutine name_cuts

    !> Draws a cut.
    !>
    !> Fails where a curve of it can't be drawn.
    subroutine take_cut(body, cut, named, request, shape, error)
        type(body_type), intent(in) :: body                 !! finished
        type(cut_type), intent(in) :: cut                   !! of it
        type(shape_type), intent(in) :: named               !! its name and number
        type(request_type), intent(in) :: request           !! tolerance, way between bevel marks
        type(shape_type), intent(out) :: shape              !! the cut as curves
        type(error_type), allocatable, intent(out) :: error !! see above

        call draw_cut(body, cut, cut_tolerance(cut, request), request%bevel_step, shape, error)
        if (allocated(error)) then
            error%message = named%name//': '//error%message
            return
        end if
        shape%name = named%name
        shape%number = named%number
    end subroutine take_cut

    !> The tolerance of the fitted curves of a cut, deck units: less where arcs shall follow them.
    pure real(dp) function cut_tolerance(cut, request) result(tolerance)
        type(cut_type), intent(in) :: cut           !! may have arcs of its own
        type(request_type), intent(in) :: request   !! settled
        real(dp) :: arcs

        tolerance = curve_tolerance(request)
        if (.not. is_one_of(request%format, 'dxf nc') .or. request%settings%is_in_space) return
        arcs = cut%arcs
        if (request%settings%has_arcs) arcs = request%tolerance
        if (arcs > 0.0_dp) tolerance = min(tolerance, part_for_curves*arcs)
    end function cut_tolerance

    !> Draws the control lines of a body.
    !>
    !> Fails where one can't be drawn.
    subroutine add_lines(body, request, parts, error)
        type(body_type), intent(in) :: body                 !! finished
        type(request_type), intent(in) :: request           !! tolerance
        type(parts_type), intent(inout) :: parts            !! gets the shapes
        type(error_type), allocatable, intent(out) :: error !! see above
        type(shape_type) :: shape
        integer :: i

        do i = 1, size(body%lines)
            call draw_line(body%lines(i), i, curve_tolerance(request), shape, error)
            if (allocated(error)) then
                error%message = trim(body%lines(i)%name)//': '//error%message
                return
            end if
            if (.not. allocated(shape%contours)) cycle
            parts%drawing%lines = [parts%drawing%lines, shape]
        end do
    end subroutine add_lines

end module app_export_body
