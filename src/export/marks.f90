!> The marks on a picture of arcs: a short line along each end tangent, and the figures 1, 2 and 3
!> beside the three points, where they hide neither curve nor tangent.
module export_marks
    use base_kinds, only: dp
    use export_picture, only: curve_type, picture_type
    implicit none (type, external)
    private

    public :: stroke_type, figure_type, tangent_strokes, point_figures

    !> A short straight line.
    type :: stroke_type
        real(dp) :: from(2) = 0.0_dp !! one end, deck units
        real(dp) :: to(2) = 0.0_dp   !! other end, deck units
    end type stroke_type

    !> The figure of a point.
    type :: figure_type
        real(dp) :: at(2) = 0.0_dp !! its middle, deck units
        integer :: number = 0      !! 1, 2 or 3
    end type figure_type

    !> Half the length of a tangent, the distance of the figure from its point, the distance at
    !> which equal figures would print over each other, and that at which a curve would run through
    !> a figure: in parts of the span of the picture.
    real(dp), parameter :: half_tangent = 0.05_dp, beyond_tangent = 0.065_dp, &
        beside_point = 0.025_dp, same_place = 0.025_dp, half_figure = 0.014_dp
    !> Curves of a picture beyond which figures would only make it black.
    integer, parameter :: most_curves = 120

contains

    !> The end tangents of a curve: a line through point 1 and one through point 3.
    pure function tangent_strokes(curve, span) result(strokes)
        type(curve_type), intent(in) :: curve !! the curve
        real(dp), intent(in) :: span          !! of the picture, deck units
        type(stroke_type) :: strokes(2)
        real(dp) :: reach(2)

        reach = half_tangent*span*unit(curve%arc%start_tangent)
        strokes(1) = stroke_type(curve%arc%start - reach, curve%arc%start + reach)
        reach = half_tangent*span*unit(curve%arc%finish_tangent)
        strokes(2) = stroke_type(curve%arc%finish - reach, curve%arc%finish + reach)
    end function tangent_strokes

    !> The figures of all points of a picture. Where points of the same number fall together, as in
    !> a nose, one figure stands for all. A picture of more than `most_curves` has none.
    pure function point_figures(picture, span) result(figures)
        type(picture_type), intent(in) :: picture !! the picture
        real(dp), intent(in) :: span              !! of the picture, deck units
        type(figure_type), allocatable :: figures(:)
        type(figure_type) :: figure
        integer :: i, k

        allocate (figures(0))
        if (picture%count > most_curves) return
        do i = 1, picture%count
            do k = 1, 3
                figure = figure_type(figure_place(picture, i, k, span), k)
                if (.not. is_taken(figure, figures, same_place*span)) figures = [figures, figure]
            end do
        end do
    end function point_figures

    !> Where the figure of a point stands: beyond the ends of the curve in line with the tangent; at
    !> the shoulder point on the side away from the chord, or on the other where a curve is there.
    pure function figure_place(picture, i, number, span) result(place)
        type(picture_type), intent(in) :: picture !! the picture
        integer, intent(in) :: i                  !! which curve
        integer, intent(in) :: number             !! which point, 1 to 3
        real(dp), intent(in) :: span              !! of the picture, deck units
        real(dp) :: place(2), away(2)

        associate (curve => picture%curve(i))
            select case (number)
            case (1)
                away = -beyond_tangent*span*unit(curve%arc%start_tangent)
            case (3)
                away = beyond_tangent*span*unit(curve%arc%finish_tangent)
            case default
                away = beside_point*span*off_chord(curve)
                if (is_crossed(picture, curve%point(:, 2) + away, half_figure*span)) away = -away
            end select
            place = curve%point(:, number) + away
        end associate
    end function figure_place

    !> True where some curve of a picture passes near a place.
    pure logical function is_crossed(picture, place, distance)
        type(picture_type), intent(in) :: picture !! the picture
        real(dp), intent(in) :: place(2)          !! the place, deck units
        real(dp), intent(in) :: distance          !! closer than this is near, deck units
        integer :: i, k

        is_crossed = .false.
        do i = 1, picture%count
            associate (line => picture%curve(i)%line)
                do k = 2, size(line, 2)
                    if (distance_from(line(:, k - 1), line(:, k), place) >= distance) cycle
                    is_crossed = .true.
                    return
                end do
            end associate
        end do
    end function is_crossed

    !> The distance of a place from a straight piece, deck units.
    pure real(dp) function distance_from(from, to, place) result(distance)
        real(dp), intent(in) :: from(2)  !! one end of the piece
        real(dp), intent(in) :: to(2)    !! its other end
        real(dp), intent(in) :: place(2) !! the place
        real(dp) :: length, along

        length = norm2(to - from)
        along = 0.0_dp
        if (length > 0.0_dp) along = dot_product(place - from, (to - from)/length)
        along = max(0.0_dp, min(length, along))
        distance = norm2(place - from)
        if (along > 0.0_dp) distance = norm2(place - from - along*unit(to - from))
    end function distance_from

    !> The direction square to the chord, on the side of the shoulder point.
    pure function off_chord(curve) result(direction)
        type(curve_type), intent(in) :: curve !! the curve
        real(dp) :: direction(2), chord(2)

        chord = unit(curve%point(:, 3) - curve%point(:, 1))
        direction = [-chord(2), chord(1)]
        if (dot_product(direction, unit(curve%point(:, 2) - curve%point(:, 1))) < 0.0_dp) &
            direction = -direction
    end function off_chord

    !> True where an equal figure already stands here.
    pure logical function is_taken(figure, figures, distance)
        type(figure_type), intent(in) :: figure     !! the figure
        type(figure_type), intent(in) :: figures(:) !! those that stand
        real(dp), intent(in) :: distance            !! closer than this is here, deck units
        integer :: i
        is_taken = .false.
        do i = 1, size(figures)
            if (figures(i)%number /= figure%number) cycle
            is_taken = is_taken .or. all(abs(figures(i)%at - figure%at) < distance)
        end do
    end function is_taken

    !> A direction with length 1.
    pure function unit(direction)
        real(dp), intent(in) :: direction(2) !! not zero
        real(dp) :: unit(2)
        unit = direction/norm2(direction)
    end function unit

end module export_marks
