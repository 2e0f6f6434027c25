!> To B-splines and back: conics, lines and Bezier curves come home; others are refused.
program test_spline_strokes
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_type, line_between, weight
    use geom_arc_by_circle, only: circle_by_points
    use geom_arc_by_rho, only: arc_by_corner_rho
    use geom_bezier, only: bezier_point
    use geom_bspline, only: bspline_type, spline_point
    use geom_place, only: place_at
    use geom_spline_strokes, only: strokes_of
    use geom_stroke, only: bezier_stroke, conic_stroke, is_straight, stroke_kind, stroke_point, &
        stroke_type
    use geom_stroke_spline, only: stroke_spline
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_conics()
    call check_circle()
    call check_others()
    call tap%finish()

contains

    !> Arcs of all rhos that are one span.
    subroutine check_conics()
        type(random_type) :: random
        type(arc_type) :: arc
        type(stroke_type), allocatable :: back(:)
        type(error_type), allocatable :: error
        real(dp) :: points(2, 3), worst(2), rho
        integer :: i, k

        worst = 0.0_dp
        do i = 1, 500
            do k = 1, 3
                points(:, k) = [10.0_dp*real(k, dp) + random%unit(), &
                    random%between(-9.0_dp, 9.0_dp)]
            end do
            rho = random%between(0.2_dp, 0.9_dp)
            call arc_by_corner_rho(points(:, 1), points(:, 2), rho, points(:, 3), arc, error)
            if (allocated(error)) cycle
            call strokes_of(stroke_spline(conic_stroke(arc)), back, error)
            if (allocated(error) .or. size(back) /= 1) then
                worst = 9.0_dp
                exit
            end if
            worst(1) = max(worst(1), abs(weight(back(1)%arc)/weight(arc) - 1.0_dp))
            do k = 0, 10
                worst(2) = max(worst(2), norm2(stroke_point(back(1), place_at(0.1_dp*real(k, dp))) &
                    - stroke_point(conic_stroke(arc), place_at(0.1_dp*real(k, dp)))))
            end do
        end do
        call tap%near(worst(1), 0.0_dp, 1.0e-13_dp, 'conics come home with their weight')
        call tap%near(worst(2), 0.0_dp, 1.0e-13_dp, 'and their points')
    end subroutine check_conics

    !> Most of a circle, which has several spans.
    subroutine check_circle()
        type(arc_type) :: arc
        type(stroke_type), allocatable :: back(:)
        type(error_type), allocatable :: error
        real(dp) :: worst, at(2)
        integer :: i, k

        call circle_by_points([5.0_dp, 0.0_dp], [-5.0_dp, 0.0_dp], [3.0_dp, -4.0_dp], arc, error)
        call strokes_of(stroke_spline(conic_stroke(arc)), back, error)
        call tap%ok(size(back) > 1 .and. all(back%kind == stroke_kind%conic), &
            'most of a circle comes back in some arcs')
        worst = 0.0_dp
        do i = 1, size(back)
            do k = 0, 10
                at = stroke_point(back(i), place_at(0.1_dp*real(k, dp)))
                worst = max(worst, abs(norm2(at) - 5.0_dp))
            end do
            if (i > 1) worst = max(worst, norm2(back(i)%start - back(i - 1)%finish))
        end do
        call tap%near(worst, 0.0_dp, 4.0e-15_dp, 'of that circle, end to end')
        call tap%ok(all(abs(back(size(back))%finish - [3.0_dp, -4.0_dp]) <= 0.0_dp), 'to its end')
    end subroutine check_circle

    !> Lines, Bezier curves, splines of many spans, rational cubics.
    subroutine check_others()
        type(random_type) :: random
        type(bspline_type) :: spline
        type(stroke_type), allocatable :: back(:)
        type(error_type), allocatable :: error
        real(dp) :: pole(2, 7), worst, t
        integer :: i, k

        call strokes_of(stroke_spline(conic_stroke(line_between([1.0_dp, 2.0_dp], &
            [4.0_dp, 6.0_dp]))), back, error)
        call tap%ok(is_straight(back(1)) .and. all(abs(back(1)%finish - [4.0_dp, 6.0_dp]) &
            <= 0.0_dp), 'a straight line')
        do i = 1, 7
            pole(:, i) = [real(i, dp), random%unit()]
        end do
        call strokes_of(stroke_spline(bezier_stroke(pole)), back, error)
        call tap%ok(back(1)%kind == stroke_kind%bezier .and. size(back) == 1, 'a Bezier curve')
        call tap%near(maxval(abs(back(1)%pole - pole)), 0.0_dp, 0.0_dp, 'to the last bit')
        spline%degree = 3
        spline%knot = [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.2_dp, 0.7_dp, 0.7_dp, 1.0_dp, 1.0_dp, &
            1.0_dp, 1.0_dp]
        spline%pole = pole
        spline%weight = pole(1, :)**0
        call strokes_of(spline, back, error)
        call tap%ok(size(back) == 3, 'a cubic spline of three spans')
        worst = 0.0_dp
        do k = 0, 20
            t = 0.05_dp*real(k, dp)
            worst = max(worst, &
                norm2(bezier_point(back(1)%pole, t) - spline_point(spline, 0.2_dp*t)), &
                norm2(bezier_point(back(2)%pole, t) - spline_point(spline, 0.2_dp + 0.5_dp*t)), &
                norm2(bezier_point(back(3)%pole, t) - spline_point(spline, 0.7_dp + 0.3_dp*t)))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-14_dp, 'is the same in Bezier curves')
        spline%weight(4) = 2.0_dp
        call strokes_of(spline, back, error)
        call tap%ok(allocated(error), 'a rational cubic is refused')
        if (allocated(error)) call tap%ok(error%cause == cause%no_arc, 'as no arc')
    end subroutine check_others

end program test_spline_strokes
