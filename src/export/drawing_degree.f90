!> Lines of high degree in files: CAD readers are sure of splines to degree 9 or so, and a BEZIER
!> line may have 25. Above 9 a line is written with the degree that it has in truth, where it was
!> only raised, or in pieces of degree 5 that keep within the tolerance.
module export_drawing_degree
    use base_kinds, only: dp
    use base_tolerances, only: agreement_ulps, ulp
    use geom_bspline, only: bspline_type
    use geom_lowering, only: bezier_unraised, lower_spline, lowered_apart
    implicit none (type, external)
    private

    public :: limit_degree

    !> The highest degree that is written, and that of the pieces of what is higher.
    integer, parameter, public :: most_degree = 9
    integer, parameter :: piece_degree = 5

contains

    !> Gives a spline of too high a degree one that can be read.
    pure subroutine limit_degree(spline, tolerance, apart)
        type(bspline_type), intent(inout) :: spline     !! where above `most_degree`, of one span
        real(dp), intent(in) :: tolerance               !! largest distance, deck units
        real(dp), intent(out) :: apart                  !! at most so far off; 0: the same
        type(bspline_type) :: lower
        logical :: is_same

        apart = 0.0_dp
        if (spline%degree <= most_degree) return
        call lower_same(spline, is_same)
        if (is_same) return
        call lower_spline(spline, piece_degree, tolerance, lower, apart)
        spline = lower
    end subroutine limit_degree

    !> Lowers a spline to the least degree in which it is the same curve, if that is not above
    !> `most_degree`.
    pure subroutine lower_same(spline, is_same)
        type(bspline_type), intent(inout) :: spline     !! of one span; as it was where not the same
        logical, intent(out) :: is_same                 !! there is such a degree
        real(dp), allocatable :: pole(:, :), lower(:, :)
        integer :: count

        allocate (pole, source=spline%pole)
        do while (size(pole, 2) > 2)
            allocate (lower, source=bezier_unraised(pole))
            if (lowered_apart(spline%pole, lower) > &
                agreement_ulps*ulp*maxval(abs(spline%pole))) exit
            call move_alloc(lower, pole)
        end do
        count = size(pole, 2)
        is_same = count <= most_degree + 1
        if (.not. is_same) return
        spline%degree = count - 1
        call move_alloc(pole, spline%pole)
        spline%weight = spline%weight(:count)
        deallocate (spline%knot)
        allocate (spline%knot(2*count))
        spline%knot(:count) = 0.0_dp
        spline%knot(count + 1:) = 1.0_dp
    end subroutine lower_same

end module export_drawing_degree
