!> Tests of cuts as shapes: quadrics, whose cuts are conics, and a fuselage, against the points that
!> `make_cut` gives.
program test_drawing_cut
    use api_computed_body, only: computed_body_type, judge_body
    use base_error, only: cause, error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, cut_kind, height_over, plane_type, station_plane, &
        waterline_plane
    use cut_request, only: request_type
    use export_drawing, only: shape_type
    use export_drawing_cut, only: draw_cut
    use geom_bspline, only: spline_point
    use deck_job, only: job_type
    use support_book, only: text_file
    use support_computed, only: job_of_text
    use support_cutting, only: by_number, by_step, cut_of, plane_of
    use support_drawn, only: curve_count, is_end_to_end, largest_error, largest_miss
    use support_quadric, only: cone, off_surface, paraboloid, quadric_type, quadric_ellipsoid => &
        ellipsoid, sphere
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(computed_body_type) :: it
    type(shape_type) :: shape
    type(cut_type) :: cut
    type(error_type), allocatable :: error
    integer :: k

    call prove_quadric('ellipsoid', quadric_ellipsoid)
    call prove_quadric('sphere', sphere)
    call prove_quadric('cone', cone)
    call prove_quadric('paraboloid', paraboloid)

    call read_deck('fuselage')
    call prove_fuselage([1, 3, 9, 12, 13, 14, 15], 1.0e-3_dp)
    call prove_fuselage([3, 16], 1.0e-5_dp)
    call prove_fuselage([12, 14], 1.0e-8_dp)
    call prove_errors()
    call prove_counts()
    call tap%finish()

