!> FAIRED and the points under it.
module deck_job_outline
    use base_decimal, only: decimal_type, to_real
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_body_card, only: blame, card_type, field_text
    use deck_body_value, only: decimal_in, is_filled
    use deck_job, only: origin, outline_type
    use deck_job_list, only: append
    use deck_job_state, only: open_line_type, state_type, text_of
    implicit none (type, external)
    private

    public :: take_outline, refuse_outline, close_outline

    !> Weight of points to be faired: waves four points long are about halved.
    type(decimal_type), parameter, public :: usual_weight = decimal_type(10, 0)
    !> Share of the second derivative in the energy.
    type(decimal_type), parameter :: usual_beta = decimal_type(5, -1)

contains

    !> Takes a FAIRED card and opens its outline for points.
    pure subroutine take_outline(state, card, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(outline_type) :: item
        integer :: i, before

        before = faults%count
        item%name = text_of(field_text(card, 2))
        item%card = card
        item%sta = decimal_in(card, 3)
        item%arcs = state%standing%arcs
        item%weight = usual_weight
        item%beta = usual_beta
        item%has_area = is_filled(card, 6)
        if (is_filled(card, 4)) item%weight = decimal_in(card, 4)
        if (is_filled(card, 5)) item%beta = decimal_in(card, 5)
        if (item%has_area) item%area = decimal_in(card, 6)
        do i = 1, state%outlines
            if (state%body%outline(i)%name == item%name) call blame(card, 2, &
                'a second FAIRED '//trim(item%name)//'; give it another name', faults)
        end do
        if (to_real(item%weight) <= 0.0_dp) call blame(card, 4, 'WEIGHT is above zero', faults)
        if (to_real(item%beta) < 0.0_dp .or. to_real(item%beta) > 1.0_dp) call blame(card, 5, &
            'BETA is from 0 to 1', faults)
        if (item%has_area .and. to_real(item%area) <= 0.0_dp) call blame(card, 6, &
            'AREA is above zero, whichever way round the points run', faults)
        item%is_sound = .not. faults%has_errors(before)
        call append(state%body%outline, state%outlines, item)
        state%open = open_line_type(is_open=.true., outline=state%outlines, origin=origin%fair)
    end subroutine take_outline

    !> After a FAIRED card in error its points are looked at, but not kept.
    pure subroutine refuse_outline(state)
        type(state_type), intent(inout) :: state !! the job so far
        state%open = open_line_type(is_open=.true., origin=origin%fair)
    end subroutine refuse_outline

    !> Gives the points read to their outline.
    pure subroutine close_outline(state, faults)
        type(state_type), intent(inout) :: state        !! the job so far, an outline open
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        associate (given => state%body%outline(state%open%outline), open => state%open)
            if (open%pieces == 0 .and. open%is_sound) then
                call blame(given%card, 2, &
                    'a FAIRED outline without points; they follow, BL and WL, one on a card', &
                    faults)
                open%is_sound = .false.
            end if
            given%is_sound = given%is_sound .and. open%is_sound
            allocate (given%piece(open%pieces))
            if (open%pieces > 0) given%piece = open%piece(:open%pieces)
        end associate
    end subroutine close_outline

end module deck_job_outline
