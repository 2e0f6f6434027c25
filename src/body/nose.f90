!> The nose of a body, sharp as its control lines meet or, with a NOSE card, rounded with a radius:
!>
!>     NOSE    1.5
!>
!> Rounded are the lines of sections that meet in the foremost point, in side view and plan; lines
!> that begin aft of the cap (a fairing, a canopy) and angles stay as they are. The nose axis lies
!> at BL 0 and has the mean of the greatest and the least slope in side view. The caps themselves
!> are made in `body_nose_cap`. What can't be rounded is said of the NOSE card, with the largest
!> radius that fits, and the nose stays sharp.
module body_nose
    use base_decimal, only: to_real
    use base_error, only: cause, error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_ledger, only: joint_between, joint_type
    use body_line, only: limit_line, line_type
    use body_nose_cap, only: cap_and_rest, new_nose, nose_type, put_cap
    use body_nose_cone, only: cone_type, find_cone
    use body_nose_fit, only: fit_nose, find_fitting
    use deck_body_card, only: blame
    use deck_job, only: body_type, origin, view
    use geom_stroke, only: stroke_type
    implicit none (type, external)
    private

    public :: round_nose

contains

    !> Rounds the nose of a body that has a NOSE card. In the ledger the joint of each cap with the
    !> rest of its line takes the place of the joints forward of it.
    pure subroutine round_nose(asked, gap, lines, joints, faults)
        type(body_type), intent(in) :: asked                        !! as the deck has it
        real(dp), intent(in) :: gap                                 !! by which points may miss
        type(line_type), intent(inout) :: lines(:)                  !! of the body
        type(joint_type), allocatable, intent(inout) :: joints(:)   !! the ledger
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        type(error_type), allocatable :: error
        type(nose_type) :: nose
        type(cone_type) :: cone
        type(line_type) :: rounded(size(lines))
        character(:), allocatable :: words
        logical :: is_used(size(lines)), is_mine(size(lines))
        real(dp) :: radius

        is_used = carries_section(asked, lines)
        if (.not. any(is_used)) return
        radius = to_real(asked%nose_radius)
        call find_cone(lines, is_used, gap, cone, is_mine, error)
        if (.not. allocated(error)) call fit_nose(lines, is_used, is_mine, &
            new_nose(cone, radius), nose, error)
        if (allocated(error)) then
            if (error%cause == cause%no_arc) then
                call find_fitting(lines, is_used, is_mine, cone, radius, words)
                error%message = error%message//'; '//words
            end if
        else
            rounded = lines
            call round_lines(nose, is_mine, gap, rounded, error)
        end if
        if (allocated(error)) then
            call blame(asked%nose_card, 2, 'the nose stays sharp: '//error%message, faults)
            return
        end if
        call enter_caps(asked, lines, is_mine, nose, joints)
        lines = rounded
    end subroutine round_nose

    !> Which lines points of sections lie on; none that is not sound, and of no section that isn't.
    pure function carries_section(asked, lines) result(carries)
        type(body_type), intent(in) :: asked        !! as the deck has it
        type(line_type), intent(in) :: lines(:)     !! of the body
        logical :: carries(size(lines))
        integer :: i

        carries = .false.
        do i = 1, size(asked%section)
            if (asked%section(i)%is_sound) carries(asked%section(i)%line) = .true.
        end do
        carries = carries .and. lines%has_side
    end function carries_section

    !> Puts the caps on all lines that begin in the apex.
    !>
    !> Fails as `put_cap`.
    pure subroutine round_lines(nose, is_mine, gap, lines, error)
        type(nose_type), intent(in) :: nose                 !! fits
        logical, intent(in) :: is_mine(:)                   !! it begins in the apex
        real(dp), intent(in) :: gap                         !! largest gap in x, deck units
        type(line_type), intent(inout) :: lines(:)          !! of the body
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i

        do i = 1, size(lines)
            if (.not. is_mine(i)) cycle
            call put_cap(nose, view%side, gap, lines(i)%side, error)
            if (.not. allocated(error)) call put_cap(nose, view%plan, gap, lines(i)%plan, error)
            if (allocated(error)) return
            call limit_line(lines(i))
        end do
    end subroutine round_lines

    !> Enters the joints of caps in the ledger. It stays in the order of lines and views; joints
    !> that the cap has taken away go. A view taken over has no joints of its own.
    pure subroutine enter_caps(asked, lines, is_mine, nose, joints)
        type(body_type), intent(in) :: asked                        !! as the deck has it
        type(line_type), intent(in) :: lines(:)                     !! still sharp
        logical, intent(in) :: is_mine(:)                           !! it is rounded
        type(nose_type), intent(in) :: nose                         !! fits
        type(joint_type), allocatable, intent(inout) :: joints(:)   !! the ledger
        type(joint_type), allocatable :: ledger(:)
        logical :: stays(size(joints)), has_cap
        integer :: i, j

        allocate (ledger(0))
        do i = 1, size(lines)
            do j = 1, size(asked%line(i)%view)
                stays = joints%line == lines(i)%name .and. joints%view == j
                if (is_mine(i) .and. j /= view%angle) then
                    stays = stays .and. joints%sta > nose%blend
                    has_cap = any(asked%line(i)%view(j)%origin == [origin%pieces, origin%constant])
                    if (has_cap) call enter_cap(lines(i), j, nose, ledger)
                end if
                ledger = [ledger, pack(joints, stays)]
            end do
        end do
        call move_alloc(ledger, joints)
    end subroutine enter_caps

    !> Enters the joint of one cap; a constant on the axis has none.
    pure subroutine enter_cap(line, which, nose, ledger)
        type(line_type), intent(in) :: line                         !! still sharp
        integer, intent(in) :: which                                !! `view%side` or `view%plan`
        type(nose_type), intent(in) :: nose                         !! fits
        type(joint_type), allocatable, intent(inout) :: ledger(:)   !! gets the joint
        type(stroke_type), allocatable :: strokes(:)
        type(error_type), allocatable :: error
        type(joint_type) :: joint

        allocate (strokes(0))
        if (which == view%side) then
            call cap_and_rest(nose, which, line%side, strokes, error)
        else
            call cap_and_rest(nose, which, line%plan, strokes, error)
        end if
        if (allocated(error) .or. size(strokes) == 0) return
        joint = joint_between(strokes(1), strokes(2))
        joint%line = line%name
        joint%view = which
        ledger = [ledger, joint]
    end subroutine enter_cap

end module body_nose
