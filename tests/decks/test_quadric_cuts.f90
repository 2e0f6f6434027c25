!> The decks of closed forms, `cards/ellipsoid.crd`, `sphere`, `paraboloid` and `cone`: every point
!> of every cut against the equation of the surface, and how the points are spread.
program test_quadric_cuts
    use api_computed_body, only: computed_body_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use cut_outline, only: cut_type
    use support_computed, only: computed_deck
    use support_quadric, only: cone, ellipsoid, off_surface, paraboloid, quadric_type, sphere
    use support_quadric_cuts, only: asked, prove_cuts, prove_outlines, prove_steps, take
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call prove_ellipsoid()
    call prove_sphere()
    call prove_paraboloid()
    call prove_cone()
    call tap%finish()

contains

    !> Nine stations, then the cuts in the order of the deck.
    subroutine prove_ellipsoid()
        type(computed_body_type) :: it
        call computed_deck(tap, 'ellipsoid', it)
        call prove_cuts(tap, 'ellipsoid', it, ellipsoid)
        call prove_outlines(tap, 'ellipsoid', it, &
            [1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1], closed=[14, 15, 17])
        call prove_steps(tap, 'ellipsoid', it%cuts(10), [40, 200, 20])
        call prove_steps(tap, 'ellipsoid', it%cuts(11), [40, 200, 20])
        call prove_steps(tap, 'ellipsoid', it%cuts(12), [60, 180, 20])
        call prove_steps(tap, 'ellipsoid', it%cuts(13), [75, 150, 15])
        call prove_chords(it%cuts(17), 0.01_dp)
    end subroutine prove_ellipsoid

    !> With a skin of 2 the inside is a sphere of radius 48.
    subroutine prove_sphere()
        type(computed_body_type) :: it
        type(quadric_type) :: inside
        integer :: i

        call computed_deck(tap, 'sphere', it)
        call prove_cuts(tap, 'sphere', it, sphere)
        call prove_outlines(tap, 'sphere', it, &
            [1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1, 1], closed=[14, 15, 17])
        call prove_steps(tap, 'sphere', it%cuts(10), [5, 95, 10])
        call prove_steps(tap, 'sphere', it%cuts(11), [10, 90, 10])
        call prove_steps(tap, 'sphere', it%cuts(12), [36, 64, 7])
        call prove_steps(tap, 'sphere', it%cuts(13), [10, 90, 10])
        call prove_even_arcs(it)
        inside = sphere
        inside%square = 1.0_dp/48.0_dp**2
        do i = 1, size(it%cuts)
            if (it%cuts(i)%skin > 0.0_dp) call prove_inside(it%cuts(i), i, inside)
        end do
    end subroutine prove_sphere

    !> Eight stations, then the cuts in the order of the deck.
    subroutine prove_paraboloid()
        type(computed_body_type) :: it
        call computed_deck(tap, 'paraboloid', it)
        call prove_cuts(tap, 'paraboloid', it, paraboloid)
        call prove_outlines(tap, 'paraboloid', it, [1, 1, 1, 1, 1, 1, 1, 1, 2, 1, 1, 1, 1, 1], &
            closed=[13, 14])
        call prove_steps(tap, 'paraboloid', it%cuts(9), [15, 75, 12])
        call prove_steps(tap, 'paraboloid', it%cuts(10), [11, 75, 8])
        call prove_steps(tap, 'paraboloid', it%cuts(11), [10, 40, 10])
    end subroutine prove_paraboloid

    !> Seven stations, then the cuts in the order of the deck.
    subroutine prove_cone()
        type(computed_body_type) :: it
        call computed_deck(tap, 'cone', it)
        call prove_cuts(tap, 'cone', it, cone)
        call prove_outlines(tap, 'cone', it, &
            [1, 1, 1, 1, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1], closed=[13, 14])
        call prove_steps(tap, 'cone', it%cuts(8), [40, 100, 10])
        call prove_steps(tap, 'cone', it%cuts(9), [60, 100, 8])
        call prove_steps(tap, 'cone', it%cuts(11), [50, 100, 10])
    end subroutine prove_cone

    !> On a sphere points at equal arc length are at equal chords.
    subroutine prove_even_arcs(it)
        type(computed_body_type), intent(in) :: it !! the sphere
        real(dp) :: uneven, chord
        integer :: i, k

        uneven = 0.0_dp
        do i = 1, 9
            associate (points => it%cuts(i)%outlines(1)%points)
                call tap%ok(size(points) == 50, &
                    'sphere: 25 points on each arc of cut '//to_text(i))
                chord = norm2(points(2)%at - points(1)%at)
                do k = 2, 50
                    if (k == 26) cycle
                    call take(uneven, norm2(points(k)%at - points(k - 1)%at)/chord - 1.0_dp)
                end do
            end associate
        end do
        call tap%near(uneven, 0.0_dp, 10.0_dp*asked, &
            'sphere: points of a station are equally spaced')
    end subroutine prove_even_arcs

    !> The sagitta of a chord between neighbours is, to second order, curvature * chord**2/8.
    subroutine prove_chords(cut, tolerance)
        type(cut_type), intent(in) :: cut       !! of an ellipsoid, points by chords
        real(dp), intent(in) :: tolerance       !! deck units
        real(dp) :: largest, chord
        integer :: k

        largest = 0.0_dp
        associate (points => cut%outlines(1)%points)
            do k = 2, size(points)
                chord = norm2(points(k)%at - points(k - 1)%at)
                call take(largest, chord**2/8.0_dp*min(abs(points(k)%curvature), &
                    abs(points(k - 1)%curvature)))
            end do
        end associate
        call tap%ok(largest <= tolerance .and. largest > 0.2_dp*tolerance, &
            'ellipsoid: chords stay within the tolerance and are not much finer')
    end subroutine prove_chords

    !> The inside of a skin of constant thickness is a sphere about the same centre.
    subroutine prove_inside(cut, number, inside)
        type(cut_type), intent(in) :: cut               !! with a skin
        integer, intent(in) :: number                   !! of the cut
        type(quadric_type), intent(in) :: inside        !! the inside
        real(dp) :: off, off_plane
        integer :: i, k, points

        off = 0.0_dp
        off_plane = 0.0_dp
        points = 0
        do i = 1, size(cut%inside)
            points = points + size(cut%inside(i)%points)
            do k = 1, size(cut%inside(i)%points)
                associate (at => cut%inside(i)%points(k)%at)
                    call take(off, off_surface(inside, at))
                    call take(off_plane, dot_product(cut%plane%normal, at - cut%plane%through) &
                        /norm2(cut%plane%normal))
                end associate
            end do
        end do
        call tap%ok(points > 10, 'sphere: cut '//to_text(number)//' has an inside')
        call tap%near(off, 0.0_dp, asked, &
            'sphere: inside of cut '//to_text(number)//' on its sphere')
        call tap%near(off_plane, 0.0_dp, asked, 'sphere: and in its plane')
    end subroutine prove_inside

end program test_quadric_cuts
