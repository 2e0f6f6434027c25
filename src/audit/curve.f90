!> The conic that an audit looks for: six coefficients to a scale, of
!>
!>     A X**2 + B X Y + C Y**2 + D X + E Y + F = 0,    X = (x - x0)/sx,  Y = (y - y0)/sy
!>
!> in coordinates about the middle of the readings and of their size. Everything a figure says of
!> the conic is linear in the coefficients: a curve that passes between (x, low) and (x, high) has
!> different signs there.
module audit_curve
    use audit_reading, only: sort
    use base_constants, only: vertical_slope
    use base_exact, only: is_zero
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: frame_type, quantity_type, monomials, gradient, form_at, roots_of, quantity_at
    public :: general_equation, point_near, side_of

    !> A sort of quantity that no reading is of: an abscissa at which the conic is vertical.
    integer, parameter, public :: extreme = 5

    !> Where the coordinates of a conic have their origin, and their units.
    type :: frame_type
        real(dp) :: origin(2) = 0.0_dp !! x0 and y0, deck units
        real(dp) :: size(2) = 1.0_dp   !! sx and sy, deck units
    end type frame_type

    !> A number that a conic has.
    type :: quantity_type
        integer :: sort = 1          !! one of `sort%...`, or `extreme`
        integer :: letter = 0        !! of a coefficient, 1 to 5 for A to E
        real(dp) :: along = 0.0_dp   !! x, or y of an abscissa, deck units
        real(dp) :: near = 0.0_dp    !! the root nearest to this is meant, deck units
        integer :: side = 0          !! 1 greater, -1 lesser root is meant; 0: the nearest
        real(dp) :: shift = 0.0_dp   !! added to x and y for coefficients, deck units
    end type quantity_type

