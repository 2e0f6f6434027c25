!> Cubic C-Bezier curves: four poles with a basis of 1, t, sin t and cos t over 0 to alpha in place
!> of the powers of t. Towards alpha = 0 they are Bezier cubics; larger ones hold arcs of circles
!> exactly, and lead from a line to a circle with a curvature that only grows.
!>
!> With S = sin alpha, C = cos alpha, K = (alpha - S)/(1 - C), M = S/(alpha - 2 K), u = alpha - t:
!>
!>     Z0 = (u - sin u)/(alpha - S)                  Z3 = (t - sin t)/(alpha - S)
!>     Z1 = M ((1 - cos u)/(1 - C) - Z0)             Z2 = M ((1 - cos t)/(1 - C) - Z3)
!>
!> They are not negative and sum to 1. The differences lose no figures for small angles: series and
!> half angles are used. A place s on a curve goes from 0 to 1, t = alpha s.
!>
!> Source: J. Zhang, "C-curves: an extension of cubic curves", Computer Aided Geometric Design 13
!> (1996), pp. 199-217; named in the contents of seed 001, chapter 4.
module geom_cyclic
    use base_constants, only: pi
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: cyclic_point, cyclic_jet, cyclic_part, start_ratio, middle_ratio

    !> Angles below which differences are worked by their series, radians, and its terms.
    real(dp), parameter :: small = 1.0_dp
    integer, parameter :: terms = 12
    !> This near to pi M is worked by its series there, radians: the quotient loses its figures.
    real(dp), parameter :: next_to_pi = 1.0e-4_dp

