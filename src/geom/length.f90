!> The length of an arc, and places at given lengths along it.
!>
!> Each half of the arc, from an end to the shoulder, is run through by a parameter s of its own in
!> which its two ends have equal standing: with k = 1/sqrt(2 q) and v1, h, q of `geom_arc`
!>
!>     alpha = r + k s,    beta = k s,    r = 1 - s
!>     |dp/ds| = 2 k |r**2 v1 + 2 r s k (v1 + h) + s**2 h|/(r**2 + r s/k + s**2)**2
!>
!> so that an almost whole ellipse is as smooth as a quarter.
!>
!> Source: G. Farin, "Curves and Surfaces for CAGD", 5th ed., 12.4 (subdivision of a conic at its
!> shoulder and return to standard form).
module geom_length
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_tolerances, only: quadrature_tolerance, series_tolerance
    use geom_arc, only: arc_type, reversed
    use geom_place, only: at_finish, at_start, mirrored, place_type
    use geom_quadrature, only: integrand_type, integrate
    use geom_spacing, only: new_scale, parameters_at, scale_type
    use geom_twofold, only: exact_sum, operator(+), to_real, twofold
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
        procedure :: values => put_speeds
    end type speed_type

    !> The speeds on both halves of an arc, each from its end to the shoulder.
    type :: pace_type
        type(speed_type) :: first  !! from the start
        type(speed_type) :: second !! from the finish
    end type pace_type

contains

    !> The length of an arc. Fails with `cause%no_convergence`, from quadrature.
    pure subroutine arc_length(arc, length, error)
        type(arc_type), intent(in) :: arc                   !! any arc
        real(dp), intent(out) :: length                     !! deck units
        type(error_type), allocatable, intent(out) :: error !! see above
        type(pace_type) :: pace
        real(dp) :: rest

        pace = pace_of(arc)
        call integrate(pace%first, 0.0_dp, 1.0_dp, quadrature_tolerance, length, error)
        if (allocated(error)) return
        call integrate(pace%second, 0.0_dp, 1.0_dp, quadrature_tolerance, rest, error)
        length = length + rest
    end subroutine arc_length

    !> Places at equal lengths along an arc, both ends included: on each half by the length from its
    !> end. Fails with `cause%no_convergence`.
    pure subroutine places_by_length(arc, number, places, error)
        type(arc_type), intent(in) :: arc                          !! any arc
        integer, intent(in) :: number                              !! how many, 2 or more
        type(place_type), allocatable, intent(out) :: places(:)    !! in order, shape (number)
        type(error_type), allocatable, intent(out) :: error        !! see above
        type(pace_type) :: pace
        type(scale_type) :: first, second
        real(dp) :: apart
        integer :: before

        allocate (places(number))
        pace = pace_of(arc)
        call new_scale(pace%first, [0.0_dp, 1.0_dp], series_tolerance, first, error)
        if (allocated(error)) return
        call new_scale(pace%second, [0.0_dp, 1.0_dp], series_tolerance, second, error)
        if (allocated(error)) return
        apart = (first%length + second%length)/real(number - 1, dp)
        before = min(number, 1 + floor(first%length/apart))
        call places_from_end(pace%first, first, apart, places(:before))
        call places_from_end(pace%second, second, apart, places(number:before + 1:-1))
        places(before + 1:) = mirrored(places(before + 1:))
    end subroutine places_by_length

    !> Places at equal lengths on a half of an arc, from its end on.
    pure subroutine places_from_end(speed, scale, apart, places)
        type(speed_type), intent(in) :: speed           !! on the half
        type(scale_type), intent(in) :: scale           !! its parameter over its length
        real(dp), intent(in) :: apart                   !! from place to place, deck units
        type(place_type), intent(inout) :: places(:)    !! see above; the first is the end
        real(dp), allocatable :: length(:), s(:)
        real(dp) :: share
        integer :: i

        allocate (length(size(places)), s(size(places)))
        do i = 1, size(places)
            length(i) = apart*real(i - 1, dp)
        end do
        call parameters_at(scale, length, s)
        if (size(places) > 0) places(1) = at_start
        do i = 2, size(places)
            share = speed%scale*s(i)
            places(i) = place_type(exact_sum(1.0_dp - s(i), share), twofold(share))
        end do
    end subroutine places_from_end

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
        real(dp) :: speeds(1)
        call put_speeds(f, [t], speeds)
        speed = speeds(1)
    end function speed_at

    !> |dp/ds| at many s, deck units.
    pure subroutine put_speeds(f, t, value)
        class(speed_type), intent(in) :: f      !! first half of an arc
        real(dp), intent(in) :: t(:)            !! the half's parameters s, 0 to 1
        real(dp), intent(out) :: value(:)       !! the speeds, one for each
        real(dp) :: r, denominator, run, rise
        integer :: i

        associate (v1 => f%leaving, turning => f%turning, h => f%half, k => f%scale)
            do i = 1, size(t)
                r = 1.0_dp - t(i)
                denominator = r**2 + r*t(i)/k + t(i)**2
                run = r**2*v1(1) + 2.0_dp*r*t(i)*turning(1) + t(i)**2*h(1)
                rise = r**2*v1(2) + 2.0_dp*r*t(i)*turning(2) + t(i)**2*h(2)
                value(i) = 2.0_dp*k/denominator**2*norm2([run, rise])
            end do
        end associate
    end subroutine put_speeds

end module geom_length