contains

    !> A deck of cards/ with its cuts, without measures.
    subroutine read_deck(name)
        character(*), intent(in) :: name
        type(fault_list_type) :: faults
        type(job_type) :: job
        call job_of_text(text_file('cards/'//name//'.crd'), job, faults)
        call judge_body(job, 1, it, faults)
        call tap%ok(faults%count == 0, name//': the deck runs without a fault')
    end subroutine read_deck

    !> Every cut of a deck of closed form is conics, exactly, on the surface and in the plane.
    subroutine prove_quadric(name, surface)
        character(*), intent(in) :: name
        type(quadric_type), intent(in) :: surface
        real(dp) :: off, out, miss, at(3)
        integer :: n, c, j
        logical :: is_exact, meets

        call read_deck(name)
        off = 0.0_dp
        out = 0.0_dp
        miss = 0.0_dp
        is_exact = .true.
        meets = .true.
        do n = 1, size(it%cuts)
            call draw_cut(it%body, it%cuts(n), 1.0e-3_dp, 0.0_dp, shape, error)
            if (allocated(error)) error stop 'a quadric can''t be drawn'
            is_exact = is_exact .and. curve_count(shape, .true.) == curve_count(shape, .false.)
            meets = meets .and. is_end_to_end(shape)
            meets = meets .and. all(it%cuts(n)%outlines%is_closed .eqv. &
                pack(shape%contours%is_closed, .not. shape%contours%is_inside))
            miss = max(miss, largest_miss(it%cuts(n)%outlines, shape, .false.))
            do c = 1, size(shape%contours)
                if (shape%contours(c)%is_inside) cycle
                do j = 1, size(shape%contours(c)%curves)
                    do k = 0, 50
                        at = spline_point(shape%contours(c)%curves(j)%spline, real(k, dp)/50.0_dp)
                        off = max(off, abs(off_surface(surface, at)))
                        out = max(out, abs(height_over(shape%plane, at)))
                    end do
                end do
            end do
        end do
        call tap%ok(is_exact, name//': every cut is conics, exactly')
        call tap%near(off, 0.0_dp, 2.0e-12_dp, name//': which lie on the surface')
        call tap%near(out, 0.0_dp, 2.0e-13_dp, name//': in their planes')
        call tap%near(miss, 0.0_dp, 2.0e-12_dp, name//': from end to end of the outlines')
        call tap%ok(meets, name//': and hang together as these do')
    end subroutine prove_quadric

    !> Cuts of the fuselage within a tolerance, outside and inside.
    subroutine prove_fuselage(numbers, tolerance)
        integer, intent(in) :: numbers(:)
        real(dp), intent(in) :: tolerance
        real(dp) :: miss, miss_inside, error_said
        character(8) :: label
        integer :: n, m
        logical :: meets

        write (label, '(es8.0e1)') tolerance
        miss = 0.0_dp
        miss_inside = 0.0_dp
        error_said = 0.0_dp
        meets = .true.
        do m = 1, size(numbers)
            n = numbers(m)
            call draw_cut(it%body, it%cuts(n), tolerance, 0.0_dp, shape, error)
            if (allocated(error)) exit
            miss = max(miss, largest_miss(it%cuts(n)%outlines, shape, .false.))
            if (size(it%cuts(n)%inside) > 0) &
                miss_inside = max(miss_inside, largest_miss(it%cuts(n)%inside, shape, .true.))
            meets = meets .and. is_end_to_end(shape)
            error_said = max(error_said, largest_error(shape))
        end do
        call tap%ok(.not. allocated(error), 'fuselage within'//label//': all cuts are drawn')
        call tap%ok(miss <= tolerance .and. miss <= error_said + 1.0e-12_dp, &
            'outlines have the points of the cuts, as near as is said')
        call tap%ok(miss_inside <= tolerance .and. miss_inside <= error_said + 1.0e-12_dp, &
            'so have the insides')
        call tap%ok(error_said <= tolerance .and. error_said > 0.1_dp*tolerance, &
            'errors are below the tolerance, and not far')
        call tap%ok(meets, 'curves meet in the same numbers')
    end subroutine prove_fuselage

    !> Names, halves, quantities, sections, exact ones.
    subroutine prove_counts()
        type(plane_type) :: canted
        type(request_type) :: request

        call draw_cut(it%body, it%cuts(9), 1.0e-3_dp, 0.0_dp, shape, error)
        call tap%same(shape%name//'|'//shape%title, 'STA_224|STATION 224', 'a station')
        call tap%ok(shape%is_half .and. shape%quantity == 1 .and. shape%kind == cut_kind%station &
            .and. size(shape%contours) == 2, 'half of one piece, with its inside')
        call tap%ok(all(shape%contours(1)%curves%is_exact) .and. &
            .not. any(shape%contours(2)%curves%is_exact), 'its arcs are exact, its inside is not')
        call tap%same(shape%contours(1)%curves(3)%section, 'FILLET', 'curves know their sections')
        call tap%near(shape%skin, 0.032_dp, 0.0_dp, 'it knows the skin')
        call draw_cut(it%body, it%cuts(13), 1.0e-3_dp, 0.0_dp, shape, error)
        call tap%ok(.not. shape%is_half .and. shape%quantity == 2 .and. all( &
            shape%contours%is_closed) .and. size(shape%contours) == 2, &
            'a frame canted both ways is whole, closed, and there are two')
        call draw_cut(it%body, it%cuts(15), 1.0e-3_dp, 0.0_dp, shape, error)
        call tap%ok(shape%quantity == 2 .and. .not. shape%is_half, 'two of a butt line')
        call tap%ok(size(shape%contours(2)%curves) == 2, 'it breaks where the roof line does')
        call draw_cut(it%body, it%cuts(3), 1.0e-3_dp, 0.0_dp, shape, error)
        call tap%ok(shape%is_flange_forward, 'it knows the side of its flange')

        cut = cut_of(it%body, by_number(buttock_plane(0.0_dp), 9))
        call draw_cut(it%body, cut, 1.0e-3_dp, 0.0_dp, shape, error)
        call tap%ok(shape%quantity == 1 .and. .not. shape%is_half, 'one of butt line 0')
        call tap%ok(curve_count(shape, .false.) > 4 .and. curve_count(shape, .false.) &
            == curve_count(shape, .true.), 'which is the centre lines'' own arcs, exactly')
        cut = cut_of(it%body, by_number(plane_of([100.0_dp, 0.0_dp, 0.0_dp], &
            [0.0_dp, -3.0_dp, 0.0_dp]), 9))
        call draw_cut(it%body, cut, 1.0e-3_dp, 0.0_dp, shape, error)
        call tap%ok(shape%quantity == 1, 'so is a plane in BL 0')
        cut = cut_of(it%body, by_step(buttock_plane(-8.0_dp), 1, 20000))
        call draw_cut(it%body, cut, 1.0e-3_dp, 0.0_dp, shape, error)
        call tap%ok(shape%quantity == 2 .and. all(shape%contours(1)%curves(1)%spline%pole(2, :) &
            < 0.0_dp), 'a butt line to port is drawn there')
        canted = plane_of([104.0_dp, 3.0_dp, 4.0_dp], [-1.0_dp, 0.0_dp, 0.0_dp])
        request = by_number(canted, 9)
        request%skin = 0.032_dp
        cut = cut_of(it%body, request)
        call draw_cut(it%body, cut, 1.0e-5_dp, 0.0_dp, shape, error)
        call tap%ok(shape%is_half .and. all(shape%contours(1)%curves%is_exact) .and. &
            largest_miss(cut%outlines, shape, .false.) < 1.0e-12_dp, &
            'a station by point and normal is a station')
        call tap%ok(largest_miss(cut%inside, shape, .true.) < 1.0e-5_dp, 'inside, too')
        cut = cut_of(it%body, by_number(waterline_plane(500.0_dp), 9))
        call draw_cut(it%body, cut, 1.0e-3_dp, 1.0_dp, shape, error)
        call tap%ok(size(shape%contours) == 0, 'a plane that misses the body gives no contours')
        call read_deck('sphere')
        cut = cut_of(it%body, by_number(station_plane(0.0_dp), 9))
        call draw_cut(it%body, cut, 1.0e-3_dp, 1.0_dp, shape, error)
        call tap%ok(size(shape%contours) == 1 .and. size(shape%contours(1)%curves) == 0, &
            'a point is a contour without curves')
        it%body%is_symmetric = .false.
        cut = cut_of(it%body, by_number(buttock_plane(3.0_dp), 9))
        call draw_cut(it%body, cut, 1.0e-3_dp, 0.0_dp, shape, error)
        call tap%ok(shape%quantity == 1 .and. .not. shape%is_half, &
            'of a body without symmetry there is one of each')
    end subroutine prove_counts

    !> What can't be fitted is said.
    subroutine prove_errors()
        call draw_cut(it%body, it%cuts(14), 1.0e-18_dp, 0.0_dp, shape, error)
        call tap%ok(allocated(error), 'a tolerance below rounding is refused')
        if (allocated(error)) call tap%ok(error%cause == cause%no_convergence, 'as what it is')
    end subroutine prove_errors

end program test_drawing_cut
