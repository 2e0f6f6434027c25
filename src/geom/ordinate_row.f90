!> The ordinates of one arc, which runs towards greater x, at abscissas in a row, and its tangents
!> there: the formulas of `geom_crossing` and `geom_arc_point` on rows of numbers, worked out
!> together. The figures are the same.
module geom_ordinate_row
    use base_kinds, only: dp
    use geom_arc, only: arc_type
    use geom_arc_row, only: place_row_type
    use geom_twofold, only: operator(*), operator(-), twofold, twofold_type
    use geom_twofold_short, only: chosen, exact_row, operator(*), operator(+), operator(-), &
        operator(/), row_type, scaled, sqrt, square, width
    implicit none (type, external)
    private

    public :: row_ordinates

contains

    !> The ordinates and tangents where an arc passes abscissas towards greater x.
    pure subroutine row_ordinates(arc, x, place, y, along)
        type(arc_type), intent(in) :: arc               !! any arc that passes them so
        real(dp), intent(in) :: x(width)                !! between its ends, deck units
        type(place_row_type), intent(out) :: place      !! where they are
        real(dp), intent(out) :: y(width)               !! deck units
        real(dp), intent(out) :: along(width, 2)        !! along x and y, forward
        type(row_type) :: first, both, last, way
        type(twofold_type) :: w
        integer :: axis

        w = arc%fullness - 1.0_dp
        place = crossings(arc, w, x)
        first = square(place%alpha)
        both = place%alpha*place%beta
        both = both + both
        last = square(place%beta)
        way = (arc%bulge(2)*both + arc%half(2)*(last - first))/(first + last + w*both)
        way = scaled(spread(arc%size, 1, width), way + arc%half(2)) + twofold(arc%start(2))
        y = way%high
        do axis = 1, 2
            if (arc%is_line) then
                along(:, axis) = arc%start_tangent(axis)
                cycle
            end if
            way = arc%leaving(axis)*first + arc%half(axis)*both + arc%arriving(axis)*last
            along(:, axis) = way%high
        end do
    end subroutine row_ordinates

    !> The places where an arc passes abscissas towards greater x.
    pure type(place_row_type) function crossings(arc, w, x) result(place)
        type(arc_type), intent(in) :: arc           !! any arc that passes them so
        type(twofold_type), intent(in) :: w         !! its weight
        real(dp), intent(in) :: x(width)            !! between its ends, deck units
        type(row_type) :: before, after, middle, root
        logical :: is_first(width)
        real(dp) :: unit(width), sense(width)

        unit = 1.0_dp/arc%size
        before = scaled(unit, exact_row(x, arc%start(1)))
        after = scaled(-unit, exact_row(x, arc%finish(1)))
        middle = ((-0.5_dp)*w)*(before - after) + arc%bulge(1)
        root = sqrt(square(middle) + before*after)
        is_first = .not. middle%high < 0.0_dp
        place%alpha = chosen(middle + root, after, is_first)
        place%beta = chosen(before, root - middle, is_first)
        sense = merge(-1.0_dp, 1.0_dp, place%alpha%high < 0.0_dp .or. place%beta%high < 0.0_dp)
        place%alpha = scaled(sense, place%alpha)
        place%beta = scaled(sense, place%beta)
    end function crossings

end module geom_ordinate_row
