!> Zeros of functions whose zeros are known: simple ones, close pairs, touching, beside an end.
program test_zeros
    use base_kinds, only: dp
    use geom_zeros, only: brackets_among, sample_points, sample_type, samples_of, zero_between, &
        zeros_between, zeros_of
    use support_polynomial, only: product_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(sample_type) :: sample
    real(dp), allocatable :: x(:), places(:, :)

    allocate (x(0))
    x = zeros_of(product_type([0.3_dp]), 0.0_dp, 1.0_dp, 0.0_dp)
    call tap%ok(size(x) == 1, 'a line has one zero')
    call tap%near(x(1), 0.3_dp, 1.0e-16_dp, 'to the last bit')
    x = zeros_of(product_type([0.1_dp, 0.5_dp, 0.9_dp]), 0.0_dp, 1.0_dp, 0.0_dp)
    call tap%ok(size(x) == 3, 'a cubic has three')
    call tap%near(maxval(abs(x - [0.1_dp, 0.5_dp, 0.9_dp])), 0.0_dp, 1.0e-15_dp, 'in order')
    x = zeros_of(product_type([0.43_dp, 0.4301_dp]), 0.0_dp, 1.0_dp, 0.0_dp)
    call tap%ok(size(x) == 2, 'a pair closer than the samples is found by the extreme between')
    call tap%near(maxval(abs(x - [0.43_dp, 0.4301_dp])), 0.0_dp, 1.0e-12_dp, 'each of the pair')
    x = zeros_of(product_type([0.43_dp, 0.43_dp]), 0.0_dp, 1.0_dp, 1.0e-15_dp)
    call tap%ok(size(x) == 1, 'a touching zero is found once')
    call tap%near(x(1), 0.43_dp, 1.0e-7_dp, 'where it touches')
    x = zeros_of(product_type([0.5_dp, 0.5_dp]), 0.0_dp, 1.0_dp, 1.0e-15_dp)
    call tap%ok(size(x) == 1, 'also where a sample is zero')
    x = zeros_of(product_type([0.5_dp - 1.0e-13_dp]), 0.0_dp, 1.0_dp, 1.0e-12_dp)
    call tap%ok(size(x) == 1, 'a simple one less than the noise before a sample')
    call tap%near(x(1), 0.5_dp, 1.0e-12_dp, 'is where it is')
    x = zeros_of(product_type([1.0e-4_dp]), 0.0_dp, 1.0_dp, 0.0_dp)
    call tap%ok(size(x) == 1, 'one between an end and the first sample')
    x = zeros_of(product_type([-0.1_dp, 1.1_dp]), 0.0_dp, 1.0_dp, 0.0_dp)
    call tap%ok(size(x) == 0, 'none outside')
    x = zeros_of(product_type([0.0_dp, 1.0_dp]), 0.0_dp, 1.0_dp, 1.0e-15_dp)
    call tap%ok(size(x) == 0, 'the ends themselves are none')
    x = zeros_of(product_type([0.5_dp]), 0.0_dp, 1.0_dp, 1.0_dp)
    call tap%ok(size(x) == 0, 'nothing but noise has none')
    call tap%near(zero_between(product_type([1000.25_dp]), 0.0_dp, 2000.0_dp), 1000.25_dp, 0.0_dp, &
        'a bracket is closed to the last bit')
    sample = samples_of(product_type([0.1_dp, 0.5_dp, 0.9_dp]), 0.0_dp, 1.0_dp)
    allocate (places(2, 0))
    places = brackets_among(product_type([0.1_dp, 0.5_dp, 0.9_dp]), sample, 0.0_dp)
    call tap%ok(size(places, 2) == 3, 'samples that are known give a bracket for each zero')
    call tap%ok(all(places(1, :) < [0.1_dp, 0.5_dp, 0.9_dp] .and. places(2, :) > [0.1_dp, &
        0.5_dp, 0.9_dp]), 'about it')
    sample%y = 1.0_dp + 1.0e-15_dp*sin(1.0e3_dp*sample%x)
    places = brackets_among(product_type([0.43_dp, 0.4301_dp]), sample, 0.0_dp)
    call tap%ok(size(places, 2) == 0, &
        'between samples that round-off alone tells apart no pair is sought')
    call compare_levels()
    x = sample_points(2.0_dp, 4.0_dp)
    call tap%ok(all(x > 2.0_dp .and. x < 4.0_dp), 'samples are inside')
    call tap%ok(all(x(2:) > x(:size(x) - 1)), 'and in order')
    call tap%ok(maxval(x(2:) - x(:size(x) - 1)) < 2.0_dp/40.0_dp, 'a fortieth apart at the most')
    call tap%finish()

contains

    !> Where a cube passes 2,000 levels: what one after another says, an extreme that is known, and
    !> the cube root of the C library.
    subroutine compare_levels()
        real(dp) :: levels(2000), zeros(2000), pairs(2, 2000)
        integer :: i, wrong

        levels = [(0.004_dp*real(i, dp) - 4.0_dp, i=1, 2000)]
        pairs = spread([-3.0_dp, 2.5_dp], 2, 2000)
        pairs(:, 7) = 0.25_dp
        call zeros_between(product_type([0.0_dp, 0.0_dp, 0.0_dp]), pairs, levels, zeros)
        call tap%ok(zeros(7) == 0.25_dp, 'of one place that')
        zeros(7) = sign(abs(levels(7))**(1.0_dp/3.0_dp), levels(7))
        call tap%near(maxval(abs(zeros - sign(abs(levels)**(1.0_dp/3.0_dp), levels))), 0.0_dp, &
            1.0e-15_dp, 'a cube passes many levels at their roots')
        wrong = 0
        do i = 1, 2000, 37
            if (zeros(i) /= zero_between(product_type([0.0_dp, 0.0_dp, 0.0_dp], &
                levels(i)), -3.0_dp, 2.5_dp)) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, 'where one search after another finds them')
    end subroutine compare_levels

end program test_zeros
