!> The search for a zero between two places: of a square, of a step, and of places that are one.
program test_zero_search
    use base_kinds, only: dp
    use geom_zero_search, only: changes, narrow, new_search, search_type, zero_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(search_type) :: search
    logical :: is_between

    search = new_search([0.0_dp, 2.0_dp], [-2.0_dp, 2.0_dp])
    call tap%ok(.not. search%is_over .and. search%next == 1.0_dp, 'the chord is asked first')
    is_between = .true.
    do while (.not. search%is_over)
        is_between = is_between .and. search%next > minval(search%x) &
            .and. search%next < maxval(search%x)
        call narrow(search, search%next**2 - 2.0_dp)
    end do
    call tap%ok(is_between, 'then values between')
    call tap%near(zero_of(search), sqrt(2.0_dp), 2.3e-16_dp, 'until the zero is known')
    call tap%ok(search%steps < 25, 'which is sooner than by halving')
    search = new_search([-3.0_dp, 1.0_dp], [-1.0_dp, 1.0_dp])
    do while (.not. search%is_over)
        call narrow(search, merge(1.0_dp, -1.0_dp, search%next >= 0.1_dp))
    end do
    call tap%near(maxval(search%x) - minval(search%x), spacing(0.1_dp), 0.0_dp, &
        'a step is closed in upon to the last bit')
    search = new_search([4.0_dp, 4.0_dp], [1.0_dp, 1.0_dp])
    call tap%ok(search%is_over .and. zero_of(search) == 4.0_dp, 'one place is the zero')
    call tap%ok(changes(-1.0_dp, 0.0_dp) .and. .not. changes(2.0_dp, 0.0_dp), 'zeros have a sign')
    call tap%finish()
end program test_zero_search
