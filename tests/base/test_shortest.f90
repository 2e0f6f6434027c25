!> The fewest figures in the columns of a line; `test_digits` proves that they are the fewest.
program test_shortest
    use base_kinds, only: dp
    use base_shortest, only: put_power, put_shortest, shortest_length, widest_shortest
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(40) :: line
    integer :: next

    line = 'x='
    next = 3
    call put_shortest(-0.1_dp, line, next)
    call tap%same(line(:next), 'x=-0.1 ', 'figures go on behind what stands there')
    call put_power('e', -7, line, next)
    call tap%same(line(:next), 'x=-0.1e-07 ', 'a power of ten has two figures')
    call tap%ok(shortest_length(-0.1_dp) == 4, 'the length is known before')
    call tap%ok(shortest_length(-1.2345678901234567e-300_dp) == widest_shortest - 0 .or. &
        shortest_length(-1.2345678901234567e-300_dp) < widest_shortest, 'the longest has room')
    call tap%finish()

end program test_shortest
