!> The list of entities and notes of a receipt.
program test_receipt
    use base_kinds, only: dp
    use base_text, only: row_of
    use export_receipt, only: entity_type, receipt_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(receipt_type) :: receipt
    type(entity_type) :: entity
    integer :: i
    logical :: in_order

    call tap%ok(receipt%count == 0 .and. .not. allocated(receipt%notes), 'a receipt begins empty')
    do i = 1, 1000
        entity%name = row_of('x', i)
        entity%kind = 'CURVE'
        entity%error = real(i, dp)
        call receipt%add(entity)
    end do
    call tap%ok(receipt%count == 1000, 'a thousand entities are counted')
    in_order = .true.
    do i = 1, receipt%count
        in_order = in_order .and. len(receipt%entities(i)%name) == i &
            .and. nint(receipt%entities(i)%error) == i
    end do
    call tap%ok(in_order, 'and stand in their order')
    call receipt%say('one')
    call receipt%say('')
    call receipt%say('two ')
    call tap%same(receipt%notes, 'one'//new_line('a')//new_line('a')//'two '//new_line('a'), &
        'notes are lines')
    call tap%finish()
end program test_receipt
