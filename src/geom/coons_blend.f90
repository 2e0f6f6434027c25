!> The functions that blend the sides of a Coons patch: F keeps the sides, G their cross slopes, H
!> the second derivatives across them. Each has value 1 at its own end for its own derivative and 0
!> for all others and at the other end.
!>
!> Source: seed 000, "Coons patches", (3), (4), (9), (12), with F1 = 3 t**2 - 2 t**3 where (4)
!> prints 3 t - 2 t**2; the functions of fifth degree are Hermite's.
module geom_coons_blend
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: blend_jet, blend_orders

    !> How sides are blended.
    type, public :: blend_list
        integer :: linear = 1       !! the sides by straight lines
        integer :: cubic = 2        !! the sides by cubics: every corner twist is 0
        integer :: slopes = 3       !! the sides and the slopes across them
        integer :: curvatures = 4   !! the sides, slopes and second derivatives across them
    end type blend_list

    !> The blends by name.
    type(blend_list), parameter, public :: blend = blend_list()

    !> How many derivatives across a side a blend keeps, the side itself counted.
    integer, parameter :: orders(4) = [1, 1, 2, 3]

    !> The functions of the first end as coefficients of 1, t, ... t**5, in the order of the blends;
    !> of each F, G, H.
    real(dp), parameter :: first_end(0:5, 0:2, 4) = reshape([real(dp) :: &
        1, -1, 0, 0, 0, 0,    0, 0, 0, 0, 0, 0,    0, 0, 0, 0, 0, 0, &
        1, 0, -3, 2, 0, 0,    0, 0, 0, 0, 0, 0,    0, 0, 0, 0, 0, 0, &
        1, 0, -3, 2, 0, 0,    0, 1, -2, 1, 0, 0,   0, 0, 0, 0, 0, 0, &
        1, 0, 0, -10, 15, -6,    0, 1, 0, -6, 8, -3,    0, 0, 0.5_dp, -1.5_dp, 1.5_dp, -0.5_dp], &
        [6, 3, 4])

contains

    !> How many derivatives across a side a blend keeps, the side itself counted: 1, 2 or 3.
    elemental integer function blend_orders(kind)
        integer, intent(in) :: kind !! one of `blend%...`
        blend_orders = orders(kind)
    end function blend_orders

    !> The blending functions at a parameter, with two derivatives: jet(derivative, function, end),
    !> where function 0 is F, 1 is G, 2 is H. Those of the last end mirror those of the first.
    pure function blend_jet(kind, t) result(jet)
        integer, intent(in) :: kind     !! one of `blend%...`
        real(dp), intent(in) :: t       !! 0 to 1
        real(dp) :: jet(0:2, 0:2, 0:1)
        integer :: order

        do order = 0, 2
            jet(:, order, 0) = polynomial_jet(first_end(:, order, kind), t)
            jet(:, order, 1) = real((-1)**order, dp)*[1.0_dp, -1.0_dp, 1.0_dp]* &
                polynomial_jet(first_end(:, order, kind), 1.0_dp - t)
        end do
    end function blend_jet

    !> A polynomial and its first two derivatives, by Horner's scheme.
    pure function polynomial_jet(c, t) result(jet)
        real(dp), intent(in) :: c(0:)   !! coefficients of 1, t, ...
        real(dp), intent(in) :: t       !! any
        real(dp) :: jet(0:2)
        integer :: i

        jet = 0.0_dp
        do i = ubound(c, 1), 0, -1
            jet(2) = jet(2)*t + 2.0_dp*jet(1)
            jet(1) = jet(1)*t + jet(0)
            jet(0) = jet(0)*t + c(i)
        end do
    end function polynomial_jet

end module geom_coons_blend
