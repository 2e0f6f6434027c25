!> An audit as comma-separated values, which are read back as the tables that they are of.
program test_csv
    use audit_csv, only: print_audit_csv
    use audit_deck, only: audit_the_deck, deck_audit_type
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use deck_audit, only: audit_deck_type
    use support_audit_deck, only: parabola, tables_of
    use support_job_deck, only: words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(audit_deck_type) :: deck
    type(fault_list_type) :: faults
    character(:), allocatable :: first, second

    first = csv_of(parabola//'EXACT,XI,5.0|AUDIT,SEC,STATION,20.,,PAR,|PRINTED,1970|CONICS,2|'// &
        'BETWEEN,S1,-.1,.1|EXACT,X1,0.|ALONG,Y,2|4.,7.5?1,5.,8.000,6.,9.000')
    call tap%ok(index(first, 'table,view,at,what,along,printed,computed,low,high,residual,'// &
        'verdict,corrected,slip,sure'//new_line('a')) == 1, 'the header')
    call tap%ok(index(first, 'PAR,SIDE,,x,25.,6.250,6.25,6.25,6.25,') > 0, 'a row')
    call tap%ok(index(first, 'PAR,SIDE,,about S3,,1.00,') > 0, 'what is known')
    call tap%ok(index(first, 'SEC,STATION,20.,y 2,4.,7.5?1,') > 0, 'a row along Y of column 2')
    second = first
    call bars(second)
    second = csv_of(second)
    call tap%same(words_of(faults), '', 'it can be read')
    call tap%ok(first == second, 'and gives the same audit')
    call tap%finish()

contains

    !> The values of a deck.
    function csv_of(cards) result(text)
        character(*), intent(in) :: cards   !! its lines with `|` between them
        character(:), allocatable :: text
        type(deck_audit_type) :: found
        type(output_type) :: out
        call tables_of(cards, deck, faults)
        call audit_the_deck(deck, found)
        call print_audit_csv(found, out)
        text = out%text()
    end function csv_of

    !> Puts `|` between lines.
    subroutine bars(text)
        character(*), intent(inout) :: text !! lines
        integer :: i
        do i = 1, len(text)
            if (text(i:i) == new_line('a')) text(i:i) = '|'
        end do
    end subroutine bars

end program test_csv
