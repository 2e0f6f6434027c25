!> Tests of the entities. Oracle: group codes of Autodesk's "DXF Reference", worked by hand.
program test_dxf_entity
    use base_kinds, only: dp
    use export_drawing, only: contour_type
    use export_dxf_entity, only: on_page, put_light_polyline, put_line, put_point, put_polyline, &
        put_spline, put_words
    use export_dxf_page, only: words_type
    use export_dxf_tag, only: dxf_type
    use cut_plane, only: station_plane
    use support_dxf_pairs, only: numbers_of, pairs_type, read_pairs
    use support_sketch, only: ellipse
    use support_tap, only: tap_type
    implicit none (type, external)
    type(tap_type) :: tap
    real(dp), parameter :: corners(3, 3) = reshape([1.0_dp, 2.0_dp, 3.0_dp, 4.0_dp, 5.0_dp, &
        6.0_dp, 7.0_dp, 8.0_dp, 9.0_dp], [3, 3])

    call check_polyline()
    call check_bulges()
    call check_simple()
    call check_spline()
    call check_words()
    call tap%finish()

contains

    !> Arcs: a half circle to the left, a quarter to the right, a straight piece.
    subroutine check_bulges()
        type(dxf_type) :: old, new
        type(pairs_type) :: pairs
        real(dp), parameter :: bulge(3) = [1.0_dp, -0.41421356237309503_dp, 0.0_dp]

        call put_polyline(old, 'A', corners(:2, :), .true., bulge)
        call read_pairs(old%out%text(), pairs)
        call tap%ok(size(numbers_of(pairs, 'VERTEX', 42)) == 2, 'two of three corners have bulges')
        call tap%near(maxval(abs(numbers_of(pairs, 'VERTEX', 42) - bulge(:2))), 0.0_dp, 0.0_dp, &
            'these')
        new%has_handles = .true.
        call put_light_polyline(new, 'A', corners(:2, :), .true., bulge)
        call read_pairs(new%out%text(), pairs)
        call tap%ok(pairs%entity_count('LWPOLYLINE', 'A') == 1, 'R2000 has an entity for arcs')
        call tap%ok(all(nint(numbers_of(pairs, 'LWPOLYLINE', 90)) == [3]) .and. &
            all(nint(numbers_of(pairs, 'LWPOLYLINE', 70)) == [1]), 'its corners counted, closed')
        call tap%near(maxval(abs(numbers_of(pairs, 'LWPOLYLINE', 10) - corners(1, :))), 0.0_dp, &
            0.0_dp, 'where they are')
        call tap%near(maxval(abs(numbers_of(pairs, 'LWPOLYLINE', 42) - bulge(:2))), 0.0_dp, &
            0.0_dp, 'and their bulges')
    end subroutine check_bulges

    subroutine check_polyline()
        type(dxf_type) :: flat, solid
        type(pairs_type) :: pairs

        call put_polyline(flat, 'A', corners(:2, :), .true.)
        call read_pairs(flat%out%text(), pairs)
        call tap%ok(pairs%entity_count('POLYLINE', 'A') == 1 .and. &
            pairs%entity_count('VERTEX', 'A') == 3 .and. &
            pairs%entity_count('SEQEND', 'A') == 1, 'one polyline, its corners, its end')
        call tap%ok(all(abs(numbers_of(pairs, 'POLYLINE', 70) - [1.0_dp]) <= 0.0_dp), 'closed')
        call tap%ok(all(abs(numbers_of(pairs, 'POLYLINE', 66) - [1.0_dp]) <= 0.0_dp), &
            'it says that corners follow')
        call tap%ok(all(abs(numbers_of(pairs, 'VERTEX', 20) - corners(2, :)) <= 0.0_dp), &
            'its ordinates')
        call tap%ok(size(numbers_of(pairs, 'VERTEX', 70)) == 0, 'corners of the plane: no flag')
        call put_polyline(solid, 'A', corners, .false.)
        call read_pairs(solid%out%text(), pairs)
        call tap%ok(all(abs(numbers_of(pairs, 'POLYLINE', 70) - [8.0_dp]) <= 0.0_dp), &
            'a polyline in space')
        call tap%ok(all(abs(numbers_of(pairs, 'VERTEX', 70) - 32.0_dp) <= 0.0_dp), &
            'corners in space say so')
        call tap%ok(all(abs(numbers_of(pairs, 'VERTEX', 30) - corners(3, :)) <= 0.0_dp), &
            'their heights')
    end subroutine check_polyline

    subroutine check_simple()
        type(dxf_type) :: file
        type(pairs_type) :: pairs
        file%has_handles = .true.
        call put_point(file, 'A', corners(:, 1))
        call put_line(file, 'A', corners(:2, 1), corners(:2, 2))
        call read_pairs(file%out%text(), pairs)
        call tap%ok(all(abs(numbers_of(pairs, 'POINT', 30) - [3.0_dp]) <= 0.0_dp), 'a point')
        call tap%ok(all(abs(numbers_of(pairs, 'LINE', 21) - [5.0_dp]) <= 0.0_dp), 'a line')
        call tap%ok(pairs%find(100, 'AcDbPoint', 1) > 0 .and. pairs%find(100, 'AcDbLine', 1) > 0, &
            'with their classes')
        call tap%ok(all(abs(on_page([1.0_dp, 2.0_dp], .true.) - [1.0_dp, 0.0_dp, 2.0_dp]) <= &
            0.0_dp), 'the page of space is the plane of BL 0')
        call tap%ok(size(on_page([1.0_dp, 2.0_dp], .false.)) == 2, 'else it is the drawing')
    end subroutine check_simple

    subroutine check_spline()
        type(dxf_type) :: file, other
        type(pairs_type) :: pairs
        type(contour_type) :: ring

        ring = ellipse(station_plane(1.0_dp), [0.0_dp, 0.0_dp], [3.0_dp, 2.0_dp])
        file%has_handles = .true.
        call put_spline(file, 'A', ring%curves(1)%spline, [1.0_dp, 0.0_dp, 0.0_dp])
        call read_pairs(file%out%text(), pairs)
        call tap%ok(all(abs(numbers_of(pairs, 'SPLINE', 70) - [12.0_dp]) <= 0.0_dp), &
            'rational and planar')
        call tap%ok(all(nint([numbers_of(pairs, 'SPLINE', 71), numbers_of(pairs, 'SPLINE', 72), &
            numbers_of(pairs, 'SPLINE', 73), numbers_of(pairs, 'SPLINE', 74)]) == [2, 6, 3, 0]), &
            'degree, counts of knots, poles and fit points')
        call tap%ok(all(abs(numbers_of(pairs, 'SPLINE', 40) - ring%curves(1)%spline%knot) <= &
            0.0_dp), 'all knots, the last too')
        call tap%ok(all(abs(numbers_of(pairs, 'SPLINE', 41) - ring%curves(1)%spline%weight) <= &
            0.0_dp), 'all weights, to the last bit')
        call tap%ok(all(abs(numbers_of(pairs, 'SPLINE', 20) - ring%curves(1)%spline%pole(2, :)) <= &
            0.0_dp), 'all poles')
        call tap%ok(all(abs(numbers_of(pairs, 'SPLINE', 210) - [1.0_dp]) <= 0.0_dp), 'its normal')
        ring%curves(1)%spline%weight = 1.0_dp
        ring%curves(1)%spline%pole(:, 3) = ring%curves(1)%spline%pole(:, 1)
        other%has_handles = .true.
        call put_spline(other, 'A', ring%curves(1)%spline, [0.0_dp, 0.0_dp, 0.0_dp])
        call read_pairs(other%out%text(), pairs)
        call tap%ok(all(abs(numbers_of(pairs, 'SPLINE', 70) - [1.0_dp]) <= 0.0_dp), &
            'closed, in no plane, polynomial')
        call tap%ok(size(numbers_of(pairs, 'SPLINE', 41)) == 0 .and. &
            size(numbers_of(pairs, 'SPLINE', 210)) == 0, 'without weights and normal')
    end subroutine check_spline

    subroutine check_words()
        type(dxf_type) :: file, other
        type(pairs_type) :: pairs

        call put_words(file, 'TEXT', words_type([1.0_dp, 2.0_dp], 2, 'CL'), 0.5_dp, .false.)
        call read_pairs(file%out%text(), pairs)
        call tap%same(pairs%text(1, 1), 'CL', 'the words')
        call tap%ok(all(abs(numbers_of(pairs, 'TEXT', 40) - [0.5_dp]) <= 0.0_dp), 'their height')
        call tap%ok(all(nint([numbers_of(pairs, 'TEXT', 72), numbers_of(pairs, 'TEXT', 73)]) == &
            [2, 2]), 'right, half way up')
        call tap%ok(all(abs(numbers_of(pairs, 'TEXT', 21) - [2.0_dp]) <= 0.0_dp), 'their place')
        other%has_handles = .true.
        call put_words(other, 'TEXT', words_type([1.0_dp, 2.0_dp], 0, 'CL'), 0.5_dp, .true.)
        call read_pairs(other%out%text(), pairs)
        call tap%ok(all(nint([numbers_of(pairs, 'TEXT', 210), numbers_of(pairs, 'TEXT', 220), &
            numbers_of(pairs, 'TEXT', 230)]) == [0, -1, 0]), &
            'in space they are read from the port side')
    end subroutine check_words

end program test_dxf_entity
