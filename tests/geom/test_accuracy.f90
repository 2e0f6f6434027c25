!> How accurate the points of an arc are, over many random cards: the distance, normal to the exact
!> conic of the doubles as read, in units in the last place (the spacing of doubles there) of the
!> largest coordinate of the card or of the point. Rounding a point exactly known costs up to .71,
!> a stepped one, of which one ordinate is given, up to .5.
!> The oracle is Liming's equation in real128, set up from the doubles:
!>
!>     F(p) = C(p)**2 - k L1(p) L3(p),     k = C(s)**2/(L1(s) L3(s))
!>
!> with C, L1, L3 the products of the chord and the end tangents with the way to p, s the shoulder
!> point; it shares nothing with the rational form under test.
!>
!> LOFT_TEST_CARDS sets the number of cards (100000 where it is not set; 3000 tell something).
program test_accuracy
    use, intrinsic :: iso_fortran_env, only: real128
    use base_decimal, only: decimal_type, grid_type, new_grid
    use base_error, only: error_type
    use base_kinds, only: dp, i64
    use base_text, only: to_text
    use geom_arc, only: arc_through, arc_type, direction_of_slope, end_type, weight
    use geom_arc_point, only: point
    use geom_contour, only: contour_of, contour_point_type
    use geom_crossing, only: turning_places
    use geom_place, only: at_shoulder, place_at, place_type
    use geom_twofold, only: twofold
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: qp = real128

    !> A card and the exact conic of its doubles.
    type :: card_type
        type(end_type) :: start, finish
        real(dp) :: shoulder(2) = 0.0_dp
        real(qp) :: ratio = 0.0_qp
    end type card_type

    !> Errors met so far: how many in each hundredth of an ulp, and the worst.
    type :: tally_type
        integer(i64) :: bin(0:1000) = 0
        real(dp) :: largest = 0.0_dp
        type(card_type) :: card
        real(dp) :: weight = 0.0_dp
        real(dp) :: point(2) = 0.0_dp
    end type tally_type

    type(tap_type) :: tap
    type(random_type) :: random
    type(tally_type) :: stepped, placed
    type(card_type) :: card
    type(arc_type) :: arc
    type(error_type), allocatable :: error
    integer :: cards, made, tried
    integer :: extreme(4)

    cards = number_of_cards()
    made = 0
    tried = 0
    extreme = 0
    do while (made < cards .and. tried < 20*cards)
        tried = tried + 1
        call draw_card(random, card)
        call arc_through(card%start, card%shoulder, card%finish, arc, error)
        if (allocated(error)) cycle
        if (arc%is_line) cycle
        made = made + 1
        card%ratio = ratio_of(card)
        extreme = extreme + merge(1, 0, [weight(arc) < -0.99_dp, weight(arc) < 0.0_dp, &
            weight(arc) > 1.0e3_dp, weight(arc) > 1.0e6_dp])
        call measure_places(card, arc, placed)
        call measure_steps(card, arc, 1, stepped)
        call measure_steps(card, arc, 2, stepped)
    end do
    call tap%note(to_text(made)//' arcs of '//to_text(tried)//' random cards; weight below -.99: ' &
        //to_text(extreme(1))//', below 0: '//to_text(extreme(2))//', above 1e3: ' &
        //to_text(extreme(3))//', above 1e6: '//to_text(extreme(4)))
    call tap%ok(made == cards, 'as many arcs as asked for were drawn')
    call tap%ok(all(extreme > cards/1000) .or. cards < 3000, &
        'nearly whole ellipses and sharp corners are among them')
    call report(placed, 'points at places of the arc')
    call report(stepped, 'points at stepped ordinates')
    call tap%ok(placed%largest <= 0.75_dp, &
        'every point at a place is within .75 ulp of the exact conic')
    call tap%ok(stepped%largest <= 0.75_dp, &
        'every stepped point is within .75 ulp of the exact conic')
    call tap%finish()

contains

    !> The number of cards asked for by LOFT_TEST_CARDS.
    integer function number_of_cards() result(number)
        character(20) :: text
        integer :: status
        number = 100000
        call get_environment_variable('LOFT_TEST_CARDS', text, status=status)
        if (status /= 0) return
        read (text, *, iostat=status) number
        if (status /= 0) number = 100000
    end function number_of_cards

    !> A card from a conic of random shape: offset to 1e4, size .1 to 1000, weight -.9995 to 1e8,
    !> end tangents from nearly along the chord to nearly parallel, shoulder point anywhere
    !> on the arc; two in three rounded to the decimals of a punched card.
    subroutine draw_card(random, card)
        type(random_type), intent(inout) :: random
        type(card_type), intent(out) :: card
        real(dp) :: chord(2), corner(2), origin(2), size, w, r, slope(2), angle
        integer :: axis

        size = 10.0_dp**random%between(-1.0_dp, 3.0_dp)
        angle = random%between(0.0_dp, 6.2832_dp)
        chord = size*[cos(angle), sin(angle)]
        if (random%one_in(8)) chord = size*[random%sign(), 0.0_dp]
        if (random%one_in(8)) chord = size*[0.0_dp, random%sign()]
        origin = [(random%sign()*10.0_dp**random%between(-1.0_dp, 4.0_dp), axis=1, 2)]
        corner = random%between(-0.5_dp, 1.5_dp)*chord &
            + random%sign()*10.0_dp**random%between(-4.0_dp, 3.0_dp)*[-chord(2), chord(1)]
        w = 10.0_dp**random%between(-3.0_dp, 8.0_dp)
        if (random%one_in(3)) w = random%between(-1.0_dp, 1.0_dp)
        if (random%one_in(6)) w = -1.0_dp + 10.0_dp**random%between(-3.3_dp, 0.0_dp)
        r = 10.0_dp**random%between(-3.0_dp, 3.0_dp)
        card%start%point = origin
        card%finish%point = origin + chord
        card%shoulder = origin + (2.0_dp*r*w*corner + r**2*chord)/(1.0_dp + 2.0_dp*r*w + r**2)
        slope = [slope_of(corner), slope_of(chord - corner)]
        if (.not. random%one_in(3)) then
            card%start%point = rounded(card%start%point, 3)
            card%finish%point = rounded(card%finish%point, 3)
            card%shoulder = rounded(card%shoulder, 3)
            slope = rounded(slope, 5)
        end if
        card%start%tangent = direction_of_slope(slope(1))
        card%finish%tangent = direction_of_slope(slope(2))
    end subroutine draw_card

    !> The slope of a direction as it is punched.
    real(dp) function slope_of(direction)
        real(dp), intent(in) :: direction(2)
        slope_of = 999.999_dp
        if (abs(direction(2)) < 999.0_dp*abs(direction(1))) slope_of = direction(2)/direction(1)
    end function slope_of

    !> A number as punched with so many decimals.
    elemental real(dp) function rounded(x, decimals)
        real(dp), intent(in) :: x
        integer, intent(in) :: decimals
        rounded = anint(x*10.0_dp**decimals)/10.0_dp**decimals
    end function rounded

    !> The constant k of Liming's equation.
    pure real(qp) function ratio_of(card) result(ratio)
        type(card_type), intent(in) :: card
        real(qp) :: line(3)
        line = lines(card, real(card%shoulder, qp))
        ratio = line(3)**2/(line(1)*line(2))
    end function ratio_of

    !> The products of both end tangents and of the chord with the way to a point.
    pure function lines(card, p) result(line)
        type(card_type), intent(in) :: card
        real(qp), intent(in) :: p(2)
        real(qp) :: line(3)
        line(1) = product_of(real(card%start%tangent, qp), p - real(card%start%point, qp))
        line(2) = product_of(real(card%finish%tangent, qp), p - real(card%finish%point, qp))
        line(3) = product_of(real(card%finish%point, qp) - real(card%start%point, qp), &
            p - real(card%start%point, qp))
    end function lines

    !> The outer product of two vectors.
    pure real(qp) function product_of(u, v)
        real(qp), intent(in) :: u(2), v(2)
        product_of = u(1)*v(2) - u(2)*v(1)
    end function product_of

    !> A vector turned left by a right angle.
    pure function left_of(v)
        real(qp), intent(in) :: v(2)
        real(qp) :: left_of(2)
        left_of = [-v(2), v(1)]
    end function left_of

    !> The distance of a point from the exact conic: Newton steps along the gradient to its foot.
    pure real(dp) function distance(card, at)
        type(card_type), intent(in) :: card
        real(dp), intent(in) :: at(2)
        real(qp) :: p(2), line(3), gradient(2), chord(2)
        integer :: i

        chord = real(card%finish%point, qp) - real(card%start%point, qp)
        p = real(at, qp)
        do i = 1, 2
            line = lines(card, p)
            gradient = 2.0_qp*line(3)*left_of(chord) - card%ratio*( &
                line(2)*left_of(real(card%start%tangent, qp)) &
                + line(1)*left_of(real(card%finish%tangent, qp)))
            if (all(abs(gradient) <= 0.0_qp)) exit
            p = p - (line(3)**2 - card%ratio*line(1)*line(2))*gradient/dot_product(gradient, &
                gradient)
        end do
        distance = real(norm2(p - real(at, qp)), dp)
    end function distance

    !> Adds the error of a point to a tally.
    subroutine add(tally, card, arc, at)
        type(tally_type), intent(inout) :: tally
        type(card_type), intent(in) :: card
        type(arc_type), intent(in) :: arc
        real(dp), intent(in) :: at(2)
        real(dp) :: ulps
        ulps = distance(card, at)/spacing(maxval(abs( &
            [card%start%point, card%shoulder, card%finish%point, at])))
        associate (slot => tally%bin(min(int(min(100.0_dp*ulps, 1.0e6_dp)), 1000)))
            slot = slot + 1
        end associate
        if (ulps <= tally%largest) return
        tally%largest = ulps
        tally%card = card
        tally%weight = weight(arc)
        tally%point = at
    end subroutine add

    !> Adds the errors at places near both ends, at the shoulder and between.
    subroutine measure_places(card, arc, tally)
        type(card_type), intent(in) :: card
        type(arc_type), intent(in) :: arc
        type(tally_type), intent(inout) :: tally
        integer :: i
        do i = 1, 5
            call add(tally, card, arc, point(arc, place_at(real(i, dp)/6.0_dp)))
        end do
        call add(tally, card, arc, point(arc, at_shoulder))
        call add(tally, card, arc, point(arc, place_type(twofold(1.0e-3_dp), twofold(1.0_dp))))
        call add(tally, card, arc, point(arc, place_type(twofold(1.0_dp), twofold(1.0e-6_dp))))
    end subroutine measure_places

    !> Adds the errors at some seven stepped ordinates along an axis.
    subroutine measure_steps(card, arc, axis, tally)
        type(card_type), intent(in) :: card
        type(arc_type), intent(in) :: arc
        integer, intent(in) :: axis
        type(tally_type), intent(inout) :: tally
        type(contour_point_type), allocatable :: rows(:)
        type(error_type), allocatable :: error
        type(grid_type) :: grid
        real(dp) :: reach, at(2)
        integer :: i

        reach = abs(arc%finish(axis) - arc%start(axis))
        associate (turns => turning_places(arc, axis))
            do i = 1, size(turns)
                at = point(arc, turns(i))
                reach = max(reach, abs(at(axis) - arc%start(axis)))
            end do
        end associate
        call new_grid(decimal_type(nint(1.0e3_dp*arc%start(axis), i64), -3), &
            decimal_type(max(1_i64, nint(1.4e4_dp*reach, i64)), -5), grid, error)
        call contour_of(arc, axis, grid, rows, error)
        if (allocated(error)) error stop 'a table was refused'
        do i = 2, size(rows) - 1
            call add(tally, card, arc, [rows(i)%x, rows(i)%y])
        end do
    end subroutine measure_steps

    !> The share of points within an error.
    real(dp) function share_within(tally, ulps) result(share)
        type(tally_type), intent(in) :: tally
        real(dp), intent(in) :: ulps
        share = real(sum(tally%bin(:nint(100.0_dp*ulps) - 1)), dp)/real(sum(tally%bin), dp)
    end function share_within

    !> Says what a tally found.
    subroutine report(tally, name)
        type(tally_type), intent(in) :: tally
        character(*), intent(in) :: name
        character(200) :: line
        integer :: i
        do i = 0, 1000
            if (share_within(tally, 0.01_dp*real(i + 1, dp)) >= 0.999_dp) exit
        end do
        write (line, '(i0,1x,2a,f0.3,a,f0.2,a,es9.2)') sum(tally%bin), name, &
            ': largest error ', tally%largest, ' ulp, 99.9 % within ', 0.01_dp*real(i + 1, dp), &
            ' ulp; worst has weight ', tally%weight
        call tap%note(trim(line))
        write (line, '(a,5(1x,g0))') 'worst card, points 1 to 3:', tally%card%start%point, &
            tally%card%shoulder, tally%card%finish%point(1)
        call tap%note(trim(line))
        write (line, '(a,7(1x,g0))') '... ', tally%card%finish%point(2), tally%card%start%tangent, &
            tally%card%finish%tangent, tally%point
        call tap%note(trim(line))
    end subroutine report

end program test_accuracy
