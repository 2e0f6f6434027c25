!> Arcs in a row, a place on each: points, tangents and curvatures by the formulas of
!> `geom_arc_point`, on rows of numbers. The figures are the same.
module geom_arc_row
    use base_kinds, only: dp
    use geom_arc, only: arc_type
    use geom_place, only: place_type
    use geom_twofold_pair, only: cross
    use geom_twofold_short, only: number_of, operator(*), operator(+), operator(-), &
        operator(/), repeated, row_of, row_type, scaled, sqrt, square, width
    implicit none (type, external)
    private

    public :: arc_row_type, place_row_type, repeated_arc, place_row, place_of_row
    public :: row_points, row_curvatures

    !> Arcs, each as an `arc_type` keeps it.
    type :: arc_row_type
        real(dp) :: start(width, 2)             !! first points, deck units
        real(dp) :: finish(width, 2)            !! last points, deck units
        real(dp) :: start_tangent(width, 2)     !! forward along the arcs
        real(dp) :: finish_tangent(width, 2)    !! forward along the arcs
        logical :: is_line(width)               !! straight lines
        real(dp) :: size(width)                 !! powers of two, deck units: of what follows
        type(row_type) :: half(2)               !! half the chords
        type(row_type) :: bulge(2)              !! see `geom_arc`
        type(row_type) :: leaving(2)            !! forward tangents at the starts
        type(row_type) :: arriving(2)           !! forward tangents at the finishes
        type(row_type) :: fullness              !! above zero
    end type arc_row_type

    !> Places, one on each arc.
    type :: place_row_type
        type(row_type) :: alpha     !! shares of the starts
        type(row_type) :: beta      !! shares of the finishes
    end type place_row_type

    !> What points, tangents and curvatures at places a : b have in common.
    type :: terms_row_type
        type(row_type) :: first     !! a**2
        type(row_type) :: both      !! 2 a b
        type(row_type) :: last      !! b**2
    end type terms_row_type

contains

    !> One arc, as often as a row has room.
    pure subroutine repeated_arc(arc, row)
        type(arc_type), intent(in) :: arc       !! any arc
        type(arc_row_type), intent(out) :: row  !! gets it
        integer :: axis

        do axis = 1, 2
            row%start(:, axis) = arc%start(axis)
            row%finish(:, axis) = arc%finish(axis)
            row%start_tangent(:, axis) = arc%start_tangent(axis)
            row%finish_tangent(:, axis) = arc%finish_tangent(axis)
            row%half(axis) = repeated(arc%half(axis))
            row%bulge(axis) = repeated(arc%bulge(axis))
            row%leaving(axis) = repeated(arc%leaving(axis))
            row%arriving(axis) = repeated(arc%arriving(axis))
        end do
        row%is_line = arc%is_line
        row%size = arc%size
        row%fullness = repeated(arc%fullness)
    end subroutine repeated_arc

    !> Some places as a row; the last one stands in the room that is left.
    pure subroutine place_row(places, row)
        type(place_type), intent(in) :: places(:)   !! from one to as many as a row has room for
        type(place_row_type), intent(out) :: row    !! gets them
        integer :: i

        do i = 1, width
            associate (place => places(min(i, size(places))))
                row%alpha%high(i) = place%alpha%high
                row%alpha%low(i) = place%alpha%low
                row%beta%high(i) = place%beta%high
                row%beta%low(i) = place%beta%low
            end associate
        end do
    end subroutine place_row

    !> One of the places of a row.
    pure type(place_type) function place_of_row(row, i) result(place)
        type(place_row_type), intent(in) :: row !! any
        integer, intent(in) :: i                !! which
        place = place_type(number_of(row%alpha, i), number_of(row%beta, i))
    end function place_of_row

    !> The points, each coordinate within half an ulp of the largest, and the tangents, forward
    !> along the arcs; the lengths of these have no meaning. The ends are exactly as given, and so
    !> are the directions there and of lines.
    pure subroutine row_points(arc, place, at, along)
        type(arc_row_type), intent(in) :: arc       !! any arcs
        type(place_row_type), intent(in) :: place   !! where on each
        real(dp), intent(out) :: at(width, 2)       !! x, y, deck units
        real(dp), intent(out) :: along(width, 2)    !! along x and y
        type(terms_row_type) :: terms
        type(row_type) :: apart, under, way
        integer :: axis, i

        terms = terms_of(place)
        apart = place%beta - place%alpha
        under = square(apart) + terms%both*arc%fullness
        apart = apart*(place%beta + place%alpha)
        do axis = 1, 2
            way = (terms%both*arc%bulge(axis) + apart*arc%half(axis))/under
            way = scaled(arc%size, arc%half(axis) + way)
            way = way + row_of(arc%start(:, axis))
            at(:, axis) = way%high
            way = hodograph(arc, terms, axis)
            along(:, axis) = way%high
            do i = 1, width
                if (.not. place%beta%high(i) > 0.0_dp) at(i, axis) = arc%start(i, axis)
                if (.not. place%alpha%high(i) > 0.0_dp) then
                    at(i, axis) = arc%finish(i, axis)
                    along(i, axis) = arc%finish_tangent(i, axis)
                end if
                if (.not. place%beta%high(i) > 0.0_dp .or. arc%is_line(i)) &
                    along(i, axis) = arc%start_tangent(i, axis)
            end do
        end do
    end subroutine row_points

    !> What places have in common.
    pure type(terms_row_type) function terms_of(place) result(terms)
        type(place_row_type), intent(in) :: place   !! any
        terms%first = square(place%alpha)
        terms%both = place%alpha*place%beta
        terms%both = terms%both + terms%both
        terms%last = square(place%beta)
    end function terms_of

    !> The vectors n of `geom_arc_point` along an axis, in `size` of the arcs.
    pure type(row_type) function hodograph(arc, terms, axis) result(n)
        type(arc_row_type), intent(in) :: arc       !! any arcs
        type(terms_row_type), intent(in) :: terms   !! of places on them
        integer, intent(in) :: axis                 !! 1: x, 2: y
        n = terms%first*arc%leaving(axis) + terms%both*arc%half(axis) &
            + terms%last*arc%arriving(axis)
    end function hodograph

    !> The curvatures, 1/deck unit, positive where an arc turns left; zero for lines.
    pure subroutine row_curvatures(arc, place, curvature)
        type(arc_row_type), intent(in) :: arc       !! any arcs
        type(place_row_type), intent(in) :: place   !! where on each
        real(dp), intent(out) :: curvature(width)   !! see above
        type(terms_row_type) :: terms
        type(row_type) :: pace, area
        integer :: i

        terms = terms_of(place)
        pace = square(place%alpha - place%beta) + terms%both*arc%fullness
        pace = pace/sqrt(square(hodograph(arc, terms, 1)) + square(hodograph(arc, terms, 2)))
        area = cross(arc%bulge, arc%half)
        area = area*pace*pace*pace
        do i = 1, width
            curvature(i) = merge(0.0_dp, area%high(i)/arc%size(i), arc%is_line(i))
        end do
    end subroutine row_curvatures

end module geom_arc_row
