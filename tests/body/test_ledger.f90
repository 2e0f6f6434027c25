!> Joints in numbers and in words.
program test_ledger
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_ledger, only: bends_on, is_broken, joint_between, joint_type, joint_words
    use geom_arc, only: arc_type, line_between
    use geom_arc_by_circle, only: circle_by_radius
    use geom_stroke, only: conic_stroke
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(joint_type) :: joint
    type(arc_type) :: five, next
    type(error_type), allocatable :: error

    call circle_by_radius([0.0_dp, 0.0_dp], [5.0_dp, 5.0_dp], -5.0_dp, five, error)
    call circle_by_radius([5.0_dp, 5.0_dp], [10.0_dp, 0.0_dp], -5.0_dp, next, error)
    joint = joint_between(conic_stroke(five), conic_stroke(next))
    call tap%ok(joint%sta == 5.0_dp, 'a joint is where the second arc begins')
    call tap%ok(all(abs(joint%curvature + 0.2_dp) < 1.0e-16_dp), 'it has both curvatures')
    call tap%same(trim(joint_words(joint)), &
        'slope and curvature go on', 'a circle goes on in a circle')
    call circle_by_radius([5.0_dp, 5.0_dp], [10.0_dp, 0.0_dp], -5.004_dp, next, error)
    joint = joint_between(conic_stroke(five), conic_stroke(next))
    call tap%ok(bends_on(joint), 'curvatures within a thousandth go on')
    call tap%ok(is_broken(joint), 'but directions .05 degrees apart break')
    call circle_by_radius([5.0_dp, 5.0_dp], [7.0_dp, 3.0_dp], -2.0_dp, next, error)
    joint = joint_between(conic_stroke(five), conic_stroke(next))
    call tap%ok(.not. (bends_on(joint) .or. is_broken(joint)), &
        'a tighter circle bends more, unbroken')
    call tap%same(trim(joint_words(joint)), 'slope goes on, curvature jumps from -0.2 to -0.5', &
        'which is said')
    joint = joint_between(conic_stroke(five), &
        conic_stroke(line_between([5.0_dp, 5.0_dp], [6.0_dp, 6.0_dp])))
    call tap%same(trim(joint_words(joint)), 'slope breaks by 45. degrees', 'so is a break')
    joint%is_knuckle = .true.
    call tap%same(trim(joint_words(joint)), &
        'slope breaks by 45. degrees, a knuckle', 'and a knuckle')
    joint = joint_between(conic_stroke(five), &
        conic_stroke(line_between([5.0_dp, 5.001_dp], [6.0_dp, 5.001_dp])))
    call tap%same(trim(joint_words(joint)), &
        'the ends are 0.001 apart, slope goes on, curvature jumps from '// &
        '-0.2 to 0.', 'and a gap')
    joint = joint_between(conic_stroke(five), &
        conic_stroke(line_between([5.0_dp, 5.0_dp], [6.0_dp, 5.0000099_dp])))
    call tap%ok(.not. is_broken(joint), 'slopes .0000099 apart are rounded')
    joint = joint_between(conic_stroke(five), &
        conic_stroke(line_between([5.0_dp, 5.0_dp], [6.0_dp, 5.0000101_dp])))
    call tap%ok(is_broken(joint), 'slopes .0000101 apart break')
    joint = joint_between(conic_stroke(line_between([4.0_dp, 5.0_dp], [5.0_dp, 5.0_dp])), &
        conic_stroke(line_between([5.0_dp, 5.0_dp], [6.0_dp, 5.0_dp])))
    call tap%same(trim(joint_words(joint)), 'slope and curvature go on', 'a line goes on in a line')
    call tap%finish()
end program test_ledger
