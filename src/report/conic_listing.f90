!> The listing of a 1970 deck computed well: each card echoed, its conic described, its tables.
!>
!>     CARD 1   MHB side
!>            X1      Y1      S1  ...
!>          -30.    -10.   0.114  ...
!>
!>     HYPERBOLA   RHO 0.50214   LENGTH 80.2281
!>     ...
!>     BY STEPS OF X
!>                  X             Y         SLOPE       ANGLE  RADIUS OF CURVATURE
!>           -30.0000      -10.0000      0.114000      6.5036            -567.1234
module report_conic_listing
    use base_constants, only: degrees, pi
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: characters, first_bytes, right, row_of, to_text, upper
    use body_card_facts, only: card_facts_type
    use body_card_tables, only: card_table_type
    use deck_conic_card, only: conic_card_type
    use deck_control_card, only: heading_type
    use deck_layout, only: conic_fields, last_read_column
    use geom_arc, only: rho, turns_past_180
    use geom_arc_point, only: slope_type
    use geom_conic, only: conic_kind, kind_name
    use geom_contour, only: contour_point_type
    use base_digits, only: fixed, scientific
    use report_page, only: page_columns, page_type
    implicit none (type, external)
    private

    public :: conic_listing_type

    !> Lines of a card's block that stay together: echo, conic, both equations, first rows.
    integer, parameter :: block_lines = 22
    !> Decimals of ordinates, slopes and angles.
    integer, parameter :: ordinate_decimals = 4, slope_decimals = 6, angle_decimals = 4

    !> A listing being printed.
    type :: conic_listing_type
        private
        type(page_type) :: page
    contains
        procedure :: begin
        procedure :: print_card
    end type conic_listing_type

