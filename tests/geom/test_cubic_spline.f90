!> The parametric cubic spline: exact rational solutions and figures worked out from the equations
!> of seed 000, and what holds of every spline. The digits of the chord-length cases were computed
!> in 2026 with scipy 1.17.1 (CubicSpline).
program test_cubic_spline
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_bezier, only: bezier_jet, bezier_point
    use geom_cubic_spline, only: closed_spline, cubic_spline_type, open_spline, spline_end, &
        spline_end_type, spline_segment
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    !> Points a chord of sqrt(5) apart, and points at any distances.
    real(dp), parameter :: even(2, 5) = reshape([0.0_dp, 0.0_dp, 1.0_dp, 2.0_dp, 3.0_dp, 3.0_dp, &
        4.0_dp, 1.0_dp, 6.0_dp, 0.0_dp], [2, 5])
    real(dp), parameter :: uneven(2, 5) = reshape([0.0_dp, 0.0_dp, 1.0_dp, 2.0_dp, 4.0_dp, 3.0_dp, &
        5.0_dp, 1.0_dp, 9.0_dp, 0.0_dp], [2, 5])
    type(spline_end_type), parameter :: free = spline_end_type(), &
        parabola = spline_end_type(kind=spline_end%parabolic)
    type(tap_type) :: tap

    call check_uniform(tap)
    call check_chords(tap)
    call check_closed(tap)
    call check_properties(tap)
    call check_steep(tap)
    call check_bad(tap)
    call tap%finish()

