!> Measures of sections in closed form.
program test_measure
    use base_constants, only: pi
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use cut_measure, only: measure_section, section_measure_type
    use support_solids, only: cone, ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: good = 1.0e-11_dp
    type(tap_type) :: tap
    type(body_type) :: body
    type(section_measure_type) :: measure

    ! At station 6 the ellipsoid 10, 5, 3 has an ellipse of half axes 4 and 2.4.
    body = ellipsoid([10.0_dp, 5.0_dp, 3.0_dp])
    call check_ellipse('by two quarters')
    body = mirrored_body(body)
    call check_ellipse('by four quarters')
    body%is_closed = .false.
    call check_ellipse('that needs no CLOSE to close')

    ! Half of it, as a body that is not symmetric: a half ellipse to starboard.
    body = ellipsoid([10.0_dp, 5.0_dp, 3.0_dp])
    body%is_symmetric = .false.
    call measure_section(body, 6.0_dp, measure)
    call tap%near(measure%area, 4.8_dp*pi, good, 'area of a half ellipse closed along BL 0')
    call tap%near(measure%centroid(1), 16.0_dp/(3.0_dp*pi), good, 'its centroid, 4 b/(3 pi)')
    call tap%near(measure%inertia(2), 64.0_dp*2.4_dp*(pi/8.0_dp - 8.0_dp/(9.0_dp*pi)), good, &
        'its inertia, b**3 c (pi/8 - 8/(9 pi))')
    call tap%near(measure%inertia(3), 0.0_dp, good, 'its product of inertia')

    body = cone(3.0_dp, 4.0_dp, -250.0_dp)
    call measure_section(body, 0.0_dp, measure)
    call tap%ok(measure%has_area .and. measure%has_girth, 'the apex of a cone is measured')
    call tap%ok(abs(measure%area) + abs(measure%girth) <= 0.0_dp, 'it has no area and no girth')
    call tap%ok(all(abs(measure%centroid - [0.0_dp, -250.0_dp]) <= 0.0_dp), 'and is where it is')
    call measure_section(body, 2.0_dp, measure)
    call tap%near(measure%girth, 3.0_dp*pi, good, 'girth of a cone')
    call tap%near(measure%inertia(1), 0.25_dp*pi*1.5_dp**4, 1.0e-9_dp, &
        'inertia about a centroid far from the datum')
    call measure_section(body, 4.5_dp, measure)
    call tap%ok(.not. (measure%has_area .or. measure%has_girth), 'nothing behind the base')
    call tap%same(measure%why, 'the body has no section at station 4.5', 'and it is said so')

    body%is_closed = .false.
    call measure_section(body, 2.0_dp, measure)
    call tap%ok(measure%has_girth .and. .not. measure%has_area, &
        'without CLOSE there is girth alone')
    call tap%same(measure%why, 'the section ends at BL 0 but the deck does not say CLOSE', &
        'and it is said why')
    body%sections = body%sections(2:)
    call measure_section(body, 2.0_dp, measure)
    call tap%near(measure%girth, 1.5_dp*pi, good, 'an open quarter and its image have girth')
    call tap%same(measure%why, 'the section is open at BL 1.5, WL -250.', &
        'and say where they are open')

    ! The shoulder line is the start line: no arc.
    body%sections(1)%line = [3, 3, 5]
    call measure_section(body, 2.0_dp, measure)
    call tap%ok(.not. (measure%has_area .or. measure%has_girth), 'no arc, no measures')
    call tap%ok(allocated(measure%why), 'and the reason is passed on')
    call tap%finish()

contains

    !> Checks the section of the ellipsoid at station 6.
    subroutine check_ellipse(name)
        character(*), intent(in) :: name
        call measure_section(body, 6.0_dp, measure)
        if (allocated(measure%why)) call tap%note(measure%why)
        call tap%ok(measure%has_area .and. .not. allocated(measure%why), 'an ellipse '//name)
        call tap%near(measure%area, 19.2_dp/2.0_dp*pi, good, 'its area')
        call tap%near(norm2(measure%centroid), 0.0_dp, good, 'its centroid')
        call tap%near(measure%inertia(1), 0.25_dp*pi*4.0_dp*2.4_dp**3, good, 'its inertia, WL**2')
        call tap%near(measure%inertia(2), 0.25_dp*pi*64.0_dp*2.4_dp, good, 'its inertia, BL**2')
        call tap%near(measure%inertia(3), 0.0_dp, good, 'its product of inertia')
        ! 16 E(.64), E by the arithmetic-geometric mean.
        call tap%near(measure%girth, 16.0_dp*complete_e(0.64_dp), good, 'its girth')
    end subroutine check_ellipse

    !> The complete elliptic integral E(m) (Abramowitz and Stegun, 17.6.4).
    real(dp) function complete_e(m)
        real(dp), intent(in) :: m
        real(dp) :: a, b, c, t, rest
        integer :: i
        a = 1.0_dp
        b = sqrt(1.0_dp - m)
        rest = 1.0_dp - 0.5_dp*m
        t = 1.0_dp
        do i = 1, 8
            c = 0.5_dp*(a - b)
            t = 2.0_dp*t
            rest = rest - 0.5_dp*t*c**2
            m_step: block
                real(dp) :: mean
                mean = 0.5_dp*(a + b)
                b = sqrt(a*b)
                a = mean
            end block m_step
        end do
        complete_e = 0.5_dp*pi/a*rest
    end function complete_e

end program test_measure
