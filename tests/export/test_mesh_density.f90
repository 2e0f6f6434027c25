!> Tests of how closely the skin wants to be divided: closed forms of cylinder, cone and sphere.
program test_mesh_density
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_mesh_density, only: density_type, find_density, samples_along, samples_around
    use geom_chain, only: chain_type
    use support_bodies, only: ellipsoid, straight_view, tapered
    use support_cylinders, only: cylinders
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(density_type) :: density
    type(error_type), allocatable :: error
    real(dp) :: quarter

    quarter = 0.5_dp*pi
    body = cylinders([50.0_dp, 50.0_dp], [50.0_dp, 50.0_dp], 0.0_dp)
    call find_density(body, density, error)
    call tap%ok(.not. allocated(error) .and. size(density%stretches) == 2, &
        'a stretch between two stops')
    call tap%ok(all(density%stretches(2)%sections == [3, 4]), 'each knows its sections')
    call tap%near(density%stretches(2)%from, 50.0_dp, 0.0_dp, 'and its stations')
    call tap%near(maxval(density%stretches(1)%need%chord), 0.0_dp, 1.0e-6_dp, &
        'a cylinder wants no rows')
    call tap%near(maxval(density%stretches(1)%need%turn), 0.0_dp, 1.0e-12_dp, 'nor does it turn')
    ! A chord of a of the quarter circle is 50 (1 - cos(a pi/4)) = a**2 50 (pi/2)**2/8 off.
    call tap%near(minval(density%around(1)%chord), sqrt(50.0_dp/8.0_dp)*quarter, 1.0e-9_dp, &
        'a quarter circle wants columns by its radius')
    call tap%near(maxval(density%around(1)%chord), sqrt(50.0_dp/8.0_dp)*quarter, 1.0e-9_dp, &
        'evenly')
    call tap%near(maxval(density%around(1)%turn), quarter, 1.0e-12_dp, 'and turns by 90 degrees')
    call tap%ok(size(density%around(1)%turn) == samples_around .and. &
        size(density%stretches(1)%need%turn) == samples_along, 'looked at in many places')

    body = tapered(view(1.0_dp), view(0.6_dp), view(0.8_dp), view(-0.8_dp), view(-1.0_dp))
    call find_density(body, density, error)
    call tap%near(maxval(density%stretches(1)%need%chord), 0.0_dp, 1.0e-5_dp, &
        'a cone wants no rows')
    ! Radius 47.5/48 of 30 at the last sample; the normal is inclined by the half angle, sine .6.
    call tap%near(maxval(density%around(1)%chord), &
        sqrt(0.8_dp*(95.0_dp/96.0_dp)*30.0_dp/8.0_dp)*quarter, 1.0e-9_dp, &
        'a cone wants columns by its greatest radius')
    call tap%near(maxval(density%around(1)%turn), 0.8_dp*quarter, 1.0e-9_dp, &
        'its normal turns by less than its section')

    body = ellipsoid([50.0_dp, 50.0_dp, 50.0_dp], 50.0_dp, 0.0_dp)
    call find_density(body, density, error)
    ! u is blunt at both ends: the station goes as sin(pi u/2)**2, the meridian in equal turns.
    call tap%near(minval(density%stretches(1)%need%chord), sqrt(50.0_dp/8.0_dp)*pi, 1.0e-6_dp, &
        'a sphere wants rows in equal turns')
    call tap%near(maxval(density%stretches(1)%need%chord), sqrt(50.0_dp/8.0_dp)*pi, 1.0e-6_dp, &
        'up to its blunt ends')
    call tap%near(maxval(density%stretches(1)%need%turn), pi, 1.0e-9_dp, 'half a turn in all')

    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 0.0_dp)
    deallocate (body%sections)
    allocate (body%sections(0))
    call find_density(body, density, error)
    call tap%ok(size(density%stretches) == 0 .and. .not. allocated(error), &
        'a body without sections has no stretch')
    body = tapered(view(1.0_dp), view(0.6_dp), view(1.2_dp), view(-0.8_dp), view(-1.0_dp))
    call find_density(body, density, error)
    call tap%ok(allocated(error), 'a section that has no arc is told')
    call tap%finish()

contains

    !> A straight view from 0 to a part of 30, over 40 stations.
    function view(part)
        real(dp), intent(in) :: part
        type(chain_type) :: view
        view = straight_view([0.0_dp, 0.0_dp], [40.0_dp, part*30.0_dp])
    end function view

end program test_mesh_density
