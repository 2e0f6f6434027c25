!> The decks of closed forms, `cards/ellipsoid.crd`, `sphere`, `paraboloid` and `cone`: girths,
!> areas, moments, volumes, skins, centroids and clearances.
program test_quadric_measures
    use api_computed_body, only: computed_body_type
    use base_kinds, only: dp
    use cut_measure, only: section_measure_type
    use support_computed, only: computed_deck
    use support_quadric, only: perimeter
    use support_quadric_cuts, only: asked, take
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: pi = acos(-1.0_dp)
    type(tap_type) :: tap

    call prove_ellipsoid()
    call prove_sphere()
    call prove_paraboloid()
    call prove_cone()
    call tap%finish()

contains

    !> Half axes 100, 60 and 50. Its skin: 2 pi c**2 + 2 pi a b (E sin(f)**2 + F cos(f)**2)/sin(f)
    !> with elliptic integrals of f = acos(c/a) and k**2 = a**2(b**2 - c**2)/(b**2(a**2 - c**2)),
    !> worked to 30 figures by mpmath.
    subroutine prove_ellipsoid()
        type(computed_body_type) :: it

        call computed_deck(tap, 'ellipsoid', it)
        call prove_curve('ellipsoid', it, half_axes=[60.0_dp, 50.0_dp], level=30.0_dp)
        call prove_body('ellipsoid', it, 4.0_dp/3.0_dp*pi*300000.0_dp, 59943.06703457406_dp, &
            [120.0_dp, 0.0_dp, 30.0_dp])
        call prove_clearances('ellipsoid', it, [50.0_dp, 50.0_dp*sqrt(0.88_dp), &
            50.0_dp*sqrt(0.88_dp) - 10.0_dp, sqrt(71.72_dp), sqrt(71.72_dp), &
            sqrt(71.72_dp) - 0.5_dp])
        call prove_nearest('ellipsoid', it, 4, [168.0_dp, 36.0_dp, 62.0_dp])
    end subroutine prove_ellipsoid

    !> Radius 50.
    subroutine prove_sphere()
        type(computed_body_type) :: it

        call computed_deck(tap, 'sphere', it)
        call prove_curve('sphere', it, half_axes=[50.0_dp, 50.0_dp], level=0.0_dp)
        call prove_body('sphere', it, 4.0_dp/3.0_dp*pi*50.0_dp**3, 4.0_dp*pi*50.0_dp**2, &
            [50.0_dp, 0.0_dp, 0.0_dp])
        call prove_clearances('sphere', it, [50.0_dp, 20.0_dp, 20.0_dp, 10.0_dp, 9.75_dp])
        call prove_nearest('sphere', it, 2, [80.0_dp, 0.0_dp, 40.0_dp])
    end subroutine prove_sphere

    !> Half-breadth 40 and half-height 30 at the open end, 100 long. Its skin by mpmath, integrated
    !> along the length in closed form, around it numerically to 30 figures.
    subroutine prove_paraboloid()
        type(computed_body_type) :: it

        call computed_deck(tap, 'paraboloid', it)
        call prove_curve('paraboloid', it, half_axes=[40.0_dp, 30.0_dp], level=0.0_dp)
        call prove_body('paraboloid', it, pi*60000.0_dp, 15314.81659164109_dp, &
            [-25.0_dp + 200.0_dp/3.0_dp, 0.0_dp, 0.0_dp])
        call prove_clearances('paraboloid', it, [22.5_dp, 20.0_dp, sqrt(23.3125_dp)])
        call prove_nearest('paraboloid', it, 3, [0.0_dp, 12.0_dp, 12.0_dp])
    end subroutine prove_paraboloid

    !> Half-breadth 30 and half-height 20 at the open end, 100 long. Its skin by a complete elliptic
    !> integral, worked to 30 figures by mpmath.
    subroutine prove_cone()
        type(computed_body_type) :: it

        call computed_deck(tap, 'cone', it)
        call prove_curve('cone', it, half_axes=[30.0_dp, 20.0_dp], level=10.0_dp)
        call prove_body('cone', it, pi*20000.0_dp, 8157.774306432212_dp, &
            [75.0_dp, 0.0_dp, 10.0_dp])
        call prove_clearances('cone', it, [10.0_dp/sqrt(1.04_dp), 10.0_dp/sqrt(1.04_dp) - 4.0_dp, &
            sqrt(21.0_dp)])
        call prove_nearest('cone', it, 3, [50.0_dp, 9.0_dp, 18.0_dp])
    end subroutine prove_cone

    !> Girth, area, centroid and moments of the elliptic sections, all along the body.
    subroutine prove_curve(name, it, half_axes, level)
        character(*), intent(in) :: name                !! of the deck
        type(computed_body_type), intent(in) :: it      !! the deck computed
        real(dp), intent(in) :: half_axes(2)            !! of the largest section
        real(dp), intent(in) :: level                   !! WL of all centres
        real(dp) :: girth, area, centroid, inertia, axes(2)
        integer :: i

        girth = 0.0_dp
        area = 0.0_dp
        centroid = 0.0_dp
        inertia = 0.0_dp
        do i = 1, size(it%measure%curve)
            associate (section => it%measure%curve(i))
                axes = half_axes*share(name, section%sta)
                if (axes(1) <= asked) cycle
                call take(girth, section%girth/perimeter(axes) - 1.0_dp)
                call take(area, section%area/(pi*product(axes)) - 1.0_dp)
                call take(centroid, norm2(section%centroid - [0.0_dp, level]))
                call take(inertia, inertia_error(section, axes))
            end associate
        end do
        call tap%ok(size(it%measure%curve) >= 20, name//': the area curve has 20 stations and more')
        call tap%near(girth, 0.0_dp, asked, name//': girths of sections')
        call tap%near(area, 0.0_dp, asked, name//': areas of sections')
        call tap%near(centroid, 0.0_dp, asked, name//': centroids of sections')
        call tap%near(inertia, 0.0_dp, asked, name//': moments of sections')
    end subroutine prove_curve

    !> The error of the second moments of an ellipse.
    real(dp) function inertia_error(section, axes) result(error)
        type(section_measure_type), intent(in) :: section   !! measured
        real(dp), intent(in) :: axes(2)                     !! its half axes
        real(dp) :: unit
        unit = 0.25_dp*pi*product(axes)
        error = maxval(abs(section%inertia - unit*[axes(2)**2, axes(1)**2, 0.0_dp])) &
            /(unit*maxval(axes)**2)
    end function inertia_error

    !> The size of a section as a share of the largest.
    real(dp) function share(name, sta)
        character(*), intent(in) :: name    !! of the deck
        real(dp), intent(in) :: sta         !! deck units
        select case (name)
        case ('ellipsoid')
            share = sqrt(max(0.0_dp, (sta - 20.0_dp)*(220.0_dp - sta)))/100.0_dp
        case ('sphere')
            share = sqrt(max(0.0_dp, sta*(100.0_dp - sta)))/50.0_dp
        case ('paraboloid')
            share = sqrt((sta + 25.0_dp)/100.0_dp)
        case default
            share = sta/100.0_dp
        end select
    end function share

    !> Volume, skin and centroid of the body, and the estimates of their errors.
    subroutine prove_body(name, it, volume, wetted, centroid)
        character(*), intent(in) :: name                !! of the deck
        type(computed_body_type), intent(in) :: it      !! the deck computed
        real(dp), intent(in) :: volume                  !! deck units**3
        real(dp), intent(in) :: wetted                  !! deck units**2
        real(dp), intent(in) :: centroid(3)             !! STA, BL, WL, deck units

        associate (found => it%measure)
            call tap%ok(found%has_volume .and. found%has_wetted, &
                name//': it has a volume and a skin')
            call tap%near(found%volume/volume, 1.0_dp, asked, name//': volume')
            call tap%near(found%wetted_area/wetted, 1.0_dp, asked, name//': skin')
            call tap%near(norm2(found%centroid - centroid), 0.0_dp, asked, name//': centroid')
            call tap%ok(found%volume_error >= 0.0_dp .and. found%volume_error < asked*volume .and. &
                found%wetted_error >= 0.0_dp .and. found%wetted_error < asked*wetted, &
                name//': the errors of both as LOFT estimates them are as small')
        end associate
    end subroutine prove_body

    !> Clearances of the components, in the order of the deck.
    subroutine prove_clearances(name, it, gap)
        character(*), intent(in) :: name                !! of the deck
        type(computed_body_type), intent(in) :: it      !! the deck computed
        real(dp), intent(in) :: gap(:)                  !! what they must be, deck units
        integer :: i

        call tap%ok(size(it%clearances) == size(gap), name//': every component is there')
        do i = 1, min(size(it%clearances), size(gap))
            call tap%near(it%clearances(i)%gap, gap(i), asked, &
                name//': clearance of '//trim(it%clearances(i)%name))
            call tap%ok(.not. it%clearances(i)%is_short, &
                name//': which is enough for '//trim(it%clearances(i)%name))
        end do
    end subroutine prove_clearances

    !> The nearest point of the skin to a component.
    subroutine prove_nearest(name, it, number, nearest)
        character(*), intent(in) :: name                !! of the deck
        type(computed_body_type), intent(in) :: it      !! the deck computed
        integer, intent(in) :: number                   !! of the component
        real(dp), intent(in) :: nearest(3)              !! STA, BL, WL, deck units
        real(dp), parameter :: along = 1.0e-6_dp ! a distance is flat about its least
        call tap%near(norm2(it%clearances(number)%nearest*[1.0_dp, sign(1.0_dp, &
            it%clearances(number)%nearest(2)), 1.0_dp] - nearest), 0.0_dp, along, &
            name//': nearest point to '//trim(it%clearances(number)%name))
    end subroutine prove_nearest

end program test_quadric_measures
