!> The deck of a variant: only the fields that vary are other than they were.
program test_image
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_job, only: job_type
    use support_tap, only: tap_type
    use sweep_image, only: image_type, new_image, write_variant
    use sweep_study, only: read_text
    implicit none (type, external)

    character(*), parameter :: feed = new_line('a')
    type(tap_type) :: tap

    call same('LINE    A       SIDE    5.'//feed//'VARY    FROM    X       1.      2.      '// &
        '2'//feed, &
        'LINE    A       SIDE    1.25'//feed//'VARY    FROM    X       1.      2.      2'//feed, &
        'the last field of a card is as long as its number')
    call same('* UTF-8 '//char(195)//char(164)//feed//'NOSE    7.      '//char(13)//feed// &
        'VARY    R       X       1.      2.      2', &
        '* UTF-8 '//char(195)//char(164)//feed//'NOSE    1.25    '//char(13)//feed// &
        'VARY    R       X       1.      2.      2', 'blanks, CR LF and a last line without '// &
        'end stay')
    call same(char(239)//char(187)//char(191)//'NOSE,7.'//feed//'VARY,R,X,1.,2.,2'//feed, &
        char(239)//char(187)//char(191)//'NOSE,1.25'//feed//'VARY,R,X,1.,2.,2'//feed, &
        'a byte order mark stays')
    call same('LINE,A,SIDE'//feed//' -1.5 , 0., 1., 2., 3., 100.5, 5., 6.   '//feed// &
        'VARY,X3,X,1.,2.,2'//feed//'VARY,TIED,X1,X,-100.,1.'//feed//'VARY,TIED,8,X,1000.'//feed, &
        'LINE,A,SIDE'//feed//' -124. , 0., 1., 2., 3., 1.25, 5., 1250.   '//feed// &
        'VARY,X3,X,1.,2.,2'//feed//'VARY,TIED,X1,X,-100.,1.'//feed//'VARY,TIED,8,X,1000.'//feed, &
        'fields between commas take the room they need, several of a card')
    call same('LINE    A       SIDE'//feed//'-1.5    0.      1.      2.      3.      100.5   5.'// &
        '      6.'//feed//'VARY    X3      X       1.      2.      2'//feed// &
        'VARY    TIED    X1      X       -99999.9'//feed//'vary    tied    s1      x       '// &
        '1.'//feed, &
        'LINE    A       SIDE'//feed//'-125000.0.      1.25    2.      3.      1.25    5.'// &
        '      6.'//feed//'VARY    X3      X       1.      2.      2'//feed// &
        'VARY    TIED    X1      X       -99999.9'//feed//'vary    tied    s1      x       '// &
        '1.'//feed, &
        'fields by columns keep their columns, however full they are')
    call same('LINE,A,SIDE'//feed//'FIVEPT,1,2,3,4,5,6,7,8,9'//feed//'* '// &
        'between'//feed//'+,10'//feed// &
        'VARY,Y3,X,1.,2.,2'//feed, 'LINE,A,SIDE'//feed//'FIVEPT,1,2,3,4,5,6,7,8,9'//feed// &
        '* between'//feed//'+,1.25'//feed//'VARY,Y3,X,1.,2.,2'//feed, &
        'a field of a continuation')
    call tap%finish()

contains

    !> The deck where X is 1.25.
    subroutine same(deck, expected, name)
        character(*), intent(in) :: deck, expected, name
        type(job_type) :: job
        type(fault_list_type) :: faults
        type(image_type) :: image
        character(:), allocatable :: text
        call read_text(deck, job, faults)
        image = new_image(deck, job%sweep%target)
        call write_variant(image, [1.25_dp], text)
        call tap%same(text, expected, name)
    end subroutine same

end program test_image
