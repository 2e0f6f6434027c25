!> The sides of a patch whose corners are anywhere on the curves they are parts of: each curve is
!> trimmed where it meets the next. A station or a cut may be a curve on each of several sections;
!> those are taken that meet all round.
module body_build_sides
    use base_decimal, only: to_real
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp, i64
    use base_text, only: compact, compact_length
    use body_contact, only: contact_type, contacts_of, nearest_contact
    use body_panel_side, only: point_side, side_part, side_type
    use body_side_curves, only: list_curves, side_words
    use body_trace, only: world_type
    use deck_job, only: bound, patch_type, range_type
    implicit none (type, external)
    private

    public :: trimmed_sides

    !> How two curves meet.
    type :: meeting_type
        type(contact_type), allocatable :: contact(:)   !! within the gap
    end type meeting_type

    !> A side on the way round: what it may be a part of, and how that meets the next side.
    type :: leg_type
        integer :: side = 0                                 !! number of the side
        character(:), allocatable :: words                  !! what it is
        type(side_type), allocatable :: curve(:)            !! whole curves it may be a part of
        type(meeting_type), allocatable :: meeting(:, :)    !! of each with each of the next side
        integer :: taken = 0                                !! which curve
    end type leg_type

    !> What holds for all sides.
    type :: rule_type
        real(dp) :: gap = 0.0_dp    !! by which they may miss each other, deck units
        type(range_type) :: range   !! stations where they may meet
    end type rule_type

    !> Places that are told of one pair of sides.
    integer, parameter :: most_told = 4

