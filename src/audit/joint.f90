!> Where two conics of a chain join: the roundest abscissa between the last row of the one and the
!> first of the other at which they differ by less than half a unit of the last place, or where they
!> come nearest to each other.
module audit_joint
    use audit_curve, only: quantity_at, quantity_type
    use audit_fit, only: fit_type
    use audit_reading, only: sort
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: find_joint

    !> Places looked at between two rows, and decimals of the roundest abscissae.
    integer, parameter :: places = 64, most_decimals = 3

contains

    !> The abscissa of a joint.
    pure real(dp) function find_joint(before, after, between, near, unit) result(joint)
        type(fit_type), intent(in) :: before  !! the conic before it
        type(fit_type), intent(in) :: after   !! the conic after it
        real(dp), intent(in) :: between(2)    !! abscissae of the rows beside it
        real(dp), intent(in) :: near          !! ordinate there, roughly
        real(dp), intent(in) :: unit          !! of the last place
        real(dp) :: x, least, gap
        integer :: i, decimals

        joint = 0.5_dp*sum(between)
        least = huge(least)
        do i = 0, places
            x = between(1) + (between(2) - between(1))*real(i, dp)/real(places, dp)
            gap = gap_at(x)
            if (gap >= least) cycle
            least = gap
            joint = x
        end do
        do decimals = 0, most_decimals
            x = anint(joint*10.0_dp**decimals)/10.0_dp**decimals
            if (x < minval(between) .or. x > maxval(between)) cycle
            if (gap_at(x) > max(0.5_dp*unit, least)) cycle
            joint = x
            return
        end do
    contains
        !> How far the conics are apart at an abscissa.
        pure real(dp) function gap_at(at) result(apart)
            real(dp), intent(in) :: at !! abscissa
            type(quantity_type) :: height
            real(dp) :: first, second
            logical :: exists
            apart = huge(apart)
            height = quantity_type(sort=sort%ordinate, along=at, near=near)
            call quantity_at(before%k, before%problem%frame, height, first, exists)
            if (.not. exists) return
            height%near = first
            call quantity_at(after%k, after%problem%frame, height, second, exists)
            if (exists) apart = abs(second - first)
        end function gap_at
    end function find_joint

end module audit_joint
