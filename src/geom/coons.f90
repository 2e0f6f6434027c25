!> Coons patches: the Boolean sum of what is blended between the sides u = 0, 1 and between the
!> sides v = 0, 1, less what both have, the surface of the corners.
!>
!> What is kept on the sides goes with the blend: the curves, (1); their cross slopes too, (8); the
!> second derivatives across them too, (10). Sides that do not agree in a corner can't all be kept:
!> `check_corners` looks at the points, `twist_gaps` at the twists.
!>
!> Source: seed 000, "Coons patches", (1), (8), (10), with (8), (10) and (11) corrected.
module geom_coons
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use geom_coons_blend, only: blend_jet, blend_orders
    implicit none (type, external)
    private

    public :: frame_type, coons_type, patch_jet_type, new_coons, coons_point, coons_jet
    public :: corner_gaps, twist_gaps, check_corners

    !> Four sides, with what is known across them.
    type, abstract :: frame_type
    contains
        procedure(side_interface), deferred :: side_u   !! u = 0 or 1, along v
        procedure(side_interface), deferred :: side_v   !! v = 0 or 1, along u
    end type frame_type

    abstract interface
        !> A side and the derivatives across it, each with its derivatives along the side:
        !> jet(:, across, along). What is not known is not asked for by the blend.
        pure function side_interface(f, side, t) result(jet)
            import :: frame_type, dp
            implicit none (type, external)
            class(frame_type), intent(in) :: f  !! the frame
            integer, intent(in) :: side         !! 0 or 1: where the other parameter is
            real(dp), intent(in) :: t           !! 0 to 1, along the side
            real(dp) :: jet(3, 0:2, 0:2)        !! deck units
        end function side_interface
    end interface

    !> A patch with its corners: corner(:, k, l, i, j) is the derivative by u (k times) and v (l
    !> times) at u = i, v = j; the mean of the two sides where they differ.
    type :: coons_type
        class(frame_type), allocatable :: frame             !! its sides
        integer :: blend = 1                                !! one of `blend%...`
        real(dp) :: corner(3, 0:2, 0:2, 0:1, 0:1) = 0.0_dp  !! see above
    end type coons_type

    !> A point of a surface with its derivatives.
    type :: patch_jet_type
        real(dp) :: at(3) = 0.0_dp  !! deck units
        real(dp) :: u(3) = 0.0_dp   !! by u
        real(dp) :: v(3) = 0.0_dp   !! by v
        real(dp) :: uu(3) = 0.0_dp  !! by u twice
        real(dp) :: uv(3) = 0.0_dp  !! by u and v: the twist
        real(dp) :: vv(3) = 0.0_dp  !! by v twice
    end type patch_jet_type

