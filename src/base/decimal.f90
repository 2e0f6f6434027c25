!> Exact decimal numbers: what is punched on a card before any rounding, `digits * 10**power`.
!> Tables are stepped in decimals, so that the fourth step of .1 is the number nearest to .4.
module base_decimal
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp, i128, i64
    implicit none (type, external)
    private

    public :: decimal_type, grid_type, new_grid, to_real

    !> Largest power of ten of a card field, which beyond it is refused as out of range. It is more
    !> than a System/360 number holds (7.2E75), and so little that no product of three coordinates
    !> overflows a double.
    integer, parameter, public :: largest_power = 80

    !> An exact decimal number, `digits * 10**power`.
    type :: decimal_type
        integer(i64) :: digits = 0 !! signed whole number, at most 18 digits
        integer :: power = 0       !! power of ten, -290 to 280; on a card to `largest_power`
    end type decimal_type

    !> Stepped ordinates `start + k*step`, k any whole number, worked exactly.
    type :: grid_type
        private
        integer(i128) :: start = 0  !! start in units of 10**power
        integer(i128) :: step = 0   !! step in the same units
        integer :: power = 0        !! the common power of ten
    contains
        procedure :: ordinate
        procedure :: put_ordinates
        procedure :: steps_to
        procedure :: step_length
    end type grid_type

    !> Powers of ten that a double holds exactly.
    integer, parameter :: exact_powers = 22
    real(dp), parameter, public :: tens(0:exact_powers) = [1.0e0_dp, 1.0e1_dp, 1.0e2_dp, 1.0e3_dp, &
        1.0e4_dp, 1.0e5_dp, 1.0e6_dp, 1.0e7_dp, 1.0e8_dp, 1.0e9_dp, 1.0e10_dp, 1.0e11_dp, &
        1.0e12_dp, 1.0e13_dp, 1.0e14_dp, 1.0e15_dp, 1.0e16_dp, 1.0e17_dp, 1.0e18_dp, 1.0e19_dp, &
        1.0e20_dp, 1.0e21_dp, 1.0e22_dp]
    !> Whole numbers below this are doubles.
    integer(i128), parameter :: exact_whole = 2_i128**53

    interface to_real
        module procedure decimal_to_real
    end interface to_real

contains

    !> The double nearest to a decimal.
    elemental real(dp) function decimal_to_real(d) result(x)
        type(decimal_type), intent(in) :: d !! any decimal
        ! What most fields hold, without a number of 128 bits.
        if (abs(d%digits) < 2_i64**53 .and. d%power <= 0 .and. d%power >= -exact_powers) then
            x = real(d%digits, dp)/tens(-d%power)
        else
            x = scaled_real(int(d%digits, i128), d%power)
        end if
    end function decimal_to_real

    !> Puts start and step on a common power of ten.
    !>
    !> Fails with `cause%increment` where the step is zero, or where start and step have so many
    !> digits between them that a start of 36 and a step of 30 don't hold them: a table of 10**7
    !> rows stays within the 38 digits of a whole number.
    pure subroutine new_grid(start, step, grid, error)
        type(decimal_type), intent(in) :: start             !! first ordinate, deck units
        type(decimal_type), intent(in) :: step              !! increment, deck units, not zero
        type(grid_type), intent(out) :: grid                !! the stepped ordinates
        type(error_type), allocatable, intent(out) :: error !! see above
        integer, parameter :: widest_start = 18, widest_step = 12

        if (step%digits == 0) then
            call fail(error, cause%increment, 'the increment is zero')
            return
        end if
        grid%power = min(start%power, step%power)
        if (start%digits == 0) grid%power = step%power
        if (step%power - grid%power > widest_step .or. &
            (start%digits /= 0 .and. start%power - grid%power > widest_start)) then
            call fail(error, cause%increment, &
                'the increment and the first ordinate have too many digits to step exactly')
            return
        end if
        if (start%digits /= 0) then
            grid%start = raised(start%digits, start%power - grid%power)
        end if
        grid%step = raised(step%digits, step%power - grid%power)
    end subroutine new_grid

    !> A whole number times a power of ten that 38 digits hold.
    elemental integer(i128) function raised(digits, power)
        integer(i64), intent(in) :: digits !! signed whole number, at most 18 digits
        integer, intent(in) :: power       !! power of ten, 0 to 18
        raised = int(digits, i128)*10_i128**int(power, i128)
    end function raised

    !> The double nearest to `start + k*step`.
    elemental real(dp) function ordinate(grid, k)
        class(grid_type), intent(in) :: grid !! the stepped ordinates
        integer(i64), intent(in) :: k        !! which step, any sign
        ordinate = scaled_real(grid%start + int(k, i128)*grid%step, grid%power)
    end function ordinate

    !> The doubles nearest to `start + k*step`, of steps one after the other.
    pure subroutine put_ordinates(grid, first, stride, values)
        class(grid_type), intent(in) :: grid    !! the stepped ordinates
        integer(i64), intent(in) :: first       !! the first step wanted
        integer(i64), intent(in) :: stride      !! from a step to the next, 1 or -1
        real(dp), intent(out) :: values(:)      !! the ordinates
        integer(i128) :: last
        real(dp) :: ten, from, by
        integer :: i

        last = grid%start + int(first + stride*size(values, kind=i64), i128)*grid%step
        if (max(abs(grid%start), abs(grid%start + int(first, i128)*grid%step), abs(last)) &
            < exact_whole .and. grid%power <= 0 .and. grid%power >= -exact_powers) then
            ! Whole numbers that a double holds: only the quotient is rounded.
            ten = tens(-grid%power)
            from = real(grid%start + int(first, i128)*grid%step, dp)
            by = real(stride*int(grid%step, i64), dp)
            do i = 1, size(values)
                values(i) = (from + real(i - 1, dp)*by)/ten
            end do
        else
            do i = 1, size(values)
                values(i) = grid%ordinate(first + stride*int(i - 1, i64))
            end do
        end if
    end subroutine put_ordinates

    !> The number of steps from the start to a value, not rounded: start + steps_to*step = x.
    elemental real(dp) function steps_to(grid, x)
        class(grid_type), intent(in) :: grid !! the stepped ordinates
        real(dp), intent(in) :: x            !! an ordinate, deck units
        steps_to = (x - grid%ordinate(0_i64))/scaled_real(grid%step, grid%power)
    end function steps_to

    !> The length of a step, however small beside the start.
    elemental real(dp) function step_length(grid)
        class(grid_type), intent(in) :: grid !! the stepped ordinates
        step_length = abs(scaled_real(grid%step, grid%power))
    end function step_length

    !> The double nearest to `digits * 10**power`: one exact quotient or product where both fit a
    !> double exactly, else the runtime's correctly rounded read.
    elemental real(dp) function scaled_real(digits, power) result(x)
        integer(i128), intent(in) :: digits !! signed whole number
        integer, intent(in) :: power        !! power of ten
        character(64) :: text

        if (abs(digits) < exact_whole .and. abs(power) <= exact_powers) then
            if (power < 0) then
                x = real(digits, dp)/tens(-power)
            else
                x = real(digits, dp)*tens(power)
            end if
        else
            write (text, '(i0,"e",i0)') digits, power
            read (text, *) x
        end if
    end function scaled_real

end module base_decimal
