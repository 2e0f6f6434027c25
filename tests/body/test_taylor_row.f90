!> Rows of numbers with derivatives: f = (2 + s)**2 and its like, by hand.
program test_taylor_row
    use base_kinds, only: dp
    use body_taylor_row, only: cross, operator(*), operator(-), taylor_row_type
    use geom_twofold_short, only: width
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(taylor_row_type) :: a, b, c
    integer :: i

    a%value = [(real(i, dp), i=1, width)]
    a%first = 1.0_dp
    a%second = 0.0_dp
    b = a*a
    call tap%ok(all(b%value == a%value**2) .and. all(b%first == 2.0_dp*a%value) &
        .and. all(b%second == 2.0_dp), 's**2, 2 s, 2')
    c = b*a
    call tap%ok(all(c%first == 3.0_dp*a%value**2) .and. all(c%second == 6.0_dp*a%value), &
        's**3: 3 s**2, 6 s')
    c = c - b
    call tap%ok(all(c%value == a%value**3 - a%value**2) .and. &
        all(c%second == 6.0_dp*a%value - 2.0_dp), 'a difference')
    c = cross([a, b], [b, a])
    call tap%ok(all(c%value == a%value**2 - a%value**4) .and. &
        all(c%first == 2.0_dp*a%value - 4.0_dp*a%value**3), 'a product of vectors')
    call tap%finish()
end program test_taylor_row
