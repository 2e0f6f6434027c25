!> A chain of arcs end to end, y over x: one view of a control line, with x the station. Each arc
!> runs towards greater x and turns back nowhere, so that at each x of the range there is one y; a
!> tangent may be vertical at an end of an arc only. A constant is a chain whose range has no end.
module geom_chain
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use base_tolerances, only: decimal_noise, ulp
    use geom_arc, only: arc_type, reversed
    use geom_arc_point, only: curvature, point, slope_along, tangent
    use geom_crossing, only: crossing, turning_places
    use geom_jet, only: jet_type
    use geom_place, only: at_finish, at_start, place_type
    use geom_vector, only: at_text
    implicit none (type, external)
    private

    public :: chain_type, new_chain, constant_chain
    public :: chain_value, chain_jet, chain_from, chain_to, chain_has, chain_joints
    public :: chain_piece, chain_place

    !> A chain as `new_chain` or `constant_chain` makes it.
    type :: chain_type
        logical :: is_constant = .false.    !! the same y everywhere; there are no arcs
        real(dp) :: constant = 0.0_dp       !! that y, deck units
        type(arc_type), allocatable :: arc(:) !! the arcs, each towards greater x, in order of x
        real(dp), allocatable :: knot(:)    !! where arc i begins, and where the last one ends
    end type chain_type

    interface new_chain
        module procedure chain_of, chain_within
    end interface new_chain

contains

    !> The chain of arcs that share their ends: `chain_within` with no gap but that of decimals.
    pure subroutine chain_of(arcs, chain, error)
        type(arc_type), intent(in) :: arcs(:)               !! one or more, from first to last
        type(chain_type), intent(out) :: chain              !! the chain, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see `chain_within`
        call chain_within(arcs, 0.0_dp, chain, error)
    end subroutine chain_of

    !> The chain of some arcs. An arc towards lesser x is turned round, and so is the order where
    !> the last arc comes before the first.
    !>
    !> Fails with `cause%not_single_valued` where an arc turns past the vertical or is a vertical
    !> line, and with `cause%joint_gap` where the next arc begins at an x further than `gap` from
    !> the end of the one before. (Gaps in y are told by `geom_joint`.) In a gap in x the chain
    !> keeps the last y; of an overlap the later arc counts.
    pure subroutine chain_within(arcs, gap, chain, error)
        type(arc_type), intent(in) :: arcs(:)               !! one or more, from first to last
        real(dp), intent(in) :: gap                         !! largest gap in x, deck units
        type(chain_type), intent(out) :: chain              !! the chain, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i, last

        last = size(arcs)
        allocate (chain%arc(last), chain%knot(last + 1))
        do i = 1, last
            chain%arc(i) = arcs(i)
            if (arcs(i)%finish(1) < arcs(i)%start(1)) chain%arc(i) = reversed(arcs(i))
            call check_single_valued(chain%arc(i), error)
            if (allocated(error)) return
        end do
        if (chain%arc(last)%start(1) < chain%arc(1)%start(1)) chain%arc = chain%arc(last:1:-1)
        do i = 2, last
            call check_meeting(chain%arc(i - 1), chain%arc(i), gap, error)
            if (allocated(error)) return
        end do
        chain%knot(:last) = chain%arc%start(1)
        chain%knot(last + 1) = chain%arc(last)%finish(1)
    end subroutine chain_within

    !> The chain of one y everywhere, from -huge to huge.
    pure subroutine constant_chain(value, chain)
        real(dp), intent(in) :: value          !! y, deck units
        type(chain_type), intent(out) :: chain !! the chain
        chain%is_constant = .true.
        chain%constant = value
    end subroutine constant_chain

    !> Fails with `cause%not_single_valued` where an arc that runs towards greater x does not
    !> do so all the way. A turn within decimal noise of an end is that end.
    pure subroutine check_single_valued(arc, error)
        type(arc_type), intent(in) :: arc                   !! finish not before start
        type(error_type), allocatable, intent(out) :: error !! see above
        type(place_type), allocatable :: turns(:)
        real(dp) :: turn(2)
        integer :: i

        if (.not. arc%finish(1) > arc%start(1)) then
            call fail(error, cause%not_single_valued, 'the arc begins and ends at '// &
                compact(arc%start(1))//'; it must lead from one station to another')
            return
        end if
        allocate (turns, source=turning_places(arc, 1))
        do i = 1, size(turns)
            turn = point(arc, turns(i))
            if (turn(1) >= arc%start(1) - noise(arc) .and. &
                turn(1) <= arc%finish(1) + noise(arc)) cycle
            call fail(error, cause%not_single_valued, 'the arc from '// &
                at_text(arc%start)//' to '//at_text(arc%finish)//' turns past the vertical at '// &
                at_text(turn)//' and has two ordinates there; end it where it is vertical')
            return
        end do
    end subroutine check_single_valued

    !> What decimals in doubles may miss along x.
    pure real(dp) function noise(arc)
        type(arc_type), intent(in) :: arc !! any arc
        noise = decimal_noise*ulp*max(abs(arc%start(1)), abs(arc%finish(1)))
    end function noise

    !> Fails with `cause%joint_gap` where two arcs do not meet in x.
    pure subroutine check_meeting(before, after, gap, error)
        type(arc_type), intent(in) :: before                !! an arc
        type(arc_type), intent(in) :: after                 !! the next
        real(dp), intent(in) :: gap                         !! largest gap in x, deck units
        type(error_type), allocatable, intent(out) :: error !! see above

        if (abs(after%start(1) - before%finish(1)) <= max(gap, noise(before)) .and. &
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
            at = point(chain%arc(i), chain_place(chain%arc(i), x))
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
        place = chain_place(chain%arc(i), x)
        at = point(chain%arc(i), place)
        along = tangent(chain%arc(i), place)
        jet%value = at(2)
        associate (slope => slope_along(along))
            is_vertical = slope%is_vertical
            jet%first = slope%value
        end associate
        if (.not. is_vertical) then
            jet%second = curvature(chain%arc(i), place)*(norm2(along)/along(1))**3
        end if
    end subroutine chain_jet

    !> The number of the arc at an x: at a joint the one after it, beyond the range the nearest.
    pure integer function chain_piece(chain, x) result(low)
        type(chain_type), intent(in) :: chain !! not a constant
        real(dp), intent(in) :: x             !! deck units
        integer :: high, middle

        low = 1
        high = size(chain%arc) + 1
        do while (high - low > 1)
            middle = (low + high)/2
            if (x < chain%knot(middle)) then
                high = middle
            else
                low = middle
            end if
        end do
    end function chain_piece

    !> The place of an arc of a chain at an x; beyond its ends the nearer one.
    pure type(place_type) function chain_place(arc, x) result(place)
        type(arc_type), intent(in) :: arc !! towards greater x
        real(dp), intent(in) :: x         !! deck units
        if (x <= arc%start(1)) then
            place = at_start
        else if (x >= arc%finish(1)) then
            place = at_finish
        else
            place = crossing(arc, 1, x, rising=.true.)
        end if
    end function chain_place

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

    !> Where the arcs of a chain meet: each x between its ends where one begins.
    pure function chain_joints(chain) result(joints)
        type(chain_type), intent(in) :: chain !! any chain
        real(dp), allocatable :: joints(:)
        if (chain%is_constant) then
            allocate (joints(0))
        else
            joints = chain%knot(2:size(chain%arc))
        end if
    end function chain_joints

end module geom_chain
