!> Second derivatives of B-spline surfaces: a polynomial surface whose derivatives are known.
program test_surface_jet
    use base_kinds, only: dp
    use geom_bicubic, only: bicubic_jet, corners_of_net
    use geom_bspline_surface, only: bspline_surface_type
    use geom_coons, only: patch_jet_type
    use geom_surface_jet, only: second_jet
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(bspline_surface_type) :: surface
    type(patch_jet_type) :: found, wanted
    real(dp) :: off
    integer :: i, j

    surface%degree = 3
    surface%u_knot = [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
    surface%v_knot = surface%u_knot
    allocate (surface%pole(3, 4, 4), surface%weight(4, 4))
    surface%weight = 1.0_dp
    do j = 1, 4
        do i = 1, 4
            surface%pole(:, i, j) = [sin(real(i + 2*j, dp)), cos(real(i*j, dp)), real(i - j, dp)]
        end do
    end do
    off = 0.0_dp
    do i = 0, 10
        associate (u => real(i, dp)/10.0_dp, v => real(mod(3*i, 11), dp)/10.0_dp)
            found = second_jet(surface, u, v)
            wanted = bicubic_jet(corners_of_net(surface%pole), u, v)
            off = max(off, norm2(found%at - wanted%at), norm2(found%u - wanted%u), &
                norm2(found%v - wanted%v), norm2(found%uu - wanted%uu), &
                norm2(found%uv - wanted%uv), norm2(found%vv - wanted%vv))
        end associate
    end do
    call tap%near(off, 0.0_dp, 2.0e-13_dp, 'a surface of one span is the bicubic patch of its net')
    call tap%finish()
end program test_surface_jet
