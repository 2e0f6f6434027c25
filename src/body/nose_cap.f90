!> The cap that rounds a sharp nose, view by view. From the nose station on, x1, to the blending
!> station, xt, a view of a control line is a conic arc that begins upright on the nose axis and
!> ends in the line's own point and slope; from xt on the line is as it was.
!>
!> All lines meet in the apex (x0, z0); the steepest leaves the axis with the slope m = tan(theta).
!> With n = sqrt(1 + m**2)
!>
!>     xt = x0 + R cos(theta)**2/sin(theta) = x0 + R/(m n)
!>     x1 = x0 + R (1/sin(theta) - 1)       = x0 + R/(m (m + n))
!>
!> are where the sphere of radius R touches the circular cone of that angle from inside, and its
!> foremost point. With offsets o from the axis and H the greatest of them at xt, the radius of
!> curvature at the nose is R (o/H)**2, so that offsets just behind the nose have the same ratios as
!> at xt and sections there are of the same shape. The cone gets the sphere, shoulder lines as well.
!>
!> The axis may rise: a shear along WL that levels it keeps upright tangents and the curvature
!> there. Derivation in doc/theory-nose.md.
module body_nose_cap
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use base_tolerances, only: meeting_tolerance
    use body_nose_cone, only: cone_type, offset_at
    use deck_job, only: view
    use geom_arc, only: arc_type, end_type, line_between
    use geom_chain, only: chain_piece, chain_type, new_chain
    use geom_jet, only: jet_type
    use geom_joint, only: match_start
    use geom_place, only: at_finish, at_start
    use geom_span, only: new_span
    use geom_stroke, only: conic_stroke, stroke_part, stroke_place, stroke_tangent, stroke_type
    implicit none (type, external)
    private

    public :: nose_type, new_nose, check_cap, put_cap, cap_and_rest

    !> A rounded nose.
    type :: nose_type
        type(cone_type) :: cone         !! the sharp one
        real(dp) :: radius = 0.0_dp     !! R, deck units
        real(dp) :: tip(2) = 0.0_dp     !! x1 and its WL, at BL 0, deck units
        real(dp) :: blend = 0.0_dp      !! xt, deck units
        real(dp) :: height = 0.0_dp     !! H, deck units; `body_nose_fit` finds it
    end type nose_type

