!> A part of a pattern while it is drawn: its page, the room that is taken, and its contours as
!> cubic Bezier arcs in inches. The origin of the shape's u and v is that of the page until all is
!> drawn.
module export_pattern_part
    use base_kinds, only: dp
    use cut_plane, only: in_space
    use export_drawing, only: contour_type, shape_type
    use export_pattern_page, only: page_type
    use export_pattern_room, only: room_type
    use export_pattern_style, only: style
    use export_receipt, only: entity_type, receipt_type
    use geom_bspline, only: bspline_type, mapped_spline
    use geom_spline_cubics, only: cubics_of
    use geom_vector, only: image
    implicit none (type, external)
    private

    public :: trace_type, part_type, new_part, is_inside_outline, bezier_points

    !> A contour on paper.
    type :: trace_type
        logical :: is_closed = .false.          !! it comes back to its first point
        logical :: is_inside = .false.          !! of the inside of the skin
        real(dp), allocatable :: control(:, :)  !! Bezier arcs end to end: 3n + 1 points, in
        real(dp), allocatable :: flat(:, :)     !! points of it, near enough for words, in
        real(dp) :: error = 0.0_dp              !! distance from the exact contour, measured, in
        real(dp) :: worst(3) = 0.0_dp           !! where it is: STA, BL, WL, unit of the drawing
    end type trace_type

    !> A part.
    type :: part_type
        type(page_type) :: page                     !! what is drawn
        type(room_type) :: room                     !! what is taken
        type(trace_type), allocatable :: traces(:)  !! the contours that are no points
        real(dp) :: inch = 1.0_dp                   !! inches of a unit of the drawing
        real(dp) :: box(4) = 0.0_dp                 !! around the contours: left, bottom, right, top
        logical :: is_region = .false.              !! its outlines close, or are closed by the fold
        integer :: fold = 0                         !! 1, 2: BL 0 closes it, across u or v; 0: no
        real(dp) :: fold_at = 0.0_dp                !! u or v of BL 0, in
        real(dp) :: error = 0.0_dp                  !! largest of the outlines, in
    end type part_type

    !> What rounding in the file adds to an error, in: PDF has five decimals of a 72nd, SVG four of
    !> a thousandth of an inch, in each of two directions.
    real(dp), parameter :: rounding = 1.0e-7_dp
    !> Nearer than this to the fold is on it, in.
    real(dp), parameter :: on_centre = 1.0e-4_dp
    !> Straight pieces that stand for a Bezier arc where words are placed.
    integer, parameter :: pieces = 12
    !> What is left of the tolerance for Bezier arcs, at least, in parts of it.
    real(dp), parameter :: least_share = 0.1_dp

