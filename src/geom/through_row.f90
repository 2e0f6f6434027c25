!> Arcs in a row by their ends, end tangents and shoulder points, by the formulas of `geom_triangle`
!> and `geom_arc` on rows of numbers. The figures are the same.
module geom_through_row
    use base_kinds, only: dp, i64
    use base_tolerances, only: decimal_noise, ulp
    use geom_arc_row, only: arc_row_type
    use geom_twofold, only: twofold_type
    use geom_twofold_pair, only: cross
    use geom_twofold_short, only: chosen, exact_row, operator(*), operator(+), operator(-), &
        operator(/), row_of, row_type, scaled, sqrt, width
    implicit none (type, external)
    private

    public :: arcs_through, end_row_type

    !> How far above its noise the height of a shoulder point over the chord must be for an arc to
    !> be made here: beyond any doubt of a straight line.
    real(dp), parameter :: clearly = 1.0e6_dp
    !> Products of two numbers above this one are still numbers.
    real(dp), parameter :: least = 1.0e-100_dp
    !> One, and rows of it and of a half.
    type(twofold_type), parameter :: one = twofold_type(1.0_dp, 0.0_dp)
    real(dp), parameter :: one_each(width) = 1.0_dp, half_each(width) = 0.5_dp
    !> Where a double has its exponent.
    integer(i64), parameter :: exponent_bits = int(z'7FF0000000000000', i64)

    !> Ends of arcs.
    type :: end_row_type
        real(dp) :: point(width, 2)     !! deck units
        real(dp) :: tangent(width, 2)   !! either way, not zero
    end type end_row_type

    !> The products of control triangles, as `triangle_type` has them.
    type :: products_type
        type(row_type) :: chord         !! shoulder x chord
        type(row_type) :: start         !! shoulder x t1
        type(row_type) :: finish        !! (shoulder - chord) x t3
        type(row_type) :: chord_start   !! chord x t1
        type(row_type) :: chord_finish  !! t3 x chord
    end type products_type

