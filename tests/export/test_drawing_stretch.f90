!> Tests of control lines between joints: exact where they can be, against closed forms.
program test_drawing_stretch
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_line, only: line_type
    use export_drawing, only: curve_type
    use export_drawing_stretch, only: draw_stretch, stretch_of, stretch_type
    use geom_bezier, only: bezier_raised
    use geom_bspline, only: spline_point
    use geom_chain, only: chain_type, chain_value, new_chain
    use geom_stroke, only: bezier_stroke
    use geom_triangle, only: end_type
    use support_bodies, only: conic_view, constant_view, control_line, half_ellipse, straight_view
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(chain_type) :: none, arch, ramp, bend
    type(curve_type) :: curve
    type(stretch_type) :: stretch
    real(dp), parameter :: ends(2) = [10.0_dp, 50.0_dp]
    real(dp) :: before(3), next(3), slowest, fastest
    integer :: k

    arch = half_ellipse(30.0_dp, 20.0_dp, 1.0_dp, 8.0_dp)
    ramp = straight_view([10.0_dp, 2.0_dp], [50.0_dp, 6.0_dp])
    bend = conic_view(end_type([10.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), [20.0_dp, 4.0_dp], &
        end_type([50.0_dp, 6.0_dp], [1.0_dp, 0.0_dp]))

    call go(control_line('A', arch, none), 'on BL 0')
    call tap%ok(curve%is_exact .and. curve%is_conic, 'a conic on BL 0 is itself')
    call on_arch(3, 8.0_dp)
    call go(control_line('B', arch, constant_view(3.0_dp)), 'along a butt line')
    call tap%ok(curve%is_exact .and. curve%is_conic, 'a conic in a butt line, too')
    call tap%ok(all(abs(curve%spline%pole(2, :) - 3.0_dp) <= 0.0_dp), 'in it to the last bit')
    call go(control_line('C', constant_view(4.0_dp), arch), 'along a waterline')
    call tap%ok(curve%is_exact .and. .not. curve%is_conic, &
        'in a waterline it is exact, but no conic of the side view')
    call on_arch(2, 8.0_dp)
    call go(control_line('D', ramp, arch), 'on a slope')
    call tap%ok(curve%is_exact, 'a conic in plan over a straight side view is exact')
    call on_arch(2, 8.0_dp)
    call on_ramp(3)
    call go(control_line('E', arch, ramp), 'leaning')
    call tap%ok(curve%is_exact, 'and so is the other way round')
    call on_ramp(2)
    call go(control_line('F', ramp, constant_view(1.0_dp)), 'straight')
    call tap%ok(curve%is_exact .and. curve%spline%degree == 1, 'a straight line is of degree 1')
    call go(control_line('G', constant_view(2.0_dp), constant_view(1.0_dp)), 'constant')
    call tap%ok(curve%is_exact .and. curve%spline%degree == 1, 'a line of two constants, too')
    call go(control_line('H', arch, half_ellipse(30.0_dp, 20.0_dp, 0.0_dp, -3.0_dp)), &
        'of two arches')
    call tap%ok(curve%is_exact, 'two views that are images of each other are one conic in space')
    call on_arch(3, 8.0_dp)
    call go(control_line('I', arch, bend), 'of two conics')
    call tap%ok(.not. curve%is_exact .and. curve%error <= 1.0e-6_dp .and. curve%error > 0.0_dp, &
        'two other conics are fitted')
    call on_arch(3, 8.0_dp)
    slowest = 0.0_dp
    do k = 1, 200
        next = spline_point(curve%spline, real(k, dp)/200.0_dp)
        if (next(1) > 15.0_dp) slowest = max(slowest, abs(next(2) - chain_value(bend, next(1))))
    end do
    call tap%near(slowest, 0.0_dp, 2.0e-6_dp, 'the plan is as near')
    stretch = stretch_of(control_line('I', arch, bend), ends)
    slowest = huge(1.0_dp)
    fastest = 0.0_dp
    before = stretch%at(0.0_dp)
    do k = 1, 1000
        next = stretch%at(real(k, dp)/1000.0_dp)
        slowest = min(slowest, norm2(next - before))
        fastest = max(fastest, norm2(next - before))
        before = next
    end do
    call tap%ok(fastest < 4.0_dp*slowest, 'its vertical ends are run through at an even speed')
    call check_degrees()
    call tap%finish()

contains

    !> Draws a line from end to end within 1e-6.
    subroutine go(line, name)
        type(line_type), intent(in) :: line
        character(*), intent(in) :: name
        type(error_type), allocatable :: error
        real(dp) :: at(3)
        call draw_stretch(stretch_of(line, ends), 1.0e-6_dp, curve, error)
        call tap%ok(.not. allocated(error), 'a line '//name//' is drawn')
        at = spline_point(curve%spline, 1.0_dp)
        call tap%near(at(1), ends(2), 0.0_dp, 'to its last station')
    end subroutine go

    !> Bezier lines: exact to degree 9, in pieces of degree 5 above, exact again where only raised.
    subroutine check_degrees()
        type(chain_type) :: wavy
        real(dp) :: pole(2, 25), worst, at(3)
        integer :: i

        pole = 0.0_dp
        do i = 1, 25
            pole(:, i) = [10.0_dp + 40.0_dp*real(i - 1, dp)/24.0_dp, &
                8.0_dp + 9.0_dp*sin(real(i, dp))]
        end do
        wavy = bezier_view(pole)
        call go(control_line('J', wavy, constant_view(3.0_dp)), 'of degree 24')
        call tap%ok(curve%spline%degree == 5 .and. .not. curve%is_exact, 'is drawn in degree 5')
        call tap%ok(curve%error > 0.0_dp .and. curve%error <= 1.0e-6_dp, 'within the tolerance')
        worst = 0.0_dp
        do i = 0, 1000
            at = spline_point(curve%spline, real(i, dp)/1000.0_dp)
            worst = max(worst, abs(at(3) - chain_value(wavy, at(1))))
        end do
        call tap%ok(worst <= 2.0e-6_dp .and. worst > 0.0_dp, 'as is seen along it')
        pole(1, :9) = [(10.0_dp + 5.0_dp*real(i - 1, dp), i=1, 9)]
        call go(control_line('K', bezier_view(pole(:, :9)), constant_view(3.0_dp)), 'of degree 8')
        call tap%ok(curve%spline%degree == 8 .and. curve%is_exact, 'is itself')
        do i = 9, 12
            pole(:, :i + 1) = bezier_raised(pole(:, :i))
        end do
        call go(control_line('L', bezier_view(pole(:, :13)), constant_view(3.0_dp)), 'raised to 12')
        call tap%ok(curve%spline%degree == 8 .and. curve%is_exact, 'is of degree 8 again')
    end subroutine check_degrees

    !> A Bezier curve as a view.
    type(chain_type) function bezier_view(pole) result(view)
        real(dp), intent(in) :: pole(:, :)
        type(error_type), allocatable :: error
        call new_chain([bezier_stroke(pole)], 0.0_dp, view, error)
        call tap%ok(.not. allocated(error), 'a Bezier curve is a view')
    end function bezier_view

    !> Judges a view against the arch.
    subroutine on_arch(axis, rise)
        integer, intent(in) :: axis
        real(dp), intent(in) :: rise
        call tap%near(off_arch(axis, rise), 0.0_dp, max(curve%error, 1.0e-14_dp), &
            'its points are on the ellipse')
    end subroutine on_arch

    !> How far a view is from an arch 1 above zero, across it.
    real(dp) function off_arch(axis, rise) result(off)
        integer, intent(in) :: axis
        real(dp), intent(in) :: rise
        real(dp) :: at(3), q(2)
        integer :: i
        off = 0.0_dp
        do i = 0, 200
            at = spline_point(curve%spline, real(i, dp)/200.0_dp)
            q = [(at(1) - 30.0_dp)/20.0_dp, (at(axis) - 1.0_dp)/max(rise, 1.0_dp)]
            off = max(off, abs(sum(q**2) - 1.0_dp)/(2.0_dp*norm2(q/[20.0_dp, max(rise, 1.0_dp)])))
        end do
    end function off_arch

    !> Judges a view against the ramp.
    subroutine on_ramp(axis)
        integer, intent(in) :: axis
        real(dp) :: at(3), off
        integer :: i
        off = 0.0_dp
        do i = 0, 200
            at = spline_point(curve%spline, real(i, dp)/200.0_dp)
            off = max(off, abs(at(axis) - 1.0_dp - 0.1_dp*at(1)))
        end do
        call tap%near(off, 0.0_dp, 2.0e-15_dp, 'its points are on the slope')
    end subroutine on_ramp

end program test_drawing_stretch
