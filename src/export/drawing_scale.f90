!> A drawing in another unit.
module export_drawing_scale
    use base_kinds, only: dp
    use export_drawing, only: curve_type, drawing_type, shape_type
    use geom_arc, only: arc_type
    use geom_twofold, only: operator(*)
    implicit none (type, external)
    private

    public :: scaled_drawing, scaled_arc

contains

    !> The drawing with all its lengths multiplied.
    pure type(drawing_type) function scaled_drawing(drawing, factor, units) result(scaled)
        type(drawing_type), intent(in) :: drawing   !! any
        real(dp), intent(in) :: factor              !! above zero: new units in an old one
        character(*), intent(in) :: units           !! name of the new unit
        integer :: i

        scaled = drawing
        scaled%units = units
        scaled%tolerance = factor*drawing%tolerance
        if (allocated(scaled%cuts)) then
            do i = 1, size(scaled%cuts)
                call scale_shape(factor, scaled%cuts(i))
            end do
        end if
        if (allocated(scaled%lines)) then
            do i = 1, size(scaled%lines)
                call scale_shape(factor, scaled%lines(i))
            end do
        end if
    end function scaled_drawing

    !> Multiplies the lengths of a shape.
    pure subroutine scale_shape(factor, shape)
        real(dp), intent(in) :: factor              !! above zero
        type(shape_type), intent(inout) :: shape    !! any
        integer :: i, k

        shape%skin = factor*shape%skin
        shape%arcs = factor*shape%arcs
        shape%plane%through = factor*shape%plane%through
        shape%plane%origin = factor*shape%plane%origin
        do i = 1, size(shape%contours)
            associate (contour => shape%contours(i))
                contour%at = factor*contour%at
                do k = 1, size(contour%marks)
                    contour%marks(k)%uv = factor*contour%marks(k)%uv
                end do
                do k = 1, size(contour%curves)
                    call scale_curve(factor, contour%curves(k))
                end do
            end associate
        end do
    end subroutine scale_shape

    !> Multiplies the lengths of a curve.
    pure subroutine scale_curve(factor, curve)
        real(dp), intent(in) :: factor              !! above zero
        type(curve_type), intent(inout) :: curve    !! any
        curve%spline%pole = factor*curve%spline%pole
        curve%error = factor*curve%error
        curve%worst = factor*curve%worst
        if (curve%is_conic) curve%arc = scaled_arc(factor, curve%arc)
    end subroutine scale_curve

    !> The arc so many times as large about the origin: its ends are rounded, its form is not.
    pure type(arc_type) function scaled_arc(factor, arc) result(scaled)
        real(dp), intent(in) :: factor      !! above zero
        type(arc_type), intent(in) :: arc   !! any
        real(dp) :: rest
        integer :: i

        scaled = arc
        scaled%start = factor*arc%start
        scaled%finish = factor*arc%finish
        scaled%size = scale(arc%size, exponent(factor))
        rest = fraction(factor)
        do i = 1, 2
            scaled%half(i) = rest*arc%half(i)
            scaled%bulge(i) = rest*arc%bulge(i)
            scaled%leaving(i) = rest*arc%leaving(i)
            scaled%arriving(i) = rest*arc%arriving(i)
        end do
    end function scaled_arc

end module export_drawing_scale
