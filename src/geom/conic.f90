!> The conic of an arc as a general equation, with the arc's first point as origin:
!>
!>     A x**2 + B x y + C y**2 + D x + E y + F = 0,     F = 0, largest magnitude 1
!>
!> With c the chord and v1, v3 the end tangents of `geom_arc`, x the product `cross`, it is
!>
!>     (p x c)**2 = 4 (p x v1)((p - c) x v3)
!>
!> (the pencil of conics that touch two lines where a third meets them: R. A. Liming, "Practical
!> Analytic Geometry with Applications to Aircraft", 1944, ch. 4).
module geom_conic
    use base_exact, only: is_zero
    use base_kinds, only: dp, i64
    use base_tolerances, only: type_tolerance, ulp
    use geom_arc, only: arc_type, weight
    use geom_twofold, only: operator(*), operator(+), operator(-), operator(/), to_real, &
        twofold_type
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: conic_type, conic_of, value_at, distance_from, roots_at, kind_name

    !> The kinds of conic.
    type, public :: kind_list
        integer :: ellipse = 1   !! weight below 1
        integer :: circle = 2    !! an ellipse with equal axes
        integer :: parabola = 3  !! weight 1
        integer :: hyperbola = 4 !! weight above 1
        integer :: line = 5      !! a straight line
    end type kind_list

    !> The kinds by name: `case (conic_kind%parabola)`.
    type(kind_list), parameter, public :: conic_kind = kind_list()
    !> The kinds in words.
    character(9), parameter :: kind_names(5) = &
        [character(9) :: 'ellipse', 'circle', 'parabola', 'hyperbola', 'line']

    !> A general equation of the second degree about an origin.
    type :: conic_type
        real(dp) :: origin(2) = 0.0_dp      !! the arc's first point, deck units
        real(dp) :: coefficient(6) = 0.0_dp !! A to F; A, B, C 1/unit**2, D, E 1/unit, to a scale
        integer :: kind = 0                 !! one of `conic_kind%...`
    end type conic_type

    !> A coefficient this small beside the largest is what cancelling terms left, and is zero.
    real(dp), parameter :: cancelled = ulp*type_tolerance

contains

    !> The conic that an arc is part of.
    pure type(conic_type) function conic_of(arc) result(conic)
        type(arc_type), intent(in) :: arc !! any arc
        type(twofold_type) :: form(5), c(2)

        conic%origin = arc%start
        associate (v1 => arc%leaving, v3 => arc%arriving)
            c(1) = 2.0_dp*arc%half(1)
            c(2) = 2.0_dp*arc%half(2)
            if (arc%is_line) then
                form(4:5) = [c(2), -c(1)]
            else
                form(1) = c(2)*c(2) - 4.0_dp*(v1(2)*v3(2))
                form(2) = 4.0_dp*(v1(2)*v3(1) + v1(1)*v3(2)) - 2.0_dp*(c(1)*c(2))
                form(3) = c(1)*c(1) - 4.0_dp*(v1(1)*v3(1))
                form(4) = 4.0_dp*(v1(2)*cross(c, v3))
                form(5) = -(4.0_dp*(v1(1)*cross(c, v3)))
            end if
        end associate
        conic%kind = kind_of(weight(arc), to_real(form(:3)))
        if (arc%is_line) conic%kind = conic_kind%line
        where (abs(form%high) <= cancelled*maxval(abs(form%high))) form = twofold_type()
        form(4) = arc%size*form(4)
        form(5) = arc%size*form(5)
        conic%coefficient(:5) = to_real(form/form(maxloc(abs(form%high), dim=1)))
    end function conic_of

    !> What a conic of a weight and of quadratic terms A, B, C is.
    pure integer function kind_of(w, form) result(kind)
        real(dp), intent(in) :: w       !! weight of the arc
        real(dp), intent(in) :: form(3) !! A, B, C
        if (abs(w - 1.0_dp) <= type_tolerance) then
            kind = conic_kind%parabola
        else if (w > 1.0_dp) then
            kind = conic_kind%hyperbola
        else if (norm2([form(1) - form(3), form(2)]) <= type_tolerance*abs(form(1) + form(3))) then
            kind = conic_kind%circle
        else
            kind = conic_kind%ellipse
        end if
    end function kind_of

    !> The word for a kind of conic.
    pure function kind_name(kind) result(name)
        integer, intent(in) :: kind !! one of `conic_kind%...`
        character(len_trim(kind_names(kind), i64)) :: name
        name = kind_names(kind)
    end function kind_name

    !> The left side of the general equation: the residual of a point of the curve.
    pure real(dp) function value_at(conic, point) result(value)
        type(conic_type), intent(in) :: conic !! any conic
        real(dp), intent(in) :: point(2)      !! x and y, deck units
        real(dp) :: x, y

        x = point(1) - conic%origin(1)
        y = point(2) - conic%origin(2)
        associate (k => conic%coefficient)
            value = x*(k(1)*x + k(2)*y + k(4)) + y*(k(3)*y + k(5)) + k(6)
        end associate
    end function value_at

    !> The distance of a near point from a conic to first order, |F|/|grad F|, deck units.
    pure real(dp) function distance_from(conic, point) result(distance)
        type(conic_type), intent(in) :: conic !! any conic
        real(dp), intent(in) :: point(2)      !! x and y, deck units, not the centre of the conic
        real(dp) :: x, y, gradient(2)

        x = point(1) - conic%origin(1)
        y = point(2) - conic%origin(2)
        associate (k => conic%coefficient)
            gradient = [2.0_dp*k(1)*x + k(2)*y + k(4), k(2)*x + 2.0_dp*k(3)*y + k(5)]
        end associate
        distance = abs(value_at(conic, point))
        if (.not. is_zero(distance)) distance = distance/norm2(gradient)
    end function distance_from

    !> Both ordinates y of a conic at an x, the lesser first: the contour and the far root, as the
    !> 1970 tables have them. One where the equation is linear in y, none where the curve does not
    !> reach x.
    pure function roots_at(conic, x) result(roots)
        type(conic_type), intent(in) :: conic !! any conic
        real(dp), intent(in) :: x             !! deck units
        real(dp), allocatable :: roots(:)
        real(dp) :: along, linear, constant, discriminant, sum

        along = x - conic%origin(1)
        associate (k => conic%coefficient)
            linear = k(2)*along + k(5)
            constant = along*(k(1)*along + k(4)) + k(6)
            discriminant = linear**2 - 4.0_dp*k(3)*constant
            roots = [real(dp) ::]
            if (is_zero(k(3))) then
                if (.not. is_zero(linear)) roots = [-constant/linear]
            else if (discriminant >= 0.0_dp) then
                sum = -0.5_dp*(linear + sign(sqrt(discriminant), linear))
                roots = [sum/k(3), sum/k(3)]
                if (.not. is_zero(sum)) roots(2) = constant/sum
                roots = [minval(roots), maxval(roots)]
            end if
        end associate
        roots = conic%origin(2) + roots
    end function roots_at

end module geom_conic
