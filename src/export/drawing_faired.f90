!> The shape of a faired outline: two B-splines of degree 3, exact, that meet in its first point and
!> the one half way round.
module export_drawing_faired
    use base_kinds, only: dp
    use body_outline, only: outline_type
    use cut_faired, only: measured_cut
    use cut_outline, only: cut_type
    use export_drawing, only: curve_type, shape_type
    use export_drawing_join, only: join, last_point
    use export_drawing_name, only: cut_name, cut_title
    use geom_bspline, only: mapped_spline
    use geom_fairing_curve, only: uniform_bspline
    implicit none (type, external)
    private

    public :: outline_shape

contains

    !> The shape of an outline, in its station.
    pure type(shape_type) function outline_shape(outline) result(shape)
        type(outline_type), intent(in) :: outline !! faired
        type(cut_type) :: cut
        integer :: half, count, i

        cut = measured_cut(outline)
        shape%name = trim(cut_name(cut))
        shape%title = trim(cut_title(cut))
        shape%kind = cut%plane%kind
        shape%plane = cut%plane
        shape%arcs = cut%arcs
        allocate (shape%contours(1))
        count = size(outline%fairing%vertex, 2)
        half = count/2
        associate (contour => shape%contours(1))
            contour%is_closed = .true.
            allocate (contour%curves(2), contour%marks(0))
            contour%curves(1) = half_curve(outline, [(1 + modulo(i - 1, count), i = 1, half + 3)])
            contour%curves(2) = half_curve(outline, [(1 + modulo(i - 1, count), &
                i = half + 1, count + 3)])
            do i = 1, 2
                call join(last_point(contour%curves(i)), huge(1.0_dp), contour%curves(3 - i))
            end do
        end associate
    end function outline_shape

    !> The B-spline of some vertices of an outline, in space.
    pure type(curve_type) function half_curve(outline, number) result(curve)
        type(outline_type), intent(in) :: outline   !! faired
        integer, intent(in) :: number(:)            !! of the vertices, in order
        real(dp), parameter :: axes(3, 2) = reshape([0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, &
            1.0_dp], [3, 2])

        call mapped_spline(uniform_bspline(outline%fairing%vertex(:, number), .false.), axes, &
            [outline%sta, 0.0_dp, 0.0_dp], curve%spline)
        curve%section = outline%name
        curve%is_exact = .true.
    end function half_curve

end module export_drawing_faired
