!> Where two strokes meet: how position, direction and curvature jump; and the arc that begins or
!> ends with a given curvature, so that there is no jump.
!>
!> With l1 the way from the start to the intersection of the end tangents, l3 that from there to
!> the finish, h half the chord and w the weight, the curvatures of an arc at its ends are
!>
!>     k1 = (l1 x h)/(w**2 |l1|**3)     k3 = (h x l3)/(w**2 |l3|**3)
!>
!> which gives w; where the tangents are parallel, w is zero and w l1 of the length that k1 asks
!> for. Source: G. Farin, "Curves and Surfaces for CAGD", 5th ed., 12.6.
module geom_joint
    use base_constants, only: degrees
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_text, only: compact
    use geom_arc, only: arc_type
    use geom_place, only: at_finish, at_start
    use geom_span, only: arc_of_ends, has_corner, is_level, span_type
    use geom_stroke, only: stroke_curvature, stroke_tangent, stroke_type
    use geom_twofold, only: operator(*), operator(-), operator(/), sqrt, to_real, twofold, &
        twofold_type
    use geom_vector, only: cross, dot
    implicit none (type, external)
    private

    public :: jump_type, jump_between, match_start, match_finish

    !> What jumps at a joint, on the way along the arcs: the value after it less that before.
    type :: jump_type
        real(dp) :: position(2) = 0.0_dp  !! x and y, deck units
        real(dp) :: gap = 0.0_dp          !! distance of the ends, deck units
        real(dp) :: direction = 0.0_dp    !! degrees, positive to the left, -180 to 180
        real(dp) :: curvature = 0.0_dp    !! 1/deck unit, positive to the left
    end type jump_type

contains

    !> The jump from the end of a stroke to the start of the next.
    pure type(jump_type) function jump_between(before, after) result(jump)
        type(stroke_type), intent(in) :: before !! a stroke
        type(stroke_type), intent(in) :: after  !! the next, in the same direction
        type(twofold_type) :: ahead(2), turned(2)

        jump%position = after%start - before%finish
        jump%gap = norm2(jump%position)
        ahead = twofold(stroke_tangent(before, at_finish))
        turned = twofold(stroke_tangent(after, at_start))
        jump%direction = degrees*atan2(to_real(cross(ahead, turned)), to_real(dot(ahead, turned)))
        jump%curvature = stroke_curvature(after, at_start) - stroke_curvature(before, at_finish)
    end function jump_between

    !> The arc of a span that begins with a curvature.
    !>
    !> Fails with `cause%no_match` where there is none: the curvature is zero or of the wrong sign,
    !> or an end tangent runs along the chord.
    pure subroutine match_start(span, bend, arc, error)
        type(span_type), intent(in) :: span                 !! the ends with their tangents
        real(dp), intent(in) :: bend                        !! 1/deck unit, positive to the left
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(twofold_type) :: reach, w

        call check_bend(span, bend, error)
        if (allocated(error)) return
        reach = pull(span, span%chord_off_start, span%t1, bend)
        w = -(reach*span%tangents/span%chord_off_finish)
        call check_side(span, to_real(w), bend, error)
        if (allocated(error)) return
        arc = arc_of_ends(span, w, reach, reach*span%chord_off_start/span%chord_off_finish)
    end subroutine match_start

    !> The arc of a span that ends with a curvature.
    !>
    !> Fails as `match_start`.
    pure subroutine match_finish(span, bend, arc, error)
        type(span_type), intent(in) :: span                 !! the ends with their tangents
        real(dp), intent(in) :: bend                        !! 1/deck unit, positive to the left
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(twofold_type) :: rest, w

        call check_bend(span, bend, error)
        if (allocated(error)) return
        rest = pull(span, span%chord_off_finish, span%t3, bend)
        w = -(rest*span%tangents/span%chord_off_start)
        call check_side(span, to_real(w), bend, error)
        if (allocated(error)) return
        arc = arc_of_ends(span, w, rest*span%chord_off_finish/span%chord_off_start, rest)
    end subroutine match_finish

    !> The multiple of an end tangent t that is w l, with a curvature k there: by the equations
    !> above it is `-(chord off t)/(2 k |t|**3)` in its square, of that sign.
    pure type(twofold_type) function pull(span, chord_off, t, bend)
        type(span_type), intent(in) :: span          !! the ends with their tangents
        type(twofold_type), intent(in) :: chord_off  !! product of chord and tangent
        type(twofold_type), intent(in) :: t(2)       !! the tangent
        real(dp), intent(in) :: bend                 !! 1/deck unit, not zero
        type(twofold_type) :: length

        length = sqrt(dot(t, t))
        pull = -(0.5_dp*chord_off/(length*length*length))/(span%size*twofold(bend))
        if (pull%high < 0.0_dp) then
            pull = -sqrt(-pull)
        else
            pull = sqrt(pull)
        end if
    end function pull

    !> Fails with `cause%no_match` where a span has no curved arc, or where the curvature is zero.
    pure subroutine check_bend(span, bend, error)
        type(span_type), intent(in) :: span                 !! the ends with their tangents
        real(dp), intent(in) :: bend                        !! 1/deck unit
        type(error_type), allocatable, intent(out) :: error !! see above

        if (is_level(span)) then
            call fail(error, cause%no_match, 'an end tangent runs along the chord, so that no '// &
                'curved arc joins the ends; turn it off the chord')
        else if (is_zero(bend)) then
            call fail(error, cause%no_match, &
                'the neighbour is straight at the joint, and a conic '// &
                'is straight nowhere; only a straight line matches its curvature 0')
        end if
    end subroutine check_bend

    !> Fails with `cause%no_match` where a curvature asks for a weight below zero (of parallel end
    !> tangents it is zero, as far as doubles can say).
    pure subroutine check_side(span, w, bend, error)
        type(span_type), intent(in) :: span                 !! the ends with their tangents
        real(dp), intent(in) :: w                           !! the weight
        real(dp), intent(in) :: bend                        !! 1/deck unit, not zero
        type(error_type), allocatable, intent(out) :: error !! see above

        if (w > 0.0_dp .or. .not. has_corner(span)) return
        call fail(error, cause%no_match, 'the neighbour turns '//trim(merge('left ', 'right', &
            bend > 0.0_dp))//' at the joint (curvature '//compact(bend)// &
            '), but between its end '// &
            'slopes this arc turns '//trim(merge('right', 'left ', bend > 0.0_dp))// &
            '; turn an end slope, or ask for no equal curvature')
    end subroutine check_side

end module geom_joint
