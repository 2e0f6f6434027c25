!> Increments against the ordinates of the rows.
program test_steps
    use audit_deck, only: deck_audit_type
    use audit_finding, only: finding_type, verdict
    use audit_item, only: new_item
    use audit_slip, only: slip
    use audit_steps, only: find_step, judge_step
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use deck_audit, only: known
    use support_audit_deck, only: audit_of, parabola
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(deck_audit_type) :: found
    type(finding_type) :: finding
    real(dp) :: step
    logical :: is_found

    call audit_of(parabola//'EXACT,XI,5.0', found)
    finding = judge_step(found%item(1), known%xi)
    call tap%ok(finding%verdict == verdict%agrees .and. finding%likely == '5.0', &
        'a sound increment')
    call audit_of(parabola//'EXACT,XI,3.0', found)
    finding = judge_step(found%item(1), known%xi)
    call tap%ok(finding%verdict == verdict%suspect .and. finding%likely == '5.0' .and. &
        finding%slip == slip%digit, 'a bad one, put right, with its slip')
    call audit_of(parabola//'EXACT,XI,?.0', found)
    finding = judge_step(found%item(1), known%xi)
    call tap%ok(finding%verdict == verdict%unreadable .and. finding%likely == '5.0', &
        'one that can not be read')
    finding = judge_step(found%item(1), known%yi)
    call tap%ok(finding%verdict == verdict%none, 'one that is not given is not judged')
    call audit_of('AUDIT,A,SIDE|EXACT,X1,0.,Y1,-21.602|ALONG,Y|-11.,17.296|EXACT,YI,10.002', found)
    call find_step(found%item(1), .true., step, is_found)
    call tap%ok(is_found .and. abs(step - 10.602_dp) < 1.0e-12_dp, &
        'a table of one row counts from point 1')
    finding = judge_step(found%item(1), known%yi)
    call tap%ok(finding%likely == '10.602' .and. finding%slip == slip%digit, &
        'as in SAE 700202, station 25')
    call find_step(found%item(1), .false., step, is_found)
    call tap%ok(.not. is_found .and. is_equal(step, 0.0_dp), 'without rows there is no increment')
    call tap%finish()

end program test_steps
