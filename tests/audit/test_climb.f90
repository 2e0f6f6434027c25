!> Linear programmes of few unknowns, against all corners tried one by one.
program test_climb
    use audit_climb, only: climb, most_unknowns
    use base_kinds, only: dp
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(random_type) :: random
    real(dp) :: a(3, 24), b(24), c(3), x(3), line(2, 3), y(2)
    integer :: bound(most_unknowns), trial, i
    logical :: all_best, all_kept, all_named

    line(:, 1) = [-1.0_dp, 0.0_dp]
    line(:, 2) = [0.0_dp, -1.0_dp]
    line(:, 3) = [-1.0_dp, -1.0_dp]
    y = 0.0_dp
    call climb([1.0_dp, 2.0_dp], line, [-3.0_dp, -2.0_dp, -4.0_dp], y, bound)
    call tap%ok(all(abs(y - [2.0_dp, 2.0_dp]) < 1.0e-14_dp), &
        'x + 2 y is greatest at (2, 2) below x <= 3, y <= 2, x + y <= 4')
    call tap%ok(count(bound > 0) == 2 .and. any(bound == 2) .and. any(bound == 3), &
        'and is held there by the second and the third')
    y = 0.0_dp
    call climb([1.0_dp, 1.0_dp], line, [-2.0_dp, -2.0_dp, -4.0_dp], y, bound)
    call tap%near(sum(y), 4.0_dp, 1.0e-14_dp, 'three bounds through one corner stop it there')
    y = [2.0_dp, 2.0_dp]
    call climb([1.0_dp, 1.0_dp], line, [-2.0_dp, -2.0_dp, -4.0_dp], y, bound)
    call tap%near(sum(y), 4.0_dp, 1.0e-14_dp, 'also from that corner')

    all_best = .true.
    all_kept = .true.
    all_named = .true.
    do trial = 1, 400
        do i = 1, 24
            a(:, i) = [random%between(-1.0_dp, 1.0_dp), random%between(-1.0_dp, 1.0_dp), &
                random%between(-1.0_dp, 1.0_dp)]*10.0_dp**random%between(-3.0_dp, 6.0_dp)
            b(i) = -norm2(a(:, i))*random%between(0.0_dp, 1.0_dp)
            if (random%one_in(5)) b(i) = 0.0_dp
        end do
        do i = 1, 3
            a(:, 2*i - 1:2*i) = 0.0_dp
            a(i, 2*i - 1:2*i) = [1.0_dp, -1.0_dp]
            b(2*i - 1:2*i) = -1.0_dp
        end do
        c = [random%between(-1.0_dp, 1.0_dp), random%between(-1.0_dp, 1.0_dp), &
            random%between(-1.0_dp, 1.0_dp)]
        x = 0.0_dp
        call climb(c, a, b, x, bound)
        all_kept = all_kept .and. keeps(x)
        all_best = all_best .and. abs(dot_product(c, x) - best_corner()) < 1.0e-9_dp
        do i = 1, count(bound > 0)
            all_named = all_named .and. abs(dot_product(a(:, bound(i)), x) - b(bound(i))) < &
                1.0e-9_dp*norm2(a(:, bound(i)))
        end do
    end do
    call tap%ok(all_kept, 'every bound is kept')
    call tap%ok(all_best, 'no corner is higher')
    call tap%ok(all_named, 'the bounds named hold')
    call tap%finish()

contains

    !> True for a point that keeps all bounds.
    pure logical function keeps(point)
        real(dp), intent(in) :: point(3) !! any
        integer :: j
        keeps = .true.
        do j = 1, size(b)
            keeps = keeps .and. dot_product(a(:, j), point) >= b(j) - 1.0e-9_dp*norm2(a(:, j))
        end do
    end function keeps

    !> The height of the highest corner, all triples of bounds tried by Cramer's rule.
    real(dp) function best_corner() result(best)
        real(dp) :: m(3, 3), n(3, 3), corner(3), whole
        integer :: i1, i2, i3, k
        best = -huge(best)
        do i1 = 1, size(b) - 2
            do i2 = i1 + 1, size(b) - 1
                do i3 = i2 + 1, size(b)
                    m = transpose(a(:, [i1, i2, i3]))
                    whole = determinant(m)
                    if (abs(whole) < 1.0e-10_dp*norm2(m(1, :))*norm2(m(2, :))*norm2(m(3, :))) cycle
                    do k = 1, 3
                        n = m
                        n(:, k) = b([i1, i2, i3])
                        corner(k) = determinant(n)/whole
                    end do
                    if (keeps(corner)) best = max(best, dot_product(c, corner))
                end do
            end do
        end do
    end function best_corner

    !> The determinant of a matrix of order 3.
    pure real(dp) function determinant(m)
        real(dp), intent(in) :: m(3, 3) !! any
        determinant = m(1, 1)*(m(2, 2)*m(3, 3) - m(2, 3)*m(3, 2)) &
            - m(1, 2)*(m(2, 1)*m(3, 3) - m(2, 3)*m(3, 1)) &
            + m(1, 3)*(m(2, 1)*m(3, 2) - m(2, 2)*m(3, 1))
    end function determinant

end program test_climb
