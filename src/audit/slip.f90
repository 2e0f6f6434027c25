!> How a true figure became the one that is read: the slips that a clerk, a typist, a printer or a
!> scan makes, each with how often it happens and in how many ways.
!>
!> What is given is the likelihood that the true figure is read as this one by this slip: the share
!> of the slip among all, over the ways in which it could have happened to the true figure. The
!> shares are those of the slips that writers on copying name, and no more than a fair guess; they
!> decide between explanations, not whether a figure is bad.
!>
!> Source: the digits taken for each other are those of optical and of clerical reading alike:
!> SAE 700202 as scanned shows 3/8, 6/8, 0/6, 0/9, 2/7, 4/9 and 5/6; 1/7 is of handwriting.
module audit_slip
    use audit_figure, only: bare, figure_length, form, is_printed_so, print_figure, scale_type
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: slip_likelihood, slip_name, chance_likelihood

    !> Kinds of slip.
    type, public :: slip_list
        integer :: none = 0     !! no slip explains it
        integer :: digit = 1    !! one character taken for another
        integer :: extra = 2    !! one character too many
        integer :: missing = 3  !! one character missing
        integer :: swapped = 4  !! two neighbours in wrong order
        integer :: sign = 5     !! the sign lost or put
        integer :: point = 6    !! the point moved
        integer :: row = 7      !! the figure of the row before or after
        integer :: inch = 8     !! an inch more or less
        integer :: eighth = 9   !! an eighth of an inch more or less
        integer :: digits = 10  !! two characters taken for others
        integer :: both = 11    !! one character taken for another, and one too many or missing
        integer :: foot = 12    !! a foot more or less
        integer :: unread = 13  !! characters that can't be read
    end type slip_list
    !> The kinds by name: `slip%digit`.
    type(slip_list), parameter, public :: slip = slip_list()

    !> How often each slip happens, of all bad figures.
    real(dp), parameter :: share(12) = [0.43_dp, 0.10_dp, 0.10_dp, 0.08_dp, 0.05_dp, 0.04_dp, &
        0.05_dp, 0.03_dp, 0.02_dp, 0.05_dp, 0.04_dp, 0.01_dp]
    !> How often a figure is bad beyond all recognition.
    real(dp), parameter :: share_of_chance = 0.05_dp
    !> Digits that each digit, from 0 on, is taken for more easily than for others.
    character(4), parameter :: look_alike(0:9) = ['689 ', '74  ', '73  ', '852 ', '91  ', '638 ', &
        '5082', '124 ', '3069', '408 ']
    !> How often it is one of those, and how often any character at all instead of a digit.
    real(dp), parameter :: like = 0.7_dp, unlike = 0.25_dp, no_digit = 0.05_dp

