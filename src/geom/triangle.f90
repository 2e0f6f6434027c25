!> What a card fixes: two ends with their tangents and a shoulder point between them, and where the
!> shoulder point lies in the triangle of the two ends and the intersection of the end tangents.
!> The coordinates are exact as given; everything is taken relative to the start and scaled by a
!> power of two, so that neither a far datum nor a large or small unit costs a figure.
!>
!> With c the chord, s the shoulder point from the start, t1 and t3 the end tangents, x the product
!> `cross`, the barycentric coordinates of the shoulder point are
!>
!>     b2 = (s x t1)/(c x t1)     b0 = ((s - c) x t3)/(t3 x c)     b1 = 1 - b0 - b2
!>
!> Source: R. A. Liming, "Practical Analytic Geometry with Applications to Aircraft", 1944, ch. 4
!> (conic by two tangents and a shoulder point); G. Farin, "Curves and Surfaces for CAGD", 5th ed.,
!> 12.5 (weight of a conic through a point).
module geom_triangle
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_tolerances, only: decimal_noise, slope_resolution, ulp
    use geom_twofold, only: exact_difference, operator(*), operator(+), operator(-), operator(/), &
        sqrt, to_real, twofold, twofold_type
    use geom_vector, only: cross, dot
    implicit none (type, external)
    private

    public :: end_type, triangle_type, new_triangle, rounding
    public :: is_flat, is_straight, has_arc, corner_of

    !> An end of an arc.
    type :: end_type
        real(dp) :: point(2) = 0.0_dp   !! x and y, deck units
        real(dp) :: tangent(2) = 0.0_dp !! any vector along the tangent, either way, not zero
    end type end_type

    !> A control triangle, in units of `size`, relative to its start.
    type :: triangle_type
        type(end_type) :: start                !! as given
        type(end_type) :: finish               !! as given
        real(dp) :: through(2) = 0.0_dp        !! shoulder point as given, deck units
        real(dp) :: size = 1.0_dp              !! a power of two near the length, deck units
        real(dp) :: noise = 0.0_dp             !! what decimals lose in doubles, in `size`
        type(twofold_type) :: chord(2)         !! c, start to finish
        type(twofold_type) :: shoulder(2)      !! s, start to shoulder point
        real(dp) :: t1(2) = 0.0_dp             !! tangent at the start, scaled near 1
        real(dp) :: t3(2) = 0.0_dp             !! tangent at the finish, scaled near 1
        type(twofold_type) :: off_chord        !! s x c
        type(twofold_type) :: off_start        !! s x t1
        type(twofold_type) :: off_finish       !! (s - c) x t3
        type(twofold_type) :: chord_off_start  !! c x t1
        type(twofold_type) :: chord_off_finish !! t3 x c
        type(twofold_type) :: tangents         !! t1 x t3
        logical :: is_within = .false.         !! the shoulder is within both tangents, else no more
        type(twofold_type) :: root             !! sqrt(b0 b2), mean of the shares of the two ends
        type(twofold_type) :: weight           !! of the conic
    end type triangle_type

