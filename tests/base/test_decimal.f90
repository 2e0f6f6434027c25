!> Exact decimals against the runtime's correctly rounded read, and grids against real128.
program test_decimal
    use, intrinsic :: iso_fortran_env, only: real128
    use base_decimal, only: decimal_type, grid_type, largest_power, new_grid, to_real
    use base_error, only: cause, error_type
    use base_kinds, only: dp, i64
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_by_hand()
    call check_against_read()
    call check_grids()
    call check_random_grids()
    call check_bad_grids()
    call tap%finish()

contains

    !> Values whose bit pattern is known.
    subroutine check_by_hand()
        call tap%ok(bits(decimal_type()) == 0_i64, 'a decimal begins as zero')
        call tap%ok(bits(decimal_type(1_i64, -1)) == int(z'3FB999999999999A', i64), &
            '.1 is 1999 9999 9999 99A(hex) over 2**56')
        call tap%ok(bits(decimal_type(-1000_i64, -2)) == int(z'C024000000000000', i64), &
            '-10.00 is -10')
        call tap%ok(bits(decimal_type(9007199254740993_i64, 0)) == int(z'4340000000000000', i64), &
            '2**53 + 1 rounds to even, down')
        call tap%ok(bits(decimal_type(9007199254740995_i64, 0)) == int(z'4340000000000002', i64), &
            '2**53 + 3 rounds to even, up')
        call tap%ok(bits(decimal_type(1_i64, 23)) == int(z'44B52D02C7E14AF6', i64), &
            '1E23 is the double below it')
        call tap%ok(bits(decimal_type(999999999999999999_i64, -18)) == bits(decimal_type(1_i64, &
            0)), &
            'eighteen nines round to one')
    end subroutine check_by_hand

    !> Random decimals, short and long, against the runtime's read.
    subroutine check_against_read()
        type(random_type) :: random
        type(decimal_type) :: d
        character(40) :: text
        real(dp) :: expected
        integer :: i, wrong

        wrong = 0
        do i = 1, 100000
            d%digits = int(random%sign()*10.0_dp**random%between(0.0_dp, 18.0_dp), i64)
            d%power = nint(random%between(-30.0_dp, 12.0_dp))
            if (random%one_in(4)) d%power = nint(random%between(-1.0_dp, 1.0_dp)*largest_power)
            write (text, '(i0,a,i0)') d%digits, '.e', d%power
            read (text, *) expected
            if (bits(d) /= transfer(expected, 0_i64)) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, '100000 random decimals are the doubles the runtime reads')
    end subroutine check_against_read

    !> Grids worked by hand.
    subroutine check_grids()
        type(grid_type) :: grid
        type(error_type), allocatable :: error

        call new_grid(decimal_type(0_i64, 0), decimal_type(1_i64, -1), grid, error)
        call tap%ok(.not. allocated(error), 'steps of .1 from 0 make a grid')
        call tap%near(grid%ordinate(3_i64), 0.3_dp, 0.0_dp, 'three steps of .1 are .3')
        call tap%near(grid%ordinate(-7_i64), -0.7_dp, 0.0_dp, 'seven steps back are -.7')
        call new_grid(decimal_type(-30_i64, 0), decimal_type(5_i64, 0), grid, error)
        call tap%near(grid%ordinate(0_i64), -30.0_dp, 0.0_dp, 'no step is the start')
        call tap%near(grid%ordinate(6_i64), 0.0_dp, 0.0_dp, 'six steps of 5 from -30 are 0')
        call tap%near(grid%steps_to(50.0_dp), 16.0_dp, 0.0_dp, 'it is 16 steps to 50')
        call tap%near(grid%steps_to(-31.0_dp), -0.2_dp, 1.0e-15_dp, &
            'and a fifth of one back to -31')
        call new_grid(decimal_type(-30_i64, 0), decimal_type(-1_i64, -12), grid, error)
        call tap%near(grid%step_length(), 1.0e-12_dp, 0.0_dp, &
            'a step keeps its length beside a large start')
        call new_grid(decimal_type(18_i64, 0), decimal_type(-3638_i64, -3), grid, error)
        call tap%near(grid%ordinate(2_i64), 10.724_dp, 0.0_dp, &
            'start and step may differ in decimals')
        call new_grid(decimal_type(12345678_i64, -3), decimal_type(1_i64, 3), grid, error)
        call tap%near(grid%ordinate(1_i64), 13345.678_dp, 0.0_dp, 'also the other way round')
        call new_grid(decimal_type(0_i64, -80), decimal_type(1_i64, 3), grid, error)
        call tap%ok(.not. allocated(error), 'a zero start fits any step')
        call tap%near(grid%ordinate(2_i64), 2000.0_dp, 0.0_dp, 'and starts at zero')
    end subroutine check_grids

    !> Random grids: the nearest double to the exact ordinate. Quadruple precision holds it.
    subroutine check_random_grids()
        type(random_type) :: random
        type(decimal_type) :: start, step
        type(grid_type) :: grid
        type(error_type), allocatable :: error
        real(real128) :: exact
        integer :: i, wrong
        integer(i64) :: k

        wrong = 0
        do i = 1, 20000
            start = decimal_type(int(random%between(-1.0e8_dp, 1.0e8_dp), i64), &
                nint(random%between(-5.0_dp, 0.0_dp)))
            step = decimal_type(int(random%between(1.0_dp, 1.0e6_dp), i64), &
                nint(random%between(-5.0_dp, 0.0_dp)))
            k = int(random%between(-1.0e5_dp, 1.0e5_dp), i64)
            call new_grid(start, step, grid, error)
            ! Whole numbers of 10**-5 below 10**17, exact, and one rounding of 113 bits.
            exact = (real(start%digits, real128)*10.0_real128**(5 + start%power) &
                + real(k*step%digits, real128)*10.0_real128**(5 + step%power))/10.0_real128**5
            if (allocated(error)) then
                wrong = wrong + 1
            else if (transfer(grid%ordinate(k), 0_i64) /= transfer(real(exact, dp), 0_i64)) then
                wrong = wrong + 1
            end if
        end do
        call tap%ok(wrong == 0, '20000 random steps are the nearest doubles')
    end subroutine check_random_grids

    !> Increments that can't step.
    subroutine check_bad_grids()
        type(grid_type) :: grid
        type(error_type), allocatable :: error

        call new_grid(decimal_type(1_i64, 0), decimal_type(0_i64, 0), grid, error)
        call tap%ok(allocated(error), 'a zero step is refused')
        if (allocated(error)) then
            call tap%ok(error%cause == cause%increment, 'as an increment')
            call tap%same(error%message, 'the increment is zero', 'in plain words')
        end if
        call new_grid(decimal_type(1_i64, 19), decimal_type(1_i64, 0), grid, error)
        call tap%ok(allocated(error), 'a start 19 powers of ten above the step is refused')
        call new_grid(decimal_type(1_i64, 18), decimal_type(1_i64, 0), grid, error)
        call tap%ok(.not. allocated(error), '18 are not')
        call new_grid(decimal_type(1_i64, -13), decimal_type(1_i64, 0), grid, error)
        call tap%ok(allocated(error), 'a step 13 powers of ten above the start is refused')
        if (allocated(error)) call tap%same(error%message, &
            'the increment and the first ordinate have too many digits to step exactly', &
            'with the reason')
        call new_grid(decimal_type(999999999999999999_i64, 12), &
            decimal_type(-999999999999999999_i64, 0), &
            grid, error)
        call tap%near(grid%ordinate(100000_i64), &
            1.0e30_dp - 1.0e23_dp, &
            spacing(1.0e30_dp), 'eighteen figures and twelve zeros do not overflow')
        call new_grid(decimal_type(9144_i64, -1), decimal_type(12345678901234567_i64, -17), &
            grid, error)
        call tap%ok(.not. allocated(error), 'a step of seventeen decimals is taken')
        call tap%near(grid%ordinate(100000_i64), 13260.078901234567_dp, 0.0_dp, &
            'and stepped without a loss')
    end subroutine check_bad_grids

    !> The bit pattern of a decimal's double.
    integer(i64) function bits(d)
        type(decimal_type), intent(in) :: d !! the decimal
        bits = transfer(to_real(d), 0_i64)
    end function bits

end program test_decimal
