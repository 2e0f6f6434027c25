!> Cards that have no arc: the cause, what the message says, and beside each a card that is fine.
program test_arc_fault
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, direction_of_slope, end_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), parameter :: vertical = 999.999_dp

    call refused([3.0_dp, 4.0_dp, 0.0_dp], [5.0_dp, 6.0_dp], [3.0_dp, 4.0_dp, 1.0_dp], &
        cause%points_coincide, &
        'points 1 and 3 are both (3., 4.)', 'ends that coincide')
    call refused([0.0_dp, 0.0_dp, 1.0_dp], [0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp, -1.0_dp], &
        cause%points_coincide, &
        'the shoulder point is point 1', 'a shoulder on point 1')
    call refused([0.0_dp, 0.0_dp, 1.0_dp], [1.0_dp, 0.0_dp], [1.0_dp, 0.0_dp, -1.0_dp], &
        cause%points_coincide, &
        'the shoulder point is point 3', 'a shoulder on point 3')
    call refused([0.3_dp, 0.0_dp, 1.0_dp], [0.5_dp, 1.0_dp], [0.1_dp + 0.2_dp, 0.0_dp, -1.0_dp], &
        cause%points_coincide, 'points 1 and 3', 'ends that differ by rounding alone')
    call refused([0.0_dp, 0.0_dp, 1.0_dp], [3.0e-313_dp, 4.0e-313_dp], &
        [7.0e-313_dp, 0.0_dp, -1.0_dp], cause%points_coincide, 'points 1 and 3', &
        'ends nearer than any number held to full length')
    call accepted([0.0_dp, 0.0_dp, 1.0_dp], [3.0e-300_dp, 2.0e-300_dp], &
        [7.0e-300_dp, 0.0_dp, -1.0_dp], 'a card of 1.e-300')
    call accepted([0.0_dp, 0.0_dp, 1.0_dp], [1.0e-9_dp, 0.9999e-9_dp], [1.0_dp, 0.0_dp, -1.0_dp], &
        'a shoulder a billionth from point 1')

    call refused([0.0_dp, 0.0_dp, 1.0_dp], [0.1_dp, 0.0_dp], [1.0_dp, 0.0_dp, -1.0_dp], &
        cause%shoulder_on_chord, 'make both slopes 0.', 'a shoulder on the chord with other slopes')
    call refused([0.0_dp, 0.0_dp, 0.5_dp], [4.0_dp, 2.0_dp], [2.0_dp, 1.0_dp, 0.5_dp], &
        cause%shoulder_on_chord, 'not between them', 'a line with its shoulder beyond the end')
    call refused([0.0_dp, 0.0_dp, 3.0_dp], [0.1_dp, 0.3_dp], [0.2_dp, 0.6_dp, 3.001_dp], &
        cause%shoulder_on_chord, 'make both slopes 3.', 'a line with a wrong slope')
    call accepted([0.0_dp, 0.0_dp, 1.0_dp], [0.1_dp, 1.0e-9_dp], [1.0_dp, 0.0_dp, -1.0_dp], &
        'a shoulder a billionth off the chord')
    call accepted([0.0_dp, 0.0_dp, 3.0_dp], [0.1_dp, 0.3_dp], [0.2_dp, 0.6_dp, 3.0_dp], &
        'a straight line')
    call accepted([0.0_dp, 0.0_dp, vertical], [0.0_dp, 0.3_dp], [0.0_dp, 0.6_dp, vertical], &
        'a vertical line')

    call refused([0.0_dp, 0.0_dp, 0.0_dp], [1.0_dp, 1.0_dp], [2.0_dp, 0.0_dp, -1.0_dp], &
        cause%tangent_on_chord, 'the tangent at point 1, slope 0.', &
        'a tangent along the chord at point 1')
    call refused([0.0_dp, 0.0_dp, 0.5_dp], [1.0_dp, 1.0_dp], [2.0_dp, 1.0_dp, 0.5_dp], &
        cause%tangent_on_chord, 'point 1', 'both tangents along the chord of a curve')
    call refused([0.0_dp, 0.0_dp, 1.0_dp], [1.0_dp, 0.5_dp], [2.0_dp, 0.0_dp, 0.0_dp], &
        cause%tangent_on_chord, 'the tangent at point 3', 'a tangent along the chord at point 3')
    call accepted([0.0_dp, 0.0_dp, 0.00001_dp], [1.0_dp, 0.000001_dp], [2.0_dp, 0.0_dp, -1.0_dp], &
        'a tangent nearly along the chord')

    call refused([0.0_dp, 0.0_dp, 1.0_dp], [0.1_dp, 0.2_dp], [2.0_dp, 0.0_dp, 1.0_dp], &
        cause%inflection, &
        'both turn to the same side', 'an S-shaped curve')
    call refused([0.0_dp, 0.0_dp, -2.0_dp], [1.0_dp, 0.2_dp], [2.0_dp, 0.0_dp, -0.1_dp], &
        cause%inflection, &
        'end slopes -2. and -0.1', 'an S-shaped curve with unequal slopes')
    call accepted([0.0_dp, 0.0_dp, 2.0_dp], [2.0_dp, 0.5_dp], [2.0_dp, 0.0_dp, 20.0_dp], &
        'both tangents on one side, where the curve turns past the vertical')

    call refused([0.0_dp, 0.0_dp, vertical], [-0.1_dp, 0.5_dp], [1.0_dp, 1.0_dp, 0.0_dp], &
        cause%shoulder_outside, &
        'on the other side of the tangent at point 1 from point 3, slope vertical', &
        'a shoulder beyond the tangent at point 1')
    call refused([0.0_dp, 0.0_dp, vertical], [0.5_dp, 1.1_dp], [1.0_dp, 1.0_dp, 0.0_dp], &
        cause%shoulder_outside, 'tangent at point 3 from point 1', &
        'a shoulder beyond the tangent at point 3')
    call refused([0.0_dp, 0.0_dp, vertical], [0.0_dp, 0.5_dp], [1.0_dp, 1.0_dp, 0.0_dp], &
        cause%shoulder_outside, 'lies on the tangent at point 1', &
        'a shoulder on the tangent at point 1')
    call refused([0.0_dp, 0.0_dp, vertical], [0.5_dp, 1.0_dp], [1.0_dp, 1.0_dp, 0.0_dp], &
        cause%shoulder_outside, 'intersection of the end tangents at (0., 1.)', &
        'a shoulder on the tangent at point 3')
    call refused([0.0_dp, 0.0_dp, vertical], [-1.0_dp, 1.0_dp], [2.0_dp, 0.0_dp, vertical], &
        cause%shoulder_outside, 'between the parallel end tangents', 'a shoulder outside a strip')
    call accepted([0.0_dp, 0.0_dp, vertical], [1.0e-5_dp, 0.5_dp], [1.0_dp, 1.0_dp, 0.0_dp], &
        'a shoulder just inside the tangent at point 1')
    call accepted([0.0_dp, 0.0_dp, vertical], [1.0_dp, 50.0_dp], [2.0_dp, 0.0_dp, vertical], &
        'a shoulder far up between parallel tangents')

    call refused([0.0_dp, 0.0_dp, 1.0_dp], [-1.9_dp, -2.1_dp], [2.0_dp, 0.0_dp, -1.0_dp], &
        cause%other_branch, &
        'different branches', 'a shoulder on the other branch of a hyperbola')
    call accepted([0.0_dp, 0.0_dp, 1.0_dp], [1.0_dp, -2.4142136_dp], [2.0_dp, 0.0_dp, -1.0_dp], &
        'three quarters of a circle')
    call tap%finish()

