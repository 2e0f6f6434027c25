!> Fields that run together, and what is said of them.
program test_body_crowd
    use base_fault, only: fault_list_type
    use base_kinds, only: i64
    use deck_body_card, only: new_card
    use deck_body_crowd, only: blame_crowded, check_surplus
    use deck_source, only: line_type
    use support_job_deck, only: words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%same(crowded('LINE TOP SIDE'), &
        '1:1-8 error: more than the word in the first field; the next field begins in '// &
        'column 9, or put commas between all fields|', 'blanks in place of columns')
    call tap%same(crowded('STRAIGHT0.      0,5     1.'), &
        '1:1-17 error: more than the word in the first field; on a card with a comma all '// &
        'fields are between commas: a comma ends a field, and decimals have a point: 22.5|', &
        'a decimal comma on a card by columns')
    call tap%same(crowded('LINE;TOP;SIDE'), &
        '1:1-8 error: more than the word in the first field; fields end with their columns or '// &
        'with a comma, not with a semicolon|', 'semicolons')
    call tap%same(surplus('STRAIGHT0.      1.      2.      3.      4.      5.', 6), &
        '1:41-48 error: a number behind the last field of the card, which is field 5|', &
        'a number behind the last field')
    call tap%same(surplus('STRAIGHT,0,0,5,1,0,0,5', 6), &
        '1:18-18 error: a number behind the last field of the card, which is field 5; '// &
        'a comma ends a field, and decimals have a point: 22.5|', 'decimal commas')
    call tap%same(surplus('STRAIGHT,0,0,5,1,0,0,5', 7), '', 'the first number stands for all')
    call tap%finish()

contains

    !> What is said of a card whose first field holds more than its word.
    function crowded(text) result(words)
        character(*), intent(in) :: text !! the card
        character(:), allocatable :: words
        type(fault_list_type) :: faults
        call blame_crowded(new_card(line_type(text=text, number=1_i64)), faults)
        words = words_of(faults)
    end function crowded

    !> What is said of a number behind field 5, the last.
    function surplus(text, number) result(words)
        character(*), intent(in) :: text    !! the card
        integer, intent(in) :: number       !! field of the number
        character(:), allocatable :: words
        type(fault_list_type) :: faults
        call check_surplus(new_card(line_type(text=text, number=1_i64)), number, 5, faults)
        words = words_of(faults)
    end function surplus

end program test_body_crowd
