!> Names of the parts of a body: sections, patches and ducts stand in the same column of tables.
module deck_job_name
    use base_fault, only: fault_list_type
    use deck_body_card, only: blame, card_type, field_text
    use deck_job_state, only: state_type
    implicit none (type, external)
    private

    public :: check_name

contains

    !> Faults of the name in field 2 of a PATCH or DUCT card that a part before it has.
    pure subroutine check_name(state, card, faults)
        type(state_type), intent(in) :: state           !! the job so far
        type(card_type), intent(in) :: card             !! the card
        type(fault_list_type), intent(inout) :: faults  !! gets a fault where the name is taken
        character(:), allocatable :: name

        name = field_text(card, 2)
        if (state%ducts > 0) then
            if (any(state%body%duct(:state%ducts)%name == name)) &
                call blame_taken('DUCT', card, faults)
        end if
        if (state%patches > 0) then
            if (any(state%body%patch(:state%patches)%name == name)) &
                call blame_taken('PATCH', card, faults)
        end if
        if (state%sections > 0) then
            if (any(state%body%section(:state%sections)%name == name)) &
                call blame_taken('SECTION', card, faults)
        end if
    end subroutine check_name

    !> Says which part has the name of a card.
    pure subroutine blame_taken(part, card, faults)
        character(*), intent(in) :: part                !! the word of its card
        type(card_type), intent(in) :: card             !! a PATCH or DUCT card
        type(fault_list_type), intent(inout) :: faults  !! gets the fault

        if (part == field_text(card, 1)) then
            call blame(card, 2, 'a second '//part//' '//field_text(card, 2)// &
                '; give it another name', faults)
        else
            call blame(card, 2, 'there is a '//part//' '//field_text(card, 2)//'; give the '// &
                trim(merge('duct ', 'patch', field_text(card, 1) == 'DUCT'))//' another name', &
                faults)
        end if
    end subroutine blame_taken

end module deck_job_name
