!> Sheets of patterns: parts set in rows, or one on each sheet; and the pages of those sheets that
!> are as large as what is on them.
module export_pattern_sheets
    use base_kinds, only: dp
    use base_text, only: to_text
    use export_pattern_bars, only: bars_height, draw_bars
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

    !> Sets parts on sheets: in rows on one, of a roll on as few as can be; or one on each. A part
    !> that is wider than the roll, either way, has a sheet of its own, its longer side along it.
    pure subroutine make_sheets(parts, is_each, paper, sheets)
        type(page_type), intent(in) :: parts(:)                 !! from `framed_part`
        logical, intent(in) :: is_each                          !! a sheet for each part
        type(paper_type), intent(in) :: paper                   !! what it is printed on
        type(page_type), allocatable, intent(out) :: sheets(:)  !! the sheets
        type(rows_type) :: rows
        logical :: is_turned(size(parts)), is_alone(size(parts))
        integer :: first, last, i, count

        call turn_wide(parts, paper, is_turned, is_alone)
        is_alone = is_alone .or. is_each
        allocate (sheets(size(parts)))
        count = 0
        first = 1
        do while (first <= size(parts))
            last = first
            do while (.not. is_alone(first) .and. last < size(parts))
                if (is_alone(last + 1)) exit
                last = last + 1
            end do
            do
                rows = set_rows(parts(first:last), is_turned(first:last), paper)
                if (paper%kind /= paper_kind%roll .or. first == last) exit
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

    !> Which parts are turned to fit on a roll, and which do not fit either way.
    pure subroutine turn_wide(parts, paper, is_turned, is_too_wide)
        type(page_type), intent(in) :: parts(:)             !! the parts
        type(paper_type), intent(in) :: paper               !! what they are printed on
        logical, intent(out) :: is_turned(:)                !! by a quarter, to the left
        logical, intent(out) :: is_too_wide(:)              !! for the roll, either way
        real(dp) :: width
        integer :: i

        is_turned = .false.
        is_too_wide = .false.
        if (paper%kind /= paper_kind%roll) return
        width = paper%size(1) - 2.0_dp*paper%margin
        do i = 1, size(parts)
            is_too_wide(i) = minval(parts(i)%size) > width
            is_turned(i) = parts(i)%size(1) > merge(parts(i)%size(2), width, is_too_wide(i))
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
