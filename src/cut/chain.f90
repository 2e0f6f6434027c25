!> Outlines as chains of tracks or arcs: which ends meet, and in which order the parts then stand.
!>
!> Two ends meet where they are one point, as far as the arithmetic goes. Where more than two ends
!> are in a point, those of one section that turn back into each other there are a pair; the others
!> stay open, rather than be joined wrongly.
module cut_chain
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: part_type, chain_type, chains_of

    !> A part of an outline, by its ends.
    type :: part_type
        real(dp) :: ends(3, 2) = 0.0_dp         !! STA, BL, WL of first and last point, deck units
        integer :: group(2) = 0                 !! ends of one group belong together before others;
                                                !! 0: of none
    end type part_type

    !> A chain of parts.
    type :: chain_type
        integer, allocatable :: part(:)         !! parts in order, negative where run backwards
        logical :: is_closed = .false.          !! the last ends where the first begins
    end type chain_type

contains

    !> The chains of some parts, each part in just one of them. A chain begins with an open end
    !> where it has one, of the part that comes first; the part that comes first runs forward in a
    !> closed chain.
    pure function chains_of(parts, tolerance) result(chains)
        type(part_type), intent(in) :: parts(:) !! in any order
        real(dp), intent(in) :: tolerance       !! ends within this are one point, deck units
        type(chain_type), allocatable :: chains(:)
        type(chain_type) :: chain
        integer :: mate(2*size(parts)), i
        logical :: is_used(size(parts))

        allocate (chains(0))
        mate = mates(parts, tolerance)
        is_used = .false.
        do i = 1, 2*size(parts)
            if (is_used((i + 1)/2) .or. mate(i) /= 0) cycle
            chain = chain_from(i, mate, is_used)
            chains = [chains, chain]
            call mark(chain, is_used)
        end do
        do i = 1, size(parts)
            if (is_used(i)) cycle
            chain = chain_from(2*i - 1, mate, is_used)
            chains = [chains, chain]
            call mark(chain, is_used)
        end do
    end function chains_of

    !> The chain that begins with an end. End 2*i - 1 is the first of part i, 2*i the last.
    pure type(chain_type) function chain_from(first, mate, is_used) result(chain)
        integer, intent(in) :: first        !! an end
        integer, intent(in) :: mate(:)      !! the end that each end meets, or 0
        logical, intent(in) :: is_used(:)   !! parts of other chains
        integer :: end, part

        allocate (chain%part(0))
        end = first
        do
            part = (end + 1)/2
            if (is_used(part)) exit
            chain%part = [chain%part, merge(part, -part, mod(end, 2) == 1)]
            end = mate(opposite(end))
            if (end == first) chain%is_closed = .true.
            if (end == 0 .or. end == first) exit
        end do
    end function chain_from

    !> The other end of the same part.
    elemental integer function opposite(end)
        integer, intent(in) :: end !! an end
        opposite = end - 1 + 2*mod(end, 2)
    end function opposite

    !> Marks the parts of a chain.
    pure subroutine mark(chain, is_used)
        type(chain_type), intent(in) :: chain   !! any
        logical, intent(inout) :: is_used(:)    !! by part
        is_used(abs(chain%part)) = .true.
    end subroutine mark

    !> The end that each end meets, or 0.
    pure function mates(parts, tolerance) result(mate)
        type(part_type), intent(in) :: parts(:) !! in any order
        real(dp), intent(in) :: tolerance       !! deck units
        integer :: mate(2*size(parts)), group(2*size(parts)), i
        real(dp) :: at(3, 2*size(parts))
        logical :: is_near(2*size(parts))

        do i = 1, size(parts)
            at(:, 2*i - 1:2*i) = parts(i)%ends
            group(2*i - 1:2*i) = parts(i)%group
        end do
        mate = 0
        do i = 1, size(mate)
            if (mate(i) /= 0 .or. group(i) == 0) cycle
            is_near = group == group(i) .and. mate == 0 .and. nearness(at, at(:, i)) <= tolerance
            call pair(is_near, mate)
        end do
        do i = 1, size(mate)
            if (mate(i) /= 0) cycle
            is_near = mate == 0 .and. nearness(at, at(:, i)) <= tolerance
            call pair(is_near, mate)
        end do
    end function mates

    !> Makes two ends mates, where there are just two.
    pure subroutine pair(is_near, mate)
        logical, intent(in) :: is_near(:)   !! the ends that meet
        integer, intent(inout) :: mate(:)   !! the end that each end meets, or 0
        integer :: one, two

        if (count(is_near) /= 2) return
        one = findloc(is_near, .true., dim=1)
        two = findloc(is_near, .true., dim=1, back=.true.)
        mate(one) = two
        mate(two) = one
    end subroutine pair

    !> The distances of points from one, each the largest of its three parts.
    pure function nearness(at, from) result(distance)
        real(dp), intent(in) :: at(:, :)    !! points, shape (3, number)
        real(dp), intent(in) :: from(3)     !! the one
        real(dp) :: distance(size(at, 2))
        distance = maxval(abs(at - spread(from, 2, size(at, 2))), dim=1)
    end function nearness

end module cut_chain
