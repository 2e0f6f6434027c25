!> Bezier curves: polynomial curves in the Bernstein basis, of any degree and in any number of
!> dimensions. A curve is the list of its poles, shape (dimensions, degree + 1); it goes from the
!> first pole to the last while its parameter goes from 0 to 1.
!>
!> Sources: seed 001 (Bernstein-Bezier curves): the original basis, de Casteljau's scheme,
!> subdivision (prop. 1.8 with its parameter corrected), elevation; seed 000, third paper
!> (Bernstein approximation).
module geom_bezier
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: bezier_point, bezier_jet, bezier_derivative, bezier_split, bezier_part
    public :: bezier_raised, bezier_sides, bezier_from_sides, bernstein

contains

    !> The point at a parameter, by de Casteljau's scheme.
    pure function bezier_point(pole, t) result(point)
        real(dp), intent(in) :: pole(:, :)  !! of one or more poles
        real(dp), intent(in) :: t           !! 0 to 1
        real(dp) :: point(size(pole, 1))
        real(dp) :: row(size(pole, 1), size(pole, 2))
        integer :: left

        row = pole
        do left = size(pole, 2) - 1, 1, -1
            row(:, :left) = (1.0_dp - t)*row(:, :left) + t*row(:, 2:left + 1)
        end do
        point = row(:, 1)
    end function bezier_point

    !> The point at a parameter and its first two derivatives, from the last rows of de Casteljau's
    !> scheme: C' = n (P1 - P0) of the row of two, C'' = n (n - 1) (P2 - 2 P1 + P0) before it.
    pure subroutine bezier_jet(pole, t, point, first, second)
        real(dp), intent(in) :: pole(:, :)      !! of one or more poles
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp), intent(out) :: point(:)       !! shape (dimensions)
        real(dp), intent(out) :: first(:)       !! dC/dt
        real(dp), intent(out) :: second(:)      !! d2C/dt2
        real(dp) :: row(size(pole, 1), size(pole, 2)), degree
        integer :: left

        row = pole
        first = 0.0_dp
        second = 0.0_dp
        degree = real(size(pole, 2) - 1, dp)
        do left = size(pole, 2) - 1, 1, -1
            if (left == 2) second = degree*(degree - 1.0_dp) &
                *((row(:, 3) - row(:, 2)) - (row(:, 2) - row(:, 1)))
            if (left == 1) first = degree*(row(:, 2) - row(:, 1))
            row(:, :left) = (1.0_dp - t)*row(:, :left) + t*row(:, 2:left + 1)
        end do
        point = row(:, 1)
    end subroutine bezier_jet

    !> The poles of the derivative: n times the differences of neighbours; of a point, zero.
    pure function bezier_derivative(pole) result(hodograph)
        real(dp), intent(in) :: pole(:, :) !! of one or more poles
        real(dp) :: hodograph(size(pole, 1), max(1, size(pole, 2) - 1))
        integer :: degree

        degree = size(pole, 2) - 1
        hodograph = 0.0_dp
        if (degree > 0) hodograph = real(degree, dp)*(pole(:, 2:) - pole(:, :degree))
    end function bezier_derivative

    !> The two parts of a curve before and after a parameter, each over 0 to 1 again: the first and
    !> the last poles of the rows of the scheme. They share the point there.
    pure subroutine bezier_split(pole, t, before, after)
        real(dp), intent(in) :: pole(:, :)      !! of one or more poles
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp), intent(out) :: before(:, :)   !! shape of `pole`
        real(dp), intent(out) :: after(:, :)    !! shape of `pole`
        real(dp) :: row(size(pole, 1), size(pole, 2))
        integer :: left, last

        last = size(pole, 2)
        row = pole
        before(:, 1) = row(:, 1)
        after(:, last) = row(:, last)
        do left = last - 1, 1, -1
            row(:, :left) = (1.0_dp - t)*row(:, :left) + t*row(:, 2:left + 1)
            before(:, last - left + 1) = row(:, 1)
            after(:, left) = row(:, left)
        end do
    end subroutine bezier_split

    !> The part of a curve between two parameters, run through from the first to the second.
    pure function bezier_part(pole, from, to) result(part)
        real(dp), intent(in) :: pole(:, :)  !! of one or more poles
        real(dp), intent(in) :: from        !! 0 to 1
        real(dp), intent(in) :: to          !! 0 to 1
        real(dp) :: part(size(pole, 1), size(pole, 2))
        integer :: k

        do k = 1, size(pole, 2)
            part(:, k) = blossom(pole, from, to, k - 1)
        end do
    end function bezier_part

    !> The polar form of a curve: de Casteljau's scheme with one parameter in its first steps and
    !> another in the rest. These are the poles of the part between the two.
    pure function blossom(pole, from, to, count) result(point)
        real(dp), intent(in) :: pole(:, :)  !! of one or more poles
        real(dp), intent(in) :: from        !! the parameter of the other steps
        real(dp), intent(in) :: to          !! the parameter of the first steps
        integer, intent(in) :: count        !! how many those are
        real(dp) :: point(size(pole, 1))
        real(dp) :: row(size(pole, 1), size(pole, 2)), t
        integer :: left, last

        row = pole
        last = size(pole, 2) - 1
        do left = last, 1, -1
            t = merge(to, from, last - left < count)
            row(:, :left) = (1.0_dp - t)*row(:, :left) + t*row(:, 2:left + 1)
        end do
        point = row(:, 1)
    end function blossom

    !> The same curve with a degree more.
    pure function bezier_raised(pole) result(raised)
        real(dp), intent(in) :: pole(:, :) !! of one or more poles
        real(dp) :: raised(size(pole, 1), size(pole, 2) + 1)
        real(dp) :: share
        integer :: i, count

        count = size(pole, 2)
        raised(:, 1) = pole(:, 1)
        raised(:, count + 1) = pole(:, count)
        do i = 2, count
            share = real(i - 1, dp)/real(count, dp)
            raised(:, i) = share*pole(:, i - 1) + (1.0_dp - share)*pole(:, i)
        end do
    end function bezier_raised

    !> The form in which P. Bezier first wrote his curves: the first pole and the sides of the
    !> polygon, each the way from one pole to the next.
    pure function bezier_sides(pole) result(side)
        real(dp), intent(in) :: pole(:, :) !! of one or more poles
        real(dp) :: side(size(pole, 1), size(pole, 2))
        side(:, 1) = pole(:, 1)
        side(:, 2:) = pole(:, 2:) - pole(:, :size(pole, 2) - 1)
    end function bezier_sides

    !> The poles of a curve from its first pole and the sides of its polygon.
    pure function bezier_from_sides(side) result(pole)
        real(dp), intent(in) :: side(:, :) !! as `bezier_sides` gives them
        real(dp) :: pole(size(side, 1), size(side, 2))
        integer :: i
        pole(:, 1) = side(:, 1)
        do i = 2, size(side, 2)
            pole(:, i) = pole(:, i - 1) + side(:, i)
        end do
    end function bezier_from_sides

    !> The Bernstein polynomial B(i, n) = C(n, i) t**i (1 - t)**(n - i).
    elemental real(dp) function bernstein(degree, i, t) result(value)
        integer, intent(in) :: degree   !! n, 0 or more
        integer, intent(in) :: i        !! 0 to n
        real(dp), intent(in) :: t       !! 0 to 1
        integer :: k

        value = t**i*(1.0_dp - t)**(degree - i)
        do k = 1, min(i, degree - i)
            value = value*real(degree + 1 - k, dp)/real(k, dp)
        end do
    end function bernstein

end module geom_bezier
