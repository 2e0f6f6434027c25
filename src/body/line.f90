!> A control line of a body: where it is at each station, in side view (WL over STA) and in plan
!> view (BL over STA), or how an end tangent of sections is turned there (degrees over STA).
module body_line
    use base_kinds, only: dp
    use deck_job, only: name_length
    use geom_chain, only: chain_from, chain_to, chain_type, chain_value
    implicit none (type, external)
    private

    public :: line_type, limit_line, line_point

    !> A control line. Its plan is BL 0 where the deck gives none.
    type :: line_type
        character(name_length) :: name = '' !! its name
        type(chain_type) :: side            !! WL over STA, deck units; where `has_side`
        type(chain_type) :: plan            !! BL over STA, deck units; where `has_side` too
        type(chain_type) :: angle           !! direction over STA, degrees; where `has_angle`
        logical :: has_side = .false.       !! the deck gives a side view
        logical :: has_plan = .false.       !! the deck gives a plan view
        logical :: has_angle = .false.      !! the deck gives an angle
        logical :: is_chine = .false.       !! a break of the skin on it is intended
        real(dp) :: from = 0.0_dp           !! least station where all its views are
        real(dp) :: to = 0.0_dp             !! greatest station where they are, not below `from`
    end type line_type

contains

    !> Sets the range of a line: where both its side and its plan view are, or, of a line that has
    !> but an angle, where this is. `to` comes out below `from` where the views do not overlap.
    pure subroutine limit_line(line)
        type(line_type), intent(inout) :: line !! a line with its views
        line%from = -huge(1.0_dp)
        line%to = huge(1.0_dp)
        if (line%has_side) call limit(line, line%side)
        if (line%has_plan) call limit(line, line%plan)
        if (.not. (line%has_side .or. line%has_plan)) call limit(line, line%angle)
    end subroutine limit_line

    !> Draws the range of a line in to that of a view.
    pure subroutine limit(line, view)
        type(line_type), intent(inout) :: line !! a line
        type(chain_type), intent(in) :: view   !! one of its views
        line%from = max(line%from, chain_from(view))
        line%to = min(line%to, chain_to(view))
    end subroutine limit

    !> BL and WL of a line, deck units; BL 0 where it has no plan.
    pure function line_point(line, sta) result(point)
        type(line_type), intent(in) :: line !! a control line with a side view
        real(dp), intent(in) :: sta         !! deck units
        real(dp) :: point(2)
        point = [0.0_dp, chain_value(line%side, sta)]
        if (line%has_plan) point(1) = chain_value(line%plan, sta)
    end function line_point

end module body_line
