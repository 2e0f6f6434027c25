!> The skin of a body as flat triangles: what STL and OBJ files are written from. It knows no deck
!> and no file format.
!>
!> Triangles share vertices, the same numbers, so that they hang together where the skin does. Seen
!> from outside, the corners of a triangle run counter-clockwise. Each corner has the normal of the
!> skin there, of its own part: where the skin breaks, a vertex has several.
module export_mesh
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: mesh_part_type, mesh_type, add_vertex, add_normal, add_triangle, trim_mesh, scale_mesh

    !> The triangles of one section of one half, or of one flat cap.
    type :: mesh_part_type
        character(:), allocatable :: name   !! `UPPER`, `UPPER P`, `CAP STA 280`
        integer :: section = 0              !! in the body's list; 0: flat; -1: a panel
        logical :: is_port = .false.        !! the mirror image of a part of the starboard half
        integer :: first = 1                !! its first triangle
        integer :: last = 0                 !! its last triangle
        real(dp) :: error = 0.0_dp          !! largest distance from the skin, measured
        real(dp) :: worst(3) = 0.0_dp       !! where: STA, BL, WL
    end type mesh_part_type

    !> A mesh; the first `counts` of vertices, normals and triangles are in use.
    type :: mesh_type
        character(:), allocatable :: deck           !! file name of the deck, without folders
        character(:), allocatable :: title          !! of the deck, may be empty
        character(:), allocatable :: units          !! INCHES, MM, FEET or M: of all lengths in it
        integer :: vertex_count = 0                 !! how many vertices
        integer :: normal_count = 0                 !! how many normals
        integer :: triangle_count = 0               !! how many triangles
        real(dp), allocatable :: vertices(:, :)     !! STA, BL, WL; shape (3, vertices)
        real(dp), allocatable :: normals(:, :)      !! outward, of unit length; shape (3, normals)
        integer, allocatable :: triangles(:, :)     !! vertices; shape (3, triangles)
        integer, allocatable :: corners(:, :)       !! normals of the corners; shape as triangles
        type(mesh_part_type), allocatable :: parts(:)   !! in order of triangles
        logical :: is_closed = .false.              !! each edge is used twice, once each way
        character(:), allocatable :: why            !! where it is not closed: why not
        integer :: stations = 0                     !! rows of vertices along the body
        real(dp) :: tolerance = 0.0_dp              !! distance from the skin that was asked
        real(dp) :: error = 0.0_dp                  !! largest distance from the skin, measured
        real(dp) :: worst(3) = 0.0_dp               !! where: STA, BL, WL
        real(dp) :: angle = 0.0_dp                  !! turn that was asked, degrees
        real(dp) :: turn = 0.0_dp                   !! largest turn between neighbours in one
                                                    !! section between stops, degrees
        real(dp) :: turn_at(3) = 0.0_dp             !! where: STA, BL, WL
    end type mesh_type

