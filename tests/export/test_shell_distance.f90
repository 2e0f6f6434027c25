!> Tests of measured distances on a sphere, whose surfaces are exact: grown, slid along, turned.
program test_shell_distance
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_shell, only: skin_model_type
    use export_shell_distance, only: measure_span, miss_type, sheet_type
    use export_shell_pace, only: conic_pace
    use export_shell_stretch, only: stretch_type, stretches_of, used_lines
    use support_skins, only: deck_body, skin_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(stretch_type), allocatable :: stretches(:)
    type(skin_model_type) :: model
    type(sheet_type) :: sheet, other
    type(miss_type) :: miss
    integer :: i, k

    body = deck_body('sphere')
    model = skin_of(body, 1.0e-6_dp, .false.)
    call stretches_of(body, 1.0e-6_dp, .false., stretches)
    sheet%body = stretches(1)%body
    sheet%section = stretches(1)%slots(1)%section
    sheet%pace = conic_pace(used_lines(stretches(1)), 0.0_dp, 50.0_dp)
    sheet%slide = 1.0e-7_dp
    sheet%surface = model%faces(1)%surface
    miss = measured(sheet, 0.0_dp, 1.0_dp)
    call tap%ok(miss%distance < 1.0e-13_dp, 'the sphere itself misses by rounding')

    other = sheet
    do i = 1, 3
        do k = 1, 3
            other%surface%pole(:, i, k) = [50.0_dp, 0.0_dp, 0.0_dp] + 1.0001_dp* &
                (sheet%surface%pole(:, i, k) - [50.0_dp, 0.0_dp, 0.0_dp])
        end do
    end do
    miss = measured(other, 0.0_dp, 1.0_dp)
    call tap%near(miss%distance, 5.0e-3_dp, 1.0e-6_dp, 'a grown one by what it has grown')
    call tap%near(norm2(miss%at - [50.0_dp, 0.0_dp, 0.0_dp]), 50.005_dp, 1.0e-10_dp, &
        'at a point that is on it')

    other = sheet
    other%pace%leaving = 1.02_dp*sheet%pace%leaving
    miss = measured(other, 0.2_dp, 0.8_dp)
    call tap%ok(miss%distance < 1.0e-5_dp, &
        'what slides along the skin by tenths misses it by no more than Newton''s rest')

    other = sheet
    other%surface%pole(2, :, :) = cos(1.0e-4_dp)*sheet%surface%pole(2, :, :) &
        - sin(1.0e-4_dp)*sheet%surface%pole(3, :, :)
    other%surface%pole(3, :, :) = sin(1.0e-4_dp)*sheet%surface%pole(2, :, :) &
        + cos(1.0e-4_dp)*sheet%surface%pole(3, :, :)
    miss = measured(other, 0.9_dp, 1.0_dp)
    call tap%ok(miss%distance > 4.9e-3_dp .and. miss%distance < 5.0e-3_dp, &
        'a turned one by the way of its edges from the lines')

    miss = miss_type(1.0_dp, [1.0_dp, 2.0_dp, 3.0_dp])
    call judge_kept()
    call tap%finish()

contains

    !> The largest distance of a span.
    function measured(of, from, to) result(miss)
        type(sheet_type), intent(in) :: of
        real(dp), intent(in) :: from, to
        type(miss_type) :: miss
        type(error_type), allocatable :: error
        call measure_span(of, from, to, miss, error)
        call tap%ok(.not. allocated(error), 'a sphere can be measured')
    end function measured

    !> A greater distance of another span stays.
    subroutine judge_kept()
        type(error_type), allocatable :: error
        call measure_span(sheet, 0.0_dp, 1.0_dp, miss, error)
        call tap%ok(miss%distance == 1.0_dp .and. all(miss%at == [1.0_dp, 2.0_dp, 3.0_dp]), &
            'what was worse before stays the worst')
    end subroutine judge_kept

end program test_shell_distance
