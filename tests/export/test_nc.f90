!> Tests of NC programs as wholes. Oracles: circles in closed form, read back by a little
!> interpreter of its own.
program test_nc
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: to_text
    use export_drawing, only: drawing_type, shape_type
    use export_nc, only: write_nc
    use export_receipt, only: receipt_type
    use export_settings, only: settings_type
    use support_sketch, only: add_contour, add_shape, ellipse, new_drawing, new_shape, segment
    use support_tap, only: tap_type
    implicit none (type, external)
    character, parameter :: nl = new_line('a')
    type(tap_type) :: tap

    !> What an interpreter has seen.
    type :: seen_type
        integer :: rapids = 0               !! moves at safe height
        integer :: cuts = 0                 !! moves at depth
        logical :: is_safe = .true.         !! no rapid move below safe height, no move without feed
        real(dp) :: off = 0.0_dp            !! largest distance of a corner from the circles
        real(dp) :: miss = 0.0_dp           !! largest distance of the middle of a chord from them
        real(dp) :: first_radius = 0.0_dp   !! of the first cut
    end type seen_type

    call check_ring('INCHES', 1.0_dp, 1.0e-3_dp)
    call check_ring('MM', 25.4_dp, 0.02_dp)
    call check_ring('INCHES', 1.0_dp, 1.0e-6_dp)
    call check_words()
    call check_arcs()
    call check_several()
    call check_refusals()
    call tap%finish()

