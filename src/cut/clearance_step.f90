!> One step towards the point of a sheet that is nearest to a box. With r the way from the box to
!> p(u, t), half its square is least where r.dp/du and r.dp/dt are zero. Its second derivatives are
!>
!>     dp/du.dp/du + r.d2p/du2        and so on for u t and t t
!>
!> where the first product counts only the axes along which p is outside of the box: along the
!> others the nearest point of the box goes with p.
module cut_clearance_step
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use cut_measure_sheet, only: spot_type
    implicit none (type, external)
    private

    public :: step_towards

contains

    !> Newton's step of u and t; where the second derivatives do not lead down, one by the tangent
    !> plane. An unknown at a bound that the distance would push it through is held.
    pure function step_towards(spot, way, is_out, can_fall, can_rise) result(step)
        type(spot_type), intent(in) :: spot     !! the skin at the place
        real(dp), intent(in) :: way(3)          !! r
        logical, intent(in) :: is_out(3)        !! the skin is outside of the box along the axis
        logical, intent(in) :: can_fall(2)      !! u, t are above their lower bounds
        logical, intent(in) :: can_rise(2)      !! u, t are below their upper bounds
        real(dp) :: step(2), slope(2), bend(2, 2), plane(2, 2)
        logical :: is_free(2)

        slope = [dot_product(way, spot%u), dot_product(way, spot%t)]
        plane = 0.0_dp
        plane(1, 1) = sum(spot%u**2, mask=is_out)
        plane(2, 2) = sum(spot%t**2, mask=is_out)
        plane(1, 2) = sum(spot%u*spot%t, mask=is_out)
        bend = 0.0_dp
        bend(1, 1) = plane(1, 1) + dot_product(way, spot%uu)
        bend(2, 2) = plane(2, 2) + dot_product(way, spot%tt)
        bend(1, 2) = plane(1, 2) + dot_product(way, spot%ut)
        is_free = merge(can_rise, can_fall, slope < 0.0_dp) .and. (can_rise .or. can_fall)
        step = solved(bend, slope, is_free)
        if (dot_product(step, slope) < 0.0_dp) return
        plane(1, 1) = plane(1, 1) + ulp + abs(dot_product(way, spot%uu))
        plane(2, 2) = plane(2, 2) + ulp + abs(dot_product(way, spot%tt))
        step = solved(plane, slope, is_free)
    end function step_towards

    !> The solution of a symmetric system of two unknowns, of which some are held at zero; zero
    !> where the system is not positive.
    pure function solved(matrix, slope, is_free) result(step)
        real(dp), intent(in) :: matrix(2, 2)    !! its upper triangle counts
        real(dp), intent(in) :: slope(2)        !! right side, with the other sign
        logical, intent(in) :: is_free(2)       !! the unknown is not held
        real(dp) :: step(2), determinant
        integer :: i

        step = 0.0_dp
        if (all(is_free)) then
            determinant = matrix(1, 1)*matrix(2, 2) - matrix(1, 2)**2
            if (matrix(1, 1) > 0.0_dp .and. determinant > ulp*matrix(1, 1)*matrix(2, 2)) then
                step = -[matrix(2, 2)*slope(1) - matrix(1, 2)*slope(2), &
                    matrix(1, 1)*slope(2) - matrix(1, 2)*slope(1)]/determinant
            end if
            return
        end if
        do i = 1, 2
            if (is_free(i) .and. matrix(i, i) > 0.0_dp) step(i) = -slope(i)/matrix(i, i)
        end do
    end function solved

end module cut_clearance_step
