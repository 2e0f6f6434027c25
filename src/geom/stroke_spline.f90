!> A stroke as a B-spline, exactly; a C-Bezier curve is none.
module geom_stroke_spline
    use base_kinds, only: dp
    use geom_arc_spline, only: arc_spline
    use geom_bspline, only: bspline_type
    use geom_stroke, only: stroke_kind, stroke_type
    implicit none (type, external)
    private

    public :: stroke_spline

contains

    !> A stroke as a B-spline, rational where it is a conic, from its start to its finish.
    pure type(bspline_type) function stroke_spline(stroke) result(spline)
        type(stroke_type), intent(in) :: stroke !! a conic or a Bezier curve
        integer :: poles

        if (stroke%kind == stroke_kind%conic) then
            spline = arc_spline(stroke%arc)
            return
        end if
        poles = size(stroke%pole, 2)
        spline%degree = poles - 1
        allocate (spline%pole, source=stroke%pole)
        allocate (spline%weight(poles), source=1.0_dp)
        allocate (spline%knot(2*poles))
        spline%knot(:poles) = 0.0_dp
        spline%knot(poles + 1:) = 1.0_dp
    end function stroke_spline

end module geom_stroke_spline
