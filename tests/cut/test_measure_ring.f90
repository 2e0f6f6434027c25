!> How sections join to rings.
program test_measure_ring
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use cut_measure_ring, only: find_opening, link_type, rings_at, sections_at
    use support_solids, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: half, whole, odd
    type(link_type), allocatable :: links(:)
    type(error_type), allocatable :: error
    character(:), allocatable :: why

    half = ellipsoid([5.0_dp, 4.0_dp, 3.0_dp])
    whole = mirrored_body(half)
    call rings_at(half, 0.0_dp, links, error)
    call tap%ok(size(links) == 2 .and. all(links%ring == 1), 'two quarters are one ring')
    call tap%ok(is_chain(links), 'end to end')
    call find_opening(half, links, why)
    call tap%same(why, '', 'which CLOSE closes')
    call rings_at(whole, 0.0_dp, links, error)
    call tap%ok(size(links) == 4 .and. all(links%ring == 1), 'four quarters are one ring')
    call tap%ok(is_chain(links) .and. is_chain(links([4, 1])), 'that comes back')
    call tap%ok(count(links%is_turned) == 2, 'two of them run through backwards')

    odd = whole
    odd%is_closed = .false.
    odd%sections = whole%sections([4, 1, 3, 2])
    call rings_at(odd, 0.0_dp, links, error)
    call tap%ok(is_chain(links) .and. all(links%ring == 1), 'the order of sections does not matter')
    call find_opening(odd, links, why)
    call tap%same(why, '', 'nor does CLOSE where the ring comes back')
    odd%sections = whole%sections([2, 3, 1])
    call rings_at(odd, 0.0_dp, links, error)
    call tap%ok(is_chain(links) .and. size(links) == 3, 'a ring grows at both its ends')
    call find_opening(odd, links, why)
    call tap%ok(len(why) > 0, 'three quarters are open')
    odd%sections = whole%sections([1, 4])
    call rings_at(odd, 0.0_dp, links, error)
    call tap%ok(maxval(links%ring) == 2, 'two quarters that do not meet are two rings')
    call find_opening(odd, links, why)
    call tap%ok(len(why) > 0, 'both open')
    call rings_at(odd, -5.0_dp, links, error)
    call tap%ok(size(links) == 0 .and. .not. allocated(error), 'a nose is no arc and no error')
    call find_opening(odd, links, why)
    call tap%same(why, '', 'and is not open')
    odd%sections(1)%to = 1.0_dp
    call tap%ok(size(sections_at(odd, 1.0_dp)) == 2 .and. size(sections_at(odd, 1.1_dp)) == 1, &
        'a section ends where its range ends')
    odd%sections(1)%line = [1, 1, 3]
    call rings_at(odd, 0.0_dp, links, error)
    call tap%ok(allocated(error), 'a section without an arc is an error')
    if (allocated(error)) call tap%ok(error%cause == cause%points_coincide, 'of its own cause')
    call tap%finish()

contains

    !> True where each arc begins where the one before ends.
    logical function is_chain(links)
        type(link_type), intent(in) :: links(:)
        integer :: i
        is_chain = .true.
        do i = 2, size(links)
            if (norm2(links(i)%arc%start - links(i - 1)%arc%finish) > 1.0e-12_dp) is_chain = .false.
        end do
    end function is_chain

end program test_measure_ring
