!> A 1970 deck made ready for export: the arc of each card as a curve.
module app_export_conics
    use app_export_choice, only: choose_cuts
    use app_export_parts, only: begin_parts, parts_type
    use app_export_request, only: request_type
    use app_input, only: deck_input_type
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use base_text, only: to_text
    use body_card_arc, only: arc_of_card
    use deck_conic_card, only: conic_card_type
    use deck_conic_deck, only: conic_deck_type, found
    use export_drawing, only: shape_type
    use export_drawing_card, only: draw_card
    use export_drawing_name, only: make_unique, safe_name
    use geom_arc, only: arc_type
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: read_conics, choose_cards

contains

    !> Reads a 1970 deck. A card without an arc is reported and left out.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read.
    subroutine read_conics(input, deck_name, parts, messages, error)
        type(deck_input_type), intent(inout) :: input       !! the deck, at its first card
        character(*), intent(in) :: deck_name               !! without folders
        type(parts_type), intent(out) :: parts              !! gets the curves as cuts
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(conic_deck_type) :: deck
        type(conic_card_type) :: card
        type(fault_list_type) :: faults
        integer :: outcome

        deck%heading = input%opening%heading
        call begin_parts(deck_name, '', 'INCHES', parts)
        do
            call deck%next(input%source, card, outcome, faults, error)
            if (allocated(error)) then
                error%message = input%name//': '//error%message
                return
            end if
            if (outcome == found%conic) call take_card(card, parts, faults)
            call print_faults(faults, input%name, .false., messages)
            parts%is_faulty = parts%is_faulty .or. faults%has_errors(0)
            call faults%clear()
            if (outcome == found%finished) exit
        end do
        if (allocated(deck%heading%title)) parts%drawing%title = deck%heading%title
        if (allocated(deck%heading%units)) parts%drawing%units = deck%heading%units
        call make_unique(parts%drawing)
    end subroutine read_conics

    !> Adds the arc of a card.
    subroutine take_card(card, parts, faults)
        type(conic_card_type), intent(in) :: card           !! the card, sound or not
        type(parts_type), intent(inout) :: parts            !! gets the curve
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added
        type(arc_type) :: arc
        type(shape_type) :: shape
        character(:), allocatable :: title
        integer :: number
        logical :: has_arc

        if (.not. card%is_readable .or. card%has_coinciding_points()) return
        call arc_of_card(card, arc, has_arc, faults)
        if (.not. has_arc) return
        number = int(card%count)
        title = card%label
        if (title == '') title = 'CARD '//to_text(number)
        call draw_card(arc, number, safe_name(title), shape)
        shape%title = title
        parts%drawing%cuts = [parts%drawing%cuts, shape]
    end subroutine take_card

    !> Leaves the cards that are wanted: by number among the data cards, by the comment before it,
    !> or by its name in the file.
    !>
    !> Fails with `cause%usage` where a card is asked that the deck has not.
    pure subroutine choose_cards(request, parts, error)
        type(request_type), intent(in) :: request           !! which cards
        type(parts_type), intent(inout) :: parts            !! of a 1970 deck
        type(error_type), allocatable, intent(out) :: error !! see above
        character(80), allocatable :: titles(:)
        logical, allocatable :: is_chosen(:)
        integer :: i

        allocate (titles(size(parts%drawing%cuts)))
        do i = 1, size(titles)
            titles(i) = parts%drawing%cuts(i)%title
        end do
        call choose_cuts(request%cuts, parts%drawing%cuts, titles, is_chosen, error)
        if (allocated(error)) return
        parts%drawing%cuts = pack(parts%drawing%cuts, is_chosen)
    end subroutine choose_cards

end module app_export_conics
