!> An octant of a sphere as a rational surface, its edges, its derivatives, its mirror image.
program test_bspline_surface
    use base_kinds, only: dp
    use geom_bspline, only: bspline_type, spline_point
    use geom_bspline_surface, only: bspline_surface_type, edge_spline, mirrored_surface, &
        surface_jet, &
        surface_point, surface_side
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(bspline_surface_type) :: sphere, patch
    type(bspline_type) :: edge
    real(dp) :: at(3), du(3), dv(3), away(5), u, v, cu, su, cv, sv
    integer :: i, j

    sphere = octant()
    away = 0.0_dp
    do j = 0, 10
        do i = 0, 10
            u = real(i, dp)/10.0_dp
            v = real(j, dp)/10.0_dp
            cu = (1 - u**2)/(1 + u**2)
            su = 2*u/(1 + u**2)
            cv = (1 - v**2)/(1 + v**2)
            sv = 2*v/(1 + v**2)
            call surface_jet(sphere, u, v, at, du, dv)
            away(1) = max(away(1), norm2(at - [cu*cv, su*cv, sv]))
            ! The angle of a stereographic parameter turns by 2/(1 + t**2).
            away(2) = max(away(2), norm2(du - 2/(1 + u**2)*[-su*cv, cu*cv, 0.0_dp]))
            away(3) = max(away(3), norm2(dv - 2/(1 + v**2)*[-cu*sv, -su*sv, cv]))
            away(4) = max(away(4), norm2(at - surface_point(sphere, u, v)))
        end do
    end do
    call tap%near(away(1), 0.0_dp, 5.0e-16_dp, 'points are on the sphere where they should be')
    call tap%near(away(2), 0.0_dp, 3.0e-15_dp, 'derivatives along u')
    call tap%near(away(3), 0.0_dp, 3.0e-15_dp, 'derivatives along v')
    call tap%ok(away(4) == 0.0_dp, 'a point is the point of the jet')

    patch = sheet()
    away = 0.0_dp
    do i = 0, 30
        u = real(i, dp)/10.0_dp
        v = real(i, dp)/30.0_dp
        edge = edge_spline(patch, surface_side%v_from)
        away(1) = max(away(1), norm2(spline_point(edge, u) - surface_point(patch, u, 0.0_dp)))
        edge = edge_spline(patch, surface_side%u_to)
        away(2) = max(away(2), norm2(spline_point(edge, v) - surface_point(patch, 3.0_dp, v)))
        edge = edge_spline(patch, surface_side%v_to)
        away(3) = max(away(3), norm2(spline_point(edge, u) - surface_point(patch, u, 1.0_dp)))
        edge = edge_spline(patch, surface_side%u_from)
        away(4) = max(away(4), norm2(spline_point(edge, v) - surface_point(patch, 0.0_dp, v)))
        at = surface_point(mirrored_surface(patch), u, v)
        away(5) = max(away(5), norm2(at*[1.0_dp, -1.0_dp, 1.0_dp] - surface_point(patch, u, v)))
    end do
    call tap%ok(all(away(:4) <= 4.0e-15_dp), 'edges are where a parameter is at its end')
    call tap%ok(away(5) == 0.0_dp, 'the mirror image is exact')
    patch%pole(2, :, :) = 0.0_dp
    patch = mirrored_surface(patch)
    call tap%ok(all(sign(1.0_dp, patch%pole(2, :, :)) > 0.0_dp), 'and has no -0')
    ! A bilinear patch is z = x y.
    patch = bspline_surface_type([1, 1], [0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp], [0.0_dp, 0.0_dp, &
        1.0_dp, &
        1.0_dp], reshape([0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, &
        1.0_dp, 1.0_dp, 1.0_dp], [3, 2, 2]), reshape([1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp], [2, 2]))
    call surface_jet(patch, 0.25_dp, 0.5_dp, at, du, dv)
    call tap%ok(all(at == [0.25_dp, 0.5_dp, 0.125_dp]) .and. all(du == [1.0_dp, 0.0_dp, 0.5_dp]) &
        .and. all(dv == [0.0_dp, 1.0_dp, 0.25_dp]), 'a bilinear patch')
    call tap%finish()

contains

    !> The octant x, y, z >= 0 of the unit sphere over stereographic longitude and latitude.
    type(bspline_surface_type) function octant() result(f)
        real(dp), parameter :: arc(2, 3) = reshape([1.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 0.0_dp, &
            1.0_dp], &
            [2, 3])
        real(dp), parameter :: weight(3) = [1.0_dp, 1.0_dp, 2.0_dp]
        integer :: i, j

        f%degree = 2
        f%u_knot = [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
        f%v_knot = f%u_knot
        allocate (f%pole(3, 3, 3), f%weight(3, 3))
        do j = 1, 3
            do i = 1, 3
                f%pole(:, i, j) = [arc(:, i)*arc(1, j), arc(2, j)]
                f%weight(i, j) = weight(i)*weight(j)
            end do
        end do
    end function octant

    !> A sheet of degree 3 with inner knots along u and 1 along v, with weights.
    type(bspline_surface_type) function sheet() result(f)
        integer :: i, j

        f%degree = [3, 1]
        f%u_knot = [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 2.0_dp, 3.0_dp, 3.0_dp, 3.0_dp, 3.0_dp]
        f%v_knot = [0.0_dp, 0.0_dp, 0.5_dp, 1.0_dp, 1.0_dp]
        allocate (f%pole(3, 6, 3), f%weight(6, 3))
        do j = 1, 3
            do i = 1, 6
                f%pole(:, i, j) = [real(i, dp), real(j*j, dp) + sin(real(i, dp)), real(mod(i*j, &
                    5), dp)]
                f%weight(i, j) = 1.0_dp + 0.25_dp*real(mod(i + j, 3), dp)
            end do
        end do
    end function sheet

end program test_bspline_surface
