!> Printed tables of random conics, damaged at random, for proofs of the audit.
!>
!> The truth is worked in four times the precision from the equation of R. A. Liming, "Practical
!> Analytic Geometry with Applications to Aircraft", 1944, ch. 4, and not by LOFT: the product of
!> the end tangents against the square of the chord, their ratio given by the shoulder point.
module support_audited
    use, intrinsic :: iso_fortran_env, only: real128
    use audit_figure, only: bare, figure_length, form, print_figure, scale_type
    use audit_printing, only: printing
    use audit_reading, only: add, line_type, meaning, new_reading, sort
    use base_kinds, only: dp, i64
    use support_random, only: random_type
    implicit none (type, external)
    private

    public :: truth_type, plan_type, random_truth, print_truth, damage, ordinate_of

    integer, parameter :: qp = real128

    !> A card: three points and two slopes, in whole thousandths and ten thousandths.
    type :: truth_type
        real(dp) :: x(3) = 0.0_dp       !! first, shoulder, last point
        real(dp) :: y(3) = 0.0_dp       !! their ordinates
        real(dp) :: slope(2) = 0.0_dp   !! first and last
    end type truth_type

    !> How a table is made.
    type :: plan_type
        integer :: rows = 15            !! of each conic
        integer :: known = 0            !! 0 nothing, 1 ends, 2 ends and slopes, 3 all but S3 whole
        integer :: printing = 1         !! one of `printing%...`
        type(scale_type) :: scale       !! places of its figures
    end type plan_type

    !> What a damage is: `kind` as `audit_slip` counts them.
    type, public :: damage_type
        integer :: kind = 0                      !! one of `slip%...`, 0: none
        character(figure_length) :: true = ''    !! the figure before
        integer(i64) :: units = 0                !! the same in units of the last place
    end type damage_type

