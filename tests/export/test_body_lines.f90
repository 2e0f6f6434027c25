!> Tests of the lines plan: which curve stands where.
program test_body_lines
    use app_plan_cuts, only: plan_cuts
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_outline, only: cut_type
    use export_body_drawing, only: drawing_type
    use export_body_lines, only: find_corners, lines_plan
    use support_solids, only: cone, ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(cut_type) :: none(0)
    type(drawing_type) :: drawing
    real(dp) :: low(3), high(3), left, right

    body = ellipsoid([50.0_dp, 30.0_dp, 20.0_dp])
    call find_corners([body], none, low, high)
    call tap%ok(all(abs(low - [-50.0_dp, 0.0_dp, -20.0_dp]) < 1.0e-12_dp) .and. &
        all(abs(high - [50.0_dp, 30.0_dp, 20.0_dp]) < 1.0e-12_dp), 'lines give the room of a body')
    drawing = lines_plan([body], plan_cuts([body], none), 'EGG', 'inches')
    call tap%near(drawing%dot(1), drawing%dot(2), 0.0_dp, 'all views have one scale')
    call reach('section', left, right)
    call tap%near(right - left, 60.0_dp, 1.0e-9_dp, 'fore and aft sections fill both sides')
    call tap%ok(left > 50.0_dp, 'of a body plan beside the profile')
    call reach('buttock', left, right)
    call tap%ok(left > -50.0_dp .and. right < 50.0_dp, 'buttocks are in the profile')
    call reach('centre', left, right)
    call tap%near(left, -50.0_dp, 1.0e-9_dp, 'the centre line of the plan begins at the nose')
    body = cone(20.0_dp, 100.0_dp, 0.0_dp)
    drawing = lines_plan([body], plan_cuts([body], none), 'CONE', 'inches')
    call reach('section', left, right)
    call tap%near(right - left, 18.0_dp, 1.0e-9_dp, &
        'with none aft of the greatest, sections keep to starboard: to station 90')
    call tap%finish()

contains

    !> The least and greatest x of a style.
    subroutine reach(style, least, greatest)
        character(*), intent(in) :: style
        real(dp), intent(out) :: least, greatest
        integer :: i, k
        least = huge(1.0_dp)
        greatest = -huge(1.0_dp)
        do i = 1, drawing%layers
            if (drawing%layer(i)%style /= style) cycle
            do k = 1, drawing%layer(i)%count
                associate (at => drawing%layer(i)%stroke(k)%at)
                    if (maxval(at(2, :)) - minval(at(2, :)) <= 0.0_dp .and. style /= 'centre') cycle
                    least = min(least, minval(at(1, :)))
                    greatest = max(greatest, maxval(at(1, :)))
                end associate
            end do
        end do
    end subroutine reach

end program test_body_lines