contains

    !> The tangents of uniform splines are fractions.
    subroutine check_uniform(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(cubic_spline_type) :: spline
        type(error_type), allocatable :: error
        type(spline_end_type) :: clamp

        clamp = spline_end_type(spline_end%clamped, [1.0_dp, 1.0_dp])
        call open_spline(even, .true., [free, free], spline, error)
        call check_tangents(tap, spline, 28, [18, 57, 48, 54, 42, -21, 36, -54, 66, -15], &
            'free ends')
        call tap%near(energy(spline), 25.285714285714286_dp, 1.0e-13_dp, 'least energy')
        call tap%near(norm2(bezier_point(spline_segment(spline, 2), 0.5_dp) &
            - [2.0267857142857143_dp, 2.8348214285714286_dp]), 0.0_dp, 1.0e-15_dp, &
            'middle of the second segment')
        call open_spline(even, .true., [clamp, free], spline, error)
        call check_tangents(tap, spline, 97, [97, 97, 157, 214, 148, -80, 124, -185, 229, -53], &
            'clamped and free, matrix (19) corrected')
        call open_spline(even, .true., [free, parabola], spline, error)
        call check_tangents(tap, spline, 71, [46, 145, 121, 136, 109, -50, 82, -149, 202, 7], &
            'free and parabolic, matrix (20)')
        call open_spline(even, .true., [parabola, parabola], spline, error)
        call tap%near(maxval(abs(spline%tangent(:, 1) - [1.0_dp/6.0_dp, 2.1_dp])), 0.0_dp, &
            1.0e-14_dp, 'parabolas at both ends')
    end subroutine check_uniform

    !> Compares all tangents with fractions.
    subroutine check_tangents(tap, spline, denominator, numerators, name)
        type(tap_type), intent(inout) :: tap            !! the tally
        type(cubic_spline_type), intent(in) :: spline   !! five points
        integer, intent(in) :: denominator              !! of all
        integer, intent(in) :: numerators(10)           !! x and y of each tangent
        character(*), intent(in) :: name                !! the check as a phrase
        call tap%near(maxval(abs(real(denominator, dp)*spline%tangent &
            - reshape(real(numerators, dp), [2, 5]))), 0.0_dp, 1.0e-12_dp, name)
    end subroutine check_tangents

    !> The integral of |r''|**2 over the parameter.
    pure real(dp) function energy(spline)
        type(cubic_spline_type), intent(in) :: spline !! any
        real(dp), dimension(2) :: point, first, from, to
        integer :: i

        energy = 0.0_dp
        do i = 1, size(spline%length)
            call bezier_jet(spline_segment(spline, i), 0.0_dp, point, first, from)
            call bezier_jet(spline_segment(spline, i), 1.0_dp, point, first, to)
            energy = energy + (dot_product(from, from) + dot_product(from, to) &
                + dot_product(to, to))/(3.0_dp*spline%length(i)**3)
        end do
    end function energy

    !> By lengths of chords.
    subroutine check_chords(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(cubic_spline_type) :: spline
        type(error_type), allocatable :: error
        type(spline_end_type) :: clamp

        clamp = spline_end_type(spline_end%clamped, [1.0_dp, 2.0_dp]/sqrt(5.0_dp))
        call open_spline(uneven, .false., [free, free], spline, error)
        call tap%near(maxval(abs(spline%tangent(:, [1, 3, 5]) - reshape([0.292198649155_dp, &
            0.934296997090_dp, 0.673890199300_dp, -0.511538598084_dp, 1.196291298848_dp, &
            0.057211698458_dp], [2, 3]))), 0.0_dp, 1.0e-12_dp, 'free ends, by chords')
        call tap%near(norm2(bezier_point(spline_segment(spline, 2), 0.5_dp) &
            - [2.532948280419_dp, 3.024236926444_dp]), 0.0_dp, 1.0e-12_dp, 'its second middle')
        call tap%near(energy(spline), 1.8478642199_dp, 1.0e-10_dp, 'its energy')
        call tap%near(maxval(abs(spline_segment(spline, 2) - reshape([1.0_dp, 2.0_dp, &
            1.7982047220_dp, 2.8587561102_dp, 3.2896573591_dp, 3.5392090270_dp, 4.0_dp, 3.0_dp], &
            [2, 4]))), 0.0_dp, 1.0e-10_dp, 'its second segment as a Bezier curve')
        call open_spline(uneven, .false., [parabola, parabola], spline, error)
        call tap%near(maxval(abs(spline%tangent(:, [1, 5]) - reshape([0.073269927457_dp, &
            0.998552859308_dp, 1.471078769348_dp, 0.431471725114_dp], [2, 2]))), 0.0_dp, &
            1.0e-12_dp, 'parabolas, by chords')
        call open_spline(uneven, .false., [clamp, free], spline, error)
        call tap%near(maxval(abs(spline%tangent(:, 3) - [0.684913873098_dp, &
            -0.514373884275_dp])), 0.0_dp, 1.0e-12_dp, 'clamped, by chords')
    end subroutine check_chords

    !> Closed splines.
    subroutine check_closed(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(cubic_spline_type) :: spline
        type(error_type), allocatable :: error
        real(dp) :: ring(2, 7)
        integer :: i

        call closed_spline(reshape([1.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, -1.0_dp, 0.0_dp, 0.0_dp, &
            -1.0_dp], [2, 4]), .true., spline, error)
        call tap%near(norm2(spline%tangent(:, 1) - [0.0_dp, 1.5_dp]), 0.0_dp, 1.0e-15_dp, &
            'a square')
        call closed_spline(even(:, :3), .false., spline, error)
        call tap%near(bend_gap(spline), 0.0_dp, 1.0e-13_dp, 'three points make a closed spline')
        do i = 1, 7
            ring(:, i) = real(i*i, dp)*[cos(0.9_dp*real(i, dp)), sin(0.9_dp*real(i, dp))]
        end do
        call closed_spline(ring, .false., spline, error)
        call tap%near(bend_gap(spline), 0.0_dp, 1.0e-13_dp, &
            'curvature goes on round a closed spline')
        call tap%ok(norm2(matmul(spline_segment(spline, 7), &
            [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp]) - ring(:, 1)) <= 0.0_dp, 'it ends where it begins')
    end subroutine check_closed

    !> The largest jump of r'' at a point, over the largest r''.
    pure real(dp) function bend_gap(spline)
        type(cubic_spline_type), intent(in) :: spline !! any
        real(dp), dimension(2) :: point, first, before, after
        real(dp) :: largest
        integer :: i, next

        bend_gap = 0.0_dp
        largest = 0.0_dp
        do i = 1, size(spline%length) - merge(0, 1, spline%is_closed)
            next = 1 + modulo(i, size(spline%length))
            call bezier_jet(spline_segment(spline, i), 1.0_dp, point, first, before)
            call bezier_jet(spline_segment(spline, next), 0.0_dp, point, first, after)
            before = before/spline%length(i)**2
            after = after/spline%length(next)**2
            bend_gap = max(bend_gap, norm2(after - before))
            largest = max(largest, norm2(before))
        end do
        bend_gap = bend_gap/largest
    end function bend_gap

    !> What holds of all splines.
    subroutine check_properties(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(cubic_spline_type) :: spline, image
        type(spline_end_type) :: exact(2)
        type(error_type), allocatable :: error
        type(random_type) :: random
        real(dp) :: points(2, 12), worst(3), turn(2, 2), x
        integer :: i, k

        worst = 0.0_dp
        do i = 1, 200
            do k = 1, 12
                points(:, k) = [random%between(0.0_dp, 9.0_dp), random%between(0.0_dp, 9.0_dp)]
            end do
            call open_spline(points, .false., [free, parabola], spline, error)
            worst(1) = max(worst(1), bend_gap(spline))
            x = random%between(0.0_dp, 6.0_dp)
            turn = 3.0_dp*reshape([cos(x), sin(x), -sin(x), cos(x)], [2, 2])
            call open_spline(matmul(turn, points), .false., [free, parabola], image, error)
            worst(2) = max(worst(2), &
                maxval(abs(3.0_dp*image%tangent - matmul(turn, spline%tangent))))
            turn = reshape([1.0_dp, 0.3_dp, x, 2.0_dp], [2, 2])
            call open_spline(points, .true., [free, parabola], spline, error)
            call open_spline(matmul(turn, points), .true., [free, parabola], image, error)
            worst(3) = max(worst(3), maxval(abs(image%tangent - matmul(turn, spline%tangent))))
        end do
        call tap%near(worst(1), 0.0_dp, 1.0e-12_dp, 'curvature goes on through every point')
        call tap%near(worst(2), 0.0_dp, 1.0e-11_dp, 'turned and enlarged points, by chords')
        call tap%near(worst(3), 0.0_dp, 1.0e-11_dp, 'any affine image, uniform')
        points(1, :) = [(real(k, dp), k=1, 12)]
        points(2, :) = points(1, :)**3 - 20.0_dp*points(1, :)**2
        exact(1) = spline_end_type(spline_end%clamped, [1.0_dp, 3.0_dp - 40.0_dp])
        exact(2) = spline_end_type(spline_end%clamped, [1.0_dp, 432.0_dp - 480.0_dp])
        call open_spline(points, .true., exact, spline, error)
        call tap%near(maxval(abs(spline%tangent(2, :) - 3.0_dp*points(1, :)**2 &
            + 40.0_dp*points(1, :))), 0.0_dp, 1.0e-11_dp, 'a cubic with its slopes comes back')
        points(2, :) = points(1, :)**2
        call open_spline(points, .true., [parabola, parabola], spline, error)
        call tap%near(maxval(abs(spline%tangent(2, :) - 2.0_dp*points(1, :))), 0.0_dp, &
            1.0e-12_dp, 'a parabola with parabolic ends comes back')
        call open_spline(points(:, :2), .false., [parabola, parabola], spline, error)
        call tap%near(norm2(spline%tangent(:, 1) - spline%tangent(:, 2)) &
            + abs(norm2(spline%tangent(:, 1)) - 1.0_dp), 0.0_dp, 1.0e-15_dp, &
            'two points with parabolic ends are a straight line')
    end subroutine check_properties

    !> The seed's note on large slopes: a quarter of a circle through the vertical. As y over x the
    !> cubic is off by more than a hundred times as much.
    subroutine check_steep(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(cubic_spline_type) :: spline, plain
        type(spline_end_type) :: ends(2)
        type(error_type), allocatable :: error
        real(dp) :: points(2, 5), errors(2)
        integer :: i, k

        do i = 1, 5
            points(:, i) = [1.0_dp - cos(0.4_dp*real(i - 1, dp)), sin(0.4_dp*real(i - 1, dp))]
        end do
        ends(1) = spline_end_type(spline_end%clamped, [0.0_dp, 1.0_dp])
        ends(2) = spline_end_type(spline_end%clamped, [sin(1.6_dp), cos(1.6_dp)])
        call open_spline(points, .false., ends, spline, error)
        call open_spline_over_x(points, plain)
        errors = 0.0_dp
        do i = 1, 4
            do k = 1, 19
                errors(1) = max(errors(1), off_circle(spline, i, 0.05_dp*real(k, dp)))
                errors(2) = max(errors(2), off_circle(plain, i, 0.05_dp*real(k, dp)))
            end do
        end do
        call tap%ok(errors(1) < 2.0e-4_dp, 'a vertical start is nothing special to the spline')
        call tap%ok(errors(2) > 100.0_dp*errors(1), 'but it is to a cubic of y over x')
    end subroutine check_steep

    !> The spline of y over x through points, free ends: x is linear in the parameter.
    subroutine open_spline_over_x(points, spline)
        real(dp), intent(in) :: points(:, :)            !! in order of x
        type(cubic_spline_type), intent(out) :: spline  !! with x as parameter
        type(cubic_spline_type) :: fine
        type(error_type), allocatable :: error
        real(dp) :: shrunk(2, size(points, 2))

        ! With y made very small the chords are the steps of x.
        shrunk(1, :) = points(1, :)
        shrunk(2, :) = 1.0e-9_dp*points(2, :)
        call open_spline(shrunk, .false., [free, free], fine, error)
        spline = fine
        spline%point(2, :) = points(2, :)
        spline%tangent(2, :) = 1.0e9_dp*fine%tangent(2, :)
    end subroutine open_spline_over_x

    !> How far a point of a segment is from the circle about (1, 0).
    pure real(dp) function off_circle(spline, segment, t)
        type(cubic_spline_type), intent(in) :: spline   !! any
        integer, intent(in) :: segment                  !! which
        real(dp), intent(in) :: t                       !! 0 to 1
        off_circle = abs(norm2(bezier_point(spline_segment(spline, segment), t) &
            - [1.0_dp, 0.0_dp]) - 1.0_dp)
    end function off_circle

    !> Points that make no spline.
    subroutine check_bad(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(cubic_spline_type) :: spline
        type(error_type), allocatable :: error

        call open_spline(even(:, :1), .false., [free, free], spline, error)
        call tap%ok(error%cause == cause%too_few, 'one point is no spline')
        call tap%same(error%message, 'a spline through 1 points; it takes at least 2', &
            'it says how many are needed')
        call open_spline(even(:, [1, 2, 2, 3]), .true., [free, free], spline, error)
        call tap%ok(error%cause == cause%points_coincide, 'a point twice')
        call tap%has(error%message, 'points 2 and 3', 'it says which')
        call closed_spline(even(:, :2), .false., spline, error)
        call tap%ok(error%cause == cause%too_few, 'two points are no closed spline')
        call closed_spline(even(:, [1, 2, 3, 1]), .false., spline, error)
        call tap%has(error%message, 'points 4 and 1', 'a closed spline names its first point once')
    end subroutine check_bad

end program test_cubic_spline
