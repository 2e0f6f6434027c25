!> Tests of the recognition of conics and straight lines, on curves of closed form.
program test_drawing_conic
    use base_kinds, only: dp
    use export_drawing_conic, only: distance_off, find_conic
    use geom_arc, only: arc_type, line_between, weight
    use geom_arc_point, only: point
    use geom_place, only: place_at
    use support_paths, only: form, plane_path_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc
    type(plane_path_type) :: path
    real(dp), parameter :: noise = 1.0e-13_dp
    real(dp) :: largest, at(2)
    logical :: is_found

    path = plane_path_type(form=form%ellipse, axes=[3.0_dp, 2.0_dp], ends=[0.2_dp, 1.9_dp])
    call find_conic(path, noise, arc, largest, is_found)
    call tap%ok(is_found .and. .not. arc%is_line, 'an arc of an ellipse is one')
    call tap%near(weight(arc), cos(0.85_dp), 1.0e-14_dp, &
        'its weight is the cosine of half its angle')
    at = point(arc, place_at(0.3_dp))
    call tap%near(sum((at/[3.0_dp, 2.0_dp])**2), 1.0_dp, 1.0e-15_dp, &
        'it has the points of the ellipse')
    at = point(arc, place_at(1.0e-3_dp))
    call tap%ok(at(2) > arc%start(2) .and. largest <= noise, 'it runs as the curve')
    path%ends = [0.0_dp, 5.0_dp]
    call find_conic(path, noise, arc, largest, is_found)
    call tap%ok(is_found .and. weight(arc) < 0.0_dp, 'an arc past 180 degrees, too')
    path%is_mute = .true.
    call find_conic(path, noise, arc, largest, is_found)
    call tap%ok(.not. is_found, 'without directions at its ends a curve is fitted')
    path = plane_path_type(form=form%hyperbola, axes=[1.0_dp, 2.0_dp], ends=[-0.5_dp, 1.5_dp])
    call find_conic(path, noise, arc, largest, is_found)
    call tap%ok(is_found .and. weight(arc) > 1.0_dp, 'an arc of a hyperbola is one')
    path = plane_path_type(form=form%parabola, axes=[1.0_dp, 2.0_dp], ends=[-0.5_dp, 1.5_dp])
    call find_conic(path, noise, arc, largest, is_found)
    call tap%ok(is_found, 'an arc of a parabola is one')
    call tap%near(weight(arc), 1.0_dp, 1.0e-14_dp, 'of weight 1')
    path = plane_path_type(form=form%line, axes=[1.0_dp, -2.0_dp], ends=[0.0_dp, 1.0_dp])
    call find_conic(path, noise, arc, largest, is_found)
    call tap%ok(is_found .and. arc%is_line, 'a straight line is one, however it is run along')
    path%is_mute = .true.
    call find_conic(path, noise, arc, largest, is_found)
    call tap%ok(is_found .and. arc%is_line, 'it needs no directions')
    path%ends = [-3.0_dp, 1.0_dp]
    call find_conic(path, noise, arc, largest, is_found)
    call tap%ok(.not. is_found, 'a straight line that goes back on itself is none')
    path = plane_path_type(form=form%cubic, axes=[1.0_dp, 1.0_dp], ends=[0.2_dp, 1.0_dp])
    call find_conic(path, noise, arc, largest, is_found)
    call tap%ok(.not. is_found, 'a cubic is none')
    path%ends = [-1.0_dp, 1.0_dp]
    call find_conic(path, noise, arc, largest, is_found)
    call tap%ok(.not. is_found, 'an S is none')
    path = plane_path_type(form=form%step, axes=[1.0_dp, 1.0e-9_dp])
    call find_conic(path, noise, arc, largest, is_found)
    call tap%ok(.not. is_found, 'a parabola with a jump of 1e-9 is none')
    path = plane_path_type(form=form%ellipse, ends=[1.0_dp, 1.0_dp])
    call find_conic(path, noise, arc, largest, is_found)
    call tap%ok(.not. is_found, 'a point is none')

    path = plane_path_type(form=form%ellipse, axes=[5.0_dp, 5.0_dp], ends=[0.1_dp, 1.3_dp])
    call find_conic(path, noise, arc, largest, is_found)
    call tap%near(distance_off(arc, 5.001_dp*[cos(0.7_dp), sin(0.7_dp)]), 1.0e-3_dp, 1.0e-6_dp, &
        'the distance from a circle, outside')
    call tap%near(distance_off(arc, 4.999_dp*[cos(0.1_dp), sin(0.1_dp)]), 1.0e-3_dp, 1.0e-6_dp, &
        'inside, at its end')
    call tap%near(distance_off(line_between([1.0_dp, 1.0_dp], [4.0_dp, 5.0_dp]), &
        [1.0_dp, 6.0_dp]), 3.0_dp, 1.0e-15_dp, 'from a straight line')
    call tap%finish()
end program test_drawing_conic
