!> Tests of outlines as smooth paths, on an ellipsoid and a cone.
program test_drawing_outside
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, in_space, plane_type, station_plane, waterline_plane
    use cut_request, only: request_type
    use export_drawing_outside, only: outside_type, way_round, way_round_type
    use support_bodies, only: ellipsoid
    use support_cutting, only: by_number, cut_of, plane_of
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: axes(3) = [50.0_dp, 20.0_dp, 30.0_dp], sta = 100.0_dp, wl = 5.0_dp
    type(tap_type) :: tap
    type(body_type) :: body
    type(cut_type) :: cut
    type(way_round_type) :: round
    type(request_type) :: request

    body = ellipsoid(axes, sta, wl)
    call go(station_plane(80.0_dp))
    call tap%ok(size(round%path) == 2 .and. all(round%path%is_arc), 'a station has its arcs')
    call judge('station')
    call go(buttock_plane(7.0_dp))
    call tap%ok(size(round%path) == 2 .and. round%is_closed, &
        'a butt line changes its section where it turns back in STA')
    call judge('butt line')
    call go(waterline_plane(5.0_dp))
    call tap%ok(size(round%path) == 1, 'the waterline of the greatest breadth begins in the nose')
    call judge('waterline')
    call go(waterline_plane(-9.0_dp))
    call judge('another waterline')
    call go(plane_of([100.0_dp, 0.0_dp, 5.0_dp], [1.0_dp, 0.0_dp, 0.4_dp]))
    call judge('canted plane')
    call go(plane_of([100.0_dp, 2.0_dp, 5.0_dp], [1.0_dp, -0.3_dp, 0.4_dp]))
    call tap%ok(round%is_closed, 'a plane with an inclination to BL 0 goes all round')
    call judge('plane canted twice')
    call go(plane_of([80.0_dp, 2.0_dp, 3.0_dp], [-2.0_dp, 0.0_dp, 0.0_dp]))
    call judge('station by point and normal, its origin off the centre')

    request = by_number(buttock_plane(7.0_dp), 5)
    request%limit(1)%has_from = .true.
    request%limit(1)%from = 70.0_dp
    request%limit(1)%has_to = .true.
    request%limit(1)%to = 110.0_dp
    request%limit(3)%has_to = .true.
    request%limit(3)%to = 32.0_dp
    call go_as(request)
    call judge('butt line within limits')
    call tap%ok(size(cut%outlines) == 2, 'limits part it')
    call tap%finish()

contains

    !> The first outline of a cut.
    subroutine go(plane)
        type(plane_type), intent(in) :: plane
        call go_as(by_number(plane, 5))
    end subroutine go

    !> The first outline of a cut as asked.
    subroutine go_as(asked)
        type(request_type), intent(in) :: asked
        cut = cut_of(body, asked)
        call way_round(mirrored_body(body), cut%plane, cut%outlines(1), round)
    end subroutine go_as

    !> Points on the ellipsoid, directions along the paths, even speed, the outside on its side.
    subroutine judge(name)
        character(*), intent(in) :: name
        real(dp) :: off, astray, wrong, slowest, fastest, p(3), q(3), way(3), n(3), gap, t, end(3)
        integer :: i, k

        off = 0.0_dp
        astray = 0.0_dp
        wrong = 1.0_dp
        slowest = huge(1.0_dp)
        fastest = 0.0_dp
        gap = 0.0_dp
        do i = 1, size(round%path)
            associate (path => round%path(i))
                end = path%at(1.0_dp)
                if (i > 1) then
                    q = round%path(i - 1)%at(1.0_dp)
                    gap = max(gap, norm2(q - path%at(0.0_dp)))
                end if
                do k = 0, 1000
                    t = real(k, dp)/1000.0_dp
                    p = path%at(t)
                    q = in_space(cut%plane, p(:2)) - [sta, 0.0_dp, wl]
                    n = q/axes**2
                    off = max(off, abs(sum((q/axes)**2) - 1.0_dp)/(2.0_dp*norm2(n)))
                    way = path%way(t)
                    way = way/norm2(way)
                    q = path%side*(-way(2)*cut%plane%u + way(1)*cut%plane%v)
                    wrong = min(wrong, dot_product(q, n)/norm2(n))
                    if (k == 0) cycle
                    q = path%at(t) - path%at(t - 1.0e-3_dp)
                    slowest = min(slowest, norm2(q))
                    fastest = max(fastest, norm2(q))
                    if (k > 1 .and. k < 1000) astray = max(astray, &
                        abs(q(1)*way(2) - q(2)*way(1))/norm2(q))
                end do
            end associate
        end do
        if (round%is_closed) gap = max(gap, norm2(end - round%path(1)%at(0.0_dp)))
        call tap%near(off, 0.0_dp, 1.0e-12_dp, name//': all points are on the surface')
        call tap%near(gap, 0.0_dp, round%noise, name//': paths meet but for rounding')
        call tap%near(astray, 0.0_dp, 5.0e-3_dp, name//': directions are along the path')
        call tap%ok(wrong > 0.0_dp, name//': the outside is on the side that is said')
        call tap%ok(slowest > 0.0_dp .and. fastest < 15.0_dp*slowest, &
            name//': the parameter stands still nowhere')
    end subroutine judge

end program test_drawing_outside
