!> The cards of a deck of printed tables, as data: see `deck_body_layout`.
module deck_audit_layout
    use deck_body_layout, only: body_field_type, body_layout_type, form, need
    implicit none (type, external)
    private

    public :: audit_fields_of

    !> The cards by name: `audit_layout(audit_card%printed)`.
    type, public :: audit_card_list
        integer :: audit = 1, printed = 2, conics = 3, shift = 4, exact = 5, about = 6, &
            between = 7, along = 8, row = 9, end = 10
    end type audit_card_list
    !> Which card is which.
    type(audit_card_list), parameter, public :: audit_card = audit_card_list()

    !> The cards of a deck of printed tables besides TITLE and UNITS.
    type(body_layout_type), parameter, public :: audit_layout(10) = [ &
        body_layout_type('AUDIT', '', '', &
        'a printed table: what of; the cards and figures that follow belong to it'), &
        body_layout_type('PRINTED', '', '', 'how the figures of the table were printed'), &
        body_layout_type('CONICS', '', '', &
        'the line is a chain of conics, joined anywhere; without the card one conic'), &
        body_layout_type('SHIFT', '', '', &
        'added to X and Y before the coefficients A to E were worked; without the card 100.'), &
        body_layout_type('EXACT', '', '', 'numbers known as they were punched'), &
        body_layout_type('ABOUT', '', '', 'numbers known to the decimals they are given with'), &
        body_layout_type('BETWEEN', '', '', 'a number known to lie between two'), &
        body_layout_type('ALONG', '', '', &
        'what the rows that follow are stepped in; without the card X, column 1'), &
        body_layout_type('', '', '', 'rows of the table, in pairs; they have no word'), &
        body_layout_type('END', '', '', 'ends the deck; without it the deck ends with the file')]

    !> What can be known of a line: fields of a conic card, coefficients, steps of the table.
    character(*), parameter, public :: known_words = 'X1 Y1 S1 X2 Y2 X3 Y3 S3 A B C D E XI YI'
    !> What a table can be of, how it can be printed, and how its figures are formed.
    character(*), parameter, public :: view_words = 'SIDE PLAN STATION BUTTOCK WATERLN', &
        printing_words = 'UNKNOWN ROUNDED TRUNCATE 1970 EVEN', form_of_words = 'DECIMAL FIE'

    character(9), parameter :: units = 'deck unit', none = 'none'

    !> The fields of these cards.
    type(body_field_type), parameter :: fields(*) = [ &
        body_field_type(audit_card%audit, 2, 'NAME', form%name, need%always, none, &
        'name of the line or section'), &
        body_field_type(audit_card%audit, 3, 'VIEW', form%word, need%always, none, &
        'Y over X: WL or BL over STA, WL over BL, ...', view_words), &
        body_field_type(audit_card%audit, 4, 'AT', form%number, need%optional, units, &
        'where a STATION, BUTTOCK or WATERLN is'), &
        body_field_type(audit_card%audit, 5, 'LINE1', form%name, need%optional, none, &
        'of a STATION: line of its first points'), &
        body_field_type(audit_card%audit, 6, 'LINE2', form%name, need%optional, none, &
        'of a STATION: line of its shoulder points'), &
        body_field_type(audit_card%audit, 7, 'LINE3', form%name, need%optional, none, &
        'of a STATION: line of its last points'), &
        body_field_type(audit_card%printed, 2, 'HOW', form%word, need%always, none, &
        'without the card UNKNOWN', printing_words), &
        body_field_type(audit_card%printed, 3, 'FORM', form%word, need%optional, none, &
        'FIE: feet-inches-eighths', form_of_words), &
        body_field_type(audit_card%printed, 4, 'N', form%whole, need%optional, none, &
        'decimals of the table; blank: those that most figures have'), &
        body_field_type(audit_card%conics, 2, 'N', form%whole, need%always, none, &
        'how many conics, 1 to 9'), &
        body_field_type(audit_card%shift, 2, 'N', form%number, need%always, units, &
        'the program of 1970 added 100.'), &
        body_field_type(audit_card%exact, 2, 'WHAT', form%word, need%always, none, &
        '', known_words), &
        body_field_type(audit_card%exact, 3, 'FIGURE', form%figure, need%paired, none, &
        'further pairs may follow'), &
        body_field_type(audit_card%about, 2, 'WHAT', form%word, need%always, none, &
        '', known_words), &
        body_field_type(audit_card%about, 3, 'FIGURE', form%figure, need%paired, none, &
        'further pairs may follow'), &
        body_field_type(audit_card%between, 2, 'WHAT', form%word, need%always, none, &
        '', known_words), &
        body_field_type(audit_card%between, 3, 'LOW', form%number, need%always, none, &
        'the least it can be'), &
        body_field_type(audit_card%between, 4, 'HIGH', form%number, need%always, none, &
        'the most it can be'), &
        body_field_type(audit_card%along, 2, 'AXIS', form%word, need%always, none, &
        'X: figures are Y; Y: figures are X', 'X Y'), &
        body_field_type(audit_card%along, 3, 'COLUMN', form%whole, need%optional, none, &
        '1 or 2: a conic is crossed twice'), &
        body_field_type(audit_card%row, 1, 'ALONG', form%number, need%always, units, &
        'X or Y, whichever ALONG says'), &
        body_field_type(audit_card%row, 2, 'FIGURE', form%figure, need%paired, units, &
        'the other, as printed; further pairs may follow')]

contains

    !> The fields of a card behind its word, in order.
    pure function audit_fields_of(card) result(field)
        integer, intent(in) :: card !! one of `audit_card%...`
        type(body_field_type), allocatable :: field(:)
        allocate (field, source=pack(fields, fields%card == card))
    end function audit_fields_of

end module deck_audit_layout
