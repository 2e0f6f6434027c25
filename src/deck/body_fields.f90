!> The fields of any card of a body deck, out of the tables.
module deck_body_fields
    use deck_body_cut_fields, only: check_fields, cut_fields
    use deck_body_data_fields, only: data_fields
    use deck_body_layout, only: body_field_type, form
    use deck_body_line_fields, only: line_fields, setting_fields
    use deck_body_sweep_fields, only: sweep_fields
    implicit none (type, external)
    private

    public :: fields_of, form_words

    !> Every field of every card.
    type(body_field_type), parameter :: all_fields(*) = &
        [setting_fields, line_fields, data_fields, cut_fields, check_fields, sweep_fields]

contains

    !> The fields of a card behind its word, in order.
    pure function fields_of(card) result(field)
        integer, intent(in) :: card !! one of `body_card%...`
        type(body_field_type), allocatable :: field(:)
        allocate (field, source=pack(all_fields, all_fields%card == card))
    end function fields_of

    !> What a field holds, in words.
    pure function form_words(field) result(words)
        type(body_field_type), intent(in) :: field !! the field
        character(8) :: words

        select case (field%form)
        case (form%number)
            words = 'number'
        case (form%whole)
            words = 'whole'
        case (form%name)
            words = 'name'
        case (form%either)
            words = 'no./name'
        case (form%figure)
            words = 'figure'
        case default
            words = 'word'
        end select
    end function form_words

end module deck_body_fields
