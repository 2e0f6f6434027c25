!> What a reading asks of a conic: a quantity of it lies between two values, or is one exactly.
!>
!> Between two values is two inequalities, linear in the coefficients k of the conic: for an
!> ordinate from l to h at x, with F(x, y) = m(x, y) . k growing in y there,
!>
!>     m(x, h) . k >= 0 >= m(x, l) . k
!>
!> and the same with the other sign where F falls. Both are scaled to units of the last place.
module audit_condition
    use audit_curve, only: extreme, form_at, frame_type, general_equation, gradient, monomials, &
        quantity_at, quantity_type
    use audit_figure, only: form, scale_type, unit_of, value_of
    use audit_printing, only: allowed, printing
    use audit_reading, only: meaning, reading_type, sort
    use audit_root, only: root_room
    use base_constants, only: vertical_slope
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: condition_type, new_condition, takes_part, exact_row, residual, bound_rows

    !> What a reading asks.
    type :: condition_type
        type(quantity_type) :: quantity        !! of what
        real(dp) :: centre = 0.0_dp            !! what is printed
        real(dp) :: low = 0.0_dp               !! least value
        real(dp) :: high = 0.0_dp              !! greatest value
        real(dp) :: unit = 1.0_dp              !! of the last place
        real(dp) :: point(2) = 0.0_dp          !! of a slope: where, when the point is known
        logical :: has_point = .false.         !! of a slope: the point is known
        logical :: is_of_1970 = .false.        !! its roots were drawn in single precision
        integer :: reading = 0                 !! which reading says so
    end type condition_type

    !> Half the room that a number known exactly is given, where it is one condition among others,
    !> and what doubles may leave of a bound: units of the last place.
    real(dp), parameter :: exact_room = 1.0e-6_dp, noise = 1.0e-7_dp
    !> The least growth of a form over a unit of the last place, relative: where a conic is just not
    !> reached, or nearly vertical, units say nothing.
    real(dp), parameter :: flat = 1.0e-9_dp
    !> Half the room of the abscissa of a vertical tangent: that of 999.999 instead of infinity.
    real(dp), parameter :: vertical_room = 5.0e-5_dp

