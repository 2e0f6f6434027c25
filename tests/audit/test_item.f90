!> Tables as lines: which figure becomes which reading, and what contradicts what.
program test_item
    use audit_item, only: entry_of, is_contradicted, item_type, new_item, number_of, point_of, &
        softened
    use audit_printing, only: printing
    use audit_reading, only: line_type, meaning, sort
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_audit, only: audit_deck_type, known
    use support_audit_deck, only: tables_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(audit_deck_type) :: deck
    type(fault_list_type) :: faults
    type(item_type) :: item
    type(line_type) :: soft
    integer :: i

    call tables_of('AUDIT,A,SIDE|PRINTED,1970|EXACT,X1,-30.,Y1,-10.,S1,.1|5.,1.000|'// &
        'ALONG,Y,2|7.,2.000|EXACT,X3,50.,Y3,4.|ABOUT,B,.001|BETWEEN,S3,.1,.2|EXACT,XI,5.', &
        deck, faults)
    item = new_item(deck%table(1))
    associate (reading => item%line%reading)
        call tap%ok(all(reading%sort == [sort%ordinate, sort%abscissa, sort%ordinate, sort%slope, &
            sort%ordinate, sort%slope, sort%coefficient]), 'rows first, then what is known')
        call tap%ok(all(reading%meaning == [meaning%printed, meaning%printed, meaning%exact, &
            meaning%exact, meaning%exact, meaning%between, meaning%rounded]), 'each as it is known')
        call tap%ok(all(is_equal(reading(:6)%along, [5.0_dp, 7.0_dp, -30.0_dp, -30.0_dp, 50.0_dp, &
            50.0_dp])), 'at its ordinate, or that of its point')
        call tap%ok(reading(2)%column == 2 .and. reading(7)%letter == 2, 'columns and letters')
    end associate
    call tap%ok(item%line%printing == printing%of_1970 .and. is_equal(item%line%shift, &
        100.0_dp), 'how it was printed, and the shift of 1970')
    call tap%ok(is_equal(number_of(item%table, known%x3), 50.0_dp) .and. &
        entry_of(item%table, known%y2) == 0 .and. point_of(known%s3) == 3, 'numbers are found')

    call tables_of('AUDIT,A,SIDE|5.,1.000,6.,2.000,7.,3.000|EXACT,X1,5.,Y1,1.001,X3,7.,Y3,3.002', &
        deck, faults)
    item = new_item(deck%table(1))
    call tap%ok(all(is_contradicted(item, [(i, i = 1, 5)]) .eqv. [.false., .false., .false., &
        .false., .true.]), 'two units off is a contradiction, one is rounding')
    soft = softened(item, .false.)
    call tap%ok(all(soft%reading(4:5)%meaning == [meaning%exact, meaning%rounded]), &
        'to which nothing is held')
    call tap%finish()

end program test_item
