!> The cards of a body deck, as data: which words begin a card, what stands in its fields. Reading,
!> carets under a fault and the printed card reference all come from here, from `deck_body_fields`
!> and from the tables of fields it gathers.
module deck_body_layout
    implicit none (type, external)
    private

    public :: body_field_type, body_layout_type, option_type

    !> How a field is read.
    type, public :: form_list
        character :: number = 'F'   !! a decimal number
        character :: whole = 'I'    !! a whole number
        character :: name = 'A'     !! a name: a letter, then letters, figures and - _ . /
        character :: word = 'W'     !! one of some words
        character :: either = 'E'   !! a decimal number or a name
        character :: figure = 'P'   !! a figure as it is printed: its very characters
    end type form_list
    type(form_list), parameter, public :: form = form_list()

    !> When a field must be filled.
    type, public :: need_list
        character :: always = 'A'       !! it must be filled
        character :: unmatched = 'U'    !! it must be filled unless the card says MATCH
        character :: optional = 'O'     !! it may be blank
        character :: repeated = 'R'     !! as are all fields behind it; one must be filled
        character :: paired = 'P'       !! it may be blank; fields behind it are like it and the
                                        !! one before in turn
    end type need_list
    type(need_list), parameter, public :: need = need_list()

    !> A field of a card.
    type :: body_field_type
        integer :: card             !! one of `body_card%...`
        integer :: field            !! which field of the card, from 1
        character(6) :: name        !! as the card reference and the faults call it
        character :: form           !! one of `form%...`
        character :: need           !! one of `need%...`
        character(9) :: unit        !! deck units, a slope, degrees, or none
        character(64) :: meaning    !! one line for the card reference
        character(64) :: words = '' !! `form%word`: the words it may hold
    end type body_field_type

    !> A card: its word, the word in its second field where that tells it from its likes, the option
    !> words that may stand behind its last field, and what it is for.
    type :: body_layout_type
        character(8) :: word = ''       !! in field 1; conics and points have none
        character(8) :: second = ''     !! in field 2, or nothing
        character(40) :: options = ''   !! words that may follow the last field, in any order
        character(96) :: meaning = ''   !! what the card is for
    end type body_layout_type

    !> A word that may stand behind the last field of a LINE, data or PATCH card.
    type :: option_type
        character(8) :: word        !! the option
        character(80) :: meaning    !! what it says
    end type option_type

    !> The options of LINE, of data cards and of PATCH.
    type(option_type), parameter, public :: option_words(11) = [ &
        option_type('CHINE', 'the skin is meant to break where sections meet on this line'), &
        option_type('DXDY', 'every end slope of the card is dx/dy; a vertical one is 0.'), &
        option_type('DXDY1', 'the slope at the first point is dx/dy'), &
        option_type('DXDY3', 'the slope at the last point is dx/dy'), &
        option_type('LAST', 'the slope is that at the last point'), &
        option_type('KNUCKLE', 'a slope break at the joint before this card is intended'), &
        option_type('MATCH', &
        'the joint before this card has equal curvature: LOFT finds shoulder or rho'), &
        option_type('TANGENT1', 'the patch is tangent to the skin beside its first side'), &
        option_type('TANGENT2', 'to the skin beside its second side'), &
        option_type('TANGENT3', 'to the skin beside its third side'), &
        option_type('TANGENT4', 'to the skin beside its fourth side')]

    !> The cards by name: `body_layout(body_card%section)`.
    type, public :: body_card_list
        integer :: output = 1, digits = 2, page = 3, symmetry = 4, close = 5, toler = 6
        integer :: body = 7, nose = 8, line = 9
        integer :: conic = 10, rho = 11, tangent = 12, tangent_rho = 13, four_points = 14
        integer :: five_points = 15, straight = 16, circle = 17, radius = 18
        integer :: cyclic = 19, blend = 20, point = 21
        integer :: section = 22, patch = 23, faired = 24, duct = 25
        integer :: points = 26, limit = 27, flange = 28, skin = 29, arcs = 30
        integer :: station = 31, stations = 32, buttock = 33, waterline = 34, oblique = 35, &
            plane = 36
        integer :: check_point = 37, check_sphere = 38, check_box = 39
        integer :: sweep = 40, vary = 41, vary_list = 42, vary_tied = 43
        integer :: object = 44, limit_measure = 45, end = 46
    end type body_card_list

    !> Which card is which.
    type(body_card_list), parameter, public :: body_card = body_card_list()

    !> The measures that OBJECT and LIMIT know, in the order of `measure_list` of `deck_sweep`.
    character(*), parameter, public :: measure_words = &
        'VOLUME WETTED CENTROID AREA GIRTH WIDTH HEIGHT CLEAR JUMP BREAK'

    !> The options of the cards that have a slope at both ends, at one, at none, and of PATCH.
    character(*), parameter :: two_slopes = 'DXDY DXDY1 DXDY3 KNUCKLE MATCH', &
        one_slope = 'LAST DXDY KNUCKLE', no_slope = 'KNUCKLE', &
        four_sides = 'TANGENT1 TANGENT2 TANGENT3 TANGENT4'

    !> The cards of a body deck besides TITLE and UNITS.
    type(body_layout_type), parameter, public :: body_layout(46) = [ &
        body_layout_type('OUTPUT', '', '', &
        'unit of the listing; CSV and files keep the unit of the deck'), &
        body_layout_type('DIGITS', '', '', 'decimals of the ordinates in the listing'), &
        body_layout_type('PAGE', '', '', 'size of a page of the listing'), &
        body_layout_type('SYMMETRY', '', '', 'whether the body is symmetric about BL 0'), &
        body_layout_type('CLOSE', '', '', &
        'sections that reach BL 0 at both ends are closed along it'), &
        body_layout_type('TOLER', '', '', 'largest gap at a joint of a line or between sections'), &
        body_layout_type('BODY', '', '', 'begins another body; what follows belongs to it'), &
        body_layout_type('NOSE', '', '', 'rounds the point nose of the body'), &
        body_layout_type('LINE', '', 'CHINE', &
        'a view of a control line; its data cards follow, end to end, unless field 4 is filled'), &
        body_layout_type('', '', two_slopes, &
        'data card: end points, end slopes, shoulder point, as in 1970; it has no word'), &
        body_layout_type('RHO', '', two_slopes, 'data card: end points, end slopes, rho'), &
        body_layout_type('TANGENT', '', 'KNUCKLE MATCH', &
        'data card: end points, intersection of the end tangents, shoulder point'), &
        body_layout_type('TANRHO', '', 'KNUCKLE MATCH', &
        'data card: end points, intersection of the end tangents, rho'), &
        body_layout_type('FOURPT', '', one_slope, 'data card: four points and one end slope'), &
        body_layout_type('FIVEPT', '', no_slope, 'data card: five points'), &
        body_layout_type('STRAIGHT', '', no_slope, 'data card: a straight line'), &
        body_layout_type('CIRCLE', '', no_slope, &
        'data card: the circular arc through three points'), &
        body_layout_type('RADIUS', '', no_slope, &
        'data card: the circular arc of at most 180 degrees between two points'), &
        body_layout_type('CBEZIER', '', no_slope, &
        'data card: a cubic C-Bezier curve: four poles and an angle'), &
        body_layout_type('BLEND', '', '', &
        'data card: a spiral that joins the lines or circles of the cards before and behind it'), &
        body_layout_type('', '', '', &
        'data card of a SPLINE, BEZIER or FAIR line, or of FAIRED: one point; it has no word'), &
        body_layout_type('SECTION', '', '', &
        'a conic of the cross-section at every station of its lines'), &
        body_layout_type('PATCH', '', four_sides, &
        'a Coons patch between four sides, counter-clockwise as seen from outside'), &
        body_layout_type('FAIRED', '', '', &
        'a closed outline at a station, faired near the points that follow; a cut by itself'), &
        body_layout_type('DUCT', '', '', &
        'a surface lofted through FAIRED outlines, with continuous slopes and curvatures'), &
        body_layout_type('POINTS', '', '', &
        'how the points are spread on the cuts that follow and give no step themselves'), &
        body_layout_type('LIMIT', '', '', 'limits the cuts that follow'), &
        body_layout_type('FLANGE', '', '', 'side of the flange on the frames that follow'), &
        body_layout_type('SKIN', '', '', 'thickness of skin for the cuts and checks that follow'), &
        body_layout_type('ARCS', '', '', &
        'circular arcs in place of the curves of the cuts that follow: a table, NC, DXF'), &
        body_layout_type('STATION', '', '', 'cuts at stations: one, or a range with its step'), &
        body_layout_type('STATION', 'LIST', '', 'cuts at the stations of a list'), &
        body_layout_type('BUTTOCK', '', '', 'a cut at a butt line'), &
        body_layout_type('WATERLN', '', '', 'a cut at a waterline'), &
        body_layout_type('OBLIQUE', '', '', &
        'a cut by the plane across the body through two (STA, WL) points, which also limit it'), &
        body_layout_type('PLANE', '', '', 'a cut by any plane'), &
        body_layout_type('CHECK', 'POINT', '', &
        'a point that must keep clear of the inside of the skin'), &
        body_layout_type('CHECK', 'SPHERE', '', 'a sphere that must keep clear of it'), &
        body_layout_type('CHECK', 'BOX', '', 'a box along the axes that must keep clear of it'), &
        body_layout_type('SWEEP', '', '', 'how loft sweep makes variants; without it GRID'), &
        body_layout_type('VARY', '', '', &
        'a field of the card right before it takes values of a range, in loft sweep'), &
        body_layout_type('VARY', 'LIST', '', 'a field of the card before takes values of a list'), &
        body_layout_type('VARY', 'TIED', '', &
        'a field of the card before goes with a variable of another VARY card'), &
        body_layout_type('OBJECT', '', '', 'a measure of the body that loft sweep looks at'), &
        body_layout_type('LIMIT', 'MEASURE', '', &
        'what a measure of a variant must keep within; the word MEASURE stands for one of these'), &
        body_layout_type('END', '', '', 'ends the deck; without it the deck ends with the file')]

end module deck_body_layout
