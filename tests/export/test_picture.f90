!> Pictures and their frames.
program test_picture
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use export_picture, only: curve_type, frame_of, frame_type, picture_type
    use geom_arc, only: arc_through, end_type, line_between
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call try_order()
    call try_frame()
    call try_level_line()
    call try_bulge()
    call tap%finish()

contains

    !> A straight curve.
    type(curve_type) function straight(name, from, to) result(curve)
        character(*), intent(in) :: name !! its name
        real(dp), intent(in) :: from(2)  !! point 1
        real(dp), intent(in) :: to(2)    !! point 3
        curve%name = name
        curve%arc = line_between(from, to)
        curve%point = reshape([from, 0.5_dp*(from + to), to], [2, 3])
    end function straight

    subroutine try_order()
        type(picture_type) :: picture
        integer :: i
        logical :: in_order

        do i = 1, 30
            call picture%add(straight(to_text(i), [0.0_dp, 0.0_dp], [real(i, dp), 1.0_dp]))
        end do
        in_order = picture%count == 30
        do i = 1, 30
            in_order = in_order .and. picture%curve(i)%name == to_text(i) .and. &
                allocated(picture%curve(i)%line)
        end do
        call tap%ok(in_order, 'thirty curves stay in the order they were added')
    end subroutine try_order

    subroutine try_frame()
        type(picture_type) :: picture
        type(frame_type) :: frame

        call picture%add(straight('a', [-30.0_dp, -10.0_dp], [50.0_dp, -4.0_dp]))
        call picture%add(straight('b', [-30.0_dp, -10.0_dp], [50.0_dp, -24.0_dp]))
        frame = frame_of(picture)
        call tap%near(frame%span, 80.0_dp, 1.0e-12_dp, 'the span is the largest extent')
        call tap%near(frame%low(1), -38.0_dp, 1.0e-12_dp, 'a tenth of it is free to the left')
        call tap%near(frame%high(1), 58.0_dp, 1.0e-12_dp, 'to the right')
        call tap%near(frame%low(2), -32.0_dp, 1.0e-12_dp, 'below')
        call tap%near(frame%high(2), 4.0_dp, 1.0e-12_dp, 'and above')
    end subroutine try_frame

    subroutine try_level_line()
        type(picture_type) :: picture
        type(frame_type) :: frame

        call picture%add(straight('level', [0.0_dp, 5.0_dp], [10.0_dp, 5.0_dp]))
        frame = frame_of(picture)
        call tap%near(frame%high(2) - frame%low(2), 3.6_dp, 1.0e-12_dp, &
            'the frame of a level line has three tenths of its width as height')
        call tap%near(0.5_dp*(frame%high(2) + frame%low(2)), 5.0_dp, 1.0e-12_dp, &
            'with the line in the middle')
    end subroutine try_level_line

    !> A half circle between (-1, 0) and (1, 0), drawn by its left and right points' tangents only.
    subroutine try_bulge()
        type(picture_type) :: picture
        type(curve_type) :: curve
        type(frame_type) :: frame
        type(error_type), allocatable :: error

        curve%name = 'half circle'
        curve%point = reshape([-1.0_dp, 0.0_dp, 0.6_dp, 0.8_dp, 1.0_dp, 0.0_dp], [2, 3])
        call arc_through(end_type(curve%point(:, 1), [0.0_dp, 1.0_dp]), curve%point(:, 2), &
            end_type(curve%point(:, 3), [0.0_dp, 1.0_dp]), curve%arc, error)
        call tap%ok(.not. allocated(error), 'the half circle exists')
        call picture%add(curve)
        frame = frame_of(picture)
        call tap%near(frame%high(2), 1.2_dp, 1.0e-3_dp, &
            'the frame holds what is higher than the three points')
    end subroutine try_bulge

end program test_picture
