!> The skin of a body as surfaces that share their edges: what IGES and STEP files are written from.
!>
!> Each face is one stretch of one section (a stretch lies between two stations where any line of
!> the body has a joint or an end), or flat: a cap that closes the body at a station, or a wall in
!> BL 0 that closes a body of one side. Faces of a shell share edges, and edges share vertices,
!> exactly: the same numbers. The edges of a surface are its own splines, pole by pole; only an end
!> of a section that is straight is an edge of degree 1 whatever the surface has.
module export_shell
    use base_kinds, only: dp
    use geom_bspline, only: bspline_type
    use geom_bspline_surface, only: bspline_surface_type
    implicit none (type, external)
    private

    public :: vertex_type, edge_type, side_type, face_type, shell_type, skin_model_type

    !> A corner of faces.
    type :: vertex_type
        real(dp) :: at(3) = 0.0_dp              !! STA, BL, WL
    end type vertex_type

    !> A curve between two vertices, used by one face (a free edge) or two.
    type :: edge_type
        type(bspline_type) :: curve             !! in space; an edge line of the surface(s)
        integer :: from = 0                     !! vertex where it begins
        integer :: to = 0                       !! vertex where it ends
    end type edge_type

    !> One side of a face.
    type :: side_type
        integer :: edge = 0                     !! which edge; 0: the side is a point (`vertex`)
        logical :: is_forward = .true.          !! the loop runs as the edge does
        integer :: vertex = 0                   !! of a side that has shrunk to a point
    end type side_type

    !> A face: all of a rational B-spline surface, or a plane within its sides.
    type :: face_type
        character(:), allocatable :: name       !! `UPPER STA 0 TO 14`, `CAP STA 280`
        character(:), allocatable :: section    !! name of the section; empty: a cap
        logical :: is_port = .false.            !! of the mirrored half
        logical :: is_flat = .false.            !! a plane, cap or wall: `surface` is not set
        type(bspline_surface_type) :: surface   !! u aft along the section's lines, v from its start
                                                !! line to its finish line
        real(dp) :: origin(3) = 0.0_dp          !! a point of a plane
        real(dp) :: normal(3) = 0.0_dp          !! of a plane, outward, of unit length
        logical :: is_outward = .true.          !! dS/du x dS/dv points out of the body
        type(side_type), allocatable :: sides(:) !! the outer loop, counter-clockwise seen from
                                                !! outside; of a surface and of a wall four: start
                                                !! line, aft end, finish line, fore end; where not
                                                !! `is_outward` start line, fore end, finish line,
                                                !! aft end; of a cap as many as there are
        logical :: is_exact = .false.           !! the surface itself, but for rounding
        real(dp) :: error = 0.0_dp              !! largest distance from the skin, measured
        real(dp) :: worst(3) = 0.0_dp           !! where
        integer :: spans = 0                    !! stretches between knots along u
    end type face_type

    !> Faces that hang together.
    type :: shell_type
        integer, allocatable :: faces(:)        !! which
        logical :: is_closed = .false.          !! every edge is used twice, once each way
        character(24) :: name = 'SKIN'          !! of several bodies with the body's: `POD SKIN`
    end type shell_type

    !> All of a body's skin.
    type :: skin_model_type
        type(vertex_type), allocatable :: vertices(:)
        type(edge_type), allocatable :: edges(:)
        type(face_type), allocatable :: faces(:)
        type(shell_type), allocatable :: shells(:)
    end type skin_model_type

end module export_shell
