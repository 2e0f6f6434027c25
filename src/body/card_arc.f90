!> From a conic card to its arc: the place where cards and geometry meet. What geometry finds wrong
!> is said of the card's columns.
module body_card_arc
    use base_error, only: cause, error_type
    use base_fault, only: fault_list_type, new_fault, severity
    use deck_conic_card, only: conic_card_type
    use deck_layout, only: conic, conic_fields
    use geom_arc, only: arc_through, arc_type, direction_of_slope, end_type, turns_past_180
    implicit none (type, external)
    private

    public :: arc_of_card

contains

    !> The arc of a sound card. Where there is none, `has_arc` is false and the fault says why; an
    !> arc that turns by more than 180 degrees is warned of.
    subroutine arc_of_card(card, arc, has_arc, faults)
        type(conic_card_type), intent(in) :: card       !! a readable card
        type(arc_type), intent(out) :: arc              !! its arc, where there is one
        logical, intent(out) :: has_arc                 !! the points and slopes have an arc
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(error_type), allocatable :: error
        type(end_type) :: start, finish
        integer :: before

        before = faults%count
        start = end_type(card%real([conic%x1, conic%y1]), direction_of_slope(card%real(conic%s1)))
        finish = end_type(card%real([conic%x3, conic%y3]), direction_of_slope(card%real(conic%s3)))
        call arc_through(start, card%real([conic%x2, conic%y2]), finish, arc, error)
        has_arc = .not. allocated(error)
        if (has_arc) then
            if (turns_past_180(arc)) call add_fault(severity%warning, conic%x2, conic%y2, &
                'the arc turns by more than 180 degrees: the shoulder point and the '// &
                'intersection of the end tangents are on different sides of the chord', faults)
        else
            call blame_fields(error, faults)
        end if
        call faults%place(before, card%line, card%image)
    end subroutine arc_of_card

    !> Puts the failure of an arc on the columns that cause it.
    subroutine blame_fields(error, faults)
        type(error_type), intent(in) :: error           !! from `arc_through`
        type(fault_list_type), intent(inout) :: faults  !! gets the fault

        select case (error%cause)
        case (cause%inflection, cause%tangent_on_chord)
            call add_fault(severity%error, conic%s1, conic%s3, error%message, faults)
        case (cause%points_coincide)
            call add_fault(severity%error, conic%x1, conic%y3, error%message, faults)
        case default
            call add_fault(severity%error, conic%x2, conic%y2, error%message, faults)
        end select
    end subroutine blame_fields

    !> Adds a fault that spans from one field to another.
    subroutine add_fault(grade, first, last, message, faults)
        integer, intent(in) :: grade                    !! one of `severity%...`
        integer, intent(in) :: first                    !! field where it begins
        integer, intent(in) :: last                     !! field where it ends
        character(*), intent(in) :: message             !! what is wrong
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        call faults%add(new_fault(grade, conic_fields(first)%first, conic_fields(last)%last, &
            message))
    end subroutine add_fault

end module body_card_arc
