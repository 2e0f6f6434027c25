!> Tests of reference lines. Lines of a circle have half-chords of sqrt(r**2 - d**2); every point of
!> a line has its ordinate in space.
program test_pattern_grid
    use base_error, only: error_type
    use base_kinds, only: dp
    use cut_plane, only: buttock_plane, in_space, oblique_plane, plane_through, plane_type, &
        station_plane, waterline_plane
    use export_drawing, only: shape_kind, shape_type
    use export_pattern_grid, only: axis_name, chords_of, families_of, family_type, name_of, &
        round_step
    use export_pattern_part, only: new_part, part_type
    use export_receipt, only: receipt_type
    use support_shapes, only: add_circle, add_path, new_shape
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(family_type) :: families(2)
    type(part_type) :: part
    type(plane_type) :: plane
    type(error_type), allocatable :: error

    call tap%ok(abs(round_step(7.0_dp) - 5.0_dp) < 1.0e-12_dp .and. &
        abs(round_step(4.99_dp) - 2.0_dp) < 1.0e-12_dp .and. &
        abs(round_step(1.0_dp) - 1.0_dp) < 1.0e-12_dp, 'steps are 1, 2 or 5')
    call tap%ok(abs(round_step(0.3_dp) - 0.2_dp) < 1.0e-12_dp .and. &
        abs(round_step(999.0_dp) - 500.0_dp) < 1.0e-12_dp .and. &
        abs(round_step(1000.0_dp) - 1000.0_dp) < 1.0e-12_dp, 'of any power of ten')

    call part_of(station_plane(20.0_dp), part)
    families = families_of(station_plane(20.0_dp), shape_kind%station, part)
    call tap%ok(all(families%axis == [2, 3]), 'a station has butt lines and waterlines')
    call tap%ok(all(abs(families%step - 5.0_dp) < 1.0e-12_dp), 'every 5 on 20 inches')
    call tap%same(name_of(families(1), 1), 'BL 5 STBD', 'butt lines say their side')
    call tap%same(name_of(families(1), -2), 'BL 10 PORT', 'in words')
    call tap%same(name_of(families(2), -1), 'WL -5', 'waterlines their sign')
    call tap%same(axis_name(family_type(1))//axis_name(family_type(1, .true.))// &
        axis_name(family_type(3, .true.)), 'STAXY', 'cards have X and Y')
    call try_chords(station_plane(20.0_dp), 'station')
    call try_chords(buttock_plane(4.0_dp), 'buttock')
    call try_chords(waterline_plane(-3.0_dp), 'waterline')
    call oblique_plane([40.0_dp, -24.0_dp], [50.0_dp, 24.0_dp], plane, error)
    families = families_of(plane, shape_kind%oblique, part)
    call tap%ok(all(families%axis == [2, 3]), 'a steep oblique plane has waterlines')
    call try_chords(plane, 'steep plane')
    call oblique_plane([40.0_dp, 0.0_dp], [90.0_dp, 4.0_dp], plane, error)
    families = families_of(plane, shape_kind%oblique, part)
    call tap%ok(all(families%axis == [2, 1]), 'a flat one has stations')
    call try_chords(plane, 'flat plane')
    call plane_through([104.0_dp, 1.0_dp, 2.0_dp], [1.0_dp, 0.3_dp, -0.4_dp], plane, error)
    call try_chords(plane, 'plane canted both ways')
    families = families_of(buttock_plane(0.0_dp), shape_kind%card, part)
    call tap%same(name_of(families(1), 2)//name_of(families(2), 2), 'Y 10X 10', &
        'a card of 1970 has x and y')
    call try_open()
    call tap%finish()

