!> Tests of the parameter along STA in which curves with vertical ends are smooth.
program test_drawing_path
    use base_kinds, only: dp
    use export_drawing_path, only: pace_of, paced
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), parameter :: step = 1.0e-6_dp
    real(dp) :: t, before, next, off, pace(2)
    logical :: rises
    integer :: i, k

    off = 0.0_dp
    do i = 0, 100
        t = real(i, dp)/100.0_dp
        off = max(off, abs(paced(3.0_dp, -5.0_dp, [1.0_dp, 1.0_dp], t) - (3.0_dp - 8.0_dp*t)))
    end do
    call tap%near(off, 0.0_dp, 4.0e-15_dp, 'with even paces the station is even')
    rises = .true.
    do k = 0, 8
        pace = [real(mod(k, 3), dp), real(k/3, dp)]
        before = 10.0_dp
        do i = 1, 1000
            next = paced(10.0_dp, 30.0_dp, pace, real(i, dp)/1000.0_dp)
            rises = rises .and. next > before
            before = next
        end do
        call tap%ok(same(paced(0.1_dp, 30.7_dp, pace, 0.0_dp), 0.1_dp) .and. &
            same(paced(0.1_dp, 30.7_dp, pace, 1.0_dp), 30.7_dp), 'both ends are exactly as given')
        call tap%near((paced(0.0_dp, 1.0_dp, pace, step))/step, pace(1), 1.0e-5_dp, &
            'the pace where it begins')
        call tap%near((1.0_dp - paced(0.0_dp, 1.0_dp, pace, 1.0_dp - step))/step, pace(2), &
            1.0e-5_dp, 'the pace where it ends')
    end do
    call tap%ok(rises, 'with all paces that are used it only goes ahead')
    call tap%near(pace_of(0.5_dp, 30.0_dp, -20.0_dp), 0.75_dp, 0.0_dp, &
        'the pace of a mean speed: slant times length over span')
    call tap%near(pace_of(1.0_dp, 300.0_dp, 20.0_dp), 2.0_dp, 0.0_dp, 'a pace is never above 2')
    call tap%near(pace_of(0.0_dp, 300.0_dp, 20.0_dp), 0.0_dp, 0.0_dp, 'a vertical end has none')
    call tap%finish()

contains

    !> The same number, all bits.
    logical function same(a, b)
        real(dp), intent(in) :: a, b
        same = abs(a - b) <= 0.0_dp
    end function same

end program test_drawing_path
