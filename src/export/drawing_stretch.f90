!> A control line between two of its joints, as a curve in space.
!>
!> A view is one stroke between joints. The line is that stroke, exactly, where its other view is
!> constant or straight, or is a stroke of the same weights over the same stations: an affine image
!> of the first. Any other line is fitted.
module export_drawing_stretch
    use base_error, only: error_type
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_tolerances, only: agreement_ulps, type_tolerance, ulp
    use body_line, only: line_type
    use export_drawing, only: curve_type
    use export_drawing_conic, only: distance_off
    use export_drawing_degree, only: limit_degree, most_degree
    use export_drawing_fit, only: fitted_curve
    use export_drawing_path, only: paced, pace_of
    use geom_arc_spline, only: line_spline
    use geom_bspline, only: bspline_type, spline_point
    use geom_chain, only: chain_piece, chain_type
    use geom_curve_fit, only: curve_function_type
    use geom_place, only: at_finish, at_start, place_type
    use geom_stroke, only: is_straight, stroke_kind, stroke_part, stroke_place, stroke_point, &
        stroke_tangent, stroke_type
    use geom_stroke_spline, only: stroke_spline
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: stretch_type, stretch_of, draw_stretch

    !> A view between two joints.
    type :: view_type
        logical :: is_constant = .false.    !! the same everywhere
        real(dp) :: constant = 0.0_dp       !! BL or WL where it is, deck units
        type(stroke_type) :: stroke         !! else BL or WL over STA, towards greater STA
    end type view_type

    !> A line between two joints.
    type, extends(curve_function_type) :: stretch_type
        real(dp) :: ends(2) = 0.0_dp        !! stations, in order, deck units
        real(dp) :: pace(2) = 1.0_dp        !! of the station at these ends
        type(view_type) :: view(2)          !! plan, side
    contains
        procedure :: at => stretch_at
    end type stretch_type

    !> Points of an exact curve at which it is proved to be that.
    integer, parameter :: proofs = 64
    !> Chords of which the length of a line is summed up.
    integer, parameter :: chords = 16

