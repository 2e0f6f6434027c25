!> SWEEP, OBJECT, and LIMIT of a measure: how variants are made, and what of them is looked at.
module deck_job_wanted
    use base_decimal, only: to_real
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use deck_body_card, only: blame, card_type, field_text
    use deck_body_layout, only: body_card, measure_words
    use deck_body_value, only: decimal_in, is_filled, looks_like_number, real_in, whole_in
    use deck_body_word, only: nearest_word, suggestion, words_in
    use deck_job, only: name_length
    use deck_job_list, only: append
    use deck_job_state, only: check_once, find_line, line_names, state_type, text_of
    use deck_job_vary, only: most_variants
    use deck_sweep, only: goal, has_aim, measure, method, wanted_type
    implicit none (type, external)
    private

    public :: take_sweep, take_wanted, is_measure

contains

    !> True for a word that is a measure, or nearly so and nothing else.
    pure logical function is_measure(word)
        character(*), intent(in) :: word !! in capitals
        is_measure = any(words_in(measure_words) == word)
        if (.not. is_measure .and. len(word) > 4) &
            is_measure = nearest_word(word, words_in(measure_words)) /= ''
    end function is_measure

    !> Takes a SWEEP card.
    pure subroutine take_sweep(state, card, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: text
        integer :: before

        before = faults%count
        call check_once(state, card, body_card%sweep, 'deck', faults)
        text = field_text(card, 2)
        if (text == 'LATIN') then
            if (.not. is_filled(card, 3)) then
                call blame(card, 3, 'COUNT is missing: a Latin hypercube of how many variants', &
                    faults)
            else if (real_in(card, 3) < 1.0_dp .or. real_in(card, 3) > real(most_variants, dp)) then
                call blame(card, 3, 'the number of variants is from 1 to '// &
                    to_text(most_variants), faults)
            end if
        else if (is_filled(card, 3) .or. is_filled(card, 4)) then
            call blame(card, merge(3, 4, is_filled(card, 3)), 'COUNT and SEED are for SWEEP '// &
                'LATIN; values are counted on VARY cards', faults)
        end if
        if (is_filled(card, 4) .and. &
            (real_in(card, 4) < 0.0_dp .or. real_in(card, 4) > real(huge(0), &
            dp))) call blame(card, &
            4, 'SEED is from 0 to '//to_text(huge(0)), faults)
        if (faults%has_errors(before)) return
        associate (sweep => state%job%sweep)
            sweep%card = card
            sweep%method = method%grid
            if (text == 'LATIN') sweep%method = method%latin
            if (text == 'LIST') sweep%method = method%list
            sweep%count = whole_in(card, 3)
            if (is_filled(card, 4)) sweep%seed = whole_in(card, 4)
        end associate
    end subroutine take_sweep

    !> Takes an OBJECT card, or a LIMIT of a measure.
    pure subroutine take_wanted(state, card, kind, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        integer, intent(in) :: kind                     !! `body_card%object` or `%limit_measure`
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(wanted_type) :: item
        integer :: before

        before = faults%count
        item%card = card
        item%body = state%bodies + 1
        item%measure = findloc(words_in(measure_words) == field_text(card, 2), .true., 1)
        if (kind == body_card%object) then
            call take_goal(item, faults)
        else
            call take_limits(item, faults)
        end if
        call take_place(state, item, faults)
        item%name = text_of(field_text(card, 2))
        if (is_filled(card, 7)) item%name = text_of(field_text(card, 7))
        call check_name(state, item, faults)
        call check_aim_once(state, item, faults)
        if (faults%has_errors(before)) return
        call append(state%job%sweep%wanted, state%wanted, item)
    end subroutine take_wanted

    !> Takes what is wanted of a measure.
    pure subroutine take_goal(item, faults)
        type(wanted_type), intent(inout) :: item        !! with its card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        select case (field_text(item%card, 3))
        case ('MIN')
            item%goal = goal%least
        case ('MAX')
            item%goal = goal%most
        case ('NEAR')
            item%goal = goal%near
        case default
            item%goal = goal%show
        end select
        item%value = decimal_in(item%card, 4)
        if (item%goal == goal%near .neqv. is_filled(item%card, 4)) call blame(item%card, 4, &
            'VALUE goes with NEAR, and NEAR with VALUE: the value to come near to', faults)
    end subroutine take_goal

    !> Takes the limits of a measure.
    pure subroutine take_limits(item, faults)
        type(wanted_type), intent(inout) :: item        !! with its card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        item%goal = goal%range
        associate (card => item%card)
            item%has_from = is_filled(card, 3)
            item%has_to = is_filled(card, 4)
            item%from = decimal_in(card, 3)
            item%to = decimal_in(card, 4)
            if (.not. item%has_from .and. .not. item%has_to) then
                call blame(card, 3, 'FROM and TO are missing; one of them at least is a limit', &
                    faults)
            else if (item%has_from .and. item%has_to .and. real_in(card, 3) > real_in(card, 4)) then
                call blame(card, 3, 'FROM is above TO; nothing is between them', faults)
            end if
        end associate
    end subroutine take_limits

    !> Takes where a measure is taken: at a station, of a component, of a line.
    pure subroutine take_place(state, item, faults)
        type(state_type), intent(in) :: state           !! the job so far
        type(wanted_type), intent(inout) :: item        !! with its card and measure
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: word
        logical :: is_number

        associate (card => item%card)
            word = field_text(card, 2)
            is_number = looks_like_number(field_text(card, 5))
            select case (item%measure)
            case (measure%area, measure%girth, measure%width, measure%height)
                if (.not. is_number) call blame(card, 5, word//' is of a section; OF is its '// &
                    'station', faults)
                item%sta = decimal_in(card, 5)
            case (measure%clear, measure%jump, measure%break)
                if (is_number) then
                    call blame(card, 5, 'OF of '//word//' is a name, or blank: all', faults)
                else if (is_filled(card, 5)) then
                    item%of = text_of(field_text(card, 5))
                    call check_owner(state, item, faults)
                end if
            case default
                if (is_filled(card, 5)) call blame(card, 5, word//' is of the body; OF is blank', &
                    faults)
            end select
            item%at = decimal_in(card, 6)
            if (is_filled(card, 6) .neqv. &
                (item%measure == measure%width .or. item%measure == measure%height)) call &
                blame(card, 6, 'AT is the waterline of a WIDTH, the butt line of a HEIGHT', faults)
        end associate
    end subroutine take_place

    !> The component or line that a measure is of must be there.
    pure subroutine check_owner(state, item, faults)
        type(state_type), intent(in) :: state           !! the job so far
        type(wanted_type), intent(in) :: item           !! with the name
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(name_length) :: names(state%checks)
        integer :: i

        if (item%measure == measure%clear) then
            do i = 1, state%checks
                names(i) = state%body%check(i)%name
            end do
            if (any(names == item%of)) return
            call blame(item%card, 5, 'no CHECK card before has the component '//trim(item%of)// &
                suggestion(trim(item%of), names), faults)
        else if (find_line(state, trim(item%of)) == 0) then
            call blame(item%card, 5, 'there is no LINE '//trim(item%of)//' before'// &
                suggestion(trim(item%of), line_names(state)), faults)
        end if
    end subroutine check_owner

    !> Columns have different names; one measure has one column.
    pure subroutine check_name(state, item, faults)
        type(state_type), intent(in) :: state           !! the job so far
        type(wanted_type), intent(in) :: item           !! complete
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i

        do i = 1, state%variables
            if (state%job%sweep%variable(i)%name == item%name) call blame(item%card, 7, &
                trim(item%name)//' is the name of a variable; columns have different names', faults)
        end do
        do i = 1, state%wanted
            associate (other => state%job%sweep%wanted(i))
                if (other%name /= item%name .or. is_same(other, item)) cycle
                call blame(item%card, 7, 'another measure has the column '//trim(item%name)// &
                    '; NAME gives this one its own', faults)
                return
            end associate
        end do
    end subroutine check_name

    !> A measure has one aim: two would say the same twice, or that no variant betters another.
    pure subroutine check_aim_once(state, item, faults)
        type(state_type), intent(in) :: state           !! the job so far
        type(wanted_type), intent(in) :: item           !! complete
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i

        if (.not. has_aim(item)) return
        do i = 1, state%wanted
            associate (other => state%job%sweep%wanted(i))
                if (.not. (has_aim(other) .and. is_same(other, item))) cycle
                call blame(item%card, 3, trim(other%name)//' has an aim already, '// &
                    field_text(other%card, 3)//'; a measure has one', faults)
                return
            end associate
        end do
    end subroutine check_aim_once

    !> True where two cards look at the same measure.
    pure logical function is_same(a, b)
        type(wanted_type), intent(in) :: a !! a measure
        type(wanted_type), intent(in) :: b !! another, or the same
        is_same = a%measure == b%measure .and. a%body == b%body .and. a%of == b%of .and. &
            is_equal(to_real(a%sta), to_real(b%sta)) .and. is_equal(to_real(a%at), to_real(b%at))
    end function is_same

end module deck_job_wanted
