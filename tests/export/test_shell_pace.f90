!> Tests of the pace of the station: ends, speeds, a circle that it follows.
program test_shell_pace
    use base_kinds, only: dp
    use body_taylor, only: taylor_type
    use export_shell_pace, only: conic_pace, divisor_at, pace_type, power_pace, station_at
    use support_bodies, only: conic_view, constant_view, control_line, level, straight_view, upright
    use body_line, only: line_type
    use geom_arc, only: end_type
    use geom_chain, only: chain_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: straight, round, steep, whole
    type(chain_type) :: none

    straight = control_line('S', straight_view([0.0_dp, 1.0_dp], [10.0_dp, 6.0_dp]), none)
    round = control_line('R', conic_view(end_type([0.0_dp, 0.0_dp], upright), [4.0_dp, 8.0_dp], &
        end_type([10.0_dp, 10.0_dp], level)), none)
    steep = control_line('P', constant_view(0.0_dp), conic_view(end_type([0.0_dp, 0.0_dp], &
        [1.0_dp, 900.0_dp]), [4.0_dp, 8.0_dp], end_type([10.0_dp, 10.0_dp], level)))
    whole = control_line('W', conic_view(end_type([0.0_dp, 0.0_dp], upright), [5.0_dp, 5.0_dp], &
        end_type([10.0_dp, 0.0_dp], upright)), none)

    call judge(power_pace([straight], 0.0_dp, 10.0_dp), [10.0_dp, 10.0_dp], 'straight lines')
    call judge(power_pace([steep], 0.0_dp, 10.0_dp), [10.0_dp, 10.0_dp], 'a steep line')
    call judge(power_pace([straight, round], 0.0_dp, 10.0_dp), [0.0_dp, 20.0_dp], 'blunt fore')
    call judge(power_pace([whole], 5.0_dp, 10.0_dp), [10.0_dp, 0.0_dp], 'blunt aft')
    call judge(power_pace([whole], 0.0_dp, 10.0_dp), [0.0_dp, 0.0_dp], 'blunt at both ends')
    call judge(conic_pace([straight, round], 0.0_dp, 10.0_dp), [0.0_dp, 0.0_dp], 'along a conic')
    call judge_circle()
    call tap%ok(.not. conic_is([straight], 10.0_dp), 'straight lines are no conic to follow')
    call tap%ok(.not. conic_is([whole], 10.0_dp), &
        'nor is half an ellipse, whose weight is zero')
    call tap%ok(conic_is([whole], 5.0_dp), 'but a quarter of it is')
    call tap%finish()

contains

    !> A pace leads from end to end, rising, with the derivative that differences have; at a blunt
    !> end it stands still, else it has the speed given (where it is not zero) there.
    subroutine judge(pace, speeds, name)
        type(pace_type), intent(in) :: pace
        real(dp), intent(in) :: speeds(2)
        character(*), intent(in) :: name
        type(taylor_type) :: sta, before, after
        real(dp) :: u, worst, last
        logical :: rises
        integer :: i
        real(dp), parameter :: h = 1.0e-5_dp
        sta = station_at(pace, 0.0_dp)
        call tap%ok(sta%value == pace%from, name//': begins at its first station, exactly')
        if (.not. pace%is_conic) call tap%ok(pace%is_blunt(1) .eqv. sta%first == 0.0_dp, &
            name//': stands still where lines are vertical')
        if (speeds(1) > 0.0_dp) call tap%near(sta%first, speeds(1), pace%to, name//': is paced')
        sta = station_at(pace, 1.0_dp)
        call tap%ok(sta%value == pace%to, name//': ends at its last station, exactly')
        worst = 0.0_dp
        rises = .true.
        last = pace%from
        do i = 1, 199
            u = real(i, dp)/200.0_dp
            sta = station_at(pace, u)
            before = station_at(pace, u - h)
            after = station_at(pace, u + h)
            worst = max(worst, abs((after%value - before%value)/(2.0_dp*h) - sta%first))
            rises = rises .and. sta%value > last
            last = sta%value
        end do
        call tap%ok(rises .and. last < pace%to, name//': rises')
        call tap%ok(worst < 1.0e-7_dp, name//': its derivative is that of differences')
    end subroutine judge

    !> Along a quarter of a circle: x = X/D, y = Y/D, x**2 + y**2 - 20 x = 0 in the same u.
    subroutine judge_circle()
        type(pace_type) :: pace
        type(taylor_type) :: sta
        real(dp) :: u, w, y, worst, nearest
        integer :: i
        pace = conic_pace([round], 0.0_dp, 10.0_dp)
        w = sqrt(0.5_dp)
        worst = 0.0_dp
        nearest = 0.0_dp
        do i = 0, 20
            u = real(i, dp)/20.0_dp
            sta = station_at(pace, u)
            y = (2.0_dp*u*(1.0_dp - u)*w*10.0_dp + u**2*10.0_dp)/divisor_at(pace, u)
            worst = max(worst, abs((sta%value - 10.0_dp)**2 + y**2 - 100.0_dp))
            nearest = max(nearest, abs(divisor_at(pace, u) - ((1.0_dp - u)**2 &
                + 2.0_dp*u*(1.0_dp - u)*w + u**2)))
        end do
        call tap%ok(worst < 1.0e-12_dp, 'a station along a circle has the circle''s own ordinates')
        call tap%ok(nearest < 1.0e-15_dp, 'its divisor is that of the weight cos 45')
    end subroutine judge_circle

    !> True where a conic is followed from station 0.
    logical function conic_is(lines, to)
        type(line_type), intent(in) :: lines(:)
        real(dp), intent(in) :: to
        type(pace_type) :: pace
        pace = conic_pace(lines, 0.0_dp, to)
        conic_is = pace%is_conic
    end function conic_is

end program test_shell_pace
