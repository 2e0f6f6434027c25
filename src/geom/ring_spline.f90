!> The closed uniform cubic B-spline as a ring of vertices: the same curve with more vertices, run
!> through backwards or begun at another of its points; its area and centroid.
!>
!> The point of number k, the joint of two segments, is (V(k) + 4 V(k+1) + V(k+2))/6; the curve
!> begins with point 1.
!>
!> Source: seed 002, equation (1). Refinement: the B-spline N over whole numbers is the sum of
!> a(k) N(p t - k), with a(k) the coefficients of ((1 + z + ... + z**(p-1))**4)/p**3; G. de Rham,
!> "Sur une courbe plane", J. Math. Pures Appl. 35 (1956), and J. Lane and R. Riesenfeld, IEEE
!> Trans. PAMI 2 (1980), for p = 2.
module geom_ring_spline
    use base_kinds, only: dp
    use geom_bezier, only: bezier_jet
    use geom_fairing_curve, only: uniform_segments
    use geom_fairing_system, only: spline_area
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: refined_ring, turned_ring, ring_from, ring_unlikeness, ring_centroid

    !> Nodes and weights of Gauss's rule of five points over -1 to 1: exact up to degree 9.
    real(dp), parameter :: node(5) = [-0.9061798459386640_dp, -0.5384693101056831_dp, 0.0_dp, &
        0.5384693101056831_dp, 0.9061798459386640_dp]
    real(dp), parameter :: weight(5) = [0.2369268850561891_dp, 0.4786286704993665_dp, &
        0.5688888888888889_dp, 0.4786286704993665_dp, 0.2369268850561891_dp]

contains

    !> The same curve with each segment in as many equal parts: so many times the vertices.
    pure function refined_ring(vertex, parts) result(fine)
        real(dp), intent(in) :: vertex(:, :)    !! deck units, shape (dimensions, vertices)
        integer, intent(in) :: parts            !! 1 or more
        real(dp), allocatable :: fine(:, :)     !! shape (dimensions, parts*vertices)
        real(dp) :: share(0:4*(parts - 1))
        integer :: j, k, m, last

        share = shares_of(parts)
        last = parts*size(vertex, 2)
        allocate (fine(size(vertex, 1), last), source=0.0_dp)
        do j = 1, size(vertex, 2)
            do k = 0, 4*(parts - 1)
                m = 1 + modulo(parts*j + k - 4*(parts - 1) - 1, last)
                fine(:, m) = fine(:, m) + share(k)*vertex(:, j)
            end do
        end do
    end function refined_ring

    !> The shares of a vertex in those of the finer ring.
    pure function shares_of(parts) result(share)
        integer, intent(in) :: parts    !! 1 or more
        real(dp) :: share(0:4*(parts - 1)), sum_of(0:4*(parts - 1))
        integer :: factor, k

        share = 0.0_dp
        share(0) = 1.0_dp/real(parts, dp)**3
        do factor = 1, 4
            sum_of = 0.0_dp
            do k = 0, parts - 1
                sum_of(k:) = sum_of(k:) + share(:ubound(share, 1) - k)
            end do
            share = sum_of
        end do
    end function shares_of

    !> The same curve run through backwards from the same point.
    pure function turned_ring(vertex) result(turned)
        real(dp), intent(in) :: vertex(:, :)    !! deck units, shape (dimensions, vertices)
        real(dp) :: turned(size(vertex, 1), size(vertex, 2))
        integer :: m, n
        n = size(vertex, 2)
        turned = vertex(:, [(1 + modulo(3 - m, n), m = 1, n)])
    end function turned_ring

    !> The same curve begun with another of its points.
    pure function ring_from(vertex, first) result(begun)
        real(dp), intent(in) :: vertex(:, :)    !! deck units, shape (dimensions, vertices)
        integer, intent(in) :: first            !! number of that point
        real(dp) :: begun(size(vertex, 1), size(vertex, 2))
        begun = cshift(vertex, first - 1, dim=2)
    end function ring_from

    !> How unlike two rings of as many vertices are, vertex by vertex: 0 where one is the other
    !> moved and scaled; for circles 1 less the cosine of the angle between where they begin.
    pure real(dp) function ring_unlikeness(one, other) result(unlike)
        real(dp), intent(in) :: one(:, :)       !! shape (2, vertices), not all of them one point
        real(dp), intent(in) :: other(:, :)     !! in the same shape
        unlike = 1.0_dp - sum(centred(one)*centred(other)) &
            /(norm2(centred(one))*norm2(centred(other)))
    end function ring_unlikeness

    !> Vertices about their mean.
    pure function centred(vertex) result(about)
        real(dp), intent(in) :: vertex(:, :) !! shape (2, vertices)
        real(dp) :: about(size(vertex, 1), size(vertex, 2))
        about = vertex - spread(sum(vertex, dim=2)/real(size(vertex, 2), dp), 2, size(vertex, 2))
    end function centred

    !> The centroid of the area within, deck units: by Green's theorem, with the integrals of
    !> x (x dy - y dx)/3 and y (x dy - y dx)/3 about the mean vertex, exact but for rounding.
    pure function ring_centroid(vertex) result(centroid)
        real(dp), intent(in) :: vertex(:, :)    !! deck units, shape (2, vertices); area not zero
        real(dp) :: centroid(2)
        real(dp) :: about(2, size(vertex, 2)), at(2), first(2), second(2), moment(2)
        real(dp), allocatable :: pole(:, :, :)
        integer :: i, k

        about = centred(vertex)
        allocate (pole, source=uniform_segments(about, .true.))
        moment = 0.0_dp
        do i = 1, size(pole, 3)
            do k = 1, size(node)
                call bezier_jet(pole(:, :, i), 0.5_dp*(1.0_dp + node(k)), at, first, second)
                moment = moment + 0.5_dp*weight(k)*at*cross(at, first)/3.0_dp
            end do
        end do
        centroid = sum(vertex, dim=2)/real(size(vertex, 2), dp) &
            + moment/spline_area(about, .true.)
    end function ring_centroid

end module geom_ring_spline