contains

    !> The likelihood that a true figure is read as another, and by which slip. `slip%none` with 0
    !> where none leads from one to the other.
    pure subroutine slip_likelihood(text, units, beside, scale, likelihood, kind)
        character(*), intent(in) :: text      !! as read
        integer(i64), intent(in) :: units     !! the true figure, in units of the last place
        integer(i64), intent(in) :: beside(:) !! the true figures of the rows before and after
        type(scale_type), intent(in) :: scale !! of the table
        real(dp), intent(out) :: likelihood   !! 0 to 1
        integer, intent(out) :: kind          !! one of `slip%...`
        character(figure_length) :: read, true
        real(dp) :: all(size(share))

        read = bare(text)
        true = bare(print_figure(units, scale))
        all = 0.0_dp
        if (index(read, '?') > 0) then
            kind = slip%none
            likelihood = 0.0_dp
            if (is_printed_so(read, true)) kind = slip%unread
            if (is_printed_so(read, true)) likelihood = 1.0_dp
            return
        end if
        call weigh_characters(read, true, all)
        call weigh_lengths(read, true, all)
        call weigh_amounts(read, units, beside, scale, all)
        all = all*share
        kind = maxloc(all, dim=1)
        likelihood = sum(all)
        if (.not. likelihood > 0.0_dp) kind = slip%none
    end subroutine slip_likelihood

    !> Slips that keep the length: a character or two, neighbours swapped.
    pure subroutine weigh_characters(read, true, all)
        character(*), intent(in) :: read       !! as read
        character(*), intent(in) :: true       !! as it should be
        real(dp), intent(inout) :: all(:)      !! likelihood of each slip, if it is made
        integer :: place(3), n, i, long

        long = len_trim(true)
        if (read(1:1) == '-' .neqv. true(1:1) == '-') then
            if (read(1:1) == '-' .and. read(2:) == true) all(slip%sign) = 1.0_dp
            if (true(1:1) == '-' .and. true(2:) == read) all(slip%sign) = 1.0_dp
            return
        end if
        if (len_trim(read) /= long) return
        n = 0
        place = 0
        do i = 1, long
            if (read(i:i) == true(i:i)) cycle
            n = n + 1
            if (n > 2) return
            place(n) = i
        end do
        if (n == 1) all(slip%digit) = taken_for(true(place(1):place(1)), &
            read(place(1):place(1)))/real(digits_of(true), dp)
        if (n /= 2) return
        all(slip%digits) = taken_for(true(place(1):place(1)), read(place(1):place(1)))* &
            taken_for(true(place(2):place(2)), read(place(2):place(2)))*2.0_dp/ &
            real(max(digits_of(true)*(digits_of(true) - 1), 1), dp)
        if (read(place(1):place(1)) == true(place(2):place(2)) .and. &
            read(place(2):place(2)) == true(place(1):place(1)) .and. &
            scan(read(place(1):place(1))//read(place(2):place(2)), '.-') == 0) then
            if (place(2) == place(1) + 1 .or. read(place(1) + 1:place(1) + 1) == '.') &
                all(slip%swapped) = 1.0_dp/real(digits_of(true), dp)
        end if
    end subroutine weigh_characters

    !> How often a character is taken for another.
    elemental real(dp) function taken_for(true, read) result(often)
        character, intent(in) :: true !! as it should be
        character, intent(in) :: read !! as read
        integer :: which
        often = 0.0_dp
        if (scan(true, '0123456789') == 0) return
        if (scan(read, '0123456789') == 0) then
            if (scan(read, '.-') == 0) often = no_digit
            return
        end if
        which = iachar(true) - iachar('0')
        often = unlike/9.0_dp
        if (index(trim(look_alike(which)), read) > 0) &
            often = often + like/real(len_trim(look_alike(which)), dp)
    end function taken_for

    !> The digits of a text.
    pure integer function digits_of(text) result(digits)
        character(*), intent(in) :: text !! any text
        integer :: i
        digits = 0
        do i = 1, len_trim(text)
            if (scan(text(i:i), '0123456789') > 0) digits = digits + 1
        end do
    end function digits_of

    !> Slips that change the length, and a point that moved.
    pure subroutine weigh_lengths(read, true, all)
        character(*), intent(in) :: read       !! as read
        character(*), intent(in) :: true       !! as it should be
        real(dp), intent(inout) :: all(:)      !! likelihood of each slip, if it is made
        real(dp) :: often
        integer :: digits

        digits = digits_of(true)
        select case (len_trim(read) - len_trim(true))
        case (1)
            often = best_without_one(read, true)
            if (often >= 1.0_dp) all(slip%extra) = 0.1_dp/real(digits + 1, dp)
            all(slip%both) = max(all(slip%both), 0.1_dp*often/real(digits*(digits + 1), dp))
        case (-1)
            often = best_without_one(true, read)
            if (often >= 1.0_dp) all(slip%missing) = 1.0_dp/real(digits + 1, dp)
            all(slip%both) = max(all(slip%both), 1.0_dp*often/real(digits*(digits + 1), dp))
        end select
        if (all(slip%extra) + all(slip%missing) > 0.0_dp) return
        if (index(true, '.') == 0) return
        if (without_point(read) == without_point(true)) &
            all(slip%point) = 1.0_dp/real(digits, dp)
    end subroutine weigh_lengths

    !> How alike two texts are when one character of the longer is left out: 1 the same, less where
    !> one other is taken for another, 0 where more are.
    pure real(dp) function best_without_one(longer, shorter) result(best)
        character(*), intent(in) :: longer  !! one character longer
        character(*), intent(in) :: shorter !! the other
        character(figure_length) :: left
        integer :: out, i, n, at

        best = 0.0_dp
        do out = 1, len_trim(longer)
            left = longer(:out - 1)//longer(out + 1:)
            n = 0
            at = 1
            do i = 1, len_trim(left)
                if (left(i:i) == shorter(i:i)) cycle
                n = n + 1
                at = i
            end do
            if (n == 0) best = 1.0_dp
            if (n == 1) best = max(best, taken_for(shorter(at:at), left(at:at)))
            if (n == 0) return
        end do
    end function best_without_one

    !> The digits and the sign of a text, zeros in front left out.
    pure function without_point(text) result(short)
        character(*), intent(in) :: text !! with one point or none
        character(figure_length) :: short
        integer :: at
        short = text
        at = index(text, '.')
        if (at > 0) short = text(:at - 1)//text(at + 1:)
        short = bare(short)
    end function without_point

    !> Slips of an amount: another row's figure, an inch, a foot, an eighth.
    pure subroutine weigh_amounts(read, units, beside, scale, all)
        character(*), intent(in) :: read      !! as read
        integer(i64), intent(in) :: units     !! the true figure
        integer(i64), intent(in) :: beside(:) !! the true figures of the rows before and after
        type(scale_type), intent(in) :: scale !! of the table
        real(dp), intent(inout) :: all(:)     !! likelihood of each slip, if it is made
        integer(i64) :: inch, step
        integer :: i

        do i = 1, size(beside)
            if (beside(i) == units) cycle
            if (bare(print_figure(beside(i), scale)) == read) all(slip%row) = 0.5_dp
        end do
        inch = 8
        if (scale%form == form%decimal) inch = 10_i64**int(scale%decimals, i64)
        do step = -1, 1, 2
            if (bare(print_figure(units + step*inch, scale)) == read) all(slip%inch) = 0.4_dp
            if (bare(print_figure(units + step*12*inch, scale)) == read) all(slip%foot) = 0.3_dp
            if (modulo(inch, 8_i64) /= 0) cycle
            if (bare(print_figure(units + step*(inch/8), scale)) == read) all(slip%eighth) = 0.5_dp
        end do
    end subroutine weigh_amounts

    !> The likelihood that a figure bad beyond recognition is read as just this text.
    pure real(dp) function chance_likelihood(text) result(likelihood)
        character(*), intent(in) :: text !! as read
        likelihood = share_of_chance*10.0_dp**(-digits_of(bare(text)))
    end function chance_likelihood

    !> A slip in words.
    pure function slip_name(kind) result(name)
        integer, intent(in) :: kind !! one of `slip%...`
        character(34), parameter :: names(0:13) = [character(34) :: 'no explanation', &
            'one digit taken for another', 'one digit too many', 'one digit missing', &
            'two digits in wrong order', 'the sign', 'the point moved', &
            'the figure of another row', &
            'a slip of an inch', 'a slip of an eighth', 'two digits taken for others', &
            'a wrong digit and one more or less', 'a slip of a foot', &
            'characters that can''t be read']
        character(len_trim(names(kind), i64)) :: name
        name = names(kind)
    end function slip_name

end module audit_slip
