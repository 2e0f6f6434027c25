!> Tests of networks of bodies.
program test_network_build
    use api_computed_body, only: computed_body_type
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use export_network, only: networks_type
    use export_network_build, only: build_networks
    use export_settings, only: settings_type
    use support_bodies, only: ellipsoid, nose_of_the_book
    use support_computed, only: computed_deck
    use support_cylinders, only: cylinders
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(networks_type) :: networks
    type(settings_type) :: settings
    type(error_type), allocatable :: error
    type(computed_body_type) :: computed
    real(dp), allocatable :: none(:)
    integer :: n

    allocate (none(0))
    settings%tolerance = 0.05_dp
    settings%angle = 90.0_dp
    body = ellipsoid([50.0_dp, 50.0_dp, 50.0_dp], 50.0_dp, 0.0_dp)
    call build_networks(body, [30.0_dp], settings, .true., networks, error)
    call tap%ok(.not. allocated(error) .and. size(networks%list) == 1, 'a sphere is one ring')
    associate (network => networks%list(1))
        n = size(network%points, 2)
        call tap%same(network%name, 'BODY', 'with a name')
        call tap%ok(size(network%points, 3) == 3 .and. networks%is_by_deck, &
            'a contour where it is asked for, and at the ends')
        call tap%near(maxval(abs(network%points(:, 1, :) - network%points(:, n, :))), 0.0_dp, &
            0.0_dp, 'it closes in the same point')
        call tap%near(maxval(abs(network%points(2, :, :) + network%points(2, n:1:-1, :))), 0.0_dp, &
            0.0_dp, 'its halves are mirror images')
        call tap%ok(swept(network%points(2:, :, 2)) < 0.0_dp, 'its outside is to the left')
        call tap%ok(network%points(2, 2, 2) > 0.0_dp .and. network%points(3, 1, 2) > 0.0_dp, &
            'it begins at the top and goes to starboard')
    end associate
    call build_networks(body, none, settings, .false., networks, error)
    call tap%ok(size(networks%list) == 2 .and. .not. networks%is_by_deck, 'or two sections')
    call tap%ok(networks%list(1)%is_half .and. networks%list(2)%is_half, 'of one half')
    call tap%same(networks%list(1)%name, 'LOWER', 'by their names')
    call tap%ok(networks%list(1)%error <= 0.05_dp, 'within the tolerance')

    call computed_deck(tap, 'fuselage', computed)
    call build_networks(computed%body, [70.0_dp, 182.0_dp, 240.0_dp], settings, .true., networks, &
        error)
    call tap%ok(size(networks%list) == 2, 'rings of other sections are networks of their own')
    call tap%same(networks%list(1)%name//' '//networks%list(2)%name, &
        'BODY_STA_0_TO_200 BODY_STA_200_TO_280', 'which say where they are')
    call tap%ok(size(networks%list(2)%points, 3) == 3, 'with their contours')
    call build_networks(computed%body, none, settings, .false., networks, error)
    call tap%ok(size(networks%list) == 5, 'sections are five')
    call tap%near(networks%list(3)%points(1, 1, 1), 200.0_dp, 0.0_dp, &
        'each over its own stations')

    call build_networks(nose_of_the_book(), none, settings, .true., networks, error)
    call tap%ok(size(networks%list) == 1, 'an open body that meets its image is one')
    n = size(networks%list(1)%points, 2)
    call tap%near(maxval(abs(networks%list(1)%points(2, (n + 1)/2, :))), 0.0_dp, 0.0_dp, &
        'with BL 0 in its middle')
    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 80.0_dp)
    call build_networks(body, none, settings, .true., networks, error)
    call tap%ok(size(networks%list) == 4, 'nacelles are a network on each side')
    call tap%same(networks%list(2)%name, 'BODY_STA_0_TO_50_P', 'the port one is named so')
    call tap%ok(swept(networks%list(2)%points(2:, :, 1)) < 0.0_dp, 'its outside is to the left too')

    body = cylinders([50.0_dp, 50.0_dp], [50.0_dp, 50.0_dp], 0.0_dp)
    body%is_symmetric = .false.
    body%name = 'A HALF'
    call build_networks(body, none, settings, .true., networks, error)
    n = size(networks%list(1)%points, 2)
    call tap%near(maxval(abs(networks%list(1)%points(:, 1, :) &
        - networks%list(1)%points(:, n, :))), 0.0_dp, 0.0_dp, 'one side is closed along BL 0')
    call tap%same(networks%list(1)%name, 'A_HALF_STA_0_TO_50', 'a name has no blanks')
    body = mirrored_body(cylinders([50.0_dp, 50.0_dp], [50.0_dp, 50.0_dp], 0.0_dp))
    call build_networks(body, none, settings, .false., networks, error)
    call tap%same(networks%list(5)%name, 'LOF_P', 'a port section is named so')

    settings%tolerance = 0.0_dp
    call build_networks(body, none, settings, .true., networks, error)
    call tap%ok(error%cause == cause%usage, 'a tolerance of 0 is refused')
    settings%tolerance = 0.1_dp
    deallocate (body%sections)
    allocate (body%sections(0))
    call build_networks(body, none, settings, .true., networks, error)
    call tap%ok(error%cause == cause%no_convergence, 'so is a body without sections')
    call tap%finish()

contains

    !> Twice the area that a closed contour sweeps, positive counter-clockwise.
    real(dp) function swept(at)
        real(dp), intent(in) :: at(:, :)
        integer :: i
        swept = 0.0_dp
        do i = 2, size(at, 2)
            swept = swept + at(1, i - 1)*at(2, i) - at(1, i)*at(2, i - 1)
        end do
    end function swept

end program test_network_build
