!> Tests of stretches: their sections, tracks that sections share, groups, walls.
program test_shell_stretch
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_shell_stretch, only: stretch_type, stretches_of, track_at, used_lines
    use support_skins, only: deck_body, text_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(stretch_type), allocatable :: stretches(:)
    character, parameter :: nl = new_line('a')
    character(*), parameter :: head = 'TITLE,BODY'//nl//'LINE,UCL,SIDE,10.'//nl// &
        'LINE,LCL,SIDE,-10.'//nl//'LINE,MHB,SIDE,0.'//nl//'LINE,MHB,PLAN,10.'//nl// &
        'LINE,USH,SIDE,8.'//nl//'LINE,USH,PLAN,6.'//nl//'LINE,LSH,SIDE,-8.'//nl// &
        'LINE,LSH,PLAN,6.'//nl

    call judge_fuselage()
    call judge_twin()
    call judge_groups()
    call judge_walls()
    call tap%finish()

contains

    !> The stretches of the fuselage.
    subroutine judge_fuselage()
        body = deck_body('fuselage')
        call stretches_of(body, 1.0e-3_dp, .false., stretches)
        call tap%ok(size(stretches) == 5, 'the fuselage has five stretches')
        call tap%ok(all(stretches%pace%from == [0.0_dp, 14.0_dp, 56.0_dp, 112.0_dp, 200.0_dp]) &
            .and. all(stretches%pace%to == [14.0_dp, 56.0_dp, 112.0_dp, 200.0_dp, 280.0_dp]), &
            'end to end')
        call tap%ok(all(stretches(1)%pace%is_blunt .eqv. [.true., .false.]), 'the first is blunt')
        associate (last => stretches(5))
            call tap%ok(all(body%sections(last%slots%number)%name == &
                ['LOWER   ', 'SIDE    ', 'FILLET  ', 'RIDGE   ']), 'the last has four sections')
            call tap%ok(size(last%tracks) == 5, 'on five tracks')
            call tap%ok(last%slots(1)%track(2) == last%slots(2)%track(2), &
                'LOWER and SIDE meet on SDL')
            call tap%ok(last%slots(2)%track(1) == last%slots(3)%track(2) .and. &
                last%slots(3)%track(1) == last%slots(4)%track(2), &
                'SIDE, FILLET and RIDGE one after the other')
            call tap%ok(count(last%tracks%is_centred) == 2 .and. &
                last%tracks(last%slots(4)%track(1))%is_centred .and. &
                last%tracks(last%slots(1)%track(1))%is_centred, 'two tracks are in BL 0')
            call tap%ok(norm2(track_at(last, last%tracks(last%slots(3)%track(1)), 280.0_dp) - &
                [0.64_dp, 14.6_dp]) < 1.0e-13_dp, 'a track is where its line is')
            call tap%ok(size(used_lines(last)) == 11, 'eleven lines carry it')
            call tap%ok(size(last%body%lines(1)%side%stroke) == 1 .and. &
                size(last%body%lines(2)%plan%stroke) == 1, 'each view is one stroke')
        end associate
    end subroutine judge_fuselage

    !> A line written twice under two names.
    subroutine judge_twin()
        body = text_body(head//'LINE,TWIN,SIDE,0.'//nl//'LINE,TWIN,PLAN,10.'//nl// &
            'SECTION,UPPER,UCL,USH,MHB,0.,999.999,0.,50.'//nl// &
            'SECTION,LOWER,LCL,LSH,TWIN,0.,999.999,0.,50.'//nl)
        call stretches_of(body, 1.0e-3_dp, .false., stretches)
        call tap%ok(size(stretches) == 1, 'sections on two lines that are one hang together')
        call tap%ok(size(stretches(1)%tracks) == 3, 'these are one track')
        body = text_body(head//'LINE,TWIN,SIDE,0.'//nl//'LINE,TWIN,PLAN,10.001'//nl// &
            'SECTION,UPPER,UCL,USH,MHB,0.,999.999,0.,50.'//nl// &
            'SECTION,LOWER,LCL,LSH,TWIN,0.,999.999,0.,50.'//nl)
        call stretches_of(body, 1.0e-2_dp, .false., stretches)
        call tap%ok(size(stretches) == 2, 'a thousandth apart they do not')
    end subroutine judge_twin

    !> Sections that have nothing to do with each other.
    subroutine judge_groups()
        body = text_body(head//'LINE,ROD,SIDE'//nl//'STRAIGHT,10.,30.,40.,35.'//nl// &
            'LINE,ROD,PLAN,1.'//nl//'LINE,TOP,SIDE'//nl//'STRAIGHT,10.,32.,40.,36.'//nl// &
            'LINE,SH,SIDE'//nl//'STRAIGHT,10.,31.6,40.,35.8'//nl//'LINE,SH,PLAN,.6'//nl// &
            'SECTION,UPPER,UCL,USH,MHB,0.,999.999,0.,50.'//nl// &
            'SECTION,ROD,TOP,SH,ROD,0.,999.999'//nl)
        call stretches_of(body, 1.0e-3_dp, .false., stretches)
        call tap%ok(size(stretches) == 4, 'stops are those of the whole body')
        call tap%ok(count(stretches%pace%from == 10.0_dp) == 2, 'groups are stretches of their own')
        call tap%ok(all([size(stretches(1)%slots), size(stretches(2)%slots), &
            size(stretches(3)%slots), size(stretches(4)%slots)] == 1), 'each with its section')
    end subroutine judge_groups

    !> Walls in BL 0.
    subroutine judge_walls()
        real(dp) :: ends(4)
        body = text_body(head//'SECTION,UPPER,UCL,USH,MHB,0.,999.999,0.,50.'//nl// &
            'SECTION,LOWER,LCL,LSH,MHB,0.,999.999,0.,50.'//nl)
        call stretches_of(body, 1.0e-3_dp, .true., stretches)
        associate (slots => stretches(1)%slots)
            call tap%ok(size(slots) == 3 .and. slots(size(slots))%number == 0, &
                'a ring open at BL 0 gets a wall')
            call tap%ok(any(slots(3)%track(1) == slots(1:2)%track(1)) .and. &
                any(slots(3)%track(2) == slots(1:2)%track(1)), 'from centre line to centre line')
            ends = [track_at(stretches(1), stretches(1)%tracks(slots(3)%track(1)), 5.0_dp), &
                track_at(stretches(1), stretches(1)%tracks(slots(3)%track(2)), 5.0_dp)]
            call tap%ok(slots(3)%outward == sign(1.0_dp, ends(2) - ends(4)), &
                'port is outside of it: to the left of a way upwards')
        end associate
        body%sections = body%sections(1:1)
        call stretches_of(body, 1.0e-3_dp, .true., stretches)
        call tap%ok(size(stretches(1)%slots) == 1, 'a quarter that ends off BL 0 gets none')
    end subroutine judge_walls

end program test_shell_stretch
