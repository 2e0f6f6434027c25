!> Tests of shapes in DXF files. Oracles: circle and ellipse in closed form.
program test_dxf_shape
    use base_error, only: error_type
    use base_kinds, only: dp
    use cut_plane, only: plane_through
    use export_drawing, only: shape_kind, shape_type
    use export_dxf_shape, only: in_drawing, pen_type, put_shape
    use export_dxf_tag, only: dxf_type
    use export_receipt, only: receipt_type
    use support_dxf_pairs, only: numbers_of, pairs_type, read_pairs
    use support_sketch, only: add_contour, ellipse, new_shape, segment
    use support_tap, only: tap_type
    implicit none (type, external)
    real(dp), parameter :: tolerance = 1.0e-3_dp
    type(pen_type), parameter :: pen = pen_type('CUT', 'CUT-IN', .false., .false., &
        tolerance)
    type(tap_type) :: tap

    call check_old()
    call check_new()
    call check_arcs(.false.)
    call check_arcs(.true.)
    call check_space()
    call check_points()
    call tap%finish()

contains

    !> A ring of radius 10 with an inside of radius 9, centre at BL 1, WL 5.
    subroutine ring(shape)
        type(shape_type), intent(out) :: shape !! at station 20
        shape = new_shape('STA-20', 20.0_dp)
        call add_contour(shape, ellipse(shape%plane, [1.0_dp, 5.0_dp], [10.0_dp, 10.0_dp]))
        call add_contour(shape, ellipse(shape%plane, [1.0_dp, 5.0_dp], [9.0_dp, 9.0_dp]))
        shape%contours(2)%is_inside = .true.
    end subroutine ring

    subroutine check_old()
        type(shape_type) :: shape
        type(dxf_type) :: file
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        type(pairs_type) :: pairs
        real(dp), allocatable :: radius(:)

        call ring(shape)
        call put_shape(file, shape, pen, receipt, error)
        call tap%ok(.not. allocated(error), 'a ring is put into R12')
        call read_pairs(file%out%text(), pairs)
        call tap%ok(pairs%entity_count('POLYLINE', 'CUT') == 1 .and. &
            pairs%entity_count('POLYLINE', 'CUT-IN') == 1, &
            'one polyline on the layer of each side of the skin')
        call tap%ok(pairs%entity_count('LINE', '') == 0, 'and no line')
        allocate (radius, source=sqrt((numbers_of(pairs, 'VERTEX', 10) - 1.0_dp)**2 + &
            (numbers_of(pairs, 'VERTEX', 20) - 5.0_dp)**2))
        call tap%ok(all(min(abs(radius - 10.0_dp), abs(radius - 9.0_dp)) < 1.0e-4_dp), &
            'corners are on the circles, rounded')
        call tap%ok(receipt%count == 2, 'two entities in the receipt')
        call tap%ok(all(receipt%entities(:2)%error <= tolerance) .and. &
            all(receipt%entities(:2)%error > 0.5_dp*tolerance), &
            'which are within the tolerance, and use it')
        call tap%ok(sum(receipt%entities(:2)%points) == size(radius), 'their corners')
        call tap%same(receipt%entities(1)%kind, 'CLOSED POLYLINE', 'their kind')
        call tap%same(receipt%entities(2)%kind, 'CLOSED POLYLINE INSIDE', 'and of which side')
        call tap%ok(all(.not. receipt%entities(:2)%is_exact), 'they are not exact')
    end subroutine check_old

    !> The ring as arcs: four quarter circles each; and a shape in space, which stays without.
    subroutine check_arcs(is_new)
        logical, intent(in) :: is_new !! R2000
        type(shape_type) :: shape
        type(dxf_type) :: file, space
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        type(pairs_type) :: pairs
        real(dp), allocatable :: bulge(:)
        character(:), allocatable :: entity, corner

        call ring(shape)
        shape%arcs = 0.01_dp
        file%has_handles = is_new
        entity = trim(merge('LWPOLYLINE', 'POLYLINE  ', is_new))
        corner = trim(merge('LWPOLYLINE', 'VERTEX    ', is_new))
        call put_shape(file, shape, pen, receipt, error)
        call tap%ok(.not. allocated(error), entity//': a ring is put as arcs')
        call read_pairs(file%out%text(), pairs)
        call tap%ok(pairs%entity_count(entity, 'CUT') == 1 .and. &
            pairs%entity_count(entity, 'CUT-IN') == 1, 'one on the layer of each side of the skin')
        allocate (bulge, source=numbers_of(pairs, corner, 42))
        call tap%ok(size(bulge) == 8, 'four arcs for each circle')
        call tap%near(maxval(abs(bulge - tan(atan(1.0_dp)/2.0_dp))), 0.0_dp, 1.0e-12_dp, &
            'each a quarter to the left')
        call tap%same(receipt%entities(2)%kind, 'CLOSED '//entity//' ARCS INSIDE', 'what it is')
        call tap%ok(receipt%entities(1)%points == 4 .and. receipt%entities(1)%spans == 4, &
            'points and arcs are counted')
        call tap%ok(receipt%entities(1)%error <= 0.01_dp, 'within the tolerance of the arcs')
        space%has_handles = is_new
        call put_shape(space, shape, pen_type('CUT', 'CUT-IN', .false., .true., tolerance), &
            receipt, error)
        call read_pairs(space%out%text(), pairs)
        call tap%ok(size(numbers_of(pairs, corner, 42)) == 0, 'in space there are no bulges')
    end subroutine check_arcs

    subroutine check_new()
        type(shape_type) :: shape
        type(dxf_type) :: file
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        type(pairs_type) :: pairs

        call ring(shape)
        call add_contour(shape, segment([20.0_dp, 0.0_dp, 5.0_dp], [20.0_dp, 3.0_dp, 5.0_dp]))
        file%has_handles = .true.
        call put_shape(file, shape, pen, receipt, error)
        call read_pairs(file%out%text(), pairs)
        call tap%ok(pairs%entity_count('SPLINE', 'CUT') == 4 .and. &
            pairs%entity_count('SPLINE', 'CUT-IN') == 4, 'a spline for each conic in R2000')
        call tap%ok(pairs%entity_count('LINE', 'CUT') == 1, 'a line where one is straight')
        call tap%ok(maxval(numbers_of(pairs, 'SPLINE', 20)) - 15.0_dp <= 0.0_dp .and. &
            maxval(numbers_of(pairs, 'SPLINE', 10)) - 11.0_dp <= 0.0_dp, &
            'poles in the plane of the cut')
        call tap%ok(receipt%count == 9 .and. all(receipt%entities(:9)%is_exact), 'all exact')
        call tap%same(receipt%entities(1)%name, 'STA-20 RING', 'named after cut and section')
        call tap%same(receipt%entities(1)%kind, 'RATIONAL SPLINE', 'and what they are')
        call tap%same(receipt%entities(9)%kind, 'LINE', 'a line is one')
        call tap%ok(receipt%entities(1)%points == 3 .and. receipt%entities(1)%spans == 1, &
            'poles and spans')
    end subroutine check_new

    subroutine check_space()
        type(shape_type) :: shape
        type(pen_type) :: solid
        type(dxf_type) :: file, new
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        type(pairs_type) :: pairs
        real(dp), allocatable :: x(:), y(:), z(:)
        real(dp), parameter :: normal(3) = [1.0_dp, 2.0_dp, 2.0_dp]

        shape = new_shape('P', 0.0_dp)
        shape%kind = shape_kind%plane
        call plane_through([3.0_dp, 1.0_dp, -2.0_dp], normal, shape%plane, error)
        call add_contour(shape, ellipse(shape%plane, [0.0_dp, 0.0_dp], [7.0_dp, 7.0_dp]))
        solid = pen
        solid%is_in_space = .true.
        call put_shape(file, shape, solid, receipt, error)
        call read_pairs(file%out%text(), pairs)
        allocate (x, source=numbers_of(pairs, 'VERTEX', 10) - 3.0_dp)
        allocate (y, source=numbers_of(pairs, 'VERTEX', 20) - 1.0_dp)
        allocate (z, source=numbers_of(pairs, 'VERTEX', 30) + 2.0_dp)
        call tap%ok(all(abs(x + 2.0_dp*y + 2.0_dp*z) < 3.0e-4_dp), 'in space it is in its plane')
        call tap%ok(all(abs(sqrt(x**2 + y**2 + z**2) - 7.0_dp) < 1.0e-4_dp), 'and on its circle')
        call tap%near(maxval(abs(in_drawing(shape, reshape(shape%plane%origin, [3, 1]), &
            .false.))), 0.0_dp, 1.0e-15_dp, 'in the plane its origin is zero')
        new%has_handles = .true.
        call put_shape(new, shape, solid, receipt, error)
        call read_pairs(new%out%text(), pairs)
        call tap%ok(all(abs(numbers_of(pairs, 'SPLINE', 210) - 1.0_dp/3.0_dp) < 1.0e-15_dp) .and. &
            all(abs(numbers_of(pairs, 'SPLINE', 230) - 2.0_dp/3.0_dp) < 1.0e-15_dp), &
            'splines have the normal of the cut')
        shape%kind = shape_kind%line
        call put_shape(new, shape, solid, receipt, error)
        call read_pairs(new%out%text(), pairs)
        call tap%ok(size(numbers_of(pairs, 'SPLINE', 210)) == 4, 'a control line has none')
    end subroutine check_space

    subroutine check_points()
        type(shape_type) :: shape
        type(dxf_type) :: old, new
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        type(pairs_type) :: pairs

        shape = new_shape('STA-0', 0.0_dp)
        call add_contour(shape, segment([0.0_dp, 1.0_dp, 2.0_dp], [0.0_dp, 1.0_dp, 2.0_dp]))
        call put_shape(old, shape, pen, receipt, error)
        call read_pairs(old%out%text(), pairs)
        call tap%ok(pairs%entity_count('POINT', 'CUT') == 1, 'a section that is a point, in R12')
        new%has_handles = .true.
        call put_shape(new, shape, pen, receipt, error)
        call read_pairs(new%out%text(), pairs)
        call tap%ok(pairs%entity_count('POINT', 'CUT') == 1, 'and in R2000')
        call tap%same(receipt%entities(1)%kind//receipt%entities(2)%kind, 'POINTPOINT', &
            'the receipt calls it so')
        shape%contours(1)%curves(1)%error = 1.0_dp
        shape%contours(1)%curves(1)%spline%pole(2, 2) = 9.0_dp
        call put_shape(old, shape, pen, receipt, error)
        call tap%ok(allocated(error), 'curves that are too far off are refused')
        deallocate (shape%contours(1)%curves)
        allocate (shape%contours(1)%curves(0))
        shape%contours(1)%at = [0.0_dp, 7.0_dp, 8.0_dp]
        call put_shape(new, shape, pen, receipt, error)
        call read_pairs(new%out%text(), pairs)
        call tap%ok(pairs%entity_count('POINT', 'CUT') == 2 .and. &
            abs(maxval(numbers_of(pairs, 'POINT', 20)) - 8.0_dp) <= 0.0_dp, &
            'a contour without curves is a point too')
    end subroutine check_points

end program test_dxf_shape
