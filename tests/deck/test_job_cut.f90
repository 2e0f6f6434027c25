!> Cuts and checks: numbers, steps, limits, the rule of their points.
program test_job_cut
    use base_decimal, only: to_real
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_job, only: axis, check, check_real, cut, cut_real, cut_type, job_type, rule
    use support_job_deck, only: body_text, faults_of, job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults

    call stations()
    call along()
    call planes()
    call points()
    call bad_cuts()
    call checks()
    call tap%finish()

contains

    !> The cuts of a deck with a body on its first six lines.
    subroutine read_cuts(cards)
        character(*), intent(in) :: cards
        call job_of(body_text//cards, job, faults)
    end subroutine read_cuts

    subroutine stations()
        call read_cuts('STATION 0.      30.     5.      FRAMES|STATION 7.5|STATION 5.'// &
            '                      F5|STATION LIST    1.      2.              4.|+       3.|'// &
            'STATION,3,3,1|STATION,9,1,-2')
        call tap%ok(faults%count == 0, 'stations are read')
        associate (c => job%body(1)%cut)
            call tap%ok(all(c%kind == cut%station), 'as stations')
            call tap%ok(c(1)%is_stepped .and. all(is_equal(cut_real(c(1), [1, 2, 3]), [0.0_dp, &
                30.0_dp, 5.0_dp])) .and. c(1)%name == 'FRAMES', 'a range')
            call tap%ok(.not. c(2)%is_stepped .and. size(c(2)%value) == 1 .and. &
                is_equal(cut_real(c(2), 1), 7.5_dp), 'a single one')
            call tap%ok(.not. c(4)%is_stepped .and. size(c(4)%value) == 4, &
                'a list with a blank field')
            call tap%ok(all(is_equal(cut_real(c(4), [1, 2, 3, 4]), [1.0_dp, 2.0_dp, 4.0_dp, &
                3.0_dp])), 'is in the order of the card, continued')
            call tap%ok(c(5)%is_stepped .and. c(6)%is_stepped, 'a range of one, a range forward')
            call tap%ok(all(c%points%kind == rule%number) .and. all(c%points%number == 25), &
                '25 points')
        end associate
        call tap%ok(job%body(1)%cut(3)%name == 'F5', 'a single one with a name')
    end subroutine stations

    subroutine along()
        call read_cuts('BUTTOCK 4.5     0.      20.     5.      KEEL|WATERLN -16.    20.     '// &
            '0.      -5.|'// &
            'BUTTOCK,0,,,,|OBLIQUE 20.     -16.    30.     -6.     2.5     FRAME')
        call tap%ok(faults%count == 1, 'a cut without step is the only fault')
        associate (c => job%body(1)%cut)
            call tap%ok(all(c%kind == [cut%buttock, cut%waterline, cut%oblique]), &
                'each is of its kind')
            call tap%ok(is_equal(cut_real(c(1), 1), 4.5_dp) .and. is_equal(cut_real(c(2), 1), &
                -16.0_dp), 'BL and WL')
            call tap%ok(all(is_equal(cut_real(c(3), [1, 2, 3, 4]), [20.0_dp, -16.0_dp, 30.0_dp, &
                -6.0_dp])), 'two points of STA and WL')
            call tap%ok(is_range(c(1), axis%sta, 0.0_dp, 20.0_dp) .and. is_range(c(2), axis%sta, &
                20.0_dp, &
                0.0_dp) .and. is_range(c(3), axis%sta, 20.0_dp, 30.0_dp), 'limits along STA')
            call tap%ok(all(c%points%kind == rule%step) .and. all(c%points%axis == axis%sta), &
                'their points are stepped along STA')
            call tap%ok(all(is_equal(to_real(c%points%start), [0.0_dp, 20.0_dp, 20.0_dp])) .and. &
                all(is_equal(to_real(c%points%step), [5.0_dp, -5.0_dp, 2.5_dp])), &
                'from FROM by STEP')
            call tap%ok(c(1)%name == 'KEEL' .and. c(2)%name == '' .and. c(3)%name == 'FRAME', &
                'names')
        end associate
    end subroutine along

    !> True where a cut is limited to a range along an axis.
    pure logical function is_range(item, along, from, to)
        type(cut_type), intent(in) :: item
        integer, intent(in) :: along
        real(dp), intent(in) :: from
        real(dp), intent(in) :: to
        associate (limit => item%limit(along))
            is_range = limit%has_from .and. limit%has_to .and. is_equal(to_real(limit%from), &
                from) .and. is_equal(to_real(limit%to), to)
        end associate
    end function is_range

    subroutine planes()
        call read_cuts('PLANE,1,2,3,.6,0,.8|PLANE   1.      2.      3.      .6      0.      '// &
            '.8      0.'// &
            '      9.      1.5|+       CANT|POINTS,WL,1|OBLIQUE,5,0,5,9')
        call tap%ok(faults%count == 0, 'planes are read')
        associate (c => job%body(1)%cut)
            call tap%ok(all(is_equal(cut_real(c(1), [1, 2, 3, 4, 5, 6]), [1.0_dp, 2.0_dp, 3.0_dp, &
                0.6_dp, 0.0_dp, 0.8_dp])), 'point and normal')
            call tap%ok(c(1)%points%kind == rule%number .and. c(1)%points%number == 25 .and. &
                .not. c(1)%limit(axis%sta)%has_from, 'a plane alone has 25 points and no limit')
            call tap%ok(c(2)%points%kind == rule%step .and. is_range(c(2), axis%sta, 0.0_dp, &
                9.0_dp) .and. c(2)%name == 'CANT', 'limit, step and name of a plane')
            call tap%ok(is_range(c(3), axis%wl, 0.0_dp, 9.0_dp) .and. &
                .not. c(3)%limit(axis%sta)%has_from, &
                'an oblique plane at one station is limited along WL')
        end associate
    end subroutine planes

    subroutine points()
        call read_cuts('LIMIT,STA,1,2|POINTS,STA,5|STATION,1|BUTTOCK,0|BUTTOCK,0,7,9,2|'// &
            'LIMIT,BL,3,4|'// &
            'BUTTOCK,0,7,9')
        call tap%ok(faults%count == 0, 'cuts go by the POINTS card before')
        associate (c => job%body(1)%cut)
            call tap%ok(c(1)%points%kind == rule%number, 'a station is not stepped along STA')
            call tap%ok(.not. c(1)%limit(axis%sta)%has_from, 'nor limited along it')
            call tap%ok(c(2)%points%kind == rule%step .and. is_range(c(2), axis%sta, 1.0_dp, &
                2.0_dp) .and. is_equal(to_real(c(2)%points%start), 1.0_dp), 'a buttock is')
            call tap%ok(is_equal(to_real(c(3)%points%step), 2.0_dp) .and. is_range(c(3), axis%sta, &
                7.0_dp, 9.0_dp), 'its own card comes first')
            call tap%ok(is_equal(to_real(c(4)%points%step), 5.0_dp) .and. &
                is_equal(to_real(c(4)%points%start), 7.0_dp), &
                'a step of POINTS begins at its own FROM')
            call tap%ok(.not. c(4)%limit(axis%bl)%has_from, 'a buttock is not limited along BL')
        end associate
        call same('POINTS,WL,1|WATERLN,0', &
            '8:10-10 error: STEP is missing, and no POINTS card before says '// &
            'how the points of such a cut are spread, as POINTS NUMBER 25 does|', &
            'a waterline can''t be stepped along WL')
    end subroutine points

    !> What is found wrong with cards from line 7 on; no cut comes of the last.
    subroutine same(cards, words, name)
        character(*), intent(in) :: cards
        character(*), intent(in) :: words
        character(*), intent(in) :: name
        call tap%same(faults_of(body_text//cards), words, name)
        call read_cuts(cards)
        call tap%ok(size(job%body(1)%cut) == 0, name//': no cut')
    end subroutine same

    subroutine bad_cuts()
        call same('STATION,0,30,0', '7:14-14 error: STEP is zero|', 'a step of zero')
        call same('STATION,0,30,-5', &
            '7:14-15 error: STEP has the wrong sign; from 0. to 30. it is '// &
            'positive|', 'a step of the wrong sign')
        call same('STATION,30,0,5', &
            '7:14-14 error: STEP has the wrong sign; from 30. to 0. it is '// &
            'negative|', 'a step of the wrong sign on the way forward')
        call same('STATION,0,30', &
            '7:13-13 error: a range of stations has FROM, TO and STEP; one station '// &
            'alone has FROM only, some have STATION LIST|', 'a range without step')
        call same('STATION,0,,5', &
            '7:11-11 error: a range of stations has FROM, TO and STEP; one station '// &
            'alone has FROM only, some have STATION LIST|', 'a step without end')
        call same('STATION,0,30,1.E-4', &
            '7:14-18 error: more than 100000 steps; a larger STEP is right|', 'too many steps')
        call same('BUTTOCK,0,,20,5', '7:11-11 error: FROM is missing; the steps begin there|', &
            'a step without start')
        call same('OBLIQUE,1,2,1,2', '7:9-15 error: the two points of the plane coincide|', &
            'one point')
        call same('OBLIQUE,1,2,1,3,1', &
            '7:17-17 error: a step of STA in a plane at one station; leave it '// &
            'blank, put a POINTS card before, or use STATION|', 'a step where STA stays')
        call same('PLANE,1,2,3,0,0,0', '7:13-17 error: the normal is zero; it needs a direction|', &
            'a normal of zero')
        call same('STATION,0,1.E70,1.E-70', &
            '7:17-22 error: more than 100000 steps; a larger STEP is '// &
            'right|', 'numbers of any size')
    end subroutine bad_cuts

    subroutine checks()
        call read_cuts('SKIN,.1|CHECK,POINT,1,2,3,.5,ENGINE|CHECK,SPHERE,1,2,3,4,.25|'// &
            'CHECK,BOX,1,2,3,4,5,6,0,BOX|'// &
            'STATION,1')
        call tap%ok(faults%count == 0, 'checks are read')
        associate (c => job%body(1)%check)
            call tap%ok(all(c%kind == [check%point, check%sphere, check%box]), &
                'each is of its kind')
            call tap%ok(all([size(c(1)%value), size(c(2)%value), size(c(3)%value)] == [3, 4, 6]), &
                'with its numbers')
            call tap%ok(all(is_equal(check_real(c(3), [1, 2, 3, 4, 5, 6]), [1.0_dp, 2.0_dp, &
                3.0_dp, 4.0_dp, 5.0_dp, 6.0_dp])), 'in their order')
            call tap%ok(all(is_equal(to_real(c%clearance), [0.5_dp, 0.25_dp, 0.0_dp])), &
                'clearances')
            call tap%ok(all(is_equal(to_real(c%skin), 0.1_dp)), 'the skin in force')
            call tap%ok(c(1)%name == 'ENGINE' .and. c(2)%name == '', 'names')
        end associate
        call same('CHECK,POINT,1,2,3,-1', '7:19-20 error: the clearance is negative|', &
            'a negative clearance')
        call same('CHECK,SPHERE,1,2,3,0,1', &
            '7:20-20 error: the radius of a sphere is above zero; a POINT '// &
            'has none|', 'a sphere of no radius')
        call same('CHECK,POINT,1,2,3,1,A|CHECK,POINT,1,2,3,1,A', &
            '8:21-21 error: a second component A|', 'a name twice')
    end subroutine checks

end program test_job_cut
