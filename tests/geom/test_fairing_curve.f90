!> Uniform cubic B-splines as Bezier curves and as B-splines of CAD files.
program test_fairing_curve
    use base_kinds, only: dp
    use geom_bezier, only: bezier_jet
    use geom_bspline, only: bspline_type, spline_jet, spline_point
    use geom_fairing_curve, only: uniform_bspline, uniform_segments
    use support_inlet, only: inlet
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check(tap, inlet(:, :14), .true., 'closed')
    call check(tap, inlet(:, :14), .false., 'open')
    call check(tap, inlet(:, :4), .false., 'one segment')
    call check(tap, inlet(:, :5), .false., 'two segments')
    call tap%finish()

contains

    !> Both forms against the basis of seed 002, equation (1); joints.
    subroutine check(tap, vertex, is_closed, name)
        type(tap_type), intent(inout) :: tap    !! the tally
        real(dp), intent(in) :: vertex(:, :)    !! the vertices
        logical, intent(in) :: is_closed        !! a ring
        character(*), intent(in) :: name        !! of the case
        real(dp), allocatable :: pole(:, :, :)
        type(bspline_type) :: spline
        real(dp) :: at(2), one(2, 2), two(2, 2), worst(3), u
        integer :: i, j

        allocate (pole, source=uniform_segments(vertex, is_closed))
        spline = uniform_bspline(vertex, is_closed)
        worst = 0.0_dp
        do i = 1, size(pole, 3)
            do j = 0, 4
                u = 0.25_dp*real(j, dp)
                call bezier_jet(pole(:, :, i), u, at, one(:, 1), two(:, 1))
                worst(1) = max(worst(1), norm2(at - by_basis(vertex, i, u)))
                worst(2) = max(worst(2), norm2(spline_point(spline, real(i - 1, dp) + u) &
                    - by_basis(vertex, i, u)))
            end do
            if (i == size(pole, 3) .and. .not. is_closed) cycle
            call bezier_jet(pole(:, :, 1 + modulo(i, size(pole, 3))), 0.0_dp, at, one(:, 2), &
                two(:, 2))
            worst(3) = max(worst(3), norm2(one(:, 2) - one(:, 1)), norm2(two(:, 2) - two(:, 1)))
        end do
        call tap%near(worst(1), 0.0_dp, 1.0e-15_dp, name//': the Bezier curves are the segments')
        call tap%near(worst(2), 0.0_dp, 1.0e-15_dp, name//': the B-spline is the curve')
        call tap%near(worst(3), 0.0_dp, 2.0e-14_dp, name//': both derivatives go on')
        call spline_jet(spline, 0.0_dp, at, one(:, 1), two(:, 1))
        call tap%near(norm2(at - pole(:, 1, 1)), 0.0_dp, 0.0_dp, name//': it begins at its pole')
    end subroutine check

    !> The point of a segment from the matrix of equation (1).
    function by_basis(vertex, segment, u) result(point)
        real(dp), intent(in) :: vertex(:, :)    !! the vertices
        integer, intent(in) :: segment          !! from 1
        real(dp), intent(in) :: u               !! 0 to 1
        real(dp) :: point(2)
        integer :: k, n
        n = size(vertex, 2)
        point = matmul(vertex(:, [(1 + modulo(segment + k - 1, n), k = 0, 3)]), [(1.0_dp - u)**3, &
            3.0_dp*u**3 - 6.0_dp*u**2 + 4.0_dp, -3.0_dp*u**3 + 3.0_dp*u**2 + 3.0_dp*u + 1.0_dp, &
            u**3]/6.0_dp)
    end function by_basis

end program test_fairing_curve
