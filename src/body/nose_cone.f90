!> The sharp nose of a body: one point, the apex, in which its foremost control lines meet, and how
!> they leave it.
!>
!> The nose axis lies at BL 0 and has the mean of the greatest and the least slope in side view, so
!> that it halves the angle of the profile; what counts in a view is the offset from it. With the
!> axis oblique the nose is seen in a shear along WL, which keeps stations, plan and upright
!> tangents.
module body_nose_cone
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use body_line, only: line_type
    use deck_job, only: view
    use geom_chain, only: chain_jet, chain_type, chain_value
    use geom_jet, only: jet_type
    implicit none (type, external)
    private

    public :: cone_type, find_cone, offset_at

    !> A sharp nose: where all lines meet, and how they leave.
    type :: cone_type
        real(dp) :: apex(2) = 0.0_dp    !! STA, WL where they meet, at BL 0, deck units
        real(dp) :: axis = 0.0_dp       !! slope of the nose axis, dWL/dSTA
        real(dp) :: steepness = 0.0_dp  !! greatest slope of a line off the axis, above zero
        real(dp) :: aft = 0.0_dp        !! greatest station of the lines, deck units
    end type cone_type

contains

    !> The sharp nose of the lines of sections: apex, axis and steepness.
    !>
    !> Fails with `cause%joint_gap` where a line that is there does not pass through the apex, and
    !> with `cause%not_single_valued` where one is upright there or none leaves the axis.
    pure subroutine find_cone(lines, is_used, gap, cone, is_mine, error)
        type(line_type), intent(in) :: lines(:)             !! of the body
        logical, intent(in) :: is_used(:)                   !! sections stand on it
        real(dp), intent(in) :: gap                         !! by which points may miss the apex
        type(cone_type), intent(out) :: cone                !! the sharp nose
        logical, intent(out) :: is_mine(:)                  !! lines that meet in the apex
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: first, i

        is_mine = .false.
        first = minloc(lines%from, dim=1, mask=is_used .and. lines%from > -huge(1.0_dp))
        if (first == 0) then
            call fail(error, cause%joint_gap, 'all lines are constants and meet nowhere; '// &
                'take NOSE out')
            return
        end if
        cone%apex = [lines(first)%from, chain_value(lines(first)%side, lines(first)%from)]
        cone%aft = maxval(lines%to, mask=is_used .and. lines%to < huge(1.0_dp))
        is_mine = is_used .and. lines%from <= cone%apex(1) + gap
        do i = 1, size(lines)
            if (is_mine(i)) call check_meeting(lines(i), lines(first), cone%apex, gap, error)
            if (allocated(error)) return
        end do
        call find_slopes(lines, is_mine, cone, error)
    end subroutine find_cone

    !> Fails with `cause%joint_gap` where a line is not at BL 0 and the WL of the apex there.
    pure subroutine check_meeting(line, first, apex, gap, error)
        type(line_type), intent(in) :: line                 !! a line that is there
        type(line_type), intent(in) :: first                !! the line that gave the apex
        real(dp), intent(in) :: apex(2)                     !! STA, WL, deck units
        real(dp), intent(in) :: gap                         !! by which it may miss, deck units
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: at(2), sta

        sta = max(line%from, apex(1))
        at = [chain_value(line%plan, sta), chain_value(line%side, sta)]
        if (abs(at(1)) <= gap .and. abs(at(2) - apex(2)) <= gap) return
        call fail(error, cause%joint_gap, 'at station '//compact(sta)//' line '// &
            trim(line%name)//' is at BL '//compact(at(1))//', WL '//compact(at(2))// &
            '; all lines that begin there must meet in one point, as '//trim(first%name)// &
            ' does in BL 0, WL '//compact(apex(2)))
    end subroutine check_meeting

    !> The axis of a nose and how steep its lines leave it.
    !>
    !> Fails with `cause%not_single_valued` where a line is upright at the apex, or none is off the
    !> axis.
    pure subroutine find_slopes(lines, is_mine, cone, error)
        type(line_type), intent(in) :: lines(:)             !! of the body
        logical, intent(in) :: is_mine(:)                   !! lines that meet in the apex
        type(cone_type), intent(inout) :: cone              !! has its apex and a level axis
        type(error_type), allocatable, intent(out) :: error !! see above
        type(jet_type) :: side, plan
        logical :: is_vertical(2)
        real(dp) :: least, greatest, widest
        integer :: i

        least = huge(1.0_dp)
        greatest = -huge(1.0_dp)
        widest = 0.0_dp
        do i = 1, size(lines)
            if (.not. is_mine(i)) cycle
            call offset_at(cone, lines(i)%side, view%side, cone%apex(1), side, is_vertical(1))
            call offset_at(cone, lines(i)%plan, view%plan, cone%apex(1), plan, is_vertical(2))
            if (any(is_vertical)) then
                call fail(error, cause%not_single_valued, 'line '//trim(lines(i)%name)// &
                    ' is upright at station '//compact(cone%apex(1))// &
                    ' and thus round already; take NOSE out, or give the line an end slope')
                return
            end if
            least = min(least, side%first)
            greatest = max(greatest, side%first)
            widest = max(widest, abs(plan%first))
        end do
        cone%axis = 0.5_dp*(least + greatest)
        cone%steepness = max(widest, 0.5_dp*(greatest - least))
        if (cone%steepness > 0.0_dp) return
        call fail(error, cause%not_single_valued, 'all lines leave the nose in one direction; '// &
            'slopes that differ there make a nose that can be rounded')
    end subroutine find_slopes

    !> The offset of a view from the nose axis at a station, with its slope off the axis.
    pure subroutine offset_at(cone, chain, which, sta, offset, is_vertical)
        type(cone_type), intent(in) :: cone     !! the sharp nose
        type(chain_type), intent(in) :: chain   !! a view of a line
        integer, intent(in) :: which            !! `view%side` or `view%plan`
        real(dp), intent(in) :: sta             !! where the chain is, deck units
        type(jet_type), intent(out) :: offset   !! deck units; slope
        logical, intent(out) :: is_vertical     !! the slope is infinite; it is zero here then

        call chain_jet(chain, sta, offset, is_vertical)
        if (which == view%plan) return
        offset%value = offset%value - cone%apex(2) - cone%axis*(sta - cone%apex(1))
        offset%first = offset%first - cone%axis
    end subroutine offset_at

end module body_nose_cone
