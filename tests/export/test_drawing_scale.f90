!> Tests of drawings in another unit.
program test_drawing_scale
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_outline, only: cut_type
    use cut_plane, only: in_space
    use cut_request, only: request_type
    use export_drawing, only: drawing_type
    use export_drawing_cut, only: draw_cut
    use export_drawing_line, only: draw_line
    use export_drawing_scale, only: scaled_arc, scaled_drawing
    use geom_arc_point, only: curvature, point
    use geom_place, only: at_shoulder, place_at
    use support_bodies, only: nose_of_the_book
    use support_cutting, only: by_number, cut_of, plane_of
    use support_drawn, only: is_end_to_end
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: inch = 25.4_dp
    type(tap_type) :: tap
    type(body_type) :: body
    type(cut_type) :: cut
    type(request_type) :: request
    type(drawing_type) :: drawing, metric
    type(error_type), allocatable :: error
    real(dp) :: at(2), off, t
    integer :: k

    body = nose_of_the_book()
    request = by_number(plane_of([20.0_dp, 1.0_dp, -10.0_dp], [1.0_dp, 0.0_dp, 0.0_dp]), 9)
    request%skin = 0.05_dp
    request%arcs = 0.01_dp
    cut = cut_of(body, request)
    allocate (drawing%cuts(1), drawing%lines(1))
    drawing%units = 'INCHES'
    drawing%tolerance = 1.0e-3_dp
    call draw_cut(body, cut, 1.0e-3_dp, 2.0_dp, drawing%cuts(1), error)
    call draw_line(body%lines(2), 2, 1.0e-3_dp, drawing%lines(1), error)
    metric = scaled_drawing(drawing, inch, 'MM')
    call tap%same(metric%units, 'MM', 'the unit is said')
    call tap%near(metric%tolerance, 0.0254_dp, 1.0e-17_dp, 'tolerance')
    call tap%near(metric%cuts(1)%skin, 1.27_dp, 1.0e-15_dp, 'thickness of the skin')
    call tap%near(metric%cuts(1)%arcs, 0.254_dp, 1.0e-16_dp, 'tolerance of its arcs')
    call tap%ok(all(abs(metric%cuts(1)%plane%origin - inch*[20.0_dp, 1.0_dp, -10.0_dp]) <= 0.0_dp) &
        .and. all(abs(metric%cuts(1)%plane%through - metric%cuts(1)%plane%origin) <= 0.0_dp), &
        'plane')
    associate (old => drawing%cuts(1)%contours(1), new => metric%cuts(1)%contours(1))
        call tap%ok(all(abs(new%curves(1)%spline%pole - inch*old%curves(1)%spline%pole) &
            <= 0.0_dp), 'poles')
        call tap%near(norm2(new%marks(3)%uv - inch*old%marks(3)%uv), 0.0_dp, 0.0_dp, 'marks')
        call tap%near(new%marks(3)%bevel, old%marks(3)%bevel, 0.0_dp, 'bevels stay')
        off = 0.0_dp
        do k = 0, 100
            t = real(k, dp)/100.0_dp
            at = point(new%curves(1)%arc, place_at(t))
            off = max(off, norm2(at - inch*point(old%curves(1)%arc, place_at(t))))
        end do
        call tap%near(off, 0.0_dp, 3.0e-13_dp, 'the arc is so many times as large')
        call tap%near(curvature(new%curves(1)%arc, at_shoulder)*inch, &
            curvature(old%curves(1)%arc, at_shoulder), 1.0e-16_dp, 'and bends so many times less')
        at = point(scaled_arc(1.0_dp/inch, new%curves(1)%arc), at_shoulder)
        call tap%near(norm2(at - point(old%curves(1)%arc, at_shoulder)), 0.0_dp, 1.0e-14_dp, &
            'there and back again')
        at = in_space_uv()
        call tap%near(norm2(at), 0.0_dp, 3.0e-13_dp, 'arc and spline agree through the plane')
    end associate
    associate (old => drawing%lines(1)%contours(1)%curves(1), &
            new => metric%lines(1)%contours(1)%curves(1))
        call tap%ok(old%error > 0.0_dp .and. abs(new%error - inch*old%error) <= 0.0_dp &
            .and. all(abs(new%worst - inch*old%worst) <= 0.0_dp), 'errors and their places')
    end associate
    call tap%ok(is_end_to_end(metric%cuts(1)), 'curves that met do so')
    deallocate (drawing%lines)
    metric = scaled_drawing(drawing, 2.0_dp, 'HALF INCHES')
    call tap%ok(.not. allocated(metric%lines), 'lines may be missing')
    call tap%finish()

contains

    !> How far the start of the first arc, put in space by the plane, is from that of its spline.
    function in_space_uv() result(apart)
        real(dp) :: apart(2), at(3)
        associate (shape => metric%cuts(1))
            at = in_space(shape%plane, shape%contours(1)%curves(1)%arc%start) &
                - shape%contours(1)%curves(1)%spline%pole(:, 1)
            apart = at(2:)
        end associate
    end function in_space_uv

end program test_drawing_scale
