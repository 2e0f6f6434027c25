!> Faults and their list.
program test_fault
    use base_fault, only: fault_list_type, fault_type, new_fault, severity
    use base_kinds, only: i64
    use base_text, only: to_text
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(fault_list_type) :: list
    type(fault_type) :: fault
    integer :: i
    logical :: in_order

    fault = new_fault(severity%warning, 9, 16, 'not so')
    call tap%ok(fault%severity == severity%warning .and. fault%first == 9 .and. fault%last == 16, &
        'a fault has its severity and columns')
    call tap%same(fault%message, 'not so', 'a fault has its words')
    call tap%ok(fault%line == 0 .and. fault%card == '', 'a new fault stands on no card')

    call tap%ok(list%count == 0 .and. .not. list%has_errors(0), &
        'a list begins empty, without errors')
    call list%clear()
    call tap%ok(list%count == 0, 'an empty list can be emptied')
    call list%add(fault)
    call list%add(new_fault(severity%remark, 1, 1, 'so-so'))
    call tap%ok(.not. list%has_errors(0), 'warnings and remarks are no errors')
    call list%place(0, 7_i64, 'CARD SEVEN')
    call list%add(new_fault(severity%error, 0, 0, 'wrong'))
    call tap%ok(list%has_errors(0) .and. list%has_errors(2), 'an error is found')
    call tap%ok(.not. list%has_errors(3), 'an error before the place asked about does not count')
    call list%place(2, 5000000000_i64, 'CARD OF A LONG DECK')
    call tap%ok(all(list%item(:2)%line == 7) .and. list%item(3)%line == 5000000000_i64, &
        'faults get the line of their card, also past 2**32')
    call tap%same(list%item(2)%card, 'CARD SEVEN', 'faults keep the card they were put on')
    call tap%same(list%item(3)%card, 'CARD OF A LONG DECK', 'later faults get theirs')
    call list%place(list%count, 1_i64, 'NONE')
    call tap%ok(list%item(3)%line == 5000000000_i64, 'placing no faults changes none')

    call list%clear()
    call tap%ok(list%count == 0 .and. .not. list%has_errors(0), 'a list can be emptied')
    do i = 1, 1000
        call list%add(new_fault(severity%error, i, i + 1, to_text(i)))
    end do
    in_order = list%count == 1000
    do i = 1, 1000
        in_order = in_order .and. list%item(i)%first == i .and. list%item(i)%message == to_text(i)
    end do
    call tap%ok(in_order, 'a thousand faults stay in order')
    call tap%finish()
end program test_fault
