!> The front against every variant held against every other; the best.
program test_front
    use base_kinds, only: dp
    use support_ellipsoid, only: ellipsoid_study, ellipsoid_text
    use support_random, only: random_type
    use support_tap, only: tap_type
    use sweep_front, only: best_of, front_of, keys_of, mark_front
    use sweep_record, only: record_type, state
    use sweep_study, only: study_type
    implicit none (type, external)

    character(*), parameter :: objectives(3) = [character(99) :: 'OBJECT,VOLUME,MAX|', &
        'OBJECT,VOLUME,MAX|OBJECT,WETTED,MIN|', &
        'OBJECT,VOLUME,MAX|OBJECT,WETTED,MIN|OBJECT,CENTROID,NEAR,.5|']
    type(tap_type) :: tap
    type(random_type) :: random
    type(study_type) :: study
    type(record_type), allocatable :: records(:)
    real(dp), allocatable :: key(:, :)
    integer, allocatable :: front(:)
    integer :: kind, run, i, k, wrong, disordered
    logical :: is_beaten

    do kind = 1, 3
        study = ellipsoid_study(ellipsoid_text('1.,2.,2', '1.,2.,2', trim(objectives(kind))), tap)
        wrong = 0
        disordered = 0
        do run = 1, 40
            call draw(50 + 5*run, coarse=mod(run, 2) == 0)
            call mark_front(study, records)
            key = keys_of(study, records)
            do i = 1, size(records)
                is_beaten = records(i)%state /= state%ok
                do k = 1, size(records)
                    is_beaten = is_beaten .or. (records(k)%state == state%ok .and. &
                        all(key(:, k) <= key(:, i)) .and. any(key(:, k) < key(:, i)))
                end do
                if (is_beaten .eqv. records(i)%is_front) wrong = wrong + 1
            end do
            front = front_of(study, records)
            do i = 2, size(front)
                if (key(1, front(i)) < key(1, front(i - 1))) disordered = disordered + 1
            end do
            if (size(front) /= count(records%is_front)) wrong = wrong + 1
            if (.not. records(best_of(study, records))%is_front) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, 'the front is who is not beaten by any other')
        call tap%ok(disordered == 0, 'it is in the order of the first objective')
    end do

    study = ellipsoid_study(ellipsoid_text('1.,2.,2', '1.,2.,2', trim(objectives(2))), tap)
    call draw(3, coarse=.false.)
    records%state = state%ok
    records(1)%measure(1:2) = [10.0_dp, 30.0_dp]
    records(2)%measure(1:2) = [9.0_dp, 12.0_dp]
    records(3)%measure(1:2) = [2.0_dp, 10.0_dp]
    call mark_front(study, records)
    call tap%ok(all(records%is_front), 'none of three betters another')
    call tap%ok(best_of(study, records) == 2, 'the best is the one with nearly the best of both')
    key = keys_of(study, records)
    call tap%near(key(1, 2), -9.0_dp, 0.0_dp, 'what is to be great is small as a key')
    records%state = state%limit
    call mark_front(study, records)
    call tap%ok(.not. any(records%is_front) .and. best_of(study, records) == 0, &
        'there is no front where no variant keeps its limits')
    call tap%finish()

contains

    !> Records with measures by chance; coarse ones have many equals.
    subroutine draw(number, coarse)
        integer, intent(in) :: number
        logical, intent(in) :: coarse
        integer :: n, m
        if (allocated(records)) deallocate (records)
        allocate (records(number))
        do n = 1, number
            records(n)%number = n
            records(n)%state = merge(state%limit, state%ok, random%one_in(8))
            allocate (records(n)%measure(size(study%shown)))
            do m = 1, size(study%shown)
                records(n)%measure(m) = random%between(0.0_dp, 6.0_dp)
                if (coarse) records(n)%measure(m) = anint(records(n)%measure(m))
            end do
        end do
    end subroutine draw

end program test_front
