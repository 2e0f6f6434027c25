!> Shapes for tests of exports, of closed form: circles as exact rational splines, and rectangles.
module support_shapes
    use base_kinds, only: dp
    use cut_plane, only: in_space, plane_type
    use export_drawing, only: contour_type, drawing_type, mark_type, shape_type
    use geom_arc_spline, only: line_spline
    use geom_bspline, only: bspline_type
    implicit none (type, external)
    private

    public :: new_shape, add_circle, add_rectangle, add_path, new_drawing

    !> Weight of a quarter of a circle.
    real(dp), parameter :: quarter = sqrt(0.5_dp)

contains

    !> A drawing of shapes, in inches.
    pure type(drawing_type) function new_drawing(shapes) result(drawing)
        type(shape_type), intent(in) :: shapes(:) !! its cuts

        drawing%deck = 'test.crd'
        drawing%title = 'SHAPES OF CLOSED FORM'
        drawing%units = 'INCHES'
        drawing%tolerance = 1.0e-3_dp
        allocate (drawing%cuts, source=shapes)
        allocate (drawing%lines(0))
    end function new_drawing

    !> A shape without contours.
    pure type(shape_type) function new_shape(name, title, plane) result(shape)
        character(*), intent(in) :: name        !! letters, figures, - _ .
        character(*), intent(in) :: title       !! any bytes
        type(plane_type), intent(in) :: plane   !! its plane

        shape%name = name
        shape%title = title
        shape%kind = plane%kind
        shape%plane = plane
        allocate (shape%contours(0))
    end function new_shape

    !> Adds a circle in u and v, counter-clockwise from its right, with bevels at even angles.
    pure subroutine add_circle(shape, centre, radius, is_inside, marks)
        type(shape_type), intent(inout) :: shape    !! gets it
        real(dp), intent(in) :: centre(2)           !! in u and v
        real(dp), intent(in) :: radius              !! units of the drawing
        logical, intent(in) :: is_inside            !! of the inside of the skin
        integer, intent(in) :: marks                !! how many bevels
        type(contour_type) :: contour
        real(dp) :: from(2), to(2), angle
        integer :: i

        contour%is_closed = .true.
        contour%is_inside = is_inside
        allocate (contour%curves(4), contour%marks(marks))
        do i = 1, 4
            from = circle_point(i - 1)
            to = circle_point(i)
            contour%curves(i)%is_exact = .true.
            contour%curves(i)%spline = arc_of(shape%plane, centre + radius*from, &
                centre + radius*(from + to), centre + radius*to)
        end do
        do i = 1, marks
            angle = 2.0_dp*acos(-1.0_dp)*real(i - 1, dp)/real(marks, dp)
            contour%marks(i)%outward = [cos(angle), sin(angle)]
            contour%marks(i)%uv = centre + radius*contour%marks(i)%outward
            contour%marks(i)%bevel = 12.0_dp*cos(angle)
        end do
        call append(shape, contour)
    end subroutine add_circle

    !> A corner of the circle of radius 1, by quarters.
    pure function circle_point(quarters) result(at)
        integer, intent(in) :: quarters !! from the right, counter-clockwise
        real(dp) :: at(2)
        real(dp), parameter :: corners(2, 0:3) = reshape([1.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, &
            -1.0_dp, 0.0_dp, 0.0_dp, -1.0_dp], [2, 4])
        at = corners(:, mod(quarters, 4))
    end function circle_point

    !> A quarter of a circle by its control points.
    pure type(bspline_type) function arc_of(plane, from, corner, to) result(spline)
        type(plane_type), intent(in) :: plane   !! where u and v are
        real(dp), intent(in) :: from(2)         !! where it begins
        real(dp), intent(in) :: corner(2)       !! where its tangents meet
        real(dp), intent(in) :: to(2)           !! where it ends

        spline%degree = 2
        allocate (spline%knot(6), spline%weight(3), spline%pole(3, 3))
        spline%knot = [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
        spline%weight = [1.0_dp, quarter, 1.0_dp]
        spline%pole(:, 1) = in_space(plane, from)
        spline%pole(:, 2) = in_space(plane, corner)
        spline%pole(:, 3) = in_space(plane, to)
    end function arc_of

    !> Adds a rectangle in u and v, counter-clockwise from its lower left corner.
    pure subroutine add_rectangle(shape, low, high)
        type(shape_type), intent(inout) :: shape    !! gets it
        real(dp), intent(in) :: low(2)              !! its lower left corner
        real(dp), intent(in) :: high(2)             !! its upper right corner
        call add_path(shape, reshape([low, high(1), low(2), high, low(1), high(2), low], [2, 5]))
    end subroutine add_rectangle

    !> Adds straight lines from point to point in u and v; closed where the last is the first.
    pure subroutine add_path(shape, points)
        type(shape_type), intent(inout) :: shape    !! gets them
        real(dp), intent(in) :: points(:, :)        !! by columns
        type(contour_type) :: contour
        integer :: i

        allocate (contour%curves(size(points, 2) - 1), contour%marks(0))
        contour%is_closed = all(abs(points(:, 1) - points(:, size(points, 2))) <= 0.0_dp)
        do i = 1, size(contour%curves)
            contour%curves(i)%is_exact = .true.
            contour%curves(i)%spline = line_spline(in_space(shape%plane, points(:, i)), &
                in_space(shape%plane, points(:, i + 1)))
        end do
        call append(shape, contour)
    end subroutine add_path

    !> Adds a contour.
    pure subroutine append(shape, contour)
        type(shape_type), intent(inout) :: shape    !! gets it
        type(contour_type), intent(in) :: contour   !! the contour
        type(contour_type), allocatable :: grown(:)

        allocate (grown(size(shape%contours) + 1))
        grown(:size(shape%contours)) = shape%contours
        grown(size(grown)) = contour
        call move_alloc(grown, shape%contours)
    end subroutine append

end module support_shapes
