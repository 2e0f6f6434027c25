!> A body deck as a file: the deck of the design, by columns and with commas; lines that are no
!> cards; the order of faults.
program test_job_reader
    use base_error, only: cause, error_type
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_control_card, only: heading_type
    use deck_job, only: cut, job_type, piece, piece_real, view
    use deck_job_reader, only: read_job
    use deck_source, only: source_type
    use support_job_deck, only: body_text, faults_of, job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    character(*), &
        parameter :: columns = 'TITLE   NOSE OF APPENDIX B|UNITS   INCHES|LINE    MHB     SIDE|'// &
        '-30.    -10.    .114    0.      -7.1    50.     -4.     .0523|LINE    MHB     PLAN|'// &
        '-30.    0.      .577    0.      11.9    50.     21.5    .1405|LINE    LSH     SIDE|'// &
        '-30     -10.    -.268   0.      -16.    50.     -21.2   -.0697|LINE    LSH     PLAN|'// &
        '-30.    0.      .404    0.      9.0     50.     18.2    .1316|LINE    LCL     SIDE|'// &
        '-30.    -10.    -.384   0.      -18.    50.     -24.1   -.0871|'// &
        'SECTION LOWER   LCL     LSH     MHB     0.      999.999|STATION 0.      30.     5.|'// &
        'BUTTOCK 4.5     0.      20.     5.|WATERLN -16.    0.      20.     5.|'// &
        'OBLIQUE 20.     -16.    30.     -6.     2.5|END'
    character(*), parameter :: commas = 'title,Nose of appendix B|units,inches|LINE,MHB,SIDE|'// &
        '-30.,-10.,.114,0.,-7.1,50.,-4.,.0523|Line,mhb,Plan|-30,0,.577,0,11.9,50,21.5,.1405|'// &
        'LINE,LSH,SIDE|-30,-10,-.268,0,-16,50,-21.2,-.0697|LINE,LSH,PLAN|'// &
        '-30,0,.404,0,9.0,50,18.2,.1316|'// &
        'LINE,LCL,SIDE|-30,-10,-.384,0,-18,50,-24.1,-.0871|SECTION,LOWER,LCL,LSH,MHB,0,999.999|'// &
        'STATION,0,30,5|BUTTOCK,4.5,0,20,5|WATERLN,-16,0,20,5|OBLIQUE,20,-16,30,-6,2.5|END,'
    type(tap_type) :: tap
    type(job_type) :: job, other
    type(fault_list_type) :: faults

    call design()
    call lines()
    call bad_lines()
    call order_of_faults()
    call unreadable()
    call tap%finish()

