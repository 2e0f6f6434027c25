!> The bicubic patch in its three forms: Coons' corner matrix H (points, tangents, twists), the net
!> of vertices b of Bezier's curves, and the side vectors A in which UNISURF first wrote it. Each is
!> an array (3, 4, 4), along u then v; the forms say the same surface and go into each other by
!>
!>     H = T b T',   A = L b L'
!>
!> H is [Q00 Q01 Qv00 Qv01; Q10 Q11 Qv10 Qv11; Qu00 Qu01 Quv00 Quv01; Qu10 Qu11 Quv10 Quv11].
!>
!> Source: seed 000, "Coons patches", (14) to (17); (16) and (17) print one garbled matrix for both
!> of Bezier's forms: the net of side vectors is A, that of vertices b. Adini's estimate: A. Adini
!> and R. Clough 1961, as in G. Farin, "Curves and Surfaces for CAGD", 16.3.
module geom_bicubic
    use base_kinds, only: dp
    use geom_coons, only: frame_type, patch_jet_type
    use geom_coons_blend, only: blend, blend_jet
    use geom_bezier, only: bezier_from_sides, bezier_point, bezier_sides
    implicit none (type, external)
    private

    public :: bicubic_point, bicubic_jet, corners_of_frame, swapped
    public :: corners_of_net, net_of_corners, sides_of_net, net_of_sides
    public :: net_point, side_vector_point, zero_twists, adini_twists, twist_estimate

    !> From vertices to ends and end tangents, and back.
    real(dp), parameter, public :: corner_matrix(4, 4) = transpose(reshape([real(dp) :: &
        1, 0, 0, 0,   0, 0, 0, 1,   -3, 3, 0, 0,   0, 0, -3, 3], [4, 4]))
    real(dp), parameter, public :: vertex_matrix(4, 4) = transpose(reshape([real(dp) :: &
        1, 0, 0, 0,   1, 0, 1.0_dp/3.0_dp, 0,   0, 1, 0, -1.0_dp/3.0_dp,   0, 1, 0, 0], [4, 4]))
    !> Rows of u**3, u**2, u, 1: of Hermite's functions, Bernstein's, and those of side vectors.
    real(dp), parameter, public :: hermite_powers(4, 4) = transpose(reshape([real(dp) :: &
        2, -2, 1, 1,   -3, 3, -2, -1,   0, 0, 1, 0,   1, 0, 0, 0], [4, 4]))
    real(dp), parameter, public :: bernstein_powers(4, 4) = transpose(reshape([real(dp) :: &
        -1, 3, -3, 1,   3, -6, 3, 0,   -3, 3, 0, 0,   1, 0, 0, 0], [4, 4]))
    real(dp), parameter, public :: side_powers(4, 4) = transpose(reshape([real(dp) :: &
        0, 1, -2, 1,   0, -3, 3, 0,   0, 3, 0, 0,   1, 0, 0, 0], [4, 4]))

