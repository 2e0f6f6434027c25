!> The conic card of 1970: three points, two slopes, two increments (SAE 700202, appendix A).
!>
!>     1       9       17      25      33      41      49      57      65    71    77
!>     X1      Y1      S1      X2      Y2      X3      Y3      S3      XI    YI    ITYP
!>     -30.    -10.    .114    0.      -7.1    50.     -4.     .0523   5.
!>
!> A card is read whole: every fault of it is reported, not only the first.
module deck_conic_card
    use base_decimal, only: decimal_type, to_real
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type, new_fault, severity
    use base_kinds, only: dp, i64
    use base_text, only: compact, to_text
    use deck_layout, only: card_columns, conic, conic_fields, field_layout_type
    use deck_number, only: number_type, read_number
    use deck_source, only: line_type
    implicit none (type, external)
    private

    public :: conic_card_type, read_conic_card, ends_deck

    !> An X1 from here on ends a 1970 deck.
    real(dp), parameter :: end_of_deck = 999.99_dp

    !> One conic, as punched.
    type :: conic_card_type
        character(:), allocatable :: label      !! the comment right before the card, or nothing
        character(card_columns) :: image = ''   !! the 80 columns
        integer(i64) :: line = 0                !! line of the file
        integer(i64) :: count = 0               !! which data card of the deck, from 1
        type(decimal_type) :: value(10)         !! X1 Y1 S1 X2 Y2 X3 Y3 S3 XI YI, exact
        integer :: ityp = 0                     !! not zero: a Y table is wanted
        logical :: is_readable = .false.        !! every field was a number
        logical :: is_whole = .false.           !! nothing stands beyond column 80
        logical :: is_sound = .false.           !! no error was found on the card
    contains
        procedure :: real => real_field
        procedure :: wants_x_table
        procedure :: wants_y_table
        procedure :: steps_well
        procedure :: has_coinciding_points
    end type conic_card_type

