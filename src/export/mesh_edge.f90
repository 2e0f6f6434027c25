!> The edges of a mesh: which triangles meet along each, where it is open, and how far the skin
!> turns from a triangle to the next.
!>
!> Side k of triangle i, from corner k to the next, is half an edge, number 3 (i - 1) + k. Its twin
!> is a half edge between the same vertices the other way.
module export_mesh_edge
    use base_constants, only: degrees
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use export_mesh, only: mesh_type
    use export_mesh_strip, only: facet_normal
    use geom_space, only: angle_between
    implicit none (type, external)
    private

    public :: find_twins, half_edge, find_turn

contains

    !> The vertices of half an edge: from, to.
    pure function half_edge(mesh, number) result(ends)
        type(mesh_type), intent(in) :: mesh !! any
        integer, intent(in) :: number       !! of the half edge
        integer :: ends(2), triangle, k

        triangle = (number - 1)/3 + 1
        k = number - 3*(triangle - 1)
        ends = mesh%triangles([k, mod(k, 3) + 1], triangle)
    end function half_edge

    !> The twin of each half edge, or 0 where the mesh is open.
    pure function find_twins(mesh) result(twin)
        type(mesh_type), intent(in) :: mesh !! any
        integer, allocatable :: twin(:)
        integer, allocatable :: first(:), next(:)
        integer :: ends(2), i, k, before

        allocate (twin(3*mesh%triangle_count), source=0)
        allocate (first(mesh%vertex_count), next(3*mesh%triangle_count), source=0)
        do i = 1, size(twin)
            ends = half_edge(mesh, i)
            ! Open half edges that end where this begins are in a list; the twin is taken out.
            before = 0
            k = first(ends(2))
            do while (k > 0)
                if (all(half_edge(mesh, k) == ends([2, 1]))) exit
                before = k
                k = next(k)
            end do
            if (k > 0) then
                twin(i) = k
                twin(k) = i
                if (before == 0) first(ends(2)) = next(k)
                if (before > 0) next(before) = next(k)
            else
                next(i) = first(ends(1))
                first(ends(1)) = i
            end if
        end do
    end function find_twins

    !> Finds the largest turn from a triangle to the next within one section, but not along rows at
    !> stops, where the skin may break.
    pure subroutine find_turn(mesh, twin, stops)
        type(mesh_type), intent(inout) :: mesh  !! gets turn and place
        integer, intent(in) :: twin(:)          !! of `find_twins`
        real(dp), intent(in) :: stops(:)        !! stations, deck units
        real(dp), allocatable :: normal(:, :)
        integer :: part, i, other, ends(2)
        real(dp) :: turn

        mesh%turn = 0.0_dp
        allocate (normal(3, mesh%triangle_count))
        do i = 1, mesh%triangle_count
            normal(:, i) = facet_normal(mesh%vertices(:, mesh%triangles(:, i)))
        end do
        do part = 1, size(mesh%parts)
            if (mesh%parts(part)%section == 0) cycle
            do i = 3*mesh%parts(part)%first - 2, 3*mesh%parts(part)%last
                if (twin(i) < i) cycle
                other = (twin(i) - 1)/3 + 1
                if (other > mesh%parts(part)%last) cycle
                ends = half_edge(mesh, i)
                if (is_on_stop(mesh%vertices(1, ends), stops)) cycle
                turn = degrees*angle_between(normal(:, (i - 1)/3 + 1), normal(:, other))
                if (turn <= mesh%turn) cycle
                mesh%turn = turn
                mesh%turn_at = 0.5_dp*(mesh%vertices(:, ends(1)) + mesh%vertices(:, ends(2)))
            end do
        end do
    end subroutine find_turn

    !> True for an edge along a row at a stop.
    pure logical function is_on_stop(sta, stops)
        real(dp), intent(in) :: sta(2)      !! of its ends, deck units
        real(dp), intent(in) :: stops(:)    !! stations, deck units
        is_on_stop = is_equal(sta(1), sta(2)) .and. any(is_equal(sta(1), stops))
    end function is_on_stop

end module export_mesh_edge
