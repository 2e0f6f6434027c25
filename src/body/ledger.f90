!> The continuity ledger: how the strokes of each control line go on at their joints, in position,
!> slope and curvature, as numbers and in words.
module body_ledger
    use base_constants, only: degrees
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_text, only: compact, widest_compact
    use base_tolerances, only: agreement_ulps, fair_curvature, slope_resolution, ulp
    use deck_job, only: name_length
    use geom_joint, only: jump_between, jump_type
    use geom_place, only: at_finish, at_start
    use geom_stroke, only: stroke_curvature, stroke_type
    implicit none (type, external)
    private

    public :: joint_type, joint_between, is_broken, bends_on, joint_words

    !> A joint of a control line, run through towards greater stations.
    type :: joint_type
        character(name_length) :: line = ''     !! name of the line
        integer :: view = 1                     !! one of `view%...` of `deck_job`
        real(dp) :: sta = 0.0_dp                !! where it is, deck units
        type(jump_type) :: jump                 !! what jumps there
        real(dp) :: curvature(2) = 0.0_dp       !! before and after it, 1/deck unit
        logical :: is_knuckle = .false.         !! a slope break is intended
    end type joint_type

contains

    !> The joint of two strokes of a line, the second aft of the first.
    pure type(joint_type) function joint_between(before, after) result(joint)
        type(stroke_type), intent(in) :: before !! towards greater stations
        type(stroke_type), intent(in) :: after  !! the next, too
        joint%sta = after%start(1)
        joint%jump = jump_between(before, after)
        joint%curvature = [stroke_curvature(before, at_finish), &
            stroke_curvature(after, at_start)]
        where (abs(joint%curvature) <= max(rounding_of(before), rounding_of(after))) &
            joint%curvature = 0.0_dp
        joint%jump%curvature = joint%curvature(2) - joint%curvature(1)
    end function joint_between

    !> The curvature, 1/deck unit, that rounded coordinates give to a stroke that is straight at an
    !> end.
    pure real(dp) function rounding_of(stroke)
        type(stroke_type), intent(in) :: stroke !! any
        rounding_of = agreement_ulps*ulp*maxval(abs([stroke%start, stroke%finish])) &
            /norm2(stroke%finish - stroke%start)**2
    end function rounding_of

    !> True where the slope breaks by more than the rounding of two punched slopes.
    pure logical function is_broken(joint)
        type(joint_type), intent(in) :: joint !! any joint
        is_broken = abs(joint%jump%direction) > 2.0_dp*slope_resolution*degrees
    end function is_broken

    !> True where the curvature goes on as far as decimals of cards can make it.
    pure logical function bends_on(joint)
        type(joint_type), intent(in) :: joint !! any joint
        bends_on = abs(joint%jump%curvature) <= fair_curvature*maxval(abs(joint%curvature))
    end function bends_on

    !> A joint in plain words: `slope goes on, curvature jumps from 0.01 to 0.02`.
    pure function joint_words(joint) result(words)
        type(joint_type), intent(in) :: joint !! any joint
        character(64 + 3*widest_compact) :: words

        if (is_broken(joint)) then
            words = 'slope breaks by '//compact(joint%jump%direction)//' degrees'
            if (joint%is_knuckle) words = trim(words)//', a knuckle'
        else if (bends_on(joint)) then
            words = 'slope and curvature go on'
        else
            words = 'slope goes on, curvature jumps from '// &
                compact(joint%curvature(1))//' to '//compact(joint%curvature(2))
        end if
        if (is_zero(joint%jump%gap)) return
        words = 'the ends are '//compact(joint%jump%gap)//' apart, '//trim(words)
    end function joint_words

end module body_ledger
