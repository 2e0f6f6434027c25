!> The forms of faired curves: the unit circle's figures, quadrature, and a dense solution.
program test_fairing_system
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_fairing, only: fair, faired_energy, fairing_type
    use geom_fairing_system, only: fairing_data_type, fairing_end, form_area, new_system, &
        solve_system, spline_area, spline_energy, system_type, vertices_of
    use geom_square_system, only: solve
    use support_inlet, only: inlet
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_circle(tap)
    call check_triangle(tap)
    call check_infinite(tap)
    call check_gradient(tap)
    call tap%finish()

contains

    !> Fourteen vertices on the unit circle; E and S from their closed forms.
    subroutine check_circle(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp) :: vertex(2, 14), angle, energy(2)
        integer :: i

        angle = 2.0_dp*acos(-1.0_dp)/14.0_dp
        do i = 1, 14
            vertex(:, i) = [cos(real(i, dp)*angle), sin(real(i, dp)*angle)]
        end do
        energy = spline_energy(vertex, .true.)
        call tap%near(spline_area(vertex, .true.), 2.937258469720_dp, 1.0e-12_dp, 'area')
        call tap%near(spline_area(vertex, .true.), 14.0_dp/720.0_dp*(245.0_dp*sin(angle) &
            + 56.0_dp*sin(2.0_dp*angle) + sin(3.0_dp*angle)), 1.0e-14_dp, &
            '... as its closed form has it')
        call tap%near(energy(1), 0.531071906561_dp, 1.0e-12_dp, 'energy of the second derivative')
        call tap%near(energy(2), 0.108776042474_dp, 1.0e-12_dp, 'energy of the third')
        call tap%near(energy(2), 14.0_dp*(2.0_dp - 2.0_dp*cos(angle))**3, 1.0e-14_dp, &
            '... as its closed form has it')
    end subroutine check_circle

    !> Three points closed, in a band that goes around the whole ring, against a dense solution of
    !> the equations written out.
    subroutine check_triangle(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp), parameter :: lambda = 0.4_dp
        type(fairing_data_type) :: given
        type(system_type) :: system
        type(error_type), allocatable :: error
        complex(dp) :: z(3)
        real(dp) :: vertex(2, 3), whole(6, 6), right(6), x(6), rcond, unit(2, 3)
        integer :: i, j

        given%point = reshape([0.0_dp, 0.0_dp, 4.0_dp, 1.0_dp, 1.0_dp, 3.0_dp], [2, 3])
        given%weight = [1.0_dp, 2.0_dp, 3.0_dp]
        given%beta = 0.25_dp
        given%ends = fairing_end%closed
        system = new_system(given)
        z = system%right
        call solve_system(system, lambda, z, error)
        vertex = vertices_of(system, z)
        call tap%near(form_area(system, z), spline_area(vertex, .true.), 1.0e-13_dp, &
            'the area of unknowns is that of vertices')
        do i = 1, 6
            unit = 0.0_dp
            unit(merge(1, 2, i <= 3), 1 + modulo(i - 1, 3)) = 1.0_dp
            right(i) = slope_at(given, unit, lambda, 0.0_dp*unit)
            do j = 1, 6
                x = 0.0_dp
                x(j) = 1.0_dp
                whole(i, j) = slope_at(given, unit, lambda, transpose(reshape(x, [3, 2]))) &
                    - right(i)
            end do
        end do
        call solve(whole, -right, x, rcond, error)
        call tap%near(maxval(abs(vertex - transpose(reshape(x, [3, 2])))), 0.0_dp, 1.0e-13_dp, &
            'a ring of three is solved as the dense equations are')
    end subroutine check_triangle

    !> The slope of E + D + lambda S along a direction: central differences, exact of quadratics.
    real(dp) function slope_at(given, way, lambda, vertex) result(slope)
        type(fairing_data_type), intent(in) :: given    !! three points, closed
        real(dp), intent(in) :: way(2, 3)               !! the direction
        real(dp), intent(in) :: lambda                  !! the multiplier
        real(dp), intent(in) :: vertex(2, 3)            !! where
        slope = 0.5_dp*(functional(given, vertex + way, lambda) &
            - functional(given, vertex - way, lambda))
    end function slope_at

    !> E + D + lambda S.
    real(dp) function functional(given, vertex, lambda) result(value)
        type(fairing_data_type), intent(in) :: given    !! three points, closed
        real(dp), intent(in) :: vertex(2, 3)            !! its vertices
        real(dp), intent(in) :: lambda                  !! the multiplier
        real(dp) :: near(2, 3)
        near = (vertex + 4.0_dp*cshift(vertex, 1, 2) + cshift(vertex, 2, 2))/6.0_dp
        value = dot_product(given%weight, sum((near - given%point)**2, 1)) &
            + dot_product([given%beta, 1.0_dp - given%beta], spline_energy(vertex, .true.)) &
            + lambda*spline_area(vertex, .true.)
    end function functional

    !> Of the curve through the points, E - E(alpha) = 2 alpha sum |p - q|**2 + E of the difference.
    subroutine check_infinite(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp) :: matrix(14, 14), through(2, 14), rcond, energy(2), step(2)
        type(fairing_data_type) :: given
        type(fairing_type) :: fairing
        type(error_type), allocatable :: error
        integer :: i, k

        matrix = 0.0_dp
        do i = 1, 14
            matrix(i, [(1 + modulo(i + k - 1, 14), k = 0, 2)]) = [1.0_dp, 4.0_dp, 1.0_dp]/6.0_dp
        end do
        do i = 1, 2
            call solve(matrix, inlet(i, :14), through(i, :), rcond, error)
        end do
        given = inlet_data()
        call fair(given, 0.0_dp, fairing, error)
        energy = spline_energy(through, .true.)
        step = spline_energy(through - fairing%vertex, .true.)
        call tap%near(0.5_dp*sum(energy) - faired_energy(fairing), &
            2.0_dp*fairing%misfit + 0.5_dp*sum(step), 1.0e-12_dp, &
            'the energy to the curve through the points')
    end subroutine check_infinite

    !> The closed inlet of the paper, weight 100.
    function inlet_data() result(given)
        type(fairing_data_type) :: given
        allocate (given%point, source=inlet(:, :14))
        allocate (given%weight(14), source=100.0_dp)
        given%ends = fairing_end%closed
    end function inlet_data

    !> At the least, no vertex can be moved with profit: differences of E + D + lambda S.
    subroutine check_gradient(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp), parameter :: step = 1.0e-3_dp, lambda = 2.0_dp
        type(fairing_data_type) :: given
        type(fairing_type) :: fairing
        type(error_type), allocatable :: error
        real(dp) :: way(2, 14), worst
        integer :: i, k

        given = inlet_data()
        call fair(given, lambda, fairing, error)
        worst = 0.0_dp
        do i = 1, 14
            do k = 1, 2
                way = 0.0_dp
                way(k, i) = step
                worst = max(worst, abs(inlet_functional(fairing%vertex + way, lambda) &
                    - inlet_functional(fairing%vertex - way, lambda))/step)
            end do
        end do
        call tap%near(worst, 0.0_dp, 1.0e-11_dp, 'the gradient is zero by differences')
    end subroutine check_gradient

    !> E + D + lambda S of the closed inlet, weight 100.
    real(dp) function inlet_functional(vertex, lambda) result(value)
        real(dp), intent(in) :: vertex(:, :)    !! shape (2, 14)
        real(dp), intent(in) :: lambda          !! the multiplier
        real(dp) :: near(2, 14)
        near = (vertex + 4.0_dp*cshift(vertex, 1, 2) + cshift(vertex, 2, 2))/6.0_dp
        value = 0.5_dp*sum(spline_energy(vertex, .true.)) + lambda*spline_area(vertex, .true.) &
            + 100.0_dp*sum((near - inlet(:, :14))**2)
    end function inlet_functional

end program test_fairing_system
