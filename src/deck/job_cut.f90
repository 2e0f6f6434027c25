!> The cuts and the components that must keep clear: STATION, BUTTOCK, WATERLN, OBLIQUE, PLANE and
!> CHECK.
module deck_job_cut
    use base_constants, only: largest_table
    use base_exact, only: is_equal, is_zero
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use deck_body_card, only: blame, blame_span, card_type, field_count, field_text
    use deck_body_layout, only: body_card
    use deck_body_value, only: decimal_in, is_filled, real_in
    use deck_job, only: axis, check, check_type, cut, cut_real, cut_type, point_rule_type, &
        range_type, rule
    use deck_job_state, only: standing_type, text_of
    implicit none (type, external)
    private

    public :: cut_of_card, check_of_card

    !> Where FROM, TO and STEP stand on the cards that have them.
    type :: range_field_type
        integer :: from = 0     !! field of the first ordinate
        integer :: to = 0       !! field of the last
        integer :: step = 0     !! field of the step
    end type range_field_type

contains

    !> The cut on a card.
    pure subroutine cut_of_card(card, kind, standing, item, faults)
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        integer, intent(in) :: kind                     !! a card that asks for a cut
        type(standing_type), intent(in) :: standing     !! what holds for it
        type(cut_type), intent(out) :: item             !! the cut
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        item%card = card
        item%limit = standing%limit
        item%is_flange_forward = standing%is_flange_forward
        item%skin = standing%skin
        item%arcs = standing%arcs
        select case (kind)
        case (body_card%station, body_card%stations)
            call take_stations(item, kind == body_card%stations, faults)
        case (body_card%buttock, body_card%waterline)
            item%kind = merge(cut%buttock, cut%waterline, kind == body_card%buttock)
            call take_numbers(item, 1, 6)
        case (body_card%oblique)
            item%kind = cut%oblique
            call take_numbers(item, 4, 7)
        case (body_card%plane)
            item%kind = cut%plane
            call take_numbers(item, 6, 11)
            if (all(is_zero(cut_real(item, [4, 5, 6])))) call blame_span(card, 5, 7, &
                'the normal is zero; it needs a direction', faults)
        end select
        call take_rule(item, standing)
        if (item%kind == cut%oblique) then
            call take_oblique(item, faults)
        else if (item%kind /= cut%station) then
            call take_range(item, merge(range_field_type(8, 9, 10), range_field_type(3, 4, 5), &
                item%kind == cut%plane), faults)
        end if
        call settle_start(item)
    end subroutine cut_of_card

    !> Takes the rule of a POINTS card, unless it steps what does not vary in the plane. A limit of
    !> what does not vary is none.
    pure subroutine take_rule(item, standing)
        type(cut_type), intent(inout) :: item           !! the cut, with its numbers
        type(standing_type), intent(in) :: standing     !! what holds for it
        integer :: fixed

        fixed = fixed_axis(item)
        if (fixed > 0) item%limit(fixed) = range_type()
        item%points%kind = merge(rule%number, 0, &
            item%kind == cut%station .or. item%kind == cut%plane)
        if (.not. standing%has_points) return
        if (standing%points%kind == rule%step .and. standing%points%axis == fixed) return
        item%points = standing%points
    end subroutine take_rule

    !> The axis along which no point of the plane differs from another; 0: there is none.
    pure integer function fixed_axis(item) result(fixed)
        type(cut_type), intent(in) :: item  !! the cut, with its numbers
        logical :: is_zero_normal(3)

        select case (item%kind)
        case (cut%station)
            fixed = axis%sta
        case (cut%buttock)
            fixed = axis%bl
        case (cut%waterline)
            fixed = axis%wl
        case (cut%oblique)
            fixed = merge(axis%sta, 0, is_equal(cut_real(item, 1), cut_real(item, 3)))
            if (is_equal(cut_real(item, 2), cut_real(item, 4))) fixed = axis%wl
        case default
            is_zero_normal = is_zero(cut_real(item, [4, 5, 6]))
            fixed = 0
            if (count(is_zero_normal) == 2) fixed = findloc(is_zero_normal, .false., 1)
        end select
    end function fixed_axis

    !> Takes the numbers of a cut from field 2 on, and its name.
    pure subroutine take_numbers(item, count, name_field)
        type(cut_type), intent(inout) :: item   !! the cut, with its card
        integer, intent(in) :: count            !! how many numbers
        integer, intent(in) :: name_field       !! field of the name
        integer :: i

        allocate (item%value(count))
        do i = 1, count
            item%value(i) = decimal_in(item%card, i + 1)
        end do
        item%name = text_of(field_text(item%card, name_field))
    end subroutine take_numbers

    !> Takes one station, a range of them or a list. A step of the frames is none of the points.
    pure subroutine take_stations(item, is_list, faults)
        type(cut_type), intent(inout) :: item           !! the cut, with its card
        logical, intent(in) :: is_list                  !! the stations are listed
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(range_field_type), parameter :: field = range_field_type(2, 3, 4)
        integer :: i, count

        item%kind = cut%station
        associate (card => item%card)
            if (is_list) then
                count = 0
                allocate (item%value(field_count(card)))
                do i = 3, field_count(card)
                    if (.not. is_filled(card, i)) cycle
                    count = count + 1
                    item%value(count) = decimal_in(card, i)
                end do
                item%value = item%value(:count)
                return
            end if
            item%is_stepped = is_filled(card, field%to) .and. is_filled(card, field%step)
            if (is_filled(card, field%to) .neqv. is_filled(card, field%step)) call blame(card, &
                merge(field%step, field%to, is_filled(card, field%to)), &
                'a range of stations has FROM, TO and STEP; one station alone has FROM only, '// &
                'some have STATION LIST', faults)
            call take_numbers(item, merge(3, 1, item%is_stepped), 5)
            if (item%is_stepped) call check_step(item, field, faults)
        end associate
    end subroutine take_stations

    !> Takes FROM, TO and STEP of a cut along the body.
    pure subroutine take_range(item, field, faults)
        type(cut_type), intent(inout) :: item           !! the cut, with its numbers
        type(range_field_type), intent(in) :: field     !! where they stand
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        associate (card => item%card, limit => item%limit(axis%sta))
            if (is_filled(card, field%from) .or. is_filled(card, field%to)) limit = range_type( &
                is_filled(card, field%from), is_filled(card, field%to), &
                decimal_in(card, field%from), decimal_in(card, field%to))
        end associate
        call take_step(item, field, faults)
    end subroutine take_range

    !> Takes the limits of an OBLIQUE card, which are its two points, and its step.
    pure subroutine take_oblique(item, faults)
        type(cut_type), intent(inout) :: item           !! the cut, with its numbers
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (all(is_equal(cut_real(item, [1, 2]), cut_real(item, [3, 4])))) then
            call blame_span(item%card, 2, 5, 'the two points of the plane coincide', faults)
        else if (fixed_axis(item) == axis%sta) then
            item%limit(axis%wl) = range_type(.true., .true., item%value(2), item%value(4))
            call take_step(item, range_field_type(step=6), faults)
        else
            item%limit(axis%sta) = range_type(.true., .true., item%value(1), item%value(3))
            call take_step(item, range_field_type(2, 4, 6), faults)
        end if
    end subroutine take_oblique

    !> Takes the step of STA on a card; where there is none, a POINTS card must have said more.
    pure subroutine take_step(item, field, faults)
        type(cut_type), intent(inout) :: item           !! the cut, with its numbers
        type(range_field_type), intent(in) :: field     !! where FROM, TO and STEP stand
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (is_filled(item%card, field%step)) then
            item%points = point_rule_type(kind=rule%step, axis=axis%sta, &
                step=decimal_in(item%card, field%step))
            if (fixed_axis(item) == axis%sta) then
                call blame(item%card, field%step, &
                    'a step of STA in a plane at one station; leave it blank, put a POINTS '// &
                    'card before, or use STATION', faults)
            else
                call check_step(item, field, faults)
            end if
        else if (item%points%kind == 0) then
            call blame(item%card, field%step, &
                'STEP is missing, and no POINTS card before says how the points of such a cut '// &
                'are spread, as POINTS NUMBER 25 does', faults)
        end if
    end subroutine take_step

    !> Steps begin where the cut is limited to begin, else they are whole multiples of the step.
    pure subroutine settle_start(item)
        type(cut_type), intent(inout) :: item   !! the cut
        associate (limit => item%limit(item%points%axis))
            if (item%points%kind == rule%step .and. limit%has_from) item%points%start = limit%from
        end associate
    end subroutine settle_start

    !> A step must be able to go from the first ordinate to the last.
    pure subroutine check_step(item, field, faults)
        type(cut_type), intent(in) :: item              !! the cut, with its card
        type(range_field_type), intent(in) :: field     !! FROM, which may be blank, TO and STEP
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        real(dp) :: way, step

        associate (card => item%card)
            step = real_in(card, field%step)
            way = real_in(card, field%to) - real_in(card, field%from)
            if (is_zero(step)) then
                call blame(card, field%step, 'STEP is zero', faults)
            else if (.not. is_filled(card, field%from)) then
                call blame(card, field%from, 'FROM is missing; the steps begin there', faults)
            else if (.not. is_filled(card, field%to) .or. is_zero(way)) then
                return
            else if ((way > 0.0_dp) .neqv. (step > 0.0_dp)) then
                call blame(card, field%step, 'STEP has the wrong sign; from '// &
                    compact(real_in(card, field%from))//' to '//compact(real_in(card, field%to))// &
                    ' it is '//merge('positive', 'negative', way > 0.0_dp), faults)
            else if (abs(way) > abs(step)*real(largest_table, dp)) then
                call blame(card, field%step, 'more than '//to_text(largest_table)// &
                    ' steps; a larger STEP is right', faults)
            end if
        end associate
    end subroutine check_step

    !> The component on a CHECK card.
    pure subroutine check_of_card(card, kind, standing, item, faults)
        type(card_type), intent(in) :: card             !! a card whose fields are sound
        integer, intent(in) :: kind                     !! a CHECK card
        type(standing_type), intent(in) :: standing     !! what holds for it
        type(check_type), intent(out) :: item           !! the component
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: count, i

        item%kind = kind - body_card%check_point + check%point
        item%card = card
        item%skin = standing%skin
        count = merge(3, merge(4, 6, item%kind == check%sphere), item%kind == check%point)
        allocate (item%value(count))
        do i = 1, count
            item%value(i) = decimal_in(card, i + 2)
        end do
        item%clearance = decimal_in(card, count + 3)
        item%name = text_of(field_text(card, count + 4))
        if (real_in(card, count + 3) < 0.0_dp) call blame(card, count + 3, &
            'the clearance is negative', faults)
        if (item%kind == check%sphere .and. real_in(card, 6) <= 0.0_dp) call blame(card, 6, &
            'the radius of a sphere is above zero; a POINT has none', faults)
    end subroutine check_of_card

end module deck_job_cut
