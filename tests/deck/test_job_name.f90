!> Names of patches and ducts: free of those of sections, patches and ducts before them.
program test_job_name
    use support_job_deck, only: body_text, faults_of
    use support_tap, only: tap_type
    implicit none (type, external)

    character(*), parameter :: rings = 'FAIRED,A,0.|0,0|1,0|0,1|FAIRED,B,5.|0,0|1,0|0,1|', &
        duct = 'DUCT,X,A,B|', patch = 'PATCH,X,TOP,1.,MHB,2.|'
    type(tap_type) :: tap

    call tap%ok(index(faults_of(rings//duct//'DUCT,Y,A,B'), 'name') == 0, 'other names are free')
    call tap%ok(has(rings//duct//duct, 'a second DUCT X; give it another name'), 'a duct twice')
    call tap%ok(has(body_text//patch//patch, 'a second PATCH X; give it another name'), &
        'a patch twice')
    call tap%ok(has(body_text//rings//duct//patch, &
        'there is a DUCT X; give the patch another name'), 'a patch named as a duct')
    call tap%ok(has(body_text//rings//patch//duct, &
        'there is a PATCH X; give the duct another name'), 'a duct named as a patch')
    call tap%ok(has(body_text//rings//'DUCT,UP,A,B', &
        'there is a SECTION UP; give the duct another name'), 'a duct named as a section')
    call tap%ok(has(body_text//'PATCH,UP,TOP,1.,MHB,2.', &
        'there is a SECTION UP; give the patch another name'), 'a patch named as a section')
    call tap%finish()

contains

    !> True where a deck has a fault of some words.
    logical function has(deck, words)
        character(*), intent(in) :: deck    !! its lines with `|` between them
        character(*), intent(in) :: words   !! of the fault
        has = index(faults_of(deck), words) > 0
    end function has

end program test_job_name
