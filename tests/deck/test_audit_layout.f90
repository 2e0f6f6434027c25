!> The cards of a deck of printed tables as data.
program test_audit_layout
    use deck_audit, only: known
    use deck_audit_layout, only: audit_card, audit_fields_of, audit_layout, known_words, &
        printing_words, view_words
    use deck_body_layout, only: body_field_type, need
    use deck_body_word, only: words_in
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_field_type), allocatable :: field(:)
    character(8), allocatable :: word(:)
    integer :: i
    logical :: is_sound

    is_sound = .true.
    do i = 1, size(audit_layout)
        field = audit_fields_of(i)
        if (i /= audit_card%end) is_sound = is_sound .and. size(field) > 0
        if (size(field) > 1) is_sound = is_sound .and. all(field(2:)%field - &
            field(:size(field) - 1)%field == 1)
    end do
    call tap%ok(is_sound, 'fields of every card follow one another')
    field = audit_fields_of(audit_card%row)
    call tap%ok(field(1)%field == 1 .and. field(2)%need == need%paired, &
        'rows begin in the first field and come in pairs')
    word = words_in(known_words)
    call tap%same(word(known%s3)//word(known%a)//word(known%e)//word(known%yi), &
        'S3      A       E       YI      ', 'words and numbers of what is known go together')
    call tap%ok(size(words_in(view_words)) == 5 .and. size(words_in(printing_words)) == 5, &
        'five views, five ways of printing')
    call tap%finish()

end program test_audit_layout
