!> An arc or another stroke as points so close that straight lines between them look like it.
!>
!> Between two points the arc lies in the triangle of its chord and end tangents, whose height is at
!> most (chord/2) tan(turn/2), the turn being the angle between the tangents. Stretches are halved
!> until turn and height are small, so points stand close where the arc bends and apart where not.
module export_polyline
    use base_kinds, only: dp
    use geom_arc, only: arc_type
    use geom_place, only: place_at
    use geom_stroke, only: conic_stroke, stroke_kind, stroke_point, stroke_tangent, stroke_type
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: polyline

    interface polyline
        module procedure arc_polyline, stroke_polyline
    end interface polyline

    !> Largest angle between two neighbouring pieces of the line, radians.
    real(dp), parameter :: largest_turn = 0.1_dp
    !> How far the arc may be from a piece, in parts of its size: a tenth of a dot on paper.
    real(dp), parameter :: largest_height = 1.0e-4_dp
    !> Halvings after which a stretch is taken as it is: its turn is then a corner to any eye.
    integer, parameter :: most_halvings = 40
    !> Stretches that a stroke which may turn either way is looked at with first.
    integer, parameter :: first_stretches = 16

contains

    !> Points of the arc itself, x and y by columns, from its start to its finish, both as given.
    pure function arc_polyline(arc) result(points)
        type(arc_type), intent(in) :: arc !! any arc
        real(dp), allocatable :: points(:, :)
        allocate (points, source=stroke_polyline(conic_stroke(arc)))
    end function arc_polyline

    !> Points of the stroke itself, x and y by columns, from its start to its finish, both as given.
    pure function stroke_polyline(stroke) result(points)
        type(stroke_type), intent(in) :: stroke !! any
        real(dp), allocatable :: points(:, :)
        real(dp), allocatable :: t(:)
        integer :: i

        allocate (t, source=parameters(stroke))
        allocate (points(2, size(t)))
        do i = 1, size(t)
            points(:, i) = stroke_point(stroke, place_at(t(i)))
        end do
    end function stroke_polyline

    !> The parameters of the points. Each half of an arc, parted where the tangent is parallel to
    !> the chord, turns by less than 180 degrees; so the angle of its end tangents is its turn.
    pure function parameters(stroke) result(t)
        type(stroke_type), intent(in) :: stroke !! any
        real(dp), allocatable :: t(:)
        real(dp), allocatable :: finer(:)
        logical, allocatable :: is_kept(:)
        real(dp) :: height
        integer :: i, halving

        t = [0.0_dp, 0.5_dp, 1.0_dp]
        if (stroke%kind /= stroke_kind%conic) &
            t = [(real(i, dp)/real(first_stretches, dp), i=0, first_stretches)]
        height = largest_height*extent(stroke)
        do halving = 1, most_halvings
            allocate (finer(2*size(t) - 1), is_kept(2*size(t) - 1))
            finer(1::2) = t
            finer(2::2) = 0.5_dp*(t(:size(t) - 1) + t(2:))
            is_kept(1::2) = .true.
            is_kept(2::2) = [(is_coarse(stroke, t(i), t(i + 1), height), i=1, size(t) - 1)]
            if (size(t) == count(is_kept)) exit
            t = pack(finer, is_kept)
            deallocate (finer, is_kept)
        end do
    end function parameters

    !> True where a stretch bends too much to be drawn as one straight piece.
    pure logical function is_coarse(stroke, from, to, height)
        type(stroke_type), intent(in) :: stroke !! any
        real(dp), intent(in) :: from      !! parameter where the stretch begins
        real(dp), intent(in) :: to        !! parameter where it ends
        real(dp), intent(in) :: height    !! how far it may be from its chord, deck units
        real(dp) :: turn, chord

        turn = angle(stroke_tangent(stroke, place_at(from)), stroke_tangent(stroke, place_at(to)))
        chord = norm2(stroke_point(stroke, place_at(to)) - stroke_point(stroke, place_at(from)))
        is_coarse = turn > largest_turn
        if (.not. is_coarse) is_coarse = 0.5_dp*chord*tan(0.5_dp*turn) > height
    end function is_coarse

    !> The angle between two directions, radians, 0 to pi.
    pure real(dp) function angle(u, v)
        real(dp), intent(in) :: u(2) !! first direction, not zero
        real(dp), intent(in) :: v(2) !! second direction, not zero
        real(dp) :: ahead(2), other(2)
        ahead = u/norm2(u)
        other = v/norm2(v)
        angle = atan2(abs(cross(ahead, other)), dot_product(ahead, other))
    end function angle

    !> The size of a stroke: its ends and its middle are about so far apart, deck units.
    pure real(dp) function extent(stroke)
        type(stroke_type), intent(in) :: stroke !! any
        real(dp) :: middle(2)
        middle = stroke_point(stroke, place_at(0.5_dp))
        extent = max(norm2(middle - stroke%start), norm2(stroke%finish - middle))
    end function extent

end module export_polyline
