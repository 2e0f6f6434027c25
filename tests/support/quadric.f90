!> Surfaces of the second degree along the axes, in closed form: what a cut of them must be.
!>
!>     F(p) = sum of square(i) q(i)**2 + plain(i) q(i) + constant,   q = p - centre
!>
!> F is below zero inside. Source: any book of analytic geometry; E. Goursat, "A Course in
!> Mathematical Analysis", for the curvature of a curve given as F = 0.
module support_quadric
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: quadric_type, ellipsoid, sphere, paraboloid, cone
    public :: off_surface, normal_of, cut_tangent, cut_curvature, perimeter

    !> A surface.
    type :: quadric_type
        real(dp) :: centre(3) = 0.0_dp      !! STA, BL, WL, deck units
        real(dp) :: square(3) = 0.0_dp      !! of q**2
        real(dp) :: plain(3) = 0.0_dp       !! of q
        real(dp) :: constant = 0.0_dp       !! of 1
    end type quadric_type

    !> `cards/ellipsoid.crd`: half axes 100, 60 and 50.
    type(quadric_type), parameter :: ellipsoid = quadric_type([120.0_dp, 0.0_dp, 30.0_dp], &
        1.0_dp/[100.0_dp, 60.0_dp, 50.0_dp]**2, 0.0_dp, -1.0_dp)
    !> `cards/sphere.crd`: radius 50.
    type(quadric_type), parameter :: sphere = quadric_type([50.0_dp, 0.0_dp, 0.0_dp], &
        1.0_dp/50.0_dp**2, 0.0_dp, -1.0_dp)
    !> `cards/paraboloid.crd`: half-breadth 40 and half-height 30 at the open end, 100 long.
    type(quadric_type), parameter :: paraboloid = quadric_type([-25.0_dp, 0.0_dp, 0.0_dp], &
        [0.0_dp, 1.0_dp/1600.0_dp, 1.0_dp/900.0_dp], [-0.01_dp, 0.0_dp, 0.0_dp], 0.0_dp)
    !> `cards/cone.crd`: half-breadth 30 and half-height 20 at the open end, 100 long.
    type(quadric_type), parameter :: cone = quadric_type([0.0_dp, 0.0_dp, 10.0_dp], &
        [-1.0e-4_dp, 1.0_dp/900.0_dp, 1.0_dp/400.0_dp], 0.0_dp, 0.0_dp)

contains

    !> Its gradient at a point, outward.
    pure function gradient(quadric, at)
        type(quadric_type), intent(in) :: quadric   !! the surface
        real(dp), intent(in) :: at(3)               !! STA, BL, WL, deck units
        real(dp) :: gradient(3)
        gradient = 2.0_dp*quadric%square*(at - quadric%centre) + quadric%plain
    end function gradient

    !> The distance of a point near to the surface from it, deck units.
    pure real(dp) function off_surface(quadric, at)
        type(quadric_type), intent(in) :: quadric   !! the surface
        real(dp), intent(in) :: at(3)               !! STA, BL, WL, deck units
        real(dp) :: q(3)
        q = at - quadric%centre
        off_surface = (dot_product(quadric%square*q + quadric%plain, q) + quadric%constant) &
            /norm2(gradient(quadric, at))
    end function off_surface

    !> The outward unit normal at a point of it.
    pure function normal_of(quadric, at) result(normal)
        type(quadric_type), intent(in) :: quadric   !! the surface
        real(dp), intent(in) :: at(3)               !! STA, BL, WL, deck units
        real(dp) :: normal(3)
        normal = gradient(quadric, at)
        normal = normal/norm2(normal)
    end function normal_of

    !> The unit tangent of a plane cut, to one side or the other.
    pure function cut_tangent(quadric, at, across) result(along)
        type(quadric_type), intent(in) :: quadric   !! the surface
        real(dp), intent(in) :: at(3)               !! STA, BL, WL, deck units
        real(dp), intent(in) :: across(3)           !! normal of the plane
        real(dp) :: along(3)
        along = cross(across, normal_of(quadric, at))
        along = along/norm2(along)
    end function cut_tangent

    !> The curvature of a plane cut, positive where it turns towards `left`.
    pure real(dp) function cut_curvature(quadric, at, along, left) result(curvature)
        type(quadric_type), intent(in) :: quadric   !! the surface
        real(dp), intent(in) :: at(3)               !! STA, BL, WL, deck units
        real(dp), intent(in) :: along(3)            !! unit tangent of the cut
        real(dp), intent(in) :: left(3)             !! unit vector in the plane, across the tangent
        curvature = -2.0_dp*sum(quadric%square*along**2)/dot_product(gradient(quadric, at), left)
    end function cut_curvature

    !> The length of an ellipse by its half axes, through the arithmetic-geometric mean.
    !>
    !> Source: M. Abramowitz, I. A. Stegun, "Handbook of Mathematical Functions", 17.6.
    pure real(dp) function perimeter(half_axes)
        real(dp), intent(in) :: half_axes(2) !! above zero
        real(dp), parameter :: pi = acos(-1.0_dp)
        real(dp) :: a, b, c, power, rest
        integer :: i

        a = maxval(half_axes)
        b = minval(half_axes)
        rest = a**2 - 0.5_dp*(a**2 - b**2)
        power = 0.5_dp
        do i = 1, 12
            c = 0.5_dp*(a - b)
            b = sqrt(a*b)
            a = a - c
            power = 2.0_dp*power
            rest = rest - power*c**2
        end do
        perimeter = 2.0_dp*pi*rest/a
    end function perimeter

    !> The vector product.
    pure function cross(a, b)
        real(dp), intent(in) :: a(3) !! any vector
        real(dp), intent(in) :: b(3) !! another
        real(dp) :: cross(3)
        cross = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
    end function cross

end module support_quadric
