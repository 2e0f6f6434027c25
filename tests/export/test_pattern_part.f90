!> Tests of contours on paper. The oracle is the circle: the distance of any point of a Bezier arc
!> from it is known.
program test_pattern_part
    use base_kinds, only: dp
    use cut_plane, only: buttock_plane, station_plane, waterline_plane
    use export_drawing, only: shape_type
    use export_pattern_part, only: bezier_points, is_inside_outline, new_part, part_type
    use export_receipt, only: receipt_type
    use support_shapes, only: add_circle, add_path, add_rectangle, new_shape
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call try_circle(1.0e-3_dp)
    call try_circle(1.0e-6_dp)
    call try_half()
    call try_nothing()
    call tap%finish()

contains

    !> A circle of 200 mm around BL 10, WL 50, drawn in inches.
    subroutine try_circle(tolerance)
        real(dp), intent(in) :: tolerance !! mm
        type(shape_type) :: shape
        type(part_type) :: part
        type(receipt_type) :: receipt
        real(dp) :: largest, points(2, 41)
        integer :: i

        shape = new_shape('STA_20', 'STATION 20', station_plane(20.0_dp))
        call add_circle(shape, [10.0_dp, 50.0_dp], 200.0_dp, .false., 0)
        call add_circle(shape, [10.0_dp, 50.0_dp], 190.0_dp, .true., 0)
        call new_part(shape, 1.0_dp/25.4_dp, tolerance, part, receipt)
        largest = 0.0_dp
        associate (control => part%traces(1)%control)
            do i = 4, size(control, 2), 3
                points = 25.4_dp*bezier_points(control(:, i - 3:i), 40)
                largest = max(largest, maxval(abs(norm2(points - spread([10.0_dp, 50.0_dp], 2, &
                    41), dim=1) - 200.0_dp)))
            end do
            call tap%ok(all(abs(control(:, 1) - control(:, size(control, 2))) <= 0.0_dp), &
                'a closed contour ends where it begins')
        end associate
        call tap%ok(largest <= tolerance, 'a circle in mm is within the tolerance, in inches')
        call tap%ok(receipt%entities(1)%error >= largest .and. &
            receipt%entities(1)%error <= tolerance + 3.0e-6_dp, &
            'the receipt states no less, and little more than was asked for')
        call tap%ok(receipt%count == 2 .and. receipt%entities(2)%kind == 'BEZIER INSIDE OF SKIN', &
            'and has the inside')
        call tap%ok(receipt%entities(1)%points == size(part%traces(1)%control, 2), 'and the points')
        associate (entity => receipt%entities(1))
            call tap%ok(entity%has_place .and. abs(entity%worst(1) - 20.0_dp) <= 0.0_dp .and. &
                abs(norm2(entity%worst(2:) - [10.0_dp, 50.0_dp]) - 200.0_dp) < 1.0e-10_dp, &
                'and the place, on the circle')
        end associate
        call tap%ok(part%is_region, 'circles close')
        call tap%ok(all(abs(part%box - ([10.0_dp, 50.0_dp, 10.0_dp, 50.0_dp] + [-200.0_dp, &
            -200.0_dp, 200.0_dp, 200.0_dp])/25.4_dp) < 1.0e-4_dp), 'the box is around them')
        call tap%ok(is_inside_outline(part, [195.0_dp, 0.0_dp]/25.4_dp) .and. &
            .not. is_inside_outline(part, [8.2_dp, 9.0_dp]), &
            'inside of the outline is inside, whatever the skin')
    end subroutine try_circle

    !> A half that BL 0 closes, and one that it does not.
    subroutine try_half()
        type(shape_type) :: shape
        type(part_type) :: part
        type(receipt_type) :: receipt

        shape = new_shape('STA_20', 'STATION 20', station_plane(20.0_dp))
        shape%is_half = .true.
        call add_path(shape, reshape([0.0_dp, -5.0_dp, 8.0_dp, -5.0_dp, 8.0_dp, 5.0_dp, 0.0_dp, &
            5.0_dp], [2, 4]))
        call new_part(shape, 1.0_dp, 1.0e-3_dp, part, receipt)
        call tap%ok(part%is_region .and. part%fold == 1, 'a half of a station is closed by BL 0')
        call tap%ok(is_inside_outline(part, [0.1_dp, 0.0_dp]), 'its inside goes to BL 0')
        call tap%ok(receipt%entities(1)%error < 1.0e-6_dp, &
            'straight lines are exact but for rounding')
        shape = new_shape('WL_0', 'WATERLINE 0', waterline_plane(0.0_dp))
        shape%is_half = .true.
        call add_path(shape, reshape([10.0_dp, 5.0_dp, 30.0_dp, 8.0_dp], [2, 2]))
        call new_part(shape, 1.0_dp, 1.0e-3_dp, part, receipt)
        call tap%ok(part%fold == 2 .and. .not. part%is_region, 'of a waterline BL 0 is level')
        call tap%ok(abs(part%box(2)) <= 0.0_dp, 'and the part goes down to it')
        shape%is_half = .false.
        call new_part(shape, 1.0_dp, 1.0e-3_dp, part, receipt)
        call tap%ok(part%fold == 0 .and. .not. part%is_region, 'a line that is no half is open')
    end subroutine try_half

    !> A shape with a point for a contour.
    subroutine try_nothing()
        type(shape_type) :: shape
        type(part_type) :: part
        type(receipt_type) :: receipt

        shape = new_shape('BL_0', 'BUTT LINE 0', buttock_plane(0.0_dp))
        call add_rectangle(shape, [0.0_dp, 0.0_dp], [1.0_dp, 2.0_dp])
        deallocate (shape%contours(1)%curves)
        allocate (shape%contours(1)%curves(0))
        call new_part(shape, 1.0_dp, 1.0e-3_dp, part, receipt)
        call tap%ok(size(part%traces) == 0 .and. receipt%count == 0, 'a point has no outline')
    end subroutine try_nothing

end program test_pattern_part
