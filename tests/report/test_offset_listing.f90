!> Tables of offsets: stations across, as many as fit; a dash where the skin is not met.
program test_offset_listing
    use base_kinds, only: dp
    use base_output, only: output_type
    use cut_offsets, only: offset_row_type, offset_table_type
    use report_offset_listing, only: print_offsets
    use report_ordinate, only: new_form
    use report_page, only: page_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(offset_table_type) :: table
    character(:), allocatable :: text
    integer :: i

    table%axis = 1
    table%stations = [(10.0_dp*real(i, dp), i = 0, 7)]
    allocate (table%rows(1))
    table%rows(1) = offset_row_type(4.5_dp, 2, 1, [(i > 1, i = 1, 8)], [(-real(i, dp), i = 1, 8)])
    text = listing(80)
    call tap%ok(index(text, 'HEIGHTS (WL) ON BUTT LINES') > 0, 'a table has a title')
    call tap%ok(index(text, '       4.500 UPPER             -    -2.000    -3.000') > 0, &
        'a row has ordinate, section and figures; a dash where the skin is not met')
    call tap%ok(longest_line(text) <= 80, 'it keeps to 80 columns')
    call tap%ok(count_of(text, 'HEIGHTS') == 2, 'eight stations are two bands of 80 columns')
    call tap%ok(count_of(listing(132), 'HEIGHTS') == 1, 'and one of 132')
    table%axis = 2
    call tap%ok(index(listing(80), 'HALF-BREADTHS (BL) ON WATERLINES') > 0, 'waterlines too')
    deallocate (table%rows)
    allocate (table%rows(0))
    call tap%same(listing(80), '', 'a table without rows is not printed')
    call tap%finish()

contains

    !> The table on pages of some width.
    function listing(width) result(text)
        integer, intent(in) :: width !! columns
        character(:), allocatable :: text
        type(page_type) :: page
        type(output_type) :: out
        call page%set_heading('TITLE', 'deck.crd', 'INCHES')
        call page%set_size(width, 60)
        call print_offsets(page, table, [character(8) :: 'LOWER', 'UPPER'], &
            new_form('INCHES', 'INCHES', 3), out)
        text = out%text()
    end function listing

    !> How often a text occurs.
    pure integer function count_of(text, part)
        character(*), intent(in) :: text !! where
        character(*), intent(in) :: part !! what
        integer :: i
        count_of = 0
        do i = 1, len(text) - len(part) + 1
            if (text(i:i + len(part) - 1) == part) count_of = count_of + 1
        end do
    end function count_of

    !> Columns of the longest line.
    pure integer function longest_line(text)
        character(*), intent(in) :: text !! lines
        integer :: i, begin
        longest_line = 0
        begin = 1
        do i = 1, len(text)
            if (text(i:i) /= new_line('a')) cycle
            longest_line = max(longest_line, i - begin)
            begin = i + 1
        end do
    end function longest_line

end program test_offset_listing
