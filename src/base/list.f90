!> A list of numbers that grows: room is doubled, so that a number added costs the same however many
!> there are.
module base_list
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: list_type

    !> A list.
    type :: list_type
        integer :: count = 0                    !! numbers held
        real(dp), allocatable :: item(:)        !! the numbers, `item(1:count)`
    contains
        procedure, private :: add_one
        procedure, private :: add_some
        generic :: add => add_one, add_some
        procedure :: all => all_of
    end type list_type

    !> Room of a new list.
    integer, parameter :: first_room = 16

contains

    !> Puts a number at the end.
    pure subroutine add_one(list, x)
        class(list_type), intent(inout) :: list !! the list
        real(dp), intent(in) :: x               !! any number
        call make_room(list, 1)
        list%count = list%count + 1
        list%item(list%count) = x
    end subroutine add_one

    !> Puts numbers at the end, in their order.
    pure subroutine add_some(list, x)
        class(list_type), intent(inout) :: list !! the list
        real(dp), intent(in) :: x(:)            !! any numbers
        call make_room(list, size(x))
        list%item(list%count + 1:list%count + size(x)) = x
        list%count = list%count + size(x)
    end subroutine add_some

    !> Makes room for more numbers.
    pure subroutine make_room(list, more)
        class(list_type), intent(inout) :: list !! the list
        integer, intent(in) :: more             !! how many
        real(dp), allocatable :: grown(:)

        if (.not. allocated(list%item)) allocate (list%item(first_room))
        if (list%count + more <= size(list%item)) return
        allocate (grown(max(2*size(list%item), list%count + more)))
        grown(:list%count) = list%item(:list%count)
        call move_alloc(grown, list%item)
    end subroutine make_room

    !> The numbers in the order in which they came.
    pure function all_of(list) result(x)
        class(list_type), intent(in) :: list !! the list
        real(dp) :: x(list%count)
        if (list%count > 0) x = list%item(:list%count)
    end function all_of

end module base_list
