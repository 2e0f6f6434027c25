!> The cuts of cards, whoever makes them: the same by one thread and by several, in the order of the
!> deck; faults once; no more than there is room for.
program test_computed_cuts
    use, intrinsic :: omp_lib, only: omp_set_num_threads
    use api_computed_body, only: computed_body_type, cut_body
    use api_computed_cuts, only: how_type
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use cut_outline, only: cut_type, room_of
    use cut_request, only: cut_fact
    use deck_job, only: job_type
    use support_computed, only: job_of_text
    use support_tap, only: tap_type
    implicit none (type, external)

    character, parameter :: nl = new_line('a')
    !> A cone of ten times its height.
    character(*), parameter :: cone = 'TITLE   CONE'//nl// &
        'LINE    TOP     SIDE'//nl//'STRAIGHT0.      0.      100.    10.'//nl// &
        'LINE    SHL     SIDE'//nl//'STRAIGHT0.      0.      100.    7.07107'//nl// &
        'LINE    SHL     PLAN'//nl//'STRAIGHT0.      0.      100.    7.07107'//nl// &
        'LINE    WID     SIDE    0.'//nl// &
        'LINE    WID     PLAN'//nl//'STRAIGHT0.      0.      100.    10.'//nl// &
        'SECTION UPPER   TOP     SHL     WID     0.      999.999'//nl
    type(tap_type) :: tap
    type(computed_body_type) :: one, four
    type(fault_list_type) :: faults, others
    type(job_type) :: job
    integer :: i

    call job_of_text(cone//'STATION 10.     60.     .1'//nl// &
        'POINTS  NUMBER  9.'//nl//'WATERLN 3.'//nl//'STATION 70.     110.    10.'//nl// &
        'SKIN    .1'//nl//'STATION 99.'//nl, job, faults)
    call tap%ok(faults%count == 0, 'the deck is sound')
    call cut_body(job, 1, one, faults)
    call omp_set_num_threads(4)
    call cut_body(job, 1, four, others, how_type(is_shared=.true.))
    call tap%ok(size(one%cuts) == 507, 'each station of the body is cut, those beyond are not')
    call tap%ok(all(one%cards == [(1, i=1, 501), 2, (3, i=1, 4), 4]), &
        'each cut has its card, in order')
    call tap%ok(all(is_equal(one%cuts(:501)%plane%through(1), [(0.1_dp*real(i, dp), i=100, 600)]) &
        .or. abs(one%cuts(:501)%plane%through(1) - [(0.1_dp*real(i, dp), i=100, 600)]) &
        < 1.0e-13_dp), 'the stations of a card are in its order')
    call tap%ok(faults%count == 1, 'stations beyond the body are one fault, not one each')
    call tap%has(faults%item(1)%message, 'beyond line', 'which says so')
    call tap%ok(others%count == 1, 'the same fault by four threads')
    call tap%ok(size(four%cuts) == size(one%cuts) .and. all(four%cards == one%cards), &
        'four threads make as many')
    call tap%ok(all([(is_same(one%cuts(i), four%cuts(i)), i=1, size(one%cuts))]), &
        'and each the same to the last bit')

    call cut_body(job, 1, four, others, how_type(facts=cut_fact%slope))
    call tap%ok(all([(.not. any(four%cuts(i)%outlines(1)%points%has_normal), i=1, 501)]), &
        'no normals where none are asked for')
    call tap%ok(all([(all(is_equal(four%cuts(i)%outlines(1)%points%at(3), &
        one%cuts(i)%outlines(1)%points%at(3))), i=1, size(one%cuts))]), 'but the same points')
    call tap%ok(all(four%cuts(507)%outlines(1)%points%has_normal) &
        .and. size(four%cuts(507)%inside(1)%points) == size(one%cuts(507)%inside(1)%points), &
        'the inside of the skin has the normals that it takes')
    call check_room()
    call tap%finish()

contains

    !> Where there is no room for all.
    subroutine check_room()
        type(computed_body_type) :: few
        type(fault_list_type) :: said
        integer :: k, fit

        call cut_body(job, 1, few, said, how_type(room=1))
        fit = 0
        do while (sum([(room_of(one%cuts(k)), k=1, fit + 1)]) <= 2**20)
            fit = fit + 1
        end do
        call tap%ok(size(few%cuts) == fit .and. fit > 100, 'as many cuts as fit are made')
        call tap%ok(all(few%cards == 1), 'no card behind has any')
        call tap%ok(said%count == 1 .and. said%has_errors(0), 'this is an error')
        call tap%has(said%item(1)%message, 'cut '//to_text(fit + 1)//' of the 508', &
            'with the count of those asked for')
        call tap%has(said%item(1)%message, 'a longer step', 'and the way out')
        call tap%ok(said%item(1)%line == 12, 'on the card whose turn it was')
    end subroutine check_room

    !> True for two cuts with the same points and figures.
    logical function is_same(a, b)
        type(cut_type), intent(in) :: a, b
        integer :: k
        is_same = size(a%outlines) == size(b%outlines) &
            .and. is_equal(a%disagreement, b%disagreement)
        if (.not. is_same) return
        do k = 1, size(a%outlines)
            associate (p => a%outlines(k)%points, q => b%outlines(k)%points)
                is_same = is_same .and. size(p) == size(q)
                if (.not. is_same) return
                is_same = all(is_equal(p%at(1), q%at(1)) .and. is_equal(p%at(2), q%at(2)) .and. &
                    is_equal(p%at(3), q%at(3)) .and. is_equal(p%curvature, q%curvature) .and. &
                    is_equal(p%bevel, q%bevel) .and. is_equal(p%slope%value, q%slope%value))
            end associate
            if (.not. is_same) return
        end do
    end function is_same

end program test_computed_cuts
