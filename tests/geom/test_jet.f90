!> A jet that is not set is a level curve at zero.
program test_jet
    use base_kinds, only: dp
    use geom_jet, only: jet_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(jet_type) :: jet

    call tap%ok(all([jet%value, jet%first, jet%second] == 0.0_dp), &
        'an unset jet is zero, level and straight')
    jet = jet_type(1.0_dp, 2.0_dp, 3.0_dp)
    call tap%ok(jet%value == 1.0_dp .and. jet%first == 2.0_dp .and. jet%second == 3.0_dp, &
        'a jet is made of value, slope and second derivative in this order')
    call tap%finish()
end program test_jet
