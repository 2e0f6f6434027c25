!> A surface split across u: both parts are the surface, and have a row of poles in common.
program test_surface_split
    use base_kinds, only: dp
    use body_duct, only: duct_type
    use geom_bspline_surface, only: bspline_surface_type, surface_point
    use geom_surface_split, only: split_surface
    use support_ducts, only: s_duct
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(duct_type) :: duct
    type(bspline_surface_type) :: part(2)
    real(dp), parameter :: at(3) = [0.5_dp, 0.3_dp, 1.0_dp/3.0_dp]
    real(dp) :: worst, u, v
    integer :: i, k, n

    duct = s_duct()
    do k = 1, size(at)
        call split_surface(duct%panel%surface, duct%panel%surface%u_knot( &
            minloc(abs(duct%panel%surface%u_knot - at(k)), dim=1)), part(1), part(2))
        if (k == 2) call split_surface(duct%panel%surface, at(k), part(1), part(2))
        worst = 0.0_dp
        do i = 0, 400
            u = real(mod(i, 20), dp)/20.0_dp
            v = real(i/20, dp)/20.0_dp
            n = merge(1, 2, u < part(2)%u_knot(1))
            worst = max(worst, norm2(surface_point(part(n), u, v) &
                - surface_point(duct%panel%surface, u, v)))
        end do
        call tap%near(worst, 0.0_dp, 2.0e-14_dp, 'the parts are the surface')
        n = size(part(1)%pole, 2)
        call tap%ok(all(abs(part(1)%pole(:, n, :) - part(2)%pole(:, 1, :)) <= 0.0_dp), &
            'they have a row of poles in common')
        call tap%ok(size(part(1)%u_knot) == n + 4 .and. &
            size(part(2)%u_knot) == size(part(2)%pole, 2) + 4 .and. &
            all(shape(part(2)%weight) == shape(part(2)%pole(1, :, :))), 'and knots as they must')
    end do
    call tap%finish()
end program test_surface_split
