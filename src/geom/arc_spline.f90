!> A conic arc as a rational B-spline, exactly: of degree 2 with weights above zero, a straight line
!> of degree 1.
!>
!> Where the weight of an arc is small or negative its pole is far away or on the other side; where
!> it is large nearly all parameters crowd at the shoulder. Such an arc is parted at its shoulder,
!> and its halves too, until the weight is between `least_weight` and `most_weight`. Both halves of
!> an arc of weight w have the weight sqrt((1 + w)/2). The pole between two places a1 : b1 and
!> a2 : b2 is the polar form of `geom_arc`'s equation,
!>
!>     p = m + ((a1 b2 + a2 b1) g + (b1 b2 - a1 a2) h)/((a1 - b1)(a2 - b2) + (a1 b2 + a2 b1) q)
!>
!> in twofold numbers, so that poles and weights are rounded once.
!>
!> Source: L. Ramshaw, "Blossoms are polar forms", Computer Aided Geometric Design 6 (1989),
!> pp. 323-358; G. Farin, "Curves and Surfaces for CAGD", 5th ed., 12.4.
module geom_arc_spline
    use base_kinds, only: dp
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_bspline, only: bspline_type
    use geom_place, only: at_finish, at_start, place_type
    use geom_subarc, only: place_between
    use geom_twofold, only: exact_sum, operator(*), operator(+), operator(-), operator(/), sqrt, &
        to_real, twofold_type
    implicit none (type, external)
    private

    public :: arc_spline, line_spline

    !> An arc of less weight is parted: its poles would be far off, which some readers of files
    !> take badly. An arc that turns by 157 degrees of a circle has it.
    real(dp), parameter :: least_weight = 0.2_dp
    !> An arc of more weight is parted: a hyperbola of rho above .95.
    real(dp), parameter :: most_weight = 20.0_dp

contains

    !> The spline of an arc, from its start to its finish, both as given; parameter 0 to 1, which is
    !> that of `place_at` where the arc is not parted.
    pure type(bspline_type) function arc_spline(arc) result(s)
        type(arc_type), intent(in) :: arc !! any arc
        type(place_type), allocatable :: places(:)
        type(twofold_type) :: weight
        integer :: pieces, i

        if (arc%is_line) then
            s = line_spline(arc%start, arc%finish)
            return
        end if
        call part_arc(arc, places)
        pieces = size(places) - 1
        s%degree = 2
        allocate (s%knot(2*pieces + 4), s%pole(2, 2*pieces + 1), s%weight(2*pieces + 1))
        s%knot(:3) = 0.0_dp
        s%pole(:, 1) = arc%start
        s%weight = 1.0_dp
        do i = 1, pieces
            s%knot(2*i + 2:2*i + 3) = real(i, dp)/real(pieces, dp)
            weight = shared(arc, places(i), places(i + 1))/sqrt(shared(arc, places(i), places(i))* &
                shared(arc, places(i + 1), places(i + 1)))
            s%weight(2*i) = to_real(weight)
            s%pole(:, 2*i) = pole_between(arc, places(i), places(i + 1))
            s%pole(:, 2*i + 1) = point(arc, places(i + 1))
        end do
        s%knot(2*pieces + 4) = 1.0_dp
    end function arc_spline

    !> The places where an arc is parted, its ends among them: the shoulder, the shoulders of its
    !> halves and so on, as often as the weight asks for.
    pure subroutine part_arc(arc, places)
        type(arc_type), intent(in) :: arc                       !! curved
        type(place_type), allocatable, intent(out) :: places(:) !! in order
        type(place_type), allocatable :: finer(:)
        type(twofold_type) :: fullness
        integer :: i

        places = [at_start, at_finish]
        fullness = arc%fullness
        do while (to_real(fullness) < 1.0_dp + least_weight .or. &
            to_real(fullness) > 1.0_dp + most_weight)
            allocate (finer(2*size(places) - 1))
            finer(1::2) = places
            do i = 1, size(places) - 1
                finer(2*i) = place_between(arc, places(i), places(i + 1))
            end do
            call move_alloc(finer, places)
            fullness = sqrt(0.5_dp*fullness) + 1.0_dp
        end do
    end subroutine part_arc

    !> The pole between two places: the intersection of their tangents.
    pure function pole_between(arc, first, second) result(pole)
        type(arc_type), intent(in) :: arc       !! curved
        type(place_type), intent(in) :: first   !! a place
        type(place_type), intent(in) :: second  !! another
        real(dp) :: pole(2)
        type(twofold_type) :: mixed, apart, way
        integer :: axis

        mixed = first%alpha*second%beta + first%beta*second%alpha
        apart = first%beta*second%beta - first%alpha*second%alpha
        do axis = 1, 2
            way = arc%half(axis) + (mixed*arc%bulge(axis) + apart*arc%half(axis))/ &
                shared(arc, first, second)
            pole(axis) = to_real(exact_sum(arc%start(axis), 0.0_dp) + arc%size*way)
        end do
    end function pole_between

    !> The polar form of the denominator D; of a place with itself D. Above zero for places on one
    !> side of the shoulder, and for the ends where the weight is.
    pure type(twofold_type) function shared(arc, first, second)
        type(arc_type), intent(in) :: arc       !! any arc
        type(place_type), intent(in) :: first   !! a place
        type(place_type), intent(in) :: second  !! another, or the same
        shared = (first%alpha - first%beta)*(second%alpha - second%beta) + &
            (first%alpha*second%beta + first%beta*second%alpha)*arc%fullness
    end function shared

    !> The straight line between two points of any dimension, parameter 0 to 1.
    pure type(bspline_type) function line_spline(p, q) result(s)
        real(dp), intent(in) :: p(:) !! where it begins, deck units
        real(dp), intent(in) :: q(:) !! where it ends, shape as `p`
        s%degree = 1
        allocate (s%knot(4), s%pole(size(p), 2), s%weight(2))
        s%knot = [0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp]
        s%weight = 1.0_dp
        s%pole(:, 1) = p
        s%pole(:, 2) = q
    end function line_spline

end module geom_arc_spline
