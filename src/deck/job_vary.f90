!> The VARY cards: a field of the card right before it varies. A field is named as the card
!> reference names it, or counted from 1; it must hold a number, which is what `loft run` takes.
module deck_job_vary
    use base_decimal, only: decimal_type, to_real
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use deck_body_card, only: blame, card_type, field_count, field_text
    use deck_body_fields, only: fields_of
    use deck_body_layout, only: body_card, body_field_type, form, need
    use deck_body_value, only: decimal_in, is_filled, looks_like_number, number_in, real_in, &
        whole_in
    use deck_body_word, only: in_words, suggestion
    use deck_job_list, only: append
    use deck_job_state, only: state_type, text_of
    use deck_number, only: number_type
    use deck_sweep, only: target_type, variable_type
    implicit none (type, external)
    private

    public :: take_vary, refuse_vary, is_vary, most_variants

    !> Variants of a sweep, at most; no range or list has more values.
    integer, parameter :: most_variants = 1000000

contains

    !> True for the cards that vary the card before them.
    elemental logical function is_vary(kind)
        integer, intent(in) :: kind !! one of `body_card%...`
        is_vary = kind >= body_card%vary .and. kind <= body_card%vary_tied
    end function is_vary

    !> Takes a VARY card.
    pure subroutine take_vary(state, card, kind, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        integer, intent(in) :: kind                     !! a VARY card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(target_type) :: item
        integer :: before, first

        if (.not. allocated(state%before%sheet)) then
            call blame(card, 1, 'VARY without a card before it; it stands right behind the '// &
                'card it varies', faults)
            return
        end if
        if (state%before_kind == 0) then
            call refuse_vary(state, card, kind)
            return
        end if
        before = faults%count
        item%card = card
        item%of = state%before
        item%is_tied = kind == body_card%vary_tied
        first = merge(2, 3, kind == body_card%vary)
        call find_field(state, card, first, item%field, faults)
        call check_field_once(state, item, first, faults)
        call find_variable(state, field_text(card, first + 1), item%variable)
        if (item%is_tied) then
            call take_tie(item, faults)
        else
            call take_variable(state, item, kind, faults)
        end if
        if (faults%has_errors(before)) return
        call append(state%job%sweep%target, state%targets, item)
    end subroutine take_vary

    !> The number of a variable; 0: there is none of that name.
    pure subroutine find_variable(state, name, number)
        type(state_type), intent(in) :: state   !! the job so far
        character(*), intent(in) :: name        !! in capitals
        integer, intent(out) :: number          !! which variable
        do number = state%variables, 1, -1
            if (state%job%sweep%variable(number)%name == name) return
        end do
    end subroutine find_variable

    !> Finds the field that a VARY card names. It must be one for numbers and hold one.
    pure subroutine find_field(state, card, from, number, faults)
        type(state_type), intent(in) :: state           !! the job so far
        type(card_type), intent(in) :: card             !! the VARY card
        integer, intent(in) :: from                     !! its field that names the field
        integer, intent(out) :: number                  !! which field of the card before; 0: none
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(body_field_type), allocatable :: field(:)
        character(:), allocatable :: text
        integer :: found

        allocate (field, source=fields_of(state%before_kind))
        text = field_text(card, from)
        call look_up(field, text, found, number)
        if (found == 0) then
            call blame_field(card, from, pack(field%name, takes_numbers(field)), text, faults)
        else if (state%before_kind == body_card%object .and. field(found)%name == 'VALUE') then
            call blame(card, from, 'the value to come near to does not vary: all variants are '// &
                'compared by it', faults)
        else if (.not. takes_numbers(field(found))) then
            call blame(card, from, 'field '//trim(field(found)%name)//' of the card before is '// &
                'not for a number that can be varied', faults)
        else if (.not. looks_like_number(field_text(state%before, number))) then
            call blame(card, from, 'field '//trim(field(found)%name)//' of the card before '// &
                'holds no number; put one there, which loft run takes', faults)
        end if
    end subroutine find_field

    !> Looks a field up by its name, or by its number; the last field of a card may stand for all
    !> that follow.
    pure subroutine look_up(field, text, found, number)
        type(body_field_type), intent(in) :: field(:)   !! of the card
        character(*), intent(in) :: text                !! a name or a number
        integer, intent(out) :: found                   !! which of them; 0: none
        integer, intent(out) :: number                  !! which field of the card
        integer :: i

        found = 0
        number = field_number(text)
        do i = 1, size(field)
            if (field(i)%name == text .or. field(i)%field == number .or. &
                (field(i)%need == need%repeated .and. number > field(i)%field)) found = i
        end do
        if (found > 0 .and. number == 0) number = field(found)%field
    end subroutine look_up

    !> The number that a text is, where it is a whole one above zero; else 0.
    pure integer function field_number(text) result(number)
        character(*), intent(in) :: text !! without blanks around it
        type(number_type) :: read

        number = 0
        if (.not. looks_like_number(text)) return
        read = number_in(text, .true.)
        if (read%first == 0 .and. to_real(read%value) < real(huge(0), dp)) &
            number = max(0, nint(to_real(read%value)))
    end function field_number

    !> True for a field that may hold a number with a point.
    elemental logical function takes_numbers(field)
        type(body_field_type), intent(in) :: field !! of a card
        takes_numbers = field%form == form%number .or. field%form == form%either
    end function takes_numbers

    !> Says that there is no such field, and which could be meant: the one with nearly that name, or
    !> all that take numbers.
    pure subroutine blame_field(card, from, names, text, faults)
        type(card_type), intent(in) :: card             !! the VARY card
        integer, intent(in) :: from                     !! its field that names the other
        character(*), intent(in) :: names(:)            !! fields that take numbers
        character(*), intent(in) :: text                !! what was taken for a field
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        character(:), allocatable :: words

        words = 'the card before has no field '//text
        if (size(names) > 0) words = words//'; a number is in '//in_words(names)
        if (size(names) > 0 .and. .not. looks_like_number(text)) &
            words = words//suggestion(text, names)
        call blame(card, from, words, faults)
    end subroutine blame_field

    !> A field is varied by one VARY card only.
    pure subroutine check_field_once(state, item, from, faults)
        type(state_type), intent(in) :: state           !! the job so far
        type(target_type), intent(in) :: item           !! with its field
        integer, intent(in) :: from                     !! field of the VARY card that names it
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i

        do i = 1, state%targets
            associate (other => state%job%sweep%target(i))
                if (other%field == item%field .and. &
                    other%of%sheet(1)%line == item%of%sheet(1)%line) call blame(item%card, from, &
                    'a second VARY of field '//field_text(item%card, from), faults)
            end associate
        end do
    end subroutine check_field_once

    !> Takes FACTOR and ADD of a field that goes with a variable.
    pure subroutine take_tie(item, faults)
        type(target_type), intent(inout) :: item        !! with its card and variable
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        item%factor = decimal_type(1, 0)
        if (is_filled(item%card, 5)) item%factor = decimal_in(item%card, 5)
        item%add = decimal_in(item%card, 6)
        if (item%variable == 0) call blame(item%card, 4, 'no VARY card before has a variable '// &
            field_text(item%card, 4)//', with which this field could go', faults)
    end subroutine take_tie

    !> Remembers the variable of a VARY card that is in error, so that no card that goes with it is
    !> blamed.
    pure subroutine refuse_vary(state, card, kind)
        type(state_type), intent(inout) :: state    !! the job so far
        type(card_type), intent(in) :: card         !! a VARY card
        integer, intent(in) :: kind                 !! which
        type(variable_type) :: variable

        if (kind == body_card%vary_tied) return
        variable%name = text_of(field_text(card, name_field(kind)))
        call append(state%job%sweep%variable, state%variables, variable)
    end subroutine refuse_vary

    !> Which field of a VARY card names its variable.
    elemental integer function name_field(kind)
        integer, intent(in) :: kind !! which card
        name_field = merge(3, 4, kind == body_card%vary)
    end function name_field

    !> Takes a variable with its range or list.
    pure subroutine take_variable(state, item, kind, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(target_type), intent(inout) :: item        !! with its card; gets the variable
        integer, intent(in) :: kind                     !! a VARY card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(variable_type) :: variable
        integer :: i, at

        at = name_field(kind)
        variable%card = item%card
        variable%is_list = kind == body_card%vary_list
        variable%name = text_of(field_text(item%card, at))
        if (item%variable > 0) call blame(item%card, at, 'a second variable '// &
            trim(variable%name)//'; VARY TIED lets this field go with the first', faults)
        do i = 1, state%wanted
            if (state%job%sweep%wanted(i)%name == variable%name) call blame(item%card, at, &
                trim(variable%name)//' is the name of a measure; columns have different names', &
                faults)
        end do
        if (variable%is_list) then
            call take_list(variable)
        else
            call take_range(variable, faults)
        end if
        call append(state%job%sweep%variable, state%variables, variable)
        item%variable = state%variables
    end subroutine take_variable

    !> Takes FROM, TO and COUNT.
    pure subroutine take_range(variable, faults)
        type(variable_type), intent(inout) :: variable  !! with its card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        associate (card => variable%card)
            variable%value = [decimal_in(card, 4), decimal_in(card, 5)]
            variable%count = whole_in(card, 6)
            if (real_in(card, 4) > real_in(card, 5)) then
                call blame(card, 4, 'FROM is above TO; the least value stands first', faults)
            else if (.not. real_in(card, 4) < real_in(card, 5)) then
                call blame(card, 5, 'FROM and TO are the same; VARY LIST takes a single value', &
                    faults)
            end if
            if (.not. is_filled(card, 6)) return
            if (real_in(card, 6) < 2.0_dp) then
                call blame(card, 6, 'COUNT is 2 or more: FROM and TO are among the values', faults)
            else if (real_in(card, 6) > real(most_variants, dp)) then
                call blame(card, 6, 'COUNT is at most '//to_text(most_variants), faults)
            end if
        end associate
    end subroutine take_range

    !> Takes the values of a list.
    pure subroutine take_list(variable)
        type(variable_type), intent(inout) :: variable  !! with its card
        integer :: i

        allocate (variable%value(0))
        do i = 5, field_count(variable%card)
            if (is_filled(variable%card, i)) &
                variable%value = [variable%value, decimal_in(variable%card, i)]
        end do
        variable%count = size(variable%value)
    end subroutine take_list

end module deck_job_vary