contains

    subroutine design()
        integer :: i, j

        call job_of(columns, job, faults)
        call tap%same(words_of(faults), '', 'the deck of the design is read without fault')
        call tap%same(job%title, 'NOSE OF APPENDIX B', 'its title')
        associate (body => job%body(1))
            call tap%ok(all(body%line%name == [character(8) :: 'MHB', 'LSH', 'LCL']), 'its lines')
            call tap%ok(all(is_equal(piece_real(body%line(1)%view(view%side)%piece(1), [1, 2, 3, &
                4, 5, 6, &
                7, 8]), [-30.0_dp, -10.0_dp, 0.114_dp, 0.0_dp, -7.1_dp, 50.0_dp, -4.0_dp, &
                0.0523_dp])), 'the numbers of the first')
            call tap%ok(is_equal(piece_real(body%line(2)%view(view%side)%piece(1), 1), -30.0_dp), &
                'a number without a point')
            call tap%ok(all(body%section(1)%line == [3, 2, 1]) .and. body%section(1)%is_sound, &
                'its section')
            call tap%ok(all(body%cut%kind == [cut%station, cut%buttock, cut%waterline, &
                cut%oblique]), 'its cuts')
        end associate
        call job_of(commas, other, faults)
        call tap%same(words_of(faults), '', 'with commas it is read without fault')
        call tap%same(other%title, 'Nose of appendix B', 'a title with a comma before it')
        do i = 1, 3
            do j = view%side, merge(view%side, view%plan, i == 3)
                associate (a => job%body(1)%line(i)%view(j)%piece(1), &
                    b => other%body(1)%line(i)%view(j)%piece(1))
                    call tap%ok(a%kind == piece%conic .and. all(is_equal(piece_real(a, [1, 2, 3, &
                        4, 5, &
                        6, 7, 8]), piece_real(b, [1, 2, 3, 4, 5, 6, 7, 8]))), &
                        'and is the same line')
                end associate
            end do
        end do
        call tap%ok(size(other%body(1)%cut) == 4 .and. other%body(1)%section(1)%is_sound, &
            'and the same job')
    end subroutine design

    subroutine lines()
        call tap%same(faults_of('* X||   |'//body_text//'* , comment|'// &
            'STATION LIST    1.|* between||'// &
            '+       2.|END|* after'), '', 'comments and blank cards are passed over')
        call job_of(body_text//'STATION,LIST,1,|+,2,3|+,4', job, faults)
        call tap%ok(size(job%body(1)%cut(1)%value) == 4, 'a card may be continued more than once')
        call job_of(body_text//'STATION,1'//achar(13)//'|STATION,2', job, faults)
        call tap%ok(faults%count == 0 .and. size(job%body(1)%cut) == 2, &
            'carriage returns are no columns')
        call job_of(body_text//'STATION 1.'//repeat(' ', 2000), job, faults)
        call tap%ok(faults%count == 0, 'nor are blanks at the end')
        call tap%same(faults_of(body_text//'STATION,1|END|STATION,2||* x|STATION,3'), &
            '8:0-0 warning: 2 cards after the END card not read|', 'cards after END are counted')
        call job_of('TITLE   A, B AND C|'//body_text//'STATION,1', job, faults)
        call tap%same(job%title, 'A, B AND C', 'commas belong to a title')
        call tap%same(faults_of(body_text//'STATION,1|TITLE   A|TITLE   B'), &
            '9:1-5 error: a second TITLE card; a deck has one|', 'TITLE may stand later, once')
    end subroutine lines

    !> What is found wrong with cards from line 8 on.
    subroutine same(cards, words, name)
        character(*), intent(in) :: cards
        character(*), intent(in) :: words
        character(*), intent(in) :: name
        call tap%same(faults_of(body_text//'STATION,1|'//cards), words, name)
    end subroutine same

    subroutine bad_lines()
        call same('SKIN'//achar(9)//'.5', &
            '8:5-5 error: a tab or control byte on a card; put blanks in its '//'place|', 'a tab')
        call same('SKIN,'//achar(7)//'.5', &
            '8:6-6 error: a tab or control byte on a card; put blanks in '// &
            'its place|', 'a control byte')
        call same('SKIN    .5'//repeat(' ', 70)//'X', &
            '8:81-81 error: text beyond column 80; a card has 80 '// &
            'columns, with commas 132; a card with + in column 1 continues it|', &
            'text in column 81')
        call same('SKIN,.5'//repeat(' ', 125)//'X', &
            '8:133-133 error: text beyond column 132; a card has '// &
            '80 columns, with commas 132; a card with + in column 1 continues it|', &
            'text in column 133')
        call same('SKIN,'//repeat(' ', 120)//'.5', '', 'text in column 127, with a comma')
        call same('SKIN'//achar(9)//'.5|+,1', &
            '8:5-5 error: a tab or control byte on a card; put blanks in '// &
            'its place|', 'a card that can''t be read takes its continuation along')
        call same('TITLE   A|+,1', '9:1-1 error: a continuation without a card before it|', &
            'a title is not continued')
        call same('SKIN,.5|'//achar(0)//'|SKIN,X', &
            '9:1-1 error: a null byte: this is a binary file, not a '// &
            'deck of cards; nothing more of it is read|', 'a null byte')
        call job_of('LINE,A,SIDE|STRAIGHT'//achar(9)//',0,0,1,1|STRAIGHT,1,1,2,2', job, faults)
        call tap%ok(.not. job%body(1)%line(1)%view(view%side)%is_sound, &
            'a line with a card that can''t be read is not sound')
    end subroutine bad_lines

    subroutine order_of_faults()
        call tap%same(faults_of('LINE,A,SIDE,B|NONSENSE|LINE,C,SIDE,D|WRONG'), &
            '1:13-13 error: there is no LINE B|2:1-8 error: NONSENSE begins no card (see loft '// &
            'help '// &
            'cards)|3:13-13 error: there is no LINE D|4:1-8 error: WRONG begins no card '// &
            '(see loft help cards)|', 'faults come in the order of their lines')
    end subroutine order_of_faults

    subroutine unreadable()
        type(source_type) :: source
        type(error_type), allocatable :: error
        type(heading_type) :: heading
        call source%attach(9999)
        call read_job(source, heading, job, faults, error)
        call tap%ok(allocated(error), 'a source that can''t be read is an error')
        if (allocated(error)) call tap%ok(error%cause == cause%file_trouble, 'of the file')
    end subroutine unreadable

end program test_job_reader
