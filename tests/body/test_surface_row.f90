!> F of a section and its gradient at points in a row, against one after another.
program test_surface_row
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: section_arc
    use body_surface, only: form_along, gradient_at, patch_at, patch_type
    use body_surface_row, only: patch_row_type, repeated_patch, row_forms, row_gradients
    use body_taylor, only: taylor_type
    use body_taylor_row, only: taylor_row_type
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_place, only: place_at
    use geom_twofold_short, only: width
    use support_bodies, only: nose_of_the_book
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(patch_type) :: patch
    type(patch_row_type) :: row
    type(arc_type) :: arc
    type(taylor_type) :: form
    type(taylor_row_type) :: forms
    type(error_type), allocatable :: error
    real(dp) :: at(width, 2), way(width, 3), gradient(width, 3), worst(3)
    integer :: i

    body = nose_of_the_book()
    call section_arc(body%lines, body%sections(1), 20.0_dp, arc, error)
    patch = patch_at(body%lines, body%sections(1), 20.0_dp, arc)
    call repeated_patch(patch, row)
    do i = 1, width
        at(i, :) = point(arc, place_at(real(i, dp)/real(width + 1, dp)))
        way(i, :) = [0.6_dp, 0.48_dp, -0.64_dp]
    end do
    call row_forms(row, at, way, forms)
    call row_gradients(row, at, gradient)
    worst = 0.0_dp
    do i = 1, width
        form = form_along(patch, at(i, :), way(i, :))
        worst(1) = max(worst(1), abs(forms%first(i) - form%first), abs(forms%value(i) - form%value))
        worst(2) = max(worst(2), abs(forms%second(i) - form%second))
        worst(3) = max(worst(3), maxval(abs(gradient(i, :) - gradient_at(patch, at(i, :)))))
    end do
    call tap%near(worst(1), 0.0_dp, 1.0e-17_dp, 'F and its slope along a way')
    call tap%near(worst(2), 0.0_dp, 1.0e-17_dp, 'its second derivative')
    call tap%near(worst(3), 0.0_dp, 1.0e-15_dp, 'its gradient')
    row%is_straight = .true.
    patch%is_straight = .true.
    call row_gradients(row, at, gradient)
    call tap%near(maxval(abs(gradient(5, :) - gradient_at(patch, at(5, :)))), 0.0_dp, 1.0e-15_dp, &
        'that of a straight section')
    call tap%finish()
end program test_surface_row
