!> Ducts cut by any plane: against de Boor's scheme, a cone, the line of first points; images.
program test_duct_cuts
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_duct, only: duct_type
    use body_panel, only: mirrored_panel, panel_type
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, height_over, plane_through, plane_type, station_plane, &
        waterline_plane
    use geom_bspline, only: spline_point
    use geom_bspline_surface, only: bspline_surface_type
    use geom_ring_loft, only: ring_at
    use support_ducts, only: cut_of, duct_through, off_ring, outline_of, s_duct, wheel
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(duct_type) :: duct

    duct = s_duct()
    call check_oblique(duct, [30.0_dp, 22.0_dp, 5.0_dp], [1.0_dp, 0.4_dp, -0.3_dp])
    call check_oblique(duct, [20.0_dp, 20.0_dp, 1.0_dp], [0.3_dp, 1.0_dp, 0.2_dp])
    call check_seam()
    call check_images(duct)
    call check_cone()
    call tap%finish()

contains

    !> A cut by any plane: its points are in it and on rings; and where lines of the surface, found
    !> by de Boor's scheme, pass the plane, the cut is there.
    subroutine check_oblique(duct, through, normal)
        type(duct_type), intent(in) :: duct
        real(dp), intent(in) :: through(3), normal(3)
        type(plane_type) :: plane
        type(error_type), allocatable :: error
        type(cut_type) :: cut
        real(dp) :: worst(3), at(3), t(2), h(2)
        integer :: i, j, k, met

        call plane_through(through, normal, plane, error)
        cut = cut_of(duct%panel, plane, .false.)
        worst = 0.0_dp
        do k = 1, size(cut%patched)
            do i = 1, size(cut%patched(k)%points)
                at = cut%patched(k)%points(i)%at
                worst(1) = max(worst(1), abs(height_over(plane, at)))
                worst(2) = max(worst(2), off_ring(ring_at(duct%loft, at(1)), at(2:)))
            end do
        end do
        met = 0
        do j = 0, 40
            do i = 0, 99
                t = (real([i, i + 1], dp))/100.0_dp
                h = [height_over(plane, de_boor(duct%panel%surface, t(1), 0.025_dp*real(j, dp))), &
                    height_over(plane, de_boor(duct%panel%surface, t(2), 0.025_dp*real(j, dp)))]
                if (h(1)*h(2) >= 0.0_dp) cycle
                do k = 1, 60
                    at = de_boor(duct%panel%surface, 0.5_dp*sum(t), 0.025_dp*real(j, dp))
                    t(merge(1, 2, height_over(plane, at)*h(1) > 0.0_dp)) = 0.5_dp*sum(t)
                end do
                met = met + 1
                worst(3) = max(worst(3), off_curves(cut, at))
            end do
        end do
        call tap%ok(size(cut%patched) > 0, 'a plane at an angle cuts the duct')
        call tap%near(worst(1), 0.0_dp, 1.0e-13_dp, 'its points are in the plane')
        call tap%near(worst(2), 0.0_dp, 1.0e-12_dp, '... and on the rings of their stations')
        call tap%ok(met > 10, 'the surface passes the plane in many places')
        call tap%near(worst(3), 0.0_dp, 1.0e-6_dp, '... all of them on the curve of the cut')
    end subroutine check_oblique

    !> The distance of a point from the curves of a cut.
    real(dp) function off_curves(cut, point) result(off)
        type(cut_type), intent(in) :: cut
        real(dp), intent(in) :: point(3)
        real(dp) :: low, high, t(2), step
        integer :: i, k, m
        off = huge(1.0_dp)
        do k = 1, size(cut%curves)
            associate (spline => cut%curves(k)%spline)
                low = spline%knot(1)
                high = spline%knot(size(spline%knot))
                t(1) = low
                t(2) = huge(1.0_dp)
                do i = 0, 1000
                    step = low + (high - low)*real(i, dp)/1000.0_dp
                    if (norm2(spline_point(spline, step) - point) >= t(2)) cycle
                    t = [step, norm2(spline_point(spline, step) - point)]
                end do
                step = (high - low)/1000.0_dp
                do i = 1, 60
                    do m = -1, 1, 2
                        low = min(max(t(1) + real(m, dp)*step, spline%knot(1)), high)
                        if (norm2(spline_point(spline, low) - point) < t(2)) &
                            t = [low, norm2(spline_point(spline, low) - point)]
                    end do
                    step = 0.7_dp*step
                end do
            end associate
            off = min(off, t(2))
        end do
    end function off_curves

    !> A point of a surface by de Boor's triangles, along u, then v.
    pure function de_boor(f, u, v) result(point)
        type(bspline_surface_type), intent(in) :: f
        real(dp), intent(in) :: u, v
        real(dp) :: point(3), row(3, size(f%pole, 3))
        integer :: j
        do j = 1, size(row, 2)
            row(:, j) = triangle(f%u_knot, f%pole(:, :, j), u)
        end do
        point = triangle(f%v_knot, row, v)
    end function de_boor

    !> A point of a cubic B-spline.
    pure function triangle(knot, pole, t) result(point)
        real(dp), intent(in) :: knot(:), pole(:, :), t
        real(dp) :: point(3), d(3, 0:3), share
        integer :: span, r, j
        span = max(4, min(size(pole, 2), count(knot <= t)))
        d = pole(:, span - 3:span)
        do r = 1, 3
            do j = 3, r, -1
                share = (t - knot(span - 3 + j))/(knot(span + 1 + j - r) - knot(span - 3 + j))
                d(:, j) = (1.0_dp - share)*d(:, j - 1) + share*d(:, j)
            end do
        end do
        point = d(:, 3)
    end function triangle

    !> A plane through the line of first points: that line and the one opposite, each once.
    subroutine check_seam()
        type(duct_type) :: duct
        type(cut_type) :: cut
        real(dp) :: third
        third = acos(-1.0_dp)/6.0_dp
        duct = duct_through([outline_of('A', 0.0_dp, wheel(12, [2.0_dp, 2.0_dp], [0.0_dp, 0.0_dp], &
            -third)), outline_of('B', 5.0_dp, wheel(12, [3.0_dp, 3.0_dp], [0.0_dp, 1.0_dp], &
            -third))])
        cut = cut_of(duct%panel, waterline_plane(0.0_dp), .false.)
        call tap%ok(size(cut%patched) == 2, 'a waterline through the axis gives both sides')
        duct = duct_through([outline_of('A', 0.0_dp, wheel(12, [2.0_dp, 2.0_dp], [0.0_dp, 0.0_dp], &
            -third)), outline_of('B', 5.0_dp, wheel(12, [3.0_dp, 3.0_dp], [0.0_dp, 0.0_dp], &
            -third))])
        cut = cut_of(duct%panel, waterline_plane(0.0_dp), .false.)
        call tap%ok(size(cut%patched) == 2 .and. .not. any(cut%patched%is_closed), &
            'one through the line of first points too')
        call tap%near(maxval(abs(cut%patched(1)%points%at(3))), 0.0_dp, 0.0_dp, 'in it exactly')
        cut = cut_of(duct%panel, waterline_plane(5.0_dp), .false.)
        call tap%ok(size(cut%patched) == 0, 'one beside it gives nothing')
        cut = cut_of(duct%panel, station_plane(6.0_dp), .false.)
        call tap%ok(size(cut%patched) == 0, 'nor does a station behind it')
    end subroutine check_seam

    !> The image of a duct has the image of a cut; one that stands once has none.
    subroutine check_images(duct)
        type(duct_type), intent(in) :: duct
        type(plane_type) :: plane
        type(error_type), allocatable :: error
        type(panel_type) :: once
        type(cut_type) :: cut, image
        real(dp) :: worst
        integer :: i

        cut = cut_of(duct%panel, station_plane(20.0_dp), .false.)
        image = cut_of(mirrored_panel(duct%panel), station_plane(20.0_dp), .false.)
        worst = 0.0_dp
        associate (a => cut%patched(1)%points, b => image%patched(1)%points)
            do i = 1, 24
                associate (c => b(1 + modulo(1 - i, 24)))
                    worst = max(worst, norm2(a(i)%at - [1.0_dp, -1.0_dp, 1.0_dp]*c%at), &
                        norm2(a(i)%normal - [1.0_dp, -1.0_dp, 1.0_dp]*c%normal), &
                        abs(a(i)%curvature - c%curvature), abs(a(i)%bevel - c%bevel))
                end associate
            end do
        end associate
        call tap%near(worst, 0.0_dp, 1.0e-10_dp, 'a mirrored duct has the mirrored cut')
        call plane_through([30.0_dp, 0.0_dp, 5.0_dp], [1.0_dp, 0.1_dp, 0.0_dp], plane, error)
        cut = cut_of(duct%panel, plane, .true.)
        call tap%ok(size(cut%patched) == 2, 'a plane across BL 0 cuts both of a pair')
        once = duct%panel
        once%has_image = .false.
        cut = cut_of(once, plane, .true.)
        call tap%ok(size(cut%patched) == 1, '... and one that stands once, once')
        cut = cut_of(once, buttock_plane(-22.0_dp), .true.)
        call tap%ok(size(cut%patched) == 0, 'of that there is nothing to port')
    end subroutine check_images

    !> A cone that is round within 1e-6: normals, bevels, curvatures are a cone's.
    subroutine check_cone()
        type(duct_type) :: duct
        type(cut_type) :: cut
        real(dp) :: factor, worst(3), way(2)
        integer :: i
        factor = 3.0_dp/(2.0_dp + cos(acos(-1.0_dp)/60.0_dp))
        duct = duct_through([outline_of('A', 0.0_dp, factor*wheel(120, [2.0_dp, 2.0_dp], &
            [0.0_dp, 0.0_dp], 0.0_dp)), outline_of('B', 10.0_dp, factor*wheel(120, [7.0_dp, &
            7.0_dp], [0.0_dp, 0.0_dp], 0.0_dp))])
        cut = cut_of(duct%panel, station_plane(6.0_dp), .false.)
        worst = 0.0_dp
        do i = 1, size(cut%patched(1)%points)
            associate (point => cut%patched(1)%points(i))
                way = point%at(2:)/norm2(point%at(2:))
                worst(1) = max(worst(1), abs(norm2(point%at(2:)) - 5.0_dp))
                worst(2) = max(worst(2), norm2(point%normal - [-0.5_dp, way(1), way(2)] &
                    /sqrt(1.25_dp)))
                worst(3) = max(worst(3), abs(point%curvature - 0.2_dp))
            end associate
        end do
        call tap%near(worst(1), 0.0_dp, 1.0e-6_dp, 'a cone has its radius')
        call tap%near(worst(2), 0.0_dp, 1.0e-5_dp, 'its outward normal')
        call tap%near(worst(3), 0.0_dp, 3.0e-4_dp, 'and its curvature')
        call tap%near(maxval(abs(cut%patched(1)%points%bevel - atan(0.5_dp)*180.0_dp/ &
            acos(-1.0_dp))), 0.0_dp, 1.0e-3_dp, 'a flange aft is open by the angle of the cone')
    end subroutine check_cone

end program test_duct_cuts