contains

    !> A circle of 10 in around (3, 4) in a plane.
    subroutine part_of(plane, part)
        type(plane_type), intent(in) :: plane   !! its plane
        type(part_type), intent(out) :: part    !! with outlines
        type(shape_type) :: shape
        type(receipt_type) :: receipt

        shape = new_shape('S', 'S', plane)
        call add_circle(shape, [3.0_dp, 4.0_dp], 10.0_dp, .false., 0)
        call new_part(shape, 1.0_dp, 1.0e-6_dp, part, receipt)
    end subroutine part_of

    !> Checks all lines of both families.
    subroutine try_chords(plane, name)
        type(plane_type), intent(in) :: plane   !! any
        character(*), intent(in) :: name        !! of it
        type(part_type) :: part
        type(family_type) :: families(2)
        real(dp), allocatable :: chords(:, :)
        real(dp) :: along(2), foot(2), at(3), distance, half, worst(2)
        integer :: i, k, e, count

        call part_of(plane, part)
        families = families_of(plane, plane%kind, part)
        worst = 0.0_dp
        count = 0
        do k = 1, 2
            do i = families(k)%first, families(k)%last
                call chords_of(part, families(k), i, along, foot, chords)
                count = count + size(chords, 2)
                if (size(chords, 2) /= 1) cycle
                distance = along(1)*(4.0_dp - foot(2)) - along(2)*(3.0_dp - foot(1))
                half = sqrt(max(0.0_dp, 100.0_dp - distance**2))
                worst(1) = max(worst(1), abs(chords(2, 1) - chords(1, 1) - 2.0_dp*half))
                do e = 1, 2
                    at = in_space(plane, foot + chords(e, 1)*along)
                    worst(2) = max(worst(2), abs(at(families(k)%axis) - &
                        real(i, dp)*families(k)%step))
                end do
            end do
        end do
        call tap%ok(count >= 6 .and. count <= 24, name//': not too few lines, not too many')
        call tap%ok(worst(1) < 0.05_dp, name//': lines go from edge to edge')
        call tap%ok(worst(2) < 1.0e-12_dp, name//': each at its ordinate')
    end subroutine try_chords

    !> Lines of what does not close.
    subroutine try_open()
        type(shape_type) :: shape
        type(part_type) :: part
        type(receipt_type) :: receipt
        type(family_type) :: families(2)
        real(dp), allocatable :: chords(:, :)
        real(dp) :: along(2), foot(2)

        shape = new_shape('WL_0', 'WATERLINE 0', waterline_plane(0.0_dp))
        call add_path(shape, reshape([0.0_dp, 8.0_dp, 40.0_dp, 10.0_dp], [2, 2]))
        call add_path(shape, reshape([0.0_dp, -8.0_dp, 40.0_dp, -10.0_dp], [2, 2]))
        call new_part(shape, 1.0_dp, 1.0e-3_dp, part, receipt)
        families = families_of(shape%plane, shape%kind, part)
        call chords_of(part, families(2), 2, along, foot, chords)
        call tap%ok(families(2)%axis == 1 .and. size(chords, 2) == 1 .and. &
            all(abs(chords(:, 1) - [-9.0_dp, 9.0_dp]) < 1.0e-9_dp), &
            'a station of a floor goes from side to side')
        call chords_of(part, families(1), 0, along, foot, chords)
        call tap%ok(all(abs(chords(:, 1) - [0.0_dp, 40.0_dp]) < 1.0e-9_dp), &
            'the butt line that crosses nothing goes all along')
        shape%contours = shape%contours(:1)
        shape%is_half = .true.
        call new_part(shape, 1.0_dp, 1.0e-3_dp, part, receipt)
        call chords_of(part, families(2), 2, along, foot, chords)
        call tap%ok(all(abs(chords(:, 1) - [0.0_dp, 9.0_dp]) < 1.0e-9_dp), &
            'of a half it goes to the fold')

        shape = new_shape('STA_0', 'STATION 0', station_plane(0.0_dp))
        call add_path(shape, reshape([-9.0_dp, 12.0_dp, -5.0_dp, 0.0_dp, 5.0_dp, 0.0_dp, 9.0_dp, &
            12.0_dp], [2, 4]))
        call new_part(shape, 1.0_dp, 1.0e-3_dp, part, receipt)
        families = families_of(shape%plane, shape%kind, part)
        families(1)%step = 8.0_dp
        call chords_of(part, families(1), 1, along, foot, chords)
        call tap%ok(all(abs(chords(:, 1) - [9.0_dp, 12.0_dp]) < 1.0e-9_dp), &
            'a butt line of a trough goes from its side to the open top')
        families(1)%step = 0.5_dp
        call chords_of(part, families(1), 1, along, foot, chords)
        call tap%ok(all(abs(chords(:, 1) - [0.0_dp, 12.0_dp]) < 1.0e-9_dp), 'or from its bottom')
        call tap%ok(families(2)%first == 1, 'the waterline of its bottom edge is not drawn')

        shape = new_shape('STA_0', 'STATION 0', station_plane(0.0_dp))
        call add_path(shape, reshape([-9.0_dp, 0.0_dp, 9.0_dp, 0.0_dp], [2, 2]))
        call new_part(shape, 1.0_dp, 1.0e-3_dp, part, receipt)
        families = families_of(shape%plane, shape%kind, part)
        call tap%ok(families(2)%last == families(2)%first - 1, 'a straight strip has no line along')
    end subroutine try_open

end program test_pattern_grid
