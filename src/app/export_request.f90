!> What `loft export` was asked for: the format, by the ending of the file or by `--format`, and the
!> settings of its writer, whose lengths wait for the unit of the deck.
module app_export_request
    use app_files, only: base_name
    use app_option_table, only: is_one_of, option_layout_type, option_of
    use app_options, only: argument_type, given_type, options_type
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: upper
    use export_settings, only: settings_type
    use export_units, only: find_unit, unit_type
    implicit none (type, external)
    private

    public :: request_type, read_request, settle_request, curve_tolerance

    !> A request.
    type :: request_type
        character(:), allocatable :: format     !! as `--format` has it
        character(:), allocatable :: units      !! of the file; empty: those of the deck
        type(settings_type) :: settings         !! as given, without defaults
        real(dp) :: tolerance = 0.0_dp          !! deck units; 0: not said
        logical :: has_tolerance = .false.      !! --tolerance was given
        real(dp) :: bevel_step = 0.0_dp         !! deck units; 0: not said
        logical :: has_depth = .false.          !! --depth was given
        type(argument_type), allocatable :: cuts(:) !! names or numbers of the cuts; none: all
    end type request_type

    !> The part of the tolerance that fitted curves may take in files whose writers put chords or
    !> other arcs in their place; these have the rest.
    real(dp), parameter :: curve_part = 0.1_dp

    !> The endings of a format.
    type :: ending_type
        character(4) :: format      !! as `--format` has it
        character(12) :: endings    !! in capitals
    end type ending_type

    !> All of them.
    type(ending_type), parameter :: endings(11) = [ &
        ending_type('svg', 'SVG'), ending_type('pdf', 'PDF'), ending_type('dxf', 'DXF'), &
        ending_type('iges', 'IGS IGES'), ending_type('step', 'STEP STP'), &
        ending_type('stl', 'STL'), ending_type('obj', 'OBJ'), &
        ending_type('nc', 'NC NGC GCODE'), ending_type('hrm', 'HRM'), ending_type('wgs', 'WGS'), &
        ending_type('csv', 'CSV')]
    !> The endings as a user reads them.
    character(*), parameter :: all_endings = '.svg .pdf .dxf .igs .iges .step .stp .stl .obj '// &
        '.nc .ngc .gcode .hrm .wgs .csv'

    !> What holds where nothing is said, for a deck in inches, mm and feet: the tolerance and the
    !> way between bevel marks, deck units. Meshes of that tolerance would be very large files:
    !> theirs is ten times as much.
    real(dp), parameter :: usual_tolerance(3) = [1.0e-3_dp, 2.5e-2_dp, 8.0e-5_dp], &
        usual_bevel_step(3) = [6.0_dp, 150.0_dp, 0.5_dp], mesh_times = 10.0_dp
    !> The same for a file in inches or feet, and in mm or metres, in inches and mm: overlap of
    !> tiles; of NC the feed a minute, the depth and the safe height.
    real(dp), parameter :: usual_overlap(2) = [0.5_dp, 12.0_dp], usual_feed(2) = [20.0_dp, &
        500.0_dp], usual_depth(2) = [-0.125_dp, -3.0_dp], usual_safe(2) = [0.25_dp, 6.0_dp]

