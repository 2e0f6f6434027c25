!> A faired outline as a cut at its station, for tables, CSV and pictures: points at equal length,
!> with slope and curvature.
module cut_faired
    use base_kinds, only: dp
    use base_error, only: error_type
    use body_outline, only: outline_type
    use cut_outline, only: cut_point_type, cut_type, note_type, plain_outline_type => outline_type
    use cut_plane, only: plane_type, station_plane, true_shape
    use geom_arc_point, only: slope_along
    use geom_fairing_curve, only: uniform_segments
    use geom_place, only: place_at, place_type
    use geom_stroke, only: bezier_stroke, stroke_curvature, stroke_jet, stroke_part, stroke_point, &
        stroke_tangent, stroke_type
    use geom_stroke_length, only: stroke_length
    implicit none (type, external)
    private

    public :: faired_cut, measured_cut, ring_length

    !> Points of an outline in tables, at equal length.
    integer, parameter, public :: points_around = 36
    !> Steps of Newton's at most, and the way of the parameter that ends them.
    integer, parameter :: most_steps = 20
    real(dp), parameter :: shortest_step = 1.0e-13_dp

contains

    !> The outline with points at equal length, counter-clockwise or clockwise as those measured.
    !>
    !> Fails with `cause%no_convergence`, from quadrature.
    pure subroutine faired_cut(outline, number, cut, error)
        type(outline_type), intent(in) :: outline           !! faired
        integer, intent(in) :: number                       !! of points, 1 or more
        type(cut_type), intent(out) :: cut                  !! one outline, without pieces
        type(error_type), allocatable, intent(out) :: error !! see above
        type(stroke_type), allocatable :: strokes(:)
        real(dp), allocatable :: length(:)
        real(dp) :: from, target
        integer :: i, k

        call begin_cut(outline, number, cut)
        allocate (strokes(0))
        strokes = strokes_of(outline%fairing%vertex)
        call measure(strokes, length, error)
        if (allocated(error)) return
        k = 1
        from = 0.0_dp
        do i = 1, number
            target = real(i - 1, dp)/real(number, dp)*sum(length)
            do while (target > from + length(k) .and. k < size(length))
                from = from + length(k)
                k = k + 1
            end do
            call put_point(outline%sta, strokes(k), place_at_length(strokes(k), target - from, &
                length(k)), cut%plane, cut%outlines(1)%points(i))
        end do
    end subroutine faired_cut

    !> The length of a closed uniform cubic B-spline, deck units.
    !>
    !> Fails with `cause%no_convergence`, from quadrature.
    pure subroutine ring_length(vertex, length, error)
        real(dp), intent(in) :: vertex(:, :)                !! deck units, shape (2, vertices)
        real(dp), intent(out) :: length                     !! deck units
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp), allocatable :: lengths(:)
        call measure(strokes_of(vertex), lengths, error)
        length = sum(lengths)
    end subroutine ring_length

    !> The measured points as a cut: for pictures.
    pure function measured_cut(outline) result(cut)
        type(outline_type), intent(in) :: outline !! faired
        type(cut_type) :: cut
        integer :: i

        call begin_cut(outline, size(outline%measured%point, 2), cut)
        do i = 1, size(outline%measured%point, 2)
            associate (point => cut%outlines(1)%points(i))
                point%at = [outline%sta, outline%measured%point(:, i)]
                point%uv = true_shape(cut%plane, point%at)
                point%section = 1
            end associate
        end do
    end function measured_cut

    !> A cut at the station of an outline, with room for points.
    pure subroutine begin_cut(outline, number, cut)
        type(outline_type), intent(in) :: outline   !! faired
        integer, intent(in) :: number               !! of points
        type(cut_type), intent(out) :: cut          !! gets a closed outline
        type(plain_outline_type) :: closed
        type(note_type) :: none(0)

        cut%plane = station_plane(outline%sta)
        cut%name = outline%name
        cut%arcs = outline%arcs
        closed%is_closed = .true.
        allocate (closed%pieces(0), closed%points(number))
        allocate (cut%outlines(1), source=closed)
        allocate (cut%inside(0))
        allocate (cut%notes, source=none)
    end subroutine begin_cut

    !> The segments of a closed uniform cubic B-spline.
    pure function strokes_of(vertex) result(strokes)
        real(dp), intent(in) :: vertex(:, :) !! deck units, shape (2, vertices)
        type(stroke_type), allocatable :: strokes(:)
        real(dp), allocatable :: pole(:, :, :)
        integer :: i

        allocate (pole, source=uniform_segments(vertex, .true.))
        allocate (strokes(size(pole, 3)))
        do i = 1, size(strokes)
            strokes(i) = bezier_stroke(pole(:, :, i))
        end do
    end function strokes_of

    !> The lengths of strokes.
    !>
    !> Fails with `cause%no_convergence`.
    pure subroutine measure(strokes, length, error)
        type(stroke_type), intent(in) :: strokes(:)             !! in order
        real(dp), allocatable, intent(out) :: length(:)         !! deck units
        type(error_type), allocatable, intent(out) :: error     !! see above
        integer :: i

        allocate (length(size(strokes)), source=0.0_dp)
        do i = 1, size(strokes)
            call stroke_length(strokes(i), length(i), error)
            if (allocated(error)) return
        end do
    end subroutine measure

    !> The place at a length from the start of a stroke: Newton's method, kept on the stroke. A
    !> length that rounding keeps from its tolerance does as it is.
    pure type(place_type) function place_at_length(stroke, target, whole) result(place)
        type(stroke_type), intent(in) :: stroke     !! a segment
        real(dp), intent(in) :: target              !! deck units, 0 to `whole`
        real(dp), intent(in) :: whole               !! length of the stroke, deck units
        type(error_type), allocatable :: rough
        real(dp) :: t, next, length, at(2), first(2), second(2)
        integer :: i

        t = 0.0_dp
        if (whole > 0.0_dp) t = target/whole
        do i = 1, most_steps
            call stroke_length(stroke_part(stroke, place_at(0.0_dp), place_at(t)), length, rough)
            call stroke_jet(stroke, t, at, first, second)
            if (.not. norm2(first) > 0.0_dp) exit
            next = min(1.0_dp, max(0.0_dp, t + (target - length)/norm2(first)))
            if (abs(next - t) <= shortest_step) exit
            t = next
        end do
        place = place_at(t)
    end function place_at_length

    !> A point with slope dWL/dBL and curvature.
    pure subroutine put_point(sta, stroke, place, plane, point)
        real(dp), intent(in) :: sta                     !! deck units
        type(stroke_type), intent(in) :: stroke         !! a segment
        type(place_type), intent(in) :: place           !! where on it
        type(plane_type), intent(in) :: plane           !! of the station
        type(cut_point_type), intent(inout) :: point    !! gets it
        real(dp) :: way(2)

        point%at = [sta, stroke_point(stroke, place)]
        point%uv = true_shape(plane, point%at)
        point%section = 1
        way = stroke_tangent(stroke, place)
        point%has_slope = norm2(way) > 0.0_dp
        if (.not. point%has_slope) return
        point%slope = slope_along(way)
        point%has_curvature = .true.
        point%curvature = stroke_curvature(stroke, place)
    end subroutine put_point

end module cut_faired
