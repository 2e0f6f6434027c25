!> Tests of the sheet of a lines plan: common scales, no view on another; round steps by hand.
program test_body_sheet
    use base_kinds, only: dp
    use export_body_sheet, only: in_body_plan, in_plan, in_profile, new_sheet, round_step, &
        round_steps, sheet_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), parameter :: point(3, 1) = reshape([40.0_dp, 6.0_dp, -3.0_dp], [3, 1])

    call test_sheet([0.0_dp, 0.0_dp, -10.0_dp], [280.0_dp, 22.0_dp, 40.0_dp], 'a long body')
    call test_sheet([5000.0_dp, 0.0_dp, 100.0_dp], [5001.0_dp, 22.0_dp, 190.0_dp], 'a tall body')
    call tap%near(round_step(100.0_dp, 10), 10.0_dp, 1.0e-13_dp, 'ten steps of 100 are 10')
    call tap%near(round_step(21.5_dp, 5), 5.0_dp, 1.0e-13_dp, 'five of 21.5 are 5')
    call tap%near(round_step(0.012_dp, 5), 0.002_dp, 1.0e-16_dp, 'five of .012 are .002')
    call tap%near(round_step(9.0_dp, 1), 10.0_dp, 1.0e-13_dp, 'one of 9 is 10')
    call tap%ok(all(abs(round_steps(0.0_dp, 21.5_dp, 5) - [5.0_dp, 10.0_dp, 15.0_dp, 20.0_dp]) &
        < 1.0e-13_dp), 'round steps leave out the ends')
    call tap%ok(size(round_steps(3.0_dp, 3.0_dp, 5)) == 0, 'there are none in no range')
    call tap%finish()

contains

    !> Tests the sheet of a room.
    subroutine test_sheet(low, high, name)
        real(dp), intent(in) :: low(3)
        real(dp), intent(in) :: high(3)
        character(*), intent(in) :: name
        type(sheet_type) :: sheet
        real(dp) :: xy(2, 1)

        sheet = new_sheet(low, high, .true.)
        xy = in_profile(point)
        call tap%ok(all(abs(xy(:, 1) - [40.0_dp, -3.0_dp]) <= 0.0_dp), &
            name//': the profile has the coordinates of the deck')
        call tap%ok(sheet%plan_centre + high(2) < low(3), name//': the plan is below the profile')
        call tap%ok(sheet%body_centre - high(2) > high(1), name//': the body plan is behind it')
        xy = in_plan(sheet, point)
        call tap%near(xy(1, 1), 40.0_dp, 0.0_dp, name//': the plan has the stations of the profile')
        call tap%near(xy(2, 1) - sheet%plan_centre, 6.0_dp, 1.0e-9_dp, name//': and its scale')
        xy = in_body_plan(sheet, point)
        call tap%near(xy(2, 1), -3.0_dp, 0.0_dp, name//': the body plan has its waterlines')
        call tap%near(xy(1, 1) - sheet%body_centre, 6.0_dp, 1.0e-9_dp, name//': and its scale')
        call tap%ok(all(sheet%paper_low < [low(1), sheet%plan_centre]) .and. &
            all(sheet%paper_high > [sheet%body_centre + high(2), high(3)]), &
            name//': all of it is on the sheet')
        sheet = new_sheet(low, high, .false.)
        call tap%near(sheet%body_low, low(2), 0.0_dp, name//': a body plan in one piece')
    end subroutine test_sheet

end program test_body_sheet
