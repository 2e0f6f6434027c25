!> Fairing by the uniform cubic B-spline that passes near measured points and has the least energy
!> of its second and third derivatives, with the area it encloses as asked for. The heavier the
!> weight of a point, the nearer it passes.
!>
!> The multiplier of the area is found by Newton's method, with
!>
!>     dS/dlambda = -conj(u) . A**-1 u,   u = i W z,   A = H - i lambda W
!>
!> kept in a bracket by bisection: S falls as the multiplier rises, as long as A is positive
!> definite. Beyond the critical multiplier there is no least; near it the curve bulges out of all
!> measure.
!>
!> Source: seed 002, section 4, with gradients corrected (doc/theory-fairing.md).
module geom_fairing
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use base_tolerances, only: area_tolerance, critical_share, critical_tolerance
    use geom_fairing_system, only: fairing_data_type, fairing_end, form_area, new_system, &
        solve_system, spline_area, spline_energy, system_type, turned, vertices_of
    implicit none (type, external)
    private

    public :: fairing_type, fair, fair_to_area, faired_energy, critical_multiplier

    !> A faired curve.
    type :: fairing_type
        real(dp), allocatable :: vertex(:, :)   !! of the B-spline, deck units: (2, vertices)
        real(dp), allocatable :: near(:, :)     !! its points next to those measured: (2, points)
        logical :: is_closed = .false.          !! behind the last vertex comes the first
        real(dp) :: beta = 0.0_dp               !! share of `energy(1)`
        real(dp) :: energy(2) = 0.0_dp          !! E2 and E3, deck units squared
        real(dp) :: misfit = 0.0_dp             !! D, deck units squared
        real(dp) :: deviation = 0.0_dp          !! largest distance from a measured point to its own
        real(dp) :: area = 0.0_dp               !! S, deck units squared
        real(dp) :: area_slope = 0.0_dp         !! dS/dlambda
        real(dp) :: lambda = 0.0_dp             !! the multiplier
        integer :: steps = 0                    !! Newton steps that led there
    end type fairing_type

    !> Steps to the multiplier at most, and doublings to beyond the critical one.
    integer, parameter :: most_steps = 100, most_doublings = 60

