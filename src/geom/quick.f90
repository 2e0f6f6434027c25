!> Rows of a table quickly: what `geom_contour` works in twofold numbers is worked here in doubles,
!> many rows side by side, each figure with a bound of its distance from the exact one. Who prints
!> decimals asks whether the bound leaves them in doubt, and only then for the exact row.
!>
!> With the notation of `geom_arc` and `geom_crossing`, u = 2**-53, S = |g| + (|w| + 1/2)(|A|+|C|),
!> V = |v1| + |h| + |v3|, N = alpha**2 + beta**2 and m = min(1, q), by the usual running analysis
!> (N. J. Higham, "Accuracy and Stability of Numerical Algorithms", 2nd ed., 2002, ch. 3):
!>
!>     the root       off by no more than u (8 S**2 + 4 |A C|)/root + u root
!>     the place      beta/alpha off by no more than 22 u S**2/(root (|B| + root)), relatively
!>     the point      by |dp/d log(beta/alpha)| <= |n| N/D**2 <= V/m**2 times that
!>     the tangent    n off by no more than N V (6 u + 2 of that) in each component
!>     D              by no more than (2 + q)/m of that, relatively, since D >= m N
!>
!> The place is taken to be off by 64 u instead of 22 u, which covers the small terms, those of
!> second order and the rounding of the exact row itself.
module geom_quick
    use base_constants, only: degrees, pi
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use geom_arc, only: arc_type
    use geom_twofold, only: operator(-), to_real
    use geom_twofold_same, only: rows_at_once
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: quick_type, quick_rows_type, new_quick, find_rows

    !> An arc in doubles, all but the points in its `size`.
    type :: quick_type
        logical :: is_usable = .false.      !! false: only the exact rows will do
        integer :: axis = 1                 !! 1: x is stepped, 2: y
        real(dp) :: start(2) = 0.0_dp       !! first point; stepped coordinate, then the other
        real(dp) :: finish(2) = 0.0_dp      !! last point, so too
        real(dp) :: size = 1.0_dp           !! unit of what follows, deck units
        real(dp) :: half(2) = 0.0_dp        !! h, stepped coordinate first in all of these
        real(dp) :: bulge(2) = 0.0_dp       !! g
        real(dp) :: leaving(2) = 0.0_dp     !! v1
        real(dp) :: arriving(2) = 0.0_dp    !! v3
        real(dp) :: fullness = 2.0_dp       !! q
        real(dp) :: weight = 1.0_dp         !! w
        real(dp) :: bend = 0.0_dp           !! size/(g x h), positive where the arc turns left
        real(dp) :: tangents = 0.0_dp       !! V
        real(dp) :: other_noise = 0.0_dp    !! rounding of the other coordinate, deck units
    end type quick_type

    !> Rows and how far each figure may be off.
    type :: quick_rows_type
        real(dp) :: stepped(rows_at_once) = 0.0_dp   !! stepped ordinates, deck units, as given
        real(dp) :: other(rows_at_once) = 0.0_dp     !! the other ordinates, deck units
        real(dp) :: slope(rows_at_once) = 0.0_dp     !! dy/dx
        real(dp) :: angle(rows_at_once) = 0.0_dp     !! of the slope, degrees
        real(dp) :: radius(rows_at_once) = 0.0_dp    !! of curvature, deck units, signed
        real(dp) :: other_doubt(rows_at_once) = 0.0_dp  !! deck units
        real(dp) :: slope_doubt(rows_at_once) = 0.0_dp  !! none
        real(dp) :: angle_doubt(rows_at_once) = 0.0_dp  !! degrees
        real(dp) :: radius_doubt(rows_at_once) = 0.0_dp !! deck units
    end type quick_rows_type

    !> Half an ulp of 1.
    real(dp), parameter :: u = 2.0_dp**(-53)
    !> Arcs fuller or flatter than this, and curves as good as straight, are left to the exact rows.
    real(dp), parameter :: most_fullness = 2.0_dp**20, least_bend = 2.0_dp**(-30)
    !> Units, deck units, and stepped coordinates, in `size`, that are left to the exact rows too.
    real(dp), parameter :: least_size = 2.0_dp**(-10), most_size = 2.0_dp**60
    real(dp), parameter :: least_reach = 2.0_dp**(-20)
    !> Where a root is less than this, its place is not known at all, which its doubt says: it is
    !> more than 7000 then. Other divisors that vanish do so only there.
    real(dp), parameter :: no_root = 1.0e-30_dp, nothing = 1.0e-60_dp
    !> The angle of a tangent is off by no more than this, radians.
    real(dp), parameter :: angle_error = 1.0e-13_dp

