!> Where an arc has a given ordinate, and where an ordinate is greatest or least. `axis` is 1 for
!> crossings of a line x = constant, 2 for y = constant; u is the coordinate along that axis.
!>
!> With A = U - u1, C = u3 - U and B = g - (U - m) w, a place r = b/a has u = U where
!>
!>     C r**2 + 2 B r - A = 0,        C r + B = +sqrt(B**2 + A C) where u increases along the arc
!>
!> and the minus sign where it decreases: no root needs choosing by trial.
module geom_crossing
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use geom_arc, only: arc_type
    use geom_place, only: is_before, place_type
    use geom_twofold, only: exact_difference, operator(*), operator(+), operator(-), sqrt, &
        twofold_type
    implicit none (type, external)
    private

    public :: crossing, turning_places

contains

    !> The place where an arc passes an ordinate, upwards or downwards. The ordinate must be one
    !> that the arc passes so; on the whole arc there is at most one such place.
    pure type(place_type) function crossing(arc, axis, ordinate, rising) result(place)
        type(arc_type), intent(in) :: arc    !! any arc
        integer, intent(in) :: axis          !! 1: x, 2: y
        real(dp), intent(in) :: ordinate     !! U, deck units
        logical, intent(in) :: rising        !! the coordinate increases along the arc there
        type(twofold_type) :: before, after, middle, root

        before = in_size(arc, exact_difference(ordinate, arc%start(axis)))
        after = in_size(arc, exact_difference(arc%finish(axis), ordinate))
        middle = arc%bulge(axis) - 0.5_dp*((before - after)*(arc%fullness - 1.0_dp))
        root = sqrt(middle*middle + before*after)
        if (.not. rising) root = -root
        if (root%high*middle%high > 0.0_dp .or. is_zero(middle%high)) then
            place = pointed(middle + root, before)
        else
            place = pointed(after, root - middle)
        end if
    end function crossing

    !> A difference of coordinates in `size` of the arc, exactly.
    pure type(twofold_type) function in_size(arc, difference)
        type(arc_type), intent(in) :: arc            !! any arc
        type(twofold_type), intent(in) :: difference !! deck units
        in_size = twofold_type(difference%high/arc%size, difference%low/arc%size)
    end function in_size

    !> A place by its shares, which may both have come out negative.
    pure type(place_type) function pointed(alpha, beta) result(place)
        type(twofold_type), intent(in) :: alpha !! share of the start, either sign
        type(twofold_type), intent(in) :: beta  !! share of the finish, the same sign
        place = place_type(alpha, beta)
        if (alpha%high < 0.0_dp .or. beta%high < 0.0_dp) place = place_type(-alpha, -beta)
    end function pointed

    !> The places between the ends where the tangent is across an axis, in order along the
    !> arc: none, one or two. There the coordinate is greatest or least.
    pure function turning_places(arc, axis) result(places)
        type(arc_type), intent(in) :: arc !! any arc
        integer, intent(in) :: axis       !! 1: greatest and least x, 2: y
        type(place_type), allocatable :: places(:)
        type(twofold_type) :: discriminant, sum

        allocate (places(0))
        associate (v1 => arc%leaving(axis), h => arc%half(axis), v3 => arc%arriving(axis))
            discriminant = h*h - v1*v3
            if (.not. discriminant%high > 0.0_dp) return
            sum = sqrt(discriminant)
            if (h%high < 0.0_dp) sum = -sum
            sum = -(h + sum)
            if (is_inside(v3, sum)) places = [places, pointed(v3, sum)]
            if (is_inside(sum, v1)) places = [places, pointed(sum, v1)]
        end associate
        if (size(places) < 2) return
        if (is_before(places(2), places(1))) places = places([2, 1])
    end function turning_places

    !> True where two shares are a place between the ends.
    pure logical function is_inside(alpha, beta)
        type(twofold_type), intent(in) :: alpha !! share of the start
        type(twofold_type), intent(in) :: beta  !! share of the finish
        is_inside = (alpha%high > 0.0_dp .and. beta%high > 0.0_dp) &
            .or. (alpha%high < 0.0_dp .and. beta%high < 0.0_dp)
    end function is_inside

end module geom_crossing
