!> Outlines of planes along a body: cones and paraboloids, whose cuts are the conics of old; a
!> composite line; several outlines of one plane.
program test_lengthwise
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type, finish_body
    use cut_lengthwise, only: lengthwise_outlines
    use cut_outline, only: cut_point_type, outline_type
    use cut_plane, only: buttock_plane, waterline_plane
    use cut_request, only: request_type
    use geom_arc, only: end_type
    use geom_chain, only: chain_type, new_chain
    use geom_arc, only: arc_type, line_between
    use support_bodies, only: conic_view, straight_view, tapered
    use support_cutting, only: by_number, by_step, plane_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(outline_type), allocatable :: outlines(:)
    type(error_type), allocatable :: error

    call check_cone()
    call check_paraboloid()
    call check_hourglass()
    call tap%finish()

contains

    !> A cone of radius STA/2: a buttock is a hyperbola, a plane along a generator a parabola.
    subroutine check_cone()
        type(body_type) :: body
        real(dp), allocatable :: x(:), y(:)
        body = tapered(ray(5.0_dp), ray(3.0_dp), ray(4.0_dp), ray(-4.0_dp), ray(-5.0_dp))
        call lengthwise_outlines(body, by_number(waterline_plane(1.0_dp), 9), outlines, error)
        call tap%ok(size(outlines) == 1 .and. .not. outlines(1)%is_closed, &
            'a waterline of a cone is one open outline')
        associate (points => outlines(1)%points)
            call tap%near(maxval(abs(points%at(1)**2/4.0_dp - points%at(2)**2 - 1.0_dp)), 0.0_dp, &
                2.0e-14_dp, &
                'a hyperbola')
            call tap%near(points(1)%at(1), 2.0_dp, 1.0e-15_dp, 'from its vertex')
            call tap%near(points(1)%curvature, -2.0_dp, 1.0e-13_dp, 'where it turns by a/b**2')
            call tap%ok(points(1)%slope%is_vertical, 'and is vertical')
        end associate
        call lengthwise_outlines(body, by_number(plane_of([2.0_dp, 0.0_dp, 1.0_dp - 2.0_dp], &
            [1.0_dp, 0.0_dp, -2.0_dp]), 9), outlines, error)
        call tap%ok(size(outlines) == 1, 'a plane along a generator cuts one outline')
        allocate (x(0))
        x = outlines(1)%points%uv(1)
        allocate (y(0))
        y = outlines(1)%points%uv(2)
        call tap%near(maxval(abs((y - y(1))/max(x**2, 1.0e-30_dp)*x**2 - (y(size(y)) - y(1)) &
            *x**2/x(size(x))**2)), 0.0_dp, 1.0e-13_dp, 'a parabola in its true shape')
        call lengthwise_outlines(body, by_number(buttock_plane(0.0_dp), 3), outlines, error)
        call tap%ok(size(outlines) == 1 .and. .not. outlines(1)%is_closed, &
            'the profile is joined at the point')
        call tap%ok(.not. any(outlines(1)%points(3:4)%has_slope), 'where there is no slope')
        call tap%ok(all(outlines(1)%points([1, 2, 5, 6])%has_slope), 'as there is elsewhere')
    end subroutine check_cone

    !> A straight view from the origin to (10, rise).
    type(chain_type) function ray(rise)
        real(dp), intent(in) :: rise
        ray = straight_view([0.0_dp, 0.0_dp], [10.0_dp, rise])
    end function ray

    !> A paraboloid BL**2 + WL**2 = STA: every plane along STA cuts the same parabola.
    subroutine check_paraboloid()
        type(body_type) :: body
        body = tapered(bow(1.0_dp), bow(0.6_dp), bow(0.8_dp), bow(-0.8_dp), bow(-1.0_dp))
        call lengthwise_outlines(body, by_step(buttock_plane(2.0_dp), 1, 4000), outlines, error)
        call tap%ok(size(outlines) == 1 .and. size(outlines(1)%pieces) == 2, &
            'a buttock of a paraboloid goes over both sections')
        associate (points => outlines(1)%points)
            call tap%near(maxval(abs(points%at(3)**2 + 4.0_dp - points%at(1))), 0.0_dp, &
                1.0e-13_dp, &
                'is a parabola')
            call tap%ok(size(points) == 8, 'has a point each side at every step and end')
            call tap%near(maxval(abs(abs(points%curvature) &
                - 2.0_dp/(1.0_dp + 4.0_dp*points%at(3)**2)**1.5_dp)), 0.0_dp, 1.0e-12_dp, &
                    'as curved as one')
        end associate
        call lengthwise_outlines(body, by_number(plane_of([4.0_dp, 0.0_dp, 0.0_dp], [1.0_dp, &
            0.0_dp, 1.0_dp]), 9), &
            outlines, error)
        call tap%near(maxval(abs(outlines(1)%points%at(2)**2 &
            + (outlines(1)%points%at(3) + 0.5_dp)**2 &
            - 4.25_dp)), 0.0_dp, 1.0e-13_dp, &
                'a canted plane cuts an ellipse that is a circle in plan of stations')
    end subroutine check_paraboloid

    !> A parabola r = k sqrt(STA) to station 16.
    type(chain_type) function bow(k)
        real(dp), intent(in) :: k
        bow = conic_view(end_type([0.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), [4.0_dp, 2.0_dp*k], &
            end_type([16.0_dp, 4.0_dp*k], [8.0_dp, k]))
    end function bow

    !> Two cones point to point at station 10, of radius 5 at 0 and 20: composite lines.
    subroutine check_hourglass()
        type(body_type) :: body
        body = tapered(waist(5.0_dp), waist(3.0_dp), waist(4.0_dp), waist(-4.0_dp), waist(-5.0_dp))
        call lengthwise_outlines(body, by_number(waterline_plane(2.0_dp), 5), outlines, error)
        call tap%ok(size(outlines) == 2, 'a waterline of two cones is two outlines')
        call tap%ok(.not. any(outlines%is_closed), 'both open')
        call tap%near(outlines(1)%points(5)%at(1), 6.0_dp, 1.0e-14_dp, 'one to station 6')
        call tap%near(outlines(2)%points(1)%at(1), 14.0_dp, 1.0e-14_dp, 'one from station 14')
    end subroutine check_hourglass

    !> A view that is `rise` at both ends and nothing in the middle, all but a millionth.
    type(chain_type) function waist(rise)
        real(dp), intent(in) :: rise
        call new_chain([line_between([0.0_dp, rise], [10.0_dp, 0.0_dp]), &
            line_between([10.0_dp, 0.0_dp], [20.0_dp, rise])], waist, error)
        if (allocated(error)) error stop 'a view of a test is no chain'
    end function waist

end program test_lengthwise
