!> Joins the rows of two runs where the set of sections changes at a stop. Where the outline of the
!> fore run and that of the aft run are one curve (a section goes on as two, say) the vertices of
!> each become vertices of the other, so that their triangles meet edge to edge. Where the outlines
!> differ they stay as they are, but where they cross both get a vertex; `export_mesh_cap` then puts
!> flat faces between them.
module export_mesh_seam
    use base_kinds, only: dp
    use export_mesh, only: add_vertex, mesh_type
    use export_mesh_row, only: row_type, strand_type
    use export_mesh_share, only: parameter_at
    use geom_arc, only: arc_type, weight
    use geom_arc_point, only: point
    use geom_place, only: place_at
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: join_row

    !> Two vertices of coinciding outlines become one where they are nearer than this part of the
    !> way to the next: no needles.
    real(dp), parameter :: near = 0.3_dp
    !> Parts of an arc where its nearest point is looked for first; halvings that then find it.
    integer, parameter :: parts = 64, halvings = 50

contains

    !> Joins the strands of a row: those of sections that end there with those that begin there.
    pure subroutine join_row(fore, aft, gap, row, mesh)
        integer, intent(in) :: fore(:)              !! sections of the fore run
        integer, intent(in) :: aft(:)               !! sections of the aft run
        real(dp), intent(in) :: gap                 !! how near curves are that are one, deck units
        type(row_type), intent(inout) :: row        !! at the stop
        type(mesh_type), intent(inout) :: mesh      !! its vertices
        integer :: i, k

        do i = 1, size(fore)
            if (any(aft == fore(i))) cycle
            do k = 1, size(aft)
                if (any(fore == aft(k))) cycle
                if (size(row%strands(fore(i))%vertex) < 2) cycle
                if (size(row%strands(aft(k))%vertex) < 2) cycle
                call share_vertices(row%strands(aft(k)), gap, mesh, row%strands(fore(i)))
                call share_vertices(row%strands(fore(i)), gap, mesh, row%strands(aft(k)))
                call cross_strands(row%strands(fore(i)), row%strands(aft(k)), mesh)
            end do
        end do
    end subroutine join_row

    !> Makes the vertices of a strand that are on the arc of another vertices of this too.
    pure subroutine share_vertices(giver, gap, mesh, taker)
        type(strand_type), intent(inout) :: giver   !! its vertices may be replaced by near ones
        real(dp), intent(in) :: gap                 !! how near is on the arc, deck units
        type(mesh_type), intent(in) :: mesh         !! has the vertices
        type(strand_type), intent(inout) :: taker   !! gets vertices
        real(dp) :: t, distance
        logical :: is_end(2)
        integer :: i, after, nearest

        do i = 1, size(giver%vertex)
            if (any(taker%vertex == giver%vertex(i))) cycle
            call find_nearest(taker%arc, mesh%vertices(2:, giver%vertex(i)), t, distance)
            if (distance > gap) cycle
            if (.not. (t > 0.0_dp .and. t < 1.0_dp)) cycle
            after = count(taker%t < t) + 1
            nearest = near_neighbour(taker, after, mesh%vertices(:, giver%vertex(i)), mesh)
            is_end = [is_end_of(giver, i), is_end_of(taker, nearest)]
            if (nearest > 0 .and. .not. is_end(1)) then
                if (can_be(giver, taker%vertex(nearest), gap, mesh)) then
                    giver%vertex(i) = taker%vertex(nearest)
                    cycle
                end if
            end if
            if (nearest > 0 .and. is_end(1) .and. .not. is_end(2)) then
                taker%vertex(nearest) = giver%vertex(i)
                taker%share(nearest) = share_at(taker, after, t)
                taker%t(nearest) = t
            else
                call insert(taker, after, share_at(taker, after, t), t, giver%vertex(i))
            end if
        end do
    end subroutine share_vertices

    !> True where a vertex of another strand can be one of a strand: it is not, and is on its arc.
    pure logical function can_be(strand, vertex, gap, mesh)
        type(strand_type), intent(in) :: strand !! any
        integer, intent(in) :: vertex           !! of another
        real(dp), intent(in) :: gap             !! how near is on the arc, deck units
        type(mesh_type), intent(in) :: mesh     !! has the vertices
        real(dp) :: t, distance

        call find_nearest(strand%arc, mesh%vertices(2:, vertex), t, distance)
        can_be = distance <= gap .and. all(strand%vertex /= vertex)
    end function can_be

    !> True for the first and the last vertex of a strand.
    pure logical function is_end_of(strand, place)
        type(strand_type), intent(in) :: strand !! any
        integer, intent(in) :: place            !! of a vertex in it
        is_end_of = place == 1 .or. place == size(strand%vertex)
    end function is_end_of

    !> The place in a strand of a vertex that a point of its arc is near to, or 0.
    pure integer function near_neighbour(strand, after, at, mesh) result(nearest)
        type(strand_type), intent(in) :: strand !! any
        integer, intent(in) :: after            !! place of the next vertex behind the point
        real(dp), intent(in) :: at(3)           !! the point
        type(mesh_type), intent(in) :: mesh     !! has the vertices
        real(dp) :: far(2), step

        associate (before => mesh%vertices(:, strand%vertex(after - 1)), &
            behind => mesh%vertices(:, strand%vertex(after)))
            far = [norm2(at - before), norm2(at - behind)]
            step = norm2(behind - before)
        end associate
        nearest = 0
        if (minval(far) > near*step) return
        nearest = merge(after - 1, after, far(1) <= far(2))
    end function near_neighbour

    !> The point of an arc that is nearest to another: the best of evenly spread ones, then a search
    !> by golden section on both sides of it.
    pure subroutine find_nearest(arc, at, t, distance)
        type(arc_type), intent(in) :: arc       !! any
        real(dp), intent(in) :: at(2)           !! BL, WL, deck units
        real(dp), intent(out) :: t              !! its parameter, 0 to 1
        real(dp), intent(out) :: distance       !! deck units
        real(dp) :: low, high, inner(2), far(2)
        real(dp), parameter :: golden = 0.5_dp*(sqrt(5.0_dp) - 1.0_dp)
        integer :: i, best

        best = minloc([(distance_at(real(i, dp)/real(parts, dp)), i=0, parts)], dim=1) - 1
        low = real(max(best - 1, 0), dp)/real(parts, dp)
        high = real(min(best + 1, parts), dp)/real(parts, dp)
        do i = 1, halvings
            inner = [high - golden*(high - low), low + golden*(high - low)]
            far = [distance_at(inner(1)), distance_at(inner(2))]
            if (far(1) < far(2)) high = inner(2)
            if (far(1) >= far(2)) low = inner(1)
        end do
        t = parameter_at(0.5_dp*(low + high), weight(arc))
        distance = norm2(point(arc, place_at(t)) - at)
        if (distance_at(0.0_dp) <= distance) t = 0.0_dp
        if (distance_at(1.0_dp) <= distance) t = 1.0_dp
    contains
        !> How far the arc is from the point at a share.
        pure real(dp) function distance_at(share)
            real(dp), intent(in) :: share !! 0 to 1
            distance_at = norm2(point(arc, place_at(parameter_at(share, weight(arc)))) - at)
        end function distance_at
    end subroutine find_nearest

    !> Gives two strands a vertex where their sides cross.
    pure subroutine cross_strands(first, second, mesh)
        type(strand_type), intent(inout) :: first   !! at a station
        type(strand_type), intent(inout) :: second  !! at the same
        type(mesh_type), intent(inout) :: mesh      !! gets the vertices
        real(dp) :: ways(2), at(3)
        integer :: i, k

        i = 2
        do while (i <= size(first%vertex))
            k = 2
            do while (k <= size(second%vertex))
                associate (one => first%vertex(i - 1:i), other => second%vertex(k - 1:k))
                    ways = 0.0_dp
                    if (all(one /= other(1) .and. one /= other(2))) call find_crossing( &
                        mesh%vertices(2:, one), mesh%vertices(2:, other), ways)
                    at = (1.0_dp - ways(1))*mesh%vertices(:, one(1)) &
                        + ways(1)*mesh%vertices(:, one(2))
                end associate
                if (all(ways > 0.0_dp .and. ways < 1.0_dp)) then
                    call add_vertex(mesh, [mesh%vertices(1, first%vertex(i)), at(2:)])
                    call insert_between(first, i, ways(1), mesh%vertex_count)
                    call insert_between(second, k, ways(2), mesh%vertex_count)
                    k = k + 1
                end if
                k = k + 1
            end do
            i = i + 1
        end do
    end subroutine cross_strands

    !> Where two straight lines cross: parts of the way along each; both 0 where they do not.
    pure subroutine find_crossing(first, second, ways)
        real(dp), intent(in) :: first(2, 2)     !! its ends by columns
        real(dp), intent(in) :: second(2, 2)    !! its ends by columns
        real(dp), intent(out) :: ways(2)        !! 0 to 1 where they cross
        real(dp) :: p(2), q(2), apart(2), area

        ways = 0.0_dp
        p = first(:, 2) - first(:, 1)
        q = second(:, 2) - second(:, 1)
        apart = second(:, 1) - first(:, 1)
        area = cross(p, q)
        if (abs(area) <= tiny(area)) return
        if (abs(cross(apart, q)) >= abs(area) .or. abs(cross(apart, p)) >= abs(area)) return
        ways = [cross(apart, q), cross(apart, p)]/area
    end subroutine find_crossing

    !> The share of a strand at a parameter, between its neighbours.
    pure real(dp) function share_at(strand, after, t) result(share)
        type(strand_type), intent(in) :: strand !! any
        integer, intent(in) :: after            !! place of the next vertex behind it
        real(dp), intent(in) :: t               !! the parameter
        share = strand%share(after - 1) + (strand%share(after) - strand%share(after - 1)) &
            *(t - strand%t(after - 1))/(strand%t(after) - strand%t(after - 1))
    end function share_at

    !> Puts a vertex into a strand, on the straight side between two others.
    pure subroutine insert_between(strand, before, way, vertex)
        type(strand_type), intent(inout) :: strand  !! gets it
        integer, intent(in) :: before               !! place of the vertex it is put before
        real(dp), intent(in) :: way                 !! where on that side, 0 to 1
        integer, intent(in) :: vertex               !! in the mesh
        real(dp) :: t

        t = strand%t(before - 1) + way*(strand%t(before) - strand%t(before - 1))
        call insert(strand, before, share_at(strand, before, t), t, vertex)
    end subroutine insert_between

    !> Puts a vertex into a strand.
    pure subroutine insert(strand, before, share, t, vertex)
        type(strand_type), intent(inout) :: strand  !! gets it
        integer, intent(in) :: before               !! place of the vertex it is put before
        real(dp), intent(in) :: share               !! its share
        real(dp), intent(in) :: t                   !! its parameter
        integer, intent(in) :: vertex               !! in the mesh
        strand%vertex = [strand%vertex(:before - 1), vertex, strand%vertex(before:)]
        strand%share = [strand%share(:before - 1), share, strand%share(before:)]
        strand%t = [strand%t(:before - 1), t, strand%t(before:)]
    end subroutine insert

end module export_mesh_seam
