!> Tests of flat faces over open ends and between outlines that differ.
program test_mesh_cap
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_mesh, only: mesh_type
    use export_mesh_cap, only: add_caps
    use export_mesh_edge, only: find_twins
    use export_mesh_row, only: first_row
    use export_mesh_seam, only: join_row
    use export_mesh_skin, only: add_skin
    use support_cylinders, only: cylinders
    use support_laid, only: area, facing, laid, laid_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(laid_type) :: it
    real(dp), parameter :: stops(3) = [0.0_dp, 50.0_dp, 100.0_dp]

    call cap(cylinders([50.0_dp, 30.0_dp], [25.0_dp, 15.0_dp], 0.0_dp), .true.)
    call tap%ok(size(it%mesh%parts) == 7, 'a step has a face at each stop')
    call check('CAP STA 0', 5, 0.5_dp*pi*1500.0_dp, -1.0_dp)
    call check('CAP STA 50', 6, 0.5_dp*pi*1125.0_dp, 1.0_dp)
    call check('CAP STA 100', 7, 0.5_dp*pi*375.0_dp, 1.0_dp)
    call tap%ok(all_open_at_centre(it%mesh), 'what is open then is in BL 0')

    call cap(cylinders([25.0_dp, 15.0_dp], [50.0_dp, 30.0_dp], 0.0_dp), .true.)
    call check('CAP STA 50', 6, 0.5_dp*pi*1125.0_dp, -1.0_dp)
    call cap(cylinders([25.0_dp, 15.0_dp], [50.0_dp, 30.0_dp], 200.0_dp), .true.)
    call check('CAP STA 50', 10, pi*1125.0_dp, -1.0_dp)
    call tap%ok(all(find_twins(it%mesh) > 0), 'beside BL 0 the mesh is closed')
    call cap(cylinders([50.0_dp, 30.0_dp], [50.0_dp, 30.0_dp], 0.0_dp), .true.)
    call tap%ok(size(it%mesh%parts) == 6, 'between outlines that are one there is no face')
    ! Ellipses 50 by 30 and 30 by 50: each has 4*50*30 atan(30/50) in common with the other.
    call cap(cylinders([50.0_dp, 30.0_dp], [30.0_dp, 50.0_dp], 0.0_dp), .true.)
    call tap%near(area(it%mesh, it%mesh%parts(6)%first, it%mesh%parts(6)%last), &
        pi*1500.0_dp - 4.0_dp*1500.0_dp*atan(0.6_dp), 3.0_dp, 'outlines that cross: area')
    call tap%ok(all_open_at_centre(it%mesh), 'and no edge is left')
    call tap%finish()

contains

    !> A body with its faces.
    subroutine cap(body, is_half)
        type(body_type), intent(in) :: body
        logical, intent(in) :: is_half
        type(error_type), allocatable :: error
        it = laid(body, 0.02_dp)
        call join_row(it%plan%runs(1)%stretch%sections, it%plan%runs(2)%stretch%sections, &
            1.0e-6_dp, it%rows(first_row(it%plan, 2)), it%mesh)
        call add_skin(body, it%plan, it%rows, it%mesh, error)
        call add_caps(it%mesh, find_twins(it%mesh), stops, is_half)
    end subroutine cap

    !> A face has its name, its area, and faces forward or aft.
    subroutine check(name, part, whole, way)
        character(*), intent(in) :: name
        integer, intent(in) :: part
        real(dp), intent(in) :: whole, way
        integer :: i
        real(dp) :: normal(3), wrong
        call tap%same(it%mesh%parts(part)%name, name, name//': its name')
        call tap%near(area(it%mesh, it%mesh%parts(part)%first, it%mesh%parts(part)%last), whole, &
            2.0e-3_dp*whole, name//': its area')
        wrong = 0.0_dp
        do i = it%mesh%parts(part)%first, it%mesh%parts(part)%last
            normal = facing(it%mesh, i)
            if (.not. way*normal(1) > 0.0_dp) wrong = wrong + 1.0_dp
            normal = it%mesh%normals(:, it%mesh%corners(2, i)) - [way, 0.0_dp, 0.0_dp]
            wrong = wrong + norm2(normal)
        end do
        call tap%near(wrong, 0.0_dp, 0.0_dp, name//': it faces the right way')
    end subroutine check

    !> True where all edges without a twin are in BL 0.
    logical function all_open_at_centre(mesh)
        type(mesh_type), intent(in) :: mesh
        integer, allocatable :: twin(:)
        integer :: i
        allocate (twin, source=find_twins(mesh))
        all_open_at_centre = any(twin == 0)
        do i = 1, size(twin)
            if (twin(i) > 0) cycle
            if (abs(mesh%vertices(2, mesh%triangles(mod(i - 1, 3) + 1, (i - 1)/3 + 1))) > 0.0_dp &
                .or. abs(mesh%vertices(2, mesh%triangles(mod(i, 3) + 1, (i - 1)/3 + 1))) > 0.0_dp) &
                all_open_at_centre = .false.
        end do
    end function all_open_at_centre

end program test_mesh_cap
