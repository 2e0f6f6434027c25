!> Whether a curve in a plane is one arc of a conic, or a straight line: the conic with its ends,
!> its end tangents and one of its points either has all its points, but for rounding, or is another
!> curve.
module export_drawing_conic
    use base_error, only: error_type
    use base_exact, only: is_equal, is_zero
    use base_kinds, only: dp
    use export_drawing_path, only: path_type
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use geom_arc_point, only: point
    use geom_place, only: at_shoulder
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: find_conic, distance_off

    !> Stretches into which a curve is divided to be looked at, a prime number; and how many of them
    !> the next point is ahead.
    integer, parameter :: steps = 37, stride = 14

contains

    !> Finds the arc that a curve is.
    pure subroutine find_conic(path, noise, arc, largest, is_found)
        class(path_type), intent(in) :: path    !! in the plane of the first two coordinates
        real(dp), intent(in) :: noise           !! distance that is but rounding, deck units
        type(arc_type), intent(out) :: arc      !! where it is found; runs as the curve
        real(dp), intent(out) :: largest        !! distance of a point from it, deck units
        logical, intent(out) :: is_found        !! the curve is this arc
        type(error_type), allocatable :: error
        real(dp) :: start(3), finish(3), first(3), last(3), middle(3)

        start = path%at(0.0_dp)
        finish = path%at(1.0_dp)
        largest = 0.0_dp
        is_found = .not. all(is_equal(start, finish))
        if (.not. is_found) return
        arc = line_between(start(:2), finish(:2))
        call judge(path, noise, arc, largest, is_found)
        if (is_found) return
        first = path%way(0.0_dp)
        last = path%way(1.0_dp)
        if (all(is_zero(first)) .or. all(is_zero(last))) return
        middle = path%at(0.5_dp)
        call arc_through(end_type(start(:2), first(:2)), middle(:2), &
            end_type(finish(:2), last(:2)), arc, error)
        if (.not. allocated(error)) call judge(path, noise, arc, largest, is_found)
    end subroutine find_conic

    !> Sees whether points of a curve are on an arc, those far from each other first.
    pure subroutine judge(path, noise, arc, largest, is_on)
        class(path_type), intent(in) :: path    !! the curve
        real(dp), intent(in) :: noise           !! distance that is but rounding, deck units
        type(arc_type), intent(in) :: arc       !! perhaps the same
        real(dp), intent(out) :: largest        !! distance of a point from it, deck units
        logical, intent(out) :: is_on           !! they are on it
        real(dp) :: at(3)
        integer :: i

        is_on = .false.
        largest = 0.0_dp
        do i = 1, steps - 1
            at = path%at(real(mod(stride*i, steps), dp)/real(steps, dp))
            largest = max(largest, distance_off(arc, at(:2)))
            if (largest > noise) return
            if (.not. arc%is_line) cycle
            if (dot_product(at(:2) - arc%start, arc%start_tangent) < 0.0_dp) return
            if (dot_product(arc%finish - at(:2), arc%start_tangent) < 0.0_dp) return
        end do
        is_on = .true.
    end subroutine judge

    !> The distance of a point near to the conic of an arc from it, to the first order: F/|grad F|
    !> with F the conic through start, finish and shoulder S with both end tangents,
    !>
    !>     F(p) = (p1 x c)**2 (s1 x t1)(s3 x t3) - (p1 x t1)(p3 x t3)(s1 x c)**2
    !>
    !> where p1, p3 are the ways to p from start and finish, s1, s3 those to S, and c is the chord.
    !> Source: R. A. Liming, "Practical Analytic Geometry with Applications to Aircraft", 1944,
    !> chapter 4.
    pure real(dp) function distance_off(arc, at) result(distance)
        type(arc_type), intent(in) :: arc   !! any arc
        real(dp), intent(in) :: at(2)       !! a point, deck units
        real(dp), dimension(2) :: chord, top, from, to, gradient
        real(dp) :: shoulder, tangents, value

        chord = arc%finish - arc%start
        from = (at - arc%start)/arc%size
        if (arc%is_line) then
            distance = abs(cross(from, chord))/norm2(chord)*arc%size
            return
        end if
        chord = chord/arc%size
        to = (at - arc%finish)/arc%size
        top = point(arc, at_shoulder)
        associate (t1 => arc%start_tangent, t3 => arc%finish_tangent, c => chord)
            tangents = cross((top - arc%start)/arc%size, t1)*cross((top - arc%finish)/arc%size, t3)
            shoulder = cross((top - arc%start)/arc%size, c)**2
            value = cross(from, c)**2*tangents - cross(from, t1)*cross(to, t3)*shoulder
            gradient = 2.0_dp*cross(from, c)*tangents*across(c) &
                - shoulder*(across(t1)*cross(to, t3) + cross(from, t1)*across(t3))
        end associate
        distance = abs(value)/norm2(gradient)*arc%size
    contains
        !> The gradient of p x d over p.
        pure function across(d)
            real(dp), intent(in) :: d(2) !! a direction
            real(dp) :: across(2)
            across = [d(2), -d(1)]
        end function across
    end function distance_off

end module export_drawing_conic
