!> The inlet duct that seed 002 fairs: 15 points of a cross-section, the last being the first.
module support_inlet
    use base_kinds, only: dp
    implicit none (type, external)
    private

    real(dp), parameter, public :: inlet(2, 15) = reshape([0.5_dp, 0.0_dp, 0.55_dp, 0.3_dp, &
        0.48_dp, 0.6_dp, 0.35_dp, 0.8_dp, 0.0_dp, 0.95_dp, -0.35_dp, 0.8_dp, -0.48_dp, 0.6_dp, &
        -0.55_dp, 0.3_dp, -0.5_dp, 0.0_dp, -0.4_dp, -0.2_dp, -0.2_dp, -0.4_dp, 0.0_dp, -0.45_dp, &
        0.2_dp, -0.4_dp, 0.4_dp, -0.2_dp, 0.5_dp, 0.0_dp], [2, 15])

end module support_inlet
