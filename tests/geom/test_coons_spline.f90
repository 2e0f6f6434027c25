!> Patches between splines: the B-spline surface is the patch, and keeps its sides.
program test_coons_spline
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_bspline, only: bspline_type, spline_point
    use geom_bspline_surface, only: bspline_surface_type, surface_jet, surface_point
    use geom_coons, only: coons_jet, coons_point, coons_type, new_coons, patch_jet_type, twist_gaps
    use geom_coons_blend, only: blend
    use geom_coons_spline, only: coons_surface, new_spline_frame, spline_frame_type
    use geom_curve_fit, only: fit_curve
    use support_hump, only: hump_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_surface(tap)
    call tap%finish()

contains

    !> Each blend: surface against the patch by its formula, sides against the curves.
    subroutine check_surface(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(spline_frame_type) :: frame
        type(bspline_surface_type) :: surface
        type(bspline_type) :: side(4)
        type(coons_type) :: patch
        type(patch_jet_type) :: jet, corner
        type(error_type), allocatable :: error
        real(dp) :: off, edge, worst, place, point(3), du(3), dv(3)
        integer :: kind, i, j

        do i = 1, 4
            call fit_curve(hump_type(side=i), 1.0e-9_dp, side(i), worst, place, error)
            call tap%ok(.not. allocated(error), 'a side is a spline')
        end do
        do kind = blend%linear, blend%slopes
            frame = new_spline_frame(side, has_twists=kind == blend%slopes)
            patch = new_coons(frame, kind)
            call coons_surface(frame, kind, surface, error)
            call tap%ok(.not. allocated(error), 'a patch is a surface')
            off = 0.0_dp
            edge = 0.0_dp
            do j = 0, 30
                do i = 0, 30
                    associate (u => real(i, dp)/30.0_dp, v => real(j, dp)/30.0_dp)
                        jet = coons_jet(patch, u, v)
                        call surface_jet(surface, u, v, point, du, dv)
                        off = max(off, norm2(point - jet%at), 0.01_dp*norm2(du - jet%u), &
                            0.01_dp*norm2(dv - jet%v))
                    end associate
                end do
                associate (t => real(j, dp)/30.0_dp)
                    edge = max(edge, off_side(surface_point(surface, t, 0.0_dp), 1, t), &
                        off_side(surface_point(surface, 1.0_dp, t), 2, t), &
                        off_side(surface_point(surface, t, 1.0_dp), 3, t), &
                        off_side(surface_point(surface, 0.0_dp, t), 4, t))
                end associate
            end do
            call tap%near(off, 0.0_dp, 1.0e-13_dp, 'the surface is the patch')
            call tap%near(edge, 0.0_dp, 2.0e-9_dp, 'its edges are the sides')
        end do
        call tap%near(maxval(twist_gaps(frame)), 0.0_dp, 1.0e-13_dp, 'its twists fit together')
        corner = coons_jet(new_coons(new_spline_frame(side, has_twists=.false.), blend%slopes), &
            0.3_dp, 0.6_dp)
        call tap%near(norm2(corner%at &
            - coons_point(new_coons(frame, blend%cubic), 0.3_dp, 0.6_dp)), 0.0_dp, 1.0e-14_dp, &
            'slopes without twists are the blend by cubics')
        corner = coons_jet(new_coons(frame, blend%linear), 1.0_dp, 0.0_dp)
        call tap%near(norm2(frame%twist(:, 1, 0) - corner%uv), 0.0_dp, 1.0e-13_dp, &
            'its twists are those of the linear blend')
    end subroutine check_surface

    !> How far a point is from that of a side.
    real(dp) function off_side(point, side, t)
        real(dp), intent(in) :: point(3)    !! on the patch
        integer, intent(in) :: side         !! which
        real(dp), intent(in) :: t           !! where
        type(hump_type) :: hump
        hump%side = side
        off_side = norm2(point - hump%at(t))
    end function off_side

end program test_coons_spline
