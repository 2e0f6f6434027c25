!> Fields of the cards of a body deck that say what the body is: settings, lines and their data
!> cards, sections.
module deck_body_line_fields
    use deck_body_layout, only: body_field_type, card => body_card, form, need
    implicit none (type, external)
    private

    !> Cards that hold for the whole deck or body.
    type(body_field_type), parameter, public :: setting_fields(8) = [ &
        body_field_type(card%output, 2, 'UNIT', form%word, need%always, 'none', &
        'FIE: feet-inches-eighths; without the card the unit of the deck', 'INCHES MM FEET FIE'), &
        body_field_type(card%digits, 2, 'N', form%whole, need%always, 'none', &
        'decimals, 0 to 9; without the card 3'), &
        body_field_type(card%page, 2, 'COLS', form%whole, need%always, 'none', &
        'columns of a page, 80 or 132; without the card 80'), &
        body_field_type(card%page, 3, 'LINES', form%whole, need%always, 'none', &
        'lines of a page, 20 to 999; without the card 60'), &
        body_field_type(card%symmetry, 2, 'ANSWER', form%word, need%always, 'none', &
        'without the card YES', 'YES NO'), &
        body_field_type(card%toler, 2, 'T', form%number, need%always, 'deck unit', &
        'not negative; without the card .001 inches, .025 mm, .0001 feet'), &
        body_field_type(card%body, 2, 'NAME', form%name, need%always, 'none', &
        'name of the body'), &
        body_field_type(card%nose, 2, 'R', form%number, need%always, 'deck unit', &
        'radius of the nose, above zero')]

    !> LINE, SECTION, PATCH and FAIRED.
    type(body_field_type), parameter, public :: line_fields(29) = [ &
        body_field_type(card%line, 2, 'NAME', form%name, need%always, 'none', &
        'name of the line'), &
        body_field_type(card%line, 3, 'VIEW', form%word, need%always, 'none', &
        'WL over STA, BL over STA, or degrees over STA', 'SIDE PLAN ANGLE'), &
        body_field_type(card%line, 4, 'FROM', form%either, need%optional, 'none', &
        'line to take over, or a constant; SPLINE, BEZIER, FAIR: points'), &
        body_field_type(card%line, 5, 'PARAM', form%either, need%optional, 'none', &
        'of a SPLINE: CHORD, UNIFORM; else CHORD. FAIR: weight; else 10'), &
        body_field_type(card%section, 2, 'NAME', form%name, need%always, 'none', &
        'name of the section'), &
        body_field_type(card%section, 3, 'LINE1', form%name, need%always, 'none', &
        'line where the conic starts'), &
        body_field_type(card%section, 4, 'SHLDR', form%name, need%always, 'none', &
        'line of its shoulder points'), &
        body_field_type(card%section, 5, 'LINE3', form%name, need%always, 'none', &
        'line where the conic ends'), &
        body_field_type(card%section, 6, 'S1', form%either, need%always, 'dWL/dBL', &
        'end slope at LINE1, 999.999 if vertical; or an ANGLE line'), &
        body_field_type(card%section, 7, 'S3', form%either, need%always, 'dWL/dBL', &
        'end slope at LINE3, 999.999 if vertical; or an ANGLE line'), &
        body_field_type(card%section, 8, 'FROM', form%number, need%optional, 'deck unit', &
        'first station it is limited to'), &
        body_field_type(card%section, 9, 'TO', form%number, need%optional, 'deck unit', &
        'last station it is limited to'), &
        body_field_type(card%section, 10, 'SIDE', form%word, need%optional, 'none', &
        'with SYMMETRY NO: PORT mirrors it, BOTH does both', 'STBD PORT BOTH'), &
        body_field_type(card%patch, 2, 'NAME', form%name, need%always, 'none', &
        'name of the patch'), &
        body_field_type(card%patch, 3, 'SIDE1', form%either, need%always, 'deck unit', &
        'a line, a cut''s name; or a station: the arc of a section there'), &
        body_field_type(card%patch, 4, 'SIDE2', form%either, need%always, 'deck unit', &
        'as SIDE1; POINT: the side is where the sides beside it meet'), &
        body_field_type(card%patch, 5, 'SIDE3', form%either, need%always, 'deck unit', &
        'as SIDE2'), &
        body_field_type(card%patch, 6, 'SIDE4', form%either, need%always, 'deck unit', &
        'as SIDE2'), &
        body_field_type(card%patch, 7, 'BLEND', form%word, need%optional, 'none', &
        'twists: Adini''s, none, of the linear blend; else TWIST', 'TWIST FLAT LINEAR'), &
        body_field_type(card%patch, 8, 'FROM', form%number, need%optional, 'deck unit', &
        'first station where its sides may meet'), &
        body_field_type(card%patch, 9, 'TO', form%number, need%optional, 'deck unit', &
        'last station where its sides may meet'), &
        body_field_type(card%faired, 2, 'NAME', form%name, need%always, 'none', &
        'name of the outline'), &
        body_field_type(card%faired, 3, 'STA', form%number, need%always, 'deck unit', &
        'its station'), &
        body_field_type(card%faired, 4, 'WEIGHT', form%number, need%optional, 'none', &
        'of its points: the more, the nearer; without it 10'), &
        body_field_type(card%faired, 5, 'BETA', form%number, need%optional, 'none', &
        'share of the 2nd derivative in its energy, 0 to 1; else .5'), &
        body_field_type(card%faired, 6, 'AREA', form%number, need%optional, 'unit**2', &
        'area it encloses; without it as it comes'), &
        body_field_type(card%duct, 2, 'NAME', form%name, need%always, 'none', &
        'name of the duct'), &
        body_field_type(card%duct, 3, 'FROM', form%name, need%always, 'none', &
        'the foremost FAIRED outline, given on a card before'), &
        body_field_type(card%duct, 4, 'NEXT', form%name, need%repeated, 'none', &
        'the next one aft, in this field and all that follow')]

end module deck_body_line_fields