contains

    !> A point of the patch of some corners, deck units.
    pure function bicubic_point(h, u, v) result(point)
        real(dp), intent(in) :: h(3, 4, 4)  !! corners
        real(dp), intent(in) :: u           !! 0 to 1
        real(dp), intent(in) :: v           !! 0 to 1
        real(dp) :: point(3)
        type(patch_jet_type) :: jet
        jet = bicubic_jet(h, u, v)
        point = jet%at
    end function bicubic_point

    !> A point of the patch of some corners with its derivatives: [F0 F1 G0 G1](u) H [...](v)'.
    pure type(patch_jet_type) function bicubic_jet(h, u, v) result(jet)
        real(dp), intent(in) :: h(3, 4, 4)  !! corners
        real(dp), intent(in) :: u           !! 0 to 1
        real(dp), intent(in) :: v           !! 0 to 1
        real(dp) :: along_u(0:2, 0:2, 0:1), along_v(0:2, 0:2, 0:1)

        along_u = blend_jet(blend%slopes, u)
        along_v = blend_jet(blend%slopes, v)
        jet = patch_jet_type(part(0, 0), part(1, 0), part(0, 1), part(2, 0), part(1, 1), part(0, 2))
    contains
        !> The derivative by u (a times) and v (b times).
        pure function part(a, b) result(sum)
            integer, intent(in) :: a    !! 0 to 2
            integer, intent(in) :: b    !! 0 to 2
            real(dp) :: sum(3), row(4), column(4)
            integer :: k
            row = [along_u(a, 0, :), along_u(a, 1, :)]
            column = [along_v(b, 0, :), along_v(b, 1, :)]
            do k = 1, 3
                sum(k) = dot_product(row, matmul(h(k, :, :), column))
            end do
        end function part
    end function bicubic_jet

    !> The corners of a frame: its points, tangents and twists (the mean of both sides).
    pure function corners_of_frame(frame) result(h)
        class(frame_type), intent(in) :: frame !! any, that knows its cross slopes
        real(dp) :: h(3, 4, 4)
        real(dp) :: across_u(3, 0:2, 0:2), across_v(3, 0:2, 0:2)
        integer :: i, j

        do j = 0, 1
            do i = 0, 1
                across_u = frame%side_u(i, real(j, dp))
                across_v = frame%side_v(j, real(i, dp))
                h(:, 1 + i, 1 + j) = 0.5_dp*(across_u(:, 0, 0) + across_v(:, 0, 0))
                h(:, 1 + i, 3 + j) = across_u(:, 0, 1)
                h(:, 3 + i, 1 + j) = across_v(:, 0, 1)
                h(:, 3 + i, 3 + j) = 0.5_dp*(across_u(:, 1, 1) + across_v(:, 1, 1))
            end do
        end do
    end function corners_of_frame

    !> The same patch with u and v exchanged; of any of the forms.
    pure function swapped(form) result(other)
        real(dp), intent(in) :: form(3, 4, 4) !! corners, net or side vectors
        real(dp) :: other(3, 4, 4)
        other = reshape(form, [3, 4, 4], order=[1, 3, 2])
    end function swapped

    !> The corners of a net: H = T b T'.
    pure function corners_of_net(net) result(h)
        real(dp), intent(in) :: net(3, 4, 4) !! vertices
        real(dp) :: h(3, 4, 4)
        h = between(corner_matrix, net)
    end function corners_of_net

    !> The net of some corners, the exchange form.
    pure function net_of_corners(h) result(net)
        real(dp), intent(in) :: h(3, 4, 4) !! corners
        real(dp) :: net(3, 4, 4)
        net = between(vertex_matrix, h)
    end function net_of_corners

    !> A matrix times a form times its transpose.
    pure function between(matrix, form) result(product)
        real(dp), intent(in) :: matrix(4, 4)    !! the matrix
        real(dp), intent(in) :: form(3, 4, 4)   !! a form of a patch
        real(dp) :: product(3, 4, 4)
        integer :: k
        do k = 1, 3
            product(k, :, :) = matmul(matrix, matmul(form(k, :, :), transpose(matrix)))
        end do
    end function between

    !> The side vectors of a net: those of each row, then of each column of what comes out.
    pure function sides_of_net(net) result(side)
        real(dp), intent(in) :: net(3, 4, 4) !! vertices
        real(dp) :: side(3, 4, 4)
        integer :: i
        do i = 1, 4
            side(:, :, i) = bezier_sides(net(:, :, i))
        end do
        do i = 1, 4
            side(:, i, :) = bezier_sides(side(:, i, :))
        end do
    end function sides_of_net

    !> The net of some side vectors.
    pure function net_of_sides(side) result(net)
        real(dp), intent(in) :: side(3, 4, 4) !! as `sides_of_net` gives them
        real(dp) :: net(3, 4, 4)
        integer :: i
        do i = 1, 4
            net(:, :, i) = bezier_from_sides(side(:, :, i))
        end do
        do i = 1, 4
            net(:, i, :) = bezier_from_sides(net(:, i, :))
        end do
    end function net_of_sides

    !> A point of the patch of a net, by de Casteljau's scheme along u, then v.
    pure function net_point(net, u, v) result(point)
        real(dp), intent(in) :: net(3, 4, 4)    !! vertices
        real(dp), intent(in) :: u               !! 0 to 1
        real(dp), intent(in) :: v               !! 0 to 1
        real(dp) :: point(3), row(3, 4)
        integer :: i
        do i = 1, 4
            row(:, i) = bezier_point(net(:, :, i), u)
        end do
        point = bezier_point(row, v)
    end function net_point

    !> A point of the patch of side vectors, by Bezier's functions 1, 3 t - 3 t**2 + t**3,
    !> 3 t**2 - 2 t**3, t**3.
    pure function side_vector_point(side, u, v) result(point)
        real(dp), intent(in) :: side(3, 4, 4)   !! as `sides_of_net` gives them
        real(dp), intent(in) :: u               !! 0 to 1
        real(dp), intent(in) :: v               !! 0 to 1
        real(dp) :: point(3)
        integer :: k
        do k = 1, 3
            point(k) = dot_product(matmul([u**3, u**2, u, 1.0_dp], side_powers), &
                matmul(side(k, :, :), matmul([v**3, v**2, v, 1.0_dp], side_powers)))
        end do
    end function side_vector_point

    !> The same sides without twists: Ferguson's patch. It is flat near its corners.
    pure function zero_twists(h) result(ferguson)
        real(dp), intent(in) :: h(3, 4, 4) !! corners
        real(dp) :: ferguson(3, 4, 4)
        ferguson = h
        ferguson(:, 3:, 3:) = 0.0_dp
    end function zero_twists

    !> The same sides with Adini's twists.
    pure function adini_twists(h) result(adini)
        real(dp), intent(in) :: h(3, 4, 4) !! corners; twists are not asked for
        real(dp) :: adini(3, 4, 4)
        integer :: i, j
        adini = h
        do j = 0, 1
            do i = 0, 1
                adini(:, 3 + i, 3 + j) = twist_estimate(h(:, :2, :2), h(:, 3:, :2), h(:, :2, 3:), &
                    i, j)
            end do
        end do
    end function adini_twists

    !> Adini's twist of a corner: that of the patch bilinearly blended between the same sides.
    pure function twist_estimate(q, qu, qv, i, j) result(twist)
        real(dp), intent(in) :: q(3, 0:1, 0:1)  !! corners (:, u, v)
        real(dp), intent(in) :: qu(3, 0:1, 0:1) !! their tangents along u
        real(dp), intent(in) :: qv(3, 0:1, 0:1) !! their tangents along v
        integer, intent(in) :: i                !! u of the corner
        integer, intent(in) :: j                !! v of the corner
        real(dp) :: twist(3)
        twist = (qv(:, 1, j) - qv(:, 0, j)) + (qu(:, i, 1) - qu(:, i, 0)) &
            - ((q(:, 1, 1) - q(:, 0, 1)) - (q(:, 1, 0) - q(:, 0, 0)))
    end function twist_estimate

end module geom_bicubic
