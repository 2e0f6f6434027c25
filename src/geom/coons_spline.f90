!> Coons patches between splines, and the B-spline surfaces that they are.
!>
!> What is blended between splines of degree 5 by functions of at most that degree is a B-spline
!> surface of degree 5 along u and v, whose knots are those of the opposite sides. So it need not be
!> fitted: the surface that has the patch's points at the nodes is the patch, but for rounding.
!>
!> Cross slopes go from corner to corner by Hermite's functions, (12): the tangents of the sides at
!> the ends, and twists there, Adini's or zero; or they are given, as a spline of degree 5 too. Then
!> the twists of the corners are those of the given ones.
!>
!> Source: seed 000, "Coons patches", (1), (8), (12).
module geom_coons_spline
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_order, only: rising
    use geom_bicubic, only: twist_estimate
    use geom_bspline, only: bspline_type, spline_breaks, spline_jet
    use geom_bspline_surface, only: bspline_surface_type
    use geom_coons, only: coons_point, coons_type, frame_type, new_coons
    use geom_coons_blend, only: blend, blend_jet
    use geom_spline_fit, only: fit_knots, fit_nodes, fit_values
    implicit none (type, external)
    private

    public :: spline_frame_type, new_spline_frame, corner_of, settle_twists, coons_surface

    !> Four splines of degree 5 over 0 to 1, each along growing u or v: side 1 where v = 0, side 2
    !> where u = 1, side 3 where v = 1, side 4 where u = 0.
    type, extends(frame_type) :: spline_frame_type
        type(bspline_type) :: side(4)                   !! the sides
        type(bspline_type) :: ribbon(4)                 !! cross slopes; without poles: not given
        real(dp) :: slope_u(3, 0:1, 0:1) = 0.0_dp       !! tangents along u in the corners (:, u, v)
        real(dp) :: slope_v(3, 0:1, 0:1) = 0.0_dp       !! tangents along v there
        real(dp) :: twist(3, 0:1, 0:1) = 0.0_dp         !! twists there
    contains
        procedure :: side_u
        procedure :: side_v
    end type spline_frame_type

    !> Degree of the sides and of the surface.
    integer, parameter :: degree = 5
    !> Knots of opposite sides that are as near to each other are one.
    real(dp), parameter :: same_knot = 1.0e-9_dp

