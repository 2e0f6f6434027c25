!> The generator of L'Ecuyer: its own numbers, worked here in 128 bits; evenness; orders by chance.
program test_random
    use base_kinds, only: dp, i128, i64
    use sweep_random, only: new_random, next_share, random_type, shuffled
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: number = 20000
    type(tap_type) :: tap
    type(random_type) :: random, other
    integer(i128) :: s1, s2, z
    real(dp) :: share, mean, bins(10), another
    integer :: order(1000), i, wrong

    random%state = [12345_i64, 67890_i64]
    s1 = 12345_i128
    s2 = 67890_i128
    wrong = 0
    do i = 1, 1000
        s1 = mod(40014_i128*s1, 2147483563_i128)
        s2 = mod(40692_i128*s2, 2147483399_i128)
        z = s1 - s2
        if (z < 1) z = z + 2147483562_i128
        call next_share(random, share)
        if (abs(share - real(z, dp)/2147483563.0_dp) > 0.0_dp) wrong = wrong + 1
    end do
    call tap%ok(wrong == 0, 'a thousand numbers are those of the recurrence')

    random = new_random(7, 1)
    mean = 0.0_dp
    bins = 0.0_dp
    do i = 1, number
        call next_share(random, share)
        mean = mean + share/real(number, dp)
        bins(1 + int(10.0_dp*share)) = bins(1 + int(10.0_dp*share)) + 1.0_dp
    end do
    call tap%near(mean, 0.5_dp, 0.01_dp, 'their mean is a half')
    call tap%ok(all(abs(bins - 2000.0_dp) < 200.0_dp), 'they are spread evenly')

    random = new_random(7, 1)
    other = new_random(7, 2)
    call next_share(random, share)
    call next_share(other, another)
    call tap%ok(abs(share - another) > 0.0_dp, 'another stream, other numbers')
    other = new_random(8, 1)
    call next_share(other, another)
    call tap%ok(abs(share - another) > 0.0_dp, 'another seed, other numbers')
    random = new_random(0, 0)
    call next_share(random, share)
    call tap%ok(share > 0.0_dp .and. share < 1.0_dp, 'a seed of zero is one, too')
    random = new_random(huge(0), huge(0))
    call next_share(random, share)
    call tap%ok(share > 0.0_dp .and. share < 1.0_dp, 'so is the largest')

    call shuffled(random, order)
    call tap%ok(all([(count(order == i) == 1, i = 1, size(order))]), &
        'an order has each number once')
    call tap%ok(count([(order(i) == i, i = 1, size(order))]) < 20, 'few stay in their place')
    call tap%finish()
end program test_random