contains

    !> Sets the heading of the pages.
    subroutine begin(listing, heading, deck)
        class(conic_listing_type), intent(inout) :: listing !! the listing
        type(heading_type), intent(in) :: heading           !! what TITLE and UNITS said
        character(*), intent(in) :: deck                    !! name of the deck, without folders
        character(:), allocatable :: title, units
        title = 'CONIC LOFTING'
        units = 'INCHES'
        if (allocated(heading%title)) title = heading%title
        if (allocated(heading%units)) units = heading%units
        call listing%page%set_heading(title, deck, units)
    end subroutine begin

    !> Prints the block of one card.
    subroutine print_card(listing, card, facts, tables, out)
        class(conic_listing_type), intent(inout) :: listing !! the listing
        type(conic_card_type), intent(in) :: card           !! the card, sound or not
        type(card_facts_type), intent(in) :: facts          !! its conic, if it has one
        type(card_table_type), intent(in) :: tables(:)      !! its tables, if it has any
        type(output_type), intent(inout) :: out             !! where it goes
        integer :: i

        associate (page => listing%page)
            call page%keep(out, block_lines)
            call print_echo(page, card, out)
            if (facts%has_arc) then
                call print_conic(page, facts, out)
                call print_equation(page, facts, out)
                call print_shifted(page, facts, out)
                do i = 1, size(tables)
                    call print_table(page, tables(i), out)
                end do
                if (size(tables) == 0) call print_missing(page, 'NO TABLE', out)
            else
                call print_missing(page, 'NOT RUN', out)
            end if
            call page%blank(out)
            call page%blank(out)
        end associate
    end subroutine print_card

    !> Prints the name of a card, the names of its fields, and the card as punched.
    subroutine print_echo(page, card, out)
        type(page_type), intent(inout) :: page      !! the listing
        type(conic_card_type), intent(in) :: card   !! the card
        type(output_type), intent(inout) :: out     !! where it goes
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
        call page%line(out, head//row_of(' ', page_columns - characters(head) - len(place))//place)
        call page%line(out, names)
        call page%line(out, card%image(:last_read_column))
        call page%blank(out)
    end subroutine print_echo

    !> Prints what kind of conic it is.
    subroutine print_conic(page, facts, out)
        type(page_type), intent(inout) :: page      !! the listing
        type(card_facts_type), intent(in) :: facts  !! of a card with an arc
        type(output_type), intent(inout) :: out     !! where it goes
        character(:), allocatable :: text
        character(16) :: figures

        text = upper(kind_name(facts%conic%kind))
        if (facts%conic%kind == conic_kind%line) text = 'STRAIGHT LINE'
        if (facts%conic%kind /= conic_kind%line) then
            figures = fixed(rho(facts%arc), 16, 6)
            text = text//'   RHO '//trim(adjustl(figures))
        end if
        if (facts%has_length) then
            figures = fixed(facts%length, 16, ordinate_decimals)
            text = text//'   LENGTH '//trim(adjustl(figures))
        end if
        if (turns_past_180(facts%arc)) text = text//'   TURNS BY MORE THAN 180 DEGREES'
        call page%line(out, text)
    end subroutine print_conic

    !> Prints the general equation with the residuals of the three points.
    subroutine print_equation(page, facts, out)
        type(page_type), intent(inout) :: page      !! the listing
        type(card_facts_type), intent(in) :: facts  !! of a card with an arc
        type(output_type), intent(inout) :: out     !! where it goes
        character(10) :: left(3)
        integer :: i

        call page%line(out, 'EQUATION, POINT 1 AS ORIGIN: A XX + B XY + C YY + D X + E Y + F = 0')
        call print_coefficients(page, facts%conic%coefficient, out)
        do i = 1, size(left)
            left(i) = scientific(facts%residual(i), len(left), 2)
        end do
        call page%line(out, '  LEFT SIDE AT POINT 1 '//left(1)//'   AT 2 '//left(2)// &
            '   AT 3 '//left(3))
    end subroutine print_equation

    !> Prints the equation in the frame of the 1970 program, or that it has none.
    subroutine print_shifted(page, facts, out)
        type(page_type), intent(inout) :: page      !! the listing
        type(card_facts_type), intent(in) :: facts  !! of a card with an arc
        type(output_type), intent(inout) :: out     !! where it goes
        character(16) :: shift
        character(10) :: condition, difference

        shift = adjustl(fixed(facts%shifted%shift, 16, 3))
        call page%line(out, 'THE SAME FROM FIVE EQUATIONS, X AND Y PLUS '//trim(shift)// &
            ': A XX + ... + E Y = -1')
        if (.not. facts%has_shifted) then
            call page%line(out, '  THE FIVE EQUATIONS HAVE NO UNIQUE SOLUTION')
            return
        end if
        call print_coefficients(page, facts%shifted%coefficient, out)
        condition = scientific(1.0_dp/facts%shifted%rcond, len(condition), 2)
        difference = scientific(facts%difference, len(difference), 2)
        call page%line(out, '  CONDITION '//condition// &
            '   LARGEST DISTANCE FROM THE ARC '//difference)
    end subroutine print_shifted

    !> Prints coefficients by name, three on a line.
    subroutine print_coefficients(page, coefficient, out)
        type(page_type), intent(inout) :: page  !! the listing
        real(dp), intent(in) :: coefficient(:)  !! A, B, C ...
        type(output_type), intent(inout) :: out !! where they go
        character(*), parameter :: names = 'ABCDEF'
        character(:), allocatable :: text
        integer :: i

        text = ''
        do i = 1, size(coefficient)
            text = text//'  '//names(i:i)//scientific(coefficient(i), 23, 16)
            if (mod(i, 3) /= 0 .and. i < size(coefficient)) cycle
            call page%line(out, text)
            text = ''
        end do
    end subroutine print_coefficients

    !> Prints a table, a row a point.
    subroutine print_table(page, table, out)
        type(page_type), intent(inout) :: page      !! the listing
        type(card_table_type), intent(in) :: table  !! the table
        type(output_type), intent(inout) :: out     !! where it goes
        character(page_columns) :: head(2)
        integer :: i

        head(1) = 'BY STEPS OF '//merge('X', 'Y', table%axis == 1)
        head(2) = right('X', 14)//right('Y', 14)//right('SLOPE', 14)//right('ANGLE', 12)// &
            right('RADIUS OF CURVATURE', 22)
        call page%blank(out)
        call page%set_columns(out, head)
        do i = 1, size(table%row)
            call page%line(out, row_text(table%row(i)))
        end do
        call page%end_columns()
    end subroutine print_table

    !> One row of a table. The radius of curvature is positive where the curve turns left on the
    !> way from point 1 to point 3.
    pure function row_text(row) result(text)
        type(contour_point_type), intent(in) :: row !! the point
        character(:), allocatable :: text
        text = fixed(row%x, 14, ordinate_decimals)//fixed(row%y, 14, ordinate_decimals)
        if (row%slope%is_vertical) then
            text = text//right('VERTICAL', 14)
        else
            text = text//fixed(row%slope%value, 14, slope_decimals)
        end if
        text = text//fixed(angle_of(row%slope), 12, angle_decimals)
        if (is_zero(row%curvature)) then
            text = text//right('STRAIGHT', 22)
        else
            text = text//fixed(1.0_dp/row%curvature, 22, ordinate_decimals)
        end if
    end function row_text

    !> The angle of a slope, degrees above -90 and up to 90.
    pure real(dp) function angle_of(slope) result(angle)
        type(slope_type), intent(in) :: slope !! dy/dx
        angle = 0.5_dp*pi
        if (.not. slope%is_vertical) angle = atan(slope%value)
        angle = angle*degrees
    end function angle_of

    !> Says that something was asked for and is not there.
    subroutine print_missing(page, what, out)
        type(page_type), intent(inout) :: page  !! the listing
        character(*), intent(in) :: what        !! `NO TABLE` or `NOT RUN`
        type(output_type), intent(inout) :: out !! where it goes
        call page%line(out, what//': THE DIAGNOSTICS SAY WHY')
    end subroutine print_missing

end module report_conic_listing
