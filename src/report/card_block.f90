!> What the listing says of one card, as text that is yet to be put on pages: the card as punched,
!> its conic, its equations, and the rows of its tables. It needs nothing of any other card, so
!> blocks can be made side by side.
module report_card_block
    use base_digits, only: put_fixed, put_scientific, widest_scientific
    use base_figures, only: put_text, put_whole
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use base_text, only: characters, first_bytes, printable, upper
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

    !> Decimals of lengths, of rho and of shifts; figures of coefficients.
    integer, parameter :: length_decimals = 4, rho_decimals = 6, shift_decimals = 3
    integer, parameter :: coefficient_figures = 16
    !> Columns for a line whose numbers are of any size.
    integer, parameter :: line_room = 2*page_columns

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

    !> Puts a line before the tables, without the blanks at its end.
    subroutine line(block, text)
        class(card_block_type), intent(inout) :: block !! the block
        character(*), intent(in) :: text               !! the line
        call block%text%line(text(:len_trim(text)))
        block%front = block%front + 1
    end subroutine line

    !> Puts the name of a card, the names of its fields, and the card as punched.
    subroutine put_echo(block, card)
        type(card_block_type), intent(inout) :: block !! gets the lines
        type(conic_card_type), intent(in) :: card   !! the card
        character(page_columns) :: names
        integer :: i

        call put_name(block, card)
        names = ''
        do i = 1, size(conic_fields)
            names(conic_fields(i)%first:conic_fields(i)%last) = conic_fields(i)%name
        end do
        call block%line(names)
        call block%line(printable(card%image(:last_read_column)))
        call block%line('')
    end subroutine put_echo

    !> Puts number, name and line of a card. A long name is cut. Its characters are counted, not its
    !> bytes, since it may be in UTF-8; a control byte shows as `?`.
    subroutine put_name(block, card)
        type(card_block_type), intent(inout) :: block !! gets the line
        type(conic_card_type), intent(in) :: card   !! the card
        character(*), parameter :: blanks = repeat(' ', page_columns)
        character(32) :: number, place
        integer :: next, behind, room
        integer(i64) :: kept

        next = 1
        call put_text('CARD ', number, next)
        call put_whole(card%count, number, next)
        call put_text('   ', number, next)
        behind = 1
        call put_text('  LINE ', place, behind)
        call put_whole(card%line, place, behind)
        room = page_columns - (next - 1) - (behind - 1)
        kept = int(first_bytes(card%label, room), i64)
        call block%text%put(number(:next - 1))
        if (kept > 0) call block%text%put(printable(card%label(:kept)))
        call block%text%put(blanks(:int(room - characters(card%label(:kept)), i64)))
        call block%text%line(place(:behind - 1))
        block%front = block%front + 1
    end subroutine put_name

    !> Puts what kind of conic it is.
    subroutine put_conic(block, facts)
        type(card_block_type), intent(inout) :: block !! gets the lines
        type(card_facts_type), intent(in) :: facts  !! of a card with an arc
        character(line_room) :: text
        integer :: next

        next = 1
        if (facts%conic%kind == conic_kind%line) then
            call put_text('STRAIGHT LINE', text, next)
        else
            call put_text(upper(kind_name(facts%conic%kind)), text, next)
            call put_text('   RHO ', text, next)
            call put_fixed(rho(facts%arc), rho_decimals, text, next)
        end if
        if (facts%has_length) then
            call put_text('   LENGTH ', text, next)
            call put_fixed(facts%length, length_decimals, text, next)
        end if
        if (turns_past_180(facts%arc)) &
            call put_text('   TURNS BY MORE THAN 180 DEGREES', text, next)
        call block%line(text(:next - 1))
    end subroutine put_conic

    !> Puts the general equation with the residuals of the three points.
    subroutine put_equation(block, facts)
        type(card_block_type), intent(inout) :: block !! gets the lines
        type(card_facts_type), intent(in) :: facts  !! of a card with an arc
        character(line_room) :: text
        integer :: next

        call block%line('EQUATION, POINT 1 AS ORIGIN: A XX + B XY + C YY + D X + E Y + F = 0')
        call put_coefficients(block, facts%conic%coefficient)
        next = 1
        call put_text('  LEFT SIDE AT POINT 1 ', text, next)
        call put_estimate(facts%residual(1), text, next)
        call put_text('   AT 2 ', text, next)
        call put_estimate(facts%residual(2), text, next)
        call put_text('   AT 3 ', text, next)
        call put_estimate(facts%residual(3), text, next)
        call block%line(text(:next - 1))
    end subroutine put_equation

    !> Puts the equation in the frame of the 1970 program, or that it has none.
    subroutine put_shifted(block, facts)
        type(card_block_type), intent(inout) :: block !! gets the lines
        type(card_facts_type), intent(in) :: facts  !! of a card with an arc
        character(line_room) :: text
        integer :: next

        next = 1
        call put_text('THE SAME FROM FIVE EQUATIONS, X AND Y PLUS ', text, next)
        call put_fixed(facts%shifted%shift, shift_decimals, text, next)
        call put_text(': A XX + ... + E Y = -1', text, next)
        call block%line(text(:next - 1))
        if (.not. facts%has_shifted) then
            call block%line('  THE FIVE EQUATIONS HAVE NO UNIQUE SOLUTION')
            return
        end if
        call put_coefficients(block, facts%shifted%coefficient)
        next = 1
        call put_text('  CONDITION ', text, next)
        call put_estimate(1.0_dp/facts%shifted%rcond, text, next)
        call put_text('   LARGEST DISTANCE FROM THE ARC ', text, next)
        call put_estimate(facts%difference, text, next)
        call block%line(text(:next - 1))
    end subroutine put_shifted

    !> Puts a number of which only the size matters, right in its columns.
    subroutine put_estimate(value, text, next)
        real(dp), intent(in) :: value           !! any number
        character(*), intent(inout) :: text     !! gets it
        integer, intent(inout) :: next          !! its first column; behind it on return
        integer, parameter :: room = 10, figures = 2
        character(widest_scientific) :: number
        integer :: behind

        behind = 1
        call put_scientific(value, figures, number, behind)
        text(next:next + room - 1) = ''
        next = next + room
        text(next - behind + 1:next - 1) = number(:behind - 1)
    end subroutine put_estimate

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
