!> A fault of a deck: what is wrong, what would be right, and where it stands on which card.
!> Faults are collected in a list or reported one by one as they are met; `report_fault` prints
!> them.
module base_fault
    use base_kinds, only: i64
    implicit none (type, external)
    private

    public :: fault_type, fault_list_type, new_fault

    !> How grave a fault is. An error makes the exit status 1, a warning does not.
    type, public :: severity_list
        integer :: remark = 0   !! a warning of `loft check` alone: read otherwise than it looks
        integer :: warning = 1  !! the job runs as asked; the user will want to know
        integer :: error = 2    !! the card can't be run, or not as it stands
    end type severity_list

    !> The severities by name: `severity%error`.
    type(severity_list), parameter, public :: severity = severity_list()

    !> One fault. `line` 0 speaks of the whole file; `first` 0 of the whole card.
    type :: fault_type
        integer :: severity = 2                 !! one of `severity%...`
        integer(i64) :: line = 0                !! line of the file, from 1
        integer :: first = 0                    !! first column at fault, from 1
        integer :: last = 0                     !! last column at fault
        character(:), allocatable :: message    !! what is wrong and what would be right
        character(:), allocatable :: card       !! the card image
    end type fault_type

    !> Faults in the order they were met.
    type :: fault_list_type
        integer :: count = 0                            !! number of faults held
        type(fault_type), allocatable :: item(:)        !! the faults, `item(1:count)`
    contains
        procedure :: add => add_fault
        procedure :: place
        procedure :: clear => clear_faults
        procedure :: has_errors
    end type fault_list_type

contains

    !> A fault with its columns and words; line and card are filled in by whoever knows them.
    pure function new_fault(grade, first, last, message) result(fault)
        integer, intent(in) :: grade        !! one of `severity%...`
        integer, intent(in) :: first        !! first column at fault; 0: the whole card
        integer, intent(in) :: last         !! last column at fault
        character(*), intent(in) :: message !! what is wrong and what would be right
        type(fault_type) :: fault
        fault%severity = grade
        fault%first = first
        fault%last = last
        fault%message = message
        fault%card = ''
    end function new_fault

    !> Puts a fault at the end of the list.
    pure subroutine add_fault(list, fault)
        class(fault_list_type), intent(inout) :: list !! the list
        type(fault_type), intent(in) :: fault         !! what to add
        type(fault_type), allocatable :: grown(:)

        if (.not. allocated(list%item)) allocate (list%item(4))
        if (list%count == size(list%item)) then
            allocate (grown(2*list%count))
            grown(:list%count) = list%item
            call move_alloc(grown, list%item)
        end if
        list%count = list%count + 1
        list%item(list%count) = fault
    end subroutine add_fault

    !> Says on which card the faults stand that were added since the list had `before` of them.
    pure subroutine place(list, before, line, card)
        class(fault_list_type), intent(inout) :: list !! the list
        integer, intent(in) :: before                 !! faults that stand elsewhere
        integer(i64), intent(in) :: line              !! line of the file, from 1
        character(*), intent(in) :: card              !! the card image
        integer :: i
        do i = before + 1, list%count
            list%item(i)%line = line
            list%item(i)%card = card
        end do
    end subroutine place

    !> Empties the list.
    pure subroutine clear_faults(list)
        class(fault_list_type), intent(inout) :: list !! the list
        list%count = 0
    end subroutine clear_faults

    !> True where at least one fault of the list, past the first `before`, is an error.
    pure logical function has_errors(list, before)
        class(fault_list_type), intent(in) :: list !! the list
        integer, intent(in) :: before              !! faults not to look at
        integer :: i
        has_errors = .false.
        do i = before + 1, list%count
            has_errors = has_errors .or. list%item(i)%severity == severity%error
        end do
    end function has_errors

end module base_fault
