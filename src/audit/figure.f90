!> A figure as it was printed: a text, of which every character counts. `?` stands for a character
!> that can't be read, a blank for no figure at all.
!>
!>     -15.999    decimal: inches, millimetres or whatever the table is in
!>     4-7-3      feet, inches, eighths of an inch, also -4-7-3; the value is in inches
!>
!> A figure is worth a whole number of units of its last place: .001, .01 ... or an eighth.
module audit_figure
    use base_kinds, only: dp, i64
    use base_text, only: columns, row_of
    implicit none (type, external)
    private

    public :: figure_type, scale_type, read_figure, print_figure, unit_of, value_of, bare
    public :: is_printed_so

    !> Characters of the longest figure.
    integer, parameter, public :: figure_length = 24
    !> More digits than a whole number holds; no table has as many.
    integer, parameter :: most_digits = 17

    !> How figures are written.
    type, public :: form_list
        integer :: decimal = 1 !! digits, a point, decimals
        integer :: eighths = 2 !! feet-inches-eighths
    end type form_list
    !> The forms by name: `form%decimal`.
    type(form_list), parameter, public :: form = form_list()

    !> The places that all figures of a table are printed to.
    type :: scale_type
        integer :: form = 1     !! one of `form%...`
        integer :: decimals = 3 !! figures behind the point; no matter for eighths
    end type scale_type

    !> A printed figure.
    type :: figure_type
        character(figure_length) :: text = ''  !! as printed, nothing before it
        type(scale_type) :: scale              !! its form and how many decimals it has
        integer(i64) :: units = 0              !! its value in units of its last place
        logical :: is_blank = .true.           !! nothing is printed
        logical :: is_unread = .false.         !! some characters can't be read
        logical :: is_sound = .false.          !! read as a figure of its form
    end type figure_type

