!> Ducts cut at stations and measured: stations against the rings, areas that cones have.
program test_duct
    use base_kinds, only: dp
    use body_duct, only: duct_type
    use cut_duct, only: duct_measure_type, measure_duct
    use cut_outline, only: cut_type
    use cut_plane, only: station_plane
    use geom_bspline, only: spline_point
    use geom_fairing_system, only: spline_area
    use geom_ring_loft, only: ring_at
    use support_ducts, only: cut_of, duct_through, off_ring, outline_of, s_duct, wheel
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_stations(s_duct())
    call check_measures()
    call tap%finish()

contains

    !> A station is one closed outline, the ring there, begun at its first point; at an outline it
    !> is that outline.
    subroutine check_stations(duct)
        type(duct_type), intent(in) :: duct
        type(cut_type) :: cut
        real(dp), parameter :: sta(6) = [10.0_dp, 13.0_dp, 16.0_dp, 29.99_dp, 30.0_dp, 44.0_dp]
        real(dp), allocatable :: ring(:, :)
        real(dp) :: worst
        logical :: is_whole, begins
        integer :: k, i

        worst = 0.0_dp
        is_whole = .true.
        begins = .true.
        do k = 1, size(sta)
            cut = cut_of(duct%panel, station_plane(sta(k)), .false.)
            is_whole = is_whole .and. size(cut%patched) == 1
            if (.not. is_whole) cycle
            is_whole = cut%patched(1)%is_closed .and. size(cut%patched(1)%points) == 24
            ring = ring_at(duct%loft, sta(k))
            associate (points => cut%patched(1)%points)
                begins = begins .and. norm2(points(1)%at(2:) - (ring(:, 1) + 4.0_dp*ring(:, 2) &
                    + ring(:, 3))/6.0_dp) < 1.0e-13_dp
                do i = 1, size(points)
                    worst = max(worst, off_ring(ring, points(i)%at(2:)))
                end do
            end associate
            do i = 0, 100
                worst = max(worst, off_ring(ring, pick(spline_point(cut%curves(1)%spline, &
                    0.01_dp*real(i, dp)))))
            end do
            is_whole = is_whole .and. cut%curves(1)%is_exact
        end do
        call tap%ok(is_whole, 'a station is one closed outline, exactly a curve')
        call tap%ok(begins, 'begun at its first point')
        call tap%near(worst, 0.0_dp, 1.0e-13_dp, 'and the ring of that station, an outline too')
    end subroutine check_stations

    !> BL and WL of a point.
    pure function pick(at) result(point)
        real(dp), intent(in) :: at(3)
        real(dp) :: point(2)
        point = at(2:)
    end function pick

    !> The table of measures: outlines and stations in order, areas of a cone.
    subroutine check_measures()
        type(duct_type) :: duct
        type(duct_measure_type) :: measure
        real(dp) :: area
        duct = duct_through([outline_of('A', 0.0_dp, wheel(12, [1.0_dp, 2.0_dp], [1.0_dp, 3.0_dp], &
            0.0_dp)), outline_of('B', 4.0_dp, wheel(24, [3.0_dp, 6.0_dp], [3.0_dp, 9.0_dp], &
            0.0_dp))])
        measure = measure_duct(duct, [3.0_dp, 9.0_dp, 1.0_dp, 4.0_dp, -1.0_dp, 3.0_dp])
        call tap%ok(size(measure%section) == 4 .and. all(measure%section%outline == [1, 0, 0, 2]), &
            'outlines and the stations between are measured, each once')
        call tap%near(maxval(abs(measure%section%sta - [0.0_dp, 1.0_dp, 3.0_dp, 4.0_dp])), 0.0_dp, &
            0.0_dp, 'in order')
        area = spline_area(wheel(12, [1.0_dp, 2.0_dp], [0.0_dp, 0.0_dp], 0.0_dp), .true.)
        call tap%near(measure%section(1)%area, area, 1.0e-14_dp, 'the first has the area '// &
            'of its outline')
        call tap%near(measure%section(4)%area, spline_area(wheel(24, [3.0_dp, 6.0_dp], [0.0_dp, &
            0.0_dp], 0.0_dp), .true.), 1.0e-13_dp, 'the last too')
        call tap%near(norm2(measure%section(4)%centroid - [3.0_dp, 9.0_dp]), 0.0_dp, 1.0e-13_dp, &
            'centroids of ellipses are their centres')
        duct = duct_through([outline_of('A', 0.0_dp, wheel(40, [1.0_dp, 1.0_dp], [0.0_dp, 0.0_dp], &
            0.0_dp)), outline_of('B', 4.0_dp, wheel(40, [3.0_dp, 3.0_dp], [0.0_dp, 0.0_dp], &
            0.0_dp))])
        measure = measure_duct(duct, [2.0_dp])
        call tap%near(measure%section(2)%perimeter**2/measure%section(2)%area, &
            4.0_dp*acos(-1.0_dp), 1.0e-5_dp, 'perimeter and area are those of a circle')
        call tap%near(measure%volume, measure%section(1)%area*(27.0_dp - 1.0_dp)*2.0_dp/3.0_dp, &
            1.0e-12_dp, 'the volume of the cone')
    end subroutine check_measures

end program test_duct
