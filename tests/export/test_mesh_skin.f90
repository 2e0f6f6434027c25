!> Tests of the skin of a mesh.
program test_mesh_skin
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_mesh_skin, only: add_skin
    use support_bodies, only: ellipsoid
    use support_cylinders, only: cylinders
    use support_laid, only: area, laid, laid_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(laid_type) :: it
    type(error_type), allocatable :: error
    integer :: i

    body = ellipsoid([50.0_dp, 50.0_dp, 50.0_dp], 50.0_dp, 0.0_dp)
    it = laid(body, 0.01_dp)
    call add_skin(body, it%plan, it%rows, it%mesh, error)
    call tap%ok(.not. allocated(error) .and. size(it%mesh%parts) == 2, 'each section is a part')
    call tap%same(it%mesh%parts(1)%name//it%mesh%parts(2)%name, 'LOWERUPPER', 'by its name')
    call tap%ok(it%mesh%parts(2)%first == it%mesh%parts(1)%last + 1 .and. &
        it%mesh%parts(2)%last == it%mesh%triangle_count, 'its triangles are together')
    call tap%near(area(it%mesh, 1, it%mesh%triangle_count), pi*5000.0_dp, 3.0_dp, &
        'together they have the area of half a sphere')
    call tap%near(it%mesh%error, 0.01_dp, 1.0e-3_dp, 'they are as far from it as planned')
    call tap%near(norm2(it%mesh%worst - [50.0_dp, 0.0_dp, 0.0_dp]), 50.0_dp, 0.02_dp, 'there')

    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 0.0_dp)
    body%sections(3)%is_port = .true.
    it = laid(body, 0.01_dp)
    call add_skin(body, it%plan, it%rows, it%mesh, error)
    call tap%same(it%mesh%parts(3)%name, 'LOA P', 'a port section is named so')
    call tap%near(area(it%mesh, it%mesh%parts(1)%first, it%mesh%parts(1)%last), &
        0.5_dp*pi*2500.0_dp, 2.0_dp, 'a section is made over its own run')
    call tap%ok(all([(maxval(it%mesh%corners(:, i)) <= it%mesh%normal_count .and. &
        minval(it%mesh%corners(:, i)) > 0, i=1, it%mesh%triangle_count)]), &
        'every corner has a normal')
    body%lines(4)%plan%constant = 60.0_dp
    call add_skin(body, it%plan, it%rows, it%mesh, error)
    call tap%ok(allocated(error), 'a section without an arc is told')
    call tap%finish()
end program test_mesh_skin
