!> LINE and its data cards.
program test_job_line
    use base_decimal, only: to_real
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_body_layout, only: body_card
    use deck_job, only: ending, job_type, origin, piece, piece_real, view
    use deck_job_line, only: is_data_card
    use support_job_deck, only: faults_of, job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults

    call all_pieces()
    call options()
    call origins()
    call bad_pieces()
    call bad_lines()
    call points()
    call bad_points()
    call tap%ok(all(is_data_card([body_card%conic, body_card%point])) .and. &
        .not. any(is_data_card([body_card%line, body_card%section])), &
        'data cards are told from others')
    call tap%finish()

contains

    !> One line with a piece of each kind; the numbers are 1, 2, 3 ... but for rho.
    subroutine all_pieces()
        integer, parameter :: numbers(9) = [8, 7, 8, 7, 9, 10, 4, 6, 5]
        integer :: i, j, wrong

        call job_of('LINE    A       SIDE|1.      2.      3.      4.      5.      6.      7.  '// &
            '    8.|'// &
            'RHO     1.      2.      3.      4.      5.      6.      .7|'// &
            'TANGENT 1.      2.      3.      4.      5.      6.      7.      8.|'// &
            'TANRHO  1.      2.      3.      4.      5.      6.      .7|'// &
            'FOURPT  1.      2.      3.      4.      5.      6.      7.      8.      9.|'// &
            'FIVEPT  1.      2.      3.      4.      5.      6.      7.      8.      9.|+     '// &
            '  10.|'// &
            'STRAIGHT1.      2.      3.      4.|CIRCLE  1.      2.      3.      4.      5.    '// &
            '  6.|'// &
            'RADIUS  1.      2.      3.      4.      5.', job, faults)
        call tap%ok(.not. faults%has_errors(0), 'a line of all pieces is read')
        associate (side => job%body(1)%line(1)%view(view%side))
            call tap%ok(side%is_sound .and. side%origin == origin%pieces, 'it is sound')
            call tap%ok(all(side%piece%kind == [piece%conic, piece%rho, piece%tangent, &
                piece%tangent_rho, &
                piece%four_points, piece%five_points, piece%straight, piece%circle, &
                piece%radius]), 'each card is a piece of its kind')
            call tap%ok(all([(size(side%piece(i)%value) == numbers(i), i = 1, 9)]), &
                'with all its numbers')
            wrong = 0
            do i = 1, 9
                do j = 1, numbers(i)
                    if (.not. any(is_equal(piece_real(side%piece(i), j), [real(j, dp), 0.7_dp]))) &
                        wrong = wrong + 1
                end do
            end do
            call tap%ok(wrong == 0, 'in their order')
            call tap%ok(side%piece(1)%first_field == 1 .and. all(side%piece(2:)%first_field == 2), &
                'and it is known where they stand')
            call tap%ok(side%piece(7)%card%sheet(1)%line == 9, 'and on which line')
        end associate
    end subroutine all_pieces

    subroutine options()
        call job_of('LINE,A,PLAN|STRAIGHT,0,0,1,1|1,1,0,2,2,3,3,1,DXDY,KNUCKLE|'// &
            '3,3,1,,,5,4,0,MATCH,DXDY1|RHO,5,4,0,7,7,1,.5,DXDY3|FOURPT,7,7,1,8,8,9,8,10,9|'// &
            '+,LAST,DXDY', &
            job, faults)
        call tap%ok(.not. faults%has_errors(0), 'options are read')
        associate (p => job%body(1)%line(1)%view(view%plan)%piece)
            call tap%ok(.not. (any(p(1)%is_inverse) .or. p(1)%is_knuckle .or. p(1)%is_match), &
                'no options')
            call tap%ok(all(p(2)%is_inverse) .and. p(2)%is_knuckle .and. .not. p(2)%is_match, &
                'DXDY KNUCKLE')
            call tap%ok(all(p(3)%is_inverse .eqv. [.true., .false.]) .and. p(3)%is_match, &
                'MATCH DXDY1')
            call tap%ok(all(p(4)%is_inverse .eqv. [.false., .true.]), 'DXDY3')
            call tap%ok(p(5)%is_slope_last .and. all(p(5)%is_inverse), &
                'LAST DXDY on a continuation')
        end associate
    end subroutine options

    subroutine origins()
        call job_of('LINE,A,SIDE,-16.|LINE,B,SIDE,A|LINE,B,ANGLE,95|LINE,A,PLAN|STRAIGHT,0,0,1,1', &
            job, faults)
        call tap%ok(size(job%body(1)%line) == 2, 'views of one name are of one line')
        associate (a => job%body(1)%line(1)%view, b => job%body(1)%line(2)%view)
            call tap%ok(a(view%side)%origin == origin%constant .and. &
                a(view%side)%constant%digits == -16, 'a constant')
            call tap%ok(b(view%side)%origin == origin%line .and. b(view%side)%line == 1 .and. &
                b(view%side)%is_sound, 'a view taken over')
            call tap%ok(b(view%angle)%origin == origin%constant, 'an angle')
            call tap%ok(b(view%plan)%origin == origin%none .and. &
                a(view%plan)%origin == origin%pieces, 'each view is its own')
        end associate
    end subroutine origins

    !> What is found wrong, in a line that begins with a straight piece on line 2.
    subroutine same(cards, words, name)
        character(*), intent(in) :: cards
        character(*), intent(in) :: words
        character(*), intent(in) :: name
        call tap%same(faults_of('LINE,A,SIDE|STRAIGHT,0,0,1,1|'//cards), words, name)
        call job_of('LINE,A,SIDE|STRAIGHT,0,0,1,1|'//cards, job, faults)
        call tap%ok(.not. job%body(1)%line(1)%view(view%side)%is_sound, name// &
            ' makes its line unsound')
    end subroutine same

    subroutine bad_pieces()
        call same('RHO,1,1,1,2,2,1,1.', &
            '3:17-18 error: rho is above 0 and below 1; below .5 an '// &
            'ellipse, .5 a parabola|', 'rho of 1')
        call same('TANRHO,1,1,1,2,2,1,0', &
            '3:20-20 error: rho is above 0 and below 1; below .5 an '// &
            'ellipse, .5 a parabola|', 'rho of 0')
        call same('RADIUS,1,1,2,2,0', '3:16-16 error: the radius is zero|', 'a radius of zero')
        call same('1,1,1,,,2,2,1,MATCH,KNUCKLE', &
            '3:15-19 error: KNUCKLE and MATCH exclude each other|', 'KNUCKLE and MATCH')
        call same('CIRCLE,1,1', '3:11-11 error: X2 Y2 X3 Y3 are missing (zero is written 0.)|', &
            'a card cut short')
        call same('CIRCEL,1,1,2,2,3,4', &
            '3:1-6 error: CIRCEL begins no card (see loft help cards); did '// &
            'you mean CIRCLE?|', 'a data card misspelt')
        call tap%same(faults_of('LINE,A,SIDE|1,1,1,,,2,2,1,MATCH'), &
            '2:15-19 error: MATCH on the first '// &
            'card of a line; there is no neighbour before it|', 'MATCH on the first card')
        call tap%ok(index(faults_of('LINE,A,SIDE|STRAIGHT,0,0,1,1,KNUCKLE'), &
            '2:18-24 warning: ') == 1, 'KNUCKLE on the first card is warned of')
    end subroutine bad_pieces

    subroutine bad_lines()
        call tap%same(faults_of('LINE,A,SIDE|LINE,B,SIDE,1'), &
            '1:6-6 error: a LINE without data; its '// &
            'conics or points follow on data cards, or field 4 names another line or a constant|', &
            'a LINE without data')
        call tap%same(faults_of('LINE,A,SIDE,1|LINE,A,SIDE,2'), &
            '2:6-6 error: A has its SIDE already; '// &
            'all data cards of a view follow one LINE card|', 'a view twice')
        call tap%same(faults_of('LINE,A,SIDE,1|STRAIGHT,0,0,1,1'), &
            '2:1-8 error: a data card under a '// &
            'LINE that is taken from field 4 of its card|', 'data under a constant')
        call tap%same(faults_of('LINE,A,SIED|STRAIGHT,0,0,1'), &
            '1:8-11 error: VIEW is SIDE, PLAN or '// &
            'ANGLE, not SIED; did you mean SIDE?|2:15-15 error: Y3 is missing: last point '// &
            '(zero is '// &
            'written 0.)|', 'data under a bad LINE are looked at')
    end subroutine bad_lines

    !> Lines by points.
    subroutine points()
        call job_of('LINE,A,SIDE,SPLINE,UNIFORM|0,0,999.999|1,2|3,4,PARABOLA|'// &
            'LINE,A,PLAN,SPLINE|0,0|1,2,FREE|LINE,B,SIDE,BEZIER|1,2|3,4', job, faults)
        call tap%ok(.not. faults%has_errors(0), 'lines by points are read')
        associate (a => job%body(1)%line(1)%view, b => job%body(1)%line(2)%view(view%side))
            call tap%ok(a(view%side)%origin == origin%spline .and. a(view%side)%is_uniform .and. &
                .not. a(view%plan)%is_uniform, 'a spline, uniform or by chords')
            call tap%ok(all(a(view%side)%piece%kind == piece%point) .and. &
                size(a(view%side)%piece) == 3, 'its cards are points')
            call tap%ok(all(a(view%side)%piece%ending == &
                [ending%slope, ending%free, ending%parabola]), 'what is asked at its ends')
            call tap%ok(all(a(view%plan)%piece%ending == ending%free), 'nothing said is free')
            call tap%ok(is_equal(piece_real(a(view%side)%piece(1), 3), 999.999_dp), 'a slope')
            call tap%ok(b%origin == origin%bezier .and. &
                is_equal(piece_real(b%piece(2), 2), 4.0_dp), 'poles')
        end associate
        call job_of('LINE,A,SIDE,FAIR|0,0|1,2,0|3,4|LINE,A,PLAN,FAIR,2.5|0,0|1,2', job, faults)
        call tap%ok(.not. faults%has_errors(0), 'faired lines are read')
        associate (a => job%body(1)%line(1)%view)
            call tap%ok(all(a(:view%plan)%origin == origin%fair), '... as faired')
            call tap%ok(is_equal(to_real(a(view%side)%weight), 10.0_dp) .and. &
                is_equal(to_real(a(view%plan)%weight), 2.5_dp), 'weights, the usual one is 10')
            call tap%ok(all(a(view%side)%piece%ending == &
                [ending%free, ending%weight, ending%free]) .and. &
                is_equal(piece_real(a(view%side)%piece(2), 3), 0.0_dp), 'weights of points')
        end associate
    end subroutine points

    !> What is wrong with points.
    subroutine bad_points()
        call tap%same(faults_of('LINE,A,SIDE,SPLINE|0,0|1,2,.5|3,4'), &
            '3:5-6 error: END at a point inside; it is for the first and the last point of a '// &
            'spline|', 'a slope inside')
        call tap%same(faults_of('LINE,A,SIDE,SPLINE|0,0,CLAMP|3,4'), &
            '2:5-9 error: END is a slope, FREE or PARABOLA|', 'an end of no kind')
        call tap%same(faults_of('LINE,A,SIDE,BEZIER|0,0,.5|3,4'), &
            '2:5-6 error: a pole has no slope; the curve begins and ends along the sides of '// &
            'its polygon|', 'a pole with a slope')
        call tap%same(faults_of('LINE,A,SIDE,SPLINE|0,0|RHO,1,1,1,2,2,1,.5'), &
            '3:1-3 error: a conic under a LINE by points; a composite line is given by conics '// &
            'alone|', 'a conic among points')
        call tap%same(faults_of('LINE,A,SIDE,SPLINE|0,|3,4,,7'), '2:3-3 error: Y is missing: '// &
            'of a point or pole; under FAIRED the WL (zero is written 0.)|'// &
            '3:6-6 error: a number behind the last field of the card, which is field 3; a '// &
            'comma ends a field, and decimals have a point: 22.5|', &
            'a point cut short, and one too long')
        call tap%same(faults_of('LINE,A,SIDE,SPLINE'), '1:6-6 error: a LINE without data; its '// &
            'conics or points follow on data cards, or field 4 names another line or a constant|', &
            'a spline without points')
        call tap%same(faults_of('LINE,A,SIDE,FAIR,0.|0,0|1,2,-1.|3,4'), '1:18-19 error: the '// &
            'weight of a FAIR line is above zero|3:5-7 error: a weight is zero or above|', &
            'weights that are none')
        call tap%same(faults_of('LINE,A,SIDE,FAIR,CHORD|0,0|1,2,FREE|3,4,2.'), '1:18-22 error: '// &
            'the weight of a FAIR line is a number|3:5-8 error: behind a point to be '// &
            'faired stands its weight|4:5-6 warning: a weight at an end of a FAIR line says '// &
            'nothing: the line is held there|', 'words in place of weights')
        call tap%same(faults_of('LINE,A,SIDE,SPLINE,UNIFROM|0,0|3,4'), '1:20-26 error: PARAM '// &
            'is CHORD or UNIFORM, not UNIFROM; did you mean UNIFORM?|', 'a parameter misspelt')
        call tap%ok(index(faults_of('LINE,A,SIDE,3.,CHORD'), '1:16-20 warning: PARAM') == 1, &
            'a parameter without a spline is warned of')
        call tap%ok(index(faults_of('LINE,A,SIDE,SPLIEN|0,0|3,4'), '1:13-18 error: there is no '// &
            'LINE SPLIEN; did you mean SPLINE?|') == 1, 'SPLINE misspelt')
    end subroutine bad_points

end program test_job_line
