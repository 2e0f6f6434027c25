!> Tangents and figures of a picture.
program test_marks
    use base_error, only: error_type
    use base_kinds, only: dp
    use export_marks, only: figure_type, point_figures, stroke_type, tangent_strokes
    use export_picture, only: curve_type, picture_type
    use geom_arc, only: arc_through, direction_of_slope, end_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call try_tangents()
    call try_figures()
    call try_nose()
    call try_neighbour()
    call try_crowd()
    call tap%finish()

contains

    !> A quarter ellipse with half axes a (level) and b, from its lowest point to its right one; the
    !> middle at (0, y).
    type(curve_type) function quarter(a, b, y) result(curve)
        real(dp), intent(in) :: a !! half the width
        real(dp), intent(in) :: b !! half the height
        real(dp), intent(in) :: y !! where the middle is
        type(error_type), allocatable :: error
        curve%name = 'quarter'
        curve%point = reshape([0.0_dp, y - b, 0.6_dp*a, y - 0.8_dp*b, a, y], [2, 3])
        call arc_through(end_type(curve%point(:, 1), direction_of_slope(0.0_dp)), &
            curve%point(:, 2), end_type(curve%point(:, 3), direction_of_slope(-999.999_dp)), &
            curve%arc, error)
        if (allocated(error)) call tap%ok(.false., error%message)
    end function quarter

    subroutine try_tangents()
        type(stroke_type) :: strokes(2)

        strokes = tangent_strokes(quarter(1.0_dp, 1.0_dp, 0.0_dp), 100.0_dp)
        call tap%near(norm2(strokes(1)%from - [-5.0_dp, -1.0_dp]), 0.0_dp, 1.0e-14_dp, &
            'the tangent of point 1 begins a twentieth of the span behind it')
        call tap%near(norm2(strokes(1)%to - [5.0_dp, -1.0_dp]), 0.0_dp, 1.0e-14_dp, &
            'and ends as far before it')
        call tap%near(norm2(strokes(2)%from - [1.0_dp, -5.0_dp]), 0.0_dp, 1.0e-14_dp, &
            'the vertical tangent of point 3 is vertical')
        call tap%near(norm2(strokes(2)%to - [1.0_dp, 5.0_dp]), 0.0_dp, 1.0e-14_dp, &
            'and runs forward, whatever the sign of the slope')
    end subroutine try_tangents

    subroutine try_figures()
        type(picture_type) :: picture
        type(figure_type), allocatable :: figures(:)

        call picture%add(quarter(10.0_dp, 10.0_dp, 0.0_dp))
        allocate (figures, source=point_figures(picture, 10.0_dp))
        call tap%ok(size(figures) == 3, 'a curve has three figures')
        if (size(figures) /= 3) return
        call tap%ok(all(figures%number == [1, 2, 3]), 'which are 1, 2 and 3')
        call tap%ok(figures(1)%at(1) < 0.0_dp .and. abs(figures(1)%at(2) + 10.0_dp) < 1.0e-12_dp, &
            '1 stands behind point 1, in line with the tangent')
        call tap%ok(figures(3)%at(2) > 0.0_dp .and. abs(figures(3)%at(1) - 10.0_dp) < 1.0e-12_dp, &
            '3 stands beyond point 3')
        call tap%ok(norm2(figures(2)%at) > 10.0_dp, '2 stands outside the bow')
    end subroutine try_figures

    !> Lines that begin in one point, as in a nose.
    subroutine try_nose()
        type(picture_type) :: picture
        type(figure_type), allocatable :: figures(:)

        call picture%add(quarter(10.0_dp, 10.0_dp, 0.0_dp))
        call picture%add(quarter(20.0_dp, 10.0_dp, 0.0_dp))
        allocate (figures, source=point_figures(picture, 20.0_dp))
        call tap%ok(count(figures%number == 1) == 1, 'points 1 in one place have one figure')
        call tap%ok(count(figures%number == 2) == 2 .and. count(figures%number == 3) == 2, &
            'points apart have their own')
    end subroutine try_nose

    !> A second curve just where the figure 2 of the first would stand: .025 of the span outside.
    subroutine try_neighbour()
        type(picture_type) :: picture
        type(figure_type), allocatable :: figures(:)

        call picture%add(quarter(10.0_dp, 10.0_dp, 0.0_dp))
        call picture%add(quarter(10.25_dp, 10.25_dp, 0.0_dp))
        allocate (figures, source=point_figures(picture, 10.0_dp))
        call tap%ok(any(figures%number == 2 .and. &
            hypot(figures(:)%at(1), figures(:)%at(2)) < 10.0_dp), &
            'a figure that a curve would strike out stands inside')
    end subroutine try_neighbour

    subroutine try_crowd()
        type(picture_type) :: picture
        integer :: i

        do i = 1, 120
            call picture%add(quarter(real(i, dp), real(i, dp), 0.0_dp))
        end do
        call tap%ok(size(point_figures(picture, 120.0_dp)) > 0, '120 curves have figures')
        call picture%add(quarter(121.0_dp, 121.0_dp, 0.0_dp))
        call tap%ok(size(point_figures(picture, 121.0_dp)) == 0, 'more curves have none')
    end subroutine try_crowd

end program test_marks
