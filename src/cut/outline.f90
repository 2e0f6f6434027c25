!> The outlines that a plane cuts from a body, as plain data: tables, CSV, pictures, drawings and
!> CAD files are all written from these.
!>
!> A cut is a set of outlines, each one a chain of pieces. A piece belongs to one section of the
!> body and goes one way in STA (or, in a station, is one conic arc). Points stand in the order of
!> the outline. An open outline begins at its foremost end; a closed one at its foremost point, and
!> runs counter-clockwise in its view; its last point is not its first again. In a station the order
!> is that of the sections, from start line to end line.
!>
!> A station at the point of a nose is an outline of that point, without pieces.
!>
!> Where two sections meet in an outline both give the point, the one that ends first: normal and
!> slope may differ.
module cut_outline
    use base_kinds, only: dp, i64
    use base_order, only: each_once
    use cut_plane, only: plane_type
    use geom_arc, only: arc_type
    use geom_arc_point, only: slope_type
    use geom_bspline, only: bspline_type
    use geom_place, only: place_type
    implicit none (type, external)
    private

    public :: cut_type, outline_type, piece_type, cut_point_type, note_type, panel_curve_type
    public :: cut_at, has_outlines, has_panels, keep_cuts, room_of

    !> A point of a cut. A value that does not exist is marked absent and is zero.
    type :: cut_point_type
        real(dp) :: at(3) = 0.0_dp          !! STA, BL, WL, deck units
        real(dp) :: uv(2) = 0.0_dp          !! true-shape coordinates in the plane, deck units
        integer :: section = 0              !! place in the body's list of sections
        integer :: piece = 0                !! place in the outline's list of pieces
        type(place_type) :: place           !! where on the section's arc at that STA
        logical :: has_normal = .false.     !! normal and bevel exist
        real(dp) :: normal(3) = 0.0_dp      !! outward unit normal of the skin
        real(dp) :: bevel = 0.0_dp          !! of the flange, degrees, positive where open
        logical :: has_slope = .false.      !! the slope exists
        type(slope_type) :: slope           !! dv/du, or vertical
        logical :: has_curvature = .false.  !! the curvature exists
        real(dp) :: curvature = 0.0_dp      !! 1/deck unit, positive where the outline turns left
    end type cut_point_type

    !> A piece of an outline: exactly what curve it is.
    type :: piece_type
        integer :: section = 0              !! place in the body's list of sections
        logical :: is_arc = .false.         !! of a station: `arc` is the piece
        type(arc_type) :: arc               !! x is BL, y is WL; runs as the outline does
        real(dp) :: from = 0.0_dp           !! STA where it begins, deck units
        real(dp) :: to = 0.0_dp             !! STA where it ends, deck units; may be below `from`
        integer :: branch = 0               !! `cut_branch`: which place of the section's arc
        integer :: first = 0                !! its first point in the outline's list
        integer :: last = 0                 !! its last point in the outline's list
        logical :: is_image = .false.       !! of the port half of a symmetric body
    end type piece_type

    !> One outline.
    type :: outline_type
        logical :: is_closed = .false.                  !! it comes back to its first point
        type(piece_type), allocatable :: pieces(:)      !! in order
        type(cut_point_type), allocatable :: points(:)  !! in order
    end type outline_type

    !> An outline on a panel as a curve.
    type :: panel_curve_type
        type(bspline_type) :: spline        !! in space, over its length, deck units
        logical :: is_exact = .false.       !! the outline itself, but for rounding
        real(dp) :: error = 0.0_dp          !! largest distance from the outline, measured
        real(dp) :: worst(3) = 0.0_dp       !! where
        logical :: has_image = .true.       !! in a symmetric body it has a mirror image
    end type panel_curve_type

    !> Something the user will want to know of a cut.
    type :: note_type
        logical :: is_error = .false.           !! the cut can't be relied upon
        character(:), allocatable :: message    !! plain words, no final point
    end type note_type

    !> A cut of a body by a plane.
    type :: cut_type
        type(plane_type) :: plane                       !! kind, normal, true-shape axes
        character(8) :: name = ''                       !! of the card, or blank
        logical :: is_flange_forward = .false.          !! for the bevel
        type(outline_type), allocatable :: outlines(:)  !! of the skin's outside; none: plane misses
        real(dp) :: skin = 0.0_dp                       !! thickness, deck units; 0: not asked
        type(outline_type), allocatable :: inside(:)    !! of its inside, where asked: no
                                                        !! pieces: `at` lies in the plane, `normal`,
                                                        !! slope and curvature are of the inside
        real(dp) :: arcs = 0.0_dp                       !! tolerance of circular arcs in place of
                                                        !! its curves, deck units; 0: not asked
        type(outline_type), allocatable :: patched(:)   !! of panels, where there are any: no
                                                        !! pieces; `section` counts on from
                                                        !! the sections of the body
        type(panel_curve_type), allocatable :: curves(:) !! each of these as a curve
        integer :: sections = huge(1)                   !! of the body, where there are panels
        integer :: patches = 0                          !! of the body; the panels behind are ducts
        real(dp) :: off_plane = 0.0_dp                  !! of these, before they are put into it
        real(dp) :: disagreement = 0.0_dp               !! largest distance between the two ways
        type(note_type), allocatable :: notes(:)        !! in no order
    end type cut_type