contains

    !> The arcs from `start` through the shoulder points to `finish`. `is_sure` is false where there
    !> may be a straight line or no arc: that is for `arc_through` to say.
    pure subroutine arcs_through(start, shoulder, finish, arc, is_sure)
        type(end_row_type), intent(in) :: start     !! first points
        real(dp), intent(in) :: shoulder(width, 2)  !! shoulder points, deck units
        type(end_row_type), intent(in) :: finish    !! last points
        type(arc_row_type), intent(out) :: arc      !! the arcs
        logical, intent(out) :: is_sure(width)      !! see above
        type(row_type), dimension(2) :: over, beyond, chord, u, v
        type(row_type) :: share, w, rise, fall
        type(products_type) :: off
        integer :: axis

        call measure(start, shoulder, finish, arc%size, chord, over)
        beyond(1) = over(1) - chord(1)
        beyond(2) = over(2) - chord(2)
        u = directions(start)
        v = directions(finish)
        off%chord = cross(over, chord)
        off%start = cross(over, u)
        off%finish = cross(beyond, v)
        off%chord_start = cross(chord, u)
        off%chord_finish = cross(v, chord)
        is_sure = is_clear(off, largest(start, shoulder, finish)/arc%size)
        if (.not. all(is_sure)) call settle(is_sure, off)
        share = share_of(off)
        w = share*cross(v, u)
        arc%fullness = w + one
        is_sure = is_sure .and. arc%fullness%high > 0.0_dp
        if (.not. all(is_sure)) arc%fullness = chosen(arc%fullness, row_of(one_each), is_sure)
        rise = share*off%chord_finish
        fall = share*off%chord_start
        do axis = 1, 2
            arc%half(axis) = scaled(half_each, chord(axis))
            arc%leaving(axis) = rise*u(axis)
            arc%arriving(axis) = fall*v(axis)
            arc%bulge(axis) = arc%leaving(axis) - w*arc%half(axis)
        end do
        arc%start = start%point
        arc%finish = finish%point
        arc%is_line = .false.
        arc%start_tangent = forward(start%tangent, arc%leaving)
        arc%finish_tangent = forward(finish%tangent, arc%arriving)
    end subroutine arcs_through

    !> Chords and ways to the shoulder points in powers of two next above them.
    pure subroutine measure(start, shoulder, finish, size, chord, over)
        type(end_row_type), intent(in) :: start     !! first points
        real(dp), intent(in) :: shoulder(width, 2)  !! shoulder points, deck units
        type(end_row_type), intent(in) :: finish    !! last points
        real(dp), intent(out) :: size(width)        !! the powers, deck units
        type(row_type), intent(out) :: chord(2)     !! start to finish, in `size`
        type(row_type), intent(out) :: over(2)      !! start to shoulder point, in `size`
        real(dp) :: length(width)
        integer :: axis

        length = 0.0_dp
        do axis = 1, 2
            chord(axis) = exact_row(finish%point(:, axis), start%point(:, axis))
            over(axis) = exact_row(shoulder(:, axis), start%point(:, axis))
            length = max(length, abs(chord(axis)%high), abs(over(axis)%high))
        end do
        size = powers_of_two(length)
        do axis = 1, 2
            chord(axis) = scaled(1.0_dp/size, chord(axis))
            over(axis) = scaled(1.0_dp/size, over(axis))
        end do
    end subroutine measure

    !> The powers of two next above some numbers; 1 where they are zero.
    pure function powers_of_two(x) result(power)
        real(dp), intent(in) :: x(width) !! not negative
        real(dp) :: power(width)
        integer(i64) :: bits
        integer :: i
        do i = 1, width
            bits = iand(transfer(max(x(i), tiny(1.0_dp)), bits), exponent_bits)
            power(i) = merge(2.0_dp*transfer(bits, 1.0_dp), 1.0_dp, x(i) > 0.0_dp)
        end do
    end function powers_of_two

    !> Tangents scaled near 1.
    pure function directions(it) result(way)
        type(end_row_type), intent(in) :: it !! ends
        type(row_type) :: way(2)
        real(dp) :: power(width)
        power = powers_of_two(max(abs(it%tangent(:, 1)), abs(it%tangent(:, 2))))
        way(1) = row_of(it%tangent(:, 1)/power)
        way(2) = row_of(it%tangent(:, 2)/power)
    end function directions

    !> What is common to the legs of control triangles and the weights of their arcs: with it, k,
    !> the legs are k (v x chord) u and k (chord x u) v, and the weights k v x u.
    pure type(row_type) function share_of(off) result(share)
        type(products_type), intent(in) :: off !! of triangles that have arcs
        real(dp) :: sense(width)
        sense = sign(0.5_dp, off%chord_start%high)*sign(1.0_dp, off%chord_finish%high)
        share = scaled(-sense, off%chord)/sqrt((off%start*off%chord_start) &
            *(off%finish*off%chord_finish))
    end function share_of

    !> The largest coordinates of the points.
    pure function largest(start, shoulder, finish)
        type(end_row_type), intent(in) :: start     !! first points
        real(dp), intent(in) :: shoulder(width, 2)  !! shoulder points, deck units
        type(end_row_type), intent(in) :: finish    !! last points
        real(dp) :: largest(width)
        largest = max(abs(start%point(:, 1)), abs(start%point(:, 2)), abs(shoulder(:, 1)), &
            abs(shoulder(:, 2)), abs(finish%point(:, 1)), abs(finish%point(:, 2)))
    end function largest

    !> True where the shoulder point is beyond doubt off the chord, and within both end tangents.
    pure function is_clear(off, size)
        type(products_type), intent(in) :: off  !! of the triangles
        real(dp), intent(in) :: size(width)     !! largest coordinates, in `size` of the arcs
        logical :: is_clear(width)
        is_clear = abs(off%chord%high) > clearly*decimal_noise*ulp*size &
            .and. off%start%high*off%chord_start%high > least &
            .and. off%finish%high*off%chord_finish%high > least
    end function is_clear

    !> Makes what is not to be used harmless.
    pure subroutine settle(is_sure, off)
        logical, intent(in) :: is_sure(width)       !! to be used
        type(products_type), intent(inout) :: off   !! of the triangles
        type(row_type) :: unused

        unused = row_of(one_each)
        off%chord = chosen(off%chord, unused, is_sure)
        off%start = chosen(off%start, unused, is_sure)
        off%finish = chosen(off%finish, unused, is_sure)
        off%chord_start = chosen(off%chord_start, unused, is_sure)
        off%chord_finish = chosen(off%chord_finish, unused, is_sure)
    end subroutine settle

    !> Tangents, turned about where they do not point forward.
    pure function forward(tangent, ahead) result(turned)
        real(dp), intent(in) :: tangent(width, 2)   !! either way
        type(row_type), intent(in) :: ahead(2)      !! forward vectors along them
        real(dp) :: turned(width, 2), sense(width)
        sense = sign(1.0_dp, ahead(1)%high*tangent(:, 1) + ahead(2)%high*tangent(:, 2))
        turned(:, 1) = sense*tangent(:, 1)
        turned(:, 2) = sense*tangent(:, 2)
    end function forward

end module geom_through_row
