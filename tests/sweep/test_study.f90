!> A sweep made ready: its columns, its objectives, what keeps it from being ready.
program test_study
    use base_fault, only: fault_list_type
    use support_ellipsoid, only: ellipsoid_study, ellipsoid_text
    use support_job_deck, only: words_of
    use support_tap, only: tap_type
    use sweep_study, only: new_study, objectives_of, study_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(study_type) :: study

    study = ellipsoid_study(ellipsoid_text('1.,2.,3', '1.,2.,2', 'OBJECT,VOLUME,MAX|'// &
        'LIMIT,WIDTH,1.,,0.,0.|OBJECTIVE,WETTED,MIN|LIMIT,VOLUME,1.|OBJECT,AREA,SHOW,,0.|'// &
        'OBJECT,WIDTH,NEAR,3.,0.,0.'), tap)
    call tap%ok(study%plan%count == 6, 'the plan is made')
    call tap%ok(all(study%column == [1, 2, 3, 1, 4, 2]), 'one measure has one column')
    call tap%ok(all(study%shown == [1, 2, 3, 5]), 'in the order of the cards')
    call tap%ok(all(objectives_of(study) == [1, 3, 6]), 'MIN, MAX and NEAR are objectives')
    call refused('LINE,A,SIDE,1.', 'no VARY card', 'a deck where nothing varies')
    call refused(ellipsoid_text('1.,2.,3', '1.,2.,2', 'LIMIT,VOLUME,1.|OBJECT,WETTED,SHOW'), &
        'no OBJECT card with MIN, MAX or NEAR', 'no objective')
    call refused('1. 2. 3.', 'no body deck', 'a 1970 deck')
    call refused('', 'no body deck', 'an empty deck')
    call refused(ellipsoid_text('2.,1.,3', '1.,2.,2', 'OBJECT,VOLUME,MAX'), 'FROM is above TO', &
        'a card in error')
    call refused('LINE,A,SIDE,1.'//new_line('a')//achar(0), 'a null byte', 'a binary file')
    call tap%finish()

contains

    !> A deck can't be swept.
    subroutine refused(text, why, name)
        character(*), intent(in) :: text, why, name
        type(fault_list_type) :: faults
        call new_study(text, study, faults)
        call tap%has(words_of(faults), why, name)
        call tap%ok(faults%has_errors(0), 'is refused')
    end subroutine refused

end program test_study
