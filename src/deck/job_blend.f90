!> The BLEND card: what can be said of it and of its place among the data cards of a line.
module deck_job_blend
    use base_decimal, only: to_real
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: compact
    use deck_body_card, only: blame
    use deck_body_value, only: is_filled
    use deck_job, only: piece, piece_type
    use deck_job_state, only: open_line_type
    implicit none (type, external)
    private

    public :: check_blend, check_last_blend

    !> The greatest ALPHA and THETA, degrees: up to this ALPHA the curvature from a line to a circle
    !> is monotone for all circles.
    real(dp), parameter :: most_alpha = 90.0_dp, most_theta = 80.0_dp

contains

    !> Looks at the next data card of a line: a BLEND, or what stands behind one.
    pure subroutine check_blend(open, item, faults)
        type(open_line_type), intent(in) :: open        !! the line with the cards before this one
        type(piece_type), intent(in) :: item            !! the next card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        logical :: is_behind

        is_behind = .false.
        if (open%pieces > 0) is_behind = open%piece(open%pieces)%kind == piece%blend
        if (is_behind .and. item%is_match) call blame(item%card, 1, &
            'MATCH behind a BLEND; the spiral itself goes over into the curvature of this card', &
            faults)
        if (item%kind /= piece%blend) return
        if (open%pieces == 0) call blame(item%card, 1, &
            'a BLEND before the data cards of its line; it stands between two of them', faults)
        if (is_behind) call blame(item%card, 1, &
            'a BLEND behind a BLEND; a line or a circle stands between them', faults)
        call check_angle(item, 1, 'ALPHA', most_alpha, faults)
        call check_angle(item, 2, 'THETA', most_theta, faults)
    end subroutine check_blend

    !> Blames an angle that is given and too small or too large.
    pure subroutine check_angle(item, number, name, most, faults)
        type(piece_type), intent(in) :: item            !! a BLEND
        integer, intent(in) :: number                   !! which angle
        character(5), intent(in) :: name                !! its name
        real(dp), intent(in) :: most                    !! the largest, degrees
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        real(dp) :: angle
        integer :: field

        field = item%first_field - 1 + number
        angle = to_real(item%value(number))
        if (.not. is_filled(item%card, field)) return
        if (angle > 0.0_dp .and. angle <= most) return
        call blame(item%card, field, name//' of a BLEND is above 0 and not above '// &
            compact(most)//' degrees', faults)
    end subroutine check_angle

    !> Blames a BLEND that is the last card of its line.
    pure subroutine check_last_blend(open, faults)
        type(open_line_type), intent(inout) :: open     !! a line with all its cards
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (open%pieces == 0) return
        if (open%piece(open%pieces)%kind /= piece%blend) return
        call blame(open%piece(open%pieces)%card, 1, &
            'a BLEND behind the data cards of its line; it stands between two of them', faults)
        open%is_sound = .false.
    end subroutine check_last_blend

end module deck_job_blend