contains

    !> Measures a control triangle. Its three points must not coincide.
    pure type(triangle_type) function new_triangle(start, shoulder, finish) result(it)
        type(end_type), intent(in) :: start  !! first point and its tangent
        real(dp), intent(in) :: shoulder(2)  !! shoulder point, deck units
        type(end_type), intent(in) :: finish !! last point and its tangent
        real(dp) :: unit

        it%start = start
        it%finish = finish
        it%through = shoulder
        it%chord = exact_difference(finish%point, start%point)
        it%shoulder = exact_difference(shoulder, start%point)
        it%size = power_of_two([to_real(it%chord), to_real(it%shoulder)])
        unit = 1.0_dp/it%size
        it%noise = rounding(start%point, shoulder, finish%point)*unit
        it%chord = scaled(unit, it%chord)
        it%shoulder = scaled(unit, it%shoulder)
        it%t1 = start%tangent/power_of_two(start%tangent)
        it%t3 = finish%tangent/power_of_two(finish%tangent)
        it%off_chord = cross(it%shoulder, it%chord)
        it%off_start = cross(it%shoulder, it%t1)
        it%off_finish = cross(it%shoulder - it%chord, it%t3)
        it%chord_off_start = cross(it%chord, it%t1)
        it%chord_off_finish = -cross(it%chord, it%t3)
        it%tangents = cross(twofold(it%t1), it%t3)
        it%is_within = same_sign(it%off_start, it%chord_off_start) .and. &
            same_sign(it%off_finish, it%chord_off_finish)
        if (it%is_within) call put_weight(it)
    end function new_triangle

    !> The weight of the conic, `w = b1/(2 sqrt(b0 b2))` with b0 and b2 above zero; b1 is
    !> `(s x c)(t1 x t3)/((c x t1)(t3 x c))`, which keeps its figures near zero.
    pure subroutine put_weight(it)
        type(triangle_type), intent(inout) :: it !! its shoulder is within both tangents
        it%root = sqrt(it%off_start/it%chord_off_start)*sqrt(it%off_finish/it%chord_off_finish)
        it%weight = (it%off_chord/it%chord_off_start)*(it%tangents/it%chord_off_finish) &
            /(2.0_dp*it%root)
    end subroutine put_weight

    !> How far points may miss each other, or a line, because binary can't hold their decimals; near
    !> zero, the least number held to full length, for nothing shorter can be measured by ratios.
    pure real(dp) function rounding(first, second, third)
        real(dp), intent(in) :: first(2)  !! a point, deck units
        real(dp), intent(in) :: second(2) !! a point, deck units
        real(dp), intent(in) :: third(2)  !! a point, deck units
        rounding = max(decimal_noise*ulp*maxval(abs([first, second, third])), tiny(1.0_dp))
    end function rounding

    !> The power of two next above the largest magnitude.
    pure real(dp) function power_of_two(values) result(power)
        real(dp), intent(in) :: values(:) !! numbers, not all zero
        power = scale(1.0_dp, exponent(maxval(abs(values))))
    end function power_of_two

    !> A twofold number times a power of two, exactly.
    elemental type(twofold_type) function scaled(power, a)
        real(dp), intent(in) :: power       !! a power of two
        type(twofold_type), intent(in) :: a !! any number
        scaled = twofold_type(power*a%high, power*a%low)
    end function scaled

    !> True where the shoulder point is on the line of the chord, as far as decimals can say.
    pure logical function is_flat(it)
        type(triangle_type), intent(in) :: it !! a control triangle
        is_flat = abs(to_real(it%off_chord)) <= it%noise*norm2(to_real(it%chord))
    end function is_flat

    !> True where all is in one line: the shoulder point between the ends, the end tangents along
    !> the chord, as far as punched decimals can say.
    pure logical function is_straight(it)
        type(triangle_type), intent(in) :: it !! a control triangle
        real(dp) :: length, along

        length = norm2(to_real(it%chord))
        along = to_real(dot(it%shoulder, it%chord))
        is_straight = is_flat(it) .and. along > 0.0_dp .and. along < length**2 &
            .and. is_along(it%chord_off_start, it%t1) .and. is_along(it%chord_off_finish, it%t3)
    contains
        !> True where a tangent has the chord's direction within the last decimal of a slope.
        pure logical function is_along(product, tangent)
            type(twofold_type), intent(in) :: product !! chord x tangent, either sign
            real(dp), intent(in) :: tangent(2)        !! the tangent
            is_along = abs(to_real(product)) <= slope_resolution*length*norm2(tangent)
        end function is_along
    end function is_straight

    !> True where a single conic arc joins the ends through the shoulder point: the shoulder point
    !> is off the chord, within both end tangents, and on the same branch as the ends.
    pure logical function has_arc(it)
        type(triangle_type), intent(in) :: it !! a control triangle
        type(twofold_type) :: fullness

        has_arc = .false.
        if (is_zero(it%off_chord%high) .or. .not. it%is_within) return
        fullness = it%weight + 1.0_dp
        has_arc = fullness%high > 0.0_dp
    end function has_arc

    !> True where two numbers are both above or both below zero.
    elemental logical function same_sign(a, b)
        type(twofold_type), intent(in) :: a !! any number
        type(twofold_type), intent(in) :: b !! any number
        same_sign = (a%high > 0.0_dp .and. b%high > 0.0_dp) &
            .or. (a%high < 0.0_dp .and. b%high < 0.0_dp)
    end function same_sign

    !> The end tangents of the arc as control vectors: `leaving` is the weight times the way from
    !> the start to the intersection of the end tangents, `arriving` from there to the finish.
    !> Both are finite also where the tangents are parallel and the weight is zero, and both point
    !> forward along the arc.
    pure subroutine corner_of(it, leaving, arriving)
        type(triangle_type), intent(in) :: it              !! a control triangle that has an arc
        type(twofold_type), intent(out) :: leaving(2)      !! at the start, in `size`
        type(twofold_type), intent(out) :: arriving(2)     !! at the finish, in `size`
        type(twofold_type) :: bulge

        bulge = it%off_chord/(2.0_dp*it%root)
        leaving = along(-(bulge/it%chord_off_start), it%t1)
        arriving = along(-(bulge/it%chord_off_finish), it%t3)
    end subroutine corner_of

    !> A twofold multiple of a vector.
    pure function along(multiple, vector)
        type(twofold_type), intent(in) :: multiple !! any number
        real(dp), intent(in) :: vector(2)          !! any vector
        type(twofold_type) :: along(2)
        along(1) = vector(1)*multiple
        along(2) = vector(2)*multiple
    end function along

end module geom_triangle
