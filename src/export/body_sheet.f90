!> The sheet of a lines plan: where profile, half-breadth plan and body plan stand, to one scale.
!>
!>     profile     body plan      x = STA, y = WL         x = body_centre + BL, y = WL
!>     plan        title block    x = STA, y = plan_centre + BL
!>
!> The sheet is measured in the units of the deck. Its profile has the deck's own coordinates; the
!> waterlines of the profile run on into the body plan, and its stations into the plan.
module export_body_sheet
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: sheet_type, new_sheet, in_profile, in_plan, in_body_plan, round_step, round_steps

    !> The sheet.
    type :: sheet_type
        real(dp) :: low(3) = 0.0_dp         !! least STA, BL and WL shown, deck units
        real(dp) :: high(3) = 0.0_dp        !! greatest, deck units
        real(dp) :: body_low = 0.0_dp       !! least BL of the body plan, deck units
        real(dp) :: plan_centre = 0.0_dp    !! y of BL 0 in the plan, deck units
        real(dp) :: body_centre = 0.0_dp    !! x of BL 0 in the body plan, deck units
        real(dp) :: block(2) = 0.0_dp       !! upper left corner of the title block, deck units
        real(dp) :: paper_low(2) = 0.0_dp   !! lower left corner of the sheet, deck units
        real(dp) :: paper_high(2) = 0.0_dp  !! upper right corner, deck units
        real(dp) :: dot = 1.0_dp            !! deck units of a dot of the sheet
    end type sheet_type

    !> Dots of the sheet: width and height at most; margins for words; between the views; title
    !> block and room above it.
    real(dp), parameter :: most_dots(2) = [1240.0_dp, 1000.0_dp], edge = 62.0_dp, between = 66.0_dp
    real(dp), parameter :: block_size(2) = [290.0_dp, 180.0_dp], above_block = 34.0_dp

contains

    !> The sheet for what lies between two corners of space.
    pure type(sheet_type) function new_sheet(low, high, is_split) result(sheet)
        real(dp), intent(in) :: low(3)          !! least STA, BL and WL, deck units
        real(dp), intent(in) :: high(3)         !! greatest, deck units
        logical, intent(in) :: is_split         !! the body plan has a port half too
        real(dp) :: reach(3), wide, tall

        sheet%low = low
        sheet%high = high
        sheet%body_low = low(2)
        if (is_split) sheet%body_low = -high(2)
        reach = high - low
        wide = high(2) - sheet%body_low
        tall = reach(2) + reach(3)
        sheet%dot = max((reach(1) + wide)/(most_dots(1) - 2.0_dp*edge - between), &
            reach(1)/(most_dots(1) - 2.0_dp*edge - between - block_size(1)), &
            tall/(most_dots(2) - 2.0_dp*edge - between))
        sheet%plan_centre = low(3) - between*sheet%dot - high(2)
        sheet%body_centre = high(1) + between*sheet%dot - sheet%body_low
        sheet%block = [high(1) + between*sheet%dot, low(3) - above_block*sheet%dot]
        sheet%paper_low = [low(1), min(sheet%plan_centre + low(2), &
            sheet%block(2) - block_size(2)*sheet%dot)] - edge*sheet%dot
        sheet%paper_high = [sheet%block(1) + max(wide, block_size(1)*sheet%dot), high(3)] &
            + edge*sheet%dot
    end function new_sheet

    !> Points of space in the profile, by columns.
    pure function in_profile(at) result(xy)
        real(dp), intent(in) :: at(:, :) !! STA, BL, WL by columns, deck units
        real(dp) :: xy(2, size(at, 2))
        xy = at([1, 3], :)
    end function in_profile

    !> Points of space in the plan, by columns.
    pure function in_plan(sheet, at) result(xy)
        type(sheet_type), intent(in) :: sheet !! the sheet
        real(dp), intent(in) :: at(:, :)      !! STA, BL, WL by columns, deck units
        real(dp) :: xy(2, size(at, 2))
        xy = at([1, 2], :)
        xy(2, :) = sheet%plan_centre + xy(2, :)
    end function in_plan

    !> Points of space in the body plan, by columns.
    pure function in_body_plan(sheet, at) result(xy)
        type(sheet_type), intent(in) :: sheet !! the sheet
        real(dp), intent(in) :: at(:, :)      !! STA, BL, WL by columns, deck units
        real(dp) :: xy(2, size(at, 2))
        xy = at([2, 3], :)
        xy(1, :) = sheet%body_centre + xy(1, :)
    end function in_body_plan

    !> A step of 1, 2 or 5 and zeros that goes into a length about so many times.
    pure real(dp) function round_step(length, times) result(step)
        real(dp), intent(in) :: length  !! above zero
        integer, intent(in) :: times    !! 1 or more
        real(dp) :: rough, power

        rough = length/real(times, dp)
        power = 10.0_dp**floor(log10(rough))
        step = 10.0_dp*power
        if (rough < 7.0_dp*power) step = 5.0_dp*power
        if (rough < 3.5_dp*power) step = 2.0_dp*power
        if (rough < 1.5_dp*power) step = power
    end function round_step

    !> The multiples of a round step inside a range, ends not included, about so many.
    pure function round_steps(low, high, times) result(ordinates)
        real(dp), intent(in) :: low     !! least
        real(dp), intent(in) :: high    !! greatest
        integer, intent(in) :: times    !! 1 or more
        real(dp), allocatable :: ordinates(:)
        real(dp), parameter :: off_the_end = 0.05_dp
        real(dp) :: step
        integer :: i, first, last

        allocate (ordinates(0))
        if (.not. high > low) return
        step = round_step(high - low, times)
        first = ceiling(low/step + off_the_end)
        last = floor(high/step - off_the_end)
        ordinates = [(real(i, dp)*step, i = first, last)]
    end function round_steps

end module export_body_sheet
