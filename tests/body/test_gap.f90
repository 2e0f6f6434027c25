!> Where a section has no arc: a shoulder line that crosses an end tangent at a known station.
program test_gap
    use base_kinds, only: dp
    use body_body, only: body_type, finish_body
    use body_gap, only: gap_type, section_gaps, section_turns
    use support_bodies, only: constant_view, control_line, ellipsoid, level, plain_section, &
        straight_view, upright
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(gap_type), allocatable :: gaps(:)

    allocate (gaps(0))
    body = ellipsoid([5.0_dp, 2.0_dp, 1.0_dp], 0.0_dp, 0.0_dp)
    gaps = section_gaps(body, body%sections(1))
    call tap%ok(size(gaps) == 0, 'an ellipsoid has no gap, its ends are points')
    body = sliding(straight_view([0.0_dp, 0.5_dp], [10.0_dp, -0.5_dp]))
    gaps = section_gaps(body, body%sections(1))
    call tap%ok(size(gaps) == 1, 'a shoulder line that goes below the keel makes a gap')
    call tap%near(gaps(1)%from, 5.0_dp, 1.0e-14_dp, 'from where it does')
    call tap%near(gaps(1)%to, 10.0_dp, 0.0_dp, 'to the end')
    call tap%ok(index(gaps(1)%reason, 'shoulder point') > 0, 'which says why')
    body = sliding(straight_view([0.0_dp, -1.0_dp], [10.0_dp, 1.0_dp]))
    gaps = section_gaps(body, body%sections(1))
    call tap%near(gaps(1)%from, 0.0_dp, 0.0_dp, 'a gap at the beginning begins there')
    call tap%near(gaps(1)%to, 5.0_dp, 1.0e-14_dp, 'and ends where the arc begins')
    gaps = section_turns(body, body%sections(1))
    call tap%ok(size(gaps) == 0, 'no section turns back as long as its shoulder is outside')
    body = sliding(straight_view([0.0_dp, 2.0_dp], [10.0_dp, 4.0_dp]))
    gaps = section_turns(body, body%sections(1))
    call tap%ok(size(gaps) == 1, 'a shoulder line that goes through the chord makes a stretch')
    call tap%near(gaps(1)%from, 5.0_dp, 1.0e-12_dp, 'from where it does')
    call tap%near(gaps(1)%to, 10.0_dp, 0.0_dp, 'to the end, on which the section goes round')
    body = sliding(straight_view([0.0_dp, 4.0_dp], [10.0_dp, 2.0_dp]))
    gaps = section_turns(body, body%sections(1))
    call tap%near(gaps(1)%from, 0.0_dp, 0.0_dp, 'a stretch at the beginning begins there')
    call tap%near(gaps(1)%to, 5.0_dp, 1.0e-12_dp, 'and ends on the chord')
    call tap%finish()

contains

    !> A quarter whose shoulder line has a side view of its own; its keel is at WL 0.
    function sliding(side) result(body)
        use geom_chain, only: chain_type
        type(chain_type), intent(in) :: side
        type(body_type) :: body
        allocate (body%lines(0), body%sections(0))
        body%lines = [control_line('KEEL', constant_view(0.0_dp), constant_view(0.0_dp)), &
            control_line('SHO', side, constant_view(3.0_dp)), &
            control_line('SIDE', constant_view(4.0_dp), constant_view(4.0_dp))]
        body%sections = [plain_section('S', [1, 2, 3], level, upright)]
        call finish_body(body)
    end function sliding

end program test_gap
