!> What the listing says of one card, as text that is yet to be put on pages: the card as punched,
!> its conic, its equations, and the rows of its tables. It needs nothing of any other card, so
!> blocks can be made side by side.
module report_card_block
    use base_digits, only: fixed, put_scientific, scientific, widest_scientific
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use base_text, only: characters, first_bytes, printable, row_of, to_text, upper
    use body_card_facts, only: card_facts_type
    use deck_conic_card, only: conic_card_type
    use deck_layout, only: conic_fields, last_read_column
    use geom_arc, only: rho, turns_past_180
    use geom_conic, only: conic_kind, kind_name
    use geom_contour, only: contour_type
    use report_page, only: page_columns
    use report_row_text, only: put_rows
    implicit none (type, external)
    private

    public :: card_block_type

    !> Decimals of lengths; figures of coefficients.
    integer, parameter :: length_decimals = 4, coefficient_figures = 16

    !> The block of a card.
    type :: card_block_type
        type(output_type) :: text           !! all its lines
        integer :: front = 0                !! lines before its tables
        integer(i64) :: front_bytes = 0     !! bytes of these
        logical :: has_arc = .false.        !! the card was run
        integer :: tables = 0               !! tables that follow
        integer :: axis(2) = 0              !! of each: 1: by steps of X, 2: of Y
        integer :: rows(2) = 0              !! rows of each
    contains
        procedure :: make
        procedure, private :: line
    end type card_block_type

contains

    !> Makes the block of a card.
    subroutine make(block, card, facts, contours)
        class(card_block_type), intent(inout) :: block  !! the block; its room is used again
        type(conic_card_type), intent(in) :: card       !! the card, sound or not
        type(card_facts_type), intent(in) :: facts      !! its conic, if it has one
        type(contour_type), intent(in) :: contours(:)   !! its tables, if it has any
        integer :: i

        call block%text%clear()
        block%front = 0
        call put_echo(block, card)
        block%has_arc = facts%has_arc
        block%tables = 0
        if (facts%has_arc) then
            call put_conic(block, facts)
            call put_equation(block, facts)
            call put_shifted(block, facts)
            block%tables = size(contours)
        end if
        block%front_bytes = block%text%length()
        do i = 1, block%tables
            block%axis(i) = contours(i)%axis
            block%rows(i) = contours(i)%row_count()
            call put_rows(contours(i), block%text)
        end do
    end subroutine make

    !> Puts a line before the tables. A control byte shows as `?`.
    subroutine line(block, text)
        class(card_block_type), intent(inout) :: block !! the block
        character(*), intent(in) :: text               !! the line
        call block%text%line(trim(printable(text)))
        block%front = block%front + 1
    end subroutine line

    !> Puts the name of a card, the names of its fields, and the card as punched.
    subroutine put_echo(block, card)
        type(card_block_type), intent(inout) :: block !! gets the lines
        type(conic_card_type), intent(in) :: card   !! the card
        character(page_columns) :: names
        character(:), allocatable :: head, place
        integer :: i

        names = ''
        do i = 1, size(conic_fields)
            names(conic_fields(i)%first:conic_fields(i)%last) = conic_fields(i)%name
        end do
        head = 'CARD '//to_text(card%count)//'   '//card%label
        place = '  LINE '//to_text(card%line)
        head = head(:first_bytes(head, page_columns - len(place)))
        call block%line(head//row_of(' ', page_columns - characters(head) - len(place))//place)
        call block%line(names)
        call block%line(card%image(:last_read_column))
        call block%line('')
    end subroutine put_echo

    !> Puts what kind of conic it is.
    subroutine put_conic(block, facts)
        type(card_block_type), intent(inout) :: block !! gets the lines
        type(card_facts_type), intent(in) :: facts  !! of a card with an arc
        character(:), allocatable :: text
        character(16) :: figures

        text = upper(kind_name(facts%conic%kind))
        if (facts%conic%kind == conic_kind%line) text = 'STRAIGHT LINE'
        if (facts%conic%kind /= conic_kind%line) then
            figures = fixed(rho(facts%arc), 16, 6)
            text = text//'   RHO '//trim(adjustl(figures))
        end if
        if (facts%has_length) then
            figures = fixed(facts%length, 16, length_decimals)
            text = text//'   LENGTH '//trim(adjustl(figures))
        end if
        if (turns_past_180(facts%arc)) text = text//'   TURNS BY MORE THAN 180 DEGREES'
        call block%line(text)
    end subroutine put_conic

    !> Puts the general equation with the residuals of the three points.
    subroutine put_equation(block, facts)
        type(card_block_type), intent(inout) :: block !! gets the lines
        type(card_facts_type), intent(in) :: facts  !! of a card with an arc
        character(10) :: left(3)
        integer :: i

        call block%line('EQUATION, POINT 1 AS ORIGIN: A XX + B XY + C YY + D X + E Y + F = 0')
        call put_coefficients(block, facts%conic%coefficient)
        do i = 1, size(left)
            left(i) = scientific(facts%residual(i), len(left), 2)
        end do
        call block%line('  LEFT SIDE AT POINT 1 '//left(1)//'   AT 2 '//left(2)// &
            '   AT 3 '//left(3))
    end subroutine put_equation

    !> Puts the equation in the frame of the 1970 program, or that it has none.
    subroutine put_shifted(block, facts)
        type(card_block_type), intent(inout) :: block !! gets the lines
        type(card_facts_type), intent(in) :: facts  !! of a card with an arc
        character(16) :: shift
        character(10) :: condition, difference

        shift = adjustl(fixed(facts%shifted%shift, 16, 3))
        call block%line('THE SAME FROM FIVE EQUATIONS, X AND Y PLUS '//trim(shift)// &
            ': A XX + ... + E Y = -1')
        if (.not. facts%has_shifted) then
            call block%line('  THE FIVE EQUATIONS HAVE NO UNIQUE SOLUTION')
            return
        end if
        call put_coefficients(block, facts%shifted%coefficient)
        condition = scientific(1.0_dp/facts%shifted%rcond, len(condition), 2)
        difference = scientific(facts%difference, len(difference), 2)
        call block%line('  CONDITION '//condition// &
            '   LARGEST DISTANCE FROM THE ARC '//difference)
    end subroutine put_shifted

    !> Puts coefficients by name, three on a line.
    subroutine put_coefficients(block, coefficient)
        type(card_block_type), intent(inout) :: block !! gets the lines
        real(dp), intent(in) :: coefficient(:)  !! A, B, C ...
        character(*), parameter :: names = 'ABCDEF'
        integer, parameter :: room = 26, on_a_line = 3
        character(on_a_line*room) :: text
        character(widest_scientific) :: figures
        integer :: i, next, place

        text = ''
        do i = 1, size(coefficient)
            place = room*mod(i - 1, on_a_line)
            text(place + 3:place + 3) = names(i:i)
            next = 1
            call put_scientific(coefficient(i), coefficient_figures, figures, next)
            text(place + room - next + 2:place + room) = figures(:next - 1)
            if (mod(i, on_a_line) /= 0 .and. i < size(coefficient)) cycle
            call block%line(text)
            text = ''
        end do
    end subroutine put_coefficients

end module report_card_block
