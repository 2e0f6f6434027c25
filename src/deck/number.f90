!> A number in the columns of a field, read as the FORTRAN of 1970 read it under F and I formats:
!> a punched point wins over the implied one, a blank after the first figure is a zero, a blank
!> field is zero, an exponent may follow as `E`, `D` or a bare sign.
module deck_number
    use base_decimal, only: decimal_type, largest_power
    use base_kinds, only: i64
    use base_text, only: to_text, upper
    use deck_plain_number, only: most_figures, read_plain
    implicit none (type, external)
    private

    public :: number_type, read_number

    !> What a field was read as.
    type :: number_type
        type(decimal_type) :: value             !! the number, exact
        logical :: is_blank = .false.           !! nothing was punched
        logical :: has_point = .false.          !! a point was punched
        logical :: has_filled_blank = .false.   !! a blank that counts as a zero changes the number
        logical :: has_exponent = .false.       !! an exponent was punched
        integer :: first = 0                    !! first character at fault; 0: the field is sound
        integer :: last = 0                     !! last character at fault
        character(:), allocatable :: trouble    !! what is wrong with it
    end type number_type

    !> Capital letters.
    character(*), parameter :: letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ'
    !> Exponents are gathered no further than this.
    integer, parameter :: exponent_bound = 100000

    !> Where the reader is in a number.
    type :: stage_list
        integer :: before = 1   !! only blanks so far
        integer :: signed = 2   !! a sign, no figure yet
        integer :: figures = 3  !! in the figures
        integer :: power = 4    !! in the exponent
    end type stage_list
    type(stage_list), parameter :: stage = stage_list()

    !> A number half read.
    type :: state_type
        logical :: is_whole = .false.   !! a whole number is asked for
        integer :: at = 1               !! one of `stage%...`
        integer :: figures = 0          !! figures met, leading zeros not counted
        integer :: met = 0              !! figures punched, leading zeros counted
        integer :: decimals = 0         !! figures behind a punched point
        integer :: sign = 1             !! of the number
        integer :: exponent = 0         !! size of the exponent
        integer :: exponent_sign = 1    !! of the exponent
        logical :: is_signed = .false.  !! the exponent has its sign
        integer :: exponent_met = 0     !! figures punched in the exponent
        integer :: blanks = 0           !! blanks since the last other character that count as zeros
    end type state_type

