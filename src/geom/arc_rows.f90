!> What an arc is at many places side by side: the figures of `geom_crossing` and `geom_arc_point`,
!> bit for bit, by the same formulas.
module geom_arc_rows
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use geom_arc, only: arc_type
    use geom_arc_point, only: slope_along, slope_type
    use geom_place, only: place_type
    use geom_twofold, only: operator(-), twofold, twofold_type
    use geom_twofold_same, only: exact_difference, operator(*), operator(+), operator(-), &
        operator(/), rows_at_once, rows_type, selected, sqrt, to_real
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: places_type, arc_rows_type, terms_type
    public :: place_of_row, crossings, terms_of, coordinates, find_arc_rows

    !> Places on an arc, as `place_type`.
    type :: places_type
        type(rows_type) :: alpha !! shares of the start
        type(rows_type) :: beta  !! shares of the finish
    end type places_type

    !> What the coordinates of places have in common; a : b are the shares.
    type :: terms_type
        type(rows_type) :: twice   !! 2 a b
        type(rows_type) :: apart   !! b**2 - a**2
        type(rows_type) :: divisor !! D of `geom_arc_point`
    end type terms_type

    !> Points of an arc with what the tables say of them.
    type :: arc_rows_type
        real(dp) :: x(rows_at_once) = 0.0_dp            !! deck units
        real(dp) :: y(rows_at_once) = 0.0_dp            !! deck units
        type(slope_type) :: slope(rows_at_once)         !! dy/dx, or vertical
        real(dp) :: curvature(rows_at_once) = 0.0_dp    !! 1/deck unit
        type(places_type) :: places                     !! where on the arc
    end type arc_rows_type

contains

    !> The rows where a curved arc passes some ordinates, which stand in them as they are.
    pure subroutine find_arc_rows(arc, axis, ordinate, rising, rows)
        type(arc_type), intent(in) :: arc               !! not a line
        integer, intent(in) :: axis                     !! 1: x is stepped, 2: y
        real(dp), intent(in) :: ordinate(rows_at_once)  !! between the ends of a stretch, deck units
        logical, intent(in) :: rising                   !! the coordinate increases along the arc
        type(arc_rows_type), intent(inout) :: rows      !! gets them
        type(terms_type) :: terms
        type(rows_type) :: alpha_square, beta_square, n(2), pace
        real(dp), dimension(rows_at_once) :: run, rise
        integer :: i, k

        rows%places = crossings(arc, axis, ordinate, rising)
        terms = terms_of(arc, rows%places)
        rows%x = ordinate
        rows%y = ordinate
        if (axis == 1) rows%y = coordinates(arc, 2, terms)
        if (axis == 2) rows%x = coordinates(arc, 1, terms)
        alpha_square = rows%places%alpha*rows%places%alpha
        beta_square = rows%places%beta*rows%places%beta
        do k = 1, 2
            n(k) = alpha_square*arc%leaving(k) + terms%twice*arc%half(k) + &
                beta_square*arc%arriving(k)
        end do
        run = to_real(n(1))
        rise = to_real(n(2))
        do i = 1, rows_at_once
            rows%slope(i) = slope_along([run(i), rise(i)])
        end do
        pace = terms%divisor/sqrt(n(1)*n(1) + n(2)*n(2))
        rows%curvature = to_real(cross(arc%bulge, arc%half)*pace*pace*pace)/arc%size
    end subroutine find_arc_rows

    !> The places where an arc passes some ordinates, upwards or downwards.
    pure type(places_type) function crossings(arc, axis, ordinate, rising) result(places)
        type(arc_type), intent(in) :: arc               !! any arc
        integer, intent(in) :: axis                     !! 1: x, 2: y
        real(dp), intent(in) :: ordinate(rows_at_once)  !! U, deck units
        logical, intent(in) :: rising                   !! the coordinate increases there
        type(rows_type) :: before, after, middle, root
        logical, dimension(rows_at_once) :: agree, turned

        before = in_size(arc, exact_difference(ordinate, spread_out(arc%start(axis))))
        after = in_size(arc, exact_difference(spread_out(arc%finish(axis)), ordinate))
        middle = arc%bulge(axis) - 0.5_dp*((before - after)*(arc%fullness - twofold(1.0_dp)))
        root = sqrt(middle*middle + before*after)
        if (.not. rising) root = -root
        agree = root%high*middle%high > 0.0_dp .or. is_zero(middle%high)
        places%alpha = selected(middle + root, after, agree)
        places%beta = selected(before, root - middle, agree)
        turned = places%alpha%high < 0.0_dp .or. places%beta%high < 0.0_dp
        places%alpha = selected(-places%alpha, places%alpha, turned)
        places%beta = selected(-places%beta, places%beta, turned)
    end function crossings

    !> One of many places.
    pure type(place_type) function place_of_row(places, i) result(place)
        type(places_type), intent(in) :: places !! the places
        integer, intent(in) :: i                !! which
        place%alpha = twofold_type(places%alpha%high(i), places%alpha%low(i))
        place%beta = twofold_type(places%beta%high(i), places%beta%low(i))
    end function place_of_row

    !> Differences of coordinates in `size` of the arc, exactly.
    pure type(rows_type) function in_size(arc, difference)
        type(arc_type), intent(in) :: arc         !! any arc
        type(rows_type), intent(in) :: difference !! deck units
        in_size%high = difference%high/arc%size
        in_size%low = difference%low/arc%size
    end function in_size

    !> A number in every row.
    pure function spread_out(x) result(all)
        real(dp), intent(in) :: x !! any number
        real(dp) :: all(rows_at_once)
        all = x
    end function spread_out

    !> What the coordinates of places have in common.
    pure type(terms_type) function terms_of(arc, places) result(terms)
        type(arc_type), intent(in) :: arc        !! any arc
        type(places_type), intent(in) :: places  !! where on it
        type(rows_type) :: apart
        associate (a => places%alpha, b => places%beta)
            apart = a - b
            terms%twice = 2.0_dp*(a*b)
            terms%apart = (b - a)*(b + a)
            terms%divisor = apart*apart + terms%twice*arc%fullness
        end associate
    end function terms_of

    !> One coordinate of places between the ends, deck units.
    pure function coordinates(arc, axis, terms) result(coordinate)
        type(arc_type), intent(in) :: arc       !! any arc
        integer, intent(in) :: axis             !! 1: x, 2: y
        type(terms_type), intent(in) :: terms   !! of the places, no end
        real(dp) :: coordinate(rows_at_once)
        type(rows_type) :: offset

        offset = arc%half(axis) + (terms%twice*arc%bulge(axis) + terms%apart*arc%half(axis))/ &
            terms%divisor
        coordinate = to_real(twofold(arc%start(axis)) + arc%size*offset)
    end function coordinates

end module geom_arc_rows