contains

    !> The four sides, trimmed. Fails with `cause%joint_gap` where sides do not meet, or in several
    !> places, and with `cause%beyond_lines` where a side has no curve.
    pure subroutine trimmed_sides(asked, world, side, error)
        type(patch_type), intent(in) :: asked               !! the patch
        type(world_type), intent(in) :: world               !! lines, sections, cuts
        type(side_type), intent(out) :: side(4)             !! from corner to corner
        type(error_type), allocatable, intent(out) :: error !! see above
        type(leg_type), allocatable :: leg(:)
        type(rule_type) :: rule
        integer :: i, n

        rule = rule_type(world%gap, asked%range)
        n = count(asked%side%kind /= bound%point)
        allocate (leg(n))
        leg%side = pack([1, 2, 3, 4], asked%side%kind /= bound%point)
        do i = 1, n
            leg(i)%words = trim(side_words(asked, world, leg(i)%side))
            call list_curves(asked, leg(i)%side, world, leg(i)%curve, error)
            if (allocated(error)) error%message = leg(i)%words//' '//error%message
            if (allocated(error)) return
        end do
        do i = 1, n
            call list_meetings(leg(i)%curve, leg(1 + mod(i, n))%curve, rule, leg(i)%meeting)
        end do
        call choose(leg, error)
        if (allocated(error)) then
            call explain(leg, rule, error)
            return
        end if
        do i = 1, n
            call trim_side(leg(1 + mod(i - 2 + n, n)), leg(i), leg(1 + mod(i, n))%taken, &
                side(leg(i)%side), error)
            if (allocated(error)) return
        end do
        i = findloc(asked%side%kind, bound%point, dim=1)
        if (i > 0) side(i) = point_side(side(1 + mod(i, 4))%at(0.0_dp))
    end subroutine trimmed_sides

    !> Finds where the curves of two sides meet, between FROM and TO.
    pure subroutine list_meetings(first, second, rule, meeting)
        type(side_type), intent(in) :: first(:)                         !! curves of a side
        type(side_type), intent(in) :: second(:)                        !! those of the next
        type(rule_type), intent(in) :: rule                             !! gap and range
        type(meeting_type), allocatable, intent(out) :: meeting(:, :)   !! all pairs
        type(contact_type), allocatable :: contact(:)
        integer :: a, b, i

        allocate (meeting(size(first), size(second)), contact(0))
        do b = 1, size(second)
            do a = 1, size(first)
                contact = contacts_of(first(a), second(b), rule%gap)
                meeting(a, b)%contact = pack(contact, [(is_within(contact(i)%at(1), rule), &
                    i = 1, size(contact))])
            end do
        end do
    end subroutine list_meetings

    !> True for a station between FROM and TO.
    pure logical function is_within(sta, rule)
        real(dp), intent(in) :: sta             !! deck units
        type(rule_type), intent(in) :: rule     !! the range
        is_within = .true.
        if (rule%range%has_from) is_within = sta >= to_real(rule%range%from) - rule%gap
        if (rule%range%has_to) is_within = is_within .and. &
            sta <= to_real(rule%range%to) + rule%gap
    end function is_within

    !> Chooses a curve of each side so that all meet, the first ones in order of the sections. Fails
    !> with `cause%joint_gap` where none do.
    pure subroutine choose(leg, error)
        type(leg_type), intent(inout) :: leg(:)             !! gets what is taken
        type(error_type), allocatable, intent(out) :: error !! see above
        logical :: is_round

        call take_curves(leg, size(leg), is_round)
        if (.not. is_round) call fail(error, cause%joint_gap, &
            'no curves of its sides meet all round')
    end subroutine choose

    !> Takes a curve of a side that meets the one taken of the next, and so on back to the first
    !> side, until they go all round.
    pure recursive subroutine take_curves(leg, place, is_round)
        type(leg_type), intent(inout) :: leg(:) !! taken behind the place; gets the others
        integer, intent(in) :: place            !! of the side on the way round, from the last to 0
        logical, intent(out) :: is_round        !! they go all round
        integer :: i, k, n

        n = size(leg)
        if (place == 0) then
            is_round = all([(is_long(leg(1 + mod(i - 2 + n, n)), leg(i), leg(1 + mod(i, n))), &
                i = 1, n)])
            return
        end if
        is_round = .false.
        do k = 1, size(leg(place)%curve)
            if (place < n) then
                if (size(leg(place)%meeting(k, leg(place + 1)%taken)%contact) == 0) cycle
            end if
            leg(place)%taken = k
            call take_curves(leg, place - 1, is_round)
            if (is_round) return
        end do
    end subroutine take_curves

    !> True where the curve taken of a side meets those of its neighbours, not in one point alone.
    pure logical function is_long(before, leg, after)
        type(leg_type), intent(in) :: before    !! the side before it
        type(leg_type), intent(in) :: leg       !! the side
        type(leg_type), intent(in) :: after     !! the side after it
        associate (begins => before%meeting(before%taken, leg%taken)%contact, &
            ends => leg%meeting(leg%taken, after%taken)%contact)
            is_long = size(begins) > 0 .and. size(ends) > 0
            if (size(begins) == 1 .and. size(ends) == 1) &
                is_long = abs(begins(1)%t(2) - ends(1)%t(1)) > 0.0_dp
        end associate
    end function is_long

    !> Trims the curve of a side. Fails with `cause%joint_gap` where it meets the next more than
    !> once.
    pure subroutine trim_side(before, leg, after, side, error)
        type(leg_type), intent(in) :: before                !! the side before it
        type(leg_type), intent(in) :: leg                   !! the side
        integer, intent(in) :: after                        !! curve taken of the side after it
        type(side_type), intent(out) :: side                !! from corner to corner
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i

        associate (begins => before%meeting(before%taken, leg%taken)%contact, &
            ends => leg%meeting(leg%taken, after)%contact)
            if (size(ends) > 1) then
                call fail(error, cause%joint_gap, leg%words//' meets the next at')
                do i = 1, min(size(ends), most_told)
                    error%message = error%message//' '//in_space(ends(i)%at)//';'
                end do
                error%message = error%message//' say in FROM and TO which it is'
            else if (size(begins) == 1) then
                side = side_part(leg%curve(leg%taken), begins(1)%t(2), ends(1)%t(1))
            end if
        end associate
    end subroutine trim_side

    !> Says which sides do not meet, and in which order they would.
    pure subroutine explain(leg, rule, error)
        type(leg_type), intent(in) :: leg(:)                    !! the sides
        type(rule_type), intent(in) :: rule                     !! gap and range
        type(error_type), allocatable, intent(inout) :: error   !! gets the words
        type(contact_type) :: nearest, other
        integer :: i, a, b, next

        do i = 1, size(leg)
            next = 1 + mod(i, size(leg))
            if (meet(leg(i)%meeting)) cycle
            nearest%gap = huge(1.0_dp)
            do a = 1, size(leg(i)%curve)
                do b = 1, size(leg(next)%curve)
                    other = nearest_contact(leg(i)%curve(a), leg(next)%curve(b))
                    if (other%gap < nearest%gap) nearest = other
                end do
            end do
            error%message = leg(i)%words//' and '//leg(next)%words//' do not meet: the gap is '// &
                compact(nearest%gap)//' at '//in_space(nearest%at)
            if (nearest%gap <= rule%gap) error%message = leg(i)%words//' and '// &
                leg(next)%words//' meet at '//in_space(nearest%at)//', not between FROM and TO'
            error%message = error%message//trim(order_words(leg, rule))
            return
        end do
    end subroutine explain

    !> The order in which four sides meet, where it is another than that of the card.
    pure function order_words(leg, rule) result(words)
        type(leg_type), intent(in) :: leg(:)    !! the sides
        type(rule_type), intent(in) :: rule     !! gap and range
        character(*), parameter :: in_order = '; its sides go round in the order'
        character(len(in_order) + 8) :: words
        integer, parameter :: orders(4, 2) = reshape([1, 3, 2, 4, 1, 2, 4, 3], [4, 2])
        type(meeting_type), allocatable :: meeting(:, :)
        logical :: is_round
        integer :: i, k

        words = ''
        if (size(leg) < 4) return
        do k = 1, size(orders, 2)
            is_round = .true.
            do i = 1, 4
                call list_meetings(leg(orders(i, k))%curve, leg(orders(1 + mod(i, 4), k))%curve, &
                    rule, meeting)
                is_round = is_round .and. meet(meeting)
            end do
            if (.not. is_round) cycle
            write (words, '(a,4i2)') in_order, orders(:, k)
            return
        end do
    end function order_words

    !> True where any curves of two sides meet.
    pure logical function meet(meeting)
        type(meeting_type), intent(in) :: meeting(:, :) !! of all pairs
        integer :: a, b
        meet = .true.
        do b = 1, size(meeting, 2)
            do a = 1, size(meeting, 1)
                if (size(meeting(a, b)%contact) > 0) return
            end do
        end do
        meet = .false.
    end function meet

    !> A point in a sentence.
    pure function in_space(at) result(words)
        real(dp), intent(in) :: at(3) !! STA, BL, WL, deck units
        character(len('STA , BL , WL ', i64) + sum(compact_length(at))) :: words
        words = 'STA '//compact(at(1))//', BL '//compact(at(2))//', WL '//compact(at(3))
    end function in_space

end module body_build_sides
