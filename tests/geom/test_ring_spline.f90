!> Rings: the same curve with more vertices, backwards, begun elsewhere; area and centroid of curves
!> for which polynomials were integrated apart from LOFT, and of circles.
program test_ring_spline
    use base_constants, only: pi
    use base_kinds, only: dp
    use geom_fairing_system, only: spline_area
    use geom_ring_spline, only: refined_ring, ring_centroid, ring_from, ring_unlikeness, turned_ring
    use support_inlet, only: inlet
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp) :: vertex(2, 14), worst
    real(dp), allocatable :: fine(:, :)
    integer :: parts, i

    vertex = inlet(:, :14)
    do parts = 1, 6
        allocate (fine, source=refined_ring(vertex, parts))
        worst = 0.0_dp
        do i = 0, 5*14*parts
            worst = max(worst, norm2(at(vertex, real(i, dp)/real(5*parts, dp)) - &
                at(fine, real(i, dp)/5.0_dp)))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-15_dp, 'a finer ring is the same curve')
        deallocate (fine)
    end do
    call check_halves()
    worst = 0.0_dp
    do i = 0, 140
        worst = max(worst, norm2(at(vertex, 0.1_dp*real(i, dp)) - at(turned_ring(vertex), &
            14.0_dp - 0.1_dp*real(i, dp))), norm2(at(vertex, modulo(0.1_dp*real(i, dp) + 4.0_dp, &
            14.0_dp)) - at(ring_from(vertex, 5), 0.1_dp*real(i, dp))))
    end do
    call tap%near(worst, 0.0_dp, 1.0e-14_dp, 'backwards from point 1, and begun with point 5')
    call tap%near(ring_unlikeness(circle(24, 0.0_dp), 3.0_dp*circle(24, 0.5_dp)), &
        1.0_dp - cos(0.5_dp), 1.0e-15_dp, 'circles are as unlike as they are turned')
    call tap%near(ring_unlikeness(vertex, 0.2_dp*vertex + 7.0_dp), 0.0_dp, 1.0e-14_dp, &
        'what is moved and scaled is the same')
    call check_centroid()
    call tap%finish()

contains

    !> Halves: new vertices are (V(j) + 6 V(j+1) + V(j+2))/8 and (V(j) + V(j+1))/2.
    subroutine check_halves()
        real(dp) :: wanted(2, 28)
        integer :: j
        do j = 1, 14
            wanted(:, 1 + modulo(2*j - 3, 28)) = 0.125_dp*(vertex(:, 1 + modulo(j - 2, 14)) &
                + 6.0_dp*vertex(:, j) + vertex(:, 1 + modulo(j, 14)))
            wanted(:, 1 + modulo(2*j - 2, 28)) = 0.5_dp*(vertex(:, j) &
                + vertex(:, 1 + modulo(j, 14)))
        end do
        call tap%near(maxval(abs(refined_ring(vertex, 2) - wanted)), 0.0_dp, 1.0e-15_dp, &
            'halves are those of Lane and Riesenfeld')
    end subroutine check_halves

    !> The centroid: of a circle its centre; of a lopsided ring that of a fine polygon.
    subroutine check_centroid()
        real(dp) :: centroid(2), area, moment(2), one(2), other(2), across
        integer, parameter :: sides = 140000
        integer :: k
        call tap%near(norm2(ring_centroid(circle(9, 0.3_dp) + 50.0_dp) - 50.0_dp), 0.0_dp, &
            1.0e-14_dp, 'the centroid of a circle')
        area = 0.0_dp
        moment = 0.0_dp
        one = at(vertex, 0.0_dp)
        do k = 1, sides
            other = at(vertex, 14.0_dp*real(k, dp)/real(sides, dp))
            across = one(1)*other(2) - one(2)*other(1)
            area = area + 0.5_dp*across
            moment = moment + across*(one + other)/6.0_dp
            one = other
        end do
        centroid = ring_centroid(vertex)
        call tap%near(norm2(centroid - moment/area), 0.0_dp, 1.0e-9_dp, &
            'the centroid of the inlet is that of a polygon of 140000 sides')
        call tap%near(spline_area(vertex, .true.), area, 1.0e-9_dp, '... and so is its area')
        call tap%near(norm2(ring_centroid(turned_ring(vertex)) - centroid), 0.0_dp, 1.0e-15_dp, &
            'it is the same clockwise')
    end subroutine check_centroid

    !> The point of a ring at a parameter, by its powers.
    pure function at(ring, t) result(point)
        real(dp), intent(in) :: ring(:, :)  !! vertices
        real(dp), intent(in) :: t           !! 0 to their number
        real(dp) :: point(size(ring, 1)), u, share(4)
        integer :: segment, k
        segment = min(int(t), size(ring, 2) - 1)
        u = t - real(segment, dp)
        share = [(1.0_dp - u)**3, 3.0_dp*u**3 - 6.0_dp*u**2 + 4.0_dp, &
            -3.0_dp*u**3 + 3.0_dp*u**2 + 3.0_dp*u + 1.0_dp, u**3]/6.0_dp
        point = 0.0_dp
        do k = 1, 4
            point = point + share(k)*ring(:, 1 + modulo(segment + k - 1, size(ring, 2)))
        end do
    end function at

    !> Vertices on a circle of radius 1.
    pure function circle(number, begin) result(vertices)
        integer, intent(in) :: number       !! of vertices
        real(dp), intent(in) :: begin       !! angle of the first, radians
        real(dp) :: vertices(2, number), angle(number)
        integer :: k
        angle = begin + [(2.0_dp*pi*real(k, dp)/real(number, dp), k = 0, number - 1)]
        vertices(1, :) = cos(angle)
        vertices(2, :) = sin(angle)
    end function circle

end program test_ring_spline