contains

    !> Reads a conic card. Every fault of it is added to the list.
    subroutine read_conic_card(line, card, faults)
        type(line_type), intent(in) :: line             !! the line of the deck, not empty
        type(conic_card_type), intent(inout) :: card    !! label and count stay, all else is set
        type(fault_list_type), intent(inout) :: faults  !! what is wrong with it is added
        type(number_type) :: number
        integer :: i, before, tab

        before = faults%count
        card%image = line%text
        card%line = line%number
        tab = 0
        if (line%has_control) tab = index(line%text, achar(9))
        call check_columns(line, tab, faults)
        card%is_readable = tab == 0
        card%is_whole = line%filled <= card_columns
        if (card%is_readable) then
            do i = 1, size(card%value)
                call read_field(conic_fields(i), card, number, faults)
                card%value(i) = number%value
            end do
            call read_field(conic_fields(conic%ityp), card, number, faults)
            card%ityp = int(number%value%digits)
        end if
        if (card%is_readable) call check_points(card, faults)
        call faults%place(before, line%number, line%text)
        card%is_sound = .not. faults%has_errors(before)
    end subroutine read_conic_card

    !> Reads one field of a card; a fault makes the card unreadable.
    subroutine read_field(field, card, number, faults)
        type(field_layout_type), intent(in) :: field    !! the field
        type(conic_card_type), intent(inout) :: card    !! the card
        type(number_type), intent(out) :: number        !! what was read
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer(i64) :: first, last

        first = int(field%first, i64)
        last = int(field%last, i64)
        number = read_number(card%image(first:last), merge(-1, field%decimals, field%form == 'I'))
        call field_faults(field, number, faults)
        card%is_readable = card%is_readable .and. number%first == 0
    end subroutine read_field

    !> True for the card that ends a 1970 deck: X1 is a number of 999.99 or more.
    pure logical function ends_deck(line)
        type(line_type), intent(in) :: line !! the line of the deck
        type(number_type) :: number
        character(card_columns) :: image
        integer(i64) :: first, last

        associate (field => conic_fields(conic%x1))
            image = line%text
            first = int(field%first, i64)
            last = int(field%last, i64)
            number = read_number(image(first:last), field%decimals)
            ends_deck = number%first == 0 .and. to_real(number%value) >= end_of_deck
        end associate
    end function ends_deck

    !> A field of the card as a double: the nearest to what was punched.
    elemental real(dp) function real_field(card, field)
        class(conic_card_type), intent(in) :: card !! the card
        integer, intent(in) :: field               !! one of `conic%x1` to `conic%yi`
        real_field = to_real(card%value(field))
    end function real_field

    !> True where a table by steps of X is asked for: XI is not zero, or it is and nothing else is
    !> asked for, which is then a fault.
    elemental logical function wants_x_table(card)
        class(conic_card_type), intent(in) :: card !! the card
        wants_x_table = card%value(conic%xi)%digits /= 0 .or. card%ityp == 0
    end function wants_x_table

    !> True where a table by steps of Y is asked for.
    elemental logical function wants_y_table(card)
        class(conic_card_type), intent(in) :: card !! the card
        wants_y_table = card%ityp /= 0
    end function wants_y_table

    !> True where an increment can step from point 1 to point 3: it is not zero and has the sign of
    !> the way. Where both points have the same ordinate, either sign will do.
    elemental logical function steps_well(card, step)
        class(conic_card_type), intent(in) :: card !! a readable card
        integer, intent(in) :: step                !! `conic%xi` or `conic%yi`
        integer :: from, to
        from = merge(conic%x1, conic%y1, step == conic%xi)
        to = merge(conic%x3, conic%y3, step == conic%xi)
        steps_well = card%value(step)%digits /= 0 .and. &
            (card%real(to) - card%real(from))*card%real(step) >= 0.0_dp
    end function steps_well

    !> True where two of the three points are one, as punched.
    elemental logical function has_coinciding_points(card)
        class(conic_card_type), intent(in) :: card !! a readable card
        has_coinciding_points = are_one(card, conic%x1, conic%x2) .or. &
            are_one(card, conic%x1, conic%x3) .or. are_one(card, conic%x2, conic%x3)
    end function has_coinciding_points

    !> True where two points of a card are one.
    elemental logical function are_one(card, a, b)
        class(conic_card_type), intent(in) :: card !! a readable card
        integer, intent(in) :: a                   !! field of the first point's X
        integer, intent(in) :: b                   !! field of the second point's X
        are_one = is_equal(card%real(a), card%real(b)) .and. &
            is_equal(card%real(a + 1), card%real(b + 1))
    end function are_one

    !> Faults of the card as a row of columns: tabs, more than 80 columns.
    subroutine check_columns(line, tab, faults)
        type(line_type), intent(in) :: line             !! the line of the deck
        integer, intent(in) :: tab                      !! where its first tab stands; 0: nowhere
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (tab > 0) call faults%add(new_fault(severity%error, tab, tab, &
            'a tab on a card; fields go by columns, so put blanks in its place'))
        if (line%filled <= card_columns) return
        call faults%add(new_fault(severity%error, card_columns + 1, line%filled, &
            'text beyond column '//to_text(card_columns)//'; XI stands in columns 65-70, YI in '// &
            '71-76, ITYP in 77-78, and 79-80 are free'))
    end subroutine check_columns

    !> Faults of one field, and remarks where it is read as 1970 read it and not as it looks.
    subroutine field_faults(field, number, faults)
        type(field_layout_type), intent(in) :: field    !! the field
        type(number_type), intent(in) :: number         !! what was read in it
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: reason

        if (number%first > 0) then
            call faults%add(new_fault(severity%error, field%first + number%first - 1, &
                field%first + number%last - 1, trim(field%name)//': '//number%trouble))
            return
        end if
        if (field%form == 'I' .or. number%value%digits == 0) return
        if (number%has_point .and. .not. number%has_filled_blank) return
        reason = ''
        if (.not. number%has_point) then
            reason = 'no point was punched, so the last '//to_text(field%decimals)// &
                ' columns are decimals'
        end if
        if (number%has_filled_blank) then
            if (reason /= '') reason = reason//' and '
            reason = reason//'a blank after a figure is a zero'
        end if
        call faults%add(new_fault(severity%remark, field%first, field%last, &
            trim(field%name)//' is read as '//compact(to_real(number%value))//': '//reason))
    end subroutine field_faults

    !> Faults of the points and increments against each other.
    subroutine check_points(card, faults)
        type(conic_card_type), intent(in) :: card       !! a readable card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        call check_pair(card, conic%x1, conic%x2, '1 and 2', faults)
        call check_pair(card, conic%x1, conic%x3, '1 and 3', faults)
        call check_pair(card, conic%x2, conic%x3, '2 and 3', faults)
        if (card%wants_x_table()) call check_increment(card, conic%xi, conic%x1, conic%x3, faults)
        if (card%wants_y_table()) call check_increment(card, conic%yi, conic%y1, conic%y3, faults)
    end subroutine check_points

    !> Two of the three points must not be one.
    subroutine check_pair(card, a, b, names, faults)
        type(conic_card_type), intent(in) :: card       !! a readable card
        integer, intent(in) :: a                        !! field of the first point's X
        integer, intent(in) :: b                        !! field of the second point's X
        character(*), intent(in) :: names               !! the points in words
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (.not. are_one(card, a, b)) return
        call faults%add(new_fault(severity%error, conic_fields(b)%first, conic_fields(b + 1)%last, &
            'points '//names//' coincide; three different points fix a conic'))
    end subroutine check_pair

    !> An increment must be able to step from point 1 to point 3.
    subroutine check_increment(card, step, from, to, faults)
        type(conic_card_type), intent(in) :: card       !! a readable card
        integer, intent(in) :: step                     !! field of the increment
        integer, intent(in) :: from                     !! field of the ordinate of point 1
        integer, intent(in) :: to                       !! field of the ordinate of point 3
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: name, trouble
        real(dp) :: way

        if (card%steps_well(step)) return
        way = card%real(to) - card%real(from)
        name = trim(conic_fields(step)%name)
        associate (field => conic_fields(step))
            if (card%value(step)%digits == 0) then
                trouble = name//' is zero where a table is asked for; punch an increment'
                if (step == conic%xi) trouble = trouble//', or ITYP and YI for a Y table alone'
            else
                trouble = name//' has the wrong sign; from '//compact(card%real(from))//' to '// &
                    compact(card%real(to))//' it is '//merge('positive', 'negative', way > 0.0_dp)
            end if
            call faults%add(new_fault(severity%error, field%first, field%last, trouble))
        end associate
    end subroutine check_increment

end module deck_conic_card
