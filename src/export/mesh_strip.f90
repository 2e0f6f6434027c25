!> The triangles of a section between two rows. Vertices of the two strands are taken in order of
!> their shares; where two are in step the four corners are parted by the diagonal that is nearer to
!> the skin. A strand of one vertex makes a fan.
module export_mesh_strip
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_skin, only: skin_at, skin_type
    use export_mesh, only: add_normal, add_triangle, mesh_type
    use export_mesh_chord, only: corner_type, gauge_type, measure_triangle, middle_distance, &
        normal_at
    use export_mesh_row, only: strand_type
    use geom_place, only: place_at
    implicit none (type, external)
    private

    public :: strip_type, set_edge, zip_strip, facet_normal

    !> One side of a strip: the strand of a row as seen from it.
    type :: edge_type
        type(corner_type), allocatable :: corner(:) !! of each vertex
        integer, allocatable :: vertex(:)           !! in the mesh
        integer, allocatable :: normal(:)           !! in the mesh; 0: the skin has none there
    end type edge_type

    !> A section between two rows.
    type :: strip_type
        integer :: section = 0          !! in the body's list
        type(gauge_type) :: gauge       !! its exact skin
        type(edge_type) :: edge(2)      !! on the fore row, on the aft row
    end type strip_type

contains

    !> Sets a side of a strip and adds its normals to the mesh. On a stop they are those of the skin
    !> on this side of it.
    pure subroutine set_edge(body, strip, side, strand, mesh)
        type(body_type), intent(in) :: body         !! finished
        type(strip_type), intent(inout) :: strip    !! has section and gauge
        integer, intent(in) :: side                 !! 1: fore, 2: aft
        type(strand_type), intent(in) :: strand     !! of the section at that row
        type(mesh_type), intent(inout) :: mesh      !! has the vertices; gets normals
        type(edge_type) :: edge
        real(dp) :: normal(3)
        integer :: i

        allocate (edge%corner(size(strand%vertex)), edge%normal(size(strand%vertex)))
        edge%vertex = strand%vertex
        do i = 1, size(edge%corner)
            edge%corner(i) = corner_type(mesh%vertices(:, edge%vertex(i)), strand%share(i), &
                merge(0, 6, side == 1), size(edge%corner) == 1)
            normal = skin_normal(body, strip, side, strand, i)
            edge%normal(i) = 0
            if (.not. norm2(normal) > 0.0_dp) cycle
            call add_normal(mesh, normal)
            edge%normal(i) = mesh%normal_count
        end do
        strip%edge(side) = edge
    end subroutine set_edge

    !> The outward normal of the skin at a vertex of a strand; zero where it has none.
    pure function skin_normal(body, strip, side, strand, number) result(normal)
        type(body_type), intent(in) :: body         !! finished
        type(strip_type), intent(in) :: strip       !! has section and gauge
        integer, intent(in) :: side                 !! 1: fore, 2: aft
        type(strand_type), intent(in) :: strand     !! of the section at that row
        integer, intent(in) :: number               !! of the vertex in the strand
        real(dp) :: normal(3), sta
        type(skin_type) :: skin

        associate (section => body%sections(strip%section), share => strand%share(number))
            normal = 0.0_dp
            if (.not. strip%gauge%is_stop(side)) normal = -section%outward &
                *normal_at(strip%gauge, merge(0, 6, side == 1), share)
            if (norm2(normal) > 0.0_dp) return
            sta = strip%gauge%sta(side)
            if (size(strand%vertex) == 1) then
                skin = skin_at(body%lines, section, sta, place_at(share))
            else
                if (side == 2 .and. strip%gauge%is_stop(2)) sta = nearest(sta, -1.0_dp)
                skin = skin_at(body%lines, section, sta, place_at(strand%t(number)))
            end if
            if (skin%has_normal) normal = skin%normal
        end associate
    end function skin_normal

    !> Adds the triangles of a strip to the last part of the mesh, measured.
    pure subroutine zip_strip(body, strip, mesh)
        type(body_type), intent(in) :: body         !! finished
        type(strip_type), intent(in) :: strip       !! has both sides
        type(mesh_type), intent(inout) :: mesh      !! gets the triangles
        integer :: i, j, last(2)
        logical :: on_fore

        last = [size(strip%edge(1)%vertex), size(strip%edge(2)%vertex)]
        i = 1
        j = 1
        do while (i < last(1) .or. j < last(2))
            on_fore = j == last(2)
            if (i < last(1) .and. j < last(2)) on_fore = goes_on_fore(strip, i, j)
            if (on_fore) then
                call add_face(body, strip, [1, 2, 1], [i, j, i + 1], mesh)
                i = i + 1
            else
                call add_face(body, strip, [1, 2, 2], [i, j, j + 1], mesh)
                j = j + 1
            end if
        end do
    end subroutine zip_strip

    !> True where the next triangle has its side on the fore row: where the next vertex there has
    !> the lesser share, or, of four corners in step, the diagonal to it is nearer to the skin.
    pure logical function goes_on_fore(strip, i, j)
        type(strip_type), intent(in) :: strip   !! has both sides
        integer, intent(in) :: i                !! vertex reached on the fore row, not the last
        integer, intent(in) :: j                !! vertex reached on the aft row, not the last
        associate (fore => strip%edge(1)%corner, aft => strip%edge(2)%corner)
            goes_on_fore = fore(i + 1)%share < aft(j + 1)%share
            if (.not. is_equal(fore(i + 1)%share, aft(j + 1)%share)) return
            if (.not. is_equal(fore(i)%share, aft(j)%share)) return
            goes_on_fore = middle_distance(strip%gauge, [fore(i + 1), aft(j)]) &
                <= middle_distance(strip%gauge, [fore(i), aft(j + 1)])
        end associate
    end function goes_on_fore

    !> Adds one triangle, turned so that it faces outward, unless it has shrunk to a line.
    pure subroutine add_face(body, strip, side, number, mesh)
        type(body_type), intent(in) :: body         !! finished
        type(strip_type), intent(in) :: strip       !! has both sides
        integer, intent(in) :: side(3)              !! of each corner
        integer, intent(in) :: number(3)            !! of each corner on that side
        type(mesh_type), intent(inout) :: mesh      !! gets the triangle
        type(corner_type) :: corner(3)
        integer :: vertex(3), normal(3), order(3), i

        order = [1, 2, 3]
        if (body%sections(strip%section)%outward > 0.0_dp) order = [1, 3, 2]
        do i = 1, 3
            associate (edge => strip%edge(side(order(i))), k => number(order(i)))
                corner(i) = edge%corner(k)
                vertex(i) = edge%vertex(k)
                normal(i) = edge%normal(k)
            end associate
        end do
        if (vertex(1) == vertex(2) .or. vertex(2) == vertex(3) .or. vertex(3) == vertex(1)) return
        if (any(normal == 0)) then
            call add_normal(mesh, facet_normal(mesh%vertices(:, vertex)))
            where (normal == 0) normal = mesh%normal_count
        end if
        call add_triangle(mesh, vertex, normal)
        associate (part => mesh%parts(size(mesh%parts)))
            call measure_triangle(strip%gauge, corner, part%error, part%worst)
        end associate
    end subroutine add_face

    !> The normal of a triangle, of unit length; zero where it has no area.
    pure function facet_normal(at) result(normal)
        real(dp), intent(in) :: at(3, 3)    !! its corners by columns
        real(dp) :: normal(3), p(3), q(3)

        p = at(:, 2) - at(:, 1)
        q = at(:, 3) - at(:, 1)
        normal = [p(2)*q(3) - p(3)*q(2), p(3)*q(1) - p(1)*q(3), p(1)*q(2) - p(2)*q(1)]
        if (norm2(normal) > 0.0_dp) normal = normal/norm2(normal)
    end function facet_normal

end module export_mesh_strip
