!> The port half of the mesh of a symmetric body: the exact mirror image of the starboard half, BL
!> with its sign changed, triangles turned round. Vertices at BL 0 belong to both.
module export_mesh_mirror
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use export_mesh, only: add_normal, add_triangle, add_vertex, mesh_part_type, mesh_type
    implicit none (type, external)
    private

    public :: add_port_half

contains

    !> Adds the mirror image of all parts, each as a part of its own.
    pure subroutine add_port_half(mesh)
        type(mesh_type), intent(inout) :: mesh !! has the starboard half
        type(mesh_part_type), allocatable :: halves(:)
        type(mesh_part_type) :: part
        integer, allocatable :: vertex(:), normal(:)
        integer :: i, k

        allocate (vertex(mesh%vertex_count), normal(mesh%normal_count))
        do i = 1, size(vertex)
            vertex(i) = i
            if (is_zero(mesh%vertices(2, i))) cycle
            call add_vertex(mesh, in_mirror(mesh%vertices(:, i)))
            vertex(i) = mesh%vertex_count
        end do
        do i = 1, size(normal)
            normal(i) = i
            if (is_zero(mesh%normals(2, i))) cycle
            call add_normal(mesh, in_mirror(mesh%normals(:, i)))
            normal(i) = mesh%normal_count
        end do
        allocate (halves, source=mesh%parts)
        do i = 1, size(halves)
            part = halves(i)
            part%name = part%name//' P'
            part%is_port = .true.
            part%worst = in_mirror(part%worst)
            part%first = mesh%triangle_count + 1
            part%last = mesh%triangle_count
            mesh%parts = [mesh%parts, part]
            do k = halves(i)%first, halves(i)%last
                call add_triangle(mesh, vertex(mesh%triangles([1, 3, 2], k)), &
                    normal(mesh%corners([1, 3, 2], k)))
            end do
        end do
    end subroutine add_port_half

    !> A point or a vector in the mirror; BL 0 has no sign.
    pure function in_mirror(at) result(image)
        real(dp), intent(in) :: at(3) !! STA, BL, WL
        real(dp) :: image(3)
        image = [at(1), 0.0_dp - at(2), at(3)]
    end function in_mirror

end module export_mesh_mirror
