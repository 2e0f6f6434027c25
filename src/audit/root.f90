!> The ordinates that the 1970 program worked out of a conic: its square root took and gave numbers
!> in single precision, 6 hexadecimal figures cut off, so that they are up to some 2E-5 out. All
!> else was done to 14 figures, which is exact here.
!>
!> With A to E of the conic about an origin moved by the shift, G = (A X X + D X) + 1, H = B X + E:
!>
!>     Y = (-H + R)/(2 C), (-H - R)/(2 C),     R = SQRT(ABS(H H - 4 C G))
!>
!> Source: SAE 700202, appendix A; the precision as its printed tables show it.
module audit_root
    use audit_curve, only: frame_type, general_equation, point_near, quantity_at, quantity_type, &
        roots_of
    use audit_reading, only: sort
    use base_exact, only: is_zero
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: root_room, root_of_1970, short

contains

    !> How much the root may have been drawn towards the other one: signed, deck units. No more than
    !> a tenth of a unit of the last place: where it is more, nothing could be told from the table.
    pure real(dp) function root_room(k, frame, quantity, unit) result(room)
        real(dp), intent(in) :: k(6)                !! the conic
        type(frame_type), intent(in) :: frame       !! its frame
        type(quantity_type), intent(in) :: quantity !! an ordinate or an abscissa
        real(dp), intent(in) :: unit                !! of the last place, deck units
        real(dp), parameter :: short_root = 1.5_dp*2.0_dp**(-20), most = 0.1_dp
        real(dp) :: roots(2)
        integer :: found

        room = 0.0_dp
        if (quantity%sort > sort%abscissa) return
        call roots_of(k, frame, quantity%along, merge(1, 2, quantity%sort == sort%abscissa), &
            roots, found)
        if (found < 2) return
        room = min(0.5_dp*short_root*(roots(2) - roots(1)), most*unit)
        if (point_near(roots, quantity) > 0.5_dp*sum(roots)) room = -room
    end function root_room

    !> The ordinate or abscissa as the program worked it, before .0005 is added; the exact one where
    !> that is not near it.
    pure real(dp) function root_of_1970(k, frame, quantity, unit) result(root)
        real(dp), intent(in) :: k(6)                !! the conic
        type(frame_type), intent(in) :: frame       !! its frame
        type(quantity_type), intent(in) :: quantity !! an ordinate or an abscissa
        real(dp), intent(in) :: unit                !! of the last place, deck units
        real(dp) :: whole(6), x, g, h, r, both(2)
        logical :: exists

        call quantity_at(k, frame, quantity, root, exists)
        if (.not. exists .or. quantity%sort > sort%abscissa) return
        whole = general_equation(k, frame, -quantity%shift)
        if (is_zero(whole(6))) return
        whole = whole/whole(6)
        if (quantity%sort == sort%abscissa) whole([1, 3, 4, 5]) = whole([3, 1, 5, 4])
        if (is_zero(whole(3))) return
        x = quantity%along + quantity%shift
        g = (whole(1)*(x*x) + whole(4)*x) + 1.0_dp
        h = whole(2)*x + whole(5)
        r = short(sqrt(short(abs(h*h - (4.0_dp*whole(3))*g))))
        both = [-h + r, -h - r]/(2.0_dp*whole(3)) - quantity%shift
        if (abs(both(2) - root) < abs(both(1) - root)) both = both([2, 1])
        if (abs(both(1) - root) < unit) root = both(1)
    end function root_of_1970

    !> A number cut off to 6 hexadecimal figures.
    elemental real(dp) function short(x)
        real(dp), intent(in) :: x !! not negative
        integer :: power
        short = 0.0_dp
        if (is_zero(x)) return
        power = 4*ceiling(0.25_dp*real(exponent(x), dp)) - 24
        short = scale(aint(scale(x, -power)), power)
    end function short

end module audit_root
