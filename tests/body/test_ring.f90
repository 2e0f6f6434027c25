!> Sections round tubes whose breaks, gaps and closures are known.
program test_ring
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_build, only: build_body
    use body_ledger, only: joint_type
    use body_ring, only: ring_of
    use body_ring_list, only: closure, ring_type
    use deck_job, only: job_type
    use support_job_deck, only: job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: degrees = 180.0_dp/acos(-1.0_dp), good = 1.0e-12_dp
    !> A round tube of radius 5 by upper and lower quarters, and what may stand in its place.
    character(*), parameter :: tube = 'LINE,UCL,SIDE,5.|LINE,LCL,SIDE,-5.|LINE,MHB,SIDE,0.|'// &
        'LINE,MHB,PLAN,5.|LINE,USH,SIDE,4.|LINE,USH,PLAN,3.|LINE,LSH,SIDE,-4.|'// &
        'LINE,LSH,PLAN,3.|LINE,TUM,ANGLE|STRAIGHT,0.,90.,80.,80.|LINE,BOW,ANGLE|'// &
        '0.,90.,.25,40.,95.,80.,90.,-.25|LINE,MHL,SIDE|STRAIGHT,0.,-.5,80.,-1.|'// &
        'LINE,MHL,PLAN,5.|', upper = 'SECTION,UPPER,UCL,USH,MHB,0.,999.999,0.,80.|', &
        lower = 'SECTION,LOWER,LCL,LSH,MHB,0.,999.999,0.,80.|'
    type(tap_type) :: tap
    type(ring_type) :: ring
    type(body_type) :: body

    call prove_smooth()
    call prove_breaks()
    call prove_ranges()
    call prove_gaps()
    call prove_missing_arcs()
    call prove_both_sides()
    call prove_nothing()
    call tap%finish()

