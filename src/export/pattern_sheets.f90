!> Sheets of patterns: parts set in rows, or one on each sheet; and the pages of those sheets that
!> are as large as what is on them.
module export_pattern_sheets
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: to_text
    use export_pattern_bars, only: bars_height, draw_bars
    use export_pattern_number, only: inches
    use export_pattern_page, only: bounds_of, label_type, page_type
    use export_pattern_paper, only: paper_kind, paper_type
    use export_pattern_rows, only: best_rows, rows_type, rows_within
    use export_pattern_style, only: style
    implicit none (type, external)
    private

    public :: framed_part, make_sheets, fitted_page

    !> A roll is no longer than this where it can be helped: a page of a PDF can't be. In.
    real(dp), parameter :: longest_sheet = 195.0_dp
    !> The narrowest page that is as large as its pattern, and what sizes are rounded up to: in.
    real(dp), parameter :: narrowest = 6.5_dp, grain = 0.01_dp
    !> Below the parts: height of the words, from line to line; from the bars to the words; all: in.
    real(dp), parameter :: height = 0.12_dp, line_height = 0.2_dp, gap = 0.15_dp, &
        strip = bars_height + 2.0_dp*gap + 2.0_dp*line_height

contains

    !> A part with its lower left corner at (0, 0).
    pure function framed_part(page, name, label) result(framed)
        type(page_type), intent(in) :: page         !! with at least one item
        character(*), intent(in) :: name            !! letters, figures, - _ .
        character(*), intent(in) :: label           !! any bytes
        type(page_type) :: framed
        real(dp) :: box(4)

        box = bounds_of(page)
        framed%name = name
        framed%label = label
        framed%size = box(3:) - box(:2)
        call framed%place(page, -box(:2), .false.)
    end function framed_part

    !> Sets parts on sheets: in rows on one, of a roll on as few as can be; or one on each.
    !>
    !> Fails with `cause%usage` where a part is wider than a roll, either way.
    pure subroutine make_sheets(parts, is_each, paper, sheets, error)
        type(page_type), intent(in) :: parts(:)                 !! from `framed_part`
        logical, intent(in) :: is_each                          !! a sheet for each part
        type(paper_type), intent(in) :: paper                   !! what it is printed on
        type(page_type), allocatable, intent(out) :: sheets(:)  !! the sheets
        type(error_type), allocatable, intent(out) :: error     !! see above
        type(rows_type) :: rows
        logical :: is_turned(size(parts))
        integer :: first, last, i, count

        call turn_wide(parts, paper, is_turned, error)
        if (allocated(error)) return
        allocate (sheets(size(parts)))
        count = 0
        first = 1
        do while (first <= size(parts))
            last = merge(first, size(parts), is_each)
            do
                rows = set_rows(parts(first:last), is_turned(first:last), paper)
                if (paper%kind == paper_kind%fitted .or. first == last) exit
                if (maxval(rows%size) <= longest_sheet) exit
                last = last - 1
            end do
            count = count + 1
            associate (sheet => sheets(count))
                sheet%size = rows%size
                do i = first, last
                    call sheet%place(parts(i), rows%at(:, i - first + 1), is_turned(i))
                end do
                sheet%name = 'sheet-'//to_text(count)
                sheet%label = 'SHEET '//to_text(count)
                if (first == last) sheet%name = parts(first)%name
                if (first == last) sheet%label = parts(first)%label
            end associate
            first = last + 1
        end do
        sheets = sheets(:count)
    end subroutine make_sheets

    !> Which parts are turned to fit on a roll. Fails where one does not, either way.
    pure subroutine turn_wide(parts, paper, is_turned, error)
        type(page_type), intent(in) :: parts(:)             !! the parts
        type(paper_type), intent(in) :: paper               !! what they are printed on
        logical, intent(out) :: is_turned(:)                !! by a quarter, to the left
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: width
        integer :: i

        is_turned = .false.
        if (paper%kind /= paper_kind%roll) return
        width = paper%size(1) - 2.0_dp*paper%margin
        do i = 1, size(parts)
            is_turned(i) = parts(i)%size(1) > width
            if (minval(parts(i)%size) <= width) cycle
            call fail(error, cause%usage, parts(i)%label//' takes a roll '// &
                inches(minval(parts(i)%size) + 2.0_dp*paper%margin)//' in wide; take that, or '// &
                'paper (a4, letter, a3, tabloid), which is tiled')
            return
        end do
    end subroutine turn_wide

    !> Sets parts in rows: as wide as the roll, or so that the sheet is nearly square.
    pure type(rows_type) function set_rows(parts, is_turned, paper) result(rows)
        type(page_type), intent(in) :: parts(:)     !! the parts
        logical, intent(in) :: is_turned(:)         !! by a quarter
        type(paper_type), intent(in) :: paper       !! what they are printed on
        real(dp) :: sizes(2, size(parts))
        integer :: i

        do i = 1, size(parts)
            sizes(:, i) = parts(i)%size
            if (is_turned(i)) sizes(:, i) = parts(i)%size([2, 1])
        end do
        if (paper%kind == paper_kind%roll) then
            rows = rows_within(sizes, paper%size(1) - 2.0_dp*paper%margin)
        else
            rows = best_rows(sizes)
        end if
    end function set_rows

    !> The page of a sheet, as large as the sheet or as wide as the roll, with check bars below.
    pure function fitted_page(sheet, paper, heading) result(page)
        type(page_type), intent(in) :: sheet        !! from `make_sheets`
        type(paper_type), intent(in) :: paper       !! what it is printed on
        character(*), intent(in) :: heading         !! of the deck, any bytes
        type(page_type) :: page
        real(dp) :: at(2), width

        page%name = sheet%name
        page%label = sheet%label
        page%size = sheet%size + 2.0_dp*paper%margin + [0.0_dp, strip]
        page%size = grain*real(ceiling(page%size/grain), dp)
        page%size(1) = max(page%size(1), narrowest)
        if (paper%kind == paper_kind%roll) page%size(1) = paper%size(1)
        width = page%size(1) - 2.0_dp*paper%margin
        at = paper%margin + [0.5_dp*(width - sheet%size(1)), strip]
        call page%place(sheet, at, .false.)
        call draw_bars(page, [paper%margin, paper%margin], width)
        at = paper%margin + [0.0_dp, bars_height + gap]
        call write_words(page, 'FULL SIZE: PRINT AT 100 %, NOT FITTED, AND MEASURE BOTH BARS', at)
        at(2) = at(2) + line_height
        call write_words(page, heading, at)
    end function fitted_page

    !> Writes words of the sheet.
    pure subroutine write_words(page, words, at)
        type(page_type), intent(inout) :: page      !! gets them
        character(*), intent(in) :: words           !! any bytes
        real(dp), intent(in) :: at(2)               !! start of the base line, in
        type(label_type) :: label

        label%text = words
        label%height = height
        call page%write(style%sheet_words, at, label)
    end subroutine write_words

end module export_pattern_sheets
