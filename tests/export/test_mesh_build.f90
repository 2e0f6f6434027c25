!> Tests of meshes of bodies: closed, within the tolerance of the exact skin at points where LOFT
!> does not measure, volume and mirror symmetry; runs whose sections differ; faults.
program test_mesh_build
    use base_constants, only: pi
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use api_computed_body, only: computed_body_type
    use body_body, only: body_type
    use cut_clearance_map, only: map_type, new_map
    use cut_clearance_nearest, only: box_type, foot_type, nearest_to
    use export_mesh, only: mesh_type
    use export_mesh_build, only: build_mesh
    use export_settings, only: settings_type
    use support_bodies, only: ellipsoid
    use support_closed_mesh, only: flat_area, is_mirrored, is_watertight, volume_of
    use support_computed, only: computed_deck
    use support_cylinders, only: cylinders, split_cylinder
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(mesh_type) :: mesh, other
    type(settings_type) :: settings
    type(error_type), allocatable :: error
    type(computed_body_type) :: computed
    real(dp) :: full

    settings%tolerance = 0.05_dp
    settings%angle = 90.0_dp
    body = ellipsoid([100.0_dp, 60.0_dp, 50.0_dp], 120.0_dp, 30.0_dp)
    call build_mesh(body, settings, mesh, error)
    call check_closed(mesh, 'ellipsoid')
    call tap%near(largest_off(mesh), mesh%error, 0.02_dp*mesh%error, &
        'ellipsoid: the distance measured is that of a closer look')
    call tap%ok(largest_off(mesh) <= 0.05_dp, 'ellipsoid: and within the tolerance')
    call tap%near(volume_of(mesh), 4.0_dp/3.0_dp*pi*300000.0_dp, 2000.0_dp, 'ellipsoid: volume')
    call tap%ok(off_vertices(mesh) < 1.0e-13_dp, 'ellipsoid: vertices are on the skin')
    call tap%ok(mesh%triangle_count < 15000, 'ellipsoid: no more triangles than it needs')

    settings%tolerance = 0.0005_dp
    call build_mesh(body, settings, mesh, error)
    call tap%ok(largest_off(mesh) <= 0.0005_dp, 'ellipsoid, a hundredth: within the tolerance')
    call tap%near(volume_of(mesh), 4.0_dp/3.0_dp*pi*300000.0_dp, 20.0_dp, &
        'ellipsoid, a hundredth: volume')

    settings%tolerance = 1.0_dp
    settings%angle = 3.0_dp
    call build_mesh(body, settings, mesh, error)
    call tap%ok(mesh%turn <= 3.0_dp .and. mesh%turn > 2.0_dp, 'an angle is kept too')
    call tap%near(mesh%angle + mesh%tolerance, 4.0_dp, 0.0_dp, 'the mesh says what was asked')

    settings%tolerance = 0.02_dp
    settings%angle = 20.0_dp
    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 0.0_dp)
    call build_mesh(body, settings, mesh, error)
    call check_closed(mesh, 'a step')
    full = pi*(2500.0_dp + 900.0_dp)*50.0_dp
    call tap%near(volume_of(mesh), full, 1.0e-3_dp*full, 'a step: volume')
    call tap%near(flat_area(mesh, 50.0_dp), pi*1600.0_dp, 10.0_dp, 'a step: a ring faces aft')

    body = cylinders([50.0_dp, 30.0_dp], [30.0_dp, 50.0_dp], 0.0_dp)
    call build_mesh(body, settings, mesh, error)
    call check_closed(mesh, 'outlines that cross')
    full = pi*150000.0_dp
    call tap%near(volume_of(mesh), full, 1.0e-3_dp*full, 'outlines that cross: volume')
    call tap%near(flat_area(mesh, 50.0_dp), 0.0_dp, 1.0_dp, &
        'outlines that cross: as much faces aft as forward')

    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 80.0_dp)
    call build_mesh(body, settings, mesh, error)
    call check_closed(mesh, 'nacelles')
    full = pi*(2500.0_dp + 900.0_dp)*100.0_dp
    call tap%near(volume_of(mesh), full, 1.0e-3_dp*full, 'nacelles: volume of both')

    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 0.0_dp)
    body%is_symmetric = .false.
    call build_mesh(body, settings, mesh, error)
    call check_closed(mesh, 'one side, closed along BL 0')
    full = pi*(2500.0_dp + 900.0_dp)*25.0_dp
    call tap%near(volume_of(mesh), full, 1.0e-3_dp*full, 'one side: volume')

    body = split_cylinder()
    call build_mesh(body, settings, mesh, error)
    call check_closed(mesh, 'a section that goes on as two')
    call tap%near(abs(flat_area(mesh, 50.0_dp)) + real(count_of(mesh, 'CAP STA 50'), dp), 0.0_dp, &
        0.0_dp, 'a section that goes on as two: no face between')
    body%is_closed = .false.
    call build_mesh(body, settings, mesh, error)
    call tap%ok(.not. mesh%is_closed .and. allocated(mesh%why), 'without CLOSE it is open')
    call tap%has(mesh%why, 'CLOSE', 'and says why')
    body%is_closed = .true.
    settings%is_open = .true.
    call build_mesh(body, settings, other, error)
    call tap%ok(.not. other%is_closed .and. other%triangle_count == mesh%triangle_count, &
        'so it is where that is asked')
    settings%is_open = .false.

    call computed_deck(tap, 'fuselage', computed)
    call build_mesh(computed%body, settings, mesh, error)
    call check_closed(mesh, 'fuselage')
    call tap%near(volume_of(mesh), computed%measure%volume, 1.0e-3_dp*computed%measure%volume, &
        'fuselage: volume')
    call tap%ok(mesh%turn <= 20.0_dp, 'fuselage: the angle is kept')
    call tap%ok(largest_from(computed%body, mesh) <= 0.02_dp, &
        'fuselage: no point of a triangle is further from the skin than asked')
    call build_mesh(computed%body, settings, other, error)
    call tap%ok(all(mesh%triangles == other%triangles) .and. &
        all(abs(mesh%vertices - other%vertices) <= 0.0_dp), 'the same again is the same')
    call computed_deck(tap, 'batten', computed)
    call build_mesh(computed%body, settings, mesh, error)
    call tap%ok(largest_from(computed%body, mesh) <= 0.02_dp, &
        'a hull with a stem: no point is further from the skin than asked')
    call tap%ok(mesh%turn > 20.0_dp, 'the angle at its stem is told')
    call computed_deck(tap, 'nose', computed)
    call build_mesh(computed%body, settings, mesh, error)
    call tap%ok(.not. mesh%is_closed, 'the nose of the book is open')
    call tap%has(mesh%why, 'the section is open at BL', 'and says where')

    settings%tolerance = 1.0e-9_dp
    call build_mesh(computed%body, settings, mesh, error)
    call tap%ok(allocated(error), 'too fine a tolerance is refused')
    call tap%ok(error%cause == cause%too_many, 'for too many triangles')
    call tap%has(error%message, 'times as large', 'and what would do is said')
    settings%tolerance = 0.0_dp
    call build_mesh(computed%body, settings, mesh, error)
    call tap%ok(error%cause == cause%usage, 'a tolerance of 0 is refused')
    settings%tolerance = 0.1_dp
    settings%angle = -1.0_dp
    call build_mesh(computed%body, settings, mesh, error)
    call tap%ok(error%cause == cause%usage, 'so is an angle below')
    settings%angle = 10.0_dp
    deallocate (body%sections)
    allocate (body%sections(0))
    call build_mesh(body, settings, mesh, error)
    call tap%ok(error%cause == cause%no_convergence, 'a body without sections has no mesh')
    call tap%finish()

