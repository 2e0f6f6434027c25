!> Tests of the view in space: its points are on the surface, rows of neighbours fit.
program test_body_view
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_body_drawing, only: drawing_type
    use export_body_view, only: view_drawing
    use support_solids, only: cone, ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(drawing_type) :: drawing
    type(body_type) :: egg
    real(dp) :: worst
    integer :: i, k
    logical :: is_even, is_whole

    egg = ellipsoid([5.0_dp, 3.0_dp, 2.0_dp])
    drawing = view_drawing([egg], 'EGG', 'inches')
    call tap%ok(drawing%layers == 4, 'two sections on both sides are four grids')
    worst = 0.0_dp
    is_even = .true.
    is_whole = .true.
    do i = 1, drawing%layers
        do k = 1, drawing%layer(i)%count
            associate (at => drawing%layer(i)%stroke(k)%at)
                worst = max(worst, maxval(abs((at(1, :)/5.0_dp)**2 + (at(2, :)/3.0_dp)**2 &
                    + (at(3, :)/2.0_dp)**2 - 1.0_dp)))
                is_even = is_even .and. size(at, 2) == size(drawing%layer(i)%stroke(1)%at, 2)
                is_whole = is_whole .and. &
                    abs(at(1, 1) - drawing%layer(1)%stroke(k)%at(1, 1)) <= 0.0_dp
            end associate
        end do
    end do
    call tap%ok(worst < 1.0e-13_dp, 'all points are on the ellipsoid')
    call tap%ok(is_even, 'all rows of a grid are of one length')
    call tap%ok(is_whole, 'rows of all grids stand at the same stations')
    associate (first => drawing%layer(1)%stroke(1)%at)
        call tap%ok(all(abs(first - spread([-5.0_dp, 0.0_dp, 0.0_dp], 2, size(first, 2))) &
            < 1.0e-13_dp), 'the foremost row is the nose')
    end associate
    drawing = view_drawing([egg, cone(2.0_dp, 7.0_dp, 9.0_dp)], 'TWO', 'inches')
    call tap%ok(drawing%layers == 8, 'several bodies are seen together')
    drawing = view_drawing([body_type ::], 'NONE', 'inches')
    call tap%ok(drawing%layers == 0, 'of none there is nothing to see')
    call tap%finish()
end program test_body_view
