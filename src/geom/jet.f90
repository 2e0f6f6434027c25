!> A curve y(x) at one x: its value and the first two derivatives.
module geom_jet
    use base_kinds, only: dp
    implicit none (type, external)
    private

    !> An ordinate and how it changes.
    type, public :: jet_type
        real(dp) :: value = 0.0_dp  !! y, deck units
        real(dp) :: first = 0.0_dp  !! dy/dx
        real(dp) :: second = 0.0_dp !! d2y/dx2, 1/deck unit
    end type jet_type

end module geom_jet