contains

    !> True for a reading that is evidence: sound, to the places of its table, or not of the table.
    pure logical function takes_part(reading, scale)
        type(reading_type), intent(in) :: reading !! any
        type(scale_type), intent(in) :: scale     !! of the table
        takes_part = reading%figure%is_sound .or. reading%meaning == meaning%between
        if (reading%meaning /= meaning%printed .or. .not. takes_part) return
        takes_part = reading%sort >= sort%slope .or. &
            reading%figure%scale%decimals == scale%decimals .or. scale%form == form%eighths
    end function takes_part

    !> The condition of a reading that takes part.
    pure type(condition_type) function new_condition(reading, way, shift) result(condition)
        type(reading_type), intent(in) :: reading !! any
        integer, intent(in) :: way                !! one of `printing%...`
        real(dp), intent(in) :: shift             !! of the coefficients, deck units
        real(dp) :: between(2)
        integer :: how

        condition%quantity = quantity_type(sort=reading%sort, letter=reading%letter, &
            along=reading%along, shift=shift)
        how = way
        if (reading%meaning /= meaning%printed .or. reading%sort >= sort%slope) &
            how = printing%rounded
        condition%unit = unit_of(reading%figure%scale)
        condition%centre = value_of(reading%figure%units, reading%figure%scale)
        select case (reading%meaning)
        case (meaning%between)
            between = [reading%low, reading%high]
            condition%centre = 0.5_dp*sum(between)
            condition%unit = max(reading%high - reading%low, tiny(1.0_dp))
        case (meaning%exact)
            between = condition%centre + [-exact_room, exact_room]*condition%unit
            condition%is_of_1970 = way == printing%of_1970 .and. reading%sort == sort%slope
        case default
            between = allowed(reading%figure%units, reading%figure%scale, how)
            condition%is_of_1970 = how == printing%of_1970
        end select
        condition%low = between(1)
        condition%high = between(2)
        condition%quantity%near = condition%centre
    end function new_condition

    !> The equation `row . k = 0` of a condition met exactly at its centre. A vertical slope of a
    !> table of 1970 is the number punched for it.
    pure function exact_row(condition, frame) result(row)
        type(condition_type), intent(in) :: condition !! an ordinate, abscissa or slope
        type(frame_type), intent(in) :: frame         !! of the conic
        real(dp) :: row(6)
        associate (x => condition%quantity%along, v => condition%centre, p => condition%point)
            select case (condition%quantity%sort)
            case (sort%ordinate)
                row = monomials(frame, x, v)
            case (sort%abscissa)
                row = monomials(frame, v, x)
            case default
                row = gradient(frame, p(1), p(2), 1) + v*gradient(frame, p(1), p(2), 2)
                if (abs(v) >= vertical_slope .and. .not. condition%is_of_1970) &
                    row = gradient(frame, p(1), p(2), 2)
            end select
        end associate
        row = row/norm2(row)
    end function exact_row

    !> How far a conic is from the centre of a condition and how far outside of its bounds (negative
    !> inside), in units of the last place. `exists` is false where the conic has no such quantity.
    pure recursive subroutine residual(condition, k, frame, off, excess, exists)
        type(condition_type), intent(in) :: condition !! any
        real(dp), intent(in) :: k(6)                  !! the conic
        type(frame_type), intent(in) :: frame         !! its frame
        real(dp), intent(out) :: off                  !! see above
        real(dp), intent(out) :: excess               !! see above
        logical, intent(out) :: exists                !! see above
        real(dp) :: value, slope(2)

        if (is_loose_vertical(condition)) then
            call residual(as_extreme(condition), k, frame, off, excess, exists)
            return
        else if (condition%has_point) then
            slope = [dot_product(k, gradient(frame, condition%point(1), condition%point(2), 1)), &
                dot_product(k, gradient(frame, condition%point(1), condition%point(2), 2))]
            exists = abs(slope(1)) < vertical_slope*abs(slope(2))
            value = 0.0_dp
            if (exists) value = -slope(1)/slope(2)
        else
            call quantity_at(k, frame, condition%quantity, value, exists)
        end if
        off = (value - condition%centre)/condition%unit
        excess = max(value - condition%high, condition%low - value)/condition%unit
    end subroutine residual

    !> The two inequalities `row . k >= 0` of a condition near a conic, see above.
    pure recursive subroutine bound_rows(condition, k, frame, rows)
        type(condition_type), intent(in) :: condition !! any
        real(dp), intent(in) :: k(6)                  !! the conic
        type(frame_type), intent(in) :: frame         !! its frame
        real(dp), intent(out) :: rows(6, 2)           !! for the least and for the greatest value
        real(dp) :: steep, slope

        if (is_loose_vertical(condition)) then
            call bound_rows(as_extreme(condition), k, frame, rows)
            return
        end if
        select case (condition%quantity%sort)
        case (sort%ordinate)
            call point_rows(condition, k, frame, 2, rows, slope)
        case (sort%abscissa)
            call point_rows(condition, k, frame, 1, rows, slope)
        case (sort%slope)
            if (condition%has_point) then
                call slope_rows(condition, k, frame, rows, slope)
            else
                call loose_rows(condition, k, frame, rows, slope)
            end if
        case (extreme)
            call loose_rows(condition, k, frame, rows, slope)
        case default
            call coefficient_rows(condition, k, frame, rows, slope)
        end select
        steep = max(abs(slope)*condition%unit, dot_product(rows(:, 2) - rows(:, 1), k)* &
            sign(1.0_dp, slope)*condition%unit/(condition%high - condition%low), &
            flat*norm2(rows(:, 2)))
        rows(:, 1) = -sign(1.0_dp, slope)*rows(:, 1)/steep
        rows(:, 2) = sign(1.0_dp, slope)*rows(:, 2)/steep
        rows = rows + noise*spread(k, 2, 2)
    end subroutine bound_rows

    !> F at the least and at the greatest point, and its derivative at the conic.
    pure subroutine point_rows(condition, k, frame, axis, rows, slope)
        type(condition_type), intent(in) :: condition !! an ordinate or an abscissa
        real(dp), intent(in) :: k(6)                  !! the conic
        type(frame_type), intent(in) :: frame         !! its frame
        integer, intent(in) :: axis                   !! of its value
        real(dp), intent(out) :: rows(6, 2)           !! see above
        real(dp), intent(out) :: slope                !! dF by the value
        real(dp) :: abc(3), low, high, under, chord

        abc = form_at(k, frame, condition%quantity%along, axis)
        under = sqrt(max(abc(2)**2 - 4.0_dp*abc(1)*abc(3), 0.0_dp))
        chord = (condition%centre - frame%origin(axis))/frame%size(axis)
        slope = sign(under, 2.0_dp*abc(1)*chord + abc(2))/frame%size(axis)
        low = condition%low
        high = condition%high
        if (condition%is_of_1970) then
            chord = root_room(k, frame, condition%quantity, condition%unit)
            low = low + min(-chord, 0.0_dp)
            high = high + max(-chord, 0.0_dp)
        end if
        if (axis == 2) then
            rows(:, 1) = monomials(frame, condition%quantity%along, low)
            rows(:, 2) = monomials(frame, condition%quantity%along, high)
        else
            rows(:, 1) = monomials(frame, low, condition%quantity%along)
            rows(:, 2) = monomials(frame, high, condition%quantity%along)
        end if
    end subroutine point_rows

    !> Fx + s Fy at the point of a slope for the least and the greatest slope s, and Fy.
    pure subroutine slope_rows(condition, k, frame, rows, slope)
        type(condition_type), intent(in) :: condition !! a slope with its point
        real(dp), intent(in) :: k(6)                  !! the conic
        type(frame_type), intent(in) :: frame         !! its frame
        real(dp), intent(out) :: rows(6, 2)           !! see above
        real(dp), intent(out) :: slope                !! Fy
        associate (at => condition%point)
            rows(:, 1) = gradient(frame, at(1), at(2), 1) + &
                condition%low*gradient(frame, at(1), at(2), 2)
            rows(:, 2) = gradient(frame, at(1), at(2), 1) + &
                condition%high*gradient(frame, at(1), at(2), 2)
            slope = dot_product(k, gradient(frame, at(1), at(2), 2))
        end associate
    end subroutine slope_rows

    !> The bounds less a quantity v that is not linear in the coefficients, near a conic k0, whose
    !> length does not change it: (bound - v(k0)) k0 - dv/dk.
    pure subroutine loose_rows(condition, k, frame, rows, slope)
        type(condition_type), intent(in) :: condition !! any
        real(dp), intent(in) :: k(6)                  !! the conic
        type(frame_type), intent(in) :: frame         !! its frame
        real(dp), intent(out) :: rows(6, 2)           !! see above
        real(dp), intent(out) :: slope                !! 1
        real(dp), parameter :: step = 1.0e-6_dp
        real(dp) :: value, side(2), growth(6), tried(6)
        logical :: exists
        integer :: i, j

        do i = 1, 6
            do j = 1, 2
                tried = k
                tried(i) = tried(i) + real(2*j - 3, dp)*step
                call quantity_at(tried, frame, condition%quantity, side(j), exists)
            end do
            growth(i) = (side(2) - side(1))/(2.0_dp*step)
        end do
        call quantity_at(k, frame, condition%quantity, value, exists)
        rows(:, 1) = (condition%low - value)*k - growth
        rows(:, 2) = (condition%high - value)*k - growth
        slope = 1.0_dp
    end subroutine loose_rows

    !> True for a vertical slope whose point is not known.
    pure logical function is_loose_vertical(condition) result(is_loose)
        type(condition_type), intent(in) :: condition !! any
        is_loose = condition%quantity%sort == sort%slope .and. .not. condition%has_point .and. &
            abs(condition%centre) >= vertical_slope
    end function is_loose_vertical

    !> A vertical slope as what it is where its point is not known: the extreme of the conic is at
    !> its abscissa.
    pure type(condition_type) function as_extreme(condition) result(same)
        type(condition_type), intent(in) :: condition !! a vertical slope
        same = condition
        same%quantity%sort = extreme
        same%quantity%near = condition%quantity%along
        same%quantity%side = 0
        same%centre = condition%quantity%along
        same%low = same%centre - vertical_room
        same%high = same%centre + vertical_room
    end function as_extreme

    !> The coefficient less its least and its greatest share of the constant term, and that term.
    pure subroutine coefficient_rows(condition, k, frame, rows, slope)
        type(condition_type), intent(in) :: condition !! a coefficient
        real(dp), intent(in) :: k(6)                  !! the conic
        type(frame_type), intent(in) :: frame         !! its frame
        real(dp), intent(out) :: rows(6, 2)           !! see above
        real(dp), intent(out) :: slope                !! the constant term, turned about
        real(dp) :: unit(6), whole(6)
        integer :: i

        do i = 1, 6
            unit = 0.0_dp
            unit(i) = 1.0_dp
            whole = general_equation(unit, frame, -condition%quantity%shift)
            rows(i, 1) = condition%low*whole(6) - whole(condition%quantity%letter)
            rows(i, 2) = condition%high*whole(6) - whole(condition%quantity%letter)
        end do
        whole = general_equation(k, frame, -condition%quantity%shift)
        slope = whole(6)
    end subroutine coefficient_rows

end module audit_condition
