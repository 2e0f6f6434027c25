!> The summary of a sweep.
program test_summary
    use base_kinds, only: dp
    use base_text, only: columns
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
        '# 3 variants, a full grid: 2 keep all limits, 0 miss one, 1 can''t be built or '// &
        'measured'//feed// &
        '# Objectives: VOLUME MAX, WETTED NEAR 30.'//feed// &
        '# Pareto front, 1 variant:'//feed// &
        '#    variant           B           C      VOLUME      WETTED'//feed// &
        '#          2        1.25          -2    200.0000    123456.8'//feed// &
        '# Best: variant 2, on the front the nearest to the best of each objective'//feed, &
        'counts, objectives, front, best')
    records%state = state%limit
    call mark_front(study, records)
    records(1)%why = 'VOLUME 100. is below 500.'
    call tap%has(summary_of(study, records, ''), &
        feed//'No variant keeps all limits: there is no front and no best.'//feed// &
        'Variant 1: VOLUME 100. is below 500.'//feed, 'no front, and what the first one misses')

    call check_column([12345.6789_dp, 0.5_dp, -3.25_dp], ['    12345.68', '        0.50', &
        '       -3.25'], 'as many decimals as the greatest has')
    call check_column([0.00012345678_dp, 0.0_dp, -0.00003_dp], ['  0.00012346', &
        '  0.00000000', ' -0.00003000'], 'small ones')
    call check_column([123456789.4_dp, 0.6_dp, -1.0_dp], ['  123456789.', '          1.', &
        '         -1.'], 'great ones')
    call check_column([1.5e12_dp, 0.5_dp, -1.25e-7_dp], ['   1.500E+12', '   5.000E-01', &
        '  -1.250E-07'], 'greater ones')
    call check_column([0.0_dp, 0.0_dp, 0.0_dp], ['          0.', '          0.', &
        '          0.'], 'nothing but zeros')
    call tap%finish()

contains

    !> The volumes of a front of three variants, as they stand below each other in the table.
    subroutine check_column(volumes, column, name)
        real(dp), intent(in) :: volumes(3)  !! falling
        character(12), intent(in) :: column(3)
        character(*), intent(in) :: name
        character(:), allocatable :: text
        integer :: k

        do k = 1, 3
            records(k) = record_type(k, [1.0_dp, 2.0_dp], [volumes(k), 30.0_dp], &
                [.true., .true.], state%ok, .true., '')
        end do
        text = summary_of(study, records, '')
        text = text(index(text, 'WETTED'//feed) + 7:)
        do k = 1, 3
            call tap%same(columns(text, 35, 46), column(k), 'a column of '//name)
            text = text(index(text, feed) + 1:)
        end do
    end subroutine check_column

end program test_summary
