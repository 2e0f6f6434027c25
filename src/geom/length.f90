!> The length of an arc, and places at given lengths along it.
!>
!> Each half of the arc, from an end to the shoulder, is run through by a parameter s of its own in
!> which its two ends have equal standing: with k = 1/sqrt(2 q) and v1, h, q of `geom_arc`
!>
!>     alpha = r + k s,    beta = k s,    r = 1 - s
!>     |dp/ds| = 2 k |r**2 v1 + 2 r s k (v1 + h) + s**2 h|/(r**2 + r s/k + s**2)**2
!>
!> so that an almost whole ellipse is as smooth as a quarter. The parameter u of the whole arc is
!> -1 at the start, 0 at the shoulder and 1 at the finish.
!>
!> Source: G. Farin, "Curves and Surfaces for CAGD", 5th ed., 12.4 (subdivision of a conic at its
!> shoulder and return to standard form).
module geom_length
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use base_tolerances, only: quadrature_tolerance
    use geom_arc, only: arc_type, reversed
    use geom_place, only: at_finish, at_start, mirrored, place_type
    use geom_quadrature, only: integrand_type, integrate
    use geom_twofold, only: operator(+), to_real, twofold
    implicit none (type, external)
    private

    public :: arc_length, places_by_length

    !> The speed |dp/ds| on the first half of an arc.
    type, extends(integrand_type) :: speed_type
        real(dp) :: leaving(2) = 0.0_dp  !! v1, deck units
        real(dp) :: turning(2) = 0.0_dp  !! k (v1 + h), deck units
        real(dp) :: half(2) = 0.0_dp     !! h, half the chord, deck units
        real(dp) :: scale = 0.5_dp       !! k
    contains
        procedure :: at => speed_at
    end type speed_type

    !> The speeds on both halves of an arc, each from its end to the shoulder.
    type :: pace_type
        type(speed_type) :: first  !! from the start
        type(speed_type) :: second !! from the finish
    end type pace_type

    !> Newton steps and halvings that place one point; each halving gains a bit of the parameter.
    integer, parameter :: most_steps = 100

