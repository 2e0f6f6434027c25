!> Circular arcs by a start with its direction and an end: what a milling machine runs along.
!>
!> An arc that leaves A in the direction phi and comes to B by the chord of direction c leaves B in
!> the direction 2 c - phi. Source: seed 003, second paper, the reflection rule of section 1.
module geom_circular
    use base_constants, only: pi
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: circular_type, circular_between, direction_to, wrapped, distance_from, leaving
    public :: reversed_circular, parted_circular

    !> A circular arc of less than a full turn, or a straight line.
    type :: circular_type
        real(dp) :: start(2) = 0.0_dp       !! first point, deck units
        real(dp) :: finish(2) = 0.0_dp      !! last point, deck units
        real(dp) :: direction = 0.0_dp      !! at the start, radians
        real(dp) :: turn = 0.0_dp           !! from start to finish, radians, positive to the left
        logical :: is_line = .true.         !! straight: no centre
        real(dp) :: centre(2) = 0.0_dp      !! deck units
        real(dp) :: radius = 0.0_dp         !! deck units, positive where it turns left
    end type circular_type

    !> Half the turn, radians, below which an arc is a straight line: its rise is below rounding.
    real(dp), parameter :: flat = 1.0e-12_dp

contains

    !> The direction from a point to another, radians.
    pure real(dp) function direction_to(from, to)
        real(dp), intent(in) :: from(2) !! a point
        real(dp), intent(in) :: to(2)   !! another
        direction_to = atan2(to(2) - from(2), to(1) - from(1))
    end function direction_to

    !> An angle between -pi and pi, radians.
    elemental real(dp) function wrapped(angle)
        real(dp), intent(in) :: angle !! radians
        wrapped = angle - 2.0_dp*pi*anint(angle/(2.0_dp*pi))
    end function wrapped

    !> The arc that leaves a point in a direction and comes to another.
    pure type(circular_type) function circular_between(start, direction, finish) result(arc)
        real(dp), intent(in) :: start(2)    !! first point, deck units
        real(dp), intent(in) :: direction   !! there, radians
        real(dp), intent(in) :: finish(2)   !! last point, another, deck units
        real(dp) :: half

        half = wrapped(direction_to(start, finish) - direction)
        arc%start = start
        arc%finish = finish
        arc%direction = direction
        arc%turn = 2.0_dp*half
        arc%is_line = abs(sin(half)) < flat
        if (arc%is_line) return
        arc%radius = norm2(finish - start)/(2.0_dp*sin(half))
        arc%centre = start + arc%radius*[-sin(direction), cos(direction)]
    end function circular_between

    !> The direction in which an arc ends, radians.
    pure real(dp) function leaving(arc)
        type(circular_type), intent(in) :: arc !! any
        leaving = arc%direction + arc%turn
    end function leaving

    !> An arc, run through backwards.
    pure type(circular_type) function reversed_circular(arc) result(back)
        type(circular_type), intent(in) :: arc !! any
        back = arc
        back%start = arc%finish
        back%finish = arc%start
        back%direction = wrapped(leaving(arc) + pi)
        back%turn = 0.0_dp - arc%turn
        back%radius = 0.0_dp - arc%radius
    end function reversed_circular

    !> An arc in so many arcs of one turn.
    pure function parted_circular(arc, count) result(parts)
        type(circular_type), intent(in) :: arc  !! with a centre
        integer, intent(in) :: count            !! one or more
        type(circular_type) :: parts(count)
        integer :: i

        parts = arc
        parts%turn = arc%turn/real(count, dp)
        do i = 2, count
            parts(i)%direction = arc%direction + real(i - 1, dp)*parts(i)%turn
            parts(i)%start = arc%centre + arc%radius*[sin(parts(i)%direction), &
                -cos(parts(i)%direction)]
            parts(i - 1)%finish = parts(i)%start
        end do
    end function parted_circular

    !> How far a point beside an arc is from its circle, or from its line, deck units.
    pure real(dp) function distance_from(arc, point) result(distance)
        type(circular_type), intent(in) :: arc  !! any
        real(dp), intent(in) :: point(2)        !! deck units
        if (arc%is_line .and. all(is_equal(arc%start, arc%finish))) then
            distance = norm2(point - arc%start)
        else if (arc%is_line) then
            distance = abs(cross(point - arc%start, arc%finish - arc%start)) &
                /norm2(arc%finish - arc%start)
        else
            distance = abs(norm2(point - arc%centre) - abs(arc%radius))
        end if
    end function distance_from

end module geom_circular
