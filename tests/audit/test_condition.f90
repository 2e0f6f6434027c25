!> What readings ask of a conic: of the circle of radius 5.
program test_condition
    use audit_condition, only: bound_rows, condition_type, exact_row, new_condition, residual, &
        takes_part
    use audit_curve, only: frame_type
    use audit_figure, only: form, scale_type
    use audit_printing, only: printing
    use audit_reading, only: meaning, new_reading, reading_type, sort
    use base_kinds, only: dp
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(frame_type), parameter :: plain = frame_type()
    type(scale_type), parameter :: three = scale_type(form%decimal, 3)
    real(dp), parameter :: circle(6) = [1.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, -25.0_dp]/ &
        sqrt(627.0_dp)
    type(condition_type) :: condition
    type(reading_type) :: reading
    real(dp) :: off, excess
    logical :: exists

    call tap%ok(takes_part(new_reading(sort%ordinate, 3.0_dp, '4.000'), three), &
        'a sound figure is evidence')
    call tap%ok(.not. takes_part(new_reading(sort%ordinate, 3.0_dp, '4.0001'), three) .and. &
        .not. takes_part(new_reading(sort%ordinate, 3.0_dp, '4.0?1'), three), &
        'one to other places, or not all readable, is none')
    call tap%ok(takes_part(new_reading(sort%ordinate, 3.0_dp, '4.', meaning%exact), three), &
        'an exact number may have any places')

    condition = new_condition(new_reading(sort%ordinate, 3.0_dp, '4.001'), printing%rounded, 0.0_dp)
    call residual(condition, circle, plain, off, excess, exists)
    call tap%ok(exists .and. abs(off + 1.0_dp) < 1.0e-9_dp .and. abs(excess - 0.5_dp) < 1.0e-9_dp, &
        'a figure one unit too large is half a unit out of its bounds')
    call check(new_reading(sort%ordinate, 3.0_dp, '4.000'), .true., 'an ordinate that is met')
    call check(new_reading(sort%ordinate, 3.0_dp, '-4.000'), .true., '... on the lower side')
    call check(new_reading(sort%ordinate, 3.0_dp, '4.001'), .false., '... that is not met')
    call check(new_reading(sort%abscissa, 3.0_dp, '-4.000'), .true., 'an abscissa that is met')
    call check(new_reading(sort%abscissa, 3.0_dp, '-3.999'), .false., '... that is not met')
    call check(new_reading(sort%ordinate, 4.99_dp, '0.316'), .true., 'an ordinate in a steep place')
    call check(new_reading(sort%ordinate, 4.99_dp, '0.317'), .false., '... that is not met')
    reading = new_reading(sort%coefficient, 0.0_dp, '-0.0400')
    reading%letter = 3
    call check(reading, .true., 'a coefficient that is met')
    reading%letter = 2
    call check(reading, .false., '... that is not met')
    reading = new_reading(sort%ordinate, 3.0_dp, '', meaning%between)
    reading%low = 3.9_dp
    reading%high = 4.2_dp
    call check(reading, .true., 'an ordinate between two numbers')
    reading%low = 4.1_dp
    call check(reading, .false., '... and not between them')

    condition = new_condition(new_reading(sort%slope, 3.0_dp, '-.75', meaning%exact), 1, 0.0_dp)
    condition%point = [3.0_dp, 4.0_dp]
    condition%has_point = .true.
    call tap%near(dot_product(exact_row(condition, plain), circle), 0.0_dp, 1.0e-15_dp, &
        'an exact slope is an equation')
    condition = new_condition(new_reading(sort%slope, 5.0_dp, '999.999', meaning%exact), 1, 0.0_dp)
    condition%point = [5.0_dp, 0.0_dp]
    call tap%near(dot_product(exact_row(condition, plain), circle), 0.0_dp, 1.0e-15_dp, &
        'so is a vertical one')
    call tap%finish()

contains

    !> Checks that both inequalities hold just where a reading is met.
    subroutine check(it, is_met, name)
        type(reading_type), intent(in) :: it !! the reading
        logical, intent(in) :: is_met        !! the circle meets it
        character(*), intent(in) :: name     !! the check as a phrase
        real(dp) :: rows(6, 2)
        condition = new_condition(it, printing%rounded, 0.0_dp)
        call bound_rows(condition, circle, plain, rows)
        call tap%ok((minval(matmul(circle, rows)) >= 0.0_dp) .eqv. is_met, name)
    end subroutine check

end program test_condition
