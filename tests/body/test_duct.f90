!> Ducts from decks and outlines: matched, begun, turned, brought to one number of vertices; what
!> can't be.
program test_duct
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_duct, only: build_ducts, duct_type
    use body_outline, only: build_outlines, outline_type
    use deck_job, only: job_type
    use geom_ring_loft, only: ring_at
    use geom_ring_spline, only: turned_ring
    use support_ducts, only: duct_through, outline_of, wheel
    use support_job_deck, only: job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    !> Squares of four points; the second runs clockwise.
    character(*), parameter :: square = '|5,-1|7,-1|7,1|5,1', back = '|5,-1|5,1|7,1|7,-1', &
        middle = '|-1,-1|1,-1|1,1|-1,1'
    type(tap_type) :: tap
    type(duct_type), allocatable :: ducts(:)
    type(duct_type) :: duct
    type(fault_list_type) :: faults
    real(dp) :: centre(2)


    call build('FAIRED,A,0.'//square//'|FAIRED,B,4.'//back//'|FAIRED,C,9.'//square// &
        '|DUCT,D,A,B,C')
    call tap%ok(size(ducts) == 1 .and. faults%count == 0, 'a duct is built')
    call tap%ok(all(ducts(1)%outline%is_turned .eqv. [.false., .true., .false.]) .and. &
        all(ducts(1)%outline%first == 1), 'an outline that runs the other way is turned')
    call tap%near(maxval(abs(ring_at(ducts(1)%loft, 6.0_dp) - ring_at(ducts(1)%loft, 0.0_dp))), &
        0.0_dp, 1.0e-14_dp, '... so that the duct is straight')
    call tap%near(ducts(1)%panel%error, 0.0_dp, 1.0e-14_dp, 'its surface has the outlines')
    call tap%ok(ducts(1)%panel%is_round .and. ducts(1)%panel%has_image, &
        'off BL 0 it has an image')
    call build('FAIRED,A,0.'//middle//'|FAIRED,B,4.'//middle//'|DUCT,D,A,B')
    call tap%ok(.not. ducts(1)%panel%has_image, 'one around BL 0 stands once')
    call build('FAIRED,A,0.'//square//'|FAIRED,B,4.'//middle//'|DUCT,D,A,B')
    call tap%ok(ducts(1)%panel%has_image, 'one that comes to BL 0 has an image')

    call build('FAIRED,A,0.'//square//'|FAIRED,B,4.|7,1|5,1|5,-1|7,-1|DUCT,D,A,B')
    call tap%same(words_of(faults), '11:10-10 warning: B begins elsewhere than A, which would '// &
        'wind the duct; it is begun with its point 3|', 'another beginning is warned of')
    call tap%near(maxval(abs(ring_at(ducts(1)%loft, 2.0_dp) - ring_at(ducts(1)%loft, 0.0_dp))), &
        0.0_dp, 1.0e-14_dp, '... and the duct is straight')
    call build('FAIRED,A,0.|0,0|1,0|2,0|1,0.|FAIRED,B,4.'//square//'|DUCT,D,A,B')
    call tap%same(words_of(faults), '11:8-8 error: duct D: outline A encloses no area; its '// &
        'points stand in a line or cross over|', 'an outline without area')
    call build('FAIRED,A,0.|0,0|1,0|2,0|0,0.|FAIRED,B,4.'//square//'|DUCT,D,A,B')
    call tap%ok(size(ducts) == 0 .and. index(words_of(faults), 'duct') == 0, &
        'nothing more is said of an outline that was wrong')

    duct = duct_through([outline_of('A', 0.0_dp, wheel(12, [5.0_dp, 4.0_dp], [0.0_dp, 1.0_dp], &
        0.0_dp)), outline_of('B', 9.0_dp, wheel(18, [5.0_dp, 4.0_dp], [0.0_dp, 1.0_dp], 0.0_dp)), &
        outline_of('C', 20.0_dp, turned_ring(wheel(8, [5.0_dp, 4.0_dp], [0.0_dp, 1.0_dp], &
        0.0_dp)))])
    call tap%ok(duct%loft%vertices == 72, '12, 18 and 8 points make 72 vertices')
    call tap%near(duct%panel%error, 0.0_dp, 1.0e-14_dp, 'and the surface has the outlines still')
    centre = sum(ring_at(duct%loft, 14.0_dp), dim=2)/72.0_dp
    call tap%near(norm2(centre - [0.0_dp, 1.0_dp]), 0.0_dp, 1.0e-13_dp, '... without a shift')
    duct = duct_through([outline_of('A', 0.0_dp, wheel(12, [5.0_dp, 4.0_dp], [0.0_dp, 1.0_dp], &
        0.0_dp)), outline_of('B', 9.0_dp, wheel(12, [5.0_dp, 4.0_dp], [0.0_dp, 1.0_dp], 0.2_dp))])
    call tap%ok(duct%outline(2)%first == 1, 'a small turn is left as given')
    call check_many()
    call tap%finish()

contains

    !> Builds the ducts of a deck.
    subroutine build(cards)
        character(*), intent(in) :: cards !! of the deck
        type(job_type) :: job
        type(outline_type), allocatable :: outlines(:)
        type(fault_list_type) :: read_faults, none
        call job_of(cards, job, read_faults)
        if (read_faults%has_errors(0)) error stop 'a deck of a test can''t be read'
        faults = none
        call build_outlines(job%body(1), outlines, faults)
        call build_ducts(job%body(1), outlines, ducts, faults)
    end subroutine build

    !> Numbers of points without a common multiple that is small.
    subroutine check_many()
        character(:), allocatable :: cards
        character(12) :: point
        integer :: i, k
        integer, parameter :: number(3) = [11, 13, 17]
        real(dp) :: angle
        cards = ''
        do k = 1, 3
            cards = cards//'FAIRED,'//achar(64 + k)//','//achar(48 + k)//'.'
            do i = 0, number(k) - 1
                angle = 6.28_dp*real(i, dp)/real(number(k), dp)
                write (point, '(f5.2,a,f5.2)') cos(angle), ',', sin(angle)
                cards = cards//'|'//trim(point)
            end do
            cards = cards//'|'
        end do
        call build(cards//'DUCT,D,A,B,C')
        call tap%same(words_of(faults), '45:6-6 error: duct D: the outlines up to C have '// &
            'numbers of points without a common multiple up to 720; give all the same '// &
            'number, or numbers like 12 and 18|', 'numbers of points that do not go together')
    end subroutine check_many

end program test_duct
