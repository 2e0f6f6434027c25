!> From the data cards of one view of a control line to its chain of strokes, with its joints.
module body_build_view
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: compact
    use body_blend, only: blend_strokes
    use body_ledger, only: is_broken, joint_between, joint_type
    use body_piece, only: piece_stroke
    use deck_body_card, only: blame_span, warn
    use deck_job, only: control_line_type, piece, piece_type
    use geom_chain, only: chain_type, new_chain
    use geom_stroke, only: reversed_stroke, stroke_type
    use geom_vector, only: at_text
    implicit none (type, external)
    private

    public :: build_view

contains

    !> Builds the chain of a view from its data cards, and puts its joints at the end of the ledger.
    !> The cards may run fore or aft, also single ones of them. What is wrong is said of the card:
    !> no arc, no spiral, a turn past the vertical, a gap over `gap` (errors), a slope break that is
    !> not said to be a KNUCKLE (a warning).
    pure subroutine build_view(line, which, gap, chain, joints, faults)
        type(control_line_type), intent(in) :: line                 !! the line
        integer, intent(in) :: which                                !! one of `view%...`
        real(dp), intent(in) :: gap                                 !! largest gap, deck units
        type(chain_type), allocatable, intent(out) :: chain         !! where nothing is in error
        type(joint_type), allocatable, intent(inout) :: joints(:)   !! the ledger
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        type(stroke_type), allocatable :: strokes(:)
        type(chain_type) :: built
        type(error_type), allocatable :: error
        integer :: before

        before = faults%count
        associate (pieces => line%view(which)%piece)
            allocate (strokes(size(pieces)))
            call build_strokes(pieces, strokes, faults)
            if (.not. faults%has_errors(before)) call check_gaps(pieces, strokes, gap, faults)
            if (faults%has_errors(before)) return
            call new_chain(strokes, gap, built, error)
            if (allocated(error)) then
                call blame_values(pieces(size(pieces)), error%message, faults)
                return
            end if
            call enter_joints(line, which, built, .not. runs_aft(strokes(1)), joints, faults)
            allocate (chain, source=built)
        end associate
    end subroutine build_view

    !> The strokes of pieces, all in the direction of the first; none after one in error.
    pure subroutine build_strokes(pieces, strokes, faults)
        type(piece_type), intent(in) :: pieces(:)               !! from first to last
        type(stroke_type), intent(inout) :: strokes(:)          !! as many
        type(fault_list_type), intent(inout) :: faults          !! what is wrong is added
        type(chain_type) :: alone
        type(stroke_type) :: before
        type(error_type), allocatable :: error
        integer :: i

        do i = 1, size(pieces)
            if (pieces(i)%kind == piece%blend) cycle
            call piece_stroke(pieces(i), before, strokes(i), error)
            if (.not. allocated(error)) call new_chain(strokes(i:i), 0.0_dp, alone, error)
            if (allocated(error)) then
                call blame_values(pieces(i), error%message, faults)
                return
            end if
            if (runs_aft(strokes(i)) .neqv. runs_aft(strokes(1))) &
                strokes(i) = reversed_stroke(strokes(i))
            before = strokes(i)
        end do
        call blend_strokes(pieces, strokes, faults)
    end subroutine build_strokes

    !> True for a stroke towards greater stations.
    pure logical function runs_aft(stroke)
        type(stroke_type), intent(in) :: stroke !! any
        runs_aft = stroke%finish(1) > stroke%start(1)
    end function runs_aft

    !> Blames a piece that does not begin where the one before ends, or lies beside it.
    pure subroutine check_gaps(pieces, strokes, gap, faults)
        type(piece_type), intent(in) :: pieces(:)       !! from first to last
        type(stroke_type), intent(in) :: strokes(:)     !! theirs, in one direction
        real(dp), intent(in) :: gap                     !! largest gap, deck units
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        real(dp) :: apart
        integer :: i

        do i = 2, size(pieces)
            apart = norm2(strokes(i)%start - strokes(i - 1)%finish)
            if (apart <= gap) cycle
            call blame_values(pieces(i), 'the line goes on at '//at_text(strokes(i)%start)// &
                ', but the card before ends at '//at_text(strokes(i - 1)%finish)//', '// &
                compact(apart)//' away; make it the same point (TOLER allows '//compact(gap)// &
                ')', faults)
        end do
    end subroutine check_gaps

    !> Puts the joints of a chain in the ledger, and warns of slope breaks that are no knuckles.
    pure subroutine enter_joints(line, which, chain, is_turned, joints, faults)
        type(control_line_type), intent(in) :: line                 !! the line
        integer, intent(in) :: which                                !! one of `view%...`
        type(chain_type), intent(in) :: chain                       !! the chain of this view
        logical, intent(in) :: is_turned                            !! the cards run forward
        type(joint_type), allocatable, intent(inout) :: joints(:)   !! the ledger
        type(fault_list_type), intent(inout) :: faults              !! warnings are added
        type(joint_type) :: joint
        integer :: i, card

        associate (pieces => line%view(which)%piece, stroke => chain%stroke)
            do i = 1, size(stroke) - 1
                card = merge(size(stroke) + 1 - i, i + 1, is_turned)
                joint = joint_between(stroke(i), stroke(i + 1))
                joint%line = line%name
                joint%view = which
                joint%is_knuckle = pieces(card)%is_knuckle
                joints = [joints, joint]
                if (.not. is_broken(joint) .or. joint%is_knuckle) cycle
                call warn(pieces(card)%card, pieces(card)%first_field, 'the slope breaks by '// &
                    compact(joint%jump%direction)//' degrees at '//compact(joint%sta)// &
                    '; correct an end slope, or say KNUCKLE where it is meant to', faults)
            end do
        end associate
    end subroutine enter_joints

    !> Blames all numbers of a piece.
    pure subroutine blame_values(item, message, faults)
        type(piece_type), intent(in) :: item            !! the piece
        character(*), intent(in) :: message             !! what is wrong and what would be right
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        call blame_span(item%card, item%first_field, item%first_field + size(item%value) - 1, &
            message, faults)
    end subroutine blame_values

end module body_build_view
