!> The cards that hold for the whole deck or for what follows: OUTPUT, DIGITS, PAGE, SYMMETRY,
!> CLOSE, TOLER; POINTS, LIMIT, FLANGE, SKIN, ARCS.
module deck_job_setting
    use base_constants, only: largest_table
    use base_decimal, only: decimal_type
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use deck_body_card, only: blame, card_type, field_text
    use deck_body_layout, only: body_card
    use deck_body_value, only: decimal_in, is_filled, real_in, whole_in
    use deck_job, only: axis, job_type, range_type, rule
    use deck_job_state, only: check_once, standing_type, state_type
    implicit none (type, external)
    private

    public :: take_setting, take_standing, default_joint_gap

    !> Decimals of a listing, at most.
    integer, parameter :: most_digits = 9
    !> Lines of a page, at least and at most.
    integer, parameter :: fewest_lines = 20, most_lines = 999

contains

    !> Takes a card that holds for the whole deck.
    pure subroutine take_setting(state, card, kind, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        integer, intent(in) :: kind                     !! `body_card%output` to `body_card%toler`
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        call check_once(state, card, kind, 'deck', faults)
        select case (kind)
        case (body_card%output)
            state%job%output = field_text(card, 2)
        case (body_card%digits)
            call check_between(card, 2, 0, most_digits, faults)
            state%job%digits = min(whole_in(card, 2), most_digits)
        case (body_card%page)
            call take_page(state%job, card, faults)
        case (body_card%symmetry)
            state%job%is_symmetric = field_text(card, 2) == 'YES'
        case (body_card%close)
            state%job%is_closed = .true.
        case (body_card%toler)
            if (real_in(card, 2) < 0.0_dp) call blame(card, 2, 'the tolerance is negative', faults)
            state%job%joint_gap = decimal_in(card, 2)
        end select
    end subroutine take_setting

    !> The largest gap at a joint where no TOLER card says it: one in the last decimal of an
    !> ordinate as the classic card has it, .001 inches, and as much of the other units.
    pure type(decimal_type) function default_joint_gap(units)
        character(*), intent(in) :: units !! INCHES, MM or FEET
        select case (units)
        case ('MM')
            default_joint_gap = decimal_type(25, -3)
        case ('FEET')
            default_joint_gap = decimal_type(1, -4)
        case default
            default_joint_gap = decimal_type(1, -3)
        end select
    end function default_joint_gap

    !> Takes a PAGE card.
    pure subroutine take_page(job, card, faults)
        type(job_type), intent(inout) :: job            !! gets the page
        type(card_type), intent(in) :: card             !! the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        select case (whole_in(card, 2))
        case (80, 132)
            job%page_columns = whole_in(card, 2)
        case default
            call blame(card, 2, 'a page has 80 or 132 columns', faults)
        end select
        call check_between(card, 3, fewest_lines, most_lines, faults)
        job%page_lines = max(fewest_lines, min(whole_in(card, 3), most_lines))
    end subroutine take_page

    !> Takes a card that holds for the cuts and checks that follow. A bad one changes nothing.
    pure subroutine take_standing(standing, card, kind, faults)
        type(standing_type), intent(inout) :: standing  !! what holds
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        integer, intent(in) :: kind                     !! `body_card%points` to `body_card%arcs`
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        select case (kind)
        case (body_card%points)
            call take_points(standing, card, faults)
        case (body_card%limit)
            call take_limit(standing, card, faults)
        case (body_card%flange)
            standing%is_flange_forward = field_text(card, 2) == 'FWD'
        case (body_card%skin)
            if (real_in(card, 2) < 0.0_dp) then
                call blame(card, 2, 'the thickness is negative; 0. is no skin', faults)
            else
                standing%skin = decimal_in(card, 2)
            end if
        case (body_card%arcs)
            if (real_in(card, 2) < 0.0_dp) then
                call blame(card, 2, 'the tolerance is negative; 0. ends the arcs', faults)
            else
                standing%arcs = decimal_in(card, 2)
            end if
        end select
    end subroutine take_standing

    !> Takes a POINTS card.
    pure subroutine take_points(standing, card, faults)
        type(standing_type), intent(inout) :: standing  !! gets the rule
        type(card_type), intent(in) :: card             !! the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: before

        before = faults%count
        call check_points_value(card, faults)
        if (faults%count > before) return
        standing%has_points = field_text(card, 2) /= 'DEFAULT'
        associate (points => standing%points)
            points%step = decimal_in(card, 3)
            select case (field_text(card, 2))
            case ('STA', 'BL', 'WL')
                points%kind = rule%step
                points%axis = axis_named(field_text(card, 2))
            case ('NUMBER')
                points%kind = rule%number
                points%number = whole_in(card, 3)
            case ('LENGTH')
                points%kind = rule%length
            case ('CHORD')
                points%kind = rule%chord
            end select
        end associate
    end subroutine take_points

    !> Looks at the number of a POINTS card.
    pure subroutine check_points_value(card, faults)
        type(card_type), intent(in) :: card             !! the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        real(dp) :: value

        value = real_in(card, 3)
        if (field_text(card, 2) == 'DEFAULT') then
            if (is_filled(card, 3)) call blame(card, 3, 'POINTS DEFAULT has no number', faults)
        else if (.not. is_filled(card, 3)) then
            call blame(card, 3, 'VALUE is missing: step, number, arc length or tolerance', faults)
        else if (value <= 0.0_dp) then
            call blame(card, 3, 'VALUE is above zero', faults)
        else if (field_text(card, 2) == 'NUMBER') then
            if (is_equal(value, anint(value))) then
                call check_between(card, 3, 2, largest_table, faults)
            else
                call blame(card, 3, 'the number of points is a whole number', faults)
            end if
        end if
    end subroutine check_points_value

    !> Takes a LIMIT card.
    pure subroutine take_limit(standing, card, faults)
        type(standing_type), intent(inout) :: standing  !! gets the limit
        type(card_type), intent(in) :: card             !! the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (field_text(card, 2) /= 'NONE') then
            if (.not. is_filled(card, 3) .and. .not. is_filled(card, 4)) call blame(card, 3, &
                'FROM and TO are missing; one of them at least is a limit', faults)
            standing%limit(axis_named(field_text(card, 2))) = range_type(is_filled(card, 3), &
                is_filled(card, 4), decimal_in(card, 3), decimal_in(card, 4))
        else if (is_filled(card, 3) .or. is_filled(card, 4)) then
            call blame(card, 3, 'LIMIT NONE has no numbers', faults)
        else
            standing%limit = range_type()
        end if
    end subroutine take_limit

    !> The axis of a name.
    pure integer function axis_named(name)
        character(*), intent(in) :: name !! STA, BL or WL
        axis_named = axis%sta
        if (name == 'BL') axis_named = axis%bl
        if (name == 'WL') axis_named = axis%wl
    end function axis_named

    !> A whole number must be between two others.
    pure subroutine check_between(card, field, least, most, faults)
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: field                    !! its field
        integer, intent(in) :: least                    !! least that may stand there
        integer, intent(in) :: most                     !! most that may stand there
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        if (real_in(card, field) >= real(least, dp) .and. &
            real_in(card, field) <= real(most, dp)) return
        call blame(card, field, 'the number is from '//to_text(least)//' to '//to_text(most), &
            faults)
    end subroutine check_between

end module deck_job_setting
