!> Lines and circles to go along.
program test_track
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_type, line_between
    use geom_arc_by_circle, only: circle_by_points, circle_by_radius
    use geom_arc_by_rho, only: arc_by_corner_rho
    use geom_track, only: arc_to, backwards, left_of, track_of, track_type
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(random_type) :: random
    type(arc_type) :: arc, new
    type(track_type) :: track, back
    type(error_type), allocatable :: error
    real(dp) :: centre(2), radius, from, worst(3)
    integer :: i

    call tap%ok(all(abs(left_of([3.0_dp, 4.0_dp]) - [-4.0_dp, 3.0_dp]) <= 0.0_dp), 'left of (3, 4)')
    call track_of(line_between([1.0_dp, 1.0_dp], [4.0_dp, 5.0_dp]), 'before', track, error)
    call tap%ok(track%is_line .and. norm2(track%along - [0.6_dp, 0.8_dp]) < 1.0e-15_dp, 'a line')
    worst = 0.0_dp
    do i = 1, 300
        centre = [random%between(-9.0_dp, 9.0_dp), random%between(-9.0_dp, 9.0_dp)]
        radius = 10.0_dp**random%between(-1.0_dp, 3.0_dp)*merge(1.0_dp, -1.0_dp, i > 150)
        from = random%between(0.0_dp, 6.0_dp)
        call circle_by_points(on(0.0_dp), on(0.7_dp), on(1.5_dp), arc, error)
        call track_of(arc, 'before', track, error)
        back = backwards(track)
        worst(1) = max(worst(1), norm2(track%centre - centre)/abs(radius))
        worst(2) = max(worst(2), abs(track%radius/radius - 1.0_dp))
        worst(3) = max(worst(3), abs(back%radius + track%radius))
    end do
    call tap%near(worst(1), 0.0_dp, 1.0e-13_dp, 'the centre of a circle')
    call tap%near(worst(2), 0.0_dp, 1.0e-13_dp, 'its radius, below zero where it turns right')
    call tap%near(worst(3), 0.0_dp, 0.0_dp, 'which backwards is the other')
    call circle_by_radius([1.0_dp, 0.0_dp], [-1.0_dp, 0.0_dp], 1.0_dp, arc, error)
    call track_of(arc, 'before', track, error)
    call tap%near(norm2(track%centre) + abs(track%radius - 1.0_dp), 0.0_dp, 1.0e-15_dp, &
        'a half circle')
    call arc_to(arc, [0.0_dp, 1.0_dp], new, error)
    call tap%ok(.not. allocated(error), 'half of it')
    call tap%near(norm2(new%start_tangent/norm2(new%start_tangent) - [0.0_dp, 1.0_dp]), 0.0_dp, &
        1.0e-15_dp, 'begins as it does')
    call arc_to(new, [-1.0_dp, 0.0_dp], arc, error)
    call tap%ok(.not. allocated(error), 'and is made longer again')
    call arc_to(new, [0.6_dp, -0.8_dp], arc, error)
    call tap%ok(allocated(error), 'but not backwards')
    call arc_to(line_between([0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp]), [-0.1_dp, 0.0_dp], arc, error)
    call tap%has(error%message, '(-0.1, 0.), beyond its other end at (0., 0.)', 'nor a line')
    call arc_by_corner_rho([0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp], 0.5_dp, [2.0_dp, 2.0_dp], arc, error)
    call track_of(arc, 'behind', track, error)
    call tap%has(error%message, 'the card behind it is neither', 'a parabola is no track')
    call tap%finish()

contains

    !> A point of the circle, so many radians on.
    pure function on(angle)
        real(dp), intent(in) :: angle !! radians
        real(dp) :: on(2)
        on = centre + abs(radius)*[cos(from + sign(angle, radius)), sin(from + sign(angle, radius))]
    end function on

end program test_track