contains

    !> Reads a field. Where it is no number, `first`, `last` and `trouble` say why, and the value is
    !> zero. `implied` is the number of decimals without a punched point (F8.3: 3); a negative one
    !> asks for a whole number (I format), where a point or an exponent is a fault.
    pure function read_number(field, implied) result(number)
        character(*), intent(in) :: field !! the columns of the field
        integer, intent(in) :: implied    !! implied decimals, or -1 for a whole number
        type(number_type) :: number
        type(state_type) :: state
        integer :: i, first, last
        logical :: is_plain

        last = len_trim(field)
        number%is_blank = last == 0
        if (number%is_blank) return
        state%is_whole = implied < 0
        call read_plain(field, state%is_whole, number%value, is_plain)
        number%has_point = is_plain .and. .not. state%is_whole
        if (is_plain) return
        first = verify(field, ' ')
        do i = 1, len(field)
            call take(number, state, field, i)
            if (number%first > 0) return
        end do
        if (state%met == 0) then
            call blame(number, first, last, 'there is no figure in the number')
        else if (state%at == stage%power .and. state%exponent_met == 0) then
            call blame(number, last, last, 'the exponent has no figures')
        else
            call settle(number, state, max(implied, 0), [first, last])
        end if
    end function read_number

    !> Takes one character of a number.
    pure subroutine take(number, state, field, i)
        type(number_type), intent(inout) :: number !! the number so far
        type(state_type), intent(inout) :: state   !! where its reading stands
        character(*), intent(in) :: field          !! the columns of the field
        integer, intent(in) :: i                   !! the character's place in it
        character :: letter

        letter = field(i:i)
        select case (letter)
        case (' ')
            call take_blank(number, state, i)
        case ('0':'9')
            if (state%blanks > 0) number%has_filled_blank = .true.
            call take_digit(number, state, iachar(letter) - iachar('0'), i)
            if (state%at == stage%power) then
                state%exponent_met = state%exponent_met + 1
            else
                state%at = stage%figures
                state%met = state%met + 1
            end if
        case ('.')
            call take_point(number, state, i)
        case ('+', '-')
            call take_sign(number, state, merge(-1, 1, letter == '-'), i)
        case ('E', 'D', 'e', 'd')
            call take_power(number, state, i)
        case default
            call blame_stranger(number, i, upper(field))
        end select
    end subroutine take

    !> Takes a blank: a zero once the figures or the exponent have begun. It is counted where the
    !> zero may change the number.
    pure subroutine take_blank(number, state, i)
        type(number_type), intent(inout) :: number !! the number so far
        type(state_type), intent(inout) :: state   !! where its reading stands
        integer, intent(in) :: i                   !! its place in the field

        select case (state%at)
        case (stage%figures)
            if (state%figures > 0 .or. number%has_point) state%blanks = state%blanks + 1
            call take_digit(number, state, 0, i)
        case (stage%power)
            if (state%exponent > 0) state%blanks = state%blanks + 1
            call take_digit(number, state, 0, i)
        end select
    end subroutine take_blank

    !> Takes a digit, punched or a blank that counts as zero, into the figures or the exponent.
    pure subroutine take_digit(number, state, digit, i)
        type(number_type), intent(inout) :: number !! the number so far
        type(state_type), intent(inout) :: state   !! where its reading stands
        integer, intent(in) :: digit               !! 0 to 9
        integer, intent(in) :: i                   !! its place in the field

        if (state%at == stage%power) then
            state%exponent = min(10*state%exponent + digit, exponent_bound)
            return
        end if
        if (state%figures > 0 .or. digit > 0) state%figures = state%figures + 1
        if (state%figures > most_figures) then
            call blame(number, i, i, 'the number has more than '//to_text(most_figures)//' figures')
            return
        end if
        number%value%digits = 10*number%value%digits + int(digit, i64)
        if (number%has_point) state%decimals = state%decimals + 1
    end subroutine take_digit

    !> Takes the decimal point.
    pure subroutine take_point(number, state, i)
        type(number_type), intent(inout) :: number !! the number so far
        type(state_type), intent(inout) :: state   !! where its reading stands
        integer, intent(in) :: i                   !! its place in the field

        if (state%is_whole) then
            call blame(number, i, i, 'a point in a whole number')
        else if (state%at == stage%power) then
            call blame(number, i, i, 'a point in the exponent')
        else if (number%has_point .and. state%blanks > 0) then
            call blame(number, i, i, 'a second number in the field; each stands in columns of '// &
                'its own')
        else if (number%has_point) then
            call blame(number, i, i, 'a second point in the number')
        else
            if (state%blanks > 0) number%has_filled_blank = .true.
            state%blanks = 0
            number%has_point = .true.
            state%at = stage%figures
        end if
    end subroutine take_point

    !> Takes a sign: of the number, of the exponent, or a bare one that begins the exponent.
    pure subroutine take_sign(number, state, sign, i)
        type(number_type), intent(inout) :: number !! the number so far
        type(state_type), intent(inout) :: state   !! where its reading stands
        integer, intent(in) :: sign                !! 1 or -1
        integer, intent(in) :: i                   !! its place in the field

        if (state%at == stage%before) then
            state%sign = sign
            state%at = stage%signed
            return
        end if
        if (state%at == stage%figures .and. state%met > 0 .and. .not. state%is_whole) then
            call take_power(number, state, i)
        else if (state%at /= stage%power .or. state%exponent_met > 0 .or. state%is_signed) then
            call blame(number, i, i, 'a sign inside the number')
        end if
        state%exponent_sign = sign
        state%is_signed = .true.
    end subroutine take_sign

    !> Takes the letter, or the bare sign, that begins the exponent.
    pure subroutine take_power(number, state, i)
        type(number_type), intent(inout) :: number !! the number so far
        type(state_type), intent(inout) :: state   !! where its reading stands
        integer, intent(in) :: i                   !! its place in the field

        if (state%is_whole) then
            call blame(number, i, i, 'an exponent in a whole number')
        else if (state%at == stage%power) then
            call blame(number, i, i, 'a second exponent letter in the number')
        else if (state%met == 0) then
            call blame(number, i, i, 'the exponent letter stands where no figure is before it')
        else
            if (state%blanks > 0 .and. .not. number%has_point) number%has_filled_blank = .true.
            state%blanks = 0
            number%has_exponent = .true.
            state%at = stage%power
        end if
    end subroutine take_power

    !> Puts sign, point and exponent together.
    pure subroutine settle(number, state, implied, range)
        type(number_type), intent(inout) :: number !! the figures taken
        type(state_type), intent(in) :: state      !! all that was read
        integer, intent(in) :: implied             !! decimals without a punched point
        integer, intent(in) :: range(2)            !! first and last character punched

        number%value%digits = int(state%sign, i64)*number%value%digits
        number%value%power = state%exponent_sign*state%exponent &
            - merge(state%decimals, implied, number%has_point)
        number%has_filled_blank = number%has_filled_blank .or. &
            (state%blanks > 0 .and. (.not. number%has_point .or. number%has_exponent))
        if (number%value%digits == 0) number%value%power = 0
        if (abs(number%value%power) <= largest_power) return
        if (number%has_exponent .and. state%blanks > 0) then
            call blame(number, range(1), range(2), &
                'the number is out of range; a blank behind its exponent is a zero')
        else
            call blame(number, range(1), range(2), 'the number is out of range')
        end if
    end subroutine settle

    !> Notes what is wrong and takes the value back.
    pure subroutine blame(number, first, last, trouble)
        type(number_type), intent(inout) :: number !! the number at fault
        integer, intent(in) :: first               !! first character at fault
        integer, intent(in) :: last                !! last character at fault
        character(*), intent(in) :: trouble        !! what is wrong
        number%value = decimal_type()
        number%first = first
        number%last = last
        number%trouble = trouble
    end subroutine blame

    !> Notes a character that no number has, with the likely slip.
    pure subroutine blame_stranger(number, i, field)
        type(number_type), intent(inout) :: number !! the number at fault
        integer, intent(in) :: i                   !! the character's place in the field
        character(*), intent(in) :: field          !! the columns of the field, in capitals
        character(*), parameter :: read_are = ' in a number; figures, a sign, a point and an '// &
            'exponent are read'
        character(:), allocatable :: words
        character(2) :: code
        integer :: last

        last = max(i, i - 2 + verify(field(i:)//' ', letters))
        select case (field(i:i))
        case (',')
            words = 'a comma in a number; the point is a full stop and fields go by columns'
        case ('/')
            words = 'a fraction in a number; it is written with decimals, 1/2 as .5'
        case ('A':'Z')
            words = ''''//field(i:last)//''''//read_are
            if (field(i:last) == 'O') words = 'the letter O in a number; the figure is 0'
            if (field(i:last) == 'I' .or. field(i:last) == 'L') &
                words = 'the letter '//field(i:i)//' in a number; the figure is 1'
        case ('!':'+', ':':'@', '[':'~')
            words = ''''//field(i:i)//''''//read_are
        case default
            write (code, '(z2.2)') ichar(field(i:i))
            words = 'byte '//code//' (hexadecimal) in a number; only plain ASCII figures, signs'// &
                ' and points are read'
        end select
        call blame(number, i, last, words)
    end subroutine blame_stranger

end module deck_number