contains

    !> The length of an arc. Fails with `cause%no_convergence`, from quadrature.
    pure subroutine arc_length(arc, length, error)
        type(arc_type), intent(in) :: arc                   !! any arc
        real(dp), intent(out) :: length                     !! deck units
        type(error_type), allocatable, intent(out) :: error !! see above
        call length_between(pace_of(arc), -1.0_dp, 1.0_dp, length, error)
    end subroutine arc_length

    !> Places at equal lengths along an arc, both ends included.
    !> Fails with `cause%no_convergence`.
    pure subroutine places_by_length(arc, number, places, error)
        type(arc_type), intent(in) :: arc                          !! any arc
        integer, intent(in) :: number                              !! how many, 2 or more
        type(place_type), allocatable, intent(out) :: places(:)    !! in order, shape (number)
        type(error_type), allocatable, intent(out) :: error        !! see above
        type(pace_type) :: pace
        real(dp) :: length, u, done
        integer :: i

        allocate (places(number))
        pace = pace_of(arc)
        call length_between(pace, -1.0_dp, 1.0_dp, length, error)
        if (allocated(error)) return
        places(1) = at_start
        places(number) = at_finish
        u = -1.0_dp
        done = 0.0_dp
        do i = 2, number - 1
            call advance(pace, length, length*real(i - 1, dp)/real(number - 1, dp), u, done, error)
            if (allocated(error)) return
            places(i) = place_of(pace, u)
        end do
    end subroutine places_by_length

    !> Goes on along an arc until a length from the start is reached: Newton's method, kept between
    !> the nearest places known to be before and after.
    pure subroutine advance(pace, total, length, u, done, error)
        type(pace_type), intent(in) :: pace                 !! speeds on the arc
        real(dp), intent(in) :: total                       !! length of the arc, deck units
        real(dp), intent(in) :: length                      !! length wanted, deck units
        real(dp), intent(inout) :: u                        !! parameter reached
        real(dp), intent(inout) :: done                     !! length reached, deck units
        type(error_type), allocatable, intent(out) :: error !! `cause%no_convergence`
        real(dp) :: before, after, next, part
        integer :: i

        before = u
        after = 1.0_dp
        do i = 1, most_steps
            if (abs(length - done) <= quadrature_tolerance*total) return
            if (done < length) before = u
            if (done > length) after = u
            next = u + (length - done)/speed_of(pace, u)
            if (.not. (next > before .and. next < after)) next = 0.5_dp*(before + after)
            call length_between(pace, u, next, part, error)
            if (allocated(error)) return
            done = done + part
            u = next
        end do
        call fail(error, cause%no_convergence, 'no place found at length '//compact(length)// &
            ' of an arc of length '//compact(total))
    end subroutine advance

    !> The length from one parameter to another, negative where it goes back.
    pure subroutine length_between(pace, from, to, length, error)
        type(pace_type), intent(in) :: pace                 !! speeds on the arc
        real(dp), intent(in) :: from                        !! parameter u, -1 to 1
        real(dp), intent(in) :: to                          !! parameter u, -1 to 1
        real(dp), intent(out) :: length                     !! deck units
        type(error_type), allocatable, intent(out) :: error !! from quadrature
        real(dp) :: part

        call integrate(pace%first, 1.0_dp + min(from, 0.0_dp), 1.0_dp + min(to, 0.0_dp), &
            quadrature_tolerance, length, error)
        if (allocated(error)) return
        call integrate(pace%second, 1.0_dp - max(to, 0.0_dp), 1.0_dp - max(from, 0.0_dp), &
            quadrature_tolerance, part, error)
        length = length + part
    end subroutine length_between

    !> The speeds on both halves of an arc.
    pure type(pace_type) function pace_of(arc) result(pace)
        type(arc_type), intent(in) :: arc !! any arc
        pace%first = speed_from_start(arc)
        pace%second = speed_from_start(reversed(arc))
    end function pace_of

    !> The speed on the first half of an arc.
    pure type(speed_type) function speed_from_start(arc) result(speed)
        type(arc_type), intent(in) :: arc !! any arc
        speed%scale = 1.0_dp/sqrt(2.0_dp*to_real(arc%fullness))
        speed%leaving = arc%size*to_real(arc%leaving)
        speed%turning = arc%size*speed%scale*to_real(arc%leaving + arc%half)
        speed%half = arc%size*to_real(arc%half)
    end function speed_from_start

    !> |dp/ds| at s, deck units.
    pure real(dp) function speed_at(f, t) result(speed)
        class(speed_type), intent(in) :: f !! first half of an arc
        real(dp), intent(in) :: t          !! the half's parameter s, 0 to 1
        real(dp) :: r, denominator

        r = 1.0_dp - t
        denominator = r**2 + r*t/f%scale + t**2
        speed = 2.0_dp*f%scale/denominator**2 &
            *norm2(r**2*f%leaving + 2.0_dp*r*t*f%turning + t**2*f%half)
    end function speed_at

    !> |dp/du| at u, deck units.
    pure real(dp) function speed_of(pace, u) result(speed)
        type(pace_type), intent(in) :: pace !! speeds on the arc
        real(dp), intent(in) :: u           !! parameter, -1 to 1
        if (u < 0.0_dp) speed = pace%first%at(1.0_dp + u)
        if (u >= 0.0_dp) speed = pace%second%at(1.0_dp - u)
    end function speed_of

    !> The place of a parameter.
    pure type(place_type) function place_of(pace, u) result(place)
        type(pace_type), intent(in) :: pace !! speeds on the arc
        real(dp), intent(in) :: u           !! parameter, -1 to 1
        real(dp) :: share

        share = pace%first%scale*(1.0_dp - abs(u))
        place = place_type(twofold(abs(u)) + share, twofold(share))
        if (u > 0.0_dp) place = mirrored(place)
    end function place_of

end module geom_length