contains

    !> An end by x, y and slope.
    pure type(end_type) function at(values)
        real(dp), intent(in) :: values(3)
        at = end_type(values(:2), direction_of_slope(values(3)))
    end function at

    !> Checks that a card is refused for a reason and that the message has certain words.
    subroutine refused(p1, p2, p3, why, words, name)
        real(dp), intent(in) :: p1(3), p2(2), p3(3)
        integer, intent(in) :: why
        character(*), intent(in) :: words, name
        type(arc_type) :: arc
        type(error_type), allocatable :: error

        call arc_through(at(p1), p2, at(p3), arc, error)
        call tap%ok(allocated(error), name//' is refused')
        if (.not. allocated(error)) return
        call tap%ok(error%cause == why, '... for the right cause')
        call tap%ok(index(error%message, words) > 0, '... and says: '//words)
        if (error%cause /= why .or. index(error%message, words) == 0) call tap%note(error%message)
    end subroutine refused

    !> Checks that a card has an arc.
    subroutine accepted(p1, p2, p3, name)
        real(dp), intent(in) :: p1(3), p2(2), p3(3)
        character(*), intent(in) :: name
        type(arc_type) :: arc
        type(error_type), allocatable :: error

        call arc_through(at(p1), p2, at(p3), arc, error)
        call tap%ok(.not. allocated(error), name//' is fine')
        if (allocated(error)) call tap%note(error%message)
    end subroutine accepted

end program test_arc_fault
