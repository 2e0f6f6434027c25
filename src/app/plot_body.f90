!> The pictures of a body deck: the lines plan, each cut in its true shape, the combs and the area
!> curve of each body, the view in space.
module app_plot_body
    use api_computed_body, only: compute_body, computed_body_type, how_type
    use app_files, only: base_name
    use app_input, only: deck_input_type
    use app_picture_drawing, only: write_drawing
    use app_picture_folder, only: begin_folder, folder_type
    use app_picture_name, only: cut_name
    use app_plan_cuts, only: panel_set_type, plan_cuts
    use app_plot_shape, only: add_images, is_same, shape_of
    use api_requests, only: requests_of
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: to_text
    use body_body, only: body_type
    use body_outline, only: outline_type
    use body_panel, only: panel_type
    use cut_faired, only: faired_cut, measured_cut
    use cut_outline, only: cut_type
    use cut_plane, only: cut_kind
    use cut_request, only: cut_fact, request_type
    use deck_job, only: job_type
    use deck_job_reader, only: read_job
    use export_body_area, only: area_drawing
    use export_body_combs, only: combs_drawing
    use export_body_cut, only: cut_drawing
    use export_body_lines, only: lines_plan
    use export_body_view, only: view_drawing
    use export_duct_area, only: duct_area_drawing
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: plot_body

    !> The scripts that those of the pictures load.
    character(*), parameter :: shared_scripts(5) = [character(10) :: 'style.gp', 'strokes.gp', &
        'sheet.gp', 'chart.gp', 'space.gp']

    !> Points that draw a faired outline: more than the eye can tell.
    integer, parameter :: points_drawn = 360

    !> What the pictures of a deck have in common.
    type :: deck_type
        type(job_type) :: job                   !! the deck
        character(:), allocatable :: heading    !! its title, or its name
        character(:), allocatable :: unit       !! name of its unit
        integer :: cuts = 0                     !! cuts drawn so far
    end type deck_type