contains

    !> The point of a curve.
    pure function cyclic_point(pole, alpha, s) result(point)
        real(dp), intent(in) :: pole(:, :)  !! four poles: (dimensions, 4)
        real(dp), intent(in) :: alpha       !! radians, above 0, not above pi
        real(dp), intent(in) :: s           !! 0 to 1
        real(dp) :: point(size(pole, 1))
        point = blended(pole, values(alpha, s))
    end function cyclic_point

    !> The sum of vectors times factors, in order: the same figures however it is compiled.
    pure function blended(vector, factor) result(sum)
        real(dp), intent(in) :: vector(:, :)    !! shape (dimensions, vectors)
        real(dp), intent(in) :: factor(:)       !! shape (vectors)
        real(dp) :: sum(size(vector, 1))
        integer :: i
        sum = factor(1)*vector(:, 1)
        do i = 2, size(factor)
            sum = sum + factor(i)*vector(:, i)
        end do
    end function blended

    !> The point of a curve and its first two derivatives over s.
    pure subroutine cyclic_jet(pole, alpha, s, point, first, second)
        real(dp), intent(in) :: pole(:, :)      !! four poles: (dimensions, 4)
        real(dp), intent(in) :: alpha           !! radians, above 0, not above pi
        real(dp), intent(in) :: s               !! 0 to 1
        real(dp), intent(out) :: point(:)       !! shape (dimensions)
        real(dp), intent(out) :: first(:)       !! d/ds
        real(dp), intent(out) :: second(:)      !! d2/ds2
        real(dp) :: slope(4), bend(4), t, u, whole, level, m, side(size(pole, 1), 3)

        t = alpha*s
        u = alpha*(1.0_dp - s)
        whole = angle_less_sine(alpha)
        level = one_less_cosine(alpha)
        m = middle_ratio(alpha)
        slope(1) = -one_less_cosine(u)/whole
        slope(4) = one_less_cosine(t)/whole
        slope(2) = m*(-sin(u)/level - slope(1))
        slope(3) = m*(sin(t)/level - slope(4))
        bend(1) = sin(u)/whole
        bend(4) = sin(t)/whole
        bend(2) = m*(cos(u)/level - bend(1))
        bend(3) = m*(cos(t)/level - bend(4))
        point = cyclic_point(pole, alpha, s)
        ! The sums are zero: by sides of the polygon nothing cancels.
        side = pole(:, 2:) - pole(:, :3)
        first = alpha*blended(side, [-slope(1), slope(3) + slope(4), slope(4)])
        second = alpha**2*blended(side, [-bend(1), bend(3) + bend(4), bend(4)])
    end subroutine cyclic_jet

    !> The four functions at a place.
    pure function values(alpha, s) result(z)
        real(dp), intent(in) :: alpha   !! radians
        real(dp), intent(in) :: s       !! 0 to 1
        real(dp) :: z(4)
        real(dp) :: t, u, whole, level, m

        t = alpha*s
        u = alpha*(1.0_dp - s)
        whole = angle_less_sine(alpha)
        level = one_less_cosine(alpha)
        m = middle_ratio(alpha)
        z(1) = angle_less_sine(u)/whole
        z(4) = angle_less_sine(t)/whole
        z(2) = m*(one_less_cosine(u)/level - z(1))
        z(3) = m*(one_less_cosine(t)/level - z(4))
    end function values

    !> K = (alpha - sin alpha)/(1 - cos alpha): at the ends dr/dt is a side of the polygon over K.
    elemental real(dp) function start_ratio(alpha) result(k)
        real(dp), intent(in) :: alpha !! radians, above 0, not above pi
        k = angle_less_sine(alpha)/one_less_cosine(alpha)
    end function start_ratio

    !> M = sin alpha/(alpha - 2 K): 3 towards 0, 1 at pi.
    elemental real(dp) function middle_ratio(alpha) result(m)
        real(dp), intent(in) :: alpha !! radians, above 0, not above pi
        real(dp) :: term, rest
        integer :: i

        if (alpha >= small) then
            m = sin(alpha)*one_less_cosine(alpha) &
                /(2.0_dp*sin(alpha) - alpha*(1.0_dp + cos(alpha)))
            if (pi - alpha < next_to_pi) m = 1.0_dp + (pi - alpha)**2/12.0_dp
            return
        end if
        ! 2 sin a - a (1 + cos a) is the sum of (2 k - 1) a**(2 k + 1)/(2 k + 1)!, signs in turn.
        term = alpha**3/6.0_dp
        rest = term
        do i = 2, terms
            term = -term*alpha**2/real(2*i*(2*i + 1), dp)
            rest = rest + real(2*i - 1, dp)*term
        end do
        m = sin(alpha)*one_less_cosine(alpha)/rest
    end function middle_ratio

    !> x - sin x.
    elemental real(dp) function angle_less_sine(x) result(value)
        real(dp), intent(in) :: x !! radians, 0 to pi
        real(dp) :: term
        integer :: i

        if (x >= small) then
            value = x - sin(x)
            return
        end if
        term = x**3/6.0_dp
        value = term
        do i = 2, terms
            term = -term*x**2/real(2*i*(2*i + 1), dp)
            value = value + term
        end do
    end function angle_less_sine

    !> 1 - cos x.
    elemental real(dp) function one_less_cosine(x) result(value)
        real(dp), intent(in) :: x !! radians
        value = 2.0_dp*sin(0.5_dp*x)**2
    end function one_less_cosine

    !> The part of a curve from one place to another, which is such a curve again over its own share
    !> of alpha: the poles follow from the ends and what the curve does there.
    pure subroutine cyclic_part(pole, alpha, from, to, part, share)
        real(dp), intent(in) :: pole(:, :)      !! four poles: (dimensions, 4)
        real(dp), intent(in) :: alpha           !! radians
        real(dp), intent(in) :: from            !! 0 to 1
        real(dp), intent(in) :: to              !! 0 to 1, not `from`
        real(dp), intent(out) :: part(:, :)     !! shape of `pole`
        real(dp), intent(out) :: share          !! alpha of the part, radians
        real(dp), dimension(size(pole, 1)) :: first, second
        real(dp) :: pace

        share = alpha*abs(to - from)
        pace = start_ratio(share)*(to - from)/share
        call cyclic_jet(pole, alpha, from, part(:, 1), first, second)
        part(:, 2) = part(:, 1) + pace*first
        call cyclic_jet(pole, alpha, to, part(:, 4), first, second)
        part(:, 3) = part(:, 4) - pace*first
    end subroutine cyclic_part

end module geom_cyclic
