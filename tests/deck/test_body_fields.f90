!> Fields of all cards: in order, without gaps, on columns that a card has.
program test_body_fields
    use deck_body_fields, only: fields_of, form_words
    use deck_body_layout, only: body_card, body_field_type, body_layout, form, need
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_field_type), allocatable :: field(:)
    integer :: card, i, bad, unsaid, late, alike

    bad = 0
    unsaid = 0
    late = 0
    alike = 0
    do card = 1, size(body_layout)
        if (allocated(field)) deallocate (field)
        allocate (field, source=fields_of(card))
        do i = 1, size(field)
            if (field(i)%field /= i + merge(0, 1, body_layout(card)%word == '')) bad = bad + 1
            if (field(i)%form == form%word .neqv. field(i)%words /= '') unsaid = unsaid + 1
            if (field(i)%need == need%repeated .and. i < size(field)) late = late + 1
            if (count(field%name == field(i)%name) > 1) alike = alike + 1
        end do
    end do
    call tap%ok(bad == 0, &
        'fields follow one another, from field 2 or on cards without a word from 1')
    call tap%ok(unsaid == 0, 'fields for words, and no others, have words to hold')
    call tap%ok(late == 0, 'only a last field is repeated')
    call tap%ok(alike == 0, 'fields of a card have different names')
    call tap%ok(size(fields_of(body_card%close)) == 0, 'CLOSE has no fields')
    deallocate (field)
    allocate (field, source=fields_of(body_card%section))
    call tap%same(trim(form_words(field(1))), 'name', 'a name is called so')
    call tap%same(trim(form_words(field(5))), 'no./name', 'a number or name is called so')
    call tap%same(trim(form_words(field(7))), 'number', 'a number is called so')
    call tap%same(trim(form_words(field(9))), 'word', 'a word is called so')
    deallocate (field)
    allocate (field, source=fields_of(body_card%digits))
    call tap%same(trim(form_words(field(1))), 'whole', 'a whole number is called so')
    call tap%finish()
end program test_body_fields