contains

    !> Reads a body deck and writes data and scripts of its pictures.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read or a file not be written.
    subroutine plot_body(input, folder, is_faulty, messages, error)
        type(deck_input_type), intent(inout) :: input       !! the deck, at its first card
        type(folder_type), intent(inout) :: folder          !! gets the pictures
        logical, intent(out) :: is_faulty                   !! a card was in error
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(fault_list_type) :: faults
        type(deck_type) :: deck

        is_faulty = .true.
        call read_job(input%source, input%opening%heading, deck%job, faults, error)
        if (allocated(error)) then
            error%message = input%name//': '//error%message
            return
        end if
        call name_deck(input%name, deck)
        call plot_bodies(deck, folder, faults, error)
        call print_faults(faults, input%name, .false., messages)
        is_faulty = faults%has_errors(0)
    end subroutine plot_body

    !> Sets what the pictures are called: the title of the deck, else its name.
    subroutine name_deck(name, deck)
        character(*), intent(in) :: name        !! of the deck; `-` is standard input
        type(deck_type), intent(inout) :: deck  !! with its job; gets heading and unit

        deck%heading = ''
        if (allocated(deck%job%title)) deck%heading = deck%job%title
        if (deck%heading == '') deck%heading = base_name(name)
        if (deck%heading == '-') deck%heading = 'standard input'
        deck%unit = 'inches'
        if (deck%job%units == 'MM') deck%unit = 'mm'
        if (deck%job%units == 'FEET') deck%unit = 'feet'
    end subroutine name_deck

    !> Writes the pictures of all bodies.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine plot_bodies(deck, folder, faults, error)
        type(deck_type), intent(inout) :: deck              !! the deck
        type(folder_type), intent(inout) :: folder          !! gets the pictures
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added
        type(error_type), allocatable, intent(out) :: error !! see above
        type(computed_body_type), allocatable :: computed(:)
        type(body_type), allocatable :: bodies(:)
        type(cut_type), allocatable :: asked(:)
        type(panel_set_type), allocatable :: sets(:)
        type(panel_set_type) :: set
        type(panel_type), allocatable :: panels(:)
        integer :: i, outlines

        allocate (computed(size(deck%job%body)), asked(0), bodies(0), sets(0), panels(0))
        outlines = 0
        do i = 1, size(computed)
            call compute_body(deck%job, i, computed(i), faults, how_type(cut_fact%slope, .true.))
            asked = [asked, computed(i)%cuts]
            outlines = outlines + size(computed(i)%outlines)
            call add_images(computed(i), panels)
            if (size(computed(i)%body%sections) == 0) cycle
            bodies = [bodies, computed(i)%body]
            set%panel = computed(i)%panels
            sets = [sets, set]
        end do
        if (size(bodies) + outlines + size(panels) == 0) return
        call begin_folder(folder, shared_scripts, error)
        if (.not. allocated(error) .and. size(bodies) > 0) call write_drawing(lines_plan(bodies, &
            plan_cuts(bodies, asked, sets), deck%heading, deck%unit), 'lines', folder, error)
        if (.not. allocated(error) .and. size(bodies) + size(panels) > 0) call write_drawing( &
            view_drawing(bodies, deck%heading, deck%unit, panels), 'view3d', folder, error)
        do i = 1, size(computed)
            if (allocated(error)) return
            call plot_one(deck, computed(i), i, folder, error)
        end do
    end subroutine plot_bodies

    !> Writes the pictures of one body: combs, area curve, cuts.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine plot_one(deck, computed, number, folder, error)
        type(deck_type), intent(inout) :: deck              !! the deck
        type(computed_body_type), intent(in) :: computed    !! a body with its cuts
        integer, intent(in) :: number                       !! of the body
        type(folder_type), intent(inout) :: folder          !! gets the pictures
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: heading, mark

        heading = deck%heading
        mark = ''
        if (size(deck%job%body) > 1) then
            heading = heading//', '//trim(computed%body%name)
            mark = '-'//to_text(number)
        end if
        call plot_ducts(deck, computed, heading, mark, folder, error)
        if (allocated(error)) return
        if (size(computed%body%sections) == 0) then
            if (size(computed%panels) > 0) call plot_cuts(deck, computed, number, heading, folder, &
                error)
            if (.not. allocated(error)) call plot_outlines(deck, computed%outlines, heading, &
                folder, error)
            return
        end if
        call write_drawing(combs_drawing(computed%body, heading, deck%unit), 'combs'//mark, &
            folder, error)
        if (.not. allocated(error)) call write_drawing(area_drawing(computed%body, &
            computed%measure, stations_of(computed%cuts), heading, deck%unit), 'area'//mark, &
            folder, error)
        if (.not. allocated(error)) call plot_cuts(deck, computed, number, heading, folder, error)
        if (.not. allocated(error)) call plot_outlines(deck, computed%outlines, heading, folder, &
            error)
    end subroutine plot_one

    !> Writes the area curves of ducts.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine plot_ducts(deck, computed, heading, mark, folder, error)
        type(deck_type), intent(in) :: deck                 !! its unit
        type(computed_body_type), intent(in) :: computed    !! a body with its ducts
        character(*), intent(in) :: heading                 !! of the pictures
        character(*), intent(in) :: mark                    !! of the body
        type(folder_type), intent(inout) :: folder          !! gets the pictures
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i

        do i = 1, size(computed%ducts)
            call write_drawing(duct_area_drawing(computed%ducts(i), computed%duct_measures(i), &
                heading, deck%unit), 'area'//mark//'-duct-'//to_text(i), folder, error)
            if (allocated(error)) return
        end do
    end subroutine plot_ducts

    !> Writes the pictures of faired outlines, each over its measured points.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine plot_outlines(deck, outlines, heading, folder, error)
        type(deck_type), intent(inout) :: deck              !! counts the cuts
        type(outline_type), intent(in) :: outlines(:)       !! of a body
        character(*), intent(in) :: heading                 !! of the pictures
        type(folder_type), intent(inout) :: folder          !! gets the pictures
        type(error_type), allocatable, intent(out) :: error !! see above
        type(cut_type) :: measured, shape
        integer :: i

        do i = 1, size(outlines)
            measured = measured_cut(outlines(i))
            call faired_cut(outlines(i), points_drawn, shape, error)
            if (allocated(error)) return
            deck%cuts = deck%cuts + 1
            call write_drawing(cut_drawing(measured, shape, deck%cuts, .false., heading, &
                deck%unit), cut_name(deck%cuts, measured), folder, error)
            if (allocated(error)) return
        end do
    end subroutine plot_outlines

    !> Writes the pictures of the cuts of a body. Their shapes are cut again, as closely as the eye
    !> can tell.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine plot_cuts(deck, computed, number, heading, folder, error)
        type(deck_type), intent(inout) :: deck              !! counts the cuts
        type(computed_body_type), intent(in) :: computed    !! a body with its cuts
        integer, intent(in) :: number                       !! of the body
        character(*), intent(in) :: heading                 !! of the pictures
        type(folder_type), intent(inout) :: folder          !! gets the pictures
        type(error_type), allocatable, intent(out) :: error !! see above
        type(request_type), allocatable :: requests(:)
        type(fault_list_type) :: known
        type(cut_type) :: shape
        integer :: i, k, made

        made = 0
        associate (asked => deck%job%body(number)%cut, cuts => computed%cuts)
            do i = 1, size(asked)
                call requests_of(asked(i), requests, known)
                do k = 1, size(requests)
                    if (made == size(cuts)) return
                    if (.not. is_same(requests(k)%plane, cuts(made + 1)%plane)) cycle
                    made = made + 1
                    shape = shape_of(computed, requests(k), cuts(made))
                    deck%cuts = deck%cuts + 1
                    call write_drawing(cut_drawing(cuts(made), shape, deck%cuts, &
                        computed%body%is_symmetric, heading, deck%unit), &
                        cut_name(deck%cuts, cuts(made)), folder, error)
                    if (allocated(error)) return
                end do
            end do
        end associate
    end subroutine plot_cuts

    !> The stations among some cuts, deck units.
    pure function stations_of(cuts) result(stations)
        type(cut_type), intent(in) :: cuts(:) !! of a body
        real(dp), allocatable :: stations(:)
        integer :: i
        stations = pack([(cuts(i)%plane%through(1), i = 1, size(cuts))], &
            cuts%plane%kind == cut_kind%station)
    end function stations_of

end module app_plot_body
