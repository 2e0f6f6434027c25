!> What a whole card does to the job: its word is looked up, its fields are checked, and whoever
!> knows that card takes it.
module deck_job_deed
    use base_fault, only: fault_list_type, new_fault, severity
    use deck_body_card, only: blame, card_type, field_text
    use deck_body_check, only: check_card
    use deck_body_crowd, only: blame_crowded
    use deck_body_layout, only: body_card, body_layout
    use deck_body_word, only: begins_as_word, crowded_word, in_words, nearest_word, suggestion
    use deck_control_card, only: heading_type
    use deck_job, only: check_type, cut_type, job_type, side
    use deck_job_body, only: close_body, take_body, take_nose, take_section
    use deck_job_cut, only: check_of_card, cut_of_card
    use deck_job_duct, only: take_duct
    use deck_job_line, only: close_line, is_data_card, refuse_line, take_line, take_piece, &
        wordless_card
    use deck_job_list, only: append
    use deck_job_outline, only: refuse_outline, take_outline
    use deck_job_patch, only: take_patch
    use deck_job_setting, only: default_joint_gap, take_setting, take_standing
    use deck_job_state, only: state_type
    use deck_job_vary, only: is_vary, refuse_vary, take_vary
    use deck_job_wanted, only: is_measure, take_sweep, take_wanted
    use deck_sweep, only: sweep_type
    implicit none (type, external)
    private

    public :: take_card, finish_job

    !> Every word a card may begin with.
    character(8), parameter :: card_word(*) = [character(8) :: body_layout%word, 'TITLE', 'UNITS']

