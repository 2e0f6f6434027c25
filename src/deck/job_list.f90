!> Lists of a job that grow while its deck is read: twice as long whenever they are full, cut to
!> their length in the end.
module deck_job_list
    use deck_body_card, only: card_type
    use deck_duct, only: duct_type
    use deck_job, only: body_type, check_type, control_line_type, cut_type, outline_type, &
        patch_type, piece_type, section_type
    use deck_sweep, only: target_type, variable_type, wanted_type
    implicit none (type, external)
    private

    public :: append

    !> Room of a list that begins.
    integer, parameter :: first_room = 8

    !> Puts an item at the end of a list that holds `count` of them.
    interface append
        module procedure append_body, append_line, append_piece, append_section, append_cut, &
            append_check, append_outline, append_patch, append_duct, append_variable, &
            append_target, append_wanted, append_card
    end interface append

contains

    !> Adds a body.
    pure subroutine append_body(list, count, item)
        type(body_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(body_type), intent(in) :: item !! what to add
        type(body_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_body

    !> Adds a control line.
    pure subroutine append_line(list, count, item)
        type(control_line_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(control_line_type), intent(in) :: item !! what to add
        type(control_line_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_line

    !> Adds a piece of a line.
    pure subroutine append_piece(list, count, item)
        type(piece_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(piece_type), intent(in) :: item !! what to add
        type(piece_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_piece

    !> Adds a section.
    pure subroutine append_section(list, count, item)
        type(section_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(section_type), intent(in) :: item !! what to add
        type(section_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_section

    !> Adds a faired outline.
    pure subroutine append_outline(list, count, item)
        type(outline_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(outline_type), intent(in) :: item !! what to add
        type(outline_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_outline

    !> Adds a cut.
    pure subroutine append_cut(list, count, item)
        type(cut_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(cut_type), intent(in) :: item !! what to add
        type(cut_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_cut

    !> Adds a patch.
    pure subroutine append_patch(list, count, item)
        type(patch_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(patch_type), intent(in) :: item !! what to add
        type(patch_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_patch

    !> Adds a duct.
    pure subroutine append_duct(list, count, item)
        type(duct_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(duct_type), intent(in) :: item !! what to add
        type(duct_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_duct

    !> Adds a component.
    pure subroutine append_check(list, count, item)
        type(check_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(check_type), intent(in) :: item !! what to add
        type(check_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_check

    !> Adds a variable of a sweep.
    pure subroutine append_variable(list, count, item)
        type(variable_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(variable_type), intent(in) :: item !! what to add
        type(variable_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_variable

    !> Adds a field that varies.
    pure subroutine append_target(list, count, item)
        type(target_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(target_type), intent(in) :: item !! what to add
        type(target_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_target

    !> Adds a measure that is looked at.
    pure subroutine append_wanted(list, count, item)
        type(wanted_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(wanted_type), intent(in) :: item !! what to add
        type(wanted_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_wanted

    !> Adds a card.
    pure subroutine append_card(list, count, item)
        type(card_type), allocatable, intent(inout) :: list(:) !! the list
        integer, intent(inout) :: count !! items in it
        type(card_type), intent(in) :: item !! what to add
        type(card_type), allocatable :: grown(:)

        if (.not. allocated(list)) allocate (list(first_room))
        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = item
    end subroutine append_card

end module deck_job_list