contains

    !> X**2, X Y, Y**2, X, Y, 1: what the coefficients are multiplied with.
    pure function monomials(frame, x, y) result(m)
        type(frame_type), intent(in) :: frame !! the conic's
        real(dp), intent(in) :: x             !! deck units
        real(dp), intent(in) :: y             !! deck units
        real(dp) :: m(6), p, q
        p = (x - frame%origin(1))/frame%size(1)
        q = (y - frame%origin(2))/frame%size(2)
        m = [p*p, p*q, q*q, p, q, 1.0_dp]
    end function monomials

    !> The derivatives of the monomials by x (axis 1) or y (axis 2), 1/deck units.
    pure function gradient(frame, x, y, axis) result(m)
        type(frame_type), intent(in) :: frame !! the conic's
        real(dp), intent(in) :: x             !! deck units
        real(dp), intent(in) :: y             !! deck units
        integer, intent(in) :: axis           !! 1 or 2
        real(dp) :: m(6), p, q
        p = (x - frame%origin(1))/frame%size(1)
        q = (y - frame%origin(2))/frame%size(2)
        if (axis == 1) then
            m = [2.0_dp*p, q, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp]/frame%size(1)
        else
            m = [0.0_dp, p, 2.0_dp*q, 0.0_dp, 1.0_dp, 0.0_dp]/frame%size(2)
        end if
    end function gradient

    !> The quadratic form of a conic: `a r**2 + b r + c = 0` for the roots r, in units of the frame
    !> from its origin, at an abscissa (axis 2 is sought) or at an ordinate (axis 1).
    pure function form_at(k, frame, along, axis) result(abc)
        real(dp), intent(in) :: k(6)          !! the conic
        type(frame_type), intent(in) :: frame !! its frame
        real(dp), intent(in) :: along         !! x or y, deck units
        integer, intent(in) :: axis           !! which is sought
        real(dp) :: abc(3), p
        p = (along - frame%origin(3 - axis))/frame%size(3 - axis)
        if (axis == 2) then
            abc = [k(3), k(2)*p + k(5), (k(1)*p + k(4))*p + k(6)]
        else
            abc = [k(1), k(2)*p + k(4), (k(3)*p + k(5))*p + k(6)]
        end if
    end function form_at

    !> Both roots at an abscissa or ordinate, the lesser first. Where the conic does not reach it,
    !> or has one root only, `found` is less than 2; a root less than `graze` beyond the extreme of
    !> the conic counts as the extreme.
    pure subroutine roots_of(k, frame, along, axis, roots, found)
        real(dp), intent(in) :: k(6)          !! the conic
        type(frame_type), intent(in) :: frame !! its frame
        real(dp), intent(in) :: along         !! x or y, deck units
        integer, intent(in) :: axis           !! which is sought
        real(dp), intent(out) :: roots(2)     !! deck units
        integer, intent(out) :: found         !! 0, 1 or 2
        real(dp), parameter :: graze = 1.0e-9_dp, least = 1.0e-13_dp
        real(dp) :: abc(3), under, sum

        abc = form_at(k, frame, along, axis)
        roots = 0.0_dp
        found = 0
        if (abs(abc(1)) <= least*maxval(abs(k))) then
            if (abs(abc(2)) <= least*maxval(abs(k))) return
            found = 1
            roots = -abc(3)/abc(2)
        else
            under = abc(2)**2 - 4.0_dp*abc(1)*abc(3)
            if (under < 0.0_dp .and. under > -graze*(abc(2)**2 + abs(4.0_dp*abc(1)*abc(3)))) &
                under = 0.0_dp
            if (under < 0.0_dp) return
            found = 2
            sum = -0.5_dp*(abc(2) + sign(sqrt(under), abc(2)))
            roots = sum/abc(1)
            if (.not. is_zero(sum)) roots(2) = abc(3)/sum
            roots = [minval(roots), maxval(roots)]
        end if
        roots = frame%origin(axis) + frame%size(axis)*roots
    end subroutine roots_of

    !> The value of a quantity. `exists` is false where the conic does not have it.
    pure subroutine quantity_at(k, frame, quantity, value, exists)
        real(dp), intent(in) :: k(6)                !! the conic
        type(frame_type), intent(in) :: frame       !! its frame
        type(quantity_type), intent(in) :: quantity !! which
        real(dp), intent(out) :: value              !! deck units, or their powers
        logical, intent(out) :: exists              !! see above
        real(dp) :: roots(2), whole(6), along(2)
        integer :: found

        value = 0.0_dp
        exists = .false.
        select case (quantity%sort)
        case (extreme)
            call roots_of([k(2)**2 - 4.0_dp*k(1)*k(3), 0.0_dp, 0.0_dp, &
                2.0_dp*(k(2)*k(5) - 2.0_dp*k(3)*k(4)), 0.0_dp, k(5)**2 - 4.0_dp*k(3)*k(6)], &
                frame, frame%origin(2), 1, roots, found)
            exists = found > 0
            value = point_near(roots, quantity)
        case (sort%coefficient)
            whole = general_equation(k, frame, -quantity%shift)
            exists = abs(whole(6)) > 0.0_dp
            if (exists) value = whole(quantity%letter)/whole(6)
        case (sort%abscissa)
            call roots_of(k, frame, quantity%along, 1, roots, found)
            exists = found > 0
            value = point_near(roots, quantity)
        case default
            call roots_of(k, frame, quantity%along, 2, roots, found)
            exists = found > 0
            value = point_near(roots, quantity)
            if (quantity%sort == sort%ordinate .or. .not. exists) return
            along = [dot_product(k, gradient(frame, quantity%along, value, 1)), &
                dot_product(k, gradient(frame, quantity%along, value, 2))]
            value = sign(vertical_slope, -along(1)*along(2))
            if (abs(along(1)) < abs(along(2))*vertical_slope) value = -along(1)/along(2)
        end select
    end subroutine quantity_at

    !> Of two roots the one that is meant.
    pure real(dp) function point_near(roots, quantity) result(value)
        real(dp), intent(in) :: roots(2)            !! the lesser first
        type(quantity_type), intent(in) :: quantity !! which is meant
        value = roots(1)
        select case (quantity%side)
        case (1)
            value = roots(2)
        case (0)
            if (abs(roots(2) - quantity%near) < abs(roots(1) - quantity%near)) value = roots(2)
        end select
    end function point_near

    !> The side of a conic on which an ordinate or abscissa is: 1 the greater root, -1 the lesser, 0
    !> where it has one root, or none, or no side as other sorts of quantity have none.
    pure integer function side_of(k, frame, quantity) result(side)
        real(dp), intent(in) :: k(6)                !! the conic
        type(frame_type), intent(in) :: frame       !! its frame
        type(quantity_type), intent(in) :: quantity !! which
        real(dp) :: roots(2)
        integer :: found

        side = 0
        if (quantity%sort > sort%abscissa) return
        call roots_of(k, frame, quantity%along, merge(1, 2, quantity%sort == sort%abscissa), &
            roots, found)
        if (found == 2) side = merge(1, -1, point_near(roots, quantity) > 0.5_dp*sum(roots))
    end function side_of

    !> The coefficients of the same conic about an origin (at, at) in deck units.
    pure function general_equation(k, frame, at) result(whole)
        real(dp), intent(in) :: k(6)          !! the conic
        type(frame_type), intent(in) :: frame !! its frame
        real(dp), intent(in) :: at            !! x and y of the new origin, deck units
        real(dp) :: whole(6), u, v, s, t

        s = 1.0_dp/frame%size(1)
        t = 1.0_dp/frame%size(2)
        u = (at - frame%origin(1))*s
        v = (at - frame%origin(2))*t
        whole(1) = k(1)*s*s
        whole(2) = k(2)*s*t
        whole(3) = k(3)*t*t
        whole(4) = s*(2.0_dp*k(1)*u + k(2)*v + k(4))
        whole(5) = t*(2.0_dp*k(3)*v + k(2)*u + k(5))
        whole(6) = u*(k(1)*u + k(2)*v + k(4)) + v*(k(3)*v + k(5)) + k(6)
    end function general_equation

end module audit_curve
