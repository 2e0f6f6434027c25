!> The DUCT card: the outlines that it goes through, given on cards before.
module deck_job_duct
    use base_decimal, only: to_real
    use base_fault, only: fault_list_type
    use deck_body_card, only: blame, card_type, field_count, field_text
    use deck_body_value, only: is_filled
    use deck_body_word, only: suggestion
    use deck_duct, only: duct_type, first_outline
    use deck_job, only: name_length
    use deck_job_list, only: append
    use deck_job_name, only: check_name
    use deck_job_state, only: find_line, state_type, text_of
    implicit none (type, external)
    private

    public :: take_duct

contains

    !> Takes a DUCT card.
    pure subroutine take_duct(state, card, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(duct_type) :: item
        integer :: before, i

        before = faults%count
        item%name = text_of(field_text(card, 2))
        item%card = card
        allocate (item%outline(0))
        call check_name(state, card, faults)
        do i = first_outline, field_count(card)
            call take_outline(state, card, i, item%outline, faults)
        end do
        if (.not. faults%has_errors(before)) call append(state%body%duct, state%ducts, item)
    end subroutine take_duct

    !> Takes the outline named in a field; it stands aft of the one before.
    pure subroutine take_outline(state, card, field, outlines, faults)
        type(state_type), intent(in) :: state                   !! the job so far
        type(card_type), intent(in) :: card                     !! the card
        integer, intent(in) :: field                            !! where the name stands
        integer, allocatable, intent(inout) :: outlines(:)      !! gets its place
        type(fault_list_type), intent(inout) :: faults          !! what is wrong is added
        integer :: number

        if (.not. is_filled(card, field)) then
            call blame(card, field, 'a blank field between outlines; leave it out', faults)
            return
        end if
        number = find_outline(state, field_text(card, field))
        if (number == 0) then
            call blame_missing(state, card, field, faults)
            return
        end if
        if (size(outlines) > 0) call check_order(state, card, field, &
            [outlines(size(outlines)), number], faults)
        outlines = [outlines, number]
    end subroutine take_outline

    !> Which outline of the open body has a name; 0 where none has.
    pure integer function find_outline(state, name) result(number)
        type(state_type), intent(in) :: state   !! the job so far
        character(*), intent(in) :: name        !! in capitals
        do number = state%outlines, 1, -1
            if (state%body%outline(number)%name == name) return
        end do
    end function find_outline

    !> Says why there is no outline of a name.
    pure subroutine blame_missing(state, card, field, faults)
        type(state_type), intent(in) :: state           !! the job so far
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: field                    !! where the name stands
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        character(:), allocatable :: name
        character(name_length) :: names(state%outlines)
        integer :: i

        name = field_text(card, field)
        do i = 1, state%outlines
            names(i) = state%body%outline(i)%name
        end do
        if (find_line(state, name) > 0) then
            call blame(card, field, name// &
                ' is a LINE; a duct goes through FAIRED outlines, which are closed', faults)
        else
            call blame(card, field, 'there is no FAIRED '//name//' before this card'// &
                suggestion(name, names), faults)
        end if
    end subroutine blame_missing

    !> An outline stands aft of the one before it.
    pure subroutine check_order(state, card, field, pair, faults)
        type(state_type), intent(in) :: state           !! the job so far
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: field                    !! of the second
        integer, intent(in) :: pair(2)                  !! two outlines, as named
        type(fault_list_type), intent(inout) :: faults  !! gets a fault where it does not

        associate (one => state%body%outline(pair(1)), other => state%body%outline(pair(2)))
            if (.not. (one%is_sound .and. other%is_sound)) return
            if (to_real(other%sta) > to_real(one%sta)) return
            if (pair(1) == pair(2)) then
                call blame(card, field, 'outline '//trim(one%name)//' twice', faults)
            else if (to_real(other%sta) < to_real(one%sta)) then
                call blame(card, field, trim(other%name)//' stands forward of '// &
                    trim(one%name)//'; name the outlines from the foremost to the last', faults)
            else
                call blame(card, field, trim(other%name)//' stands at the station of '// &
                    trim(one%name)//'; a duct has one outline at a station', faults)
            end if
        end associate
    end subroutine check_order

end module deck_job_duct
