!> The conic of an arc in its standard position: about its centre (a parabola about its vertex),
!> along its axes.
!>
!>     ellipse     x**2/a**2 + y**2/b**2 = 1     x along the longer axis; a circle has b = a
!>     hyperbola   x**2/a**2 - y**2/b**2 = 1     x towards the branch of the arc
!>     parabola    y**2 = a x                    x into the opening
!>
!> In the notation of `geom_arc`, with p = m + X h + Y g, the arc fulfils
!>
!>     X**2 + (1 - w**2) Y**2 + 2 w Y = 1
!>
!> so that h/sqrt|1 - w**2| and g/|1 - w**2| are conjugate half diameters about m - w g/(1 - w**2);
!> the principal ones are those that are at right angles (Rytz's problem, worked out here).
module geom_conic_axes
    use base_kinds, only: dp
    use base_tolerances, only: type_tolerance
    use geom_arc, only: arc_type, weight
    use geom_conic, only: conic_kind
    use geom_twofold, only: operator(*), operator(-), to_real, twofold
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: axes_type, axes_of, to_axes, coefficients_of, distance_from_axes, reach_of

    !> A conic in its standard position, and where that is.
    type :: axes_type
        integer :: kind = 0                 !! ellipse (circles too), parabola, hyperbola or line
        real(dp) :: origin(2) = 0.0_dp      !! centre or vertex, deck units
        real(dp) :: x(2) = 0.0_dp           !! unit vector of the x axis
        real(dp) :: y(2) = 0.0_dp           !! unit vector of the y axis: left or right of x, such
                                            !! that the arc of an ellipse runs from x to y, others
                                            !! on along y
        real(dp) :: a = 0.0_dp              !! half axis along x; of a parabola see above
        real(dp) :: b = 0.0_dp              !! half axis along y
    end type axes_type

contains

    !> The axes of an arc's conic; of a line only the kind.
    pure type(axes_type) function axes_of(arc) result(axes)
        type(arc_type), intent(in) :: arc !! any arc
        real(dp) :: middle(2), half(2), bulge(2)

        axes%kind = conic_kind%line
        if (arc%is_line) return
        half = arc%size*to_real(arc%half)
        bulge = arc%size*to_real(arc%bulge)
        middle = arc%start + half
        if (abs(weight(arc) - 1.0_dp) <= type_tolerance) then
            axes = parabola(middle, half, bulge)
        else
            axes = central(middle, half, bulge, weight(arc), to_real(arc%fullness*(twofold( &
                2.0_dp) - arc%fullness)))
        end if
    end function axes_of

    !> A parabola: its vertex is where the tangent is across g.
    pure type(axes_type) function parabola(middle, half, bulge) result(axes)
        real(dp), intent(in) :: middle(2)   !! of the chord, deck units
        real(dp), intent(in) :: half(2)     !! half the chord
        real(dp), intent(in) :: bulge(2)    !! g
        real(dp) :: at, across(2)

        at = dot_product(half, bulge)/dot_product(bulge, bulge)
        across = half - at*bulge
        axes%kind = conic_kind%parabola
        axes%origin = middle + at*half + 0.5_dp*(1.0_dp - at**2)*bulge
        axes%x = -bulge/norm2(bulge)
        axes%y = [-axes%x(2), axes%x(1)]
        if (dot_product(axes%y, across) < 0.0_dp) axes%y = -axes%y
        axes%a = 2.0_dp*dot_product(across, across)/norm2(bulge)
    end function parabola

    !> An ellipse or a hyperbola: its principal half axes from two conjugate ones.
    pure type(axes_type) function central(middle, half, bulge, w, rest) result(axes)
        real(dp), intent(in) :: middle(2)   !! of the chord, deck units
        real(dp), intent(in) :: half(2)     !! half the chord
        real(dp), intent(in) :: bulge(2)    !! g
        real(dp), intent(in) :: w           !! weight, not 1
        real(dp), intent(in) :: rest        !! 1 - w**2
        real(dp) :: p(2), q(2), turn, major(2)

        p = half/sqrt(abs(rest))
        q = bulge/rest
        axes%origin = middle - w*q
        if (rest > 0.0_dp) then
            axes%kind = conic_kind%ellipse
            turn = 0.5_dp*atan2(2.0_dp*dot_product(p, q), dot_product(p, p) - dot_product(q, q))
            major = cos(turn)*p + sin(turn)*q
        else
            axes%kind = conic_kind%hyperbola
            turn = 0.5_dp*atanh(-2.0_dp*dot_product(p, q)/(dot_product(p, p) + dot_product(q, q)))
            major = cosh(turn)*q + sinh(turn)*p
        end if
        axes%a = norm2(major)
        axes%b = abs(cross(p, q))/axes%a
        if (abs(axes%a - axes%b) <= type_tolerance*axes%a) axes%b = axes%a
        axes%x = major/axes%a
        axes%y = [-axes%x(2), axes%x(1)]
        ! An arc that turns left goes around the centre of its ellipse to the left, but around the
        ! centre of its hyperbola to the right.
        if (cross(bulge, half)*rest < 0.0_dp) axes%y = -axes%y
    end function central

    !> A point along the axes.
    pure function to_axes(axes, point) result(at)
        type(axes_type), intent(in) :: axes !! of a curved arc
        real(dp), intent(in) :: point(2)    !! deck units
        real(dp) :: at(2)
        at = [dot_product(axes%x, point - axes%origin), dot_product(axes%y, point - axes%origin)]
    end function to_axes

    !> A to F of `A x**2 + B x y + C y**2 + D x + E y + F = 0` along the axes.
    pure function coefficients_of(axes) result(form)
        type(axes_type), intent(in) :: axes !! of a curved arc
        real(dp) :: form(6)

        form = 0.0_dp
        if (axes%kind == conic_kind%parabola) then
            form([3, 4]) = [1.0_dp, -axes%a]
        else
            form([1, 3, 6]) = [1.0_dp/axes%a**2, 1.0_dp/axes%b**2, -1.0_dp]
            if (axes%kind == conic_kind%hyperbola) form(3) = -form(3)
        end if
    end function coefficients_of

    !> The distance of a near point from the conic to first order, deck units.
    pure real(dp) function distance_from_axes(axes, point) result(distance)
        type(axes_type), intent(in) :: axes !! of a curved arc
        real(dp), intent(in) :: point(2)    !! deck units, not the centre
        real(dp) :: at(2), form(6)

        at = to_axes(axes, point)
        form = coefficients_of(axes)
        distance = abs(form(1)*at(1)**2 + form(3)*at(2)**2 + form(4)*at(1) + form(6))/ &
            norm2([2.0_dp*form(1)*at(1) + form(4), 2.0_dp*form(3)*at(2)])
    end function distance_from_axes

    !> How far the conic's own numbers reach from the chord, in parts of it: a reader rounds with
    !> them. Centres and axes that are far away make this large.
    pure real(dp) function reach_of(axes, arc) result(reach)
        type(axes_type), intent(in) :: axes !! of the arc
        type(arc_type), intent(in) :: arc   !! curved
        reach = max(norm2(axes%origin - arc%start), axes%a, axes%b)/norm2(arc%finish - arc%start)
    end function reach_of

end module geom_conic_axes