contains

    !> The faired curve at a multiplier of the area; 0: the area is as it comes.
    !>
    !> Fails with `cause%too_few` where there are less than two points, of a closed curve three;
    !> with `cause%bad_weight` where a weight is below zero or beta is not from 0 to 1; with
    !> `cause%singular` where too few points have weight, or the multiplier is beyond the critical
    !> one.
    pure subroutine fair(given, lambda, fairing, error)
        type(fairing_data_type), intent(in) :: given        !! the points
        real(dp), intent(in) :: lambda                      !! the multiplier
        type(fairing_type), intent(out) :: fairing          !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(system_type) :: system
        complex(dp), allocatable :: z(:)
        real(dp) :: slope

        call check(given, error)
        if (allocated(error)) return
        system = new_system(given)
        call solve_at(system, lambda, z, slope, error)
        if (allocated(error)) then
            call fail(error, cause%singular, 'there is no fairest curve at the multiplier '// &
                compact(lambda)//'; it is from '//compact(-critical_multiplier(given))//' to '// &
                compact(critical_multiplier(given)))
        else
            fairing = fairing_of(given, system, z)
            fairing%lambda = lambda
            fairing%area_slope = slope
        end if
    end subroutine fair

    !> The faired curve that encloses an area, signed as its points run.
    !>
    !> Fails as `fair` does; with `cause%no_area` where no such curve is near the points; with
    !> `cause%no_convergence` where the area is not met.
    pure subroutine fair_to_area(given, area, fairing, error)
        type(fairing_data_type), intent(in) :: given        !! the points
        real(dp), intent(in) :: area                        !! deck units squared
        type(fairing_type), intent(out) :: fairing          !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(system_type) :: system
        complex(dp), allocatable :: z(:)
        real(dp) :: bracket(2), lambda, slope, miss, scale
        integer :: step

        call check(given, error)
        if (allocated(error)) return
        system = new_system(given)
        bracket = critical_share*critical_of(system)*[-1.0_dp, 1.0_dp]
        call check_reach(system, area, bracket, error)
        if (allocated(error)) return
        lambda = 0.0_dp
        do step = 0, most_steps
            call solve_at(system, lambda, z, slope, error)
            if (allocated(error)) return
            miss = form_area(system, z) - area
            if (step == 0) scale = max(abs(area), abs(area + miss))
            if (abs(miss) <= area_tolerance*scale) exit
            bracket(merge(1, 2, miss > 0.0_dp)) = lambda
            lambda = next_multiplier(lambda, miss, slope, bracket)
        end do
        if (abs(miss) > area_tolerance*scale) then
            call fail(error, cause%no_convergence, 'the area '//compact(abs(area))// &
                ' is not met; it is missed by '//compact(abs(miss)))
            return
        end if
        fairing = fairing_of(given, system, z)
        fairing%lambda = lambda
        fairing%area_slope = slope
        fairing%steps = step
    end subroutine fair_to_area

    !> The next multiplier: Newton's, or the middle of the bracket where that is outside of it.
    pure real(dp) function next_multiplier(lambda, miss, slope, bracket) result(next)
        real(dp), intent(in) :: lambda      !! the last one
        real(dp), intent(in) :: miss        !! area there, less that asked
        real(dp), intent(in) :: slope       !! of the area there, by the multiplier
        real(dp), intent(in) :: bracket(2)  !! where the right one is

        next = 0.5_dp*(bracket(1) + bracket(2))
        if (slope >= 0.0_dp) return
        if (abs(miss) >= abs(slope)*(bracket(2) - bracket(1))) return
        if (lambda - miss/slope > bracket(1) .and. lambda - miss/slope < bracket(2)) &
            next = lambda - miss/slope
    end function next_multiplier

    !> beta E2 + gamma E3, deck units squared.
    elemental real(dp) function faired_energy(fairing) result(energy)
        type(fairing_type), intent(in) :: fairing !! a faired curve
        energy = fairing%beta*fairing%energy(1) + (1.0_dp - fairing%beta)*fairing%energy(2)
    end function faired_energy

    !> The multiplier, above zero, from which on there is no fairest curve, nor below its negative.
    pure real(dp) function critical_multiplier(given) result(critical)
        type(fairing_data_type), intent(in) :: given !! points that `fair` takes
        critical = critical_of(new_system(given))
    end function critical_multiplier

    !> The same of the equations, by bisection; a multiplier at which there still is one.
    pure real(dp) function critical_of(system) result(least)
        type(system_type), intent(in) :: system !! definite where the multiplier is zero
        real(dp) :: most, middle
        integer :: i

        least = 0.0_dp
        most = 1.0_dp
        do i = 1, most_doublings
            if (.not. is_definite(system, most)) exit
            least = most
            most = 2.0_dp*most
        end do
        do while (most - least > critical_tolerance*most)
            middle = 0.5_dp*(least + most)
            if (is_definite(system, middle)) then
                least = middle
            else
                most = middle
            end if
        end do
    end function critical_of

    !> True where the equations have a least at a multiplier.
    pure logical function is_definite(system, lambda)
        type(system_type), intent(in) :: system !! any
        real(dp), intent(in) :: lambda          !! the multiplier
        type(error_type), allocatable :: error
        complex(dp) :: z(size(system%right))
        z = system%right
        call solve_system(system, lambda, z, error)
        is_definite = .not. allocated(error)
    end function is_definite

    !> The unknowns at a multiplier and the slope of the area there.
    !>
    !> Fails with `cause%singular`.
    pure subroutine solve_at(system, lambda, z, slope, error)
        type(system_type), intent(in) :: system             !! any
        real(dp), intent(in) :: lambda                      !! the multiplier
        complex(dp), allocatable, intent(out) :: z(:)       !! the unknowns
        real(dp), intent(out) :: slope                      !! dS/dlambda
        type(error_type), allocatable, intent(out) :: error !! see above
        complex(dp) :: force(size(system%right)), pace(size(system%right))
        integer :: last

        slope = 0.0_dp
        last = size(system%right)
        allocate (z(last))
        z = system%right
        if (system%ends == fairing_end%held) z([1, last]) = system%known
        call solve_system(system, lambda, z, error)
        if (allocated(error)) return
        force = (0.0_dp, 1.0_dp)*turned(system, z)
        if (system%ends == fairing_end%held) force([1, last]) = (0.0_dp, 0.0_dp)
        pace = force
        call solve_system(system, lambda, pace, error)
        slope = -real(dot_product(force, pace), dp)
    end subroutine solve_at

    !> Is an area within what the bracket reaches? If not it is said of areas of its sign, as they
    !> are to the eye: which way the points run is not.
    !>
    !> Fails with `cause%no_area`, or `cause%singular`.
    pure subroutine check_reach(system, area, bracket, error)
        type(system_type), intent(in) :: system             !! any
        real(dp), intent(in) :: area                        !! deck units squared
        real(dp), intent(in) :: bracket(2)                  !! least and greatest multiplier
        type(error_type), allocatable, intent(out) :: error !! see above
        complex(dp), allocatable :: z(:)
        real(dp) :: reach(2), slope, sense
        integer :: i

        do i = 1, 2
            call solve_at(system, bracket(i), z, slope, error)
            if (allocated(error)) return
            reach(i) = form_area(system, z)
        end do
        if (area >= reach(2) .and. area <= reach(1)) return
        sense = sign(1.0_dp, area)
        call fail(error, cause%no_area, 'no faired curve near these points has the area '// &
            compact(abs(area))//'; with these weights it is from '// &
            compact(minval(sense*reach))//' to '//compact(maxval(sense*reach)))
    end subroutine check_reach

    !> The curve of unknowns.
    pure type(fairing_type) function fairing_of(given, system, z) result(fairing)
        type(fairing_data_type), intent(in) :: given    !! the points
        type(system_type), intent(in) :: system         !! their equations
        complex(dp), intent(in) :: z(:)                 !! the unknowns
        real(dp) :: miss(size(given%point, 2))
        integer :: i, k, n, points

        points = size(given%point, 2)
        fairing%is_closed = given%ends == fairing_end%closed
        fairing%beta = given%beta
        allocate (fairing%vertex, source=vertices_of(system, z))
        n = size(fairing%vertex, 2)
        allocate (fairing%near(2, points))
        do i = 1, points
            associate (three => fairing%vertex(:, [(1 + modulo(i + k - 1, n), k = 0, 2)]))
                fairing%near(:, i) = (three(:, 1) + 4.0_dp*three(:, 2) + three(:, 3))/6.0_dp
            end associate
        end do
        if (given%ends == fairing_end%held) &
            fairing%near(:, [1, points]) = given%point(:, [1, points])
        miss = norm2(fairing%near - given%point, dim=1)
        fairing%misfit = sum(given%weight*miss**2)
        fairing%deviation = maxval(miss)
        fairing%energy = spline_energy(fairing%vertex, fairing%is_closed)
        fairing%area = spline_area(fairing%vertex, fairing%is_closed)
    end function fairing_of

    !> Are the points such that there is one fairest curve?
    !>
    !> Fails as `fair` says.
    pure subroutine check(given, error)
        type(fairing_data_type), intent(in) :: given        !! the points
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: points, least, weighted

        points = size(given%point, 2)
        least = merge(3, 2, given%ends == fairing_end%closed)
        weighted = count(given%weight > 0.0_dp)
        if (given%ends == fairing_end%held .and. points > 1) &
            weighted = 2 + count(given%weight(2:points - 1) > 0.0_dp)
        if (points < least) then
            call fail(error, cause%too_few, 'a faired curve near '//to_text(points)// &
                ' points; it takes at least '//to_text(least))
        else if (any(given%weight < 0.0_dp)) then
            call fail(error, cause%bad_weight, 'a weight below zero')
        else if (.not. (given%beta >= 0.0_dp .and. given%beta <= 1.0_dp)) then
            call fail(error, cause%bad_weight, 'beta is '//compact(given%beta)// &
                '; it is from 0 to 1')
        else if (weighted < least_weighted(given)) then
            call fail(error, cause%singular, 'only '//to_text(weighted)//' points have weight; '// &
                'the curve is fixed by '//to_text(least_weighted(given))//' at least')
        end if
    end subroutine check

    !> Points that fix the curve: what has no energy is a point where it is closed, else a straight
    !> line or, without E2, a parabola.
    pure integer function least_weighted(given) result(least)
        type(fairing_data_type), intent(in) :: given !! the points
        least = merge(2, 3, given%beta > 0.0_dp)
        if (given%ends == fairing_end%closed) least = 1
    end function least_weighted

end module geom_fairing
