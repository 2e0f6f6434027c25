!> The arcs of the cuts of a deck. Oracles: the counts the method gives for the two examples of the
!> paper; a frame that is a straight line; radii of curvature of a sphere.
program test_computed_arcs
    use api_computed_arcs, only: arcs_of_cut
    use api_computed_body, only: computed_body_type
    use base_error, only: error_type
    use base_kinds, only: dp
    use cut_outline, only: cut_type
    use report_arc_listing, only: arc_table_type
    use support_computed, only: computed_deck
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(computed_body_type) :: it
    type(cut_type) :: cut
    type(arc_table_type), allocatable :: tables(:)
    type(error_type), allocatable :: error
    integer :: i
    real(dp) :: off

    call computed_deck(tap, 'arcs', it)
    call tap%ok(size(it%arcs) == 2, 'each cut of the body has its arcs')
    associate (cubic => it%arcs(1)%tables)
        call tap%ok(size(cubic) == 1, 'one outline')
        call tap%ok(size(cubic(1)%arcs) == 28 .and. count(cubic(1)%arcs%is_primary) == 14, &
            'the cubic has the 29 points of the paper, 14 of them secondary')
        off = 0.0_dp
        do i = 1, 28
            associate (at => cubic(1)%arcs(i)%arc%start)
                off = max(off, abs(at(2) - 0.1_dp*at(1)*(at(1)**2 - 27.0_dp)) &
                    /hypot(1.0_dp, 0.3_dp*at(1)**2 - 2.7_dp))
            end associate
        end do
        call tap%near(off, 0.0_dp, 5.0e-6_dp, 'all of them on the cubic, as its curve was fitted')
        call tap%ok(maxval(cubic(1)%arcs%deviation) <= 0.75_dp*0.005_dp, &
            'a quarter of the tolerance is left for rounding')
    end associate
    associate (frame => it%arcs(2)%tables(1))
        call tap%ok(size(frame%arcs) == 1 .and. frame%arcs(1)%arc%is_line, 'the frame is a line')
    end associate
    cut = it%cuts(1)
    cut%arcs = 0.0_dp
    call arcs_of_cut(it%body, cut, tables, error)
    call tap%ok(size(tables) == 0 .and. .not. allocated(error), 'none where none are asked')
    cut%arcs = 1.0e-18_dp
    call arcs_of_cut(it%body, cut, tables, error)
    call tap%ok(allocated(error), 'a tolerance below rounding is refused')
    call check_sphere()
    call check_duct()
    call tap%finish()

contains

    !> A great circle.
    subroutine check_sphere()
        type(computed_body_type) :: ball
        real(dp) :: radius
        integer :: k

        call computed_deck(tap, 'sphere', ball)
        cut = ball%cuts(5)
        cut%arcs = 0.001_dp
        radius = norm2(cut%outlines(1)%points(1)%uv)
        call arcs_of_cut(ball%body, cut, tables, error)
        call tap%ok(.not. allocated(error), 'a station of a sphere has arcs')
        call tap%near(maxval([(abs(abs(tables(1)%arcs(k)%arc%radius)/radius - 1.0_dp), &
            k=1, size(tables(1)%arcs))]), 0.0_dp, 1.0e-12_dp, 'of its radius')
    end subroutine check_sphere

    !> A faired outline and a section of a duct, with the tolerance asked on either.
    subroutine check_duct()
        type(computed_body_type) :: duct

        call computed_deck(tap, 'duct', duct)
        call tap%ok(size(duct%outline_arcs(1)%tables) == 1 .and. &
            all([(size(duct%outline_arcs(i)%tables) == 0, i = 2, 4)]), &
            'the outline behind an ARCS card has arcs')
        associate (lip => duct%outline_arcs(1)%tables(1))
            call tap%ok(lip%is_closed .and. maxval(lip%arcs%deviation) <= 0.002_dp, &
                'all around it, within the tolerance')
        end associate
        associate (section => duct%arcs(size(duct%arcs))%tables)
            call tap%ok(size(section) == 1, 'so has a section of a duct')
            call tap%ok(section(1)%is_closed .and. maxval(section(1)%arcs%deviation) <= 0.002_dp, &
                'all around it')
        end associate
    end subroutine check_duct

end program test_computed_arcs
