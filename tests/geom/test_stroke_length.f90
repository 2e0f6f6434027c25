!> Lengths of strokes of all kinds in closed form, and places at equal lengths.
program test_stroke_length
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_place, only: place_type
    use geom_stroke, only: bezier_stroke, conic_stroke, cyclic_stroke, stroke_point, stroke_type
    use geom_stroke_length, only: stroke_length, stroke_places
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc
    type(error_type), allocatable :: error
    real(dp) :: length, quarter, k, whole

    ! y = x**2 from (1, 1) to (3, 9), as a polynomial and as a conic; a quarter of a circle.
    whole = arc_of_square(3.0_dp) - arc_of_square(1.0_dp)
    call arc_through(end_type([1.0_dp, 1.0_dp], [1.0_dp, 2.0_dp]), [2.0_dp, 4.0_dp], &
        end_type([3.0_dp, 9.0_dp], [1.0_dp, 6.0_dp]), arc, error)
    quarter = 2.0_dp*atan(1.0_dp)
    k = quarter - 1.0_dp
    call check(bezier_stroke(reshape([1.0_dp, 1.0_dp, 2.0_dp, 3.0_dp, 3.0_dp, 9.0_dp], [2, 3])), &
        'a parabola as a polynomial')
    call check(conic_stroke(arc), 'as a conic')
    call stroke_length(cyclic_stroke(reshape([0.0_dp, 0.0_dp, 0.0_dp, k, 1.0_dp - k, 1.0_dp, &
        1.0_dp, 1.0_dp], [2, 4]), quarter), length, error)
    call tap%near(length, quarter, 1.0e-10_dp, 'a quarter of a circle as a C-Bezier curve')
    call tap%finish()

contains

    !> The length of the parabola and its nine places.
    subroutine check(stroke, name)
        type(stroke_type), intent(in) :: stroke     !! from (1, 1) to (3, 9)
        character(*), intent(in) :: name            !! the check as a phrase
        type(place_type), allocatable :: places(:)
        real(dp) :: at(2), worst
        integer :: i

        call stroke_length(stroke, length, error)
        call tap%near(length, whole, 1.0e-10_dp, 'the length of '//name)
        call stroke_places(stroke, 9, places, error)
        worst = 0.0_dp
        do i = 1, 9
            at = stroke_point(stroke, places(i))
            worst = max(worst, abs(arc_of_square(at(1)) - arc_of_square(1.0_dp) &
                - whole*real(i - 1, dp)/8.0_dp))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-4_dp, 'places at equal lengths of '//name)
    end subroutine check

    !> The length of y = x**2 from 0.
    pure real(dp) function arc_of_square(x) result(length)
        real(dp), intent(in) :: x !! where to
        length = 0.5_dp*x*sqrt(1.0_dp + 4.0_dp*x**2) + 0.25_dp*asinh(2.0_dp*x)
    end function arc_of_square

end program test_stroke_length
