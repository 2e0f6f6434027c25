!> From PATCH cards to panels: a quarter of an ellipsoid's nose, and what can't be built.
program test_build_panels
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_build, only: build_body
    use body_build_panels, only: build_panels
    use body_ledger, only: joint_type
    use body_panel, only: panel_type
    use body_trace, only: trace_type
    use deck_job, only: job_type
    use geom_bspline_surface, only: surface_point
    use support_faults, only: said
    use support_job_deck, only: job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    character(*), parameter :: lines = 'LINE,UCL,SIDE|0,0,999.999,2.,6.,10,10,0|'// &
        'LINE,MHB,SIDE,0|LINE,MHB,PLAN|0,0,999.999,2.,6.,10,10,0|'// &
        'LINE,USH,SIDE|0,0,999.999,2.,4.8,10,8,0|'// &
        'LINE,USH,PLAN|0,0,999.999,2.,3.6,10,6,0|SECTION,UP,UCL,USH,MHB,0,999.999|STATION,1|'
    type(tap_type) :: tap
    type(panel_type), allocatable :: panels(:)
    type(fault_list_type) :: faults
    real(dp) :: point(3), off
    integer :: i

    call build('PATCH,CAP,POINT,UCL,10.,MHB')
    call tap%same(said(faults), '', 'a nose cap is built')
    call tap%ok(size(panels) == 1, 'one panel')
    if (size(panels) == 1) then
        call tap%ok(panels(1)%point == 1, 'its first side is a point')
        off = 0.0_dp
        do i = 0, 10
            associate (t => real(i, dp)/10.0_dp)
                off = max(off, norm2(surface_point(panels(1)%surface, t, 0.0_dp)))
                point = surface_point(panels(1)%surface, t, 1.0_dp)
                off = max(off, abs(point(1) - 10.0_dp), abs(norm2(point(2:)) - 10.0_dp))
                point = surface_point(panels(1)%surface, 1.0_dp, t)
                off = max(off, abs(point(2)), &
                    abs((10.0_dp - point(1))**2 + point(3)**2 - 100.0_dp))
            end associate
        end do
        call tap%near(off, 0.0_dp, 1.0e-6_dp, 'its sides are the nose, the circle and the line')
    end if
    call wrong('PATCH,CAP,POINT,UCL,12.,MHB', 'station 12. is beyond line UCL', &
        'a station beyond a line')
    call wrong('LINE,FAR,SIDE|STRAIGHT,0,20,10,20|PATCH,P,FAR,POINT,UCL,5.', &
        'lines FAR and UCL do not meet from station 0. to 10.: the gap is 10.', &
        'lines that do not meet')
    call wrong('LINE,FAR,SIDE|STRAIGHT,0,0,10,10|PATCH,P,FAR,POINT,UCL,5.', &
        'lines FAR and UCL meet at stations 0., 10.; say in FROM and TO', &
        'lines that meet twice')
    call wrong('LINE,FAR,SIDE|STRAIGHT,0,0,10,10|PATCH,P,FAR,POINT,UCL,5.,,0.,4.', &
        'no section goes from line UCL to FAR at station 5.', 'no arc between two lines')
    call tap%finish()

contains

    !> Builds the panels of the lines with some cards.
    subroutine build(cards)
        character(*), intent(in) :: cards !! a | ends each but the last
        type(job_type) :: job
        type(body_type) :: body
        type(joint_type), allocatable :: joints(:)
        call job_of(lines//cards, job, faults)
        call build_body(job, 1, body, joints, faults)
        call build_panels(job, 1, body, [trace_type ::], panels, faults)
    end subroutine build

    !> What is said of cards.
    subroutine wrong(cards, words, name)
        character(*), intent(in) :: cards   !! as `build`
        character(*), intent(in) :: words   !! in what is said
        character(*), intent(in) :: name    !! of the check
        call build(cards)
        call tap%has(said(faults), words, name)
        call tap%ok(size(panels) == 0, name//' make no panel')
    end subroutine wrong

end program test_build_panels