contains

    !> Reads what the command line asks of an export.
    !>
    !> Fails with `cause%usage` where the format is not known, or an option does not go with it.
    pure subroutine read_request(options, request, error)
        type(options_type), intent(in) :: options           !! the command line
        type(request_type), intent(out) :: request          !! what it asks for
        type(error_type), allocatable, intent(out) :: error !! see above
        type(option_layout_type) :: layout
        integer :: i

        request%units = ''
        request%settings%paper = ''
        allocate (request%cuts(0))
        call find_format(options, request%format, error)
        if (allocated(error)) return
        request%settings%is_each = request%format == 'pdf'
        do i = 1, size(options%given)
            layout = option_of(options%given(i)%name, 'export')
            if (layout%formats == '' .or. is_one_of(request%format, layout%formats)) then
                call take(options%given(i), request)
            else
                call fail(error, cause%usage, trim(layout%name)//' does not go with '// &
                    request%format//', but with: '//trim(layout%formats))
                return
            end if
        end do
        call check_request(options, request, error)
    end subroutine read_request

    !> The format of the file: what `--format` says, else by its ending.
    !>
    !> Fails with `cause%usage`.
    pure subroutine find_format(options, format, error)
        type(options_type), intent(in) :: options               !! the command line
        character(:), allocatable, intent(out) :: format        !! as `--format` has it
        type(error_type), allocatable, intent(out) :: error     !! see above
        character(:), allocatable :: name, ending
        integer :: i

        format = options%format
        if (format /= '') return
        name = base_name(options%output)
        ending = name(index(name, '.', back=.true.) + 1:)
        ending = upper(ending)
        do i = 1, size(endings)
            if (is_one_of(ending, endings(i)%endings) .and. index(name, '.') > 0) &
                format = trim(endings(i)%format)
        end do
        if (format /= '') return
        if (options%output == '-') then
            call fail(error, cause%usage, '-o - is standard output; --format says what goes there')
        else
            call fail(error, cause%usage, '-o '//options%output//': its ending says no format; '// &
                'endings: '//all_endings)
        end if
    end subroutine find_format

    !> Takes an option that goes with the format.
    pure subroutine take(given, request)
        type(given_type), intent(in) :: given           !! the option
        type(request_type), intent(inout) :: request    !! gets it

        select case (given%name)
        case ('--tolerance')
            request%tolerance = given%number
            request%has_tolerance = .true.
        case ('--bevel')
            request%bevel_step = given%number
        case ('--units')
            request%units = trim(merge('INCHES', 'MM    ', given%text == 'in'))
            if (given%text == 'ft') request%units = 'FEET'
            if (given%text == 'm') request%units = 'M'
        case ('--cut')
            call split(given%text, request%cuts)
        case ('--depth')
            request%settings%depth = given%number
            request%has_depth = .true.
        case default
            call take_setting(given, request%settings)
        end select
    end subroutine take

    !> Takes an option that is a setting as it is.
    pure subroutine take_setting(given, settings)
        type(given_type), intent(in) :: given           !! the option
        type(settings_type), intent(inout) :: settings  !! gets it

        select case (given%name)
        case ('--sheet')
            settings%is_each = given%text == 'each'
        case ('--paper')
            settings%paper = given%text
            settings%roll_width = given%number
        case ('--overlap')
            settings%overlap = given%number
        case ('--half')
            settings%is_half = .true.
        case ('--dxf-splines')
            settings%has_splines = .true.
        case ('--3d')
            settings%is_in_space = .true.
        case ('--arcs')
            settings%has_arcs = .true.
        case ('--iges-conics')
            settings%has_conics = .true.
        case ('--angle')
            settings%angle = given%number
        case ('--binary')
            settings%is_binary = .true.
        case ('--open')
            settings%is_open = .true.
        case ('--feed')
            settings%feed = given%number
        case ('--safe')
            settings%safe = given%number
        end select
    end subroutine take_setting

    !> Adds the words of a list with commas in it.
    pure subroutine split(list, words)
        character(*), intent(in) :: list                                !! `FLOOR,4`
        type(argument_type), allocatable, intent(inout) :: words(:)     !! gets them
        type(argument_type) :: word
        integer :: first, last

        first = 1
        do while (first <= len(list))
            last = first + index(list(first:)//',', ',') - 2
            word%text = trim(adjustl(list(first:last)))
            if (word%text /= '') words = [words, word]
            first = last + 2
        end do
    end subroutine split

    !> What can't stand together.
    pure subroutine check_request(options, request, error)
        type(options_type), intent(in) :: options           !! the command line
        type(request_type), intent(in) :: request           !! what was read
        type(error_type), allocatable, intent(out) :: error !! `cause%usage`

        associate (settings => request%settings)
            if (settings%overlap > 0.0_dp .and. settings%paper == '') then
                call fail(error, cause%usage, '--overlap goes with --paper')
            else if (request%format == 'svg' .and. options%output == '-' .and. &
                (settings%is_each .or. settings%paper /= '')) then
                call fail(error, cause%usage, '-o - holds one sheet; --sheet each and --paper '// &
                    'make several files of svg')
            else if (request%format == 'nc' .and. is_one_of(request%units, 'FEET M')) then
                call fail(error, cause%usage, '--units: NC machines know in and mm')
            else if (request%has_depth .and. .not. settings%depth < 0.0_dp) then
                call fail(error, cause%usage, '--depth is below 0, which is the top of the stock')
            else if (settings%has_arcs .and. settings%is_in_space) then
                call fail(error, cause%usage, '--arcs are in the plane of a cut; --3d is not')
            else if (settings%angle > 90.0_dp) then
                call fail(error, cause%usage, '--angle is 90 degrees at most')
            end if
        end associate
    end subroutine check_request

    !> Settles a request for a deck: its units, and what was not said.
    !>
    !> Fails with `cause%usage` where the deck's unit is not known.
    pure subroutine settle_request(request, deck_units, factor, error)
        type(request_type), intent(inout) :: request        !! gets units and defaults
        character(*), intent(in) :: deck_units              !! INCHES, MM or FEET
        real(dp), intent(out) :: factor                     !! units of the file in one of the deck
        type(error_type), allocatable, intent(out) :: error !! see above
        type(unit_type) :: of_deck, of_file
        real(dp) :: step
        integer :: i, k

        if (request%units == '') then
            request%units = deck_units
            if (request%format == 'nc' .and. deck_units == 'FEET') request%units = 'INCHES'
            if (request%format == 'csv') request%units = 'M'
        end if
        call find_unit(deck_units, of_deck, error)
        if (.not. allocated(error)) call find_unit(request%units, of_file, error)
        if (allocated(error)) return
        factor = of_file%inch/of_deck%inch
        i = max(1, findloc(['INCHES', 'MM    ', 'FEET  '], deck_units, 1))
        if (.not. request%has_tolerance) then
            request%tolerance = usual_tolerance(i)
            if (is_one_of(request%format, 'stl obj')) request%tolerance = &
                mesh_times*request%tolerance
        end if
        if (.not. request%bevel_step > 0.0_dp) request%bevel_step = usual_bevel_step(i)
        request%settings%tolerance = factor*request%tolerance
        request%settings%bevel_step = factor*request%bevel_step
        k = merge(2, 1, of_file%is_metric)
        step = of_file%inch
        if (of_file%is_metric) step = of_file%inch/25.4_dp
        associate (s => request%settings)
            if (.not. s%overlap > 0.0_dp) s%overlap = step*usual_overlap(k)
            if (.not. s%feed > 0.0_dp) s%feed = step*usual_feed(k)
            if (.not. request%has_depth) s%depth = step*usual_depth(k)
            if (.not. s%safe > 0.0_dp) s%safe = step*usual_safe(k)
        end associate
    end subroutine settle_request

    !> The tolerance of fitted curves, deck units.
    pure real(dp) function curve_tolerance(request) result(tolerance)
        type(request_type), intent(in) :: request !! settled
        tolerance = request%tolerance
        if (is_one_of(request%format, 'iges step') .or. request%settings%has_splines) return
        tolerance = curve_part*tolerance
    end function curve_tolerance

end module app_export_request
