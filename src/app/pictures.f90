!> Which card of a deck is drawn in which picture. The name of a card (the comment right before it)
!> decides: SIDE, PLAN, or STA, STATION or SECTION as a word of its own, in any case and the first
!> of these in this order. All other cards share a picture.
module app_pictures
    use app_card_arcs, only: card_arc_type, read_card_arcs
    use app_files, only: base_name
    use app_input, only: deck_input_type
    use base_error, only: error_type
    use base_output, only: output_type
    use base_text, only: to_text, upper
    use deck_control_card, only: heading_type
    use deck_layout, only: conic
    use export_picture, only: curve_type, picture_type
    implicit none (type, external)
    private

    public :: read_pictures, picture_of

    !> The pictures, in the order they are drawn.
    integer, parameter, public :: side = 1, plan = 2, sections = 3, conics = 4

contains

    !> Reads a deck and puts the arc of each card on its picture. A card without an arc is reported
    !> and left out.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read.
    subroutine read_pictures(input, pictures, is_faulty, messages, error)
        type(deck_input_type), intent(inout) :: input       !! the deck, at its first card
        type(picture_type), intent(out) :: pictures(4)      !! side, plan, sections, conics
        logical, intent(out) :: is_faulty                   !! a card was in error
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(card_arc_type), allocatable :: list(:)
        type(heading_type) :: heading
        integer :: i

        call read_card_arcs(input, heading, list, is_faulty, messages, error)
        if (allocated(error)) return
        do i = 1, size(list)
            call pictures(picture_of(list(i)%card%label))%add(curve_of(list(i)))
        end do
        call name_pictures(heading, input%name, pictures)
    end subroutine read_pictures

    !> The arc of a card as a curve.
    pure type(curve_type) function curve_of(item) result(curve)
        type(card_arc_type), intent(in) :: item !! a card with its arc

        curve%arc = item%arc
        curve%name = item%card%label
        if (curve%name == '') curve%name = 'card '//to_text(item%card%count)
        curve%point(:, 1) = item%card%real([conic%x1, conic%y1])
        curve%point(:, 2) = item%card%real([conic%x2, conic%y2])
        curve%point(:, 3) = item%card%real([conic%x3, conic%y3])
    end function curve_of

    !> The picture that a card of some name is in.
    pure integer function picture_of(name)
        character(*), intent(in) :: name !! the comment before the card, or nothing
        picture_of = conics
        if (has_word(name, 'STA') .or. has_word(name, 'STATION') .or. has_word(name, 'SECTION')) &
            picture_of = sections
        if (has_word(name, 'PLAN')) picture_of = plan
        if (has_word(name, 'SIDE')) picture_of = side
    end function picture_of

    !> True where a word stands in a text with neither letter nor figure against it.
    pure logical function has_word(text, word)
        character(*), intent(in) :: text !! any bytes
        character(*), intent(in) :: word !! in capitals
        character(:), allocatable :: padded
        integer :: i

        padded = ' '//text//' '
        padded = upper(padded)
        has_word = .false.
        do i = 2, len(padded) - len(word)
            if (padded(i:i + len(word) - 1) /= word) cycle
            has_word = .not. (is_letter(padded(i - 1:i - 1)) .or. &
                is_letter(padded(i + len(word):i + len(word))))
            if (has_word) return
        end do
    end function has_word

    !> True for what can be part of a word: a capital letter, a figure, a byte of a letter with an
    !> accent.
    pure logical function is_letter(byte)
        character, intent(in) :: byte !! any byte
        is_letter = index('ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789', byte) > 0 .or. ichar(byte) > 127
    end function is_letter

    !> Gives the pictures their names, titles and axes.
    pure subroutine name_pictures(heading, deck, pictures)
        type(heading_type), intent(in) :: heading         !! title and unit
        character(*), intent(in) :: deck                  !! name of the deck
        type(picture_type), intent(inout) :: pictures(:)  !! gets them
        character(*), parameter :: station = 'station (STA)', butt_line = 'butt line (BL)', &
            waterline = 'waterline (WL)'
        character(:), allocatable :: title, unit
        integer :: i

        title = base_name(deck)
        if (deck == '-') title = 'standard input'
        if (allocated(heading%title)) then
            if (heading%title /= '') title = heading%title
        end if
        unit = ', inches'
        if (allocated(heading%units)) then
            if (heading%units == 'MM') unit = ', mm'
            if (heading%units == 'FEET') unit = ', feet'
        end if
        call set_texts(pictures(side), 'side', 'Side view', station//unit, waterline//unit)
        call set_texts(pictures(plan), 'plan', 'Plan view', station//unit, butt_line//unit)
        call set_texts(pictures(sections), 'sections', 'Sections', butt_line//unit, waterline//unit)
        call set_texts(pictures(conics), 'conics', 'Conics', 'X'//unit, 'Y'//unit)
        do i = 1, size(pictures)
            pictures(i)%heading = title
        end do
    end subroutine name_pictures

    !> Gives one picture its texts.
    pure subroutine set_texts(picture, name, view, x_axis, y_axis)
        type(picture_type), intent(inout) :: picture !! gets them
        character(*), intent(in) :: name             !! of its files
        character(*), intent(in) :: view             !! what is seen
        character(*), intent(in) :: x_axis           !! name and unit
        character(*), intent(in) :: y_axis           !! name and unit
        picture%name = name
        picture%view = view
        picture%x_axis = x_axis
        picture%y_axis = y_axis
    end subroutine set_texts

end module app_pictures
