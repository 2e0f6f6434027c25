!> Growing lists of tables and figures.
program test_audit
    use deck_audit, only: add_entry, add_table, audit_deck_type, audit_entry_type, &
        audit_table_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(audit_deck_type) :: deck
    type(audit_table_type) :: table
    type(audit_entry_type) :: entry
    integer :: i, k
    logical :: is_kept

    do i = 1, 40
        entry%what = i
        call add_entry(table, entry)
    end do
    call tap%ok(table%count == 40 .and. all(table%entry(:40)%what == [(i, i = 1, 40)]), &
        'entries stay in order')
    do k = 1, 9
        table%entry(1)%what = k
        call add_table(deck, table)
    end do
    is_kept = deck%count == 9
    do k = 1, 9
        is_kept = is_kept .and. deck%table(k)%entry(1)%what == k .and. deck%table(k)%count == 40
    end do
    call tap%ok(is_kept, 'tables stay in order with their entries')
    call tap%finish()

end program test_audit
