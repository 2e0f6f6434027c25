!> Arcs in the rounded numbers of controls. Oracles: G-code worked by hand; the limit of NISTIR 6556
!> for the two radii of an arc, on thousands of arcs of all sizes.
program test_nc_arcs
    use base_constants, only: pi
    use base_kinds, only: dp
    use export_nc_arcs, only: arc_path
    use export_nc_path, only: path_type
    use geom_circular, only: circular_between, circular_type, distance_from
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)
    real(dp), parameter :: origin(2) = 0.0_dp
    type(tap_type) :: tap

    call check_simple()
    call check_limits()
    call check_any(4, 100.0_dp, 2.0e-4_dp, 'inches')
    call check_any(3, 2500.0_dp, 2.0e-3_dp, 'millimetres')
    call tap%finish()

contains

    subroutine check_simple()
        type(circular_type) :: arcs(3)
        type(path_type) :: path

        arcs(1) = circular_between(origin, 0.0_dp, [1.0_dp, 1.0_dp])
        arcs(2) = circular_between([1.0_dp, 1.0_dp], 0.5_dp*pi, [1.0_dp, 3.0_dp])
        arcs(3) = circular_between([1.0_dp, 3.0_dp], 0.5_dp*pi, [2.00004_dp, 4.0_dp])
        path = arc_path(arcs, 4)
        call tap%ok(size(path%segments) == 3, 'three arcs are three segments')
        call tap%near(norm2(path%start), 0.0_dp, 0.0_dp, 'from the start of the first')
        call tap%ok(path%segments(1)%is_arc .and. .not. path%segments(1)%is_clockwise, &
            'one to the left')
        call tap%near(norm2(path%segments(1)%centre - [0.0_dp, 1.0_dp]), 0.0_dp, 0.0_dp, &
            'its centre')
        call tap%ok(.not. path%segments(2)%is_arc, 'straight ahead is straight')
        call tap%ok(path%segments(3)%is_arc .and. path%segments(3)%is_clockwise, 'one to the right')
        call tap%near(norm2(path%segments(3)%to - [2.0_dp, 4.0_dp]), 0.0_dp, 0.0_dp, &
            'ends are rounded')
        call tap%near(norm2(path%segments(3)%centre - [2.0_dp, 3.0_dp]), 0.0_dp, 1.0e-15_dp, &
            'and the centre is that of rounded ends')
    end subroutine check_simple

    subroutine check_limits()
        type(circular_type) :: arcs(2), wide(1)
        type(path_type) :: path
        real(dp) :: miss
        integer :: i

        path = arc_path(arcs(:0), 4)
        call tap%ok(size(path%segments) == 0, 'no arcs, no segments')
        arcs(1) = circular_between(origin, 0.0_dp, [1.0e-5_dp, 1.0e-5_dp])
        arcs(2) = circular_between([1.0e-5_dp, 1.0e-5_dp], 0.0_dp, [1.0_dp, 1.0e-5_dp])
        path = arc_path(arcs, 4)
        call tap%ok(size(path%segments) == 1, 'an arc whose ends fall together is left out')
        arcs(1) = circular_between(origin, 0.0_dp, [0.1_dp, 1.0e-4_dp])
        path = arc_path(arcs(:1), 4)
        call tap%ok(.not. path%segments(1)%is_arc, &
            'one whose rise is a quarter of a unit is straight')
        path = arc_path(arcs(:1), 5)
        call tap%ok(path%segments(1)%is_arc, 'with another decimal it is not')
        wide(1) = circular_between(origin, 0.0_dp, [100.0_dp, 0.25_dp])
        path = arc_path(wide, 4)
        call tap%ok(abs(wide(1)%radius) > 1.0e4_dp .and. .not. any(path%segments%is_arc), &
            'a radius of nine figures is straight pieces')
        miss = 0.0_dp
        do i = 1, size(path%segments)
            miss = max(miss, distance_from(wide(1), path%segments(i)%to))
            if (i > 1) miss = max(miss, distance_from(wide(1), 0.5_dp*(path%segments(i)%to &
                + path%segments(i - 1)%to)))
        end do
        call tap%ok(miss <= 1.21e-4_dp, 'that are on it, but for rounding')
        call tap%near(norm2(path%segments(size(path%segments))%to - [100.0_dp, 0.25_dp]), 0.0_dp, &
            0.0_dp, 'to its end')
        wide(1) = circular_between(origin, 0.0_dp, [1.0e22_dp, 1.0e22_dp])
        path = arc_path(wide, 4)
        call tap%ok(maxval(abs(path%segments(size(path%segments))%to)) >= 1.0e22_dp, &
            'coordinates beyond any machine do no harm')
    end subroutine check_limits

    !> Arcs of any size: both ends on one circle as controls have it, the middle where it was.
    subroutine check_any(decimals, reach, limit, name)
        integer, intent(in) :: decimals     !! of coordinates
        real(dp), intent(in) :: reach       !! of points
        real(dp), intent(in) :: limit       !! of the difference of two radii
        character(*), intent(in) :: name    !! of the unit
        type(random_type) :: random
        type(circular_type) :: arc
        type(path_type) :: path
        real(dp) :: at(2), finish(2), length, two_radii, off, middle(2), angle
        integer :: i, k, arcs

        two_radii = 0.0_dp
        off = 0.0_dp
        arcs = 0
        do i = 1, 20000
            at = [random%between(-reach, reach), random%between(-reach, reach)]
            length = reach*10.0_dp**random%between(-6.0_dp, 0.0_dp)
            angle = random%between(-pi, pi)
            finish = at + length*[cos(angle), sin(angle)]
            arc = circular_between(at, angle - 10.0_dp**random%between(-4.0_dp, log10(1.5_dp)) &
                *merge(1.0_dp, -1.0_dp, random%between(0.0_dp, 1.0_dp) > 0.5_dp), finish)
            path = arc_path([arc], decimals)
            if (size(path%segments) /= 1) cycle
            associate (segment => path%segments(1))
                if (.not. segment%is_arc) cycle
                arcs = arcs + 1
                two_radii = max(two_radii, abs(norm2(path%start - segment%centre) &
                    - norm2(segment%to - segment%centre)))
                do k = 1, 3
                    angle = atan2(path%start(2) - segment%centre(2), path%start(1) &
                        - segment%centre(1)) + 0.25_dp*real(k, dp)*arc%turn
                    middle = segment%centre + norm2(path%start - segment%centre) &
                        *[cos(angle), sin(angle)]
                    off = max(off, distance_from(arc, middle))
                end do
            end associate
        end do
        call tap%ok(arcs > 5000, name//': thousands of arcs stay arcs')
        call tap%ok(two_radii < 1.45_dp*10.0_dp**(-decimals) .and. two_radii <= limit, &
            name//': their ends are on one circle as NIST has it')
        call tap%ok(off <= 3.0_dp*0.5_dp*sqrt(2.0_dp)*10.0_dp**(-decimals), &
            name//': rounding moves them no more than is said')
    end subroutine check_any

end program test_nc_arcs
