!> Cuts of bodies of closed form: ellipsoids by planes of all kinds, near and far from the datum;
!> which outlines there are, open or closed; planes that touch and miss; the body is the same
!> however it is said.
program test_make
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_body, only: body_type, finish_body
    use cut_make, only: make_cut
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, cut_kind, oblique_plane, plane_type, station_plane, &
        waterline_plane
    use cut_request, only: request_type
    use support_bodies, only: ellipsoid, nose_of_the_book
    use support_cutting, only: by_number, cut_of, misses_of, misses_type, plane_of
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: axes(3) = [3.0_dp, 2.0_dp, 1.0_dp]
    type(tap_type) :: tap
    type(random_type) :: random

    call check_random_planes([0.0_dp, 0.0_dp, 0.0_dp], 'about the datum')
    call check_random_planes([1000.0_dp, 0.0_dp, -50.25_dp], 'far from the datum')
    call check_kinds()
    call check_touching()
    call check_beyond()
    call check_same_body()
    call tap%finish()

contains

    !> Every point is on the ellipsoid and on the plane; planes miss where they must.
    subroutine check_random_planes(centre, where)
        real(dp), intent(in) :: centre(3)
        character(*), intent(in) :: where
        type(misses_type) :: one
        real(dp) :: worst(6), a(3), disagreement
        type(body_type) :: body
        type(plane_type) :: plane
        type(cut_type) :: cut
        integer :: i, wrong, open, points
        logical :: hits

        worst = 0.0_dp
        disagreement = 0.0_dp
        wrong = 0
        open = 0
        points = 0
        do i = 1, 80
            a = [random%between(1.0_dp, 5.0_dp), random%between(1.0_dp, 3.0_dp), &
                random%between(1.0_dp, 3.0_dp)]
            body = ellipsoid(a, centre(1), centre(3))
            plane = random_plane(i, a, centre)
            cut = cut_of(body, by_number(plane, 9))
            hits = abs(dot_product(plane%normal, plane%through - centre)) < norm2(a*plane%normal)
            if (hits .neqv. size(cut%outlines) == 1) wrong = wrong + 1
            if (plane%kind == cut_kind%plane) open = open + count(.not. cut%outlines%is_closed)
            one = misses_of(cut, a, centre)
            worst = max(worst, [one%surface, one%plane, one%normal, one%bevel, one%slope, &
                one%curvature])
            disagreement = max(disagreement, cut%disagreement)
            points = points + one%points
        end do
        call tap%ok(wrong == 0, 'a plane that meets gives one outline, others none, '//where)
        call tap%ok(open == 0, 'a general plane gives closed outlines, '//where)
        call tap%ok(points > 600, 'there are hundreds of points, '//where)
        call tap%near(worst(1), 0.0_dp, 1.0e-15_dp*(10.0_dp + norm2(centre)), &
            'points are on the surface, '//where)
        call tap%near(worst(2), 0.0_dp, 1.0e-15_dp*(10.0_dp + norm2(centre)), &
            'points are on the plane, '//where)
        call tap%near(worst(3), 0.0_dp, 1.0e-11_dp*(1.0_dp + norm2(centre)), 'normals, '//where)
        call tap%near(worst(4), 0.0_dp, 1.0e-11_dp*(1.0_dp + norm2(centre)), 'bevels, '//where)
        call tap%near(worst(5), 0.0_dp, 1.0e-11_dp*(1.0_dp + norm2(centre)), 'slopes, '//where)
        call tap%near(worst(6), 0.0_dp, 1.0e-10_dp*(1.0_dp + norm2(centre)), 'curvatures, '//where)
        call tap%near(disagreement, 0.0_dp, 1.0e-10_dp, 'both ways agree, '//where)
    end subroutine check_random_planes

    !> A plane of every kind but a station in turn.
    function random_plane(i, a, centre) result(plane)
        integer, intent(in) :: i
        real(dp), intent(in) :: a(3), centre(3)
        type(plane_type) :: plane
        type(error_type), allocatable :: error
        real(dp) :: point(3), other(3)

        point = centre + a*[random%between(-1.0_dp, 1.0_dp), random%between(-1.0_dp, 1.0_dp), &
            random%between(-1.0_dp, 1.0_dp)]
        other = centre + a*[random%between(-1.0_dp, 1.0_dp), random%between(-1.0_dp, 1.0_dp), &
            random%between(-1.0_dp, 1.0_dp)]
        select case (mod(i, 4))
        case (0)
            plane = buttock_plane(point(2))
        case (1)
            plane = waterline_plane(point(3))
        case (2)
            call oblique_plane(point([1, 3]), other([1, 3]), plane, error)
        case default
            plane = plane_of(point, other - centre)
        end select
    end function random_plane

    !> What outlines there are.
    subroutine check_kinds()
        type(body_type) :: body
        type(cut_type) :: cut
        body = ellipsoid(axes, 0.0_dp, 0.0_dp)
        cut = cut_of(body, by_number(station_plane(1.0_dp), 25))
        call tap%ok(size(cut%outlines) == 1 .and. all(cut%outlines%is_closed .eqv. .false.), &
            'a station of the starboard half is one open outline')
        call tap%ok(size(cut%outlines(1)%points) == 50, 'with 25 points a section')
        call tap%ok(all(cut%outlines(1)%pieces%is_arc), 'of conic arcs')
        call tap%ok(all(cut%outlines(1)%points%curvature > 0.0_dp), &
            'which turns left on the way from keel to crown')
        cut = cut_of(body, by_number(waterline_plane(0.0_dp), 5))
        call tap%ok(size(cut%outlines) == 1 .and. size(cut%outlines(1)%pieces) == 1, &
            'a waterline along the line where two sections meet is there once')
        cut = cut_of(body, by_number(buttock_plane(0.0_dp), 5))
        call tap%ok(size(cut%outlines) == 1 .and. cut%outlines(1)%is_closed, &
            'the profile, keel and crown, is one closed outline')
        call tap%ok(cut%outlines(1)%points(1)%at(1) < -2.99_dp, 'from the nose on')
        call tap%ok(all(cut%outlines(1)%points%curvature >= 0.0_dp), 'counter-clockwise')
        cut = cut_of(body, by_number(buttock_plane(-0.5_dp), 5))
        call tap%ok(size(cut%outlines) == 1 .and. all(cut%outlines(1)%pieces%is_image), &
            'a buttock to port is cut from the mirrored half')
        cut = cut_of(body, by_number(plane_of([0.5_dp, 1.5_dp, 0.6_dp], [0.2_dp, 1.0_dp, &
            1.0_dp]), 7))
        call tap%ok(size(cut%outlines(1)%pieces) == 2 .and. cut%outlines(1)%is_closed, &
            'an island within one section is a closed outline of two branches')
        call tap%ok(size(cut%outlines(1)%points) == 12, 'whose turning points are said once')
    end subroutine check_kinds

    !> Planes that only touch.
    subroutine check_touching()
        type(body_type) :: body
        type(cut_type) :: cut
        body = ellipsoid(axes, 0.0_dp, 0.0_dp)
        cut = cut_of(body, by_number(buttock_plane(2.0_dp), 5))
        call tap%ok(size(cut%outlines) == 0, 'a buttock that touches has no outline')
        cut = cut_of(body, by_number(waterline_plane(1.0_dp), 5))
        call tap%ok(size(cut%outlines) == 0, 'a waterline that touches has no outline')
        cut = cut_of(body, by_number(waterline_plane(1.0_dp - 1.0e-9_dp), 5))
        call tap%ok(size(cut%outlines) == 1, 'one a thousand-millionth below has')
        cut = cut_of(body, by_number(waterline_plane(1.1_dp), 5))
        call tap%ok(size(cut%outlines) == 0, 'a waterline above has none')
        cut = cut_of(body, by_number(station_plane(3.0_dp), 5))
        call tap%ok(size(cut%outlines) == 1, 'the station of the tail is a point')
        if (size(cut%outlines) == 1) call tap%ok(size(cut%outlines(1)%points) == 1 .and. &
            size(cut%outlines(1)%pieces) == 0 .and. &
            .not. cut%outlines(1)%points(1)%has_slope, 'without slope or piece')
    end subroutine check_touching

    !> Cuts where the lines are not.
    subroutine check_beyond()
        type(cut_type) :: cut
        type(error_type), allocatable :: error
        type(request_type) :: request

        call make_cut(nose_of_the_book(), by_number(station_plane(60.0_dp), 5), cut, error)
        call tap%ok(allocated(error), 'a station behind all lines is an error')
        if (.not. allocated(error)) return
        call tap%ok(error%cause == cause%beyond_lines, 'of that cause')
        call tap%same(error%message, 'the cut is beyond line LCL, which goes from station -30. '// &
            'to 50.; cut there, or lengthen the line', 'which names a line and its range')
        request = by_number(waterline_plane(-16.0_dp), 5)
        request%limit(1)%has_to = .true.
        request%limit(1)%to = -31.0_dp
        call make_cut(nose_of_the_book(), request, cut, error)
        call tap%ok(allocated(error), 'so is a waterline that ends before them')
    end subroutine check_beyond

    !> Sections reversed or in another order give the same surface.
    subroutine check_same_body()
        type(body_type) :: body, other
        type(cut_type) :: one, two
        type(plane_type) :: plane

        body = ellipsoid(axes, 0.0_dp, 0.0_dp)
        other = body
        other%sections = body%sections(2:1:-1)
        other%sections%line(1) = body%sections(2:1:-1)%line(3)
        other%sections%line(3) = body%sections(2:1:-1)%line(1)
        other%sections%slope(1) = body%sections(2:1:-1)%slope(2)
        other%sections%slope(2) = body%sections(2:1:-1)%slope(1)
        call finish_body(other)
        plane = plane_of([0.5_dp, 0.2_dp, 0.1_dp], [1.0_dp, 2.0_dp, 3.0_dp])
        one = cut_of(body, by_number(plane, 5))
        two = cut_of(other, by_number(plane, 5))
        call tap%ok(size(one%outlines) == 1 .and. size(two%outlines) == 1, &
            'sections run backwards cut alike')
        call tap%near(maxval(abs(one%outlines(1)%points%at(1) - two%outlines(1)%points%at(1))), &
            0.0_dp, &
            1.0e-5_dp, 'at the same points')
        call tap%near(maxval(abs(one%outlines(1)%points%normal(3) &
            - two%outlines(1)%points%normal(3))), 0.0_dp, &
            1.0e-5_dp, 'with normals outwards')
        one = cut_of(body, by_number(station_plane(1.0_dp), 9))
        two = cut_of(other, by_number(station_plane(1.0_dp), 9))
        call tap%near(maxval(abs(one%outlines(1)%points%at(2) &
            - two%outlines(1)%points(18:1:-1)%at(2))), &
            0.0_dp, 1.0e-11_dp, 'and a station runs the other way')
    end subroutine check_same_body

end program test_make
