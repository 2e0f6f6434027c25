!> What linear equations leave free.
program test_span
    use audit_span, only: free_basis
    use base_kinds, only: dp
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(random_type) :: random
    real(dp) :: rows(6, 3), basis(6, 6), worst, unlike_one
    integer :: free, trial, i, j

    worst = 0.0_dp
    unlike_one = 0.0_dp
    do trial = 1, 50
        do j = 1, 3
            do i = 1, 6
                rows(i, j) = random%between(-1.0_dp, 1.0_dp)*10.0_dp**(3*j)
            end do
        end do
        call free_basis(rows, basis, free)
        if (free /= 3) worst = 1.0_dp
        do j = 1, 3
            worst = max(worst, maxval(abs(matmul(rows(:, j), basis(:, :3))))/norm2(rows(:, j)))
        end do
        do i = 1, 3
            do j = 1, 3
                unlike_one = max(unlike_one, abs(dot_product(basis(:, i), basis(:, j)) - &
                    merge(1.0_dp, 0.0_dp, i == j)))
            end do
        end do
    end do
    call tap%near(worst, 0.0_dp, 1.0e-14_dp, 'three equations of six unknowns leave three free')
    call tap%near(unlike_one, 0.0_dp, 1.0e-14_dp, 'as an orthonormal basis')
    rows(:, 3) = 2.0_dp*rows(:, 1) - rows(:, 2)
    call free_basis(rows, basis, free)
    call tap%ok(free == 4, 'an equation that follows from others says nothing')
    call free_basis(rows(:, :0), basis, free)
    call tap%ok(free == 6, 'no equation leaves all free')
    call tap%finish()
end program test_span
