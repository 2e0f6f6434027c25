!> PATCH.
module deck_job_patch
    use base_fault, only: fault_list_type
    use base_text, only: to_text
    use deck_body_card, only: blame, card_type, field_text
    use deck_body_check, only: has_option
    use deck_body_layout, only: body_card
    use deck_body_value, only: decimal_in, is_filled, looks_like_number, real_in
    use deck_body_word, only: suggestion
    use deck_job, only: bound, bound_type, cut, name_length, origin, patch_type, range_type, &
        twist, view
    use deck_job_list, only: append
    use deck_job_name, only: check_name
    use deck_job_state, only: find_line, line_names, state_type, text_of
    implicit none (type, external)
    private

    public :: take_patch

    !> The field of the first side.
    integer, parameter :: first_side = 3

contains

    !> Takes a PATCH card. Its lines and cuts stand on cards before it.
    pure subroutine take_patch(state, card, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(patch_type) :: item
        integer :: i, before

        before = faults%count
        item%name = text_of(field_text(card, 2))
        item%card = card
        call check_name(state, card, faults)
        do i = 1, 4
            call take_side(state, card, first_side - 1 + i, item%side(i), faults)
            item%side(i)%is_tangent = has_option(card, body_card%patch, 'TANGENT'//to_text(i))
        end do
        if (field_text(card, 7) == 'FLAT') item%twist = twist%none
        if (field_text(card, 7) == 'LINEAR') item%twist = twist%linear
        item%range = range_type(is_filled(card, 8), is_filled(card, 9), decimal_in(card, 8), &
            decimal_in(card, 9))
        if (item%range%has_from .and. item%range%has_to .and. &
            real_in(card, 8) >= real_in(card, 9)) call blame(card, 9, 'TO is not aft of FROM', &
            faults)
        if (.not. faults%has_errors(before)) call check_sides(item, faults)
        if (.not. faults%has_errors(before)) call append(state%body%patch, state%patches, item)
    end subroutine take_patch

    !> Reads a side: a station, the word POINT, a line with a SIDE view, or else a cut by its name.
    pure subroutine take_side(state, card, field, side, faults)
        type(state_type), intent(in) :: state           !! the job so far
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: field                    !! where the side stands
        type(bound_type), intent(inout) :: side         !! what it is
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (looks_like_number(field_text(card, field))) then
            side%kind = bound%station
            side%station = decimal_in(card, field)
        else if (field_text(card, field) == 'POINT') then
            side%kind = bound%point
        else
            side%kind = bound%line
            side%line = find_line(state, field_text(card, field))
            if (side%line == 0) then
                call take_cut(state, card, field, side, faults)
            else if (state%body%line(side%line)%view(view%side)%origin == origin%none) then
                call blame(card, field, 'LINE '//field_text(card, field)//' has no SIDE', faults)
            end if
        end if
    end subroutine take_side

    !> Takes a side that is a cut of the open body; of a STATION card it is that station.
    pure subroutine take_cut(state, card, field, side, faults)
        type(state_type), intent(in) :: state           !! the job so far
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: field                    !! where the name stands
        type(bound_type), intent(inout) :: side         !! what it is
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(name_length) :: names(state%cuts)
        character(:), allocatable :: name
        integer :: i

        name = field_text(card, field)
        names = [(state%body%cut(i)%name, i = 1, state%cuts)]
        if (count(names == name) == 0) then
            call blame(card, field, 'there is no LINE '//name//', and no cut of that name, on '// &
                'the cards before'//suggestion(name, [text_of('POINT'), line_names(state), &
                names]), faults)
            return
        else if (count(names == name) > 1) then
            call blame(card, field, 'several cuts are named '//name//'; give each its own name', &
                faults)
            return
        end if
        side%cut = findloc(names, text_of(name), dim=1)
        side%kind = bound%cut
        associate (found => state%body%cut(side%cut))
            if (found%kind /= cut%station) return
            if (size(found%value) > 1) call blame(card, field, 'cut '//name//' has several '// &
                'stations; a side is at one', faults)
            side%kind = bound%station
            side%station = found%value(1)
        end associate
    end subroutine take_cut

    !> A patch has at most one point for a side; it and stations stand between lines or cuts. What
    !> is TANGENT has skin beside it, and slopes across its sides.
    pure subroutine check_sides(item, faults)
        type(patch_type), intent(in) :: item            !! with its sides
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i, next

        do i = 1, 4
            next = 1 + mod(i, 4)
            if (.not. (is_long(item%side(i)) .or. is_long(item%side(next)))) then
                call blame(item%card, first_side - 1 + next, 'sides '//to_text(i)//' and '// &
                    to_text(next)//' are both no lines; a station or a POINT stands between '// &
                    'two lines or cuts', faults)
                return
            end if
            if (item%side(i)%is_tangent .and. item%side(i)%kind == bound%point) call blame( &
                item%card, first_side - 1 + i, 'TANGENT'//to_text(i)//' of a side that is a '// &
                'POINT; it has no skin beside it', faults)
            if (item%side(i)%is_tangent .and. item%twist == twist%linear) call blame(item%card, &
                7, 'LINEAR has no slopes across its sides; TANGENT'//to_text(i)//' takes TWIST '// &
                'or FLAT', faults)
        end do
        if (count(item%side%kind == bound%point) > 1) call blame(item%card, first_side, &
            'a patch has one POINT for a side at most', faults)
        do i = 1, 4
            next = 1 + mod(i, 4)
            if (item%side(i)%kind /= item%side(next)%kind) cycle
            if (item%side(i)%line /= item%side(next)%line) cycle
            if (item%side(i)%cut /= item%side(next)%cut) cycle
            call blame(item%card, first_side - 1 + next, 'a '// &
                trim(merge('line', 'cut ', item%side(i)%kind == bound%line))// &
                ' twice in a row', faults)
        end do
    end subroutine check_sides

    !> True for a side that may stand beside any other: a line or a cut along the body.
    pure logical function is_long(side)
        type(bound_type), intent(in) :: side !! of a patch
        is_long = side%kind == bound%line .or. side%kind == bound%cut
    end function is_long

end module deck_job_patch
