!> Tests of check bars: ten inches are 10, twenty-five centimetres 9.8425.
program test_pattern_bars
    use base_kinds, only: dp
    use export_pattern_bars, only: bars_height, draw_bars
    use export_pattern_page, only: bounds_of, item_kind, page_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call try(12.0_dp, 10.0_dp, 25.0_dp, 'MEASURE THIS: 10.000 in', 'MEASURE THIS: 25.00 cm')
    call try(9.9_dp, 5.0_dp, 25.0_dp, 'MEASURE THIS: 5.000 in', 'MEASURE THIS: 25.00 cm')
    call try(4.2_dp, 4.0_dp, 10.0_dp, 'MEASURE THIS: 4.000 in', 'MEASURE THIS: 10.00 cm')
    call try(1.0_dp, 1.0_dp, 2.0_dp, 'MEASURE THIS: 1.000 in', 'MEASURE THIS: 2.00 cm')
    call tap%finish()

contains

    !> Draws bars in a room, and measures them from end to end.
    subroutine try(width, inches, centimetres, first, second)
        real(dp), intent(in) :: width           !! of the room, in
        real(dp), intent(in) :: inches          !! length of the first
        real(dp), intent(in) :: centimetres     !! length of the second
        character(*), intent(in) :: first       !! what it says
        character(*), intent(in) :: second      !! what the other says
        type(page_type) :: page
        real(dp) :: box(4), lengths(2)
        character(:), allocatable :: words
        integer :: i, bars

        call draw_bars(page, [3.0_dp, 5.0_dp], width)
        words = ''
        bars = 0
        do i = 1, page%count
            associate (item => page%items(i))
                if (item%kind == item_kind%words) then
                    words = words//item%label%text//'|'
                else if (abs(item%at(2, 1) - item%at(2, 2)) < 1.0e-12_dp) then
                    bars = bars + 1
                    lengths(bars) = norm2(item%at(:, 2) - item%at(:, 1))
                end if
            end associate
        end do
        call tap%near(lengths(1), inches, 1.0e-12_dp, 'the first bar is as long as it says')
        call tap%near(2.54_dp*lengths(2), centimetres, 1.0e-12_dp, 'so is the second')
        call tap%same(words, first//'|'//second//'|', 'and they say so')
        call tap%ok(page%count == nint(inches) + nint(centimetres) + 2 + 4, 'a tick for each unit')
        box = bounds_of(page)
        call tap%ok(box(1) >= 3.0_dp .and. box(2) >= 5.0_dp - 1.0e-12_dp .and. &
            box(3) <= 3.0_dp + max(width, 2.0_dp) .and. box(4) <= 5.0_dp + bars_height, &
            'all of it in its room')
    end subroutine try

end program test_pattern_bars
