!> A mesh small enough to write out by hand: a tetrahedron of two parts.
module support_tetrahedron
    use base_kinds, only: dp
    use export_mesh, only: mesh_part_type, mesh_type
    implicit none (type, external)
    private

    public :: tetrahedron

contains

    !> Corners at 0 and at 1 along STA, 2 along BL, .1 along WL; its part UPPER has three faces.
    function tetrahedron() result(mesh)
        type(mesh_type) :: mesh
        type(mesh_part_type) :: part
        real(dp), parameter :: third = 1.0_dp/3.0_dp
        mesh%deck = 'a b.crd'
        mesh%title = 'FOUR FACES'
        mesh%units = 'INCHES'
        mesh%vertices = reshape([0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 2.0_dp, &
            0.0_dp, 0.0_dp, 0.0_dp, 0.1_dp], [3, 4])
        mesh%triangles = reshape([1, 3, 2, 1, 2, 4, 2, 3, 4, 3, 1, 4], [3, 4])
        mesh%normals = reshape([0.0_dp, 0.0_dp, -1.0_dp, third, 2.0_dp*third, 2.0_dp*third], [3, 2])
        mesh%corners = reshape([1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2], [3, 4])
        mesh%vertex_count = 4
        mesh%normal_count = 2
        mesh%triangle_count = 4
        allocate (mesh%parts(2))
        part%name = 'CAP STA 0'
        part%last = 1
        mesh%parts(1) = part
        part%name = 'UPPER P'
        part%section = 1
        part%first = 2
        part%last = 4
        part%error = 0.25_dp
        part%worst = [1.0_dp, 2.0_dp, 3.0_dp]
        mesh%parts(2) = part
        mesh%is_closed = .true.
        mesh%stations = 2
        mesh%turn = 12.5_dp
        mesh%turn_at = [4.0_dp, 5.0_dp, -6.0_dp]
        mesh%angle = 10.0_dp
    end function tetrahedron

end module support_tetrahedron
