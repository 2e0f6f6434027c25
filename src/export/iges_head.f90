!> The first two sections of an IGES file: what it is in plain words, and the facts that readers
!> need, of which the unit is the foremost (IGES 5.3, 2.2.4.2 and 2.2.4.3).
!>
!> The standard asks for the date of writing, and readers complain where that of the model is left
!> out; both are the first second of 1970 in every file, so that the same deck gives the same bytes.
module export_iges_head
    use base_constants, only: version
    use base_digits, only: shortest
    use base_kinds, only: dp
    use export_drawing, only: drawing_type
    use export_iges_card, only: section_type
    use export_iges_record, only: plain, record_type
    use export_units, only: unit_type
    implicit none (type, external)
    private

    public :: put_start, put_global, resolution_of

    !> Columns of a line of plain words.
    integer, parameter :: start_columns = 72
    !> The date of every file.
    character(*), parameter :: no_date = '19700101.000000'
    !> Bits of integers, largest power of ten and figures of reals, both kinds being doubles.
    integer, parameter :: integer_bits = 32, power = 308, figures = 15
    !> The version of the standard, 5.3, and that no drafting standard applies (fields 23, 24).
    integer, parameter :: version_flag = 11, no_standard = 0
    !> How many times the smallest length that means anything, and the width of lines, go into an
    !> inch.
    real(dp), parameter :: resolutions = 1.0e6_dp, line_widths = 100.0_dp
    !> Names of units, and their flags (field 14).
    character(6), parameter :: unit_names(4) = ['INCHES', 'MM    ', 'FEET  ', 'M     ']
    integer, parameter :: unit_flags(4) = [1, 2, 4, 6]

contains

    !> Puts what the file is, in plain words.
    subroutine put_start(section, drawing, levels)
        type(section_type), intent(inout) :: section    !! S
        type(drawing_type), intent(in) :: drawing       !! deck, title, unit, tolerance
        character(*), intent(in) :: levels              !! a line for each level, with its end

        call put_words(section, 'LOFT '//version//': curves and skin of '//drawing%deck)
        call put_words(section, drawing%title)
        call put_words(section, 'Lengths in '//trim(drawing%units)//'; x is STA, aft; '// &
            'y is BL, to starboard; z is WL, up.')
        call put_words(section, 'Fitted curves and surfaces are within '// &
            shortest(drawing%tolerance)//' of the exact shape.')
        call put_lines(section, levels)
    end subroutine put_start

    !> Puts lines of plain words.
    subroutine put_lines(section, lines)
        type(section_type), intent(inout) :: section    !! S
        character(*), intent(in) :: lines               !! each with its end
        integer :: first, last

        first = 1
        do while (first <= len(lines))
            last = first - 1 + index(lines(first:), new_line('a'))
            call put_words(section, lines(first:last - 1))
            first = last + 1
        end do
    end subroutine put_lines

    !> Puts plain words, on more cards where one has no room for them; none where there are none.
    subroutine put_words(section, words)
        type(section_type), intent(inout) :: section    !! S
        character(*), intent(in) :: words               !! any bytes
        character(:), allocatable :: letters
        integer :: first

        letters = plain(words)
        do first = 1, len_trim(letters), start_columns
            call section%put_card(letters(first:min(len(letters), first + start_columns - 1)))
        end do
    end subroutine put_words

    !> Puts the facts that readers need.
    subroutine put_global(section, drawing, unit, largest, resolution)
        type(section_type), intent(inout) :: section    !! G
        type(drawing_type), intent(in) :: drawing       !! deck, title
        type(unit_type), intent(in) :: unit             !! of all lengths
        real(dp), intent(in) :: largest                 !! magnitude of a coordinate
        real(dp), intent(in) :: resolution              !! `resolution_of`
        type(record_type) :: record

        call record%text(',')
        call record%text(';')
        call record%text(product_of(drawing))
        call record%text(drawing%deck)
        call record%text('LOFT '//version)
        call record%text('LOFT '//version)
        call record%whole(integer_bits)
        call record%whole(power)
        call record%whole(figures)
        call record%whole(power)
        call record%whole(figures)
        call record%text(product_of(drawing))
        call record%reals([1.0_dp])
        call record%whole(unit_flags(findloc(unit_names, unit%name, dim=1)))
        call record%text(trim(unit%short))
        call record%whole(1)
        call record%reals([unit%inch/line_widths])
        call record%text(no_date)
        call record%reals([resolution, largest])
        call record%default()
        call record%default()
        call record%whole(version_flag)
        call record%whole(no_standard)
        call record%text(no_date)
        call record%default()
        call section%put_free(record%content())
    end subroutine put_global

    !> What the file shows: the title of the deck, or its name.
    pure function product_of(drawing) result(name)
        type(drawing_type), intent(in) :: drawing   !! deck, title
        character(:), allocatable :: name
        name = trim(drawing%title)
        if (name == '') name = drawing%deck
    end function product_of

    !> The smallest length that means anything: a millionth of an inch, or the tolerance where that
    !> is less.
    pure real(dp) function resolution_of(unit, tolerance)
        type(unit_type), intent(in) :: unit     !! of the file
        real(dp), intent(in) :: tolerance       !! in the file's unit; 0: none
        resolution_of = unit%inch/resolutions
        if (tolerance > 0.0_dp) resolution_of = min(resolution_of, tolerance)
    end function resolution_of

end module export_iges_head
