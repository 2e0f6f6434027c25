!> A half shape with its port half: the mirror image in BL 0 is the same numbers with the sign of BL
!> turned. It runs the other way, so that the body stays on the same side of every contour.
module export_drawing_whole
    use base_exact, only: is_equal, is_zero
    use base_kinds, only: dp
    use cut_plane, only: plane_type, true_shape
    use export_drawing, only: contour_type, mark_type, shape_type
    use export_drawing_join, only: seat_ends
    use geom_arc, only: arc_type, reversed
    use geom_bspline, only: reversed_spline, spline_point
    use geom_twofold, only: operator(-)
    implicit none (type, external)
    private

    public :: whole, mirrored_contour

    !> Points of a curve by which the area of a contour is told from none.
    integer, parameter :: area_points = 16

contains

    !> The whole of a shape: of a half one each contour that has a mirror image with it, as one
    !> contour where they meet at BL 0; closed, and then counter-clockwise in the plane, where they
    !> meet twice. Another shape is as it was.
    pure type(shape_type) function whole(shape) result(both)
        type(shape_type), intent(in) :: shape !! any
        type(contour_type), allocatable :: more(:)
        integer :: i, count

        both = shape
        if (.not. shape%is_half) return
        both%is_half = .false.
        allocate (more(2*size(shape%contours)))
        count = 0
        do i = 1, size(shape%contours)
            call add_both(shape%plane, shape%contours(i), more, count)
        end do
        both%contours = more(:count)
    end function whole

    !> Adds a contour and its image, joined where they can be.
    pure subroutine add_both(plane, contour, contours, count)
        type(plane_type), intent(in) :: plane               !! of the shape
        type(contour_type), intent(in) :: contour           !! of a half shape
        type(contour_type), intent(inout) :: contours(:)    !! get them
        integer, intent(inout) :: count                     !! how many there are
        type(contour_type) :: own, image
        logical :: meets(2)

        own = contour
        if (.not. contour%has_image) then
            count = count + 1
            contours(count) = own
            return
        end if
        call seat_ends(plane, own, meets)
        image = mirrored_contour(plane, own)
        count = count + 1
        if (size(own%curves) == 0) then
            contours(count) = own
            if (is_zero(own%at(2))) return
            count = count + 1
            contours(count) = image
        else if (meets(2)) then
            contours(count) = joined(own, image)
            contours(count)%is_closed = meets(1)
            if (.not. meets(1)) return
            call drop_repeated(contours(count)%marks)
            if (enclosed_area(plane, contours(count)) < 0.0_dp) &
                contours(count) = backwards(contours(count))
        else if (meets(1)) then
            contours(count) = joined(image, own)
        else
            contours(count) = own
            count = count + 1
            contours(count) = image
        end if
    end subroutine add_both

    !> Two contours as one, the first ending where the second begins. A mark there is the first's.
    pure type(contour_type) function joined(first, second) result(both)
        type(contour_type), intent(in) :: first     !! any
        type(contour_type), intent(in) :: second    !! its image
        integer :: i, count

        count = size(first%curves)
        both = first
        deallocate (both%curves, both%marks)
        allocate (both%curves(2*count))
        do i = 1, count
            both%curves(i) = first%curves(i)
            both%curves(count + i) = second%curves(i)
        end do
        both%marks = [first%marks, second%marks]
        i = size(first%marks)
        if (i == 0 .or. size(second%marks) == 0) return
        if (all(is_equal(first%marks(i)%uv, second%marks(1)%uv))) &
            both%marks = [first%marks, second%marks(2:)]
    end function joined

    !> Drops the last of the marks of a closed contour where it is the first again.
    pure subroutine drop_repeated(marks)
        type(mark_type), allocatable, intent(inout) :: marks(:) !! in order along it
        integer :: last
        last = size(marks)
        if (last < 2) return
        if (all(is_equal(marks(1)%uv, marks(last)%uv))) marks = marks(:last - 1)
    end subroutine drop_repeated

    !> The mirror image of a contour in BL 0, run through backwards.
    pure type(contour_type) function mirrored_contour(plane, contour) result(image)
        type(plane_type), intent(in) :: plane       !! across BL 0, of the shape
        type(contour_type), intent(in) :: contour   !! in it
        integer :: i

        image = backwards(contour)
        image%at(2) = 0.0_dp - contour%at(2)
        do i = 1, size(image%curves)
            associate (curve => image%curves(i))
                curve%spline%pole(2, :) = 0.0_dp - curve%spline%pole(2, :)
                curve%worst(2) = 0.0_dp - curve%worst(2)
                if (curve%is_conic) curve%arc = mirrored_arc(plane, curve%arc)
            end associate
        end do
        do i = 1, size(image%marks)
            associate (mark => image%marks(i))
                mark%uv(axis_of(plane)) = turned(plane, mark%uv(axis_of(plane)))
                mark%outward(axis_of(plane)) = 0.0_dp - mark%outward(axis_of(plane))
            end associate
        end do
    end function mirrored_contour

    !> A contour, run through backwards.
    pure type(contour_type) function backwards(contour) result(back)
        type(contour_type), intent(in) :: contour !! any
        integer :: i, count

        back = contour
        count = size(contour%curves)
        do i = 1, count
            back%curves(i) = contour%curves(count + 1 - i)
            back%curves(i)%spline = reversed_spline(contour%curves(count + 1 - i)%spline)
            if (back%curves(i)%is_conic) back%curves(i)%arc = reversed(back%curves(i)%arc)
        end do
        back%marks = contour%marks(size(contour%marks):1:-1)
    end function backwards

    !> The axis of the true shape that is along BL: 1 u, 2 v.
    pure integer function axis_of(plane) result(axis)
        type(plane_type), intent(in) :: plane !! across BL 0
        axis = merge(1, 2, abs(plane%u(2)) > abs(plane%v(2)))
    end function axis_of

    !> A coordinate along BL of the mirror image.
    pure real(dp) function turned(plane, x)
        type(plane_type), intent(in) :: plane   !! across BL 0
        real(dp), intent(in) :: x               !! u or v, along BL, deck units
        turned = (0.0_dp - x) - 2.0_dp*plane%origin(2)
    end function turned

    !> The mirror image of an arc in BL 0, as it runs.
    pure type(arc_type) function mirrored_arc(plane, arc) result(image)
        type(plane_type), intent(in) :: plane   !! across BL 0
        type(arc_type), intent(in) :: arc       !! in u and v

        image = arc
        associate (k => axis_of(plane))
            image%start(k) = turned(plane, arc%start(k))
            image%finish(k) = turned(plane, arc%finish(k))
            image%start_tangent(k) = 0.0_dp - arc%start_tangent(k)
            image%finish_tangent(k) = 0.0_dp - arc%finish_tangent(k)
            image%half(k) = -arc%half(k)
            image%bulge(k) = -arc%bulge(k)
            image%leaving(k) = -arc%leaving(k)
            image%arriving(k) = -arc%arriving(k)
        end associate
    end function mirrored_arc

    !> Twice the area in a closed contour, about; positive where it runs counter-clockwise.
    pure real(dp) function enclosed_area(plane, contour) result(area)
        type(plane_type), intent(in) :: plane       !! of the shape
        type(contour_type), intent(in) :: contour   !! closed, in it
        real(dp) :: before(2), next(2), middle(2), t
        integer :: i, k

        area = 0.0_dp
        middle = true_shape(plane, contour%curves(1)%spline%pole(:, 1))
        before = 0.0_dp
        do i = 1, size(contour%curves)
            associate (spline => contour%curves(i)%spline)
                do k = 1, area_points
                    t = spline%knot(1) + (spline%knot(size(spline%knot)) - spline%knot(1)) &
                        *(real(k, dp)/real(area_points, dp))
                    next = true_shape(plane, spline_point(spline, t)) - middle
                    area = area + before(1)*next(2) - before(2)*next(1)
                    before = next
                end do
            end associate
        end do
    end function enclosed_area

end module export_drawing_whole
