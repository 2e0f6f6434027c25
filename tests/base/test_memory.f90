!> How much memory there is; `stream.t` runs LOFT with little, `limits.t` with small stacks.
program test_memory
    use base_kinds, only: i64
    use base_memory, only: has_little_memory, stack_room
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    logical :: before

    before = has_little_memory()
    call tap%ok(before .eqv. has_little_memory(), 'asking again gives the same')
    call tap%ok(stack_room() >= 65536_i64, 'a program that runs has a stack')
    call tap%finish()

end program test_memory