contains

    !> A frame of four splines, with Adini's twists, or without twists.
    pure type(spline_frame_type) function new_spline_frame(side, has_twists) result(frame)
        type(bspline_type), intent(in) :: side(4)   !! as in the type
        logical, intent(in) :: has_twists           !! Adini's
        real(dp) :: corner(3, 0:1, 0:1), second(3)
        integer :: i, j

        frame%side = side
        do j = 0, 1
            do i = 0, 1
                call spline_jet(side(1 + 2*j), real(i, dp), corner(:, i, j), &
                    frame%slope_u(:, i, j), second)
                call spline_jet(side(4 - 2*i), real(j, dp), corner(:, i, j), &
                    frame%slope_v(:, i, j), second)
            end do
        end do
        if (.not. has_twists) return
        do j = 0, 1
            do i = 0, 1
                frame%twist(:, i, j) = twist_estimate(corner, frame%slope_u, frame%slope_v, i, j)
            end do
        end do
    end function new_spline_frame

    !> The side u = 0 or 1 with its cross slope.
    pure function side_u(f, side, t) result(jet)
        class(spline_frame_type), intent(in) :: f   !! the frame
        integer, intent(in) :: side                 !! 0 or 1
        real(dp), intent(in) :: t                   !! v
        real(dp) :: jet(3, 0:2, 0:2)
        jet = side_jet(f%side(4 - 2*side), f%slope_u(:, side, :), f%twist(:, side, :), t)
        call take_ribbon(f%ribbon(4 - 2*side), t, jet)
    end function side_u

    !> The side v = 0 or 1 with its cross slope.
    pure function side_v(f, side, t) result(jet)
        class(spline_frame_type), intent(in) :: f   !! the frame
        integer, intent(in) :: side                 !! 0 or 1
        real(dp), intent(in) :: t                   !! u
        real(dp) :: jet(3, 0:2, 0:2)
        jet = side_jet(f%side(1 + 2*side), f%slope_v(:, :, side), f%twist(:, :, side), t)
        call take_ribbon(f%ribbon(1 + 2*side), t, jet)
    end function side_v

    !> Puts a cross slope that is given in the place of the other.
    pure subroutine take_ribbon(ribbon, t, jet)
        type(bspline_type), intent(in) :: ribbon        !! of a side
        real(dp), intent(in) :: t                       !! 0 to 1
        real(dp), intent(inout) :: jet(3, 0:2, 0:2)     !! of the side
        if (.not. allocated(ribbon%pole)) return
        call spline_jet(ribbon, t, jet(:, 1, 0), jet(:, 1, 1), jet(:, 1, 2))
    end subroutine take_ribbon

    !> The corner (u, v) where a side begins or ends, along growing u or v.
    pure function corner_of(number, end) result(uv)
        integer, intent(in) :: number   !! which side
        integer, intent(in) :: end      !! 0 where it begins, 1 where it ends
        integer :: uv(2)
        if (mod(number, 2) == 1) then
            uv = [end, number/2]
        else
            uv = [2 - number/2, end]
        end if
    end function corner_of

    !> Takes the twists of the corners from the ribbons that are given, the mean where two meet; the
    !> other cross slopes then go by them.
    pure subroutine settle_twists(frame)
        type(spline_frame_type), intent(inout) :: frame !! with its ribbons
        real(dp) :: sum(3, 0:1, 0:1), at(3), first(3), second(3)
        integer :: number, end, uv(2), met(0:1, 0:1)

        met = 0
        sum = 0.0_dp
        do number = 1, 4
            if (.not. allocated(frame%ribbon(number)%pole)) cycle
            do end = 0, 1
                uv = corner_of(number, end)
                call spline_jet(frame%ribbon(number), real(end, dp), at, first, second)
                sum(:, uv(1), uv(2)) = sum(:, uv(1), uv(2)) + first
                met(uv(1), uv(2)) = met(uv(1), uv(2)) + 1
            end do
        end do
        do end = 0, 3
            uv = [mod(end, 2), end/2]
            if (met(uv(1), uv(2)) > 0) frame%twist(:, uv(1), uv(2)) = &
                sum(:, uv(1), uv(2))/real(met(uv(1), uv(2)), dp)
        end do
    end subroutine settle_twists

    !> A side with its cross slope, both with their derivatives along it.
    pure function side_jet(side, slope, twist, t) result(jet)
        type(bspline_type), intent(in) :: side  !! a side
        real(dp), intent(in) :: slope(3, 0:1)   !! the cross slope at its ends
        real(dp), intent(in) :: twist(3, 0:1)   !! the twists there
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp) :: jet(3, 0:2, 0:2), along(0:2, 0:2, 0:1)
        integer :: i, b

        jet = 0.0_dp
        call spline_jet(side, t, jet(:, 0, 0), jet(:, 0, 1), jet(:, 0, 2))
        along = blend_jet(blend%slopes, t)
        do i = 0, 1
            do b = 0, 2
                jet(:, 1, b) = jet(:, 1, b) + along(b, 0, i)*slope(:, i) &
                    + along(b, 1, i)*twist(:, i)
            end do
        end do
    end function side_jet

    !> The surface of the patch between four splines, over 0 to 1 along u and v.
    !>
    !> Fails with `cause%singular` where knots are so close that nodes are one.
    pure subroutine coons_surface(frame, kind, surface, error)
        type(spline_frame_type), intent(in) :: frame        !! its sides
        integer, intent(in) :: kind                         !! one of `blend%...`
        type(bspline_surface_type), intent(out) :: surface  !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(coons_type) :: patch
        real(dp), allocatable :: u_breaks(:), v_breaks(:), u(:), v(:), value(:, :), pole(:, :)
        integer :: i, j

        patch = new_coons(frame, kind)
        u_breaks = breaks_along(frame, 1)
        v_breaks = breaks_along(frame, 2)
        u = fit_nodes(u_breaks, degree)
        v = fit_nodes(v_breaks, degree)
        allocate (value(3*size(v), size(u)), pole(3*size(v), size(u)))
        do i = 1, size(u)
            do j = 1, size(v)
                value(3*j - 2:3*j, i) = coons_point(patch, u(i), v(j))
            end do
        end do
        call fit_values(u_breaks, degree, value, pole, error)
        if (allocated(error)) return
        value = reshape(reshape(pole, [3, size(u), size(v)], order=[1, 3, 2]), [3*size(u), size(v)])
        deallocate (pole)
        allocate (pole(3*size(u), size(v)))
        call fit_values(v_breaks, degree, value, pole, error)
        if (allocated(error)) return
        surface%degree = degree
        surface%u_knot = fit_knots(u_breaks, degree)
        surface%v_knot = fit_knots(v_breaks, degree)
        surface%pole = reshape(pole, [3, size(u), size(v)])
        allocate (surface%weight(size(u), size(v)), source=1.0_dp)
    end subroutine coons_surface

    !> The breaks of a side and the one opposite, and of their ribbons.
    pure function breaks_along(frame, number) result(breaks)
        type(spline_frame_type), intent(in) :: frame    !! the sides
        integer, intent(in) :: number                   !! 1 or 2
        real(dp), allocatable :: breaks(:)
        integer :: i
        allocate (breaks(0))
        breaks = merged(spline_breaks(frame%side(number)), spline_breaks(frame%side(number + 2)))
        do i = number, number + 2, 2
            if (allocated(frame%ribbon(i)%pole)) &
                breaks = merged(breaks, spline_breaks(frame%ribbon(i)))
        end do
    end function breaks_along

    !> The breaks of two splines over 0 to 1, rising, each once.
    pure function merged(first, second) result(breaks)
        real(dp), intent(in) :: first(:)    !! rising from 0 to 1
        real(dp), intent(in) :: second(:)   !! rising from 0 to 1
        real(dp), allocatable :: breaks(:), all(:)
        integer :: i

        allocate (breaks(1), source=0.0_dp)
        allocate (all(0))
        all = rising([first, second])
        do i = 1, size(all)
            if (all(i) > breaks(size(breaks)) + same_knot .and. all(i) < 1.0_dp - same_knot) &
                breaks = [breaks, all(i)]
        end do
        breaks = [breaks, 1.0_dp]
    end function merged

end module geom_coons_spline
