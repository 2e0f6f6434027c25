!> What is integrated over a span: a cone in closed form, and one so thin that the rounding of its
!> points can be seen.
program test_measure_slice
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_measure_body, only: body_measure_type, measure_whole
    use cut_measure_slice, only: new_slice, slice_type
    use support_solids, only: cone
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(body_measure_type) :: measure
    type(slice_type) :: slice
    type(error_type), allocatable :: error
    real(dp) :: value(5), radius
    integer :: i

    body = cone(3.0_dp, 4.0_dp, 10.0_dp)
    slice = new_slice(body, [0.0_dp, 4.0_dp], [-1.0_dp, 0.0_dp, 8.0_dp], 5)
    call tap%ok(size(slice%chosen) == 2, 'the halves of a cone')
    call slice%at(0.5_dp, value, error)
    call tap%near(value(1), 4.0_dp*2.0_dp*pi*1.5_dp*1.25_dp, 1.0e-12_dp, 'its skin half-way')
    call tap%near(value(2), 4.0_dp*pi*2.25_dp, 1.0e-12_dp, 'its area')
    call tap%near(maxval(abs(value(3:) - value(2)*[3.0_dp, 0.0_dp, 2.0_dp])), 0.0_dp, 1.0e-11_dp, &
        'and its moments')
    call tap%ok(all(slice%noise([47.0_dp, 38.0_dp, 100.0_dp, 0.0_dp, 100.0_dp]) < 1.0e-10_dp), &
        'rounding can hardly be seen')
    do i = 8, 10, 2
        radius = 10.0_dp**(-i)
        call measure_whole(cone(radius, 100.0_dp, 10.0_dp), measure)
        call tap%ok(measure%has_volume .and. measure%has_wetted, 'a needle has volume and skin')
        associate (volume => pi*radius**2*100.0_dp/3.0_dp, skin => pi*radius*100.0_dp)
            call tap%near(measure%volume, volume, measure%volume_error, 'a volume')
            call tap%near(measure%wetted_area, skin, measure%wetted_error, 'and a skin')
            call tap%ok(measure%volume_error < 0.1_dp*volume .and. &
                measure%wetted_error < 0.1_dp*skin, 'within bounds of use')
        end associate
    end do
    call measure_whole(cone(1.0e-12_dp, 100.0_dp, 10.0_dp), measure)
    call tap%has(measure%why, 'at station 0.96', 'where rounding takes the shape it is said where')
    call tap%has(measure%why, 'UPPER: it has nearly shrunk to a point, ', 'of what, and why')
    call tap%has(measure%why, ': end the section before, or let it be larger', 'with the way out')
    slice = new_slice(cone(1.0e-10_dp, 100.0_dp, 10.0_dp), [0.0_dp, 100.0_dp], &
        [0.0_dp, 0.0_dp, 10.0_dp], 1)
    call tap%near(sum(slice%noise([3.0e-8_dp])), 800.0_dp*4.0_dp*epsilon(1.0_dp)*10.0_dp, &
        1.0e-14_dp, 'as rounding moves both ends of both halves on both sides')
    call tap%finish()
end program test_measure_slice