contains

    !> A tube.
    subroutine prove_smooth()
        call go_round(tube//upper//lower)
        call tap%ok(size(ring%meetings) == 3 .and. size(ring%loose) == 0, 'a tube meets thrice')
        call tap%ok(all(ring%meetings%end(1) == [1, 2, 3]) .and. &
            all(ring%meetings%end(2) == [0, 4, 0]), 'itself at BL 0, twice, and at its side')
        call tap%near(maxval(ring%meetings%break), 0.0_dp, good, 'without a break')
        call tap%ok(all(ring%meetings%from == 0.0_dp) .and. all(ring%meetings%to == 80.0_dp), &
            'all along')
        call tap%ok(size(ring%stretches) == 1, 'in one stretch')
        call tap%ok(ring%stretches(1)%closure == closure%halves, 'from BL 0 to BL 0')
    end subroutine prove_smooth

    !> Slopes that differ, that differ along the length, and that are not level at BL 0.
    subroutine prove_breaks()
        call go_round(tube//upper//'SECTION,LOWER,LCL,LSH,MHB,0.,-2.,0.,80.')
        call tap%near(ring%meetings(2)%break, 90.0_dp - atan(2.0_dp)*degrees, good, &
            'upright and 1:2 break by the angle between them')
        call go_round(tube//upper//'SECTION,LOWER,MHB,LSH,LCL,-2.,0.,0.,80.')
        call tap%near(ring%meetings(2)%break, 90.0_dp - atan(2.0_dp)*degrees, good, &
            'also where the second runs the other way')
        call tap%ok(all(ring%meetings(2)%end == [2, 3]), 'by its start then')
        call go_round(tube//upper//'SECTION,LOWER,LCL,LSH,MHB,0.,TUM,0.,80.')
        call tap%near(ring%meetings(2)%break, 10.0_dp, good, 'a slope line breaks most')
        call tap%ok(ring%meetings(2)%sta == 80.0_dp, 'where it has turned furthest')
        call go_round(tube//upper//'SECTION,LOWER,LCL,LSH,MHB,0.,BOW,0.,80.')
        call tap%near(ring%meetings(2)%break, 5.0_dp, good, 'be that between')
        call tap%near(ring%meetings(2)%sta, 40.0_dp, good, 'in the middle')
        call go_round(tube//'SECTION,UPPER,UCL,USH,MHB,-.1,999.999,0.,80.|'//lower)
        call tap%near(ring%meetings(1)%break, 2.0_dp*atan(0.1_dp)*degrees, good, &
            'a ridge breaks by twice its angle')
        call tap%near(ring%meetings(3)%break, 0.0_dp, good, 'and the keel not at all')
        call go_round(tube//upper//'SECTION,LOWER,UCL,USH,MHB,0.,999.999,0.,80.')
        call tap%near(ring%meetings(1)%break, 180.0_dp, 1.0e-10_dp, 'a fold breaks by half a turn')
    end subroutine prove_breaks

    !> Sections that stand but along a part.
    subroutine prove_ranges()
        call go_round(tube//upper//'SECTION,FORE,LCL,LSH,MHB,0.,999.999,0.,30.|'// &
            'SECTION,AFT,LCL,LSH,MHB,0.,TUM,30.,60.')
        call tap%ok(size(ring%meetings) == 5, 'each part has its meetings')
        call tap%ok(all(ring%meetings%end(1) == [1, 2, 2, 3, 5]), 'in the order of sections')
        call tap%ok(all(ring%meetings%from == [0.0_dp, 0.0_dp, 30.0_dp, 0.0_dp, 30.0_dp]) .and. &
            all(ring%meetings%to == [80.0_dp, 30.0_dp, 60.0_dp, 30.0_dp, 60.0_dp]), &
            'where both sections are')
        call tap%near(ring%meetings(3)%break, 7.5_dp, good, 'with the largest break there')
        call tap%ok(size(ring%stretches) == 2, 'closed and open are two stretches')
        call tap%ok(all(ring%stretches%closure == [closure%halves, closure%open]), 'one of each')
        call tap%ok(ring%stretches(1)%to == 60.0_dp .and. ring%stretches(2)%from == 60.0_dp, &
            'where the last part ends')
        call tap%ok(size(ring%loose) == 1, 'behind it an end is loose')
        call tap%ok(ring%loose(1)%end == 2 .and. ring%loose(1)%next == 0 .and. &
            ring%loose(1)%from == 60.0_dp, 'that of the upper section, alone')
    end subroutine prove_ranges

    !> Sections that should meet and do not.
    subroutine prove_gaps()
        call go_round(tube//upper//'SECTION,LOWER,LCL,LSH,MHL,0.,999.999,0.,80.')
        call tap%ok(size(ring%meetings) == 2, 'sections on different lines do not meet')
        call tap%ok(size(ring%loose) == 2, 'two ends are loose')
        call tap%ok(all(ring%loose%end == [2, 4]) .and. all(ring%loose%next == [4, 2]), &
            'each next to the other')
        call tap%near(norm2(ring%loose(1)%gap - [0.0_dp, -1.0_dp]), 0.0_dp, good, &
            'at most 1 below')
        call tap%near(norm2(ring%loose(2)%gap - [0.0_dp, 1.0_dp]), 0.0_dp, good, 'or above')
        call tap%ok(all(ring%loose%sta == 80.0_dp), 'at the aft end')
        call tap%ok(ring%stretches(1)%closure == closure%open, 'so the ring is open')
        call go_round(tube//'LINE,TWIN,SIDE,0.|LINE,TWIN,PLAN,5.|'//upper// &
            'SECTION,LOWER,LCL,LSH,TWIN,0.,-2.,0.,80.')
        call tap%ok(size(ring%meetings) == 3 .and. size(ring%loose) == 0, &
            'lines that are in one place do as well as one line')
        call tap%near(ring%meetings(2)%break, 90.0_dp - atan(2.0_dp)*degrees, good, &
            'and their sections break as such do')
    end subroutine prove_gaps

    !> A section whose shoulder line leaves its tangents, upright in BL 5, at station 40.
    subroutine prove_missing_arcs()
        call go_round(tube//'LINE,OUT,SIDE,-4.|LINE,OUT,PLAN|STRAIGHT,0.,3.,80.,7.|'//upper// &
            'SECTION,LOWER,LCL,OUT,MHB,0.,999.999,0.,80.')
        call tap%near(maxval(ring%meetings%to, mask=ring%meetings%end(2) == 4), 40.0_dp, good, &
            'sections meet as far as both have an arc')
        call tap%ok(size(ring%stretches) == 2, 'where one has none begins another stretch')
        call tap%near(ring%stretches(1)%to, 40.0_dp, good, 'there')
        call tap%ok(ring%stretches(2)%closure == closure%open, 'which is open')
    end subroutine prove_missing_arcs

    !> Both halves of a body that is not symmetric.
    subroutine prove_both_sides()
        call go_round('SYMMETRY,NO|'//tube//upper(:len(upper) - 1)//',BOTH|'// &
            'SECTION,LOWER,LCL,LSH,MHB,.1,999.999,0.,80.,BOTH')
        call tap%ok(size(ring%meetings) == 4, 'two halves meet four times')
        call tap%ok(all(ring%meetings%end(2) > 0), 'none its mirror image')
        call tap%near(maxval(ring%meetings%break), 2.0_dp*atan(0.1_dp)*degrees, good, &
            'the keel breaks')
        call tap%ok(ring%stretches(1)%closure == closure%round, 'they go all round')
        call go_round('SYMMETRY,NO|'//tube//upper//lower)
        call tap%ok(size(ring%meetings) == 1 .and. ring%stretches(1)%closure == closure%halves, &
            'one half alone does not')
    end subroutine prove_both_sides

    !> No section.
    subroutine prove_nothing()
        call go_round(tube)
        call tap%ok(size(ring%meetings) == 0 .and. size(ring%loose) == 0 .and. &
            size(ring%stretches) == 0, 'without sections there is no ring')
    end subroutine prove_nothing

    !> Goes round the first body of a deck.
    subroutine go_round(deck)
        character(*), intent(in) :: deck
        type(job_type) :: job
        type(joint_type), allocatable :: joints(:)
        type(fault_list_type) :: faults
        call job_of(deck, job, faults)
        call build_body(job, 1, body, joints, faults)
        if (faults%has_errors(0)) call tap%note(words_of(faults))
        ring = ring_of(body)
    end subroutine go_round

end program test_ring