contains

    !> A patch between the sides of a frame.
    pure type(coons_type) function new_coons(frame, blend) result(patch)
        class(frame_type), intent(in) :: frame  !! its sides
        integer, intent(in) :: blend            !! one of `blend%...`
        real(dp) :: across_u(3, 0:2, 0:2), across_v(3, 0:2, 0:2)
        integer :: i, j, k

        allocate (patch%frame, source=frame)
        patch%blend = blend
        do j = 0, 1
            do i = 0, 1
                across_u = frame%side_u(i, real(j, dp))
                across_v = frame%side_v(j, real(i, dp))
                do k = 0, 2
                    patch%corner(:, k, :, i, j) = &
                        0.5_dp*(across_u(:, k, :) + across_v(:, :, k))
                end do
            end do
        end do
    end function new_coons

    !> A point of a patch, deck units.
    pure function coons_point(patch, u, v) result(point)
        type(coons_type), intent(in) :: patch   !! any
        real(dp), intent(in) :: u               !! 0 to 1
        real(dp), intent(in) :: v               !! 0 to 1
        real(dp) :: point(3)
        type(patch_jet_type) :: jet
        jet = coons_jet(patch, u, v)
        point = jet%at
    end function coons_point

    !> A point of a patch with its derivatives.
    pure type(patch_jet_type) function coons_jet(patch, u, v) result(jet)
        type(coons_type), intent(in) :: patch   !! any
        real(dp), intent(in) :: u               !! 0 to 1
        real(dp), intent(in) :: v               !! 0 to 1
        real(dp) :: along_u(0:2, 0:2, 0:1), along_v(0:2, 0:2, 0:1), sum(3, 0:2, 0:2)
        real(dp) :: side_u(3, 0:2, 0:2, 0:1), side_v(3, 0:2, 0:2, 0:1)
        integer :: side, last, a, b

        along_u = blend_jet(patch%blend, u)
        along_v = blend_jet(patch%blend, v)
        last = blend_orders(patch%blend) - 1
        do side = 0, 1
            side_u(:, :, :, side) = patch%frame%side_u(side, v)
            side_v(:, :, :, side) = patch%frame%side_v(side, u)
        end do
        do b = 0, 2
            do a = 0, 2 - b
                sum(:, a, b) = blended(along_u(a, :last, :), side_u(:, :last, b, :)) &
                    + blended(along_v(b, :last, :), side_v(:, :last, a, :)) &
                    - both(along_u(a, :last, :), along_v(b, :last, :), &
                    patch%corner(:, :last, :last, :, :))
            end do
        end do
        jet = patch_jet_type(sum(:, 0, 0), sum(:, 1, 0), sum(:, 0, 1), sum(:, 2, 0), sum(:, 1, 1), &
            sum(:, 0, 2))
    end function coons_jet

    !> What is blended between two opposite sides.
    pure function blended(share, side) result(sum)
        real(dp), intent(in) :: share(:, :)     !! (function, end)
        real(dp), intent(in) :: side(:, :, :)   !! (:, derivative across, end)
        real(dp) :: sum(3)
        integer :: k, i

        sum = 0.0_dp
        do i = 1, size(share, 2)
            do k = 1, size(share, 1)
                sum = sum + share(k, i)*side(:, k, i)
            end do
        end do
    end function blended

    !> What is blended between the corners.
    pure function both(along_u, along_v, corner) result(sum)
        real(dp), intent(in) :: along_u(:, :)           !! (function, end)
        real(dp), intent(in) :: along_v(:, :)           !! (function, end)
        real(dp), intent(in) :: corner(:, :, :, :, :)   !! (:, by u, by v, u, v)
        real(dp) :: sum(3)
        integer :: l, j

        sum = 0.0_dp
        do j = 1, size(along_v, 2)
            do l = 1, size(along_v, 1)
                sum = sum + along_v(l, j)*blended(along_u, corner(:, :, l, :, j))
            end do
        end do
    end function both

    !> How far the ends of sides are from each other in the corners, gap(u, v), deck units.
    pure function corner_gaps(frame) result(gap)
        class(frame_type), intent(in) :: frame !! any
        real(dp) :: gap(0:1, 0:1)
        gap = gaps(frame, 0)
    end function corner_gaps

    !> How far the twists differ that the two sides of a corner give it, gap(u, v). Where they do, a
    !> patch with slopes keeps neither cross slope near the corner.
    pure function twist_gaps(frame) result(gap)
        class(frame_type), intent(in) :: frame !! any, that knows its cross slopes
        real(dp) :: gap(0:1, 0:1)
        gap = gaps(frame, 1)
    end function twist_gaps

    !> How far the two sides of a corner differ there, in what is derived as often by u as by v.
    pure function gaps(frame, times) result(gap)
        class(frame_type), intent(in) :: frame  !! any
        integer, intent(in) :: times            !! how often: 0 the point, 1 the twist
        real(dp) :: gap(0:1, 0:1)
        real(dp) :: across_u(3, 0:2, 0:2), across_v(3, 0:2, 0:2)
        integer :: i, j

        do j = 0, 1
            do i = 0, 1
                across_u = frame%side_u(i, real(j, dp))
                across_v = frame%side_v(j, real(i, dp))
                gap(i, j) = norm2(across_u(:, times, times) - across_v(:, times, times))
            end do
        end do
    end function gaps

    !> Fails with `cause%joint_gap` where sides do not meet in a corner; names the worst one and its
    !> gap. Corner 1 is that of sides 4 and 1, corner 2 that of 1 and 2, and so on round the patch:
    !> u = v = 0; u = 1, v = 0; u = v = 1; u = 0, v = 1.
    pure subroutine check_corners(frame, tolerance, error)
        class(frame_type), intent(in) :: frame              !! any
        real(dp), intent(in) :: tolerance                   !! deck units
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: gap(0:1, 0:1)
        integer :: worst(2), number

        gap = corner_gaps(frame)
        if (all(gap <= tolerance)) return
        worst = maxloc(gap) - 1
        number = 1 + worst(1) + worst(2)*(3 - 2*worst(1))
        call fail(error, cause%joint_gap, 'sides '//to_text(1 + mod(number + 2, 4))//' and '// &
            to_text(number)//' do not meet in corner '//to_text(number)//': the gap is '// &
            compact(gap(worst(1), worst(2)))//'; '//compact(tolerance)//' is allowed')
    end subroutine check_corners

end module geom_coons
