!> Splines as curves for arcs. Oracle: the parabola y = x**2 over x from 2 to 6, its knots from 3
!> to 5.
program test_plane_spline
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc_chain, only: arcs_along, chain_arc_type
    use geom_plane_spline, only: plane_spline_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(plane_spline_type) :: f
    type(chain_arc_type), allocatable :: arcs(:)
    type(error_type), allocatable :: error
    real(dp), dimension(2) :: point, first, second
    real(dp) :: worst(3), t, x
    integer :: i

    f%spline%degree = 2
    f%spline%knot = [3.0_dp, 3.0_dp, 3.0_dp, 5.0_dp, 5.0_dp, 5.0_dp]
    f%spline%weight = [1.0_dp, 1.0_dp, 1.0_dp]
    f%spline%pole = reshape([2.0_dp, 4.0_dp, 4.0_dp, 12.0_dp, 6.0_dp, 36.0_dp], [2, 3])
    worst = 0.0_dp
    do i = 0, 20
        t = real(i, dp)/20.0_dp
        x = 2.0_dp + 4.0_dp*t
        call f%jet(t, point, first, second)
        worst = max(worst, [norm2(point - [x, x**2]), norm2(first - [4.0_dp, 8.0_dp*x]), &
            norm2(second - [0.0_dp, 32.0_dp])])
    end do
    call tap%near(worst(1), 0.0_dp, 1.0e-13_dp, 'its parameter goes from 0 to 1')
    call tap%near(worst(2), 0.0_dp, 1.0e-13_dp, 'so does that of its derivative')
    call tap%near(worst(3), 0.0_dp, 1.0e-12_dp, 'and of its second one')
    call arcs_along(f, 0.01_dp, arcs, error)
    call tap%ok(.not. allocated(error), 'arcs follow it')
    call tap%ok(all(arcs%deviation <= 0.01_dp) .and. size(arcs) > 1, 'within the tolerance')
    call tap%near(norm2(arcs(size(arcs))%arc%finish - [6.0_dp, 36.0_dp]), 0.0_dp, 1.0e-13_dp, &
        'to its end')
    ! A drop that begins and ends at one point, both times to the right.
    f%spline%degree = 4
    f%spline%knot = [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
    f%spline%weight = [1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
    f%spline%pole = reshape([0.0_dp, 0.0_dp, 2.0_dp, 0.0_dp, 0.0_dp, 3.0_dp, -2.0_dp, 0.0_dp, &
        0.0_dp, 0.0_dp], [2, 5])
    call arcs_along(f, 0.01_dp, arcs, error)
    call tap%ok(.not. allocated(error) .and. size(arcs) > 4, 'a closed curve has arcs')
    call tap%near(sum(arcs%arc%turn), 2.0_dp*pi, 1.0e-9_dp, 'that turn once')
    call tap%finish()
end program test_plane_spline
