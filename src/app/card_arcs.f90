!> The arcs of a 1970 deck, read whole: what pictures are drawn of, and what goes into files.
module app_card_arcs
    use app_input, only: deck_input_type
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use body_card_arc, only: arc_of_card
    use deck_conic_card, only: conic_card_type
    use deck_conic_deck, only: conic_deck_type, found
    use deck_control_card, only: heading_type
    use geom_arc, only: arc_type
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: card_arc_type, read_card_arcs

    !> A card that has an arc.
    type :: card_arc_type
        type(conic_card_type) :: card   !! as it was read
        type(arc_type) :: arc           !! its arc
    end type card_arc_type

    !> Cards that there is room for at first.
    integer, parameter :: first_room = 16

contains

    !> Reads a 1970 deck to its end. A card without an arc is reported and left out.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read.
    subroutine read_card_arcs(input, heading, list, is_faulty, messages, error)
        type(deck_input_type), intent(inout) :: input               !! the deck, at its first card
        type(heading_type), intent(out) :: heading                  !! what TITLE and UNITS say
        type(card_arc_type), allocatable, intent(out) :: list(:)    !! in the order of the deck
        logical, intent(out) :: is_faulty                           !! a card was in error
        type(output_type), intent(inout) :: messages                !! diagnostics
        type(error_type), allocatable, intent(out) :: error         !! see above
        type(conic_deck_type) :: deck
        type(card_arc_type) :: item
        type(fault_list_type) :: faults
        logical :: has_arc
        integer :: outcome, count

        allocate (list(first_room))
        count = 0
        is_faulty = .false.
        deck%heading = input%opening%heading
        do
            call deck%next(input%source, item%card, outcome, faults, error)
            if (allocated(error)) then
                error%message = input%name//': '//error%message
                return
            end if
            has_arc = outcome == found%conic .and. item%card%is_readable
            if (has_arc) has_arc = .not. item%card%has_coinciding_points()
            if (has_arc) call arc_of_card(item%card, item%arc, has_arc, faults)
            if (has_arc) call append(item, list, count)
            call print_faults(faults, input%name, .false., messages)
            is_faulty = is_faulty .or. faults%has_errors(0)
            call faults%clear()
            if (outcome == found%finished) exit
        end do
        heading = deck%heading
        list = list(:count)
    end subroutine read_card_arcs

    !> Puts a card behind others.
    pure subroutine append(item, list, count)
        type(card_arc_type), intent(in) :: item                     !! one more
        type(card_arc_type), allocatable, intent(inout) :: list(:)  !! `list(:count)` count
        integer, intent(inout) :: count                             !! how many there are
        type(card_arc_type), allocatable :: grown(:)

        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append

end module app_card_arcs
