!> BODY, NOSE and SECTION, and the end of a body: its names are put to its lines.
module deck_job_body
    use base_fault, only: fault_list_type
    use base_kinds, only: dp, i64
    use base_text, only: to_text
    use deck_body_card, only: blame, card_type, field_text, warn
    use deck_body_layout, only: body_card
    use deck_body_value, only: decimal_in, is_filled, looks_like_number, real_in
    use deck_body_word, only: suggestion
    use deck_job, only: body_type, name_length, origin, range_type, section_type, side, view
    use deck_job_line, only: close_line
    use deck_job_list, only: append
    use deck_job_state, only: check_once, find_line, line_names, state_type, text_of
    implicit none (type, external)
    private

    public :: take_body, take_nose, take_section, close_body

    !> The views in words.
    character(*), parameter :: view_name(3) = ['SIDE ', 'PLAN ', 'ANGLE']

contains

    !> Takes a BODY card: closes the open body, if there is anything of it, and opens another.
    pure subroutine take_body(state, card, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i

        if (state%has_body_card .or. &
            state%lines + state%sections + state%patches + state%ducts + state%cuts + &
            state%checks + state%outlines > 0 .or. state%body%has_nose) &
            call close_body(state, faults)
        do i = 1, state%bodies
            if (state%job%body(i)%name == field_text(card, 2)) call blame(card, 2, &
                'a second body '//field_text(card, 2), faults)
        end do
        state%has_body_card = .true.
        state%body%name = text_of(field_text(card, 2))
    end subroutine take_body

    !> Takes a NOSE card.
    pure subroutine take_nose(state, card, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        call check_once(state, card, body_card%nose, 'body', faults)
        if (real_in(card, 2) <= 0.0_dp) then
            call blame(card, 2, &
                'the radius of a rounded nose is above zero; without the card it is sharp', faults)
            return
        end if
        state%body%has_nose = .true.
        state%body%nose_radius = decimal_in(card, 2)
        state%body%nose_card = card
    end subroutine take_nose

    !> Takes a SECTION card. Its lines are found when the body closes.
    pure subroutine take_section(state, card, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(section_type) :: item
        integer :: i, before

        before = faults%count
        item%name = text_of(field_text(card, 2))
        item%card = card
        do i = 1, state%sections
            if (state%body%section(i)%name == item%name) call blame(card, 2, &
                'a second SECTION '//trim(item%name)//'; give it another name', faults)
        end do
        do i = 1, 2
            item%slope(i)%is_angle = .not. looks_like_number(field_text(card, 5 + i))
            if (.not. item%slope(i)%is_angle) item%slope(i)%value = decimal_in(card, 5 + i)
        end do
        item%range = range_type(is_filled(card, 8), is_filled(card, 9), decimal_in(card, 8), &
            decimal_in(card, 9))
        if (item%range%has_from .and. item%range%has_to .and. &
            real_in(card, 8) >= real_in(card, 9)) then
            call blame(card, 9, 'TO is not aft of FROM', faults)
        end if
        if (field_text(card, 10) == 'PORT') item%side = side%port
        if (field_text(card, 10) == 'BOTH') item%side = side%both
        item%is_sound = .not. faults%has_errors(before)
        call append(state%body%section, state%sections, item)
    end subroutine take_section

    !> Closes the open body: resolves its names, cuts its lists to length, adds it to the job.
    pure subroutine close_body(state, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(body_type) :: none
        integer :: i

        call close_line(state, faults)
        call resolve_views(state, faults)
        do i = 1, state%sections
            call resolve_section(state, i, faults)
        end do
        call append(state%job%body, state%bodies, trimmed_body(state))
        state%body = none
        state%lines = 0
        state%sections = 0
        state%outlines = 0
        state%patches = 0
        state%ducts = 0
        state%cuts = 0
        state%checks = 0
        state%has_body_card = .false.
        state%has_met(body_card%nose) = .false.
    end subroutine close_body

    !> The open body with its lists cut to length.
    pure type(body_type) function trimmed_body(state) result(body)
        type(state_type), intent(in) :: state !! the job so far

        body%name = state%body%name
        body%has_nose = state%body%has_nose
        body%nose_radius = state%body%nose_radius
        body%nose_card = state%body%nose_card
        allocate (body%line(state%lines), body%section(state%sections), body%cut(state%cuts), &
            body%check(state%checks), body%outline(state%outlines), body%patch(state%patches), &
            body%duct(state%ducts))
        if (state%lines > 0) body%line = state%body%line(:state%lines)
        if (state%sections > 0) body%section = state%body%section(:state%sections)
        if (state%outlines > 0) body%outline = state%body%outline(:state%outlines)
        if (state%patches > 0) body%patch = state%body%patch(:state%patches)
        if (state%ducts > 0) body%duct = state%body%duct(:state%ducts)
        if (state%cuts > 0) body%cut = state%body%cut(:state%cuts)
        if (state%checks > 0) body%check = state%body%check(:state%checks)
    end function trimmed_body

    !> Puts the views that are taken over to the lines they come from. A view is unsound where the
    !> one it comes from is.
    pure subroutine resolve_views(state, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i, j, from
        logical :: is_settled

        do i = 1, state%lines
            do j = 1, size(view_name)
                if (state%body%line(i)%view(j)%origin /= origin%line) cycle
                call look_up(state, state%body%line(i)%view(j)%card, 4, j, from, faults)
                state%body%line(i)%view(j)%line = from
                if (from == 0) state%body%line(i)%view(j)%is_sound = .false.
            end do
        end do
        is_settled = .false.
        do while (.not. is_settled)
            is_settled = .true.
            do i = 1, state%lines
                do j = 1, size(view_name)
                    associate (given => state%body%line(i)%view(j))
                        if (given%line == 0 .or. .not. given%is_sound) cycle
                        given%is_sound = state%body%line(given%line)%view(j)%is_sound
                        is_settled = is_settled .and. given%is_sound
                    end associate
                end do
            end do
        end do
    end subroutine resolve_views

    !> Puts the names of a section to lines. It is sound where its card and all views it needs are.
    pure subroutine resolve_section(state, number, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        integer, intent(in) :: number                   !! which section
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i, line
        logical :: is_sound

        is_sound = state%body%section(number)%is_sound
        associate (item => state%body%section(number))
            do i = 1, 3
                call look_up(state, item%card, 2 + i, view%side, line, faults)
                item%line(i) = line
                is_sound = is_sound .and. is_usable(state, item%line(i), view%side)
                if (item%line(i) == 0) cycle
                associate (plan => state%body%line(item%line(i))%view(view%plan))
                    if (plan%origin /= origin%none) then
                        is_sound = is_sound .and. plan%is_sound
                    else if (i == 2) then
                        call warn(item%card, 4, 'the shoulder line '//field_text(item%card, 4)// &
                            ' has no PLAN and so lies at BL 0', faults)
                    end if
                end associate
            end do
            do i = 1, 2
                if (.not. item%slope(i)%is_angle) cycle
                call look_up(state, item%card, 5 + i, view%angle, line, faults)
                item%slope(i)%line = line
                is_sound = is_sound .and. is_usable(state, item%slope(i)%line, view%angle)
            end do
            item%is_sound = is_sound
        end associate
    end subroutine resolve_section

    !> True where a line was found and the view of it is sound.
    pure logical function is_usable(state, line, which)
        type(state_type), intent(in) :: state   !! the job so far
        integer, intent(in) :: line             !! the line; 0: not found
        integer, intent(in) :: which            !! the view
        is_usable = .false.
        if (line > 0) is_usable = state%body%line(line)%view(which)%is_sound
    end function is_usable

    !> Finds the line named in a field. It must have the view, given on a card before; else 0.
    pure subroutine look_up(state, card, field, which, line, faults)
        type(state_type), intent(in) :: state           !! the job so far
        type(card_type), intent(in) :: card             !! the card that names it
        integer, intent(in) :: field                    !! where it is named
        integer, intent(in) :: which                    !! the view that is needed
        integer, intent(out) :: line                    !! the line
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: name, trouble
        integer(i64) :: defined

        name = field_text(card, field)
        trouble = ''
        line = find_line(state, name)
        if (line == 0) then
            trouble = 'there is no LINE '//name//in_this_body(state)// &
                suggestion(name, [line_names(state), words_instead(card)])
        else if (state%body%line(line)%view(which)%origin == origin%none) then
            trouble = 'LINE '//name//' has no '//trim(view_name(which))
        else
            defined = state%body%line(line)%view(which)%card%sheet(1)%line
            if (defined >= card%sheet(1)%line) trouble = trim(view_name(which))//' of '//name// &
                ' is given only on line '//to_text(defined)//'; it must be given before'
        end if
        if (trouble == '') return
        line = 0
        call blame(card, field, trouble, faults)
    end subroutine look_up

    !> What may stand in place of a line's name: on a LINE card the ways by points.
    pure function words_instead(card) result(words)
        type(card_type), intent(in) :: card !! the card that names a line
        character(name_length), allocatable :: words(:)
        words = [character(name_length) ::]
        if (field_text(card, 1) == 'LINE') words = [character(name_length) :: 'SPLINE', &
            'BEZIER', 'FAIR']
    end function words_instead

    !> Words that remind of the body a name belongs to, where there is more than one.
    pure function in_this_body(state) result(words)
        type(state_type), intent(in) :: state !! the job so far
        character(*), parameter :: reminder = ' in this body'
        character(merge(len(reminder, i64), 0_i64, state%bodies > 0)) :: words
        words = reminder
    end function in_this_body

end module deck_job_body
