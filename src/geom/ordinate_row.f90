!> The ordinates of one arc, which runs towards greater x, at abscissas in a row, and its tangents
!> there, on rows of numbers. The figures are those of `geom_crossing` and `geom_arc_point`, of
!> which this takes half the operations. Of each place r = b/a one share is A or C, and the point
!> is seen from the end that is so far away along x. With B = v1 - w A (along x) and R of
!> `geom_crossing`
!>
!>     from the start, where B >= 0:   o = A, v = v1       p = R + |B|        q = p v + o h
!>     from the finish, elsewhere:     o = C, v = v3
!>
!> the shares are p and o, the point is away by o along x and by o qy/qx along y, and half the
!> tangent n is R qx along x and R qy + o (v1 x h) along y, from the finish R qy - o (v1 x h).
!> (D = 2 qx from the start: what a place is away from there is 2 b (a v1 + b h)/D.)
module geom_ordinate_row
    use base_kinds, only: dp
    use geom_arc, only: arc_type
    use geom_arc_row, only: place_row_type
    use geom_twofold, only: operator(*), operator(-), operator(/), twofold, twofold_type
    use geom_twofold_pair, only: product_and_multiple
    use geom_twofold_short, only: chosen, exact_row, operator(*), operator(+), operator(/), &
        row_of, row_type, scaled, sqrt, square, width
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: row_ordinates

    !> Points of an arc as they are seen from one of its ends.
    type :: view_row_type
        type(row_type) :: away          !! o, in `size` of the arc
        type(row_type) :: reach         !! p
        type(row_type) :: root          !! R
        logical :: is_start(width)      !! from the start; else from the finish
    end type view_row_type

contains

    !> The ordinates and tangents where an arc passes abscissas towards greater x.
    pure subroutine row_ordinates(arc, x, y, along, place)
        type(arc_type), intent(in) :: arc                       !! any arc that passes them so
        real(dp), intent(in) :: x(width)                        !! between its ends, deck units
        real(dp), intent(out) :: y(width)                       !! deck units
        real(dp), intent(out) :: along(width, 2)                !! along x and y, forward
        type(place_row_type), intent(out), optional :: place    !! where they are
        type(view_row_type) :: view
        type(row_type) :: way, q(2), seen_from
        real(dp) :: sense(width)
        integer :: axis

        call look(arc, x, view)
        if (present(place)) then
            place%alpha = chosen(view%reach, view%away, view%is_start)
            place%beta = chosen(view%away, view%reach, view%is_start)
        end if
        if (arc%is_line) then
            way = (arc%half(2)/arc%half(1))*exact_row(x, arc%start(1)) + twofold(arc%start(2))
            y = way%high
            along(:, 1) = arc%start_tangent(1)
            along(:, 2) = arc%start_tangent(2)
            return
        end if
        do axis = 1, 2
            q(axis) = product_and_multiple(view%reach, either(arc%leaving(axis), &
                arc%arriving(axis), view%is_start), arc%half(axis), view%away)
        end do
        sense = merge(1.0_dp, -1.0_dp, view%is_start)
        view%away = scaled(sense, view%away)
        seen_from = row_of(merge(arc%start(2), arc%finish(2), view%is_start)/arc%size)
        way = seen_from + view%away*(q(2)/q(1))
        y = arc%size*way%high
        way = view%root*q(1)
        along(:, 1) = way%high
        way = product_and_multiple(view%root, q(2), cross(arc%leaving, arc%half), view%away)
        along(:, 2) = way%high
    end subroutine row_ordinates

    !> The points of an arc at abscissas from the ends of the arc.
    pure subroutine look(arc, x, view)
        type(arc_type), intent(in) :: arc           !! any arc that passes them so
        real(dp), intent(in) :: x(width)            !! between its ends, deck units
        type(view_row_type), intent(out) :: view    !! from the better end each
        type(row_type) :: before, after, middle
        real(dp) :: unit

        unit = 1.0_dp/arc%size
        before = exact_row(unit*x, unit*arc%start(1))
        after = exact_row(-unit*x, -unit*arc%finish(1))
        middle = (twofold(1.0_dp) - arc%fullness)*before + arc%leaving(1)
        view%root = sqrt(square(middle) + before*after)
        view%is_start = .not. middle%high < 0.0_dp
        view%reach = view%root + scaled(merge(1.0_dp, -1.0_dp, view%is_start), middle)
        view%away = chosen(before, after, view%is_start)
    end subroutine look

    !> One of two numbers, or the other.
    pure type(row_type) function either(first, second, is_first) result(row)
        type(twofold_type), intent(in) :: first     !! taken where `is_first`
        type(twofold_type), intent(in) :: second    !! taken elsewhere
        logical, intent(in) :: is_first(width)      !! which
        integer :: i
        do i = 1, width
            row%high(i) = merge(first%high, second%high, is_first(i))
            row%low(i) = merge(first%low, second%low, is_first(i))
        end do
    end function either

end module geom_ordinate_row
