!> The cards with a word in front that may begin a deck of either kind: TITLE and UNITS.
!>
!>     1       9
!>     TITLE   NOSE OF APPENDIX B
!>     UNITS   INCHES
module deck_control_card
    use base_fault, only: fault_list_type, new_fault, severity
    use base_kinds, only: i64
    use base_text, only: columns, first_bytes, to_text, upper
    use deck_layout, only: card_columns, title_fields, units_fields
    use deck_source, only: line_type
    implicit none (type, external)
    private

    public :: heading_type, begins_with_word, card_word, control_bytes, read_heading_card

    !> What the cards before the first other card say.
    type :: heading_type
        character(:), allocatable :: title  !! text of the TITLE card
        character(:), allocatable :: units  !! INCHES, MM or FEET
        logical :: has_title = .false.      !! a TITLE card was met
        logical :: has_units = .false.      !! a UNITS card was met
    end type heading_type

    character(*), parameter :: letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ'

contains

    !> True where the first columns hold a word, not a number: two letters side by side begin it.
    !> (`O.5` is a number with a slip in it.)
    pure logical function begins_with_word(line)
        type(line_type), intent(in) :: line !! a line of the deck
        character(8) :: field
        field = line%text
        field = adjustl(field)
        begins_with_word = verify(upper(field(1:2)), letters) == 0
    end function begins_with_word

    !> The columns of a card from the word it begins with, in capitals.
    pure function word_columns(line) result(text)
        type(line_type), intent(in) :: line !! a line of the deck that begins with a word
        character(card_columns) :: text
        text = upper(adjustl(columns(line%text, 1, card_columns)))
    end function word_columns

    !> The word a card begins with, in capitals: what stands before the first blank or comma.
    pure function card_word(line) result(word)
        type(line_type), intent(in) :: line !! a line of the deck that begins with a word
        character(scan(word_columns(line)//' ', ' ,'//achar(9), kind=i64) - 1_i64) :: word
        word = word_columns(line)
    end function card_word

    !> Reads a TITLE or UNITS card.
    subroutine read_heading_card(line, heading, faults)
        type(line_type), intent(in) :: line             !! a line that begins with TITLE or UNITS
        type(heading_type), intent(inout) :: heading    !! what it says is put here
        type(fault_list_type), intent(inout) :: faults  !! what is wrong with it is added
        type(line_type) :: card
        integer :: before, bad

        before = faults%count
        card = by_columns(line)
        bad = scan(line%text, control_bytes())
        if (bad > 0) then
            call faults%add(new_fault(severity%error, bad, bad, &
                'a tab or control byte on a card; put blanks in its place'))
            card%text = line%text
        else if (card_word(line) == 'TITLE') then
            call read_title(card, heading, faults)
        else
            call read_units(card, heading, faults)
        end if
        call faults%place(before, line%number, card%text)
    end subroutine read_heading_card

    !> A heading card with a comma right behind its word is free-field: the same card by columns.
    !> (Other commas belong to the text of a title.)
    pure type(line_type) function by_columns(line) result(card)
        type(line_type), intent(in) :: line !! a line that begins with TITLE or UNITS
        character(8) :: word
        integer :: comma

        card = line
        comma = index(line%text, ',')
        if (comma == 0) return
        if (upper(adjustl(columns(line%text, 1, comma - 1))) /= card_word(line)) return
        word = card_word(line)
        card%text = word//trim(adjustl(line%text(comma + 1:)))
        card%filled = len(card%text)
    end function by_columns

    !> Reads a TITLE card; a second one changes nothing. A column of it is a character, which in
    !> UTF-8 may be several bytes.
    subroutine read_title(line, heading, faults)
        type(line_type), intent(in) :: line             !! the line
        type(heading_type), intent(inout) :: heading    !! gets the title
        type(fault_list_type), intent(inout) :: faults  !! what is wrong with it is added
        integer :: room

        call check_field('TITLE', title_fields(2)%first, line, heading%has_title, faults)
        room = first_bytes(line%text, card_columns)
        if (line%filled > room) then
            call faults%add(new_fault(severity%error, room + 1, line%filled, &
                'text beyond column '//to_text(card_columns)//'; shorten the title'))
        end if
        if (heading%has_title) return
        heading%has_title = .true.
        heading%title = trim(columns(line%text, title_fields(2)%first, room))
    end subroutine read_title

    !> Reads a UNITS card; a second one changes nothing.
    subroutine read_units(line, heading, faults)
        type(line_type), intent(in) :: line             !! the line
        type(heading_type), intent(inout) :: heading    !! gets the unit
        type(fault_list_type), intent(inout) :: faults  !! what is wrong with it is added
        character(:), allocatable :: text

        call check_field('UNITS', units_fields(2)%first, line, heading%has_units, faults)
        if (heading%has_units) return
        heading%has_units = .true.
        associate (field => units_fields(2))
            text = upper(columns(line%text, field%first, field%last))
            if (line%filled > field%last) then
                call faults%add(new_fault(severity%error, field%last + 1, line%filled, &
                    'text outside the columns; the unit stands in columns 9-16'))
            end if
            select case (text)
            case ('INCHES', 'MM', 'FEET')
                heading%units = trim(text)
            case default
                call faults%add(new_fault(severity%error, field%first, field%last, &
                    'the unit is INCHES, MM or FEET, from column 9 on'))
            end select
        end associate
    end subroutine read_units

    !> The word must be in column 1, alone before its text, and its card the first of its kind.
    subroutine check_field(word, first, line, is_second, faults)
        character(*), intent(in) :: word                !! TITLE or UNITS
        integer, intent(in) :: first                    !! column where its text begins
        type(line_type), intent(in) :: line             !! the line
        logical, intent(in) :: is_second                !! one has been met before
        type(fault_list_type), intent(inout) :: faults  !! what is wrong with it is added
        character(8) :: field

        field = line%text
        if (upper(field) /= word) then
            call faults%add(new_fault(severity%error, 1, first - 1, 'the word '//word// &
                ' stands in columns 1-5 and its text from column '//to_text(first)//' on'))
        end if
        if (is_second) then
            call faults%add(new_fault(severity%error, 1, len(word), &
                'a second '//word//' card; a deck has one'))
        end if
    end subroutine check_field

    !> The bytes below blank, and delete.
    pure function control_bytes() result(bytes)
        character(33) :: bytes
        integer :: i
        do i = 0, 31
            bytes(i + 1:i + 1) = achar(i)
        end do
        bytes(33:33) = achar(127)
    end function control_bytes

end module deck_control_card
