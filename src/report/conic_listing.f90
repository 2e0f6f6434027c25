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
    use base_kinds, only: i64
    use base_output, only: output_type
    use deck_control_card, only: heading_type
    use report_card_block, only: card_block_type
    use report_page, only: page_columns, page_type
    use report_row_text, only: row_columns, row_heads
    implicit none (type, external)
    private

    public :: conic_listing_type

    !> Lines of a card's block that stay together: echo, conic, both equations, first rows.
    integer, parameter :: block_lines = 22

    !> A listing being printed.
    type :: conic_listing_type
        private
        type(page_type) :: page
    contains
        procedure :: begin
        procedure :: print_block
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
    subroutine print_block(listing, block, out)
        class(conic_listing_type), intent(inout) :: listing !! the listing
        type(card_block_type), intent(in) :: block          !! of the card
        type(output_type), intent(inout) :: out             !! where it goes
        integer(i64) :: done
        integer :: i

        associate (page => listing%page)
            call page%keep(out, block_lines)
            call page%kept_lines(out, block%text, block%front_bytes, block%front)
            done = block%front_bytes
            do i = 1, block%tables
                call print_table(page, block, i, done, out)
            end do
            if (.not. block%has_arc) then
                call page%line(out, 'NOT RUN: THE DIAGNOSTICS SAY WHY')
            else if (block%tables == 0) then
                call page%line(out, 'NO TABLE: THE DIAGNOSTICS SAY WHY')
            end if
            call page%blank(out)
            call page%blank(out)
        end associate
    end subroutine print_block

    !> Prints a table of a block.
    subroutine print_table(page, block, i, done, out)
        type(page_type), intent(inout) :: page      !! the listing
        type(card_block_type), intent(in) :: block  !! the block
        integer, intent(in) :: i                    !! which table
        integer(i64), intent(inout) :: done         !! bytes of the block printed
        type(output_type), intent(inout) :: out     !! where it goes
        character(page_columns) :: head(2)

        head(1) = 'BY STEPS OF '//merge('X', 'Y', block%axis(i) == 1)
        head(2) = row_heads
        call page%blank(out)
        call page%set_columns(out, head)
        call page%equal_lines(out, block%text, done, row_columns + 1, block%rows(i))
        call page%end_columns()
        done = done + int(row_columns + 1, i64)*int(block%rows(i), i64)
    end subroutine print_table

end module report_conic_listing
