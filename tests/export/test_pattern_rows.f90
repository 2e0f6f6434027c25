!> Tests of rows: whatever the sizes, no part touches another and all are on the sheet.
program test_pattern_rows
    use base_kinds, only: dp
    use export_pattern_rows, only: best_rows, rows_type, rows_within
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(rows_type) :: rows, column
    type(random_type) :: random
    real(dp) :: sizes(2, 30)
    integer :: i, k, tries, faults(3)

    rows = rows_within(reshape([4.0_dp, 2.0_dp, 3.0_dp, 5.0_dp, 6.0_dp, 1.0_dp], [2, 3]), 8.0_dp)
    call tap%ok(all(abs(rows%at - reshape([0.0_dp, 1.75_dp, 4.75_dp, 1.75_dp, 0.0_dp, 0.0_dp], &
        [2, 3])) < 1.0e-12_dp), 'parts stand on the line of their row, the first row on top')
    call tap%ok(all(abs(rows%size - [7.75_dp, 6.75_dp]) < 1.0e-12_dp), 'the sheet holds them')

    faults = 0
    do tries = 1, 50
        do i = 1, 30
            sizes(:, i) = [random%between(1.0_dp, 40.0_dp), random%between(1.0_dp, 40.0_dp)]
        end do
        rows = best_rows(sizes)
        column = rows_within(sizes, 60.0_dp)
        if (column%size(1) > 60.0_dp) faults(1) = faults(1) + 1
        if (maxval(rows%size) > maxval(column%size)) faults(2) = faults(2) + 1
        do i = 1, 30
            if (any(rows%at(:, i) < -1.0e-9_dp) .or. &
                any(rows%at(:, i) + sizes(:, i) > rows%size + 1.0e-9_dp)) faults(3) = faults(3) + 1
            do k = 1, i - 1
                if (.not. any(rows%at(:, i) > rows%at(:, k) + sizes(:, k) + 0.5_dp .or. &
                    rows%at(:, k) > rows%at(:, i) + sizes(:, i) + 0.5_dp)) faults(3) = faults(3) + 1
            end do
        end do
    end do
    call tap%ok(faults(1) == 0, 'rows are no wider than asked for')
    call tap%ok(faults(2) == 0, 'the best rows have no longer side than others')
    call tap%ok(faults(3) == 0, 'all on the sheet, none near another')
    rows = rows_within(reshape([9.0_dp, 2.0_dp, 1.0_dp, 1.0_dp], [2, 2]), 8.0_dp)
    call tap%ok(abs(rows%size(1) - 9.0_dp) < 1.0e-12_dp .and. rows%at(2, 1) > rows%at(2, 2), &
        'what is too wide has a row of its own')
    call tap%finish()
end program test_pattern_rows
