!> PATCH cards: what is taken, and what is said of those that are wrong.
program test_job_patch
    use base_fault, only: fault_list_type
    use deck_job, only: bound, job_type, twist
    use support_job_deck, only: body_text, faults_of, job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults

    call job_of(body_text//'PATCH,CAP,POINT,TOP,10.,MHB|PATCH,B,TOP,2.,MHB,3.5,FLAT,0.,9.|'// &
        'STATION,1', job, faults)
    call tap%ok(faults%count == 0 .and. size(job%body(1)%patch) == 2, 'patches are read')
    associate (cap => job%body(1)%patch(1), b => job%body(1)%patch(2))
        call tap%ok(cap%name == 'CAP' .and. all(cap%side%kind == [bound%point, bound%line, &
            bound%station, bound%line]), 'sides of every kind')
        call tap%ok(all(cap%side([2, 4])%line == [1, 3]), 'their lines')
        call tap%ok(cap%side(3)%station%digits == 10 .and. b%side(4)%station%digits == 35, &
            'their stations')
        call tap%ok(cap%twist == twist%adini .and. b%twist == twist%none, 'how they are blended')
        call tap%ok(.not. cap%range%has_from .and. b%range%has_from .and. b%range%has_to .and. &
            b%range%to%digits == 9, 'where lines may meet')
    end associate
    call wrong('PATCH,CAP,POINT,TOPP,10.,MHB', '7:17-20 error: there is no LINE TOPP, and no '// &
        'cut of that name, on the cards before; did you mean TOP?|', 'a line misspelt')
    call wrong('PATCH,CAP,2.,3.,TOP,MHB', '7:14-15 error: sides 1 and 2 are both no lines; a '// &
        'station or a POINT stands between two lines or cuts|', 'two stations in a row')
    call wrong('PATCH,CAP,POINT,TOP,POINT,MHB', '7:11-15 error: a patch has one POINT for a '// &
        'side at most|', 'two points')
    call wrong('PATCH,CAP,TOP,TOP,2.,MHB', '7:15-17 error: a line twice in a row|', 'a line twice')
    call wrong('PATCH,UP,POINT,TOP,10.,MHB', '7:7-8 error: there is a SECTION UP; give the '// &
        'patch another name|', 'the name of a section')
    call wrong('PATCH,CAP,POINT,TOP,10.,MHB,,5.,5.', '7:33-34 error: TO is not aft of FROM|', &
        'an empty range')
    call wrong('PATCH,CAP,POINT,TOP,10.,MHB,TWISTED', '7:29-35 error: BLEND is TWIST, FLAT or '// &
        'LINEAR, not TWISTED; did you mean TWIST?|', 'an unknown blend')
    call wrong('PATCH,CAP,POINT,TOP,10.,MHB,,,,TANGENT1', '7:11-15 error: TANGENT1 of a side '// &
        'that is a POINT; it has no skin beside it|', 'a point that is tangent')
    call wrong('PATCH,CAP,POINT,TOP,10.,MHB,LINEAR,,,TANGENT3', '7:29-34 error: LINEAR has no '// &
        'slopes across its sides; TANGENT3 takes TWIST or FLAT|', 'tangent without slopes')
    call wrong('PATCH,CAP,POINT,TOP,10.,MHB,,,,TANGENT5', '7:32-39 error: TANGENT5 is no '// &
        'option of this card; options are TANGENT1, TANGENT2, TANGENT3 or TANGENT4; did you '// &
        'mean TANGENT1?|', 'a fifth side')
    call wrong('STATION,1,2,.5,RIBS|PATCH,P,RIBS,TOP,10.,MHB', &
        '8:9-12 error: cut RIBS has several stations; a side is at one|', 'several stations')
    call wrong('BUTTOCK,1,0,,1,RIB|BUTTOCK,2,0,,1,RIB|PATCH,P,RIB,TOP,10.,MHB', &
        '9:9-11 error: several cuts are named RIB; give each its own name|', 'a name of two cuts')
    call wrong('BUTTOCK,1,0,,1,RIB|PATCH,P,RIB,RIB,10.,MHB', &
        '8:13-15 error: a cut twice in a row|', 'a cut twice')
    call job_of(body_text//'STATION,7.5,,,FORE|WATERLN,2.,0.,,1.,FOOT|PATCH,P,FOOT,FORE,TOP,9.,'// &
        ',,,TANGENT1,TANGENT3', job, faults)
    call tap%ok(faults%count == 0, 'cuts by their names')
    associate (side => job%body(1)%patch(1)%side)
        call tap%ok(all(side%kind == [bound%cut, bound%station, bound%line, bound%station]) .and. &
            side(1)%cut == 2 .and. side(2)%station%digits == 75, 'a STATION is a station')
        call tap%ok(all(side%is_tangent .eqv. [.true., .false., .true., .false.]), &
            'which sides are tangent')
    end associate
    call tap%finish()

contains

    !> What is said of a card on line 7.
    subroutine wrong(card, words, name)
        character(*), intent(in) :: card    !! the card
        character(*), intent(in) :: words   !! all that is said
        character(*), intent(in) :: name    !! of the check
        call tap%same(faults_of(body_text//card//'|STATION,1'), words, name)
    end subroutine wrong

end program test_job_patch
