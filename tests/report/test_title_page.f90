!> The title page of a body listing: datum, rounding, and every card in the order of the deck.
program test_title_page
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use deck_job, only: job_type
    use deck_job_reader, only: read_job
    use deck_kind, only: opening_type, read_opening
    use deck_source, only: source_type
    use report_ordinate, only: new_form
    use report_page, only: page_type
    use report_title_page, only: print_title_page
    use support_tap, only: tap_type
    implicit none (type, external)

    character, parameter :: feed = new_line('a')
    character(*), parameter :: deck = 'TITLE   A BODY'//feed// &
        'LINE    LCL     SIDE'//feed// &
        '-30.    -10.    -.384   0.      -18.    50.     -24.1   -.0871'//feed// &
        'LINE    MHB     SIDE'//feed// &
        '-30.    -10.    .114    0.      -7.1    50.     -4.     .0523'//feed// &
        'LINE    MHB     PLAN'//feed// &
        '-30.    0.      .577    0.      11.9    50.     21.5    .1405'//feed// &
        'SECTION LOWER   LCL     MHB     MHB     0.      999.999'//feed// &
        'SKIN    .04'//feed//'STATION 0.      30.     5.'//feed//'VARY    Y9'//feed// &
        'FLANGE  FWD'//feed//'CLOSE'//feed//'END'//feed
    type(tap_type) :: tap
    character(:), allocatable :: text

    text = page_of(deck)
    call tap%has(text, 'POSITIVE AFT', 'the station axis is said')
    call tap%has(text, 'POSITIVE TO STARBOARD', 'the butt line axis is said')
    call tap%has(text, &
        'ORDINATES IN      INCHES, ROUNDED TO 3 DECIMALS', 'unit and rounding are said')
    call tap%has(text, 'ABOUT BL 0', 'symmetry is said')
    call tap%has(text, '     2  LINE    LCL     SIDE'//feed//'     3  -30.    -10.    -.384', &
        'cards are echoed with their lines')
    call tap%has(text, '     9  SKIN    .04'//feed//'    10  STATION 0.      30.     5.'//feed// &
        '    12  FLANGE  FWD'//feed//'    13  CLOSE'//feed, &
        'to the last, but for one in error; also those that hold for what follows')
    call tap%ok(index(text, '     3  ') < index(text, '     4  ') .and. &
        index(text, '     7  ') < index(text, '     8  '), 'in the order of the deck')
    call tap%finish()

contains

    !> The title page of a deck.
    function page_of(deck) result(text)
        character(*), intent(in) :: deck !! the deck
        character(:), allocatable :: text
        type(source_type) :: source
        type(opening_type) :: opening
        type(job_type) :: job
        type(fault_list_type) :: faults
        type(error_type), allocatable :: error
        type(page_type) :: page
        type(output_type) :: out

        call source%from_text(deck)
        call read_opening(source, opening, faults, error)
        call read_job(source, opening%heading, job, faults, error)
        call page%set_heading('TITLE', 'deck.crd', 'INCHES')
        call print_title_page(page, job, new_form(job%units, job%output, job%digits), out)
        text = out%text()
    end function page_of

end program test_title_page
