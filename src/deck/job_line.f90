!> LINE and its data cards.
module deck_job_line
    use base_decimal, only: to_real
    use base_exact, only: is_zero
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_body_card, only: blame, card_type, field_text, warn
    use deck_body_check, only: has_option
    use deck_body_fields, only: fields_of
    use deck_body_layout, only: body_card, body_field_type
    use deck_body_value, only: decimal_in, is_filled, looks_like_number
    use deck_body_word, only: suggestion, word_length
    use deck_job, only: control_line_type, ending, origin, piece, piece_real, piece_type, view, &
        view_type
    use deck_job_blend, only: check_blend, check_last_blend
    use deck_job_list, only: append
    use deck_job_outline, only: close_outline, usual_weight
    use deck_job_state, only: find_line, open_line_type, state_type, text_of
    implicit none (type, external)
    private

    public :: take_line, refuse_line, take_piece, close_line, is_data_card, wordless_card

contains

    !> True for the cards that stand under a LINE.
    elemental logical function is_data_card(kind)
        integer, intent(in) :: kind !! one of `body_card%...`
        is_data_card = kind >= body_card%conic .and. kind <= body_card%point
    end function is_data_card

    !> What a card without a word is: a point under a LINE by points, else a conic.
    pure integer function wordless_card(state) result(kind)
        type(state_type), intent(in) :: state !! the job so far
        kind = merge(body_card%point, body_card%conic, by_points(state%open%origin))
    end function wordless_card

    !> True for a view that is given by points.
    elemental logical function by_points(from)
        integer, intent(in) :: from !! one of `origin%...`
        by_points = from == origin%spline .or. from == origin%bezier .or. from == origin%fair
    end function by_points

    !> Takes a LINE card and opens its view for data cards.
    pure subroutine take_line(state, card, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(control_line_type) :: fresh
        type(view_type) :: given
        integer :: line, which

        given%card = card
        given%is_sound = .true.
        given%origin = origin%pieces
        if (looks_like_number(field_text(card, 4))) then
            given%origin = origin%constant
            given%constant = decimal_in(card, 4)
        else if (field_text(card, 4) == 'SPLINE') then
            given%origin = origin%spline
        else if (field_text(card, 4) == 'BEZIER') then
            given%origin = origin%bezier
        else if (field_text(card, 4) == 'FAIR') then
            given%origin = origin%fair
        else if (is_filled(card, 4)) then
            given%origin = origin%line
        end if
        call take_parameter(given, faults)
        line = find_line(state, field_text(card, 2))
        if (line == 0) then
            fresh%name = text_of(field_text(card, 2))
            call append(state%body%line, state%lines, fresh)
            line = state%lines
        end if
        if (has_option(card, body_card%line, 'CHINE')) state%body%line(line)%chine = card
        which = view_named(field_text(card, 3))
        associate (target_view => state%body%line(line)%view(which))
            if (target_view%origin /= origin%none) then
                call blame(card, 2, field_text(card, 2)//' has its '//field_text(card, 3)// &
                    ' already; all data cards of a view follow one LINE card', faults)
                call refuse_line(state)
                state%open%origin = given%origin
                return
            end if
            target_view = given
        end associate
        state%open = open_line_type(is_open=.true., line=line, view=which, origin=given%origin)
    end subroutine take_line

    !> Takes field 5 of a LINE card: the parameter of a spline, the weight of a faired line.
    pure subroutine take_parameter(given, faults)
        type(view_type), intent(inout) :: given         !! with its card and origin
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(word_length), parameter :: words(2) = [character(word_length) :: &
            'CHORD', 'UNIFORM']
        character(:), allocatable :: text
        integer :: before

        before = faults%count
        text = field_text(given%card, 5)
        given%weight = usual_weight
        given%is_uniform = text == 'UNIFORM'
        if (text == '') return
        if (given%origin == origin%fair) then
            given%weight = decimal_in(given%card, 5)
            if (.not. looks_like_number(text)) then
                call blame(given%card, 5, 'the weight of a FAIR line is a number', faults)
            else if (to_real(given%weight) <= 0.0_dp) then
                call blame(given%card, 5, 'the weight of a FAIR line is above zero', faults)
            end if
        else if (given%origin /= origin%spline) then
            call warn(given%card, 5, 'PARAM says nothing here: it is for a SPLINE or FAIR', faults)
        else if (all(text /= words)) then
            call blame(given%card, 5, 'PARAM is CHORD or UNIFORM, not '//text// &
                suggestion(text, words), faults)
        end if
        given%is_sound = .not. faults%has_errors(before)
    end subroutine take_parameter

    !> After a LINE card in error its data cards are looked at, but not kept.
    pure subroutine refuse_line(state)
        type(state_type), intent(inout) :: state !! the job so far
        state%open = open_line_type(is_open=.true.)
    end subroutine refuse_line

    !> The view of a name.
    pure integer function view_named(name)
        character(*), intent(in) :: name !! SIDE, PLAN or ANGLE
        view_named = view%side
        if (name == 'PLAN') view_named = view%plan
        if (name == 'ANGLE') view_named = view%angle
    end function view_named

    !> Takes a data card. One in error makes its line unsound.
    pure subroutine take_piece(state, card, kind, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: kind                     !! a data card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong with its fields is in it
        type(piece_type) :: item

        if (by_points(state%open%origin)) then
            if (kind /= body_card%point) call blame(card, 1, &
                'a conic under a LINE by points; a composite line is given by conics alone', faults)
        else if (state%open%line > 0 .and. state%open%origin /= origin%pieces) then
            call blame(card, 1, 'a data card under a LINE that is taken from field 4 of its card', &
                faults)
        end if
        item = piece_of(card, kind)
        if (kind == body_card%point) then
            call take_ending(item, state%open%origin, faults)
        else
            call check_piece(item, state%open%pieces == 0, faults)
            call check_blend(state%open, item, faults)
        end if
        call append(state%open%piece, state%open%pieces, item)
    end subroutine take_piece

    !> The piece on a card.
    pure type(piece_type) function piece_of(card, kind) result(item)
        type(card_type), intent(in) :: card !! a card whose fields are sound
        integer, intent(in) :: kind         !! a data card
        type(body_field_type), allocatable :: field(:)
        integer :: i

        allocate (field, source=fields_of(kind))
        item%kind = kind - body_card%conic + piece%conic
        item%card = card
        item%first_field = field(1)%field
        allocate (item%value(size(field)))
        do i = 1, size(field)
            item%value(i) = decimal_in(card, field(i)%field)
        end do
        item%is_slope_last = has_option(card, kind, 'LAST')
        item%is_knuckle = has_option(card, kind, 'KNUCKLE')
        item%is_match = has_option(card, kind, 'MATCH')
        item%is_inverse = has_option(card, kind, 'DXDY') .or. &
            [has_option(card, kind, 'DXDY1'), has_option(card, kind, 'DXDY3')]
    end function piece_of

    !> Takes what stands behind a point.
    pure subroutine take_ending(item, from, faults)
        type(piece_type), intent(inout) :: item         !! the point
        integer, intent(in) :: from                     !! `origin%spline`, `%bezier` or `%fair`
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (.not. is_filled(item%card, 3)) return
        if (from == origin%fair) then
            item%ending = ending%weight
            if (.not. looks_like_number(field_text(item%card, 3))) then
                call blame(item%card, 3, 'behind a point to be faired stands its weight', &
                    faults)
            else if (piece_real(item, 3) < 0.0_dp) then
                call blame(item%card, 3, 'a weight is zero or above', faults)
            end if
        else if (from == origin%bezier) then
            call blame(item%card, 3, 'a pole has no slope; the curve begins and ends along the '// &
                'sides of its polygon', faults)
        else if (looks_like_number(field_text(item%card, 3))) then
            item%ending = ending%slope
        else if (field_text(item%card, 3) == 'PARABOLA') then
            item%ending = ending%parabola
        else if (field_text(item%card, 3) /= 'FREE') then
            call blame(item%card, 3, 'END is a slope, FREE or PARABOLA', faults)
        end if
    end subroutine take_ending

    !> Looks at a piece as a whole.
    pure subroutine check_piece(item, is_first, faults)
        type(piece_type), intent(in) :: item            !! the piece
        logical, intent(in) :: is_first                 !! no piece is before it
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: last
        real(dp) :: number

        last = item%first_field + size(item%value)
        if (item%is_match .and. item%is_knuckle) call blame(item%card, last, &
            'KNUCKLE and MATCH exclude each other', faults)
        if (item%is_match .and. is_first) call blame(item%card, last, &
            'MATCH on the first card of a line; there is no neighbour before it', faults)
        if (item%is_knuckle .and. is_first) call warn(item%card, last, &
            'KNUCKLE on the first card of a line says nothing: there is no joint before it', faults)
        number = to_real(item%value(size(item%value)))
        if (item%kind == piece%rho .or. item%kind == piece%tangent_rho) then
            if (item%is_match .or. (number > 0.0_dp .and. number < 1.0_dp)) return
            call blame(item%card, last - 1, &
                'rho is above 0 and below 1; below .5 an ellipse, .5 a parabola', faults)
        else if (item%kind == piece%radius .and. is_zero(number)) then
            call blame(item%card, last - 1, 'the radius is zero', faults)
        else if (item%kind == piece%cyclic .and. .not. (number > 0.0_dp .and. number <= 180.0_dp)) &
            then
            call blame(item%card, last - 1, 'ALPHA is above 0 and not above 180 degrees', faults)
        end if
    end subroutine check_piece

    !> Closes the open line: its pieces are given to its view.
    pure subroutine close_line(state, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(open_line_type) :: none

        if (state%open%outline > 0) call close_outline(state, faults)
        if (state%open%line > 0) then
            associate (given => state%body%line(state%open%line)%view(state%open%view), &
                open => state%open)
                if (open%pieces == 0 .and. open%is_sound .and. &
                    (given%origin == origin%pieces .or. by_points(given%origin))) then
                    call blame(given%card, 2, &
                        'a LINE without data; its conics or points follow on data cards, or '// &
                        'field 4 names another line or a constant', faults)
                    open%is_sound = .false.
                end if
                if (given%origin == origin%spline) call check_endings(open, faults)
                if (given%origin == origin%fair) call check_ends(open, faults)
                call check_last_blend(open, faults)
                given%is_sound = given%is_sound .and. open%is_sound
                allocate (given%piece(open%pieces))
                if (open%pieces > 0) given%piece = open%piece(:open%pieces)
            end associate
        end if
        state%open = none
    end subroutine close_line

    !> Blames what is asked at a point of a spline that is no end.
    pure subroutine check_endings(open, faults)
        type(open_line_type), intent(inout) :: open     !! a spline
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i

        do i = 2, open%pieces - 1
            if (.not. is_filled(open%piece(i)%card, 3)) cycle
            call blame(open%piece(i)%card, 3, 'END at a point inside; it is for the first and '// &
                'the last point of a spline', faults)
            open%is_sound = .false.
        end do
    end subroutine check_endings

    !> Warns of weights at the ends of a faired line, which is held there.
    pure subroutine check_ends(open, faults)
        type(open_line_type), intent(in) :: open        !! a faired line
        type(fault_list_type), intent(inout) :: faults  !! warnings are added
        integer :: i

        do i = 1, open%pieces, max(1, open%pieces - 1)
            if (open%piece(i)%ending == ending%weight) call warn(open%piece(i)%card, 3, &
                'a weight at an end of a FAIR line says nothing: the line is held there', faults)
        end do
    end subroutine check_ends

end module deck_job_line
