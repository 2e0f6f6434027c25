!> Where a plane meets the arc of a section. At a place a : b of the arc of `geom_arc` the height
!> over the plane, times the positive denominator D, is the quadratic form
!>
!>     e1 a**2 + 2 e2 a b + e3 b**2
!>
!> with e1 and e3 the heights of its ends and e2 = w (e1 + e3)/2 + n . g, g the bulge and w the
!> weight. It has at most one place where the height rises along the arc, (e2 + R : -e1) = (e3 : R -
!> e2) with R = sqrt(e2**2 - e1 e3), and at most one where it falls, which rises for -e1, -e2, -e3:
!> a branch of a cut is one of these two and needs no other choosing.
module cut_meeting
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_tolerances, only: decimal_noise, ulp
    use cut_plane, only: plane_type
    use geom_arc, only: arc_type
    use geom_place, only: at_finish, at_start, place_type
    use geom_twofold, only: exact_difference, operator(*), operator(+), operator(-), sqrt, &
        to_real, twofold, twofold_type
    implicit none (type, external)
    private

    public :: meeting_type, meeting_of, has_branch, place_of, turning_place, openness
    public :: edge_height, height_noise, is_across

    !> The branches of a cut.
    type, public :: branch_list
        integer :: rising = 1   !! the height over the plane rises from start to finish
        integer :: falling = -1 !! it falls
    end type branch_list

    !> The branches by name.
    type(branch_list), parameter, public :: cut_branch = branch_list()

    !> The quadratic form of the heights of an arc.
    type :: meeting_type
        type(twofold_type) :: start     !! e1, deck units times the length of the plane's normal
        type(twofold_type) :: middle    !! e2, the same
        type(twofold_type) :: finish    !! e3, the same
    end type meeting_type

