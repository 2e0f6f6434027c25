!> Drawings whose exact shape is a closed form: circles, ellipses, straight pieces, in any plane.
module support_sketch
    use base_kinds, only: dp
    use cut_plane, only: in_space, plane_type, station_plane
    use export_drawing, only: contour_type, curve_type, drawing_type, shape_kind, shape_type
    implicit none (type, external)
    private

    public :: new_drawing, new_shape, add_shape, add_contour, ellipse, segment, new_contour
    public :: line_curve

contains

    !> A drawing without shapes, in inches.
    pure type(drawing_type) function new_drawing(tolerance) result(drawing)
        real(dp), intent(in) :: tolerance   !! of curves
        drawing%deck = 'sketch.crd'
        drawing%title = 'SKETCH'
        drawing%units = 'INCHES'
        drawing%tolerance = tolerance
        allocate (drawing%cuts(0), drawing%lines(0))
    end function new_drawing

    !> A station without contours.
    pure type(shape_type) function new_shape(name, sta) result(shape)
        character(*), intent(in) :: name    !! of the shape
        real(dp), intent(in) :: sta         !! inches
        shape%name = name
        shape%title = 'STATION '//name
        shape%kind = shape_kind%station
        shape%number = 1
        shape%plane = station_plane(sta)
        allocate (shape%contours(0))
    end function new_shape

    !> Adds a shape to the cuts of a drawing.
    subroutine add_shape(drawing, shape)
        type(drawing_type), intent(inout) :: drawing    !! gets it
        type(shape_type), intent(in) :: shape           !! a cut
        type(shape_type), allocatable :: grown(:)
        allocate (grown(size(drawing%cuts) + 1))
        grown(:size(drawing%cuts)) = drawing%cuts
        grown(size(grown)) = shape
        call move_alloc(grown, drawing%cuts)
    end subroutine add_shape

    !> Adds a contour to a shape.
    subroutine add_contour(shape, contour)
        type(shape_type), intent(inout) :: shape    !! gets it
        type(contour_type), intent(in) :: contour   !! in its plane
        type(contour_type), allocatable :: grown(:)
        allocate (grown(size(shape%contours) + 1))
        grown(:size(shape%contours)) = shape%contours
        grown(size(grown)) = contour
        call move_alloc(grown, shape%contours)
    end subroutine add_contour

    !> A contour of curves.
    pure type(contour_type) function new_contour(curves, is_closed) result(contour)
        type(curve_type), intent(in) :: curves(:)   !! end to end
        logical, intent(in) :: is_closed            !! the last ends where the first begins
        allocate (contour%curves, source=curves)
        allocate (contour%marks(0))
        contour%is_closed = is_closed
    end function new_contour

    !> A whole ellipse with its axes along u and v: four conics of weight sqrt(1/2).
    pure type(contour_type) function ellipse(plane, centre, half_axes) result(contour)
        type(plane_type), intent(in) :: plane       !! where it lies
        real(dp), intent(in) :: centre(2)           !! u and v
        real(dp), intent(in) :: half_axes(2)        !! along u and v
        type(curve_type) :: curves(4)
        real(dp), parameter :: corner(2, 9) = reshape([1.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 0.0_dp, &
            1.0_dp, -1.0_dp, 1.0_dp, -1.0_dp, 0.0_dp, -1.0_dp, -1.0_dp, 0.0_dp, -1.0_dp, 1.0_dp, &
            -1.0_dp, 1.0_dp, 0.0_dp], [2, 9])
        integer :: i, k

        do i = 1, 4
            curves(i)%section = 'RING'
            curves(i)%is_exact = .true.
            curves(i)%spline%degree = 2
            curves(i)%spline%knot = [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
            curves(i)%spline%weight = [1.0_dp, sqrt(0.5_dp), 1.0_dp]
            allocate (curves(i)%spline%pole(3, 3))
            do k = 1, 3
                curves(i)%spline%pole(:, k) = in_space(plane, &
                    centre + half_axes*corner(:, 2*i + k - 2))
            end do
        end do
        contour = new_contour(curves, .true.)
    end function ellipse

    !> A straight piece between two points of space.
    pure type(curve_type) function line_curve(from, to) result(curve)
        real(dp), intent(in) :: from(3) !! one end
        real(dp), intent(in) :: to(3)   !! the other
        curve%section = ''
        curve%is_exact = .true.
        curve%spline%degree = 1
        curve%spline%knot = [0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp]
        curve%spline%weight = [1.0_dp, 1.0_dp]
        curve%spline%pole = reshape([from, to], [3, 2])
    end function line_curve

    !> An open contour of one straight piece.
    pure type(contour_type) function segment(from, to) result(contour)
        real(dp), intent(in) :: from(3) !! one end
        real(dp), intent(in) :: to(3)   !! the other
        type(curve_type) :: curves(1)
        curves(1) = line_curve(from, to)
        contour = new_contour(curves, .false.)
    end function segment

end module support_sketch
