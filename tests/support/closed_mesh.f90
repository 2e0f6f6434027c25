!> What a closed mesh must be, looked at without the means of `src/export`.
module support_closed_mesh
    use base_kinds, only: dp
    use export_mesh, only: mesh_type
    implicit none (type, external)
    private

    public :: is_watertight, is_mirrored, volume_of, flat_area

contains

    !> True where each edge is used once each way.
    logical function is_watertight(mesh)
        type(mesh_type), intent(in) :: mesh
        integer, allocatable :: head(:), next(:)
        integer :: i, k, h, a, b
        is_watertight = mesh%triangle_count > 0
        allocate (head(mesh%vertex_count), next(3*mesh%triangle_count), source=0)
        do i = 1, 3*mesh%triangle_count
            a = from_of(mesh, i)
            next(i) = head(a)
            head(a) = i
        end do
        do i = 1, 3*mesh%triangle_count
            a = from_of(mesh, i)
            b = to_of(mesh, i)
            k = 0
            h = head(b)
            do while (h > 0)
                if (to_of(mesh, h) == a) k = k + 1
                h = next(h)
            end do
            if (k /= 1) is_watertight = .false.
        end do
    end function is_watertight

    !> Where a side of a triangle begins.
    integer function from_of(mesh, side)
        type(mesh_type), intent(in) :: mesh
        integer, intent(in) :: side
        from_of = mesh%triangles(mod(side - 1, 3) + 1, (side - 1)/3 + 1)
    end function from_of

    !> Where it ends.
    integer function to_of(mesh, side)
        type(mesh_type), intent(in) :: mesh
        integer, intent(in) :: side
        to_of = mesh%triangles(mod(side, 3) + 1, (side - 1)/3 + 1)
    end function to_of

    !> True where the second half of the triangles are the mirror images of the first.
    logical function is_mirrored(mesh)
        type(mesh_type), intent(in) :: mesh
        real(dp) :: p(3, 3), q(3, 3)
        integer :: i, half
        half = mesh%triangle_count/2
        is_mirrored = mod(mesh%triangle_count, 2) == 0
        do i = 1, half
            p = mesh%vertices(:, mesh%triangles(:, i))
            q = mesh%vertices(:, mesh%triangles([1, 3, 2], half + i))
            q(2, :) = -q(2, :)
            if (any(abs(p - q) > 0.0_dp)) is_mirrored = .false.
        end do
    end function is_mirrored

    !> Volume by the theorem of Gauss, from the mesh's own middle.
    real(dp) function volume_of(mesh) result(volume)
        type(mesh_type), intent(in) :: mesh
        real(dp) :: p(3, 3)
        integer :: i
        volume = 0.0_dp
        do i = 1, mesh%triangle_count
            p = mesh%vertices(:, mesh%triangles(:, i))
            volume = volume + (p(1, 1)*(p(2, 2)*p(3, 3) - p(3, 2)*p(2, 3)) &
                + p(2, 1)*(p(3, 2)*p(1, 3) - p(1, 2)*p(3, 3)) &
                + p(3, 1)*(p(1, 2)*p(2, 3) - p(2, 2)*p(1, 3)))/6.0_dp
        end do
    end function volume_of

    !> Area of the triangles in the plane of a station, positive where they face aft.
    real(dp) function flat_area(mesh, sta) result(area)
        type(mesh_type), intent(in) :: mesh
        real(dp), intent(in) :: sta
        real(dp) :: p(3, 3)
        integer :: i
        area = 0.0_dp
        do i = 1, mesh%triangle_count
            p = mesh%vertices(:, mesh%triangles(:, i))
            if (any(abs(p(1, :) - sta) > 0.0_dp)) cycle
            area = area + 0.5_dp*((p(2, 2) - p(2, 1))*(p(3, 3) - p(3, 1)) &
                - (p(3, 2) - p(3, 1))*(p(2, 3) - p(2, 1)))
        end do
    end function flat_area

end module support_closed_mesh
