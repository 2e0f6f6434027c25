!> Fair parts of a section's arc: a share of 0 is its start, 1 its finish, and equal steps between
!> are equal steps of the conic's own angle. A circle is divided into equal turns, a parabola into
!> equal parts of its parameter; with w the weight of the arc and f its half angle
!>
!>     w = cos f (ellipse) or cosh f (hyperbola)
!>     t = sin(f s)/(sin(f (1 - s)) + sin(f s)),  sinh where w > 1,  s where w = 1
!>
!> where t is the usual parameter of the rational quadratic. All are equal steps of affine arc
!> length; source: W. Blaschke, "Vorlesungen ueber Differentialgeometrie II", Springer 1923, ch. 1.
module export_mesh_share
    use base_exact, only: is_zero
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: parameter_at, pace_at

    !> A weight so near to 1 is that of a parabola: its angle has hardly a digit.
    real(dp), parameter :: parabolic = 1.0e-12_dp

contains

    !> The parameter of an arc at a share, 0 to 1.
    elemental real(dp) function parameter_at(share, weight) result(t)
        real(dp), intent(in) :: share   !! 0 to 1
        real(dp), intent(in) :: weight  !! of the arc, above -1
        real(dp) :: before, after

        call ways(share, weight, before, after)
        t = after/(before + after)
    end function parameter_at

    !> dt/ds at a share.
    elemental real(dp) function pace_at(share, weight) result(pace)
        real(dp), intent(in) :: share   !! 0 to 1
        real(dp), intent(in) :: weight  !! of the arc, above -1
        real(dp) :: before, after, angle

        call ways(share, weight, before, after)
        pace = 1.0_dp
        angle = half_angle(weight)
        if (is_zero(angle)) return
        if (weight < 1.0_dp) pace = angle*sin(angle)/(before + after)**2
        if (weight > 1.0_dp) pace = angle*sinh(angle)/(before + after)**2
    end function pace_at

    !> The sines of the formula: of the way done, `after`, and of the way to come, `before`.
    elemental subroutine ways(share, weight, before, after)
        real(dp), intent(in) :: share       !! 0 to 1
        real(dp), intent(in) :: weight      !! of the arc, above -1
        real(dp), intent(out) :: before     !! 0 at the finish
        real(dp), intent(out) :: after      !! 0 at the start
        real(dp) :: angle

        before = 1.0_dp - share
        after = share
        angle = half_angle(weight)
        if (is_zero(angle)) return
        if (weight < 1.0_dp) then
            before = sin(angle*before)
            after = sin(angle*after)
        else
            before = sinh(angle*before)
            after = sinh(angle*after)
        end if
    end subroutine ways

    !> The half angle of a weight; 0 for a parabola.
    elemental real(dp) function half_angle(weight) result(angle)
        real(dp), intent(in) :: weight !! above -1
        angle = 0.0_dp
        if (abs(weight - 1.0_dp) <= parabolic) return
        if (weight < 1.0_dp) angle = acos(max(weight, -1.0_dp))
        if (weight > 1.0_dp) angle = acosh(weight)
    end function half_angle

end module export_mesh_share