contains

    !> True for a cut that meets the body: its sections or its panels.
    pure logical function has_outlines(cut)
        type(cut_type), intent(in) :: cut !! as made
        has_outlines = size(cut%outlines) > 0 .or. has_panels(cut)
    end function has_outlines

    !> True for a cut that meets panels.
    pure logical function has_panels(cut)
        type(cut_type), intent(in) :: cut !! any
        has_panels = .false.
        if (allocated(cut%patched)) has_panels = size(cut%patched) > 0
    end function has_panels

    !> Where cuts of a kind stand along their axis, each ordinate once.
    pure function cut_at(cuts, kind, axis) result(ordinates)
        type(cut_type), intent(in) :: cuts(:)   !! of a body
        integer, intent(in) :: kind             !! one of `cut_kind%...`
        integer, intent(in) :: axis             !! 1 STA, 2 BL, 3 WL
        real(dp), allocatable :: ordinates(:)
        integer :: i

        allocate (ordinates(0))
        ordinates = each_once(pack([(cuts(i)%plane%through(axis), i=1, size(cuts))], &
            cuts%plane%kind == kind))
    end function cut_at

    !> Keeps some of a list of cuts.
    pure subroutine keep_cuts(is_kept, cuts)
        logical, intent(in) :: is_kept(:)                       !! one for each
        type(cut_type), allocatable, intent(inout) :: cuts(:)   !! loses the others
        type(cut_type), allocatable :: kept(:)
        integer :: i, number

        allocate (kept(count(is_kept)))
        number = 0
        do i = 1, size(cuts)
            if (.not. is_kept(i)) cycle
            number = number + 1
            call move_cut(cuts(i), kept(number))
        end do
        call move_alloc(kept, cuts)
    end subroutine keep_cuts

    !> Moves a cut without copying its outlines.
    pure subroutine move_cut(from, to)
        type(cut_type), intent(inout) :: from   !! loses them
        type(cut_type), intent(out) :: to       !! gets it
        to = cut_type(plane=from%plane, name=from%name, is_flange_forward=from%is_flange_forward, &
            skin=from%skin, arcs=from%arcs, sections=from%sections, patches=from%patches, &
            off_plane=from%off_plane, disagreement=from%disagreement)
        call move_alloc(from%outlines, to%outlines)
        call move_alloc(from%inside, to%inside)
        call move_alloc(from%patched, to%patched)
        call move_alloc(from%curves, to%curves)
        call move_alloc(from%notes, to%notes)
    end subroutine move_cut

    !> The room that a cut takes but for its notes, bytes.
    pure integer(i64) function room_of(cut) result(room)
        type(cut_type), intent(in) :: cut !! any
        room = int(storage_size(cut)/8, i64)
        if (allocated(cut%outlines)) room = room + room_of_outlines(cut%outlines)
        if (allocated(cut%inside)) room = room + room_of_outlines(cut%inside)
        if (allocated(cut%patched)) room = room + room_of_outlines(cut%patched)
    end function room_of

    !> The room that outlines take, bytes.
    pure integer(i64) function room_of_outlines(outlines) result(room)
        type(outline_type), intent(in) :: outlines(:) !! any
        integer :: i

        room = int(storage_size(outlines)/8, i64)*size(outlines, kind=i64)
        do i = 1, size(outlines)
            if (allocated(outlines(i)%points)) room = room + &
                int(storage_size(outlines(i)%points)/8, i64)*size(outlines(i)%points, kind=i64)
            if (allocated(outlines(i)%pieces)) room = room + &
                int(storage_size(outlines(i)%pieces)/8, i64)*size(outlines(i)%pieces, kind=i64)
        end do
    end function room_of_outlines

end module cut_outline
