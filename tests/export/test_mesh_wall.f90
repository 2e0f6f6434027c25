!> Tests of walls in BL 0, and of why a body does not close.
program test_mesh_wall
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use export_mesh_edge, only: find_twins
    use export_mesh_skin, only: add_skin
    use export_mesh_wall, only: add_walls, why_not_closed
    use support_bodies, only: nose_of_the_book
    use support_cylinders, only: cylinders
    use support_laid, only: area, facing, laid, laid_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(laid_type) :: it
    type(error_type), allocatable :: error
    real(dp) :: normal(3)
    integer :: i, parts

    body = cylinders([50.0_dp, 40.0_dp], [30.0_dp, 25.0_dp], 0.0_dp)
    it = laid(body, 0.1_dp)
    call tap%same(why_not_closed(body, it%plan), '', 'a body that is closed is')
    call add_walls(body, it%plan, it%rows, it%mesh)
    call tap%ok(size(it%mesh%parts) == 0, 'a symmetric body has no walls')
    body%is_symmetric = .false.
    call add_skin(body, it%plan, it%rows, it%mesh, error)
    parts = size(it%mesh%parts)
    call add_walls(body, it%plan, it%rows, it%mesh)
    call tap%ok(size(it%mesh%parts) == parts + 1, 'one side of a body has')
    associate (part => it%mesh%parts(parts + 1))
        call tap%same(part%name, 'WALL BL 0', 'which have a name')
        call tap%near(area(it%mesh, part%first, part%last), 6500.0_dp, 1.0e-9_dp, &
            'their area is that of the strip between the centre lines')
        normal = 0.0_dp
        do i = part%first, part%last
            normal = normal + facing(it%mesh, i)
        end do
        call tap%near(normal(2), -13000.0_dp, 1.0e-9_dp, 'they face to port')
        call tap%near(it%mesh%normals(2, it%mesh%corners(1, part%last)), -1.0_dp, 0.0_dp, &
            'and so do their normals')
    end associate
    call tap%ok(all([(is_at_end(i), i=1, 3*it%mesh%triangle_count)] .or. find_twins(it%mesh) > 0), &
        'only the ends are open then')

    body = mirrored_body(cylinders([50.0_dp, 40.0_dp], [30.0_dp, 25.0_dp], 0.0_dp))
    it = laid(body, 0.1_dp)
    call add_walls(body, it%plan, it%rows, it%mesh)
    call tap%ok(size(it%mesh%parts) == 0, 'sections that go round need no wall')
    body%is_closed = .false.
    call tap%same(why_not_closed(body, it%plan), '', 'nor that the deck says CLOSE')
    body = cylinders([50.0_dp, 40.0_dp], [30.0_dp, 25.0_dp], 0.0_dp)
    body%is_closed = .false.
    it = laid(body, 0.1_dp)
    call tap%has(why_not_closed(body, it%plan), 'does not say CLOSE', 'halves do')
    body = nose_of_the_book()
    it = laid(body, 0.1_dp)
    call tap%has(why_not_closed(body, it%plan), 'the section is open at BL', &
        'a section that ends beside BL 0 is open')
    call tap%finish()

contains

    !> True for half an edge in the plane of a stop.
    logical function is_at_end(number)
        integer, intent(in) :: number
        real(dp) :: sta(3)
        integer :: k
        k = mod(number - 1, 3)
        sta = it%mesh%vertices(1, it%mesh%triangles(:, (number - 1)/3 + 1))
        is_at_end = abs(sta(k + 1) - sta(mod(k + 1, 3) + 1)) <= 0.0_dp .and. &
            any(abs(sta(k + 1) - [0.0_dp, 50.0_dp, 100.0_dp]) <= 0.0_dp)
    end function is_at_end

end program test_mesh_wall