contains

    !> A ring: the outside has a radius of 10 inches, the inside 9.
    subroutine ring(units, inch, tolerance, drawing, settings)
        character(*), intent(in) :: units               !! of the drawing
        real(dp), intent(in) :: inch                    !! how many an inch has
        real(dp), intent(in) :: tolerance               !! of the settings
        type(drawing_type), intent(out) :: drawing      !! one cut
        type(settings_type), intent(out) :: settings    !! of NC
        type(shape_type) :: shape

        drawing = new_drawing(tolerance)
        drawing%units = units
        shape = new_shape('STA-20', 20.0_dp*inch)
        call add_contour(shape, ellipse(shape%plane, [0.0_dp, 0.0_dp], [10.0_dp, 10.0_dp]*inch))
        call add_contour(shape, ellipse(shape%plane, [0.0_dp, 0.0_dp], [9.0_dp, 9.0_dp]*inch))
        shape%contours(2)%is_inside = .true.
        call add_shape(drawing, shape)
        settings%tolerance = tolerance
        settings%feed = 20.0_dp
        settings%safe = 0.25_dp*inch
        settings%depth = -0.125_dp*inch
    end subroutine ring

    subroutine check_ring(units, inch, tolerance)
        character(*), intent(in) :: units       !! of the drawing
        real(dp), intent(in) :: inch            !! how many an inch has
        real(dp), intent(in) :: tolerance       !! of the settings
        type(drawing_type) :: drawing
        type(settings_type) :: settings
        type(output_type) :: out
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        type(seen_type) :: seen
        character(:), allocatable :: name

        call ring(units, inch, tolerance, drawing, settings)
        call write_nc(drawing, settings, out, receipt, error)
        name = units//', '//to_text(nint(-log10(tolerance)))//' decimals: '
        call tap%ok(.not. allocated(error), name//'a ring is written')
        call run_program(out%text(), [9.0_dp, 10.0_dp]*inch, seen)
        call tap%ok(seen%is_safe, name//'no rapid move in the stock, no cut without feed')
        call tap%ok(seen%off <= tolerance, name//'corners are on the circles')
        call tap%ok(seen%miss <= tolerance, name//'chords stay within the tolerance')
        call tap%ok(max(seen%off, seen%miss) <= 1.01_dp*maxval(receipt%entities(:2)%error), &
            name//'the receipt does not promise more')
        call tap%near(seen%first_radius, 9.0_dp*inch, tolerance, name//'the inside comes first')
        call tap%ok(receipt%count == 2 .and. seen%cuts == sum(receipt%entities(:2)%points) + 2, &
            name//'as many moves as the receipt has points, and back, and two plunges less')
    end subroutine check_ring

    !> Runs a program of straight pieces.
    subroutine run_program(text, radii, seen)
        character(*), intent(in) :: text        !! the program
        real(dp), intent(in) :: radii(:)        !! of circles about the origin
        type(seen_type), intent(out) :: seen    !! what it does
        real(dp) :: at(3), to(3), feed, middle(2)
        character(:), allocatable :: line
        integer :: first, length

        at = [0.0_dp, 0.0_dp, 1.0_dp]
        feed = 0.0_dp
        first = 1
        do while (first <= len(text))
            length = index(text(first:), nl) - 1
            line = text(first:first + length - 1)
            first = first + length + 1
            if (index(line, 'G0 ') /= 1 .and. index(line, 'G1 ') /= 1) cycle
            to = [number_behind(line, 'X', at(1)), number_behind(line, 'Y', at(2)), &
                number_behind(line, 'Z', at(3))]
            feed = number_behind(line, 'F', feed)
            if (line(2:2) == '0') then
                seen%rapids = seen%rapids + 1
                seen%is_safe = seen%is_safe .and. (to(3) > 0.0_dp .and. (at(3) > 0.0_dp .or. &
                    all(abs(to(:2) - at(:2)) <= 0.0_dp)))
            else
                seen%cuts = seen%cuts + 1
                seen%is_safe = seen%is_safe .and. feed > 0.0_dp .and. to(3) < 0.0_dp
                if (seen%cuts == 1) seen%first_radius = norm2(to(:2))
                middle = 0.5_dp*(to(:2) + at(:2))
                seen%off = max(seen%off, minval(abs(norm2(to(:2)) - radii)))
                seen%miss = max(seen%miss, minval(abs(norm2(middle) - radii)))
            end if
            at = to
        end do
    end subroutine run_program

    !> The number behind a letter in a block, or another where there is none.
    real(dp) function number_behind(line, letter, otherwise) result(number)
        character(*), intent(in) :: line        !! the block
        character, intent(in) :: letter         !! X, Y...
        real(dp), intent(in) :: otherwise       !! see above
        integer :: first, last
        number = otherwise
        first = index(line, ' '//letter)
        if (first == 0) return
        last = first + index(line(first + 2:)//' ', ' ')
        read (line(first + 2:last), *) number
    end function number_behind

    subroutine check_words()
        type(drawing_type) :: drawing
        type(settings_type) :: settings
        type(output_type) :: out, again
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        character(:), allocatable :: text
        integer :: first, length, longest

        call ring('INCHES', 1.0_dp, 1.0e-3_dp, drawing, settings)
        drawing%title = 'NOSE (REV. B) '//repeat('OF A LONG NAME ', 9)
        call write_nc(drawing, settings, out, receipt, error)
        text = out%text()
        call tap%ok(text(:2) == '%'//nl .and. text(len(text) - 5:) == 'M30'//nl//'%'//nl, &
            'the program stands between signs of per cent and ends with M30')
        call tap%has(text, nl//'G20'//nl//'G17 G90 G94 G40 G49 G80'//nl//'G0 Z0.2500'//nl, &
            'unit, safe start, and up before anything else')
        call tap%has(text, nl//'(DECK SKETCH.CRD)'//nl//'(TITLE NOSE -REV. B- OF', &
            'deck and title')
        call tap%has(text, nl//'(WITHIN 0.001 IN OF THE EXACT SHAPE)'//nl, 'the tolerance')
        call tap%has(text, nl//'(CUT 1 STATION STA-20)'//nl//'(1 PIECE, X IS BL, Y IS WL)'//nl// &
            '(INSIDE OF THE SKIN)'//nl, 'which cut, how many pieces, what X and Y are, which side')
        call tap%has(text, nl//'M5'//nl//'(NEXT THE OUTSIDE OF THE SKIN - '// &
            'START THE SPINDLE AGAIN)'//nl//'M0'//nl//'(OUTSIDE OF THE SKIN)'//nl, &
            'and the other side, behind a stop')
        call tap%ok(index(text, '-0.0000') == 0, 'zero has no sign')
        first = 1
        longest = 0
        do while (first <= len(text))
            length = index(text(first:), nl) - 1
            longest = max(longest, length)
            first = first + length + 1
        end do
        call tap%ok(longest <= 79, 'no line is longer than Grbl reads')
        call tap%ok(index(text, nl//'(NEXT PIECE') == 0, 'one cut needs no other stop')
        call write_nc(drawing, settings, again, receipt, error)
        call tap%same(again%text(), text, 'the same drawing gives the same bytes')
    end subroutine check_words

    !> A ring of circular arcs, and beside it a cut without.
    subroutine check_arcs()
        type(drawing_type) :: drawing
        type(settings_type) :: settings
        type(shape_type) :: shape
        type(output_type) :: out
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error

        call ring('INCHES', 1.0_dp, 1.0e-3_dp, drawing, settings)
        drawing%cuts(1)%arcs = 0.01_dp
        shape = new_shape('STA-30', 30.0_dp)
        call add_contour(shape, ellipse(shape%plane, [0.0_dp, 0.0_dp], [10.0_dp, 10.0_dp]))
        call add_shape(drawing, shape)
        call write_nc(drawing, settings, out, receipt, error)
        call tap%ok(.not. allocated(error), 'a ring of arcs is written')
        call tap%has(out%text(), nl//'G0 X9.0000 Y0.0000'//nl//'G1 Z-0.1250 F10.0'//nl// &
            'G3 X0.0000 Y9.0000 I-9.0000 J0.0000 F20.0'//nl// &
            'G3 X-9.0000 Y0.0000 I0.0000 J-9.0000'//nl// &
            'G3 X0.0000 Y-9.0000 I9.0000 J0.0000'//nl// &
            'G3 X9.0000 Y0.0000 I0.0000 J9.0000'//nl//'G0 Z0.2500'//nl, 'as four quarter circles')
        call tap%has(out%text(), nl//'(WITHIN 0.01 IN OF THE EXACT SHAPE)'//nl// &
            '(I AND J LEAD FROM THE START OF AN ARC TO ITS CENTRE)'//nl, &
            'the larger tolerance is said, and what I and J are')
        call tap%has(out%text(), nl//'(CIRCULAR ARCS WITHIN 0.01)'//nl, 'of which cut')
        call tap%same(receipt%entities(1)%kind, 'CLOSED PATH OF ARCS INSIDE', 'the receipt has it')
        call tap%ok(receipt%entities(2)%spans == 4 .and. receipt%entities(2)%points == 4 .and. &
            receipt%entities(2)%error <= 0.01_dp, 'with arcs, points and its error')
        call tap%same(receipt%entities(3)%kind, 'CLOSED PATH', 'a cut without arcs has none')
        drawing%cuts(2)%arcs = 1.0e-4_dp
        call write_nc(drawing, settings, out, receipt, error)
        call tap%has(out%text(), nl//'G3 X0.00000 Y10.00000 I-10.00000 J0.00000 F20.0'//nl, &
            'a small tolerance has more decimals')
    end subroutine check_arcs

    subroutine check_several()
        type(drawing_type) :: drawing
        type(settings_type) :: settings
        type(shape_type) :: shape
        type(output_type) :: out
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error

        call ring('MM', 25.4_dp, 0.02_dp, drawing, settings)
        shape = new_shape('STA-30', 30.0_dp)
        shape%number = 4
        call add_contour(shape, segment([30.0_dp, 1.0_dp, 1.0_dp], [30.0_dp, 1.0_dp, 1.0_dp]))
        call add_contour(shape, segment([30.0_dp, -1.5_dp, 1.0_dp], [30.0_dp, 20000.0_dp, 1.0_dp]))
        call add_shape(drawing, shape)
        call write_nc(drawing, settings, out, receipt, error)
        call tap%has(out%text(), nl//'G21'//nl, 'millimetres are G21')
        call tap%has(out%text(), nl//'M0'//nl//'(CUT 4 STATION STA-30)'//nl, &
            'the machine stops before the next cut')
        call tap%has(out%text(), nl//'G0 X-1.500 Y1.000'//nl//'G1 Z-3.175 F10.0'//nl// &
            'G1 X20000.000 Y1.000 F20.0'//nl//'G0 Z6.350'//nl, 'an open piece is cut once')
        call tap%ok(receipt%count == 3, 'a point is not cut')
        call tap%has(receipt%notes, 'STA-30: an outline that is a point is not cut', &
            'and the receipt says so')
        call tap%ok(index(receipt%notes, 'figures') == 0, 'eight figures are read by all')
        settings%tolerance = 1.0e-4_dp
        call write_nc(drawing, settings, out, receipt, error)
        call tap%has(receipt%notes, 'STA-30: coordinates have more than 8 figures', &
            'more than that is said in the receipt')
        call tap%ok(index(receipt%notes, 'figures') == index(receipt%notes, 'figures', .true.), &
            'once for each cut')
    end subroutine check_several

    subroutine check_refusals()
        type(drawing_type) :: drawing
        type(settings_type) :: settings

        call ring('FEET', 1.0_dp/12.0_dp, 1.0e-4_dp, drawing, settings)
        call refused(drawing, settings, '--units in or --units mm', 'feet')
        call ring('INCHES', 1.0_dp, 1.0e-3_dp, drawing, settings)
        settings%feed = 0.0_dp
        call refused(drawing, settings, '--feed', 'no feed')
        settings%feed = 1.0e6_dp
        call refused(drawing, settings, 'below', 'a feed beyond any machine')
        settings%feed = 10.0_dp
        settings%depth = 0.1_dp
        call refused(drawing, settings, '--depth', 'a depth above the stock')
        settings%depth = -0.1_dp
        settings%safe = 0.0_dp
        call refused(drawing, settings, '--safe', 'a safe height at the top of the stock')
        settings%safe = 1.0_dp
        settings%tolerance = 0.0_dp
        call refused(drawing, settings, 'tolerance', 'no tolerance')
        call ring('INCHES', 1.0e4_dp, 1.0e-3_dp, drawing, settings)
        settings%safe = 1.0_dp
        settings%depth = -1.0_dp
        call refused(drawing, settings, 'less than 100000', 'a coordinate beyond any machine')
        deallocate (drawing%cuts)
        allocate (drawing%cuts(0))
        call refused(drawing, settings, 'nothing to draw', 'a drawing without cuts')
    end subroutine check_refusals

    subroutine refused(drawing, settings, words, name)
        type(drawing_type), intent(in) :: drawing       !! what to write
        type(settings_type), intent(in) :: settings     !! how
        character(*), intent(in) :: words               !! in the message
        character(*), intent(in) :: name                !! of the case
        type(output_type) :: out
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        call write_nc(drawing, settings, out, receipt, error)
        call tap%ok(allocated(error), name//': refused')
        if (.not. allocated(error)) return
        call tap%ok(error%cause == cause%usage, name//': with its cause')
        call tap%has(error%message, words, name//': and says why')
    end subroutine refused

end program test_nc
