!> Verdicts.
program test_finding
    use audit_finding, only: finding_type, verdict, verdict_name
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(finding_type) :: finding

    call tap%same(verdict_name(verdict%suspect), 'suspect', 'a verdict is one word')
    call tap%same(verdict_name(finding%verdict), 'not judged', 'or none yet')
    call tap%ok(finding%rival == 0, &
        'a figure is nobody''s rival until it is judged')
    call tap%finish()
end program test_finding
