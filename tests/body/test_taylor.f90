!> Derivatives of products and sums against those worked by hand.
program test_taylor
    use base_kinds, only: dp
    use body_taylor, only: cross, operator(*), operator(+), operator(-), taylor_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(taylor_type) :: s, f

    s = taylor_type(3.0_dp, 1.0_dp)
    f = s*s*s
    call tap%ok(f%value == 27.0_dp .and. f%first == 27.0_dp .and. f%second == 18.0_dp, &
        's**3 at 3 is 27, its derivatives 27 and 18')
    f = s*s - s + taylor_type(1.0_dp)
    call tap%ok(f%value == 7.0_dp .and. f%first == 5.0_dp .and. f%second == 2.0_dp, &
        's**2 - s + 1 is 7, its derivatives 5 and 2')
    f = cross([s, s*s], [s*s, s])
    call tap%ok(f%value == -72.0_dp .and. f%first == -102.0_dp .and. f%second == -106.0_dp, &
        '(s, s**2) x (s**2, s) is s**2 - s**4')
    call tap%finish()
end program test_taylor