contains

    !> A mesh is closed, and its halves are images.
    subroutine check_closed(mesh, name)
        type(mesh_type), intent(in) :: mesh
        character(*), intent(in) :: name
        call tap%ok(.not. allocated(error), name//': there is a mesh')
        call tap%ok(mesh%is_closed, name//': it says that it is closed')
        call tap%ok(is_watertight(mesh), name//': each edge is used once each way')
        call tap%ok(is_mirrored(mesh) .or. .not. body%is_symmetric, &
            name//': its halves are mirror images to the last bit')
    end subroutine check_closed

    !> Triangles of a part.
    integer function count_of(mesh, name)
        type(mesh_type), intent(in) :: mesh
        character(*), intent(in) :: name
        integer :: i
        count_of = 0
        do i = 1, size(mesh%parts)
            if (mesh%parts(i)%name == name) &
                count_of = mesh%parts(i)%last - mesh%parts(i)%first + 1
        end do
    end function count_of

    !> How far points of all triangles, 45 each, are from the ellipsoid, to first order.
    real(dp) function largest_off(mesh) result(largest)
        type(mesh_type), intent(in) :: mesh
        integer :: i, j, k
        real(dp) :: p(3, 3), at(3), weight(3)
        largest = 0.0_dp
        do i = 1, mesh%triangle_count
            p = mesh%vertices(:, mesh%triangles(:, i))
            do j = 0, 8
                do k = 0, 8 - j
                    weight = real([j, k, 8 - j - k], dp)/8.0_dp
                    at = matmul(p, weight)
                    largest = max(largest, off_ellipsoid(at))
                end do
            end do
        end do
    end function largest_off

    !> How far a point is from the ellipsoid: F/|grad F|, then at its foot again.
    real(dp) function off_ellipsoid(at) result(off)
        real(dp), intent(in) :: at(3)
        real(dp) :: x(3), gradient(3), value
        real(dp), parameter :: axes(3) = [100.0_dp, 60.0_dp, 50.0_dp]
        integer :: i
        x = at - [120.0_dp, 0.0_dp, 30.0_dp]
        off = 0.0_dp
        do i = 1, 3
            value = sum((x/axes)**2) - 1.0_dp
            gradient = 2.0_dp*x/axes**2
            off = off + abs(value)/norm2(gradient)
            x = x - value*gradient/dot_product(gradient, gradient)
        end do
    end function off_ellipsoid

    !> How far vertices are from the ellipsoid.
    real(dp) function off_vertices(mesh) result(largest)
        type(mesh_type), intent(in) :: mesh
        integer :: i
        largest = 0.0_dp
        do i = 1, mesh%vertex_count
            largest = max(largest, off_ellipsoid(mesh%vertices(:, i)))
        end do
    end function off_vertices

    !> How far points of triangles of the starboard skin are from the nearest point of the skin.
    real(dp) function largest_from(body, mesh) result(largest)
        type(body_type), intent(in) :: body
        type(mesh_type), intent(in) :: mesh
        type(map_type) :: map
        type(foot_type) :: foot
        real(dp) :: at(3)
        integer :: i, k
        map = new_map(body)
        largest = 0.0_dp
        do k = 1, size(mesh%parts)
            if (mesh%parts(k)%section == 0 .or. mesh%parts(k)%is_port) cycle
            do i = mesh%parts(k)%first, mesh%parts(k)%last, 41
                at = matmul(mesh%vertices(:, mesh%triangles(:, i)), &
                    [0.2_dp, 0.2_dp, 0.2_dp] + 0.4_dp*real(cshift([1, 0, 0], mod(i, 3)), dp))
                call nearest_to(body, map, box_type(at, at), foot)
                largest = max(largest, foot%distance)
            end do
        end do
    end function largest_from

end program test_mesh_build