contains

    !> Traces the contours of a shape, draws them and puts them to the receipt.
    pure subroutine new_part(shape, inch, tolerance, part, receipt)
        type(shape_type), intent(in) :: shape           !! what is drawn
        real(dp), intent(in) :: inch                    !! inches of a unit of the drawing
        real(dp), intent(in) :: tolerance               !! above zero, in units of the drawing
        type(part_type), intent(out) :: part            !! with its outlines
        type(receipt_type), intent(inout) :: receipt    !! gets an entity for each contour
        integer :: i, count

        part%inch = inch
        allocate (part%traces(size(shape%contours)))
        call part%page%open_group(shape%name, shape%title)
        count = 0
        do i = 1, size(shape%contours)
            if (size(shape%contours(i)%curves) == 0) cycle
            count = count + 1
            call trace(shape, shape%contours(i), inch, tolerance, part%traces(count))
            call receipt%add(entity_of(shape%name, part%traces(count), inch))
        end do
        part%traces = part%traces(:count)
        if (count == 0) return
        part%box(:2) = huge(1.0_dp)
        part%box(3:) = -huge(1.0_dp)
        do i = 1, count
            associate (t => part%traces(i))
                call part%page%draw_curves(merge(style%inside, style%outline, t%is_inside), &
                    t%control, t%is_closed)
                call part%room%take_line(t%flat)
                part%box(:2) = min(part%box(:2), minval(t%flat, dim=2))
                part%box(3:) = max(part%box(3:), maxval(t%flat, dim=2))
                part%error = max(part%error, t%error)
            end associate
        end do
        call set_fold(shape, part)
        part%is_region = all([(closes(part, part%traces(i)), i=1, count)])
    end subroutine new_part

    !> Sets where BL 0 is, of a half; the box reaches so far. The plane of a half is across BL 0.
    pure subroutine set_fold(shape, part)
        type(shape_type), intent(in) :: shape   !! any
        type(part_type), intent(inout) :: part  !! gets it
        real(dp) :: across(2)

        if (.not. shape%is_half) return
        across = [shape%plane%u(2), shape%plane%v(2)]
        part%fold = maxloc(abs(across), dim=1)
        part%fold_at = -part%inch*shape%plane%origin(2)/across(part%fold)
        part%box(part%fold) = min(part%box(part%fold), part%fold_at)
        part%box(part%fold + 2) = max(part%box(part%fold + 2), part%fold_at)
    end subroutine set_fold

    !> True for a contour that comes back to its start, by itself or along the fold.
    pure logical function closes(part, traced)
        type(part_type), intent(in) :: part         !! has the fold
        type(trace_type), intent(in) :: traced      !! one of its contours

        closes = traced%is_closed
        if (closes .or. part%fold == 0) return
        closes = all(abs(traced%control(part%fold, [1, size(traced%control, 2)]) - &
            part%fold_at) < on_centre)
    end function closes

    !> Traces a contour.
    pure subroutine trace(shape, contour, inch, tolerance, traced)
        type(shape_type), intent(in) :: shape           !! it is of this shape
        type(contour_type), intent(in) :: contour       !! of at least one curve
        real(dp), intent(in) :: inch                    !! inches of a unit of the drawing
        real(dp), intent(in) :: tolerance               !! units of the drawing
        type(trace_type), intent(out) :: traced         !! the contour on paper
        type(bspline_type) :: flat
        real(dp), allocatable :: arcs(:, :, :)
        real(dp) :: largest, worst(2), left
        integer :: i

        traced%is_closed = contour%is_closed
        traced%is_inside = contour%is_inside
        do i = 1, size(contour%curves)
            call flatten(shape, contour%curves(i)%spline, inch, flat)
            left = inch*(tolerance - contour%curves(i)%error) - rounding
            call cubics_of(flat, max(left, least_share*inch*tolerance), arcs, largest, worst)
            call append(traced%control, arcs)
            associate (curve => contour%curves(i))
                if (i > 1 .and. largest + inch*curve%error <= traced%error) cycle
                traced%error = largest + inch*curve%error
                traced%worst = curve%worst
                if (largest >= inch*curve%error) traced%worst = in_space(shape%plane, worst/inch)
            end associate
        end do
        traced%error = traced%error + rounding
        associate (last => size(traced%control, 2))
            if (traced%is_closed) traced%control(:, last) = traced%control(:, 1)
        end associate
        call sample(traced%control, traced%flat)
    end subroutine trace

    !> A curve in the plane of its shape, in inches.
    pure subroutine flatten(shape, spline, inch, flat)
        type(shape_type), intent(in) :: shape       !! has the plane
        type(bspline_type), intent(in) :: spline    !! in space
        real(dp), intent(in) :: inch                !! inches of a unit of the drawing
        type(bspline_type), intent(out) :: flat     !! in two dimensions
        real(dp) :: axes(2, 3)

        axes(1, :) = inch*shape%plane%u
        axes(2, :) = inch*shape%plane%v
        call mapped_spline(spline, axes, -image(axes, shape%plane%origin), flat)
    end subroutine flatten

    !> Adds Bezier arcs at the end of others: the first point of the first falls on the last one.
    pure subroutine append(control, arcs)
        real(dp), allocatable, intent(inout) :: control(:, :)   !! 3n + 1 points, or none yet
        real(dp), intent(in) :: arcs(:, :, :)                   !! end to end: (2, 4, :)
        real(dp), allocatable :: grown(:, :)
        integer :: i, count

        count = 1
        if (allocated(control)) count = size(control, 2)
        allocate (grown(2, count + 3*size(arcs, 3)))
        grown(:, 1) = arcs(:, 1, 1)
        if (allocated(control)) grown(:, :count) = control
        do i = 1, size(arcs, 3)
            grown(:, count + 3*i - 2:count + 3*i) = arcs(:, 2:, i)
        end do
        call move_alloc(grown, control)
    end subroutine append

    !> Points of Bezier arcs, ends among them.
    pure subroutine sample(control, points)
        real(dp), intent(in) :: control(:, :)               !! 3n + 1 points
        real(dp), allocatable, intent(out) :: points(:, :)  !! by columns
        integer :: i, arcs

        arcs = (size(control, 2) - 1)/3
        allocate (points(2, pieces*arcs + 1))
        points(:, 1) = control(:, 1)
        do i = 1, arcs
            points(:, pieces*(i - 1) + 1:pieces*i + 1) = &
                bezier_points(control(:, 3*i - 2:3*i + 1), pieces)
        end do
    end subroutine sample

    !> Points of a Bezier arc at even steps of its parameter, both ends among them.
    pure function bezier_points(control, steps) result(points)
        real(dp), intent(in) :: control(2, 4)   !! its control points
        integer, intent(in) :: steps            !! from end to end
        real(dp) :: points(2, steps + 1), t, s
        integer :: i

        do i = 0, steps
            t = real(i, dp)/real(steps, dp)
            s = 1.0_dp - t
            points(:, i + 1) = s**3*control(:, 1) + 3.0_dp*s*t*(s*control(:, 2) + &
                t*control(:, 3)) + t**3*control(:, 4)
        end do
    end function bezier_points

    !> What the receipt says of a contour.
    pure type(entity_type) function entity_of(name, traced, inch) result(entity)
        character(*), intent(in) :: name            !! of its shape
        type(trace_type), intent(in) :: traced      !! what is drawn
        real(dp), intent(in) :: inch                !! inches of a unit of the drawing

        entity%name = name
        entity%kind = 'BEZIER OUTLINE'
        if (traced%is_inside) entity%kind = 'BEZIER INSIDE OF SKIN'
        entity%points = size(traced%control, 2)
        entity%spans = (entity%points - 1)/3
        entity%error = traced%error/inch
        entity%has_place = .true.
        entity%worst = traced%worst
    end function entity_of

    !> True for a point inside of the outlines, by the crossings of a line to its right.
    pure logical function is_inside_outline(part, at) result(is_inside)
        type(part_type), intent(in) :: part     !! its outlines close
        real(dp), intent(in) :: at(2)           !! in
        integer :: i, k, next
        real(dp) :: t

        is_inside = .false.
        do i = 1, size(part%traces)
            if (part%traces(i)%is_inside) cycle
            associate (p => part%traces(i)%flat)
                do k = 1, size(p, 2)
                    next = mod(k, size(p, 2)) + 1
                    if (p(2, k) > at(2) .eqv. p(2, next) > at(2)) cycle
                    t = (at(2) - p(2, k))/(p(2, next) - p(2, k))
                    if (p(1, k) + t*(p(1, next) - p(1, k)) > at(1)) is_inside = .not. is_inside
                end do
            end associate
        end do
    end function is_inside_outline

end module export_pattern_part
