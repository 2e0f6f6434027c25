!> Lengths of arcs in closed form, and places at equal lengths.
program test_length
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use geom_arc_point, only: point
    use geom_length, only: arc_length, places_by_length
    use geom_place, only: is_finish, is_start, place_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc
    type(place_type), allocatable :: places(:)
    type(error_type), allocatable :: error
    real(dp), parameter :: up(2) = [0.0_dp, 1.0_dp], flat(2) = [1.0_dp, 0.0_dp]
    real(dp), parameter :: good = 1.0e-12_dp
    real(dp) :: p(2), angle, worst
    integer :: i

    call check(card([1.0_dp, 0.0_dp], up, [0.6_dp, 0.8_dp], [0.0_dp, 1.0_dp], flat), 0.5_dp*pi, &
        'a quarter circle')
    call check(card([1.0_dp, 0.0_dp], up, [0.0_dp, 1.0_dp], [-1.0_dp, 0.0_dp], up), pi, &
        'a semicircle')
    arc = card([-0.28_dp, 0.96_dp], [0.96_dp, 0.28_dp], [0.0_dp, -1.0_dp], [0.28_dp, 0.96_dp], &
        [0.96_dp, -0.28_dp])
    call check(arc, 2.0_dp*(pi - asin(0.28_dp)), 'a circle but for a notch')
    call check(card([0.0_dp, 0.0_dp], flat, [1.0_dp, 1.0_dp], [2.0_dp, 4.0_dp], [1.0_dp, 4.0_dp]), &
        sqrt(17.0_dp) + 0.25_dp*asinh(4.0_dp), 'y = x**2 from 0 to 2')
    ! E(3/4) = 1.2110560275684595 (Abramowitz and Stegun, table 17.1: 1.21105602756846 at m = .75).
    call check(card([0.0_dp, 1.0_dp], flat, [1.2_dp, 0.8_dp], [2.0_dp, 0.0_dp], up), &
        2.0_dp*1.2110560275684595_dp, 'a quarter ellipse of axes 2 and 1: 2 E(3/4)')
    call check(card([0.0_dp, 0.0_dp], up, [1.0e-6_dp, 1.0_dp - 1.0e-6_dp], [1.0_dp, 1.0_dp], &
        flat), &
        2.0_dp, 'a sharp corner: nearly its two tangents', 1.0e-4_dp)
    call check(line_between([1.0_dp, 2.0_dp], [4.0_dp, 6.0_dp]), 5.0_dp, 'a line')

    call places_by_length(arc, 25, places, error)
    call tap%ok(.not. allocated(error) .and. size(places) == 25, 'a notched circle has 25 places')
    call tap%ok(is_start(places(1)) .and. is_finish(places(25)), 'the ends are among them')
    worst = 0.0_dp
    do i = 1, 25
        p = point(arc, places(i))
        angle = asin(0.28_dp) + 2.0_dp*(pi - asin(0.28_dp))*real(i - 1, dp)/24.0_dp
        worst = max(worst, norm2(p - [-sin(angle), cos(angle)]))
    end do
    call tap%near(worst, 0.0_dp, 1.0e-10_dp, 'they are at equal angles, in order')
    arc = card([0.0_dp, 0.0_dp], up, [1.0e-6_dp, 1.0_dp - 1.0e-6_dp], [1.0_dp, 1.0_dp], flat)
    call places_by_length(arc, 5, places, error)
    call tap%near(norm2(point(arc, places(2)) - [0.0_dp, 0.5_dp]), 0.0_dp, 1.0e-3_dp, &
        'round a sharp corner the second of five is half way up')
    call tap%near(norm2(point(arc, places(4)) - [0.5_dp, 1.0_dp]), 0.0_dp, 1.0e-3_dp, &
        'and the fourth half way along')
    call places_by_length(line_between([0.0_dp, 0.0_dp], [4.0_dp, 8.0_dp]), 2, places, error)
    call tap%ok(is_start(places(1)) .and. is_finish(places(2)), 'two places are the ends')
    call tap%finish()

contains

    !> The arc of a card that has one.
    type(arc_type) function card(p1, t1, p2, p3, t3) result(arc)
        real(dp), intent(in) :: p1(2), t1(2), p2(2), p3(2), t3(2)
        type(error_type), allocatable :: error
        call arc_through(end_type(p1, t1), p2, end_type(p3, t3), arc, error)
        if (allocated(error)) call tap%ok(.false., error%message)
    end function card

    !> Checks a length.
    subroutine check(arc, expected, name, tolerance)
        type(arc_type), intent(in) :: arc
        real(dp), intent(in) :: expected
        character(*), intent(in) :: name
        real(dp), intent(in), optional :: tolerance
        type(error_type), allocatable :: error
        real(dp) :: length, allowed
        allowed = good*expected
        if (present(tolerance)) allowed = tolerance
        call arc_length(arc, length, error)
        if (allocated(error)) call tap%note(error%message)
        call tap%ok(.not. allocated(error), 'has a length: '//name)
        call tap%near(length, expected, allowed, name)
    end subroutine check

end program test_length
