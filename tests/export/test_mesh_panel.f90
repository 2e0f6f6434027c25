!> Panels as triangles: a saddle, and its image beside it across BL 0.
program test_mesh_panel
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_panel, only: mirrored_panel, panel_type
    use export_mesh, only: mesh_type
    use export_mesh_build, only: build_panel_mesh
    use export_mesh_edge, only: find_twins
    use export_mesh_panel, only: add_panels
    use export_settings, only: settings_type
    use support_saddle, only: saddle
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(mesh_type) :: mesh
    type(settings_type) :: settings
    type(error_type), allocatable :: error
    real(dp) :: off
    integer :: i

    allocate (mesh%parts(0))
    call add_panels([saddle()], 1.0e-3_dp, 30.0_dp, .false., mesh, error)
    call tap%ok(.not. allocated(error) .and. size(mesh%parts) == 1, 'a panel is one part')
    off = 0.0_dp
    do i = 1, mesh%vertex_count
        associate (at => mesh%vertices(:, i))
            off = max(off, abs(at(3) - 0.04_dp*at(1)*at(2)))
        end associate
    end do
    call tap%near(off, 0.0_dp, 1.0e-13_dp, 'its vertices are on the saddle')
    call tap%ok(mesh%parts(1)%error <= 1.0e-3_dp .and. mesh%parts(1)%error > 1.0e-5_dp, &
        'its triangles within the tolerance')
    call tap%near(swept(mesh), 100.0_dp, 1.0e-11_dp, 'they cover its plan once, seen from outside')
    settings%tolerance = 1.0e-3_dp
    settings%angle = 30.0_dp
    call build_panel_mesh([saddle(), mirrored_panel(saddle())], settings, mesh, error)
    call tap%ok(.not. allocated(error), 'panels alone make a mesh')
    call tap%near(swept(mesh), 200.0_dp, 1.0e-10_dp, 'both halves')
    call tap%ok(open_in_bl_0(mesh) == 0, 'which hang together in BL 0')
    call tap%ok(.not. mesh%is_closed .and. len(mesh%why) > 0, 'and are open elsewhere')
    settings%tolerance = 0.0_dp
    call build_panel_mesh([saddle()], settings, mesh, error)
    call tap%ok(allocated(error), 'no tolerance is an error')
    call tap%finish()

contains

    !> The area of the plan of all triangles, seen from above.
    real(dp) function swept(mesh)
        type(mesh_type), intent(in) :: mesh !! any
        integer :: i
        swept = 0.0_dp
        do i = 1, mesh%triangle_count
            associate (a => mesh%vertices(:2, mesh%triangles(1, i)), &
                b => mesh%vertices(:2, mesh%triangles(2, i)), &
                c => mesh%vertices(:2, mesh%triangles(3, i)))
                swept = swept + 0.5_dp*((b(1) - a(1))*(c(2) - a(2)) - (b(2) - a(2))*(c(1) - a(1)))
            end associate
        end do
    end function swept

    !> Open edges in BL 0.
    integer function open_in_bl_0(mesh) result(number)
        type(mesh_type), intent(in) :: mesh !! any
        integer, allocatable :: twin(:)
        integer :: i, k, ends(2)
        allocate (twin, source=find_twins(mesh))
        number = 0
        do i = 1, size(twin)
            if (twin(i) > 0) cycle
            k = 1 + mod(i - 1, 3)
            ends = mesh%triangles([k, 1 + mod(k, 3)], 1 + (i - 1)/3)
            if (all(abs(mesh%vertices(2, ends)) <= 0.0_dp)) number = number + 1
        end do
    end function open_in_bl_0

end program test_mesh_panel