contains

    !> A random card that goes on from a point with a slope.
    function random_truth(random, x, y, slope) result(truth)
        type(random_type), intent(inout) :: random !! where the numbers come from
        real(dp), intent(in) :: x                  !! first abscissa
        real(dp), intent(in) :: y                  !! first ordinate
        real(dp), intent(in) :: slope              !! first slope
        type(truth_type) :: truth
        real(dp) :: length, corner(2), rho, turn

        length = anint(random%between(40.0_dp, 200.0_dp))
        truth%x = [x, 0.0_dp, x + length]
        truth%slope(1) = slope
        corner(1) = random%between(0.3_dp, 0.7_dp)*length
        corner(2) = slope*corner(1)
        turn = random%sign()*random%between(0.05_dp, 0.8_dp)
        truth%slope(2) = round_to(slope + turn, 4)
        truth%y(1) = y
        truth%y(3) = round_to(y + corner(2) + truth%slope(2)*(length - corner(1)), 3)
        ! The corner of the rounded numbers.
        corner(1) = (truth%y(3) - y - truth%slope(2)*length)/(slope - truth%slope(2))
        corner(2) = slope*corner(1)
        rho = random%between(0.3_dp, 0.7_dp)
        truth%x(2) = round_to(x + 0.5_dp*length + rho*(corner(1) - 0.5_dp*length), 1)
        truth%y(2) = round_to(y + 0.5_dp*(truth%y(3) - y) + rho*(corner(2) - &
            0.5_dp*(truth%y(3) - y)), 3)
    end function random_truth

    !> A number rounded to decimals.
    pure real(dp) function round_to(x, decimals) result(rounded)
        real(dp), intent(in) :: x       !! any
        integer, intent(in) :: decimals !! how many
        rounded = anint(x*10.0_dp**decimals)/10.0_dp**decimals
    end function round_to

    !> The ordinate of a card's arc: the root nearest to the arc's control triangle.
    pure real(qp) function ordinate_of(truth, at) result(y)
        type(truth_type), intent(in) :: truth !! the card
        real(dp), intent(in) :: at            !! abscissa between its ends
        real(qp) :: p(3), ratio, x, c, t1, t3, a, b, g, root(2), guess

        p = value_forms(truth, real(truth%x(2), qp), real(truth%y(2), qp))
        ratio = p(3)**2/(p(1)*p(2))
        ! chord(x, y)**2 = ratio*t1(x, y)*t3(x, y), each v + y*w at this x.
        x = real(at, qp)
        p = value_forms(truth, x, 0.0_qp)
        c = real(truth%x(3), qp) - real(truth%x(1), qp)
        t1 = p(1)
        t3 = p(2)
        a = c*c - ratio
        b = 2.0_qp*p(3)*c - ratio*(t1 + t3)
        g = p(3)**2 - ratio*t1*t3
        if (abs(a) < 1.0e-25_qp*c*c) then
            y = -g/b
            return
        end if
        root = [-b - sqrt(max(b*b - 4.0_qp*a*g, 0.0_qp)), -b + sqrt(max(b*b - 4.0_qp*a*g, 0.0_qp))]
        root = root/(2.0_qp*a)
        ! The arc is between the chord and the two tangents.
        guess = merge(1.0_qp, -1.0_qp, truth%slope(1) > truth%slope(2))
        y = root(1)
        if (is_within(root(2))) y = root(2)
    contains
        !> True where an ordinate is between the chord and the lower or upper tangents.
        pure logical function is_within(height)
            real(qp), intent(in) :: height !! ordinate
            real(qp), parameter :: noise = 1.0e-20_qp
            is_within = guess*(p(3) + c*height) >= -noise .and. guess*(t1 + height) <= noise .and. &
                guess*(t3 + height) <= noise
        end function is_within
    end function ordinate_of

    !> y less the first tangent, y less the last tangent, the chord's form (c*(y - y1) less rise).
    pure function value_forms(truth, x, y) result(p)
        type(truth_type), intent(in) :: truth !! the card
        real(qp), intent(in) :: x             !! abscissa
        real(qp), intent(in) :: y             !! ordinate
        real(qp) :: p(3), x1, x3, y1, y3
        x1 = real(truth%x(1), qp)
        x3 = real(truth%x(3), qp)
        y1 = real(truth%y(1), qp)
        y3 = real(truth%y(3), qp)
        p(1) = y - y1 - real(truth%slope(1), qp)*(x - x1)
        p(2) = y - y3 - real(truth%slope(2), qp)*(x - x3)
        p(3) = (x3 - x1)*(y - y1) - (y3 - y1)*(x - x1)
    end function value_forms

    !> The table of a chain of cards: rows and what else is known, as a line to be audited.
    subroutine print_truth(truth, plan, line, table)
        type(truth_type), intent(in) :: truth(:)                  !! cards in order
        type(plan_type), intent(in) :: plan                       !! how it is made
        type(line_type), intent(out) :: line                      !! to be audited
        type(damage_type), allocatable, intent(out) :: table(:)   !! its true figures
        real(dp) :: x
        integer :: i, k

        allocate (table(plan%rows*size(truth)))
        line%scale = plan%scale
        line%conics = size(truth)
        do k = 1, size(truth)
            do i = 1, plan%rows
                x = truth(k)%x(1) + (truth(k)%x(3) - truth(k)%x(1))*real(i, dp)/ &
                    real(plan%rows + 1, dp)
                x = round_to(x, 1)
                associate (row => table((k - 1)*plan%rows + i))
                    row%units = printed_as(ordinate_of(truth(k), x), plan)
                    row%true = print_figure(row%units, plan%scale)
                    call add(line, new_reading(sort%ordinate, x, row%true, &
                        form_of=plan%scale%form))
                end associate
            end do
        end do
        call tell(truth(1), plan%known, 1, line)
        call tell(truth(size(truth)), plan%known, 2, line)
        if (plan%known == 3 .and. size(truth) == 1) call add(line, new_reading(sort%ordinate, &
            truth(1)%x(2), print_figure(nint(1000*truth(1)%y(2), i64), thousandths()), &
            meaning%exact))
    end subroutine print_truth

    !> Places of ordinates and slopes that are known.
    pure type(scale_type) function thousandths()
        thousandths = scale_type(form%decimal, 3)
    end function thousandths

    !> Tells a line what is known of one end.
    subroutine tell(truth, known, side, line)
        type(truth_type), intent(in) :: truth  !! the card there
        integer, intent(in) :: known           !! as in `plan_type`
        integer, intent(in) :: side            !! 1 first, 2 last
        type(line_type), intent(inout) :: line !! to be audited
        integer :: at, means

        if (known == 0) return
        at = 2*side - 1
        call add(line, new_reading(sort%ordinate, truth%x(at), &
            print_figure(nint(1000*truth%y(at), i64), thousandths()), meaning%exact))
        if (known == 1) return
        means = merge(meaning%rounded, meaning%exact, known == 3 .and. side == 2)
        if (means == meaning%exact) then
            call add(line, new_reading(sort%slope, truth%x(at), &
                print_figure(nint(10000*truth%slope(side), i64), scale_type(form%decimal, 4)), &
                meaning%exact))
        else
            call add(line, new_reading(sort%slope, truth%x(at), &
                print_figure(nint(1000*truth%slope(side), i64), thousandths()), means))
        end if
    end subroutine tell

    !> A true ordinate in units of the last place, as a plan prints it.
    pure integer(i64) function printed_as(y, plan) result(units)
        real(qp), intent(in) :: y           !! ordinate
        type(plan_type), intent(in) :: plan !! how it is printed
        real(qp) :: size
        size = y
        if (plan%printing == printing%of_1970) size = size + 0.0005_qp
        size = size*merge(8.0_qp, 10.0_qp**plan%scale%decimals, plan%scale%form == form%eighths)
        if (plan%printing == printing%truncated) then
            units = int(aint(size), i64)
        else
            units = nint(size, i64)
        end if
    end function printed_as

    !> Damages a figure at random; `kind` is left 0 where nothing came of it.
    subroutine damage(random, table, row, text)
        type(random_type), intent(inout) :: random          !! where the numbers come from
        type(damage_type), intent(inout) :: table(:)        !! all figures
        integer, intent(in) :: row                          !! which
        character(figure_length), intent(out) :: text       !! as it is read then
        real(dp) :: which
        integer :: at, kind

        text = table(row)%true
        which = random%unit()
        if (which < 0.55_dp) then
            kind = 1
            call confuse(random, text)
        else if (which < 0.62_dp) then
            kind = 2
            at = 1 + int(random%unit()*real(len_trim(text), dp))
            text = text(:at)//digit(int(10.0_dp*random%unit()))//text(at + 1:figure_length - 1)
        else if (which < 0.69_dp) then
            kind = 3
            at = digit_in(random, text)
            text = text(:at - 1)//text(at + 1:)
        else if (which < 0.76_dp) then
            kind = 4
            at = digit_in(random, text)
            if (scan(text(at + 1:at + 1), '0123456789') > 0) &
                text(at:at + 1) = text(at + 1:at + 1)//text(at:at)
        else if (which < 0.80_dp) then
            kind = 5
            if (text(1:1) == '-') then
                text = text(2:)
            else
                text = '-'//text(:figure_length - 1)
            end if
        else if (which < 0.86_dp) then
            kind = 7
            at = min(max(row + nint(random%sign()), 1), size(table))
            text = table(at)%true
        else
            kind = 10
            call confuse(random, text)
            call confuse(random, text)
        end if
        if (bare(text) /= bare(table(row)%true)) table(row)%kind = kind
    end subroutine damage

    !> Takes one digit for another, mostly for one that looks like it.
    subroutine confuse(random, text)
        type(random_type), intent(inout) :: random          !! where the numbers come from
        character(figure_length), intent(inout) :: text     !! a figure
        character(4), parameter :: alike(0:9) = ['6898', '7474', '7373', '8585', '9191', '6363', &
            '5080', '1212', '3069', '4080']
        character(4) :: other
        integer :: at, which, place
        at = digit_in(random, text)
        which = iachar(text(at:at)) - iachar('0')
        if (random%one_in(3)) then
            text(at:at) = digit(modulo(which + 1 + int(9.0_dp*random%unit()), 10))
        else
            other = alike(which)
            place = 1 + int(4.0_dp*random%unit())
            which = iachar(other(place:place)) - iachar('0')
            text(at:at) = digit(which)
        end if
    end subroutine confuse

    !> The character of a digit.
    pure character function digit(which)
        integer, intent(in) :: which !! 0 to 9
        digit = achar(iachar('0') + which)
    end function digit

    !> The place of a random digit of a figure.
    integer function digit_in(random, text) result(at)
        type(random_type), intent(inout) :: random !! where the numbers come from
        character(*), intent(in) :: text           !! a figure
        do
            at = 1 + int(random%unit()*real(len_trim(text), dp))
            if (scan(text(at:at), '0123456789') > 0) return
        end do
    end function digit_in

end module support_audited