contains

    !> Prepares an arc.
    pure type(quick_type) function new_quick(arc, axis) result(quick)
        type(arc_type), intent(in) :: arc !! any arc
        integer, intent(in) :: axis       !! 1: x is stepped, 2: y
        real(dp) :: turn, fill
        integer :: order(2)

        order = [axis, 3 - axis]
        quick%axis = axis
        quick%start = arc%start(order)
        quick%finish = arc%finish(order)
        quick%size = arc%size
        quick%half = to_real(arc%half(order))
        quick%bulge = to_real(arc%bulge(order))
        quick%leaving = to_real(arc%leaving(order))
        quick%arriving = to_real(arc%arriving(order))
        quick%fullness = to_real(arc%fullness)
        quick%weight = to_real(arc%fullness - 1.0_dp)
        quick%tangents = sum(abs(quick%leaving) + abs(quick%half) + abs(quick%arriving))
        turn = to_real(cross(arc%bulge, arc%half))
        fill = min(1.0_dp, quick%fullness)
        quick%is_usable = .not. (arc%is_line .or. is_zero(turn)) &
            .and. quick%fullness < most_fullness .and. quick%fullness > 1.0_dp/most_fullness &
            .and. quick%size > least_size .and. quick%size < most_size &
            .and. abs(quick%half(1)) + abs(quick%bulge(1)) > least_reach &
            .and. abs(turn) > least_bend*quick%tangents**2
        if (.not. quick%is_usable) return
        quick%bend = quick%size/turn
        quick%other_noise = 16.0_dp*u*(abs(quick%start(2)) + abs(quick%finish(2)) + quick%size &
            *(abs(quick%half(2)) + (abs(quick%half(2)) + abs(quick%bulge(2)))/fill))
    end function new_quick

    !> Works the rows at some ordinates of a stretch of the arc.
    pure subroutine find_rows(quick, rising, rows)
        type(quick_type), intent(in) :: quick        !! a usable arc
        logical, intent(in) :: rising                !! the stepped coordinate increases along it
        type(quick_rows_type), intent(inout) :: rows !! has its ordinates; gets all else
        real(dp), dimension(rows_at_once) :: alpha, beta, doubt

        call find_places(quick, rising, rows%stepped, alpha, beta, doubt)
        call find_figures(quick, alpha, beta, doubt, rows)
    end subroutine find_rows

    !> The places of some ordinates, and how far beta/alpha may be off, relatively.
    pure subroutine find_places(quick, rising, ordinate, alpha, beta, doubt)
        type(quick_type), intent(in) :: quick                !! a usable arc
        logical, intent(in) :: rising                        !! as `find_rows`
        real(dp), intent(in) :: ordinate(rows_at_once)       !! deck units
        real(dp), intent(out) :: alpha(rows_at_once)         !! share of the start
        real(dp), intent(out) :: beta(rows_at_once)          !! share of the finish
        real(dp), intent(out) :: doubt(rows_at_once)         !! relative
        real(dp), dimension(rows_at_once) :: before, after, middle, root
        real(dp) :: unit, way, reach, slack
        integer :: i

        unit = 1.0_dp/quick%size
        way = merge(1.0_dp, -1.0_dp, rising)
        do i = 1, rows_at_once
            before(i) = (ordinate(i) - quick%start(1))*unit
            after(i) = (quick%finish(1) - ordinate(i))*unit
            middle(i) = way*(quick%bulge(1) - 0.5_dp*((before(i) - after(i))*quick%weight))
            root(i) = sqrt(max(middle(i)*middle(i) + before(i)*after(i), 0.0_dp))
        end do
        reach = maxval(abs(before) + abs(after))
        slack = 64.0_dp*u*(abs(quick%bulge(1)) + (abs(quick%weight) + 0.5_dp)*reach)**2
        do i = 1, rows_at_once
            associate (sum => abs(middle(i)) + root(i))
                alpha(i) = merge(sum, abs(after(i)), middle(i) >= 0.0_dp)
                beta(i) = merge(abs(before(i)), sum, middle(i) >= 0.0_dp)
                doubt(i) = slack/max(root(i)*sum, no_root)
            end associate
        end do
    end subroutine find_places

    !> The figures of some places.
    pure subroutine find_figures(quick, alpha, beta, doubt, rows)
        type(quick_type), intent(in) :: quick               !! a usable arc
        real(dp), intent(in) :: alpha(rows_at_once)         !! share of the start
        real(dp), intent(in) :: beta(rows_at_once)          !! share of the finish
        real(dp), intent(in) :: doubt(rows_at_once)         !! of beta/alpha, relative
        type(quick_rows_type), intent(inout) :: rows        !! gets the figures
        real(dp), dimension(rows_at_once) :: run, rise, pace, length, vague
        real(dp) :: aa, ab, bb, d, full, fill, spread, turning
        integer :: i, x, y

        full = quick%fullness
        fill = min(1.0_dp, full)
        spread = quick%size*quick%tangents/fill**2
        turning = 3.0_dp*(3.0_dp + full)/fill
        x = quick%axis
        y = 3 - x
        do i = 1, rows_at_once
            aa = alpha(i)*alpha(i)
            ab = 2.0_dp*(alpha(i)*beta(i))
            bb = beta(i)*beta(i)
            d = 1.0_dp/max((alpha(i) - beta(i))**2 + ab*full, nothing)
            rows%other(i) = quick%start(2) + quick%size*(quick%half(2) + &
                (ab*quick%bulge(2) + (beta(i) - alpha(i))*(beta(i) + alpha(i))*quick%half(2))*d)
            run(i) = aa*quick%leaving(x) + ab*quick%half(x) + bb*quick%arriving(x)
            rise(i) = aa*quick%leaving(y) + ab*quick%half(y) + bb*quick%arriving(y)
            length(i) = max(sqrt(run(i)*run(i) + rise(i)*rise(i)), nothing)
            pace(i) = length(i)*d
            vague(i) = (aa + bb)*quick%tangents*doubt(i)/length(i)
        end do
        do i = 1, rows_at_once
            rows%slope(i) = rise(i)/sign(max(abs(run(i)), nothing), run(i))
            rows%radius(i) = quick%bend*pace(i)*pace(i)*pace(i)
            rows%other_doubt(i) = spread*doubt(i) + quick%other_noise
            ! The tangent is no longer than (1 + |slope|) |run|.
            rows%slope_doubt(i) = 2.0_dp*vague(i)*(1.0_dp + abs(rows%slope(i)))**2
            rows%angle_doubt(i) = 2.0_dp*degrees*(vague(i) + angle_error)
            rows%radius_doubt(i) = abs(rows%radius(i))*(6.0_dp*vague(i) + turning*doubt(i))
            rows%angle(i) = angle_of(run(i), rise(i))
        end do
    end subroutine find_figures

    !> The angle of a tangent, degrees, from -90 to 90: the arctangent of a quotient below 0.42 in
    !> size, to which those of larger ones come by 45 and 90 degrees. The polynomial is the one of
    !> its degree with the least relative error, 2.6e-14.
    elemental real(dp) function angle_of(run, rise) result(angle)
        real(dp), intent(in) :: run  !! of x
        real(dp), intent(in) :: rise !! of y
        real(dp), parameter :: tan_22 = 0.41421356237309503_dp
        real(dp), parameter :: c(0:8) = [0.9999999999999744_dp, -0.3333333333088924_dp, &
            0.19999999615324704_dp, -0.14285690907887633_dp, 0.11110396086015144_dp, &
            -0.09078528899969984_dp, 0.07564643494897869_dp, -0.05877869216360761_dp, &
            0.030711354953105726_dp]
        real(dp) :: across, along, half, steep, z, s

        across = min(abs(run), abs(rise))
        along = max(abs(run), abs(rise), nothing)
        half = 0.5_dp + sign(0.5_dp, across - tan_22*along)
        steep = 0.5_dp + sign(0.5_dp, abs(rise) - abs(run))
        z = (across - half*along)/(along + half*across)
        s = z*z
        s = c(0) + s*(c(1) + s*(c(2) + s*(c(3) + s*(c(4) + s*(c(5) + s*(c(6) + s*(c(7) &
            + s*c(8))))))))
        angle = 0.25_dp*pi*half + z*s
        angle = 0.5_dp*pi*steep + (1.0_dp - 2.0_dp*steep)*angle
        angle = sign(degrees*angle, run*rise)
    end function angle_of

end module geom_quick
