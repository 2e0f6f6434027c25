!> The card layouts against the formats of SAE 700202, appendix A.
program test_layout
    use deck_layout, only: card_columns, conic, conic_fields, field_layout_type, last_read_column, &
        title_fields, units_fields
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    integer, parameter :: first(11) = [1, 9, 17, 25, 33, 41, 49, 57, 65, 71, 77]
    integer, parameter :: last(11) = [8, 16, 24, 32, 40, 48, 56, 64, 70, 76, 78]
    character(*), parameter :: forms = 'FFFFFFFFFFI'
    integer, parameter :: decimals(11) = [3, 3, 5, 3, 3, 3, 3, 5, 3, 3, 0]
    character(4), parameter :: names(11) = &
        ['X1  ', 'Y1  ', 'S1  ', 'X2  ', 'Y2  ', 'X3  ', 'Y3  ', 'S3  ', 'XI  ', 'YI  ', 'ITYP']
    integer :: i

    do i = 1, 11
        call tap%ok(conic_fields(i)%first == first(i) .and. conic_fields(i)%last == last(i) .and. &
            conic_fields(i)%form == forms(i:i) .and. conic_fields(i)%decimals == decimals(i) .and. &
            conic_fields(i)%name == names(i), 'the field '//trim(names(i))// &
            ' is as the paper has it')
    end do
    call tap%ok(all([conic%x1, conic%y1, conic%s1, conic%x2, conic%y2, conic%x3, conic%y3, &
        conic%s3, &
        conic%xi, conic%yi, conic%ityp] == [(i, i = 1, 11)]), &
        'the fields have their names in order')
    call tap%ok(conic_fields(11)%last == last_read_column, 'ITYP is the last that is read')
    call tap%ok(card_columns == 80, 'a card has 80 columns')
    call check_word_card(title_fields, 80, 'TITLE')
    call check_word_card(units_fields, 16, 'UNITS')
    call tap%finish()

contains

    !> A card with a word in columns 1-8 and text behind it.
    subroutine check_word_card(fields, last_column, word)
        type(field_layout_type), intent(in) :: fields(:) !! the layout
        integer, intent(in) :: last_column               !! where the text ends
        character(*), intent(in) :: word                 !! the word
        call tap%ok(size(fields) == 2 .and. all(fields%first == [1, 9]) .and. &
            all(fields%last == [8, last_column]) .and. all(fields%form == 'A'), &
            word//' has a word of 8 columns and text from column 9 on')
    end subroutine check_word_card

end program test_layout
