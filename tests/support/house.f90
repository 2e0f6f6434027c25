!> A house: two flat walls and a flat roof, all of whose corners are known.
module support_house
    use base_kinds, only: dp
    use body_body, only: body_type, finish_body
    use geom_chain, only: chain_type
    use support_bodies, only: constant_view, control_line, plain_section, straight_view, upright
    implicit none (type, external)
    private

    public :: house, ridge_inside

contains

    !> Upright walls 2 from the centre line and a roof of slope 1/2, from the eaves at WL 2 to the
    !> ridge at WL 3, at station 0; all of it rises.
    function house(rise) result(body)
        real(dp), intent(in) :: rise        !! dWL/dSTA
        type(body_type) :: body

        allocate (body%lines(0), body%sections(0))
        body%lines = [control_line('FLOOR', risen(0.0_dp, rise), constant_view(2.0_dp)), &
            control_line('WALL', risen(1.0_dp, rise), constant_view(2.0_dp)), &
            control_line('EAVES', risen(2.0_dp, rise), constant_view(2.0_dp)), &
            control_line('ROOF', risen(2.5_dp, rise), constant_view(1.0_dp)), &
            control_line('RIDGE', risen(3.0_dp, rise), constant_view(0.0_dp))]
        body%sections = [plain_section('WALL', [1, 2, 3], upright, upright), &
            plain_section('ROOF', [3, 4, 5], [-2.0_dp, 1.0_dp], [-2.0_dp, 1.0_dp])]
        call finish_body(body)
    end function house

    !> The side view of a line.
    type(chain_type) function risen(wl, rise)
        real(dp), intent(in) :: wl          !! at station 0
        real(dp), intent(in) :: rise        !! dWL/dSTA
        risen = straight_view([0.0_dp, wl], [10.0_dp, wl + 10.0_dp*rise])
    end function risen

    !> WL of the ridge of the inside: the roof is the plane BL/2 + WL = 3 + rise STA.
    pure real(dp) function ridge_inside(rise, sta, skin) result(wl)
        real(dp), intent(in) :: rise        !! dWL/dSTA
        real(dp), intent(in) :: sta         !! station
        real(dp), intent(in) :: skin        !! thickness
        wl = 3.0_dp + rise*sta - skin*sqrt(1.25_dp + rise**2)
    end function ridge_inside

end module support_house