contains

    !> A line between two joints.
    pure type(stretch_type) function stretch_of(line, ends) result(stretch)
        type(line_type), intent(in) :: line     !! with a side view
        real(dp), intent(in) :: ends(2)         !! stations of neighbouring joints, deck units
        real(dp) :: length, slant(2), t
        integer :: i

        stretch%ends = ends
        stretch%view(1)%is_constant = .true.
        if (line%has_plan) stretch%view(1) = view_of(line%plan, ends)
        stretch%view(2) = view_of(line%side, ends)
        length = 0.0_dp
        do i = 1, chords
            t = real(i, dp)/real(chords, dp)
            length = length + norm2(stretch%at(t) - stretch%at(t - 1.0_dp/real(chords, dp)))
        end do
        slant = [slant_at(stretch, at_start), slant_at(stretch, at_finish)]
        stretch%pace = pace_of(slant, length, ends(2) - ends(1))
    end function stretch_of

    !> A view between two joints.
    pure type(view_type) function view_of(chain, ends) result(view)
        type(chain_type), intent(in) :: chain   !! a view of a line
        real(dp), intent(in) :: ends(2)         !! stations of neighbouring joints, deck units

        view%is_constant = chain%is_constant
        view%constant = chain%constant
        if (chain%is_constant) return
        associate (stroke => chain%stroke(chain_piece(chain, ends(1))))
            view%stroke = stroke_part(stroke, stroke_place(stroke, ends(1)), &
                stroke_place(stroke, ends(2)))
        end associate
        view%is_constant = is_straight(view%stroke) &
            .and. is_equal(view%stroke%start(2), view%stroke%finish(2))
        view%constant = view%stroke%start(2)
    end function view_of

    !> The part of the unit direction along STA at an end.
    pure real(dp) function slant_at(stretch, place) result(slant)
        type(stretch_type), intent(in) :: stretch   !! any
        type(place_type), intent(in) :: place       !! start or finish
        real(dp) :: along(2), steep
        integer :: i

        slant = 0.0_dp
        steep = 1.0_dp
        do i = 1, 2
            if (stretch%view(i)%is_constant) cycle
            along = stroke_tangent(stretch%view(i)%stroke, place)
            if (abs(along(1)) <= ulp*abs(along(2))) return
            steep = steep + (along(2)/along(1))**2
        end do
        slant = 1.0_dp/sqrt(steep)
    end function slant_at

    !> The point of a stretch.
    pure function stretch_at(f, t) result(at)
        class(stretch_type), intent(in) :: f    !! the stretch
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp) :: at(3), seen(2)
        integer :: i

        at(1) = paced(f%ends(1), f%ends(2), f%pace, t)
        do i = 1, 2
            at(i + 1) = f%view(i)%constant
            if (f%view(i)%is_constant) cycle
            seen = stroke_point(f%view(i)%stroke, stroke_place(f%view(i)%stroke, at(1)))
            at(i + 1) = seen(2)
        end do
    end function stretch_at

    !> The curve of a stretch; of one of high degree, one of lower degree near it. Fails with
    !> `cause%no_convergence` where it can't be fitted.
    pure subroutine draw_stretch(stretch, tolerance, curve, error)
        type(stretch_type), intent(in) :: stretch           !! between joints
        real(dp), intent(in) :: tolerance                   !! of a fitted curve, deck units
        type(curve_type), intent(out) :: curve              !! in space
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: apart
        logical :: is_one

        call join_views(stretch, curve%spline, is_one)
        if (is_one) call prove(stretch, curve)
        is_one = curve%is_exact
        if (is_one .and. curve%spline%degree > most_degree) then
            call limit_degree(curve%spline, tolerance, apart)
            call prove(stretch, curve)
            curve%is_exact = curve%is_exact .and. apart <= 0.0_dp
            curve%error = max(curve%error, apart)
        end if
        if (is_one) then
            curve%section = ''
            curve%is_conic = stretch%view(1)%is_constant .and. .not. stretch%view(2)%is_constant
            associate (side => stretch%view(2)%stroke)
                curve%is_conic = curve%is_conic .and. side%kind == stroke_kind%conic
                if (curve%is_conic) curve%arc = side%arc
            end associate
        else
            call fitted_curve(stretch, 3, tolerance, curve, error)
        end if
    end subroutine draw_stretch

    !> The spline that both views of a stretch are images of, if they can be of one.
    pure subroutine join_views(stretch, spline, is_one)
        type(stretch_type), intent(in) :: stretch       !! any
        type(bspline_type), intent(out) :: spline       !! in space
        logical, intent(out) :: is_one                  !! there is perhaps one
        type(bspline_type) :: other
        real(dp) :: share
        integer :: main, i, k, last

        is_one = .not. any(is_cyclic(stretch%view))
        if (.not. is_one) return
        main = 2
        if (is_plain(stretch%view(2)) .and. .not. is_plain(stretch%view(1))) main = 1
        if (stretch%view(main)%is_constant) main = 3 - main
        if (stretch%view(main)%is_constant) then
            spline = line_spline(stretch%at(0.0_dp), stretch%at(1.0_dp))
            return
        end if
        other = stroke_spline(stretch%view(main)%stroke)
        spline = other
        last = size(spline%weight)
        deallocate (spline%pole)
        allocate (spline%pole(3, last))
        spline%pole(1, :) = other%pole(1, :)
        spline%pole(main + 1, :) = other%pole(2, :)
        i = 3 - main
        associate (view => stretch%view(i), pole => spline%pole)
            if (view%is_constant) then
                pole(i + 1, :) = view%constant
            else if (is_straight(view%stroke)) then
                associate (line => view%stroke)
                    do k = 1, last
                        share = (pole(1, k) - line%start(1))/(line%finish(1) - line%start(1))
                        pole(i + 1, k) = (1.0_dp - share)*line%start(2) + share*line%finish(2)
                    end do
                end associate
            else
                other = stroke_spline(view%stroke)
                is_one = size(other%weight) == last
                if (.not. is_one) return
                is_one = all(abs(other%weight - spline%weight) <= type_tolerance*spline%weight)
                pole(i + 1, :) = other%pole(2, :)
            end if
        end associate
    end subroutine join_views

    !> True for a C-Bezier curve, which is no B-spline.
    elemental logical function is_cyclic(view)
        type(view_type), intent(in) :: view !! any
        is_cyclic = .not. view%is_constant .and. view%stroke%kind == stroke_kind%cyclic
    end function is_cyclic

    !> True for a view that is straight.
    pure logical function is_plain(view)
        type(view_type), intent(in) :: view !! any
        is_plain = view%is_constant .or. is_straight(view%stroke)
    end function is_plain

    !> Measures a spline that should be a stretch, on both views; it is exact where it is off by no
    !> more than rounding.
    pure subroutine prove(stretch, curve)
        type(stretch_type), intent(in) :: stretch   !! what it should be
        type(curve_type), intent(inout) :: curve    !! has a spline
        real(dp) :: at(3), off(2)
        integer :: i, k

        curve%worst = curve%spline%pole(:, 1)
        do k = 0, proofs
            at = spline_point(curve%spline, real(k, dp)/real(proofs, dp))
            do i = 1, 2
                off(i) = abs(at(i + 1) - stretch%view(i)%constant)
                if (.not. stretch%view(i)%is_constant) &
                    off(i) = distance_from(stretch%view(i)%stroke, at([1, i + 1]))
            end do
            if (norm2(off) <= curve%error) cycle
            curve%error = norm2(off)
            curve%worst = at
        end do
        curve%is_exact = curve%error <= agreement_ulps*ulp*maxval(abs(curve%spline%pole))
    end subroutine prove

    !> How far a point is from a stroke, of a Bezier curve as its ordinate tells it.
    pure real(dp) function distance_from(stroke, at) result(distance)
        type(stroke_type), intent(in) :: stroke     !! towards greater STA
        real(dp), intent(in) :: at(2)               !! a point beside it, deck units
        type(place_type) :: place
        real(dp) :: along(2)

        if (stroke%kind == stroke_kind%conic) then
            distance = distance_off(stroke%arc, at)
            return
        end if
        place = stroke_place(stroke, at(1))
        along = stroke_tangent(stroke, place)
        distance = abs(cross(at - stroke_point(stroke, place), along))/norm2(along)
    end function distance_from

end module export_drawing_stretch
