!> A drawing: cuts and control lines as exact or fitted curves, each with its measured error. Every
!> file of curves (SVG, PDF, DXF, IGES, STEP, NC) is written from one; it knows no deck and no file
!> format.
!>
!> All lengths are in the unit the drawing says. Curves are in space, (STA, BL, WL); a cut lies in
!> the plane of its shape, whose axes u and v show it in its true form. A drawing of a 1970 deck
!> has its x as STA and its y as WL.
module export_drawing
    use base_kinds, only: dp
    use cut_plane, only: plane_type
    use geom_arc, only: arc_type
    use geom_bspline, only: bspline_type
    implicit none (type, external)
    private

    public :: curve_type, mark_type, contour_type, shape_type, drawing_type

    !> What a shape is.
    type, public :: shape_list
        integer :: station = 1      !! a cut, as `cut_kind` has it
        integer :: buttock = 2
        integer :: waterline = 3
        integer :: oblique = 4
        integer :: plane = 5
        integer :: line = 6         !! a control line
        integer :: card = 7         !! a card of a 1970 deck
    end type shape_list

    !> The kinds by name.
    type(shape_list), parameter, public :: shape_kind = shape_list()

    !> One curve, from its first pole to its last.
    type :: curve_type
        type(bspline_type) :: spline            !! in space, three dimensions
        character(:), allocatable :: section    !! section of the body it is on, or empty
        logical :: is_exact = .false.           !! the curve itself, but for rounding
        real(dp) :: error = 0.0_dp              !! largest distance from the curve, measured
        real(dp) :: worst(3) = 0.0_dp           !! where: STA, BL, WL
        logical :: is_conic = .false.           !! it is one arc of a conic, `arc`
        type(arc_type) :: arc                   !! in u and v of the shape, runs as the spline does
    end type curve_type

    !> A mark on a contour: where a bevel is taken.
    type :: mark_type
        real(dp) :: uv(2) = 0.0_dp      !! in the plane of the shape
        real(dp) :: outward(2) = 0.0_dp !! unit vector across the contour, away from the body
        real(dp) :: bevel = 0.0_dp      !! degrees, positive where the flange is open
    end type mark_type

    !> Curves end to end.
    type :: contour_type
        logical :: is_closed = .false.                  !! the last ends where the first begins
        logical :: is_inside = .false.                  !! of the inside of the skin
        logical :: has_image = .true.                   !! of a half shape: it is half of a pair
        type(curve_type), allocatable :: curves(:)      !! in order; none: a point
        type(mark_type), allocatable :: marks(:)        !! bevels, in order along it
        real(dp) :: at(3) = 0.0_dp                      !! of a point: STA, BL, WL
    end type contour_type

    !> A cut, a control line or a card.
    type :: shape_type
        character(:), allocatable :: name       !! unique in the drawing: letters, figures, - _ .
        character(:), allocatable :: title      !! `STATION 20`, `WATERLINE -16 FLOOR`: any bytes
        integer :: kind = 0                     !! one of `shape_kind%...`
        integer :: number = 0                   !! which cut, line or card of the deck
        type(plane_type) :: plane               !! lengths in the unit of the drawing
        real(dp) :: skin = 0.0_dp               !! thickness asked for; 0: none
        real(dp) :: arcs = 0.0_dp               !! tolerance of circular arcs for it; 0: none
        integer :: quantity = 1                 !! pieces a body needs
        logical :: is_flange_forward = .false.  !! the side of its flange, as the cut has it
        logical :: is_half = .false.            !! its mirror image in BL 0 belongs to the piece
        type(contour_type), allocatable :: contours(:)
    end type shape_type

    !> A drawing.
    type :: drawing_type
        character(:), allocatable :: deck       !! file name of the deck, without folders
        character(:), allocatable :: title      !! of the deck, may be empty
        character(:), allocatable :: units      !! INCHES, MM, FEET or M: of all lengths in it
        real(dp) :: tolerance = 0.0_dp          !! asked of fitted curves
        type(shape_type), allocatable :: cuts(:)    !! in the order of the deck
        type(shape_type), allocatable :: lines(:)   !! control lines in space; of 1970 decks none
    end type drawing_type

end module export_drawing
