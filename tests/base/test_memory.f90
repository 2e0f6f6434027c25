!> How much memory there is; `stream.t` runs LOFT with little.
program test_memory
    use base_memory, only: has_little_memory
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    logical :: before

    before = has_little_memory()
    call tap%ok(before .eqv. has_little_memory(), 'asking again gives the same')
    call tap%finish()

end program test_memory
