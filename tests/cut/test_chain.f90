!> Parts joined by their ends: open and closed chains, ends of a group first, crowds left open.
program test_chain
    use base_kinds, only: dp
    use cut_chain, only: chain_type, chains_of, part_type
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: near = 1.0e-9_dp
    type(tap_type) :: tap
    type(chain_type), allocatable :: chains(:)
    type(part_type) :: parts(4)

    allocate (chains(0))
    chains = chains_of([part(1, 2), part(3, 2), part(3, 4)], near)
    call tap%ok(size(chains) == 1 .and. .not. chains(1)%is_closed, &
        'three parts in a row are one open chain')
    call tap%ok(all(chains(1)%part == [1, -2, 3]), 'the middle one runs backwards')
    chains = chains_of([part(1, 2), part(2, 3), part(3, 1)], near)
    call tap%ok(size(chains) == 1 .and. chains(1)%is_closed, 'three in a ring are a closed one')
    call tap%ok(all(chains(1)%part == [1, 2, 3]), 'from the first on')
    chains = chains_of([part(1, 2), part(2, 1)], near)
    call tap%ok(chains(1)%is_closed .and. size(chains(1)%part) == 2, 'two may close a ring')
    chains = chains_of([part(1, 2), part(3, 4), part(5, 6)], near)
    call tap%ok(size(chains) == 3, 'parts that do not meet stay apart')
    chains = chains_of([part(2, 1), part(2, 3), part(2, 4)], near)
    call tap%ok(size(chains) == 3, 'three ends in a point are not joined')
    parts = [part(1, 2), part(2, 3), part(4, 2), part(2, 5)]
    parts(1)%group(2) = 7
    parts(2)%group(1) = 7
    chains = chains_of(parts, near)
    call tap%ok(size(chains) == 2, 'of four, those of a group are a pair, and so the others')
    call tap%ok(all(chains(1)%part == [1, 2]), 'the group')
    chains = chains_of(parts(:0), near)
    call tap%ok(size(chains) == 0, 'nothing has no chains')
    call tap%finish()

contains

    !> A part from one point of a row to another.
    type(part_type) function part(from, to)
        integer, intent(in) :: from, to
        part%ends(:, 1) = real(from, dp)
        part%ends(:, 2) = real(to, dp) + 1.0e-11_dp
    end function part

end program test_chain
