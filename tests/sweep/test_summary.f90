!> The summary of a sweep.
program test_summary
    use base_kinds, only: dp
    use support_ellipsoid, only: ellipsoid_study, ellipsoid_text
    use support_tap, only: tap_type
    use sweep_front, only: mark_front
    use sweep_record, only: record_type, state
    use sweep_study, only: study_type
    use sweep_summary, only: summary_of
    implicit none (type, external)

    character(*), parameter :: feed = new_line('a')
    type(tap_type) :: tap
    type(study_type) :: study
    type(record_type) :: records(3)
    integer :: i

    study = ellipsoid_study(ellipsoid_text('1.,2.,2', '1.,2.,2', &
        'OBJECT,VOLUME,MAX|OBJECT,WETTED,NEAR,30.'), tap)
    do i = 1, 3
        records(i) = record_type(i, [1.25_dp, -2.0_dp], [100.0_dp*real(i, dp), 123456.78901_dp], &
            [.true., .true.], merge(state%ok, state%fault, i < 3), .false., '')
    end do
    call mark_front(study, records)
    call tap%same(summary_of(study, records, '# '), &
        '# 3 variants, a full grid: 2 keep all limits, 0 miss one, 1 can''t be built'//feed// &
        '# Objectives: VOLUME MAX, WETTED NEAR 30.'//feed// &
        '# Pareto front, 1 variant:'//feed// &
        '#    variant           B           C      VOLUME      WETTED'//feed// &
        '#          2        1.25          -2        200.   123456.79'//feed// &
        '# Best: variant 2, on the front the nearest to the best of each objective'//feed, &
        'counts, objectives, front, best')
    records%state = state%limit
    call mark_front(study, records)
    call tap%has(summary_of(study, records, ''), &
        feed//'No variant keeps all limits: there is no front and no best.'//feed, 'no front')
    call tap%finish()
end program test_summary