contains

    !> Adds a vertex.
    pure subroutine add_vertex(mesh, at)
        type(mesh_type), intent(inout) :: mesh  !! its last vertex is then the new one
        real(dp), intent(in) :: at(3)           !! STA, BL, WL
        if (.not. allocated(mesh%vertices)) allocate (mesh%vertices(3, 1024))
        if (mesh%vertex_count == size(mesh%vertices, 2)) call widen(mesh%vertices)
        mesh%vertex_count = mesh%vertex_count + 1
        mesh%vertices(:, mesh%vertex_count) = at
    end subroutine add_vertex

    !> Adds a normal.
    pure subroutine add_normal(mesh, normal)
        type(mesh_type), intent(inout) :: mesh  !! its last normal is then the new one
        real(dp), intent(in) :: normal(3)       !! outward, of unit length
        if (.not. allocated(mesh%normals)) allocate (mesh%normals(3, 1024))
        if (mesh%normal_count == size(mesh%normals, 2)) call widen(mesh%normals)
        mesh%normal_count = mesh%normal_count + 1
        mesh%normals(:, mesh%normal_count) = normal
    end subroutine add_normal

    !> Adds a triangle to the last part.
    pure subroutine add_triangle(mesh, vertices, corners)
        type(mesh_type), intent(inout) :: mesh  !! has a part
        integer, intent(in) :: vertices(3)      !! counter-clockwise seen from outside
        integer, intent(in) :: corners(3)       !! their normals
        if (.not. allocated(mesh%triangles)) allocate (mesh%triangles(3, 1024), &
            mesh%corners(3, 1024))
        if (mesh%triangle_count == size(mesh%triangles, 2)) then
            call widen_whole(mesh%triangles)
            call widen_whole(mesh%corners)
        end if
        mesh%triangle_count = mesh%triangle_count + 1
        mesh%triangles(:, mesh%triangle_count) = vertices
        mesh%corners(:, mesh%triangle_count) = corners
        mesh%parts(size(mesh%parts))%last = mesh%triangle_count
    end subroutine add_triangle

    !> Makes room for twice as many columns.
    pure subroutine widen(list)
        real(dp), allocatable, intent(inout) :: list(:, :) !! shape (3, any)
        real(dp), allocatable :: wide(:, :)
        allocate (wide(3, 2*size(list, 2)))
        wide(:, :size(list, 2)) = list
        call move_alloc(wide, list)
    end subroutine widen

    !> Makes room for twice as many columns of whole numbers.
    pure subroutine widen_whole(list)
        integer, allocatable, intent(inout) :: list(:, :) !! shape (3, any)
        integer, allocatable :: wide(:, :)
        allocate (wide(3, 2*size(list, 2)))
        wide(:, :size(list, 2)) = list
        call move_alloc(wide, list)
    end subroutine widen_whole

    !> Leaves out vertices that no triangle uses, and room that is not in use.
    pure subroutine trim_mesh(mesh)
        type(mesh_type), intent(inout) :: mesh !! finished
        integer, allocatable :: number(:)
        integer :: i, k

        if (.not. allocated(mesh%vertices)) allocate (mesh%vertices(3, 0))
        if (.not. allocated(mesh%normals)) allocate (mesh%normals(3, 0))
        if (.not. allocated(mesh%triangles)) allocate (mesh%triangles(3, 0), mesh%corners(3, 0))
        mesh%triangles = mesh%triangles(:, :mesh%triangle_count)
        mesh%corners = mesh%corners(:, :mesh%triangle_count)
        allocate (number(mesh%vertex_count), source=0)
        do i = 1, mesh%triangle_count
            number(mesh%triangles(:, i)) = 1
        end do
        k = 0
        do i = 1, mesh%vertex_count
            if (number(i) == 0) cycle
            k = k + 1
            number(i) = k
            mesh%vertices(:, k) = mesh%vertices(:, i)
        end do
        mesh%vertex_count = k
        mesh%vertices = mesh%vertices(:, :k)
        mesh%normals = mesh%normals(:, :mesh%normal_count)
        do i = 1, mesh%triangle_count
            mesh%triangles(:, i) = number(mesh%triangles(:, i))
        end do
    end subroutine trim_mesh

    !> A mesh in another unit.
    pure subroutine scale_mesh(mesh, factor, units)
        type(mesh_type), intent(inout) :: mesh  !! any; all its lengths become larger by the factor
        real(dp), intent(in) :: factor          !! above zero: new units in one of the old
        character(*), intent(in) :: units       !! the new unit: INCHES, MM, FEET or M

        mesh%units = units
        if (allocated(mesh%vertices)) mesh%vertices(:, :mesh%vertex_count) = &
            factor*mesh%vertices(:, :mesh%vertex_count)
        mesh%tolerance = factor*mesh%tolerance
        mesh%error = factor*mesh%error
        mesh%worst = factor*mesh%worst
        mesh%turn_at = factor*mesh%turn_at
        if (allocated(mesh%parts)) call scale_parts(mesh%parts, factor)
    end subroutine scale_mesh

    !> Scales the errors of parts.
    elemental subroutine scale_parts(part, factor)
        type(mesh_part_type), intent(inout) :: part !! any
        real(dp), intent(in) :: factor              !! new units in one of the old
        part%error = factor*part%error
        part%worst = factor*part%worst
    end subroutine scale_parts

end module export_mesh
