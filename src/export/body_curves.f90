!> The curves of a body as points close together: views of control lines, outlines of cuts. Arcs are
!> followed as closely as they bend (`export_polyline`), not by so many points each.
module export_body_curves
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_line, only: line_type
    use cut_outline, only: cut_type, has_panels, outline_type
    use cut_plane, only: true_shape
    use export_body_drawing, only: stroke_type
    use export_polyline, only: polyline
    use geom_chain, only: chain_type
    implicit none (type, external)
    private

    public :: gather_outlines
    public :: chain_strokes, outline_points, on_paper, body_range, swept_area, mirror_in_plane

contains

    !> The strokes of a view of a line, each a row of station and ordinate. A constant is drawn over
    !> the stations given.
    pure function chain_strokes(chain, range) result(strokes)
        type(chain_type), intent(in) :: chain           !! the view
        real(dp), intent(in) :: range(2)                !! stations, deck units
        type(stroke_type), allocatable :: strokes(:)
        integer :: i

        if (chain%is_constant) then
            allocate (strokes(1))
            strokes(1)%at = reshape([range(1), chain%constant, range(2), chain%constant], [2, 2])
        else
            allocate (strokes(size(chain%stroke)))
            do i = 1, size(chain%stroke)
                strokes(i)%at = polyline(chain%stroke(i))
            end do
        end if
    end function chain_strokes

    !> The least and greatest station of the sections of some bodies; nought and nought where there
    !> are none.
    pure function body_range(bodies) result(range)
        type(body_type), intent(in) :: bodies(:)    !! finished
        real(dp) :: range(2)
        integer :: i

        range = [huge(1.0_dp), -huge(1.0_dp)]
        do i = 1, size(bodies)
            range(1) = min(range(1), minval(bodies(i)%sections%from))
            range(2) = max(range(2), maxval(bodies(i)%sections%to))
        end do
        if (range(1) > range(2)) range = 0.0_dp
    end function body_range

    !> Gathers the outlines of a cut, on sections and on panels. (Of a function gfortran 12 would
    !> lose what the outlines hold.)
    pure subroutine gather_outlines(cut, outlines)
        type(cut_type), intent(in) :: cut                               !! any
        type(outline_type), allocatable, intent(out) :: outlines(:)     !! those of sections first
        integer :: on_sections, on_panels

        on_sections = size(cut%outlines)
        on_panels = 0
        if (has_panels(cut)) on_panels = size(cut%patched)
        allocate (outlines(on_sections + on_panels))
        outlines(:on_sections) = cut%outlines
        if (on_panels > 0) outlines(on_sections + 1:) = cut%patched
    end subroutine gather_outlines

    !> STA, BL and WL along an outline, by columns. A station follows its arcs; the points of other
    !> cuts stand as close as they were asked to.
    pure function outline_points(outline) result(at)
        type(outline_type), intent(in) :: outline !! of a cut, with at least one point
        real(dp), allocatable :: at(:, :)
        real(dp), allocatable :: arc(:, :), grown(:, :)
        integer :: i, before, new

        allocate (at(3, 0))
        if (allocated(outline%pieces)) then
            do i = 1, size(outline%pieces)
                if (.not. outline%pieces(i)%is_arc) exit
                arc = polyline(outline%pieces(i)%arc)
                before = size(at, 2)
                new = size(arc, 2)
                allocate (grown(3, before + new))
                grown(:, :before) = at
                grown(1, before + 1:) = outline%pieces(i)%from
                grown(2:, before + 1:) = arc
                call move_alloc(grown, at)
            end do
        end if
        if (size(at, 2) == 0) then
            deallocate (at)
            allocate (at(3, size(outline%points)))
            do i = 1, size(outline%points)
                at(:, i) = outline%points(i)%at
            end do
        end if
        if (outline%is_closed) at = reshape([at, at(:, 1)], [3, size(at, 2) + 1])
    end function outline_points

    !> Points of the plane of a cut in its true-shape coordinates, by columns.
    pure function on_paper(cut, at) result(uv)
        type(cut_type), intent(in) :: cut       !! the cut
        real(dp), intent(in) :: at(:, :)        !! STA, BL, WL by columns, deck units
        real(dp) :: uv(2, size(at, 2))
        integer :: i
        do i = 1, size(at, 2)
            uv(:, i) = true_shape(cut%plane, at(:, i))
        end do
    end function on_paper

    !> The mirror image in BL 0 of points, by columns.
    pure function mirror_in_plane(at) result(image)
        real(dp), intent(in) :: at(:, :) !! STA, BL, WL by columns, deck units
        real(dp) :: image(size(at, 1), size(at, 2))
        image = at
        image(2, :) = -at(2, :)
    end function mirror_in_plane

    !> The area between the outlines of a station and BL 0, of any sign: how great a section is
    !> among its neighbours.
    pure real(dp) function swept_area(cut) result(area)
        type(cut_type), intent(in) :: cut !! a station
        real(dp), allocatable :: at(:, :)
        integer :: i, k

        area = 0.0_dp
        do i = 1, size(cut%outlines)
            at = outline_points(cut%outlines(i))
            do k = 2, size(at, 2)
                area = area + 0.5_dp*(at(2, k) + at(2, k - 1))*(at(3, k) - at(3, k - 1))
            end do
        end do
    end function swept_area

end module export_body_curves