contains

    !> The nose of a radius in a cone; its height is not known yet.
    pure type(nose_type) function new_nose(cone, radius) result(nose)
        type(cone_type), intent(in) :: cone     !! the sharp nose
        real(dp), intent(in) :: radius          !! above zero, deck units
        real(dp) :: slant

        nose%cone = cone
        nose%radius = radius
        associate (m => cone%steepness)
            slant = sqrt(1.0_dp + m**2)
            nose%blend = cone%apex(1) + radius/(m*slant)
            nose%tip = cone%apex + radius/(m*(m + slant))*[1.0_dp, cone%axis]
        end associate
    end function new_nose

    !> True where a view runs along the nose axis at the blending station.
    pure logical function is_on_axis(nose, offset)
        type(nose_type), intent(in) :: nose     !! with its height
        type(jet_type), intent(in) :: offset    !! of the view at the blending station
        is_on_axis = abs(offset%value) <= meeting_tolerance*nose%height &
            .and. abs(offset%first) <= meeting_tolerance
    end function is_on_axis

    !> Fails with `cause%no_arc` where a view has no cap: its tangent at the blending station does
    !> not meet the nose station on the line's own side of the axis.
    pure subroutine check_cap(nose, chain, which, error)
        type(nose_type), intent(in) :: nose                 !! with its height
        type(chain_type), intent(in) :: chain               !! a view that reaches past `blend`
        integer, intent(in) :: which                        !! `view%side` or `view%plan`
        type(error_type), allocatable, intent(out) :: error !! see above
        type(jet_type) :: offset
        logical :: is_vertical
        real(dp) :: corner

        call offset_at(nose%cone, chain, which, nose%blend, offset, is_vertical)
        if (is_on_axis(nose, offset) .and. .not. is_vertical) return
        corner = offset%value - offset%first*(nose%blend - nose%tip(1))
        if (corner*sign(1.0_dp, offset%value) > 0.0_dp .and. .not. is_vertical .and. &
            abs(offset%value) > meeting_tolerance*nose%height) return
        call fail(error, cause%no_arc, 'in '//trim(merge('side', 'plan', which == view%side))// &
            ' view its tangent at station '//compact(nose%blend)// &
            ', where the cap would end, crosses the nose axis aft of the nose at station '// &
            compact(nose%tip(1)))
    end subroutine check_cap

    !> Rounds a view: its chain is the cap and the rest. A constant on the axis stays.
    !>
    !> Fails as `match_start` and `new_chain`.
    pure subroutine put_cap(nose, which, gap, chain, error)
        type(nose_type), intent(in) :: nose                 !! with its height
        integer, intent(in) :: which                        !! `view%side` or `view%plan`
        real(dp), intent(in) :: gap                         !! largest gap in x, deck units
        type(chain_type), intent(inout) :: chain            !! the view, sound by `check_cap`
        type(error_type), allocatable, intent(out) :: error !! see above
        type(stroke_type), allocatable :: strokes(:)
        type(chain_type) :: rounded

        allocate (strokes(0))
        call cap_and_rest(nose, which, chain, strokes, error)
        if (allocated(error) .or. size(strokes) == 0) return
        call new_chain(strokes, gap, rounded, error)
        if (.not. allocated(error)) chain = rounded
    end subroutine put_cap

    !> The strokes of a rounded view, the cap first; none for a constant on the axis.
    !>
    !> Fails as `match_start`.
    pure subroutine cap_and_rest(nose, which, chain, strokes, error)
        type(nose_type), intent(in) :: nose                     !! with its height
        integer, intent(in) :: which                            !! `view%side` or `view%plan`
        type(chain_type), intent(in) :: chain                   !! the view, sound by `check_cap`
        type(stroke_type), allocatable, intent(out) :: strokes(:) !! towards greater stations
        type(error_type), allocatable, intent(out) :: error     !! see above
        type(stroke_type), allocatable :: rest(:)
        type(arc_type) :: cap
        type(jet_type) :: offset
        real(dp) :: tip(2)
        logical :: is_vertical

        call offset_at(nose%cone, chain, which, nose%blend, offset, is_vertical)
        if (is_on_axis(nose, offset) .and. chain%is_constant) then
            allocate (strokes(0))
            return
        end if
        tip = [nose%tip(1), merge(nose%tip(2), 0.0_dp, which == view%side)]
        call cut_off(chain, nose, rest)
        if (is_on_axis(nose, offset)) then
            cap = line_between(tip, rest(1)%start)
        else
            call match_start(new_span(end_type(tip, [0.0_dp, 1.0_dp]), &
                end_type(rest(1)%start, stroke_tangent(rest(1), at_start))), &
                -sign(1.0_dp, offset%value)/(nose%radius*(offset%value/nose%height)**2), &
                cap, error)
            if (allocated(error)) return
        end if
        allocate (strokes(1 + size(rest)))
        strokes(1) = conic_stroke(cap)
        strokes(2:) = rest
    end subroutine cap_and_rest

    !> The strokes of a view aft of the blending station; of a constant a straight line.
    pure subroutine cut_off(chain, nose, rest)
        type(chain_type), intent(in) :: chain               !! a view
        type(nose_type), intent(in) :: nose                 !! the nose
        type(stroke_type), allocatable, intent(out) :: rest(:) !! towards greater stations

        if (chain%is_constant) then
            allocate (rest(1))
            rest(1) = conic_stroke(line_between([nose%blend, chain%constant], &
                [nose%cone%aft, chain%constant]))
            return
        end if
        rest = chain%stroke(chain_piece(chain, nose%blend):)
        rest(1) = stroke_part(rest(1), stroke_place(rest(1), nose%blend), at_finish)
    end subroutine cut_off

end module body_nose_cap
