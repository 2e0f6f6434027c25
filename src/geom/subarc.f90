!> A part of a conic arc, from one of its places to another, which is a conic arc again.
!>
!> With each of the two places scaled to a denominator D of 1 (`geom_arc_point`), their sum is the
!> shoulder of the part, and any other sum of shares of the two is the place of the whole arc where
!> the part has these shares. Source: G. Farin, "Curves and Surfaces for CAGD", 5th ed., 12.4.
module geom_subarc
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, line_between
    use geom_arc_point, only: point, tangent
    use geom_place, only: is_finish, is_start, place_type
    use geom_triangle, only: end_type
    use geom_twofold, only: operator(*), operator(+), operator(/), operator(-), sqrt, twofold, &
        twofold_type
    implicit none (type, external)
    private

    public :: place_between, place_of_part, part_of

contains

    !> The shoulder of the part of an arc between two places: there it is furthest from its chord.
    pure type(place_type) function place_between(arc, first, second) result(place)
        type(arc_type), intent(in) :: arc       !! any arc
        type(place_type), intent(in) :: first   !! a place
        type(place_type), intent(in) :: second  !! another
        type(place_type) :: middle
        middle = place_type(twofold(1.0_dp), twofold(1.0_dp))
        place = place_of_part(arc, first, second, middle)
    end function place_between

    !> The place of an arc where the part of it between two places has a place.
    pure type(place_type) function place_of_part(arc, first, second, inner) result(place)
        type(arc_type), intent(in) :: arc       !! any arc
        type(place_type), intent(in) :: first   !! where the part begins
        type(place_type), intent(in) :: second  !! where it ends
        type(place_type), intent(in) :: inner   !! a place of the part
        type(place_type) :: one, two

        one = scaled(arc, first)
        two = scaled(arc, second)
        place%alpha = inner%alpha*one%alpha + inner%beta*two%alpha
        place%beta = inner%alpha*one%beta + inner%beta*two%beta
    end function place_of_part

    !> A place scaled to a denominator of 1.
    pure type(place_type) function scaled(arc, place)
        type(arc_type), intent(in) :: arc       !! any arc
        type(place_type), intent(in) :: place   !! where on it
        type(twofold_type) :: apart, root

        apart = place%alpha - place%beta
        root = sqrt(apart*apart + 2.0_dp*(place%alpha*place%beta)*arc%fullness)
        scaled = place_type(place%alpha/root, place%beta/root)
    end function scaled

    !> The part of an arc between two places; the whole arc where these are its ends. A part too
    !> short to be a conic in doubles is the line between its ends.
    pure type(arc_type) function part_of(arc, first, second) result(part)
        type(arc_type), intent(in) :: arc       !! any arc
        type(place_type), intent(in) :: first   !! where the part begins
        type(place_type), intent(in) :: second  !! where it ends
        type(error_type), allocatable :: error

        part = arc
        if (is_start(first) .and. is_finish(second)) return
        call arc_through(end_type(point(arc, first), tangent(arc, first)), &
            point(arc, place_between(arc, first, second)), &
            end_type(point(arc, second), tangent(arc, second)), part, error)
        if (allocated(error)) part = line_between(point(arc, first), point(arc, second))
    end function part_of

end module geom_subarc
