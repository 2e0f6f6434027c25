!> Tests of the vertices of a mesh.
program test_mesh_row
    use base_error, only: error_type
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use body_body, only: body_type, finish_body
    use export_mesh, only: mesh_type
    use export_mesh_density, only: density_type, find_density
    use export_mesh_plan, only: new_plan, plan_type
    use export_mesh_row, only: first_row, lay_vertices, row_type
    use geom_chain, only: chain_type
    use support_bodies, only: constant_view, control_line, ellipsoid, level, plain_section, &
        straight_view, upright
    use support_cylinders, only: cylinders
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(density_type) :: density
    type(plan_type) :: plan
    type(row_type), allocatable :: rows(:)
    type(mesh_type) :: mesh, other
    type(error_type), allocatable :: error
    integer :: last, n

    body = ellipsoid([100.0_dp, 60.0_dp, 50.0_dp], 120.0_dp, 30.0_dp)
    call find_density(body, density, error)
    call new_plan(density, 0.5_dp, 20.0_dp, .true., plan, error)
    call lay_vertices(body, plan, rows, mesh, error)
    last = size(rows)
    call tap%ok(last == size(plan%runs(1)%u), 'a row for each station')
    call tap%ok(size(rows(1)%strands(1)%vertex) == 1, 'at its tip the section is one vertex')
    call tap%ok(rows(1)%strands(1)%vertex(1) == rows(1)%strands(2)%vertex(1), &
        'the same for both sections')
    associate (lower => rows(5)%strands(1), upper => rows(5)%strands(2))
        n = size(lower%vertex)
        call tap%ok(n == size(plan%columns(1)%share), 'elsewhere one for each share')
        call tap%ok(lower%vertex(n) == upper%vertex(1), 'sections share the vertex where they meet')
        call tap%ok(size(rows(5)%ends%vertex) == 3, 'a row knows its control lines')
        call tap%ok(is_zero(mesh%vertices(2, lower%vertex(1))) .and. &
            is_zero(mesh%vertices(2, upper%vertex(size(upper%vertex)))), 'two of them in BL 0')
        call tap%near(mesh%vertices(1, lower%vertex(3)), rows(5)%sta, 0.0_dp, &
            'vertices are at the station')
    end associate
    call tap%ok(mesh%vertex_count == (last - 2)*(n + size(rows(5)%strands(2)%vertex) - 1) + 2, &
        'no vertex is there twice')
    associate (at => mesh%vertices(:, :mesh%vertex_count))
        call tap%near(maxval(abs(((at(1, :) - 120.0_dp)/100.0_dp)**2 + (at(2, :)/60.0_dp)**2 &
            + ((at(3, :) - 30.0_dp)/50.0_dp)**2 - 1.0_dp)), 0.0_dp, 1.0e-14_dp, &
            'all are on the ellipsoid')
    end associate

    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 0.0_dp)
    ! A start that misses BL 0 and an end that misses its neighbour, both by 1e-5 of 50.
    body%lines(1)%has_plan = .true.
    body%lines(1)%plan%is_constant = .true.
    body%lines(1)%plan%constant = 1.0e-5_dp
    call find_density(body, density, error)
    call new_plan(density, 0.5_dp, 20.0_dp, .true., plan, error)
    call lay_vertices(body, plan, rows, other, error)
    call tap%ok(size(rows) == 5 .and. first_row(plan, 2) == 3 .and. first_row(plan, 3) == 5, &
        'runs share the row between them')
    call tap%ok(allocated(rows(2)%strands(1)%vertex) .and. &
        .not. allocated(rows(2)%strands(3)%vertex), 'a row has the sections of its run')
    call tap%ok(allocated(rows(3)%strands(1)%vertex) .and. &
        allocated(rows(3)%strands(3)%vertex), 'a row at a stop those of both')
    call tap%ok(is_zero(other%vertices(2, rows(1)%strands(1)%vertex(1))), &
        'an end that nearly is at BL 0 is there')
    body%lines(1)%plan%constant = 1.0e-3_dp
    call lay_vertices(body, plan, rows, mesh, error)
    call tap%near(mesh%vertices(2, rows(1)%strands(1)%vertex(1)), 1.0e-3_dp, 0.0_dp, &
        'one that is not stays where it is')
    body%lines(4)%plan%constant = 60.0_dp
    call lay_vertices(body, plan, rows, mesh, error)
    call tap%ok(allocated(error), 'a section without an arc is told')

    ! A stem: at station 0 the section is upright in BL 0. All sections are one, but for their
    ! breadth, so that each share has its WL.
    body = wedge()
    call find_density(body, density, error)
    call new_plan(density, 0.05_dp, 20.0_dp, .true., plan, error)
    call lay_vertices(body, plan, rows, mesh, error)
    call tap%ok(.not. allocated(error), 'a section may shrink to a line')
    associate (stem => rows(1)%strands(1)%vertex, next => rows(2)%strands(1)%vertex)
        call tap%near(maxval(abs(mesh%vertices(3, stem) - mesh%vertices(3, next))), 0.0_dp, &
            1.0e-9_dp, 'its vertices are where those of the next row lead to')
        call tap%near(maxval(abs(mesh%vertices(2, stem))), 0.0_dp, 0.0_dp, 'in BL 0')
        call tap%ok(all(mesh%vertices(3, stem(2:)) > mesh%vertices(3, stem(:size(stem) - 1))), &
            'in order')
    end associate
    call tap%finish()

contains

    !> A body of one section from WL 0 to 20 and from BL 0 to a quarter of the station.
    function wedge() result(body)
        type(body_type) :: body
        type(chain_type) :: none
        allocate (body%lines(0), body%sections(0))
        body%lines = [control_line('KEEL', constant_view(0.0_dp), none), &
            control_line('BILGE', constant_view(5.0_dp), &
            straight_view([0.0_dp, 0.0_dp], [40.0_dp, 8.0_dp])), &
            control_line('SHEER', constant_view(20.0_dp), &
            straight_view([0.0_dp, 0.0_dp], [40.0_dp, 10.0_dp]))]
        body%sections = [plain_section('HULL', [1, 2, 3], level, upright)]
        call finish_body(body)
    end function wedge

end program test_mesh_row