contains

    !> Reads a text as a figure of a form. Any text is one; `is_sound` says whether it is formed as
    !> figures are.
    pure type(figure_type) function read_figure(text, form_of) result(figure)
        character(*), intent(in) :: text !! as printed; blanks around it do not count
        integer, intent(in) :: form_of   !! one of `form%...`

        figure%text = adjustl(text)
        figure%scale%form = form_of
        figure%is_blank = figure%text == ''
        figure%is_unread = index(figure%text, '?') > 0
        if (figure%is_blank) return
        if (form_of == form%eighths) then
            figure%scale%decimals = 0
            if (.not. figure%is_unread) call read_eighths(figure)
        else
            call read_decimal(figure)
        end if
    end function read_figure

    !> Reads digits, a point, decimals.
    pure subroutine read_decimal(figure)
        type(figure_type), intent(inout) :: figure !! its text is given
        integer :: i, first, digits, points

        first = 1 + scan(figure%text(1:1), '+-')
        digits = 0
        points = 0
        figure%scale%decimals = 0
        do i = first, len_trim(figure%text)
            select case (figure%text(i:i))
            case ('0':'9')
                figure%units = 10*figure%units + digit_at(figure%text, i)
                digits = digits + 1
                if (points > 0) figure%scale%decimals = figure%scale%decimals + 1
            case ('?')
                if (points > 0) figure%scale%decimals = figure%scale%decimals + 1
            case ('.')
                points = points + 1
            case default
                return
            end select
            if (digits > most_digits) return
        end do
        if (figure%text(1:1) == '-') figure%units = -figure%units
        figure%is_sound = digits > 0 .and. points <= 1 .and. .not. figure%is_unread
    end subroutine read_decimal

    !> Reads feet, inches and eighths, with a dash between them.
    pure subroutine read_eighths(figure)
        type(figure_type), intent(inout) :: figure !! its text is given, all readable
        integer(i64) :: part(3)
        integer :: i, at, digits
        logical :: is_negative

        is_negative = figure%text(1:1) == '-'
        part = 0
        at = 1
        digits = 0
        do i = merge(2, 1, is_negative), len_trim(figure%text)
            select case (figure%text(i:i))
            case ('0':'9')
                digits = digits + 1
                if (digits > 5) return
                part(at) = 10*part(at) + digit_at(figure%text, i)
            case ('-')
                if (digits == 0 .or. at == 3) return
                at = at + 1
                digits = 0
            case default
                return
            end select
        end do
        figure%is_sound = at == 3 .and. digits > 0 .and. part(2) < 12 .and. part(3) < 8
        figure%units = (12*part(1) + part(2))*8 + part(3)
        if (is_negative) figure%units = -figure%units
    end subroutine read_eighths

    !> The digit at a place of a text that has one there.
    pure integer(i64) function digit_at(text, i) result(digit)
        character(*), intent(in) :: text !! any text
        integer, intent(in) :: i         !! which character
        digit = int(iachar(text(i:i)) - iachar('0'), i64)
    end function digit_at

    !> The text of a value of so many units of the last place.
    pure function print_figure(units, scale) result(text)
        integer(i64), intent(in) :: units     !! in units of the last place
        type(scale_type), intent(in) :: scale !! form and decimals
        character(figure_length) :: text
        character(figure_length) :: digits
        integer(i64) :: size
        integer :: last

        size = abs(units)
        if (scale%form == form%eighths) then
            write (text, '(i0,"-",i0,"-",i0)') size/96, mod(size, 96_i64)/8, mod(size, 8_i64)
        else
            write (digits, '(i0)') size
            last = len_trim(digits)
            if (last <= scale%decimals) then
                digits = row_of('0', scale%decimals + 1 - last)//digits
                last = scale%decimals + 1
            end if
            text = digits
            if (scale%decimals > 0) then
                last = last - scale%decimals
                text = digits(:last)//'.'//digits(last + 1:)
            end if
        end if
        if (units < 0) text = '-'//text(:figure_length - 1)
    end function print_figure

    !> The unit of the last place: deck units, inches for eighths.
    elemental real(dp) function unit_of(scale)
        type(scale_type), intent(in) :: scale !! form and decimals
        unit_of = 0.125_dp
        if (scale%form == form%decimal) unit_of = 1.0_dp/10.0_dp**scale%decimals
    end function unit_of

    !> The value of so many units of the last place, the double nearest to it.
    elemental real(dp) function value_of(units, scale)
        integer(i64), intent(in) :: units     !! in units of the last place
        type(scale_type), intent(in) :: scale !! form and decimals
        if (scale%form == form%decimal) then
            value_of = real(units, dp)/10.0_dp**scale%decimals
        else
            value_of = real(units, dp)/8.0_dp
        end if
    end function value_of

    !> A text of a figure as all are compared: no plus sign, one zero and not more or fewer before a
    !> point that has none but zeros before it.
    pure function bare(text) result(short)
        character(*), intent(in) :: text !! any text
        character(figure_length) :: short
        logical :: is_negative

        short = adjustl(text)
        is_negative = short(1:1) == '-'
        if (scan(short(1:1), '+-') > 0) short = short(2:)
        do while (short(1:1) == '0' .and. scan(short(2:2), '0123456789') > 0)
            short = short(2:)
        end do
        if (short(1:1) == '.') short = '0'//short(:figure_length - 1)
        if (is_negative) short = '-'//short(:figure_length - 1)
    end function bare

    !> True where a text with unreadable characters may be another one: every `?` is one character.
    pure logical function is_printed_so(unread, text) result(may_be)
        character(*), intent(in) :: unread !! with `?` for characters
        character(*), intent(in) :: text   !! a whole figure
        character(figure_length) :: pattern, whole
        integer :: i

        pattern = bare(unread)
        whole = bare(text)
        may_be = len_trim(pattern) == len_trim(whole)
        do i = 1, len_trim(pattern)
            if (columns(pattern, i, i) == '?') cycle
            may_be = may_be .and. pattern(i:i) == whole(i:i)
        end do
    end function is_printed_so

end module audit_figure