contains

    !> Takes a card with its continuations.
    pure subroutine take_card(state, card, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: before, kind

        call find_kind(state, card, kind, faults)
        if (.not. is_vary(kind)) state%before = card
        if (.not. is_vary(kind)) state%before_kind = 0
        if (kind == 0) return
        if (is_data_card(kind) .and. .not. state%open%is_open) then
            call blame(card, 1, &
                'a data card outside a LINE; a LINE card comes first, its data cards right '// &
                'behind it', faults)
            return
        end if
        if (.not. is_data_card(kind) .and. .not. is_vary(kind)) call close_line(state, faults)
        before = faults%count
        call check_card(card, kind, faults)
        if (.not. faults%has_errors(before)) then
            call take_sound(state, card, kind, faults)
        else if (kind == body_card%line) then
            call refuse_line(state)
        else if (kind == body_card%faired) then
            call refuse_outline(state)
        else if (is_vary(kind)) then
            call refuse_vary(state, card, kind)
        end if
        if (is_data_card(kind) .and. faults%has_errors(before)) state%open%is_sound = .false.
        if (faults%has_errors(before)) return
        if (.not. is_vary(kind)) state%before_kind = kind
        call append(state%job%card, state%cards, card)
    end subroutine take_card

    !> Finds out which card it is; 0 where it is none, which is then a fault.
    pure subroutine find_kind(state, card, kind, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! the card
        integer, intent(out) :: kind                    !! one of `body_card%...`, or 0
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: word, second
        integer :: i

        word = field_text(card, 1)
        if (word == 'OBJECTIVE') word = 'OBJECT'
        second = field_text(card, 2)
        kind = wordless_card(state)
        if (.not. begins_as_word(word)) return
        kind = 0
        do i = 1, size(body_layout)
            if (body_layout(i)%word /= word) cycle
            if (body_layout(i)%second == '' .or. body_layout(i)%second == second) kind = i
        end do
        if (kind == body_card%limit .and. is_measure(second)) kind = body_card%limit_measure
        if (kind > 0) return
        if (any(card_word == word)) then
            associate (wanted => pack(body_layout%second, body_layout%word == word))
                call blame(card, 2, word//' is followed by '//in_words(wanted)// &
                    suggestion(second, wanted), faults)
            end associate
        else
            call blame_word(state, card, word, faults)
        end if
    end subroutine find_kind

    !> Says that a word begins no card. Where it was meant to be a LINE card, the data cards that
    !> follow are its; a data card, its line is not whole.
    pure subroutine blame_word(state, card, word, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! the card
        character(*), intent(in) :: word                !! its first field
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(len(card_word)) :: meant

        meant = crowded_word(word, card_word)
        if (meant /= '') then
            call blame_crowded(card, faults)
        else
            call blame(card, 1, word//' begins no card (see loft help cards)'// &
                suggestion(word, card_word), faults)
            meant = nearest_word(word, card_word)
        end if
        if (meant == 'LINE') then
            call close_line(state, faults)
            call refuse_line(state)
        else if (any(body_layout(body_card%rho:body_card%blend)%word == meant)) then
            state%open%is_sound = .false.
        end if
    end subroutine blame_word

    !> Takes a card whose fields are sound.
    pure subroutine take_sound(state, card, kind, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: kind                     !! one of `body_card%...`
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (is_data_card(kind)) then
            call take_piece(state, card, kind, faults)
            return
        end if
        select case (kind)
        case (body_card%output:body_card%toler)
            call take_setting(state, card, kind, faults)
        case (body_card%points:body_card%arcs)
            call take_standing(state%standing, card, kind, faults)
        case (body_card%body)
            call take_body(state, card, faults)
        case (body_card%nose)
            call take_nose(state, card, faults)
        case (body_card%line)
            call take_line(state, card, faults)
        case (body_card%section)
            call take_section(state, card, faults)
        case (body_card%faired)
            call take_outline(state, card, faults)
        case (body_card%patch)
            call take_patch(state, card, faults)
        case (body_card%duct)
            call take_duct(state, card, faults)
        case (body_card%station:body_card%plane)
            call take_cut(state, card, kind, faults)
        case (body_card%check_point:body_card%check_box)
            call take_check(state, card, kind, faults)
        case (body_card%vary:body_card%vary_tied)
            call take_vary(state, card, kind, faults)
        case (body_card%sweep)
            call take_sweep(state, card, faults)
        case (body_card%object:body_card%limit_measure)
            call take_wanted(state, card, kind, faults)
        end select
    end subroutine take_sound

    !> Takes a card that asks for a cut.
    pure subroutine take_cut(state, card, kind, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: kind                     !! one of `body_card%...`
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(cut_type) :: item
        integer :: before
        before = faults%count
        call cut_of_card(card, kind, state%standing, item, faults)
        if (.not. faults%has_errors(before)) call append(state%body%cut, state%cuts, item)
    end subroutine take_cut

    !> Takes a CHECK card.
    pure subroutine take_check(state, card, kind, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: kind                     !! one of `body_card%...`
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(check_type) :: item
        integer :: before, i

        before = faults%count
        call check_of_card(card, kind, state%standing, item, faults)
        do i = 1, state%checks
            if (item%name /= '' .and. state%body%check(i)%name == item%name) call blame(card, &
                size(item%value) + 4, 'a second component '//trim(item%name), faults)
        end do
        if (.not. faults%has_errors(before)) call append(state%body%check, state%checks, item)
    end subroutine take_check

    !> Finishes the job at the end of the deck: the last body, what no card said, what is not there.
    pure subroutine finish_job(state, heading, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(heading_type), intent(in) :: heading       !! what TITLE and UNITS said
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        call close_body(state, faults)
        associate (job => state%job)
            job%body = job%body(:state%bodies)
            if (.not. allocated(job%card)) allocate (job%card(0))
            job%card = job%card(:state%cards)
            job%title = ''
            call trim_sweep(job%sweep, [state%variables, state%targets, state%wanted])
            if (allocated(heading%title)) job%title = heading%title
            if (allocated(heading%units)) job%units = heading%units
            if (.not. state%has_met(body_card%output)) job%output = job%units
            if (.not. state%has_met(body_card%toler)) job%joint_gap = default_joint_gap(job%units)
            call check_sides(job, faults)
            if (.not. faults%has_errors(0)) call warn_of_nothing(job, faults)
        end associate
    end subroutine finish_job

    !> Cuts the lists of the sweep to their length.
    pure subroutine trim_sweep(sweep, length)
        type(sweep_type), intent(inout) :: sweep    !! lists with room for more
        integer, intent(in) :: length(3)            !! variables, fields, measures
        type(sweep_type) :: room

        room = sweep
        if (allocated(room%variable)) deallocate (sweep%variable)
        if (allocated(room%target)) deallocate (sweep%target)
        if (allocated(room%wanted)) deallocate (sweep%wanted)
        allocate (sweep%variable(length(1)), sweep%target(length(2)), sweep%wanted(length(3)))
        if (length(1) > 0) sweep%variable = room%variable(:length(1))
        if (length(2) > 0) sweep%target = room%target(:length(2))
        if (length(3) > 0) sweep%wanted = room%wanted(:length(3))
    end subroutine trim_sweep

    !> A symmetric body has no port sections of its own.
    pure subroutine check_sides(job, faults)
        type(job_type), intent(inout) :: job            !! the job
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i, j

        if (.not. job%is_symmetric) return
        do i = 1, size(job%body)
            do j = 1, size(job%body(i)%section)
                associate (item => job%body(i)%section(j))
                    if (item%side == side%starboard) cycle
                    call blame(item%card, 10, field_text(item%card, 10)// &
                        ' in a symmetric body; SYMMETRY NO makes its sides different', faults)
                    item%is_sound = .false.
                end associate
            end do
        end do
    end subroutine check_sides

    !> Warns where there is nothing to cut, or no cut; faired outlines are something.
    pure subroutine warn_of_nothing(job, faults)
        type(job_type), intent(in) :: job               !! the job
        type(fault_list_type), intent(inout) :: faults  !! gets the warnings
        integer :: i, sections, cuts

        sections = 0
        cuts = 0
        do i = 1, size(job%body)
            if (size(job%body(i)%outline) > 0) return
        end do
        do i = 1, size(job%body)
            sections = sections + size(job%body(i)%section)
            cuts = cuts + size(job%body(i)%cut)
        end do
        if (sections == 0) then
            call faults%add(new_fault(severity%warning, 0, 0, 'the deck has no SECTION card: '// &
                'there is no body to cut'))
        else if (cuts == 0) then
            call faults%add(new_fault(severity%warning, 0, 0, &
                'the deck asks for no cut; STATION, BUTTOCK, WATERLN, OBLIQUE and PLANE do'))
        end if
    end subroutine warn_of_nothing

end module deck_job_deed
