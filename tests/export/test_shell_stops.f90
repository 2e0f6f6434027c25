!> Tests of the stations where faces part: joints, ends, gaps, stops that are one but for rounding.
program test_shell_stops
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_gap, only: gap_type
    use export_shell_stops, only: find_gaps, sections_between, stops_of
    use support_skins, only: deck_body, text_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(gap_type), allocatable :: gaps(:)
    integer, allocatable :: owner(:), chosen(:)
    real(dp), allocatable :: stops(:)
    character, parameter :: nl = new_line('a')

    allocate (chosen(0))
    body = deck_body('fuselage')
    call find_gaps(body, gaps, owner)
    call tap%ok(size(gaps) == 0, 'the fuselage has no gap')
    allocate (stops, source=stops_of(body, gaps))
    call tap%ok(size(stops) == 6, 'it has six stops')
    if (size(stops) == 6) call tap%ok(all(stops == &
        [0.0_dp, 14.0_dp, 56.0_dp, 112.0_dp, 200.0_dp, 280.0_dp]), 'joints and ends of sections')
    chosen = sections_between(body, gaps, owner, [112.0_dp, 200.0_dp])
    call tap%ok(all(body%sections(chosen)%name == ['LOWER   ', 'UPPER   ']), &
        'forward of station 200 there are two sections')
    chosen = sections_between(body, gaps, owner, [200.0_dp, 280.0_dp])
    call tap%ok(size(chosen) == 4 .and. all(body%sections(chosen)%name /= 'UPPER   '), &
        'aft of it four')

    body%sections(1)%to = 200.0_dp
    body%sections(2)%to = 200.0_dp*(1.0_dp + epsilon(1.0_dp))
    deallocate (stops)
    allocate (stops, source=stops_of(body, gaps))
    call tap%ok(count(abs(stops - 200.0_dp) < 1.0e-9_dp) == 1, &
        'stations that are one but for rounding are one stop')
    body%sections(2)%to = 200.001_dp
    deallocate (stops)
    allocate (stops, source=stops_of(body, gaps))
    call tap%ok(count(abs(stops - 200.0_dp) < 0.01_dp) == 2, 'a thousandth is no rounding')

    body = text_body('TITLE,GAP'//nl//'LINE,UCL,SIDE,10.'//nl//'LINE,MHB,SIDE,0.'//nl// &
        'LINE,MHB,PLAN,10.'//nl//'LINE,USH,SIDE'//nl//'STRAIGHT,0.,6.,50.,10.2'//nl// &
        'LINE,USH,PLAN'//nl//'STRAIGHT,0.,8.,50.,9.5'//nl// &
        'SECTION,UPPER,UCL,USH,MHB,0.,999.999,0.,50.'//nl)
    call find_gaps(body, gaps, owner)
    call tap%ok(size(gaps) == 1, 'a shoulder that leaves the tangents makes a gap')
    if (size(gaps) == 1) then
        call tap%near(gaps(1)%from, 4.0_dp/(4.2_dp/50.0_dp) - 0.05_dp, 1.0e-6_dp, &
            'it begins where WL 10 is passed, less a thousandth of the length')
        call tap%near(gaps(1)%to, 50.0_dp, 0.0_dp, 'and goes on to the end')
        call tap%ok(size(sections_between(body, gaps, owner, [gaps(1)%from, 50.0_dp])) == 0, &
            'there is no section in it')
        call tap%ok(size(sections_between(body, gaps, owner, [0.0_dp, gaps(1)%from])) == 1, &
            'but one before it')
    end if
    body%sections = body%sections(:0)
    call tap%ok(size(stops_of(body, gaps(:0))) == 0, 'no sections, no stops')
    call tap%finish()
end program test_shell_stops
