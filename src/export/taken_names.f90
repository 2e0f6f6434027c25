!> Names that are taken, whatever the case of their letters: whether one is among them takes the
!> same time however many there are.
!>
!> Source: D. E. Knuth, "The Art of Computer Programming", vol. 3, 2nd ed., 6.4 (hashing with
!> chains).
module export_taken_names
    use base_kinds, only: i64
    use base_text, only: to_text, upper
    implicit none (type, external)
    private

    public :: taken_type, new_taken, take_name

    !> A name.
    type :: entry_type
        character(:), allocatable :: text   !! in capitals
        integer :: suffix = 1               !! the last that was given to one like it
        integer :: before = 0               !! the one before it in its chain, or 0
    end type entry_type

    !> The names.
    type :: taken_type
        integer :: count = 0                        !! names taken
        type(entry_type), allocatable :: entry(:)   !! `entry(1:count)`
        integer, allocatable :: last(:)             !! of each chain, or 0
    end type taken_type

contains

    !> Room for some names, none of them taken yet.
    pure type(taken_type) function new_taken(room) result(taken)
        integer, intent(in) :: room !! how many at most
        allocate (taken%entry(room), taken%last(0:2*room))
        taken%last = 0
    end function new_taken

    !> Takes a name; one that is taken gets the suffix `-2`, `-3` and so on.
    pure subroutine take_name(taken, name)
        type(taken_type), intent(inout) :: taken            !! has room for one more
        character(:), allocatable, intent(inout) :: name    !! may get a suffix
        character(:), allocatable :: asked
        integer :: like, chain

        like = place_of(taken, upper(name))
        if (like > 0) then
            asked = name
            do while (place_of(taken, upper(name)) > 0)
                taken%entry(like)%suffix = taken%entry(like)%suffix + 1
                name = asked//'-'//to_text(taken%entry(like)%suffix)
            end do
        end if
        taken%count = taken%count + 1
        chain = chain_of(taken, upper(name))
        associate (new => taken%entry(taken%count))
            new%text = upper(name)
            new%before = taken%last(chain)
        end associate
        taken%last(chain) = taken%count
    end subroutine take_name

    !> Where a name stands among those taken; 0 where it does not.
    pure integer function place_of(taken, text) result(place)
        type(taken_type), intent(in) :: taken   !! the names
        character(*), intent(in) :: text        !! in capitals
        place = taken%last(chain_of(taken, text))
        do while (place > 0)
            if (taken%entry(place)%text == text) return
            place = taken%entry(place)%before
        end do
    end function place_of

    !> The chain of a name.
    pure integer function chain_of(taken, text) result(chain)
        type(taken_type), intent(in) :: taken   !! the names
        character(*), intent(in) :: text        !! in capitals
        integer(i64) :: hash
        integer :: i

        hash = 0_i64
        do i = 1, len(text)
            hash = modulo(31_i64*hash + int(iachar(text(i:i)), i64), 2147483647_i64)
        end do
        chain = int(modulo(hash, size(taken%last, kind=i64)))
    end function chain_of

end module export_taken_names
