!> A chain of strokes end to end, y over x: one view of a control line, with x the station. Each
!> stroke runs towards greater x and turns back nowhere, so that at each x of the range there is one
!> y; a tangent may be vertical at an end of a stroke only. A constant is a chain whose range has no
!> end.
module geom_chain
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use base_tolerances, only: decimal_noise, ulp
    use geom_arc, only: arc_type
    use geom_arc_point, only: slope_along
    use geom_jet, only: jet_type
    use geom_place, only: place_type
    use geom_stroke, only: conic_stroke, reversed_stroke, stroke_curvature, stroke_place, &
        stroke_point, stroke_tangent, stroke_type
    use geom_stroke_turn, only: stroke_turn
    use geom_vector, only: at_text
    implicit none (type, external)
    private

    public :: chain_type, new_chain, constant_chain
    public :: chain_value, chain_jet, chain_from, chain_to, chain_has, chain_joints
    public :: chain_piece

    !> A chain as `new_chain` or `constant_chain` makes it.
    type :: chain_type
        logical :: is_constant = .false.    !! the same y everywhere; there are no strokes
        real(dp) :: constant = 0.0_dp       !! that y, deck units
        type(stroke_type), allocatable :: stroke(:) !! each towards greater x, in order of x
        real(dp), allocatable :: knot(:)    !! where each stroke begins, and where the last one ends
    end type chain_type

    interface new_chain
        module procedure chain_of_arcs, chain_of_arcs_within, chain_within
    end interface new_chain

