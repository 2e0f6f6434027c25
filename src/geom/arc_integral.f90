!> Area and moments swept by an arc as seen from an origin: of the region between the arc and the
!> two straight lines from the origin to its ends, positive where the arc goes round the origin to
!> the left. The arcs of a closed outline sum to the area and the moments it encloses.
!>
!> The region is the triangle of the origin and the chord, and the segment between chord and arc.
!> With the notation of `geom_arc`, the segment is p = m + X h + Y g, its outline
!>
!>     X**2 = (1 - Y q)(1 - Y (q - 2)),    0 <= Y <= 1/q
!>
!> so that its moments follow from four integrals that know only q. With Y q = 1 - s**2 they are
!> smooth for every conic: X = s R, R**2 = (2 + (q - 2) s**2)/q.
!>
!> Source: Green's theorem; the outline follows from X and Y of `geom_arc` by eliminating a : b.
module geom_arc_integral
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_tolerances, only: segment_tolerance
    use geom_arc, only: arc_type
    use geom_integral_set, only: estimate_type, integrand_set_type, integrate_set
    use geom_twofold, only: to_real
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: moments_type, operator(+), swept_by, scaled

    !> Integrals over a region, about an origin.
    type :: moments_type
        real(dp) :: area = 0.0_dp      !! of 1, deck unit**2
        real(dp) :: first(2) = 0.0_dp  !! of x and y, deck unit**3
        real(dp) :: second(3) = 0.0_dp !! of x**2, y**2 and x y, deck unit**4
    end type moments_type

    interface operator(+)
        module procedure sum_of
    end interface operator(+)

    !> The integrands of a segment over s.
    type, extends(integrand_set_type) :: segment_type
        real(dp) :: fullness = 2.0_dp !! q
    contains
        procedure :: at => segment_at
    end type segment_type

contains

    !> Area and moments swept by an arc. Fails with `cause%no_convergence`.
    pure subroutine swept_by(arc, origin, moments, error)
        type(arc_type), intent(in) :: arc                   !! any arc
        real(dp), intent(in) :: origin(2)                   !! deck units
        type(moments_type), intent(out) :: moments          !! about the origin
        type(error_type), allocatable, intent(out) :: error !! see above
        type(moments_type) :: bow

        moments = triangle(arc%start - origin, arc%finish - origin)
        if (arc%is_line) return
        call segment(arc, origin, bow, error)
        moments = moments + bow
    end subroutine swept_by

    !> Moments of the triangle of the origin and two points.
    pure type(moments_type) function triangle(u, v) result(moments)
        real(dp), intent(in) :: u(2) !! first point, from the origin
        real(dp), intent(in) :: v(2) !! second point, from the origin

        moments%area = 0.5_dp*cross(u, v)
        moments%first = moments%area*(u + v)/3.0_dp
        moments%second(:2) = moments%area*(u**2 + u*v + v**2)/6.0_dp
        moments%second(3) = moments%area* &
            (2.0_dp*(u(1)*u(2) + v(1)*v(2)) + u(1)*v(2) + v(1)*u(2))/12.0_dp
    end function triangle

    !> Moments of the segment between the chord and the arc.
    pure subroutine segment(arc, origin, moments, error)
        type(arc_type), intent(in) :: arc                   !! not a line
        real(dp), intent(in) :: origin(2)                   !! deck units
        type(moments_type), intent(out) :: moments          !! about the origin
        type(error_type), allocatable, intent(out) :: error !! `cause%no_convergence`
        type(segment_type) :: f
        type(estimate_type) :: estimate
        real(dp) :: m(2), h(2), g(2), m00, m01, m02, m20, frame

        f%number = 4
        f%fullness = to_real(arc%fullness)
        call integrate_set(f, 0.0_dp, 1.0_dp, segment_tolerance, estimate, error)
        if (allocated(error)) return
        m00 = 2.0_dp*estimate%value(1)/f%fullness
        m01 = 2.0_dp*estimate%value(2)/f%fullness**2
        m02 = 2.0_dp*estimate%value(3)/f%fullness**3
        m20 = 2.0_dp*estimate%value(4)/(3.0_dp*f%fullness)
        h = arc%size*to_real(arc%half)
        g = arc%size*to_real(arc%bulge)
        m = (arc%start - origin) + h
        frame = cross(g, h)
        moments%area = frame*m00
        moments%first = frame*(m*m00 + g*m01)
        moments%second(:2) = frame*(m**2*m00 + 2.0_dp*m*g*m01 + h**2*m20 + g**2*m02)
        moments%second(3) = frame*(m(1)*m(2)*m00 + (m(1)*g(2) + m(2)*g(1))*m01 &
            + h(1)*h(2)*m20 + g(1)*g(2)*m02)
    end subroutine segment

    !> X, (Y q) X, (Y q)**2 X and X**3 with d(Y q) = 2 s ds, at s.
    pure subroutine segment_at(f, t, value, error)
        class(segment_type), intent(in) :: f                !! fullness
        real(dp), intent(in) :: t                           !! s, 0 to 1
        real(dp), intent(out) :: value(:)                   !! shape (4)
        type(error_type), allocatable, intent(out) :: error !! never
        real(dp) :: x, y

        y = (1.0_dp - t)*(1.0_dp + t)
        x = t*sqrt((2.0_dp*y + f%fullness*t**2)/f%fullness)
        value(:4) = 2.0_dp*t*x*[1.0_dp, y, y**2, x**2]
        if (allocated(error)) deallocate (error)
    end subroutine segment_at

    !> The moments of two regions together, about the same origin.
    elemental type(moments_type) function sum_of(a, b)
        type(moments_type), intent(in) :: a !! one region
        type(moments_type), intent(in) :: b !! the other
        sum_of = moments_type(a%area + b%area, a%first + b%first, a%second + b%second)
    end function sum_of

    !> The moments of a region taken so many times: -1 turns its sense round.
    elemental type(moments_type) function scaled(moments, factor)
        type(moments_type), intent(in) :: moments !! any
        real(dp), intent(in) :: factor            !! any number
        scaled = moments_type(factor*moments%area, factor*moments%first, factor*moments%second)
    end function scaled

end module geom_arc_integral
