!> A job: what it is before any card, and its numbers as doubles.
program test_job
    use base_decimal, only: decimal_type
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use deck_job, only: check_real, check_type, cut, cut_real, cut_type, job_type, origin, &
        piece_real, piece_type, point_rule_type, rule, section_type, side, view_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(piece_type) :: piece
    type(cut_type) :: plane
    type(check_type) :: ball
    type(view_type) :: view
    type(section_type) :: section
    type(point_rule_type) :: points

    call tap%ok(job%units == 'INCHES' .and. job%output == 'INCHES', 'inches are the unit')
    call tap%ok(job%page_columns == 80 .and. job%page_lines == 60 .and. job%digits == 3, &
        'the page of old')
    call tap%ok(job%is_symmetric .and. .not. job%is_closed, 'a body is symmetric and open')
    call tap%ok(view%origin == origin%none .and. .not. view%is_sound, 'a view is not given')
    call tap%ok(section%side == side%starboard, 'a section stands to starboard')
    call tap%ok(points%kind == rule%number .and. points%number == 25, 'an arc has 25 points')
    allocate (piece%value(2), plane%value(6), ball%value(4))
    piece%value = [decimal_type(1, -1), decimal_type(-30, 0)]
    plane%kind = cut%plane
    plane%value(6) = decimal_type(5, 2)
    ball%value(4) = decimal_type(25, -2)
    call tap%ok(all(is_equal(piece_real(piece, [1, 2]), [0.1_dp, -30.0_dp])), 'numbers of a piece')
    call tap%ok(is_equal(cut_real(plane, 6), 500.0_dp), 'numbers of a cut')
    call tap%ok(is_equal(check_real(ball, 4), 0.25_dp), 'numbers of a component')
    call tap%finish()
end program test_job