contains

    !> The chain of arcs that share their ends: `chain_within` with no gap but that of decimals.
    pure subroutine chain_of_arcs(arcs, chain, error)
        type(arc_type), intent(in) :: arcs(:)               !! one or more, from first to last
        type(chain_type), intent(out) :: chain              !! the chain, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see `chain_within`
        call chain_within(conic_stroke(arcs), 0.0_dp, chain, error)
    end subroutine chain_of_arcs

    !> The chain of conic arcs: `chain_within`.
    pure subroutine chain_of_arcs_within(arcs, gap, chain, error)
        type(arc_type), intent(in) :: arcs(:)               !! one or more, from first to last
        real(dp), intent(in) :: gap                         !! largest gap in x, deck units
        type(chain_type), intent(out) :: chain              !! the chain, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see `chain_within`
        call chain_within(conic_stroke(arcs), gap, chain, error)
    end subroutine chain_of_arcs_within

    !> The chain of some strokes. A stroke towards lesser x is turned round, and so is the order
    !> where the last stroke comes before the first.
    !>
    !> Fails with `cause%not_single_valued` where a stroke turns past the vertical or is a vertical
    !> line, and with `cause%joint_gap` where the next stroke begins at an x further than `gap` from
    !> the end of the one before. (Gaps in y are told by `geom_joint`.) In a gap in x the chain
    !> keeps the last y; of an overlap the later stroke counts.
    pure subroutine chain_within(strokes, gap, chain, error)
        type(stroke_type), intent(in) :: strokes(:)         !! one or more, from first to last
        real(dp), intent(in) :: gap                         !! largest gap in x, deck units
        type(chain_type), intent(out) :: chain              !! the chain, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i, last

        last = size(strokes)
        allocate (chain%stroke(last), chain%knot(last + 1))
        do i = 1, last
            chain%stroke(i) = strokes(i)
            if (strokes(i)%finish(1) < strokes(i)%start(1)) &
                chain%stroke(i) = reversed_stroke(strokes(i))
            call check_single_valued(chain%stroke(i), error)
            if (allocated(error)) return
        end do
        if (chain%stroke(last)%start(1) < chain%stroke(1)%start(1)) &
            chain%stroke = chain%stroke(last:1:-1)
        do i = 2, last
            call check_meeting(chain%stroke(i - 1), chain%stroke(i), gap, error)
            if (allocated(error)) return
        end do
        do i = 1, last
            chain%knot(i) = chain%stroke(i)%start(1)
        end do
        chain%knot(last + 1) = chain%stroke(last)%finish(1)
    end subroutine chain_within

    !> The chain of one y everywhere, from -huge to huge.
    pure subroutine constant_chain(value, chain)
        real(dp), intent(in) :: value          !! y, deck units
        type(chain_type), intent(out) :: chain !! the chain
        chain%is_constant = .true.
        chain%constant = value
    end subroutine constant_chain

    !> Fails with `cause%not_single_valued` where a stroke that runs towards greater x does not do
    !> so all the way.
    pure subroutine check_single_valued(stroke, error)
        type(stroke_type), intent(in) :: stroke             !! finish not before start
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: turn(2)
        logical :: turns

        if (.not. stroke%finish(1) > stroke%start(1)) then
            call fail(error, cause%not_single_valued, 'the arc begins and ends at '// &
                compact(stroke%start(1))//'; it must lead from one station to another')
            return
        end if
        call stroke_turn(stroke, turns, turn)
        if (turns) call fail(error, cause%not_single_valued, 'the arc from '// &
            at_text(stroke%start)//' to '//at_text(stroke%finish)// &
            ' turns past the vertical at '//at_text(turn)//' and has two ordinates there; '// &
            'end it where it is vertical')
    end subroutine check_single_valued

    !> Fails with `cause%joint_gap` where two strokes do not meet in x.
    pure subroutine check_meeting(before, after, gap, error)
        type(stroke_type), intent(in) :: before             !! a stroke
        type(stroke_type), intent(in) :: after              !! the next
        real(dp), intent(in) :: gap                         !! largest gap in x, deck units
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: noise

        noise = decimal_noise*ulp*max(abs(before%start(1)), abs(before%finish(1)))
        if (abs(after%start(1) - before%finish(1)) <= max(gap, noise) .and. &
            after%start(1) > before%start(1)) return
        call fail(error, cause%joint_gap, 'an arc ends at '//at_text(before%finish)// &
            ' and the next begins at '//at_text(after%start)//'; they must share that point')
    end subroutine check_meeting

    !> The ordinate at an x of the range, within a few ulp.
    pure real(dp) function chain_value(chain, x) result(y)
        type(chain_type), intent(in) :: chain !! any chain
        real(dp), intent(in) :: x             !! from `chain_from` to `chain_to`, deck units
        real(dp) :: at(2)
        integer :: i

        if (chain%is_constant) then
            y = chain%constant
        else
            i = chain_piece(chain, x)
            at = stroke_point(chain%stroke(i), stroke_place(chain%stroke(i), x))
            y = at(2)
        end if
    end function chain_value

    !> The ordinate at an x of the range with its derivatives; at a joint those after it.
    pure subroutine chain_jet(chain, x, jet, is_vertical)
        type(chain_type), intent(in) :: chain !! any chain
        real(dp), intent(in) :: x             !! from `chain_from` to `chain_to`, deck units
        type(jet_type), intent(out) :: jet    !! y and its derivatives
        logical, intent(out) :: is_vertical   !! dy/dx is infinite; the derivatives are zero then
        type(place_type) :: place
        real(dp) :: at(2), along(2)
        integer :: i

        is_vertical = .false.
        if (chain%is_constant) then
            jet%value = chain%constant
            return
        end if
        i = chain_piece(chain, x)
        place = stroke_place(chain%stroke(i), x)
        at = stroke_point(chain%stroke(i), place)
        along = stroke_tangent(chain%stroke(i), place)
        jet%value = at(2)
        associate (slope => slope_along(along))
            is_vertical = slope%is_vertical
            jet%first = slope%value
        end associate
        if (.not. is_vertical) then
            jet%second = stroke_curvature(chain%stroke(i), place)*(norm2(along)/along(1))**3
        end if
    end subroutine chain_jet

    !> The number of the stroke at an x: at a joint the one after it, beyond the range the nearest.
    pure integer function chain_piece(chain, x) result(low)
        type(chain_type), intent(in) :: chain !! not a constant
        real(dp), intent(in) :: x             !! deck units
        integer :: high, middle

        low = 1
        high = size(chain%stroke) + 1
        do while (high - low > 1)
            middle = (low + high)/2
            if (x < chain%knot(middle)) then
                high = middle
            else
                low = middle
            end if
        end do
    end function chain_piece

    !> The least x of a chain.
    pure real(dp) function chain_from(chain)
        type(chain_type), intent(in) :: chain !! any chain
        chain_from = -huge(1.0_dp)
        if (.not. chain%is_constant) chain_from = chain%knot(1)
    end function chain_from

    !> The greatest x of a chain.
    pure real(dp) function chain_to(chain)
        type(chain_type), intent(in) :: chain !! any chain
        chain_to = huge(1.0_dp)
        if (.not. chain%is_constant) chain_to = chain%knot(size(chain%knot))
    end function chain_to

    !> True where a chain has an ordinate at an x.
    pure logical function chain_has(chain, x)
        type(chain_type), intent(in) :: chain !! any chain
        real(dp), intent(in) :: x             !! deck units
        chain_has = x >= chain_from(chain) .and. x <= chain_to(chain)
    end function chain_has

    !> Where the strokes of a chain meet: each x between its ends where one begins.
    pure function chain_joints(chain) result(joints)
        type(chain_type), intent(in) :: chain !! any chain
        real(dp), allocatable :: joints(:)
        if (chain%is_constant) then
            allocate (joints(0))
        else
            joints = chain%knot(2:size(chain%stroke))
        end if
    end function chain_joints

end module geom_chain
