!> Strokes: a conic is itself; a Bezier curve against its own formulas, and against the parabola
!> that both can be.
program test_stroke
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_arc_point, only: curvature, point
    use geom_place, only: at_finish, at_shoulder, at_start, place_at
    use geom_stroke, only: bezier_stroke, conic_stroke, cyclic_stroke, reversed_stroke, &
        stroke_curvature, stroke_part, stroke_place, stroke_point, stroke_tangent, stroke_type
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(stroke_type) :: parabola, conic
    type(arc_type) :: arc
    type(error_type), allocatable :: error

    ! y = x**2 from (1, 1) to (3, 9); the end tangents meet in (2, 3).
    parabola = bezier_stroke(reshape([1.0_dp, 1.0_dp, 2.0_dp, 3.0_dp, 3.0_dp, 9.0_dp], [2, 3]))
    call arc_through(end_type([1.0_dp, 1.0_dp], [1.0_dp, 2.0_dp]), [2.0_dp, 4.0_dp], &
        end_type([3.0_dp, 9.0_dp], [1.0_dp, 6.0_dp]), arc, error)
    conic = conic_stroke(arc)
    call check_parabola(tap)
    call check_vertical(tap)
    call check_inverse(tap)
    call check_cyclic(tap)
    call tap%finish()

contains

    !> The same curve as a polynomial and as a conic.
    subroutine check_parabola(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(stroke_type) :: part
        real(dp) :: along(2)
        integer :: i
        real(dp) :: worst(3), x

        worst = 0.0_dp
        do i = 0, 20
            x = 1.0_dp + 0.1_dp*real(i, dp)
            worst(1) = max(worst(1), norm2(stroke_point(parabola, stroke_place(parabola, x)) &
                - [x, x**2]), norm2(stroke_point(conic, stroke_place(conic, x)) - [x, x**2]))
            along = stroke_tangent(parabola, stroke_place(parabola, x))
            worst(2) = max(worst(2), abs(along(2)/along(1) - 2.0_dp*x))
            worst(3) = max(worst(3), abs(stroke_curvature(parabola, stroke_place(parabola, x)) &
                - 2.0_dp/(1.0_dp + 4.0_dp*x**2)**1.5_dp))
        end do
        call tap%near(worst(1), 0.0_dp, 4.0e-15_dp, 'x**2 as a polynomial and as a conic')
        call tap%near(worst(2), 0.0_dp, 4.0e-15_dp, 'its slope')
        call tap%near(worst(3), 0.0_dp, 1.0e-15_dp, 'its curvature')
        call tap%near(stroke_curvature(conic, at_shoulder), curvature(arc, at_shoulder), 0.0_dp, &
            'a conic has its own curvature')
        call tap%near(norm2(stroke_point(conic, at_shoulder) - point(arc, at_shoulder)), 0.0_dp, &
            0.0_dp, 'and points')
        part = stroke_part(reversed_stroke(parabola), place_at(0.25_dp), at_finish)
        call tap%near(norm2(part%start - [2.5_dp, 6.25_dp]) &
            + norm2(part%finish - [1.0_dp, 1.0_dp]), &
            0.0_dp, 1.0e-15_dp, 'a part of it backwards')
        part = stroke_part(reversed_stroke(conic), place_at(0.25_dp), at_finish)
        call tap%near(norm2(part%start - [2.5_dp, 6.25_dp]), 0.0_dp, 1.0e-15_dp, 'and of the conic')
    end subroutine check_parabola

    !> An end where the curve is vertical, and one where poles are one.
    subroutine check_vertical(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(stroke_type) :: root

        ! y = sqrt(x)
        root = bezier_stroke(reshape([0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 4.0_dp, 2.0_dp], [2, 3]))
        call tap%ok(all(abs(stroke_tangent(root, at_start)*[1.0_dp, 0.0_dp]) <= 0.0_dp), &
            'a vertical tangent is exactly so')
        call tap%near(stroke_curvature(root, at_start), -2.0_dp, 1.0e-15_dp, 'with its curvature')
        call tap%near(norm2(stroke_point(root, stroke_place(root, 1.0e-12_dp)) &
            - [1.0e-12_dp, 1.0e-6_dp]), 0.0_dp, 1.0e-21_dp, 'x beside it gives the root of x')
        root = bezier_stroke(reshape([0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 4.0_dp, 2.0_dp], [2, 3]))
        call tap%ok(all(abs(stroke_tangent(root, at_start) - [4.0_dp, 2.0_dp]) <= 0.0_dp), &
            'where two poles are one the tangent leads to the third')
        call tap%ok(all(stroke_tangent(reversed_stroke(root), at_finish) < 0.0_dp), &
            'backwards it points backwards')
    end subroutine check_vertical

    !> Places of any x on curves of degree 1 to 9.
    subroutine check_inverse(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(random_type) :: random
        type(stroke_type) :: stroke
        real(dp), allocatable :: pole(:, :)
        real(dp) :: at(2), x, worst
        integer :: i, k, degree

        worst = 0.0_dp
        do i = 1, 2000
            degree = 1 + mod(i, 9)
            if (allocated(pole)) deallocate (pole)
            allocate (pole(2, degree + 1))
            pole(:, 1) = [0.0_dp, 1.0_dp]
            do k = 2, degree + 1
                pole(:, k) = [pole(1, k - 1) + random%unit()**4, random%unit()]
            end do
            stroke = bezier_stroke(pole)
            x = random%unit()*stroke%finish(1)
            at = stroke_point(stroke, stroke_place(stroke, x))
            worst = max(worst, abs(at(1) - x)/max(x, 1.0e-300_dp))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-13_dp, 'the place of an x is at that x')
    end subroutine check_inverse

    !> A quarter of a unit circle about (1, 0), as a C-Bezier curve.
    subroutine check_cyclic(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(stroke_type) :: quarter, part
        real(dp) :: k, at(2), x, worst(3)
        integer :: i

        k = 2.0_dp*atan(1.0_dp) - 1.0_dp
        quarter = cyclic_stroke(reshape([0.0_dp, 0.0_dp, 0.0_dp, k, 1.0_dp - k, 1.0_dp, 1.0_dp, &
            1.0_dp], [2, 4]), 2.0_dp*atan(1.0_dp))
        worst = 0.0_dp
        do i = 1, 20
            x = 0.05_dp*real(i, dp)
            at = stroke_point(quarter, stroke_place(quarter, x))
            worst(1) = max(worst(1), norm2(at - [x, sqrt(x*(2.0_dp - x))]))
            worst(2) = max(worst(2), &
                abs(stroke_curvature(quarter, stroke_place(quarter, x)) + 1.0_dp))
            at = stroke_tangent(quarter, stroke_place(quarter, x))
            worst(3) = max(worst(3), abs(at(2) - at(1)*(1.0_dp - x)/sqrt(x*(2.0_dp - x)))/norm2(at))
        end do
        call tap%near(worst(1), 0.0_dp, 3.0e-15_dp, 'a circle as a C-Bezier curve')
        call tap%near(worst(2), 0.0_dp, 1.0e-13_dp, 'its curvature')
        call tap%near(worst(3), 0.0_dp, 1.0e-14_dp, 'its tangent')
        part = stroke_part(reversed_stroke(quarter), place_at(0.5_dp), at_finish)
        call tap%near(norm2(part%start - [1.0_dp - sqrt(0.5_dp), sqrt(0.5_dp)]) &
            + abs(part%alpha - atan(1.0_dp)), 0.0_dp, 2.0e-15_dp, 'half of it backwards')
    end subroutine check_cyclic

end program test_stroke