contains

    !> The form of an arc at a station. What is known to be zero is so exactly: the height of an
    !> edge in the plane, and with an end tangent in the plane, too, e2.
    pure type(meeting_type) function meeting_of(arc, sta, plane, lies) result(it)
        type(arc_type), intent(in) :: arc       !! x is BL, y is WL
        real(dp), intent(in) :: sta             !! deck units
        type(plane_type), intent(in) :: plane   !! any plane but a station
        logical, intent(in) :: lies(2)          !! the start, the finish lies in the plane
        type(twofold_type) :: rise

        if (.not. lies(1)) it%start = edge_height(plane, sta, arc%start)
        if (.not. lies(2)) it%finish = edge_height(plane, sta, arc%finish)
        rise = plane%normal(2)*arc%bulge(1) + plane%normal(3)*arc%bulge(2)
        it%middle = 0.5_dp*((arc%fullness - 1.0_dp)*(it%start + it%finish)) + arc%size*rise
        if ((lies(1) .and. is_along(arc%start_tangent)) .or. &
            (lies(2) .and. is_along(arc%finish_tangent))) it%middle = twofold_type()
    contains
        !> True for an end tangent in the plane: it then touches the arc there, and e2 is zero.
        pure logical function is_along(tangent)
            real(dp), intent(in) :: tangent(2) !! BL, WL
            is_along = abs(dot_product(plane%normal(2:), tangent)) <= &
                decimal_noise*ulp*norm2(plane%normal(2:))*norm2(tangent)
        end function is_along
    end function meeting_of

    !> The height of a point over a plane, times the length of the plane's normal.
    pure type(twofold_type) function edge_height(plane, sta, at) result(height)
        type(plane_type), intent(in) :: plane   !! any plane
        real(dp), intent(in) :: sta             !! deck units
        real(dp), intent(in) :: at(2)           !! BL, WL, deck units
        height = plane%normal(1)*exact_difference(sta, plane%through(1)) &
            + plane%normal(2)*exact_difference(at(1), plane%through(2)) &
            + plane%normal(3)*exact_difference(at(2), plane%through(3))
    end function edge_height

    !> What lost decimals do to a height, times the length of the plane's normal.
    pure real(dp) function height_noise(plane, sta, at) result(noise)
        type(plane_type), intent(in) :: plane   !! any plane
        real(dp), intent(in) :: sta             !! deck units
        real(dp), intent(in) :: at(2)           !! BL, WL, deck units
        noise = decimal_noise*ulp*sum(abs(plane%normal)*(abs([sta, at]) + abs(plane%through)))
    end function height_noise

    !> True for a plane across STA: it cuts a section as a whole.
    pure logical function is_across(plane)
        type(plane_type), intent(in) :: plane !! any plane
        is_across = all(is_zero(plane%normal(2:)))
    end function is_across

    !> e2**2 - e1 e3.
    pure type(twofold_type) function discriminant(it)
        type(meeting_type), intent(in) :: it !! of an arc
        discriminant = it%middle*it%middle - it%start*it%finish
    end function discriminant

    !> The discriminant to a scale of its own, -1 to 1: zero where the plane touches the conic, and
    !> where it can't be told from zero because the heights can't.
    pure real(dp) function openness(it)
        type(meeting_type), intent(in) :: it !! of an arc
        type(twofold_type) :: square, product
        real(dp) :: most, scale

        openness = 0.0_dp
        most = maxval(abs(to_real([it%start, it%middle, it%finish])))
        if (is_zero(most)) return
        scale = 2.0_dp**min(-exponent(most), maxexponent(most) - 1)
        square = (scale*it%middle)*(scale*it%middle)
        product = (scale*it%start)*(scale*it%finish)
        openness = to_real(square - product)/(to_real(square) + abs(to_real(product)) &
            + decimal_noise*ulp*(scale*most)**2)
    end function openness

    !> The form for which a branch is rising.
    pure type(meeting_type) function facing(it, branch) result(turned)
        type(meeting_type), intent(in) :: it    !! of an arc
        integer, intent(in) :: branch           !! one of `cut_branch%...`
        turned = it
        if (branch == cut_branch%falling) turned = meeting_type(-it%start, -it%middle, -it%finish)
    end function facing

    !> True where a branch is on the arc, ends included. An arc all in the plane has none.
    pure logical function has_branch(it, branch)
        type(meeting_type), intent(in) :: it    !! of an arc
        integer, intent(in) :: branch           !! one of `cut_branch%...`
        type(meeting_type) :: up
        type(twofold_type) :: under

        up = facing(it, branch)
        under = discriminant(up)
        has_branch = .false.
        if (under%high < 0.0_dp) return
        if (up%middle%high > 0.0_dp) then
            has_branch = up%start%high <= 0.0_dp
        else
            has_branch = up%finish%high >= 0.0_dp .and. (up%middle%high < 0.0_dp &
                .or. up%finish%high > 0.0_dp .or. up%start%high < 0.0_dp)
        end if
    end function has_branch

    !> The place of a branch; where rounding took it just beyond an end of the arc, that end.
    pure type(place_type) function place_of(it, branch) result(place)
        type(meeting_type), intent(in) :: it    !! of an arc that has it
        integer, intent(in) :: branch           !! one of `cut_branch%...`
        type(meeting_type) :: up
        type(twofold_type) :: root

        up = facing(it, branch)
        root = sqrt(discriminant(up))
        if (up%middle%high > 0.0_dp) then
            place = kept(up%middle + root, -up%start, at_start)
        else
            place = kept(up%finish, root - up%middle, at_finish)
        end if
    end function place_of

    !> A place by its shares; another where one of them is negative or both are zero.
    pure type(place_type) function kept(alpha, beta, otherwise) result(place)
        type(twofold_type), intent(in) :: alpha     !! share of the start
        type(twofold_type), intent(in) :: beta      !! share of the finish
        type(place_type), intent(in) :: otherwise   !! see above
        place = otherwise
        if (alpha%high < 0.0_dp .or. beta%high < 0.0_dp) return
        if (alpha%high > 0.0_dp .or. beta%high > 0.0_dp) place = place_type(alpha, beta)
    end function kept

    !> The place where both branches are one: the plane touches the arc.
    pure type(place_type) function turning_place(it) result(place)
        type(meeting_type), intent(in) :: it !! of an arc that is touched
        if (abs(it%start%high) > abs(it%finish%high)) then
            place = kept(magnitude(it%middle), magnitude(it%start), at_start)
        else
            place = kept(magnitude(it%finish), magnitude(it%middle), at_finish)
        end if
    end function turning_place

    !> A number without its sign.
    pure type(twofold_type) function magnitude(a)
        type(twofold_type), intent(in) :: a !! any
        magnitude = a
        if (a%high < 0.0_dp) magnitude = -a
    end function magnitude

end module cut_meeting
