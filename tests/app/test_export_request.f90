!> What `loft export` is asked for: formats by ending, options with and without their format, units
!> and what holds where nothing is said.
program test_export_request
    use app_export_request, only: curve_tolerance, read_request, request_type, settle_request
    use app_options, only: options_type, read_options
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use support_command_line, only: options_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_endings()
    call check_settings()
    call check_formats()
    call check_combinations()
    call check_units()
    call check_defaults()
    call check_curves()
    call tap%finish()

contains

    !> Endings in any case, a format said, none of both.
    subroutine check_endings()
        character(5), parameter :: endings(15) = ['svg  ', 'pdf  ', 'dxf  ', 'igs  ', 'iges ', &
            'step ', 'stp  ', 'stl  ', 'obj  ', 'nc   ', 'ngc  ', 'gcode', 'hrm  ', 'wgs  ', &
            'csv  ']
        character(4), parameter :: formats(15) = ['svg ', 'pdf ', 'dxf ', 'iges', 'iges', 'step', &
            'step', 'stl ', 'obj ', 'nc  ', 'nc  ', 'nc  ', 'hrm ', 'wgs ', 'csv ']
        integer :: i

        do i = 1, size(endings)
            call tap%same(format_of('a|-o|b.'//trim(endings(i))), trim(formats(i)), &
                'ending '//endings(i))
        end do
        call tap%same(format_of('a|-o|x.y/b.STP'), 'step', 'in capitals')
        call tap%same(format_of('a|-o|b.Svg'), 'svg', 'in both')
        call tap%same(format_of('a|-o|b.svg.pdf'), 'pdf', 'the last ending counts')
        call tap%same(format_of('a|-o|b.txt|--format|nc'), 'nc', 'what is said counts more')
        call tap%same(format_of('a|-o|-|--format|csv'), 'csv', 'standard output has what is said')
        call refused('export|a|-o|b.txt', '-o b.txt: its ending says no format; endings: .svg '// &
            '.pdf .dxf .igs .iges .step .stp .stl .obj .nc .ngc .gcode .hrm .wgs .csv', &
            'another ending')
        call refused('export|a|-o|svg', '-o svg: its ending says', 'none, though it is one')
        call refused('export|a|-o|x.svg/y', '-o x.svg/y: its ending says', 'that of a folder')
        call refused('export|a|-o|b.', '-o b.: its ending says', 'a point alone')
        call refused('export|a|-o|b.IGS IGES', '-o b.IGS IGES: its ending says', 'two in one')
        call refused('export|a|-o|-', '-o - is standard output; --format says what goes there', &
            'standard output without a format')
    end subroutine check_endings

    !> Options come to their settings.
    subroutine check_settings()
        type(request_type) :: request
        integer :: i

        request = request_of('export|a|-o|b.dxf|--half|--3d|--dxf-splines|--tolerance|.01'// &
            '|--cut| 4,FLOOR,,|--cut|x')
        call tap%ok(request%settings%is_half .and. request%settings%is_in_space .and. &
            request%settings%has_splines .and. .not. request%settings%is_each, 'flags')
        call tap%near(request%tolerance, 0.01_dp, 0.0_dp, 'the tolerance is in deck units')
        call tap%same(request%cuts(1)%text//'|'//request%cuts(2)%text//'|'//request%cuts(3)%text, &
            '4|FLOOR|x', 'cuts by lists and several times')
        call tap%ok(size(request%cuts) == 3, 'nothing between two commas is no cut')
        request = request_of('export|a|-o|b.pdf|--paper|roll|36|--overlap|1')
        call tap%same(request%settings%paper, 'roll', 'paper')
        call tap%near(request%settings%roll_width + request%settings%overlap, 37.0_dp, 0.0_dp, &
            'width and overlap')
        call tap%ok(request%settings%is_each, 'PDF has a sheet for each')
        request = request_of('export|a|-o|b.pdf|--sheet|all')
        call tap%ok(.not. request%settings%is_each, 'or what is said')
        request = request_of('export|a|-o|b.svg|--sheet|each')
        call tap%ok(request%settings%is_each, 'so has SVG')
        request = request_of('export|a|-o|b.stl|--binary|--open|--angle|5')
        call tap%ok(request%settings%is_binary .and. request%settings%is_open .and. &
            nint(request%settings%angle) == 5, 'meshes')
        request = request_of('export|a|-o|b.nc|--arcs')
        call tap%ok(request%settings%has_arcs, 'arcs')
        request = request_of('export|a|-o|b.igs|--iges-conics')
        call tap%ok(request%settings%has_conics, 'conics')
        request = request_of('export|a|-o|b.nc|--feed|1|--depth|-2|--safe|3')
        call tap%ok(all(nint([request%settings%feed, request%settings%depth, &
            request%settings%safe]) == [1, -2, 3]), 'feed, depth and height')
        request = request_of('export|a|-o|b.wgs')
        call tap%ok(size(request%cuts) == 0 .and. request%units == '', 'nothing said')
        do i = 1, 4
            request = request_of('export|a|-o|b.wgs|--units|'//trim(unit_word(i)))
            call tap%same(request%units, trim(unit_name(i)), '--units '//unit_word(i))
        end do
    end subroutine check_settings

    !> Options that do not go with a format.
    subroutine check_formats()
        call refused('export|a|-o|b.svg|--3d', '--3d does not go with svg, but with: dxf', &
            'space on paper')
        call refused('export|a|-o|b.step|--paper|a4', &
            '--paper does not go with step, but with: svg pdf', 'STEP on paper')
        call refused('export|a|-o|b.dxf|--angle|1', &
            '--angle does not go with dxf, but with: stl obj hrm wgs csv', 'an angle of curves')
        call refused('export|a|-o|b.obj|--binary', '--binary does not go with obj, but with: stl', &
            'a binary OBJ')
        call refused('export|a|-o|b.csv|--units|m', '--units does not go with csv', &
            'a unit of CPACS, which has but one')
        call refused('export|a|-o|b.svg|--arcs', '--arcs does not go with svg, but with: dxf nc', &
            'arcs on paper')
        call refused('export|a|-o|b.stl|--cut|1', &
            '--cut does not go with stl, but with: svg pdf dxf iges step nc', 'cuts of a mesh')
    end subroutine check_formats

    !> Options that do not go together, and values that can't be.
    subroutine check_combinations()
        call refused('export|a|-o|b.pdf|--overlap|1', '--overlap goes with --paper', &
            'an overlap of one sheet')
        call refused('export|a|-o|-|--format|svg|--sheet|each', '-o - holds one sheet', &
            'sheets on standard output')
        call refused('export|a|-o|-|--format|svg|--paper|a4', '-o - holds one sheet', &
            'tiles on standard output')
        call tap%same(format_of('a|-o|-|--format|pdf|--paper|a4'), 'pdf', 'but of PDF')
        call refused('export|a|-o|b.nc|--units|ft', '--units: NC machines know in and mm', &
            'a machine in feet')
        call refused('export|a|-o|b.nc|--depth|.1', '--depth is below 0', 'a cut in the air')
        call refused('export|a|-o|b.nc|--depth|0', '--depth is below 0', 'no depth')
        call refused('export|a|-o|b.dxf|--arcs|--3d', '--arcs are in the plane of a cut', &
            'arcs in space')
        call refused('export|a|-o|b.stl|--angle|91', '--angle is 90 degrees at most', &
            'a mesh of nothing')
    end subroutine check_combinations

    !> The unit of the file, and the way there.
    subroutine check_units()
        call has_factor('INCHES', 'mm', 25.4_dp)
        call has_factor('INCHES', 'm', 0.0254_dp)
        call has_factor('INCHES', 'ft', 1.0_dp/12.0_dp)
        call has_factor('INCHES', 'in', 1.0_dp)
        call has_factor('MM', 'in', 1.0_dp/25.4_dp)
        call has_factor('MM', 'm', 1.0e-3_dp)
        call has_factor('FEET', 'in', 12.0_dp)
        call has_factor('FEET', 'mm', 304.8_dp)
        call has_factor('FEET', 'm', 0.3048_dp)
    end subroutine check_units

    !> What holds where nothing is said.
    subroutine check_defaults()
        call settles('a.pdf', 'INCHES', 'INCHES', [1.0e-3_dp, 6.0_dp, 0.5_dp])
        call settles('a.pdf', 'MM', 'MM', [2.5e-2_dp, 150.0_dp, 12.0_dp])
        call settles('a.pdf', 'FEET', 'FEET', [8.0e-5_dp, 0.5_dp, 0.5_dp/12.0_dp])
        call settles('a.pdf|--units|mm', 'INCHES', 'MM', [0.0254_dp, 152.4_dp, 12.0_dp])
        call settles('a.pdf|--units|m', 'MM', 'M', [2.5e-5_dp, 0.15_dp, 0.012_dp])
        call settles('a.pdf|--units|mm|--tolerance|1|--bevel|2|--paper|a4|--overlap|5', 'INCHES', &
            'MM', [25.4_dp, 50.8_dp, 5.0_dp])
        call settles('a.stl', 'INCHES', 'INCHES', [1.0e-2_dp, 6.0_dp, 0.5_dp])
        call settles('a.obj|--tolerance|.001', 'MM', 'MM', [1.0e-3_dp, 150.0_dp, 12.0_dp])
        call settles('a.csv', 'MM', 'M', [2.5e-5_dp, 0.15_dp, 0.012_dp])
        call settles('a.nc', 'FEET', 'INCHES', [9.6e-4_dp, 6.0_dp, 0.5_dp])
    end subroutine check_defaults

    !> What of the tolerance fitted curves may take.
    subroutine check_curves()
        type(request_type) :: request
        request = request_of('export|a|-o|b.nc|--tolerance|1')
        call tap%near(curve_tolerance(request), 0.1_dp, 1.0e-15_dp, 'chords have most of it')
        request = request_of('export|a|-o|b.igs|--tolerance|1')
        call tap%near(curve_tolerance(request), 1.0_dp, 0.0_dp, 'splines have all of it')
        request = request_of('export|a|-o|b.dxf|--tolerance|1|--dxf-splines')
        call tap%near(curve_tolerance(request), 1.0_dp, 0.0_dp, 'in DXF too')
    end subroutine check_curves

    !> Counts the checks of a request settled for a deck.
    subroutine settles(rest, deck_units, units, expected)
        character(*), intent(in) :: rest        !! of the command line
        character(*), intent(in) :: deck_units  !! of the deck
        character(*), intent(in) :: units       !! of the file
        real(dp), intent(in) :: expected(3)     !! tolerance, way between bevels, overlap
        type(request_type) :: request
        type(error_type), allocatable :: error
        real(dp) :: factor

        request = request_of('export|a|-o|'//rest)
        call settle_request(request, deck_units, factor, error)
        call tap%same(request%units, units, rest//' of '//deck_units)
        call tap%ok(all(abs([request%settings%tolerance, request%settings%bevel_step, &
            request%settings%overlap] - expected) <= 1.0e-12_dp*expected), 'its lengths: '//rest)
    end subroutine settles

    !> Counts the check of a factor.
    subroutine has_factor(deck_units, word, expected)
        character(*), intent(in) :: deck_units  !! of the deck
        character(*), intent(in) :: word        !! of the file, as an option
        real(dp), intent(in) :: expected        !! units of the file in one of the deck
        type(request_type) :: request
        type(error_type), allocatable :: error
        real(dp) :: factor

        request = request_of('export|a|-o|b.stl|--units|'//word)
        call settle_request(request, deck_units, factor, error)
        call tap%near(factor, expected, 2.0_dp*spacing(expected), deck_units//' as '//word)
    end subroutine has_factor

    !> A unit as an option, by number.
    pure function unit_word(number) result(word)
        integer, intent(in) :: number !! 1 to 4
        character(2) :: word
        character(2), parameter :: words(4) = ['in', 'mm', 'ft', 'm ']
        word = words(number)
    end function unit_word

    !> Its name.
    pure function unit_name(number) result(name)
        integer, intent(in) :: number !! 1 to 4
        character(6) :: name
        character(6), parameter :: names(4) = ['INCHES', 'MM    ', 'FEET  ', 'M     ']
        name = names(number)
    end function unit_name

    !> The format of an export.
    function format_of(rest) result(format)
        character(*), intent(in) :: rest !! of the command line
        character(:), allocatable :: format
        type(request_type) :: request
        request = request_of('export|'//rest)
        format = request%format
    end function format_of

    !> The request of a command line that is in order.
    function request_of(line) result(request)
        character(*), intent(in) :: line !! see `words_of`
        type(request_type) :: request
        type(error_type), allocatable :: error
        call read_request(options_of(line, tap), request, error)
        if (allocated(error)) call tap%ok(.false., line//': '//error%message)
    end function request_of

    !> A command line that is refused, and how what is said begins.
    subroutine refused(line, expected, name)
        character(*), intent(in) :: line     !! see `words_of`
        character(*), intent(in) :: expected !! the message, or its beginning
        character(*), intent(in) :: name     !! what is wrong
        type(options_type) :: options
        type(request_type) :: request
        type(error_type), allocatable :: error
        call read_options(words_of(line), options, error)
        if (.not. allocated(error)) call read_request(options, request, error)
        call tap%ok(allocated(error), 'refused: '//name)
        if (.not. allocated(error)) return
        if (index(error%message, expected) /= 1) call tap%note(error%message)
        call tap%ok(index(error%message, expected) == 1 .and. error%cause == cause%usage, &
            'and it is said: '//name)
    end subroutine refused

end program test_export_request
