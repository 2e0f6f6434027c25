!> A 1970 deck made ready for export: the arc of each card as a curve.
module app_export_conics
    use app_card_arcs, only: card_arc_type, read_card_arcs
    use app_export_choice, only: choose_cuts
    use app_export_parts, only: begin_parts, parts_type
    use app_export_request, only: request_type
    use app_input, only: deck_input_type
    use base_error, only: error_type
    use base_output, only: output_type
    use base_text, only: to_text
    use deck_control_card, only: heading_type
    use export_drawing, only: shape_type
    use export_drawing_card, only: draw_card
    use export_drawing_name, only: make_unique, safe_name
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
        type(card_arc_type), allocatable :: list(:)
        type(heading_type) :: heading
        integer :: i

        call begin_parts(deck_name, '', 'INCHES', parts)
        call read_card_arcs(input, heading, list, parts%is_faulty, messages, error)
        if (allocated(error)) return
        deallocate (parts%drawing%cuts)
        allocate (parts%drawing%cuts(size(list)))
        do i = 1, size(list)
            call draw(list(i), parts%drawing%cuts(i))
        end do
        if (allocated(heading%title)) parts%drawing%title = heading%title
        if (allocated(heading%units)) parts%drawing%units = heading%units
        call make_unique(parts%drawing)
    end subroutine read_conics

    !> Draws the arc of a card.
    pure subroutine draw(item, shape)
        type(card_arc_type), intent(in) :: item !! a card with its arc
        type(shape_type), intent(out) :: shape  !! its curve
        character(:), allocatable :: title
        integer :: number

        number = int(item%card%count)
        title = item%card%label
        if (title == '') title = 'CARD '//to_text(number)
        call draw_card(item%arc, number, safe_name(title), shape)
        shape%title = title
    end subroutine draw

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
