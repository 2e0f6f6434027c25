!> Tests of the triangles between two rows.
program test_mesh_strip
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_mesh, only: mesh_part_type
    use export_mesh_chord, only: new_gauge
    use export_mesh_strip, only: facet_normal, set_edge, strip_type, zip_strip
    use support_bodies, only: ellipsoid
    use support_cylinders, only: cylinders
    use support_laid, only: facing, laid, laid_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(laid_type) :: ball, tube
    type(strip_type) :: strip
    type(error_type), allocatable :: error
    real(dp), parameter :: middle(3) = [50.0_dp, 0.0_dp, 0.0_dp]
    real(dp) :: off
    integer :: i, k, columns

    body = ellipsoid([50.0_dp, 50.0_dp, 50.0_dp], 50.0_dp, 0.0_dp)
    ball = laid(body, 0.5_dp)
    columns = size(ball%plan%columns(1)%share) - 1
    call add_strip(ball, 1, 2)
    call tap%ok(ball%mesh%triangle_count == columns, 'at a tip there is a fan')
    call add_strip(ball, 1, 3)
    call tap%ok(ball%mesh%triangle_count == 3*columns, 'elsewhere two triangles in four corners')
    call add_strip(ball, 2, 3)
    call add_strip(ball, 2, size(ball%rows))
    call tap%ok(ball%mesh%triangle_count == 6*columns, 'at the aft tip a fan again')
    call tap%ok(all([(dot_product(facing(ball%mesh, i), ball%mesh%vertices(:, &
        ball%mesh%triangles(1, i)) - middle) > 0.0_dp, i=1, ball%mesh%triangle_count)]), &
        'all triangles face outward')
    off = 0.0_dp
    do i = 1, ball%mesh%triangle_count
        do k = 1, 3
            off = max(off, norm2(ball%mesh%normals(:, ball%mesh%corners(k, i)) &
                - (ball%mesh%vertices(:, ball%mesh%triangles(k, i)) - middle)/50.0_dp))
        end do
    end do
    call tap%near(off, 0.0_dp, 1.0e-7_dp, 'corners have the normals of the sphere')
    off = 0.0_dp
    do i = 1, ball%mesh%triangle_count
        associate (at => ball%mesh%vertices(:, ball%mesh%triangles(:, i)))
            do k = 1, 3
                off = max(off, 50.0_dp - norm2(0.5_dp*(at(:, k) + at(:, mod(k, 3) + 1)) - middle))
            end do
            off = max(off, 50.0_dp - norm2(sum(at, dim=2)/3.0_dp - middle))
        end associate
    end do
    call tap%near(ball%mesh%parts(1)%error, off, 1.0e-3_dp*off, &
        'the part says how far they are from it')

    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 0.0_dp)
    tube = laid(body, 0.5_dp)
    ! One vertex more on the stop, as a seam may put there.
    associate (strand => tube%rows(1)%strands(1))
        strand%vertex = [strand%vertex(:2), strand%vertex(2:)]
        strand%share = [strand%share(:2), 0.5_dp*(strand%share(2) + strand%share(3)), &
            strand%share(3:)]
        strand%t = strand%share
        strand%vertex(3) = tube%mesh%vertex_count
    end associate
    columns = size(tube%plan%columns(1)%share) - 1
    call add_strip(tube, 1, 2)
    call tap%ok(tube%mesh%triangle_count == 2*columns + 1, 'a vertex more makes a triangle more')
    call tap%ok(count(tube%mesh%triangles(:, :tube%mesh%triangle_count) &
        == tube%mesh%vertex_count) > 1, 'that has its side at it')
    call tap%near(norm2(facet_normal(reshape([0.0_dp, 0.0_dp, 0.0_dp, 2.0_dp, 0.0_dp, 0.0_dp, &
        0.0_dp, 3.0_dp, 0.0_dp], [3, 3])) - [0.0_dp, 0.0_dp, 1.0_dp]), 0.0_dp, 0.0_dp, &
        'a flat normal')
    call tap%near(norm2(facet_normal(reshape([0.0_dp, 0.0_dp, 0.0_dp, 2.0_dp, 0.0_dp, 0.0_dp, &
        3.0_dp, 0.0_dp, 0.0_dp], [3, 3]))), 0.0_dp, 0.0_dp, 'a line has none')
    call tap%finish()

contains

    !> Adds the strip before a row of the first run.
    subroutine add_strip(it, section, row)
        type(laid_type), intent(inout) :: it
        integer, intent(in) :: section, row
        type(mesh_part_type) :: part
        part%name = 'PART'
        if (size(it%mesh%parts) == 0) it%mesh%parts = [part]
        strip%section = section
        call new_gauge(body, section, it%plan%runs(1)%stretch%span, &
            it%plan%runs(1)%u(row - 1:row), strip%gauge, error)
        call set_edge(body, strip, 1, it%rows(row - 1)%strands(section), it%mesh)
        call set_edge(body, strip, 2, it%rows(row)%strands(section), it%mesh)
        call zip_strip(body, strip, it%mesh)
    end subroutine add_strip

end program test_mesh_strip
