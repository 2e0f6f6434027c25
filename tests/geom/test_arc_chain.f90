!> Chains of circular arcs: the figures worked out from the equations of seed 003, second paper, and
!> its two example functions; what holds of every chain.
program test_arc_chain
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc_chain, only: arc_pair, arcs_along, chain_arc_type, reversed_chain
    use geom_circular, only: circular_between, circular_type, distance_from, leaving, wrapped
    use support_plane_curves, only: example_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_pairs()
    call check_errors(tap)
    call check_cubic(tap)
    call check_wave(tap)
    call check_special(tap)
    call check_any(tap)
    call tap%finish()

contains

    !> Pairs on -x**2 and x**3, figure for figure.
    subroutine check_pairs()
        call check_pair(1, [0.5_dp, 1.5_dp], 0.86710149094788_dp, &
            [-2.02866565763780_dp, -10.44052764818899_dp], 0.008896017202_dp, &
            '-x**2 from .5 to 1.5')
        call check_pair(1, [0.0_dp, 1.0_dp], 0.43168341659058_dp, &
            [-0.59317528607966_dp, -3.40968771525280_dp], 0.012167329553_dp, '-x**2 from 0 to 1')
        call check_pair(1, [0.0_dp, 0.5_dp], 0.26923672942748_dp, &
            [-0.53624420823740_dp, -1.12551964445124_dp], 0.001306677651_dp, '-x**2 from 0 to .5')
        call check_pair(1, [-1.5_dp, -0.5_dp], -0.86710149094788_dp, &
            [-10.44052764818899_dp, -2.02866565763780_dp], 0.008896017202_dp, 'curvature grows')
        call check_pair(4, [0.0_dp, 1.0_dp], 0.784207276231_dp, &
            [0.878722842931_dp, 3.836761533286_dp], 0.028956833290_dp, 'x**3 from its inflection')
    end subroutine check_pairs

    !> One pair of arcs.
    subroutine check_pair(which, range, x, radii, deviation, name)
        integer, intent(in) :: which            !! example
        real(dp), intent(in) :: range(2)        !! of x
        real(dp), intent(in) :: x               !! of the point between
        real(dp), intent(in) :: radii(2)        !! of the arcs
        real(dp), intent(in) :: deviation       !! the larger of the two
        character(*), intent(in) :: name        !! the check as a phrase
        type(example_type) :: f
        type(chain_arc_type), allocatable :: pair(:)
        real(dp) :: point(2), first(2), second(2), largest
        logical :: exists
        integer :: i, k

        f = example_type(which, range)
        call f%jet(0.0_dp, point, first, second)
        call arc_pair(f, [0.0_dp, 1.0_dp], atan2(first(2), first(1)), pair, exists)
        call tap%ok(exists, name//' has a pair')
        call tap%near(pair(1)%arc%finish(1), x, 1.0e-11_dp, 'its middle point')
        call tap%near(maxval(abs([pair(1)%arc%radius, pair(2)%arc%radius]/radii - 1.0_dp)), &
            0.0_dp, 1.0e-10_dp, 'its radii')
        largest = 0.0_dp
        do i = 1, 2
            do k = 0, 2000
                call f%jet(pair(i)%ends(1) + (pair(i)%ends(2) - pair(i)%ends(1)) &
                    *real(k, dp)/2000.0_dp, point, first, second)
                largest = max(largest, &
                    abs(norm2(point - pair(i)%arc%centre) - abs(pair(i)%arc%radius)))
            end do
        end do
        call tap%near(largest, deviation, 1.0e-6_dp, 'its deviation')
        call f%jet(1.0_dp, point, first, second)
        call tap%near(wrapped(leaving(pair(2)%arc) - atan2(first(2), first(1))), 0.0_dp, &
            1.0e-13_dp, 'it leaves as the curve does')
        call tap%near(norm2(pair(2)%arc%centre + pair(2)%arc%radius*[sin(leaving(pair(2)%arc)), &
            -cos(leaving(pair(2)%arc))] - point), 0.0_dp, 1.0e-12_dp, 'and ends on it')
    end subroutine check_pair

    !> A wrong direction to begin with is put right, up to the limit of the paper's (12).
    subroutine check_errors(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(example_type) :: f
        type(chain_arc_type), allocatable :: pair(:)
        real(dp), parameter :: limit = 0.17985349979248_dp
        real(dp) :: direction
        logical :: exists

        f = example_type(1, [0.5_dp, 1.5_dp])
        direction = atan2(-1.0_dp, 1.0_dp)
        call arc_pair(f, [0.0_dp, 1.0_dp], direction + 0.5_dp*limit, pair, exists)
        call tap%near(pair(1)%arc%finish(1), 0.66437586540427_dp, 1.0e-11_dp, &
            'half the limit off moves the middle point')
        call arc_pair(f, [0.0_dp, 1.0_dp], direction + 0.99_dp*limit, pair, exists)
        call tap%ok(exists .and. abs(pair(1)%arc%finish(1) - 0.5030026625_dp) < 1.0e-9_dp, &
            '.99 of it is still put right')
        call arc_pair(f, [0.0_dp, 1.0_dp], direction - 0.99_dp*limit, pair, exists)
        call tap%ok(exists .and. abs(pair(1)%arc%finish(1) - 1.4910475470_dp) < 1.0e-9_dp, &
            'either way')
        call arc_pair(f, [0.0_dp, 1.0_dp], direction + 1.01_dp*limit, pair, exists)
        call tap%ok(.not. exists, '1.01 of it is not')
    end subroutine check_errors

    !> The first example of the paper: 29 points, 15 of them initial.
    subroutine check_cubic(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp), parameter :: tolerances(8) = [0.1_dp, 0.05_dp, 0.02_dp, 0.01_dp, 0.005_dp, &
            0.002_dp, 0.001_dp, 0.0001_dp]
        integer, parameter :: initial(8) = [9, 9, 11, 13, 15, 19, 23, 45]
        type(example_type) :: f
        type(chain_arc_type), allocatable :: arcs(:)
        type(error_type), allocatable :: error
        integer :: i
        logical :: are_same

        f = example_type(2, [-6.0_dp, 6.0_dp])
        are_same = .true.
        do i = 1, size(tolerances)
            call arcs_along(f, tolerances(i), arcs, error)
            are_same = are_same .and. 1 + count(arcs%is_primary) == initial(i)
            if (1 + count(arcs%is_primary) /= initial(i)) &
                call tap%ok(.false., 'count of initial points')
        end do
        call tap%ok(are_same, 'as many initial points as the method gives at eight tolerances')
        call arcs_along(f, 0.005_dp, arcs, error)
        call tap%ok(size(arcs) + 1 == 29, 'the 29 points of the paper')
        call check_back(tap, arcs)
        call check_chain(tap, f, arcs, 0.005_dp)
    end subroutine check_cubic

    !> A chain backwards: the same points, primary as they were.
    subroutine check_back(tap, arcs)
        type(tap_type), intent(inout) :: tap            !! the tally
        type(chain_arc_type), intent(in) :: arcs(:)     !! a chain
        type(chain_arc_type) :: back(size(arcs))
        integer :: i, count
        logical :: are_same

        back = reversed_chain(arcs)
        count = size(arcs)
        are_same = back(count)%is_primary
        do i = 1, count - 1
            are_same = are_same .and. norm2(back(i)%arc%finish - arcs(count - i)%arc%finish) &
                <= 0.0_dp .and. (back(i)%is_primary .eqv. arcs(count - i)%is_primary) .and. &
                abs(back(i)%ends(2) - back(i + 1)%ends(1)) <= 0.0_dp
        end do
        call tap%ok(are_same, 'backwards it has the same points, secondary where they were')
        call tap%near(maxval(abs(back(count:1:-1)%deviation - arcs%deviation)), 0.0_dp, 0.0_dp, &
            'and deviations')
        are_same = .true.
        do i = 1, count
            are_same = are_same .and. distance_from(arcs(i)%arc, arcs(i)%worst) &
                >= arcs(i)%deviation .and. arcs(i)%deviation > 0.0_dp
        end do
        call tap%ok(are_same, 'the place of a deviation is that far from its arc')
    end subroutine check_back

    !> The second example.
    subroutine check_wave(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp), parameter :: tolerances(5) = [0.1_dp, 0.02_dp, 0.01_dp, 0.005_dp, 0.001_dp]
        integer, parameter :: wide(5) = [17, 21, 27, 27, 41], narrow(5) = [13, 15, 19, 19, 29]
        type(chain_arc_type), allocatable :: arcs(:)
        type(error_type), allocatable :: error
        integer :: i, counts(2, 5)

        do i = 1, 5
            call arcs_along(example_type(3, [-9.0_dp, 9.0_dp]), tolerances(i), arcs, error)
            counts(1, i) = 1 + count(arcs%is_primary)
            call arcs_along(example_type(3, [-6.0_dp, 6.0_dp]), tolerances(i), arcs, error)
            counts(2, i) = 1 + count(arcs%is_primary)
        end do
        call tap%ok(all(abs(counts(1, :) - wide) <= 1), 'the wave from -9 to 9')
        call tap%ok(all(abs(counts(2, :) - narrow) <= 1), 'the wave from -6 to 6')
        call check_chain(tap, example_type(3, [-6.0_dp, 6.0_dp]), arcs, 0.001_dp)
    end subroutine check_wave

    !> Curves that are an arc or a line; a curve of sharp bends.
    subroutine check_special(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(chain_arc_type), allocatable :: arcs(:)
        type(error_type), allocatable :: error
        type(circular_type) :: arc

        call arcs_along(example_type(5, [0.3_dp, 2.9_dp]), 1.0e-9_dp, arcs, error)
        call tap%ok(size(arcs) == 1, 'a circle is one arc')
        call tap%near(arcs(1)%arc%radius, 2.0_dp, 1.0e-14_dp, 'of its radius')
        call tap%near(arcs(1)%arc%turn, 2.6_dp, 1.0e-14_dp, 'and its turn')
        call arcs_along(example_type(7, [0.0_dp, 9.0_dp]), 1.0e-9_dp, arcs, error)
        call tap%ok(size(arcs) == 1 .and. arcs(1)%arc%is_line, 'a line is one line')
        call tap%ok(arcs(1)%deviation < 1.0e-15_dp, 'exactly')
        call arcs_along(example_type(6, [0.1_dp, 6.2_dp]), 1.0e-3_dp, arcs, error)
        call check_chain(tap, example_type(6, [0.1_dp, 6.2_dp]), arcs, 1.0e-3_dp)
        call arcs_along(example_type(6, [0.1_dp, 6.2_dp]), 1.0e-18_dp, arcs, error)
        call tap%ok(allocated(error), 'a tolerance below rounding is refused')
        arc = circular_between([0.0_dp, 0.0_dp], 0.0_dp, [0.0_dp, 2.0_dp])
        call tap%near(norm2(arc%centre - [0.0_dp, 1.0_dp]) + abs(arc%turn - pi), 0.0_dp, &
            1.0e-15_dp, 'half a turn to the left')
    end subroutine check_special

    !> What holds of a chain: it is on the curve, smooth, and within its tolerance, measured apart.
    subroutine check_chain(tap, f, arcs, tolerance)
        type(tap_type), intent(inout) :: tap            !! the tally
        type(example_type), intent(in) :: f             !! the curve
        type(chain_arc_type), intent(in) :: arcs(:)     !! along it
        real(dp), intent(in) :: tolerance               !! asked
        real(dp) :: point(2), first(2), second(2), worst(4)
        integer :: i, k

        worst = 0.0_dp
        do i = 1, size(arcs)
            associate (arc => arcs(i)%arc)
                do k = 0, 777
                    call f%jet(arcs(i)%ends(1) + (arcs(i)%ends(2) - arcs(i)%ends(1)) &
                        *real(k, dp)/777.0_dp, point, first, second)
                    if (k == 0) worst(1) = max(worst(1), norm2(point - arc%start))
                    worst(2) = max(worst(2), abs(norm2(point - arc%centre) - abs(arc%radius)))
                end do
                if (arcs(i)%is_primary) worst(3) = max(worst(3), &
                    abs(wrapped(leaving(arc) - atan2(first(2), first(1)))))
                if (i == size(arcs)) cycle
                worst(4) = max(worst(4), abs(wrapped(leaving(arc) - arcs(i + 1)%arc%direction)), &
                    norm2(arc%finish - arcs(i + 1)%arc%start))
            end associate
        end do
        call tap%near(worst(1), 0.0_dp, 0.0_dp, 'arcs begin on the curve')
        call tap%ok(worst(2) <= tolerance, 'within the tolerance')
        call tap%near(worst(2), maxval(arcs%deviation), 0.01_dp*tolerance, 'as the chain says')
        call tap%near(worst(3), 0.0_dp, 1.0e-12_dp, 'with the curve''s tangents')
        call tap%near(worst(4), 0.0_dp, 1.0e-12_dp, 'and one arc goes on as the other')
    end subroutine check_chain

    !> Fewer arcs never come of a finer tolerance; backwards the arcs of a pair are the same.
    subroutine check_any(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(chain_arc_type), allocatable :: arcs(:), pair(:), back(:)
        type(error_type), allocatable :: error
        integer :: before, i
        logical :: is_rising, exists

        before = 0
        is_rising = .true.
        do i = 0, 15
            call arcs_along(example_type(3, [-9.0_dp, 9.0_dp]), 0.5_dp**i, arcs, error)
            is_rising = is_rising .and. size(arcs) >= before
            before = size(arcs)
        end do
        call tap%ok(is_rising, 'half the tolerance never takes fewer arcs')
        call arc_pair(example_type(1, [0.5_dp, 1.5_dp]), [0.0_dp, 1.0_dp], &
            atan2(-1.0_dp, 1.0_dp), pair, exists)
        call arc_pair(example_type(1, [1.5_dp, 0.5_dp]), [0.0_dp, 1.0_dp], &
            atan2(3.0_dp, -1.0_dp), back, exists)
        call tap%near(pair(1)%arc%radius + back(2)%arc%radius, 0.0_dp, 1.0e-12_dp, &
            'backwards the arcs are the same')
    end subroutine check_any

end program test_arc_chain
