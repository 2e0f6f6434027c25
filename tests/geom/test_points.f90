!> Points apart, in line, in order, inside others.
program test_points
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_points, only: are_in_line, check_distinct, has_inner_point, find_in_line, &
        is_in_order, &
        noise_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(error_type), allocatable :: error

    call tap%near(noise_of(points([1.0_dp, -100.0_dp])), 400.0_dp*epsilon(1.0_dp), 0.0_dp, &
        'noise is 4 ulp of the largest coordinate')
    call check_distinct(points([real(dp) :: 0, 0, 1, 2, 3, 4]), '1A3', error)
    call tap%ok(.not. allocated(error), 'three points are apart')
    call check_distinct(points([0.0_dp, 0.0_dp, 0.3_dp, 2.0_dp, 0.1_dp + 0.2_dp, 2.0_dp]), '1A3', &
        error)
    call tap%ok(allocated(error), 'decimals that binary holds differently are not')
    if (allocated(error)) then
        call tap%ok(error%cause == cause%points_coincide, 'they coincide')
        call tap%same(error%message, 'points A and 3 are both (0.3, 2.); they must be apart', &
            'which the message says of them by name')
    end if
    call check_distinct(points([0.0_dp, 0.0_dp, 0.3_dp, 2.0_dp, 0.3_dp, 2.000001_dp]), '1A3', error)
    call tap%ok(.not. allocated(error), 'a millionth apart is apart')

    call tap%ok(are_in_line(points([0.0_dp, 0.0_dp, 0.1_dp, 0.3_dp, 0.2_dp, 0.6_dp])), &
        'decimal points on y = 3 x are in line')
    call tap%ok(.not. are_in_line(points([0.0_dp, 0.0_dp, 0.1_dp, 0.300001_dp, 0.2_dp, 0.6_dp])), &
        'a millionth off they are not')
    call tap%ok(is_in_order(points([real(dp) :: 0, 0, 1, 1, 3, 3, 4, 4])), &
        'points follow each other')
    call tap%ok(.not. is_in_order(points([real(dp) :: 0, 0, 3, 3, 1, 1, 4, 4])), 'or do not')
    call tap%ok(.not. is_in_order(points([real(dp) :: 0, 0, 5, 5, 4, 4])), 'or lie beyond the last')
    call tap%ok(has_inner_point(points([real(dp) :: 0, 0, 4, 0, 0, 4, 1, 1])), &
        'a point is in a triangle')
    call tap%ok(.not. has_inner_point(points([real(dp) :: 0, 0, 4, 0, 0, 4, 3, 3])), 'or outside')
    call tap%ok(has_inner_point(points([real(dp) :: 1, 1, 0, 0, 4, 0, 9, 9, 0, 4])), &
        'of any three of five')
    call tap%same(words_of(points([real(dp) :: 0, 0, 1, 5, 2, 2, 3, 3]), '1AB3'), &
        'points 1, B and 3 are in line', 'three in line are named')
    call tap%same(words_of(points([real(dp) :: 0, 0, 1, 5, 2, 2, 3, 4]), '1AB3'), '', &
        'nothing is where none are')
    call tap%finish()

contains

    !> Points, x and y in turn.
    pure function points(coordinates)
        real(dp), intent(in) :: coordinates(:)
        real(dp) :: points(2, size(coordinates)/2)
        points = reshape(coordinates, shape(points))
    end function points

    !> The words of `find_in_line`.
    function words_of(points, names) result(words)
        real(dp), intent(in) :: points(:, :)
        character(*), intent(in) :: names
        character(:), allocatable :: words
        call find_in_line(points, names, words)
    end function words_of

end program test_points
