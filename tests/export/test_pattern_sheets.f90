!> Tests of sheets.
program test_pattern_sheets
    use base_kinds, only: dp
    use export_pattern_page, only: bounds_of, page_type
    use export_pattern_paper, only: paper_kind, paper_type
    use export_pattern_sheets, only: fitted_page, framed_part, make_sheets
    use export_pattern_style, only: style
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(page_type) :: parts(3), page
    type(page_type), allocatable :: sheets(:)
    type(paper_type) :: fitted, roll
    real(dp) :: box(4)

    parts(1) = part('A', [10.0_dp, 20.0_dp])
    parts(2) = part('B', [30.0_dp, 12.0_dp])
    parts(3) = part('C', [5.0_dp, 5.0_dp])
    box = bounds_of(parts(2))
    call tap%ok(all(abs(box - [0.0_dp, 0.0_dp, 30.0_dp, 12.0_dp]) < 1.0e-12_dp), &
        'a part begins at its corner, wherever it was drawn')

    call make_sheets(parts, .true., fitted, sheets)
    call tap%ok(size(sheets) == 3, 'a sheet for each')
    call tap%same(sheets(2)%name//sheets(2)%label, 'BB', 'is named for its part')
    call make_sheets(parts, .false., fitted, sheets)
    call tap%ok(size(sheets) == 1 .and. sheets(1)%group_count == 3, 'or all on one')
    call tap%same(sheets(1)%name, 'sheet-1', 'which has a name of its own')
    page = fitted_page(sheets(1), fitted, 'A DECK')
    box = bounds_of(page)
    call tap%ok(all(box(:2) >= 0.4_dp) .and. all(box(3:) <= page%size - 0.4_dp), &
        'its page has a margin around everything')
    call tap%near(modulo(100.0_dp*page%size(1) + 0.5_dp, 1.0_dp), 0.5_dp, 1.0e-9_dp, &
        'and a size in hundredths')

    roll%kind = paper_kind%roll
    roll%size(1) = 24.0_dp
    call make_sheets(parts, .false., roll, sheets)
    call tap%ok(size(sheets) == 1 .and. sheets(1)%size(1) <= 23.0_dp, &
        'on a roll what is too wide is turned')
    page = fitted_page(sheets(1), roll, 'A DECK')
    call tap%near(page%size(1), 24.0_dp, 1.0e-12_dp, 'the page is as wide as the roll')
    parts(2) = part('B', [130.0_dp, 12.0_dp])
    parts(3) = part('C', [140.0_dp, 12.0_dp])
    call make_sheets(parts, .false., roll, sheets)
    call tap%ok(size(sheets) == 2 .and. maxval(sheets(1)%size) < 200.0_dp, &
        'a roll is cut before it is too long for a page')
    parts(3) = part('TOO WIDE', [40.0_dp, 25.0_dp])
    parts(2) = part('B', [10.0_dp, 12.0_dp])
    call make_sheets(parts, .false., roll, sheets)
    call tap%ok(size(sheets) == 2 .and. sheets(1)%group_count == 2, &
        'what is too wide either way has a sheet of its own')
    call tap%ok(all(abs(sheets(2)%size - [25.0_dp, 40.0_dp]) < 1.0e-12_dp), &
        'with its longer side along the roll')
    call tap%finish()

contains

    !> A part of a size.
    type(page_type) function part(name, size) result(framed)
        character(*), intent(in) :: name    !! of it
        real(dp), intent(in) :: size(2)     !! in
        type(page_type) :: page

        call page%open_group(name, name)
        call page%draw(style%outline, reshape([7.0_dp, -3.0_dp, 7.0_dp + size(1), -3.0_dp, &
            7.0_dp + size(1), -3.0_dp + size(2)], [2, 3]), .true.)
        framed = framed_part(page, name, name)
    end function part

end program test_pattern_sheets
