!> A job: what a body deck asks for, card by card, as plain data. No geometry is done here; numbers
!> are the decimals of the cards, names are resolved to places in the lists. Every item keeps its
!> card, so that what is found wrong with it later is said of the right columns (`deck_body_card`).
module deck_job
    use base_decimal, only: decimal_type, to_real
    use base_kinds, only: dp
    use deck_body_card, only: card_type
    use deck_duct, only: duct_type
    use deck_sweep, only: sweep_type
    implicit none (type, external)
    private

    public :: job_type, body_type, control_line_type, view_type, piece_type
    public :: section_type, outline_type, end_slope_type, patch_type, bound_type, cut_type
    public :: point_rule_type, range_type, check_type, piece_real, cut_real, check_real

    !> Characters of a name.
    integer, parameter, public :: name_length = 8

    !> The axes, as limits and steps count them.
    type, public :: axis_list
        integer :: sta = 1, bl = 2, wl = 3
    end type axis_list
    type(axis_list), parameter, public :: axis = axis_list()

    !> The views of a control line.
    type, public :: view_list
        integer :: side = 1     !! WL over STA
        integer :: plan = 2     !! BL over STA
        integer :: angle = 3    !! degrees over STA: the direction of an end tangent of sections
    end type view_list
    type(view_list), parameter, public :: view = view_list()

    !> The ways a piece of a line is given, and the numbers it then has, in their order.
    type, public :: piece_list
        integer :: conic = 1        !! X1 Y1 S1 X2 Y2 X3 Y3 S3
        integer :: rho = 2          !! X1 Y1 S1 X3 Y3 S3 RHO
        integer :: tangent = 3      !! X1 Y1 XT YT X2 Y2 X3 Y3
        integer :: tangent_rho = 4  !! X1 Y1 XT YT X3 Y3 RHO
        integer :: four_points = 5  !! X1 Y1 S1 XA YA XB YB X3 Y3
        integer :: five_points = 6  !! X1 Y1 XA YA XB YB XC YC X3 Y3
        integer :: straight = 7     !! X1 Y1 X3 Y3
        integer :: circle = 8       !! X1 Y1 X2 Y2 X3 Y3
        integer :: radius = 9       !! X1 Y1 X3 Y3 R
        integer :: cyclic = 10      !! X1 Y1 XA YA XB YB X3 Y3 ALPHA
        integer :: blend = 11       !! ALPHA THETA, 0 where blank
        integer :: point = 12       !! X Y of a point or a pole; S at an end, or its weight
    end type piece_list
    type(piece_list), parameter, public :: piece = piece_list()

    !> Where a view of a line comes from.
    type, public :: origin_list
        integer :: none = 0     !! the view is not given
        integer :: pieces = 1   !! data cards
        integer :: line = 2     !! the same view of another line
        integer :: constant = 3 !! one ordinate at every station
        integer :: spline = 4   !! a spline through the points of data cards
        integer :: bezier = 5   !! the Bezier curve of the poles of data cards
        integer :: fair = 6     !! a faired curve near the points of data cards
    end type origin_list
    type(origin_list), parameter, public :: origin = origin_list()

    !> What is asked at an end of a spline, or of a point of a faired line.
    type, public :: ending_list
        integer :: free = 1     !! no bending
        integer :: slope = 2    !! the slope on the card
        integer :: parabola = 3 !! a parabola to the next point
        integer :: weight = 4   !! none: a point of a faired line with a weight of its own
    end type ending_list
    type(ending_list), parameter, public :: ending = ending_list()

    !> On which side of BL 0 a section stands.
    type, public :: side_list
        integer :: starboard = 1    !! as its lines and slopes say
        integer :: port = 2         !! their mirror image in BL 0
        integer :: both = 3         !! both of these
    end type side_list
    type(side_list), parameter, public :: side = side_list()

    !> What a side of a patch is.
    type, public :: bound_list
        integer :: line = 1     !! a part of a line
        integer :: station = 2  !! the arc of a section at a station
        integer :: point = 3    !! where the sides beside it meet
        integer :: cut = 4      !! a part of what a named cut takes from the skin
    end type bound_list
    type(bound_list), parameter, public :: bound = bound_list()

    !> How a patch is blended between its sides.
    type, public :: twist_list
        integer :: adini = 1    !! with Adini's twists
        integer :: none = 2     !! by cubics, without twists
        integer :: linear = 3   !! by straight lines
    end type twist_list
    type(twist_list), parameter, public :: twist = twist_list()

    !> The cuts, and the numbers they have.
    type, public :: cut_list
        integer :: station = 1  !! `value`: the stations; where `is_stepped` FROM TO STEP
        integer :: buttock = 2  !! BL
        integer :: waterline = 3 !! WL
        integer :: oblique = 4  !! STA1 WL1 STA2 WL2: every BL of the line through them
        integer :: plane = 5    !! X Y Z of a point, NX NY NZ of the normal
    end type cut_list
    type(cut_list), parameter, public :: cut = cut_list()

    !> How the points of a cut are spread.
    type, public :: rule_list
        integer :: step = 1     !! at `start + k*step` of an axis, and at the ends
        integer :: number = 2   !! so many on each arc, equally spaced in arc length, ends included
        integer :: length = 3   !! equal arc lengths, as near to `step` as goes evenly
        integer :: chord = 4    !! chords stay within `step` of the curve
    end type rule_list
    type(rule_list), parameter, public :: rule = rule_list()

    !> What must keep clear of the skin, and the numbers it has.
    type, public :: check_list
        integer :: point = 1    !! STA BL WL
        integer :: sphere = 2   !! STA BL WL of the centre, radius
        integer :: box = 3      !! STA BL WL of two opposite corners
    end type check_list
    type(check_list), parameter, public :: check = check_list()

    !> A range along an axis, deck units; FROM may be above TO.
    type :: range_type
        logical :: has_from = .false.   !! there is a first ordinate
        logical :: has_to = .false.     !! there is a last ordinate
        type(decimal_type) :: from      !! first ordinate
        type(decimal_type) :: to        !! last ordinate
    end type range_type

    !> One arc of a line, or one point of it.
    type :: piece_type
        integer :: kind = 0                         !! one of `piece%...`
        type(decimal_type), allocatable :: value(:) !! its numbers, in the order of `piece_list`
        integer :: first_field = 1                  !! field of the card that holds `value(1)`
        logical :: is_inverse(2) = .false.          !! S1, S3 is dX/dY
        logical :: is_slope_last = .false.          !! four points: the slope is that at point 3
        integer :: ending = 1                       !! of a point: one of `ending%...`
        logical :: is_knuckle = .false.             !! a slope break at its start is intended
        logical :: is_match = .false.               !! shoulder or rho is found: equal curvature
        type(card_type) :: card                     !! its card
    end type piece_type

    !> One view of a line.
    type :: view_type
        integer :: origin = 0                       !! one of `origin%...`
        type(piece_type), allocatable :: piece(:)   !! from first to last
        integer :: line = 0                         !! the line it is taken from
        type(decimal_type) :: constant              !! the ordinate, deck units or degrees
        logical :: is_uniform = .false.             !! spline: 1 in its parameter between points
        type(decimal_type) :: weight                !! faired: of points that have none themselves
        logical :: is_sound = .false.               !! none of its cards was in error
        type(card_type) :: card                     !! its LINE card
    end type view_type

    !> A control line. Without a PLAN it lies at BL 0.
    type :: control_line_type
        character(name_length) :: name = '' !! its name
        type(view_type) :: view(3)          !! by `view%side`, `view%plan`, `view%angle`
        type(card_type), allocatable :: chine   !! its card that says CHINE, if one does
    end type control_line_type

    !> An end slope dWL/dBL of a section.
    type :: end_slope_type
        logical :: is_angle = .false.   !! the direction is the ANGLE view of a line
        integer :: line = 0             !! that line
        type(decimal_type) :: value     !! else the slope; 999.99 or more is vertical
    end type end_slope_type

    !> A section of the body: one conic at each station.
    type :: section_type
        character(name_length) :: name = ''     !! its name
        integer :: line(3) = 0                  !! start, shoulder and end line
        type(end_slope_type) :: slope(2)        !! at the start and at the end
        type(range_type) :: range               !! stations it is limited to
        integer :: side = 1                     !! one of `side%...`
        logical :: is_sound = .false.           !! its card, and all lines it names, are sound
        type(card_type) :: card                 !! its card
    end type section_type

    !> A closed outline at a station, faired near measured points.
    type :: outline_type
        character(name_length) :: name = ''         !! its name
        type(decimal_type) :: sta                   !! its station, deck units
        type(decimal_type) :: weight                !! of points that have none themselves
        type(decimal_type) :: beta                  !! share of the second derivative's energy
        logical :: has_area = .false.               !! its area is prescribed
        type(decimal_type) :: area                  !! that area, deck units squared, above zero
        type(decimal_type) :: arcs                  !! tolerance of arcs, deck units; 0: none asked
        type(piece_type), allocatable :: piece(:)   !! its points, BL and WL, in order around it
        logical :: is_sound = .false.               !! none of its cards was in error
        type(card_type) :: card                     !! its card
    end type outline_type

    !> A side of a patch.
    type :: bound_type
        integer :: kind = 0             !! one of `bound%...`
        integer :: line = 0             !! that line
        integer :: cut = 0              !! that cut
        type(decimal_type) :: station   !! that station
        logical :: is_tangent = .false. !! the patch keeps the tangent planes of the skin there
    end type bound_type

    !> A patch between four sides, which go round counter-clockwise as seen from outside.
    type :: patch_type
        character(name_length) :: name = '' !! its name
        type(bound_type) :: side(4)         !! its sides
        integer :: twist = 1                !! one of `twist%...`
        type(range_type) :: range           !! stations where its lines may meet
        type(card_type) :: card             !! its card
    end type patch_type

    !> How the points of a cut are spread; for its own card or by POINTS, already decided.
    type :: point_rule_type
        integer :: kind = 2             !! one of `rule%...`
        integer :: axis = 1             !! `rule%step`: the axis that is stepped
        integer :: number = 25          !! `rule%number`: points on each arc
        type(decimal_type) :: start     !! `rule%step`: ordinates are start + k*step
        type(decimal_type) :: step      !! step, arc length or tolerance, deck units
    end type point_rule_type

    !> A cut asked for. A stepped STATION card is one of these.
    type :: cut_type
        integer :: kind = 0                         !! one of `cut%...`
        character(name_length) :: name = ''         !! its name, or blank
        type(decimal_type), allocatable :: value(:) !! its numbers, in the order of `cut_list`
        logical :: is_stepped = .false.             !! stations FROM TO STEP
        type(range_type) :: limit(3)                !! along STA, BL, WL
        type(point_rule_type) :: points             !! how its points are spread
        logical :: is_flange_forward = .false.      !! the frame's flange is forward
        type(decimal_type) :: skin                  !! thickness of skin, deck units; 0: not asked
        type(decimal_type) :: arcs                  !! tolerance of arcs, deck units; 0: none asked
        type(card_type) :: card                     !! its card
    end type cut_type

    !> A component that must keep clear of the inside of the skin.
    type :: check_type
        integer :: kind = 0                         !! one of `check%...`
        character(name_length) :: name = ''         !! its name, or blank
        type(decimal_type), allocatable :: value(:) !! its numbers, in the order of `check_list`
        type(decimal_type) :: clearance             !! asked for, deck units
        type(decimal_type) :: skin                  !! thickness of skin, deck units
        type(card_type) :: card                     !! its card
    end type check_type

    !> A body: what stands between two BODY cards.
    type :: body_type
        character(name_length) :: name = ''             !! its name, or blank
        logical :: has_nose = .false.                   !! its nose is to be rounded
        type(decimal_type) :: nose_radius               !! radius of the nose, deck units
        type(card_type) :: nose_card                    !! the NOSE card, where there is one
        type(control_line_type), allocatable :: line(:) !! its control lines
        type(section_type), allocatable :: section(:)   !! its sections
        type(outline_type), allocatable :: outline(:)   !! its faired outlines
        type(patch_type), allocatable :: patch(:)       !! its patches
        type(duct_type), allocatable :: duct(:)         !! its ducts
        type(cut_type), allocatable :: cut(:)           !! the cuts asked of it, in deck order
        type(check_type), allocatable :: check(:)       !! clearances asked of it
    end type body_type

    !> All that a body deck asks for.
    type :: job_type
        character(:), allocatable :: title      !! of the deck, or nothing
        character(6) :: units = 'INCHES'        !! of its numbers: INCHES, MM or FEET
        character(6) :: output = 'INCHES'       !! of the listing: INCHES, MM, FEET or FIE
        integer :: digits = 3                   !! decimals of the listing
        integer :: page_columns = 80, page_lines = 60   !! of a page: 80 or 132, and its lines
        logical :: is_symmetric = .true.        !! the body is symmetric about BL 0
        logical :: is_closed = .false.          !! sections that reach BL 0 are closed along it
        type(decimal_type) :: joint_gap         !! largest gap at a joint, deck units
        type(body_type), allocatable :: body(:) !! at least one
        type(sweep_type) :: sweep               !! what varies, and what is looked at
        type(card_type), allocatable :: card(:) !! every card that is sound, in deck order
    end type job_type

contains

    !> A number of a piece as a double.
    elemental real(dp) function piece_real(item, number)
        type(piece_type), intent(in) :: item    !! the piece
        integer, intent(in) :: number           !! which, in the order of `piece_list`
        piece_real = to_real(item%value(number))
    end function piece_real

    !> A number of a cut as a double.
    elemental real(dp) function cut_real(item, number)
        type(cut_type), intent(in) :: item      !! the cut
        integer, intent(in) :: number           !! which, in the order of `cut_list`
        cut_real = to_real(item%value(number))
    end function cut_real

    !> A number of a check as a double.
    elemental real(dp) function check_real(item, number)
        type(check_type), intent(in) :: item    !! the component
        integer, intent(in) :: number           !! which, in the order of `check_list`
        check_real = to_real(item%value(number))
    end function check_real

end module deck_job
