!> The card of a line: round numbers for its ends, slopes and shoulder point that all good figures
!> allow together. Each number in turn is given the fewest decimals that are allowed with those
!> before it; of several such numbers, the one nearest to the middle of what is allowed.
module audit_card
    use audit_curve, only: quantity_type
    use audit_figure, only: figure_length
    use audit_fit, only: fit_type
    use audit_parameter, only: bound_parameter, fix_parameter, parameter_type
    use audit_reading, only: sort
    use base_constants, only: vertical_slope
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, direction_of_slope, end_type
    implicit none (type, external)
    private

    public :: card_type, make_card

    !> The numbers of a card.
    type :: card_type
        logical :: is_whole = .false.                !! all five were found
        logical :: is_conic = .false.                !! and have an arc: the card runs
        real(dp) :: x(3) = 0.0_dp                    !! abscissae of first, shoulder, last point
        character(figure_length) :: number(5) = ''   !! Y1, S1, Y2, Y3, S3 as they are punched
    end type card_type

    !> The order in which numbers are fixed: ends, slopes, shoulder point.
    integer, parameter :: turn(5) = [1, 4, 2, 5, 3]

contains

    !> The card of a fitted conic, and its conic instead of the one deepest inside the bounds.
    !> Where a number is not bounded by the good figures the card is not whole and the conic stays.
    pure subroutine make_card(fit, parameter, card)
        type(fit_type), intent(inout) :: fit              !! the conic and its good readings
        type(parameter_type), intent(in) :: parameter(5)  !! Y1, S1, Y2, Y3, S3, bounded
        type(card_type), intent(out) :: card              !! see above
        type(fit_type) :: fixed
        type(parameter_type) :: now
        real(dp) :: value
        integer :: i
        logical :: is_allowed

        card%x = parameter([1, 3, 4])%quantity%along
        fixed = fit
        do i = 1, 5
            associate (it => parameter(turn(i)), text => card%number(turn(i)))
                if (.not. it%exists) return
                if (it%quantity%sort == sort%slope .and. abs(it%value) >= vertical_slope) then
                    text = '999.999'
                    cycle
                end if
                now = it
                if (i > 1) now = bound_parameter(fixed, it%name, it%quantity)
                if (.not. now%is_limited .or. size(now%round) == 0) return
                text = middle_of(now)
                read (text, *) value
            end associate
            if (is_single(now)) cycle
            call fix_parameter(fixed, now%quantity, value, is_allowed)
            if (.not. is_allowed) return
        end do
        card%is_whole = .true.
        card%is_conic = has_arc(card)
        fit%k = fixed%k
    end subroutine make_card

    !> True where an arc goes through the points of a whole card with its slopes.
    pure logical function has_arc(card)
        type(card_type), intent(in) :: card !! with all numbers
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        real(dp) :: value(5)

        read (card%number, *) value
        associate (y1 => value(1), s1 => value(2), y2 => value(3), y3 => value(4), s3 => value(5))
            call arc_through(end_type([card%x(1), y1], direction_of_slope(s1)), [card%x(2), y2], &
                end_type([card%x(3), y3], direction_of_slope(s3)), arc, error)
        end associate
        has_arc = .not. allocated(error)
    end function has_arc

    !> True where a parameter is one number already.
    pure logical function is_single(parameter)
        type(parameter_type), intent(in) :: parameter !! bounded
        real(dp), parameter :: noise = 1.0e-9_dp
        is_single = parameter%high - parameter%low <= noise*max(1.0_dp, abs(parameter%value))
    end function is_single

    !> Of the round numbers the one nearest to the middle of the bounds.
    pure function middle_of(parameter) result(text)
        type(parameter_type), intent(in) :: parameter !! with one round number or more
        character(figure_length) :: text
        real(dp) :: value, apart, nearest
        integer :: i
        nearest = huge(nearest)
        do i = 1, size(parameter%round)
            read (parameter%round(i), *) value
            apart = abs(value - 0.5_dp*(parameter%low + parameter%high))
            if (apart >= nearest) cycle
            nearest = apart
            text = parameter%round(i)
        end do
    end function middle_of

end module audit_card
