!> Faired outlines from a deck: the paper's inlet by cards, both ways round, and what can't be.
program test_outline
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_outline, only: build_outlines, outline_type
    use deck_job, only: job_type
    use geom_fairing, only: faired_energy
    use support_job_deck, only: job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    character(*), parameter :: points = '|.5,0|.55,.3|.48,.6|.35,.8|0,.95|-.35,.8|-.48,.6|'// &
        '-.55,.3|-.5,0|-.4,-.2|-.2,-.4|0,-.45|.2,-.4|.4,-.2', back = '|.4,-.2|.2,-.4|0,-.45|'// &
        '-.2,-.4|-.4,-.2|-.5,0|-.55,.3|-.48,.6|-.35,.8|0,.95|.35,.8|.48,.6|.55,.3|.5,0'
    type(tap_type) :: tap
    type(outline_type), allocatable :: list(:)
    type(fault_list_type) :: faults
    character(:), allocatable :: words

    call build('FAIRED,A,7.,100.,.5,1.18'//points//'|FAIRED,B,7.,100.,.5,1.18'//back// &
        '|FAIRED,C,7.,100.'//points)
    call tap%ok(faults%count == 0 .and. size(list) == 3, 'three outlines are faired')
    call tap%near(list(1)%fairing%area, 1.18_dp, 1.18e-10_dp, 'the area asked for')
    call tap%near(list(2)%fairing%area, -1.18_dp, 1.18e-10_dp, '... also clockwise')
    call tap%near(list(1)%fairing%lambda, 2.2421231135_dp, 6.0e-11_dp, 'its multiplier')
    call tap%near(list(2)%fairing%lambda, -2.2421231135_dp, 6.0e-11_dp, '... also clockwise')
    call tap%near(faired_energy(list(1)%fairing), 0.3676866940_dp, 6.0e-11_dp, 'its energy')
    call tap%near(list(3)%fairing%area, 1.1924299839_dp, 6.0e-11_dp, 'the area as it comes')
    call tap%ok(all(list%sta == 7.0_dp) .and. all(list%name == ['A', 'B', 'C']), &
        'station and name')

    call build('FAIRED,A,7.,100.,.5,1.E9'//points)
    call tap%ok(size(list) == 0, 'an area that can''t be reached makes no outline')
    call tap%has(words_of(faults), '1:21-24 error: no faired curve near these points has the '// &
        'area 1.', 'why is said')
    call build('FAIRED,A,7.,100.,.5,50.'//points)
    words = words_of(faults)
    call build('FAIRED,A,7.,100.,.5,50.'//back)
    call tap%same(words_of(faults), words, 'in the same words for points that run clockwise')
    call build('FAIRED,A,7.'//points//'|.5,0.')
    call tap%same(words_of(faults), '16:1-2 error: the last point is the first again; the '// &
        'outline closes by itself: leave it out|', 'a first point that is given again')
    call build('FAIRED,A,7.|0,0|1,1')
    call tap%same(words_of(faults), '1:8-8 error: a faired curve near 2 points; it takes at '// &
        'least 3|', 'two points')
    call tap%finish()

contains

    !> Fairs the outlines of a deck.
    subroutine build(cards)
        character(*), intent(in) :: cards !! of the deck
        type(job_type) :: job
        type(fault_list_type) :: read_faults, none
        call job_of(cards, job, read_faults)
        faults = none
        call build_outlines(job%body(1), list, faults)
    end subroutine build

end program test_outline
