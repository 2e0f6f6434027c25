!> A body laid out in rows, as a mesh begins.
module support_laid
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_mesh, only: mesh_type
    use export_mesh_density, only: density_type, find_density
    use export_mesh_plan, only: new_plan, plan_type
    use export_mesh_row, only: lay_vertices, row_type
    implicit none (type, external)
    private

    public :: laid_type, laid, facing, area

    !> Plan, rows, and a mesh with their vertices and no part.
    type :: laid_type
        type(plan_type) :: plan
        type(row_type), allocatable :: rows(:)
        type(mesh_type) :: mesh
    end type laid_type

contains

    !> A body laid out for a tolerance and 90 degrees; it must have its arcs.
    function laid(body, tolerance) result(out)
        type(body_type), intent(in) :: body
        real(dp), intent(in) :: tolerance
        type(laid_type) :: out
        type(density_type) :: density
        type(error_type), allocatable :: error
        call find_density(body, density, error)
        if (allocated(error)) error stop 'a body of a test has no arc'
        call new_plan(density, tolerance, 90.0_dp, body%is_symmetric, out%plan, error)
        if (allocated(error)) error stop 'a body of a test has too many triangles'
        allocate (out%mesh%parts(0), out%mesh%normals(3, 1))
        call lay_vertices(body, out%plan, out%rows, out%mesh, error)
        if (allocated(error)) error stop 'a body of a test has no arc'
    end function laid

    !> Twice the area of a triangle, along its normal.
    function facing(mesh, triangle) result(normal)
        type(mesh_type), intent(in) :: mesh
        integer, intent(in) :: triangle
        real(dp) :: normal(3), p(3), q(3)
        associate (at => mesh%vertices(:, mesh%triangles(:, triangle)))
            p = at(:, 2) - at(:, 1)
            q = at(:, 3) - at(:, 1)
        end associate
        normal = [p(2)*q(3) - p(3)*q(2), p(3)*q(1) - p(1)*q(3), p(1)*q(2) - p(2)*q(1)]
    end function facing

    !> The area of some triangles.
    real(dp) function area(mesh, first, last)
        type(mesh_type), intent(in) :: mesh
        integer, intent(in) :: first, last
        integer :: i
        area = 0.0_dp
        do i = first, last
            area = area + 0.5_dp*norm2(facing(mesh, i))
        end do
    end function area

end module support_laid
