!> Is a card of a body deck what its layout says? Every field is looked at and every fault said.
module deck_body_check
    use base_constants, only: degrees, vertical_slope
    use base_decimal, only: to_real
    use base_digits, only: fixed
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use deck_body_card, only: blame, blame_inside, blame_span, card_type, field_count, field_text, &
        warn
    use deck_body_crowd, only: check_surplus
    use deck_body_fields, only: fields_of
    use deck_body_layout, only: body_card, body_field_type, body_layout, body_layout_type, form, &
        need
    use deck_body_value, only: is_filled, looks_like_number, number_in
    use deck_body_word, only: begins_as_word, in_words, name_trouble, suggestion, words_in
    use deck_number, only: number_type
    implicit none (type, external)
    private

    public :: check_card, check_against, has_option

    !> Characters of the longest figure as printed.
    integer, parameter :: most_characters = 24

contains

    !> Looks at all fields of a card.
    pure subroutine check_card(card, kind, faults)
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: kind                     !! one of `body_card%...`
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(body_field_type), allocatable :: field(:)

        allocate (field, source=fields_of(kind))
        call check_against(card, body_layout(kind), field, faults)
    end subroutine check_card

    !> Looks at all fields of a card of any deck of words.
    pure subroutine check_against(card, layout, field, faults)
        type(card_type), intent(in) :: card             !! the card
        type(body_layout_type), intent(in) :: layout    !! what it should be
        type(body_field_type), intent(in) :: field(:)   !! and its fields
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        logical :: is_match
        integer :: i, last

        is_match = says_option(card, layout, field, 'MATCH')
        last = 1
        do i = 1, size(field)
            last = field(i)%field
            if (.not. is_filled(card, last)) cycle
            call check_field(card, field(i), last, faults)
            if (is_match .and. field(i)%need == need%unmatched) call warn(card, last, &
                trim(field(i)%name)//' is not used: MATCH finds it', faults)
        end do
        call check_missing(card, field, is_match, faults)
        do i = last + 1, field_count(card)
            if (.not. is_filled(card, i)) cycle
            if (is_repeated(field, need%repeated)) then
                call check_field(card, field(size(field)), i, faults)
            else if (is_repeated(field, need%paired)) then
                call check_field(card, field(size(field) - modulo(i - last, 2)), i, faults)
            else
                call check_option(card, layout, i, last, faults)
            end if
        end do
    end subroutine check_against

    !> Blames the blank fields that must be filled; those side by side are one fault.
    pure subroutine check_missing(card, field, is_match, faults)
        type(card_type), intent(in) :: card             !! the card
        type(body_field_type), intent(in) :: field(:)   !! its fields
        logical, intent(in) :: is_match                 !! the card says MATCH
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: words
        integer :: i, first

        first = 0
        do i = 1, size(field)
            if (.not. is_missing(card, field(i), is_match)) cycle
            if (first == 0) first = i
            if (i < size(field)) then
                if (is_missing(card, field(i + 1), is_match)) cycle
            end if
            call say_missing(field(first:i), words)
            call blame_span(card, field(first)%field, field(i)%field, words, faults)
            first = 0
        end do
    end subroutine check_missing

    !> Says what is missing.
    pure subroutine say_missing(field, words)
        type(body_field_type), intent(in) :: field(:)   !! blank fields
        character(:), allocatable, intent(out) :: words !! the sentence
        integer :: i

        words = trim(field(1)%name)
        if (size(field) == 1) then
            words = words//' is missing'
            if (field(1)%meaning /= '') words = words//': '//trim(field(1)%meaning)
            if (field(1)%words /= '') words = words//'; '//in_words(words_in(field(1)%words))
        else
            do i = 2, size(field)
                words = words//' '//trim(field(i)%name)
            end do
            words = words//' are missing'
        end if
        if (all(field%form == form%number)) words = words//' (zero is written 0.)'
    end subroutine say_missing

    !> True where a field is blank that must not be.
    pure logical function is_missing(card, field, is_match)
        type(card_type), intent(in) :: card             !! the card
        type(body_field_type), intent(in) :: field      !! its field
        logical, intent(in) :: is_match                 !! the card says MATCH
        is_missing = .not. is_filled(card, field%field) .and. (field%need == need%always .or. &
            (field%need == need%unmatched .and. .not. is_match) .or. &
            (field%need == need%repeated .and. field_count(card) < field%field))
    end function is_missing

    !> True where the last field of a card may be repeated, alone or with the one before it.
    pure logical function is_repeated(field, how)
        type(body_field_type), intent(in) :: field(:) !! fields of a card
        character, intent(in) :: how                  !! `need%repeated` or `need%paired`
        is_repeated = .false.
        if (size(field) > 0) is_repeated = field(size(field))%need == how
    end function is_repeated

    !> Looks at one field that is not blank.
    pure subroutine check_field(card, field, number, faults)
        type(card_type), intent(in) :: card             !! the card
        type(body_field_type), intent(in) :: field      !! layout of the field
        integer, intent(in) :: number                   !! which field of the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: text

        text = field_text(card, number)
        select case (field%form)
        case (form%number, form%whole)
            call check_number(card, field, number, faults)
        case (form%either)
            if (looks_like_number(text)) then
                call check_number(card, field, number, faults)
            else
                call check_name(card, field, number, faults)
            end if
        case (form%name)
            call check_name(card, field, number, faults)
        case (form%figure)
            call check_figure(card, field, number, faults)
        case default
            if (any(words_in(field%words) == text)) return
            call blame(card, number, trim(field%name)//' is '//in_words(words_in(field%words))// &
                ', not '//text//suggestion(text, words_in(field%words)), faults)
        end select
    end subroutine check_field

    !> Looks at a field that must be a number.
    pure subroutine check_number(card, field, number, faults)
        type(card_type), intent(in) :: card             !! the card
        type(body_field_type), intent(in) :: field      !! layout of the field
        integer, intent(in) :: number                   !! which field of the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(number_type) :: value
        character(:), allocatable :: text

        text = field_text(card, number)
        value = number_in(text, field%form == form%whole)
        if (value%first == 0) then
            call check_slope(card, field, number, to_real(value%value), faults)
        else if (begins_as_word(text)) then
            call blame(card, number, trim(field%name)//' is a number, not the word '//text, faults)
        else
            call blame_inside(card, number, value%first, value%last, &
                trim(field%name)//': '//value%trouble, faults)
        end if
    end subroutine check_number

    !> Warns of a slope that looks like degrees: a whole number from 10 on that is not vertical.
    pure subroutine check_slope(card, field, number, slope, faults)
        type(card_type), intent(in) :: card             !! the card
        type(body_field_type), intent(in) :: field      !! layout of the field
        integer, intent(in) :: number                   !! which field of the card
        real(dp), intent(in) :: slope                   !! its number
        type(fault_list_type), intent(inout) :: faults  !! gets the warning
        real(dp), parameter :: least = 10.0_dp

        if (all(field%unit /= ['dy/dx  ', 'dWL/dBL']) .or. field%need == need%optional) return
        if (abs(slope) < least .or. abs(slope) >= vertical_slope) return
        if (.not. is_equal(slope, anint(slope))) return
        call warn(card, number, trim(field%name)//' is '//trim(field%unit)//', not degrees: '// &
            compact(slope)//' is a direction of '//trim(adjustl(fixed(degrees*atan(slope), 12, &
            3)))//' degrees; a vertical one is 999.999', faults)
    end subroutine check_slope

    !> Looks at a field that must be a name.
    pure subroutine check_name(card, field, number, faults)
        type(card_type), intent(in) :: card             !! the card
        type(body_field_type), intent(in) :: field      !! layout of the field
        integer, intent(in) :: number                   !! which field of the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: text, trouble

        text = field_text(card, number)
        trouble = trim(name_trouble(text))
        if (trouble == '') return
        if (looks_like_number(text)) trouble = 'a number where a name is expected; '//trouble
        call blame(card, number, trim(field%name)//': '//trouble, faults)
    end subroutine check_name

    !> Looks at a field that must be a figure as it is printed, of which some may not be readable.
    pure subroutine check_figure(card, field, number, faults)
        type(card_type), intent(in) :: card             !! the card
        type(body_field_type), intent(in) :: field      !! layout of the field
        integer, intent(in) :: number                   !! which field of the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: text
        integer :: bad

        text = field_text(card, number)
        bad = verify(text, '0123456789.-+?')
        if (len(text) > most_characters) bad = most_characters + 1
        if (bad > 0) call blame_inside(card, number, bad, bad, trim(field%name)// &
            ': a figure as printed has digits, a sign and a point, or dashes between feet, '// &
            'inches and eighths, at most 24 characters; ? is one that can''t be read', faults)
    end subroutine check_figure

    !> Looks at a filled field behind the last one of a layout: an option word, or a fault.
    pure subroutine check_option(card, layout, number, last, faults)
        type(card_type), intent(in) :: card             !! the card
        type(body_layout_type), intent(in) :: layout    !! what it should be
        integer, intent(in) :: number                   !! the field of the card
        integer, intent(in) :: last                     !! last field of the layout
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: text
        integer :: i

        text = field_text(card, number)
        if (looks_like_number(text)) then
            call check_surplus(card, number, last, faults)
        else if (layout%options == '') then
            call blame(card, number, 'text behind the last field of the card, which is field '// &
                to_text(last), faults)
        else if (.not. any(words_in(layout%options) == text)) then
            call blame(card, number, text//' is no option of this card; options are '// &
                in_words(words_in(layout%options))//suggestion(text, words_in(layout%options)), &
                faults)
        else
            do i = last + 1, number - 1
                if (field_text(card, i) == text) call blame(card, number, text//' twice', faults)
            end do
        end if
    end subroutine check_option

    !> True where a card has an option word behind its fields.
    pure logical function has_option(card, kind, word)
        type(card_type), intent(in) :: card !! the card
        integer, intent(in) :: kind         !! one of `body_card%...`
        character(*), intent(in) :: word    !! the option
        type(body_field_type), allocatable :: field(:)

        allocate (field, source=fields_of(kind))
        has_option = says_option(card, body_layout(kind), field, word)
    end function has_option

    !> The same of any layout.
    pure logical function says_option(card, layout, field, word)
        type(card_type), intent(in) :: card             !! the card
        type(body_layout_type), intent(in) :: layout    !! what it should be
        type(body_field_type), intent(in) :: field(:)   !! and its fields
        character(*), intent(in) :: word                !! the option
        integer :: i

        says_option = .false.
        if (.not. any(words_in(layout%options) == word)) return
        do i = size(field) + merge(1, 2, layout%word == ''), field_count(card)
            says_option = says_option .or. field_text(card, i) == word
        end do
    end function says_option

end module deck_body_check
