!> The card reference against the card table of SAE 700202, and whether every card of a body deck is
!> in it.
program test_card_reference
    use base_output, only: output_type
    use deck_body_layout, only: body_layout
    use report_card_reference, only: print_card, print_card_reference
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(output_type) :: out, few
    character(:), allocatable :: text
    character(*), parameter :: feed = new_line('a')
    character(21), parameter :: rows(11) = [character(21) :: &
        '  1-8  X1     F8.3 ', ' 9-16  Y1     F8.3 ', '17-24  S1     F8.5 ', &
        '25-32  X2     F8.3 ', &
        '33-40  Y2     F8.3 ', '41-48  X3     F8.3 ', '49-56  Y3     F8.3 ', &
        '57-64  S3     F8.5 ', &
        '65-70  XI     F6.3 ', '71-76  YI     F6.3 ', '77-78  ITYP   I2   ']
    integer :: i, next
    logical :: is_card

    call print_card_reference(out)
    text = out%text()
    do i = 1, size(rows)
        call tap%ok(index(text, '  '//trim(rows(i))//' ') > 0, &
            'the field'//rows(i)(6:12)//' has its columns and format')
    end do
    call tap%ok(index(text, 'Columns 79-80 are free') > 0, 'the sequence number is mentioned')
    call tap%ok(index(text, feed//'TITLE') > 0 .and. index(text, '9-80  TEXT   A72') > 0, &
        'TITLE is there')
    call tap%ok(index(text, feed//'UNITS') > 0 .and. index(text, '9-16  UNIT   A8') > 0, &
        'UNITS is there')
    call tap%ok(index(text, ' '//feed) == 0, 'no line ends with blanks')
    do i = 1, size(body_layout)
        if (body_layout(i)%word == '') cycle
        call tap%ok(index(text, feed//trim(body_layout(i)%word)) > 0, 'the card '// &
            trim(body_layout(i)%word)//' '//trim(body_layout(i)%second)//' is there')
    end do
    call tap%ok(index(text, feed//'      4    25-32  SHLDR     name ') > 0, 'a field of SECTION')
    call tap%ok(index(text, feed//'      8    57-64  [FROM]    number ') > 0, &
        'a field that may be blank')
    call tap%ok(index(text, feed//'     11    +9-16  Y3        number ') > 0, &
        'a field of a continuation')
    call tap%ok(index(text, 'behind  options: LAST DXDY KNUCKLE'//feed) > 0, 'options of a card')
    call tap%ok(index(text, feed//'  KNUCKLE   a slope break') > 0, 'and their meaning')
    i = 1
    do
        next = index(text(i:), feed)
        if (next == 0) exit
        if (next > 133) exit
        i = i + next
    end do
    call tap%ok(next == 0, 'no line is wider than a printer''s')
    call print_card('STATION', few, is_card)
    text = few%text()
    call tap%ok(is_card .and. index(text, 'STATION: ') == 1 .and. &
        index(text, feed//'STATION LIST: ') > 0 .and. index(text, 'BUTTOCK') == 0, &
        'the cards of one word alone')
    call print_card('LINE', few, is_card)
    call tap%has(few%text(), feed//'  CHINE     the skin is meant to break where sections', &
        'with the meaning of their options')
    call print_card('AUDIT', few, is_card)
    call tap%ok(is_card, 'a card of printed tables')
    call print_card('CONIC', few, is_card)
    call tap%has(few%text(), '77-78  ITYP   I2', 'the card of 1970')
    call print_card('', few, is_card)
    call tap%ok(.not. is_card, 'no word is no card')
    call print_card('FUSELAGE', few, is_card)
    call tap%ok(.not. is_card, 'nor is another')
    call tap%finish()
end program test_card_reference
