!> The listing of a 1970 deck: a block for each card, whatever became of it.
program test_conic_listing
    use base_decimal, only: decimal_type
    use base_fault, only: fault_list_type
    use base_kinds, only: i64
    use base_output, only: output_type
    use body_card_arc, only: arc_of_card
    use body_card_facts, only: card_facts_type, facts_of_card
    use body_card_tables, only: contours_of_card
    use deck_conic_card, only: conic_card_type, read_conic_card
    use deck_control_card, only: heading_type
    use deck_source, only: line_type
    use geom_arc, only: arc_type
    use geom_contour, only: contour_type
    use report_card_block, only: card_block_type
    use report_conic_listing, only: conic_listing_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(:), allocatable :: text

    ! A quarter of a circle of radius 5; at X = -3 it is at 4 with slope 3/4.
    text = listing_of('-5.     0.      999.999 -4.     3.      0.      5.      0.      1.')
    call tap%has(text, 'CONIC LOFTING', 'a deck without TITLE has a heading')
    call tap%has(text, 'quarter.crd', 'the deck is named')
    call tap%has(text, 'INCHES', 'the unit is said')
    call tap%has(text, 'PAGE 1', 'the page is numbered')
    call tap%has(text, 'CARD 1   a quarter', 'the card has its number and name')
    call tap%has(text, '-5.     0.      999.999 -4.', 'the card is echoed')
    call tap%has(text, 'CIRCLE   RHO 0.414214   LENGTH 7.8540', 'its conic is described')
    call tap%has(text, 'BY STEPS OF X', 'its table has a heading')
    call tap%has(text, &
        '       -3.0000        4.0000      0.750000     36.8699               -5.0000', &
        'a row has X, Y, slope, angle and radius of curvature')
    call tap%has(text, &
        '       -5.0000        0.0000      VERTICAL     90.0000               -5.0000', &
        'a vertical slope is a word')
    call tap%has(text, &
        '        0.0000        5.0000      0.000000      0.0000               -5.0000', &
        'the last point stands too')
    call tap%ok(index(text, '-0.0000 ') == 0, 'no zero has a minus')

    text = listing_of('0.      0.      .5      4.      2.      8.      4.      .5      1.')
    call tap%has(text, 'STRAIGHT LINE   LENGTH 8.9443', 'a straight line is called one')
    call tap%has(text, 'THE FIVE EQUATIONS HAVE NO UNIQUE SOLUTION', 'and has no equations of 1970')
    call tap%has(text, '              STRAIGHT', 'and no radius of curvature')

    text = listing_of('0.      0.      .5      5.      5.      10.     10.     2.      1.')
    call tap%has(text, &
        'NOT RUN: THE DIAGNOSTICS SAY WHY', 'a card without an arc stands in the listing')
    text = listing_of('-5.     0.      999.999 -4.     3.      0.      5.      0.      -1.')
    call tap%has(text, 'NO TABLE: THE DIAGNOSTICS SAY WHY', 'so does a card without a table')
    call tap%finish()

contains

    !> The listing of one card.
    function listing_of(image) result(text)
        character(*), intent(in) :: image !! the card image
        character(:), allocatable :: text
        type(conic_listing_type) :: listing
        type(output_type) :: out
        type(conic_card_type) :: card
        type(card_facts_type) :: facts
        type(contour_type), allocatable :: contours(:)
        type(card_block_type) :: block
        type(fault_list_type) :: faults
        type(heading_type) :: heading
        type(line_type) :: line
        type(arc_type) :: arc
        logical :: has_arc

        line%text = image
        line%length = len(image, i64)
        line%number = 1
        card%label = 'a quarter'
        card%count = 1
        call read_conic_card(line, card, faults)
        call arc_of_card(card, arc, has_arc, faults)
        allocate (contours(0))
        if (has_arc) then
            facts = facts_of_card(card, arc, decimal_type(100, 0))
            call contours_of_card(card, arc, contours, faults)
        end if
        call listing%begin(heading, 'quarter.crd')
        call block%make(card, facts, contours)
        call listing%print_block(block, out)
        text = out%text()
    end function listing_of

end program test_conic_listing
