!> Fields of the cards of a design sweep: SWEEP, VARY, OBJECT, and LIMIT of a measure.
module deck_body_sweep_fields
    use deck_body_layout, only: body_field_type, card => body_card, form, measure_words, need
    implicit none (type, external)
    private

    !> Where a measure is taken, alike on OBJECT and LIMIT.
    character(*), parameter :: of_words = 'station; of CLEAR a component, of JUMP, BREAK a line', &
        at_words = 'of WIDTH the waterline, of HEIGHT the butt line', &
        name_words = 'name of its column; without it the word of the measure'

    !> All of them.
    type(body_field_type), parameter, public :: sweep_fields(29) = [ &
        body_field_type(card%vary, 2, 'FIELD', form%either, need%always, 'none', &
        'field of the card before: its name, or which it is'), &
        body_field_type(card%vary, 3, 'NAME', form%name, need%always, 'none', &
        'name of the variable'), &
        body_field_type(card%vary, 4, 'FROM', form%number, need%always, 'as FIELD', &
        'least value'), &
        body_field_type(card%vary, 5, 'TO', form%number, need%always, 'as FIELD', &
        'greatest value'), &
        body_field_type(card%vary, 6, 'COUNT', form%whole, need%optional, 'none', &
        'values, both ends included; not needed with SWEEP LATIN'), &
        body_field_type(card%vary_list, 2, 'LIST', form%word, need%always, 'none', '', 'LIST'), &
        body_field_type(card%vary_list, 3, 'FIELD', form%either, need%always, 'none', &
        'field of the card before: its name, or which it is'), &
        body_field_type(card%vary_list, 4, 'NAME', form%name, need%always, 'none', &
        'name of the variable'), &
        body_field_type(card%vary_list, 5, 'VALUE', form%number, need%repeated, 'as FIELD', &
        'the values, in this field and all that follow'), &
        body_field_type(card%vary_tied, 2, 'TIED', form%word, need%always, 'none', '', 'TIED'), &
        body_field_type(card%vary_tied, 3, 'FIELD', form%either, need%always, 'none', &
        'field of the card before: its name, or which it is'), &
        body_field_type(card%vary_tied, 4, 'NAME', form%name, need%always, 'none', &
        'variable of a VARY card before'), &
        body_field_type(card%vary_tied, 5, 'FACTOR', form%number, need%optional, 'none', &
        'the field holds FACTOR times the variable; blank: 1.'), &
        body_field_type(card%vary_tied, 6, 'ADD', form%number, need%optional, 'as FIELD', &
        'and this added; blank: 0.'), &
        body_field_type(card%sweep, 2, 'METHOD', form%word, need%always, 'none', &
        'all with all, a Latin hypercube, or k-th with k-th', 'GRID LATIN LIST'), &
        body_field_type(card%sweep, 3, 'COUNT', form%whole, need%optional, 'none', &
        'of LATIN: how many variants'), &
        body_field_type(card%sweep, 4, 'SEED', form%whole, need%optional, 'none', &
        'of LATIN: another seed, other variants; blank: 1'), &
        body_field_type(card%object, 2, 'WHAT', form%word, need%always, 'none', '', &
        measure_words), &
        body_field_type(card%object, 3, 'GOAL', form%word, need%always, 'none', &
        'SHOW: no aim, only a column', 'MIN MAX NEAR SHOW'), &
        body_field_type(card%object, 4, 'VALUE', form%number, need%optional, 'its own', &
        'of NEAR'), &
        body_field_type(card%object, 5, 'OF', form%either, need%optional, 'none', of_words), &
        body_field_type(card%object, 6, 'AT', form%number, need%optional, 'deck unit', at_words), &
        body_field_type(card%object, 7, 'NAME', form%name, need%optional, 'none', name_words), &
        body_field_type(card%limit_measure, 2, 'WHAT', form%word, need%always, 'none', '', &
        measure_words), &
        body_field_type(card%limit_measure, 3, 'FROM', form%number, need%optional, 'its own', &
        'least value; blank: not limited there'), &
        body_field_type(card%limit_measure, 4, 'TO', form%number, need%optional, 'its own', &
        'greatest value; blank: not limited there'), &
        body_field_type(card%limit_measure, 5, 'OF', form%either, need%optional, 'none', &
        of_words), &
        body_field_type(card%limit_measure, 6, 'AT', form%number, need%optional, 'deck unit', &
        at_words), &
        body_field_type(card%limit_measure, 7, 'NAME', form%name, need%optional, 'none', &
        name_words)]

end module deck_body_sweep_fields
