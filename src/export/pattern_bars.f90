!> The bars by which a print is checked: one in inches and one in centimetres, as long as there is
!> room for. A print at any other size than full size shows at once.
module export_pattern_bars
    use base_kinds, only: dp
    use base_text, only: to_text
    use export_pattern_number, only: inches
    use export_pattern_page, only: label_type, page_type, side
    use export_pattern_style, only: style
    implicit none (type, external)
    private

    public :: draw_bars, bars_height

    !> Lengths that bars may have, inches and centimetres.
    integer, parameter :: in_lengths(6) = [10, 5, 4, 3, 2, 1], &
        cm_lengths(7) = [25, 20, 15, 10, 5, 3, 2]
    !> Inches of a centimetre.
    real(dp), parameter :: centimetre = 1.0_dp/2.54_dp
    !> Ticks at the ends and between, the height of the words and their distance from the bar, and
    !> how far the second bar is below the first: in.
    real(dp), parameter :: end_tick = 0.09_dp, tick = 0.05_dp, height = 0.1_dp, gap = 0.04_dp, &
        apart = 0.4_dp
    !> How high both are with their words, in.
    real(dp), parameter :: bars_height = apart + height + gap + 2.0_dp*end_tick

contains

    !> Draws both bars; the corner is the lower left one of the room for them.
    pure subroutine draw_bars(page, corner, width)
        type(page_type), intent(inout) :: page      !! gets them
        real(dp), intent(in) :: corner(2)           !! of the room, in
        real(dp), intent(in) :: width               !! of the room, in; 1 or more
        integer :: number

        number = longest(in_lengths, 1.0_dp, width)
        call draw_bar(page, corner + [0.0_dp, apart + end_tick], number, 1.0_dp, &
            'MEASURE THIS: '//inches(real(number, dp))//' in')
        number = longest(cm_lengths, centimetre, width)
        call draw_bar(page, corner + [0.0_dp, end_tick], number, centimetre, &
            'MEASURE THIS: '//to_text(number)//'.00 cm')
    end subroutine draw_bars

    !> The longest length that there is room for, at least the shortest.
    pure integer function longest(lengths, unit, width) result(length)
        integer, intent(in) :: lengths(:)   !! falling
        real(dp), intent(in) :: unit        !! of the lengths, in
        real(dp), intent(in) :: width       !! of the room, in
        integer :: i

        do i = 1, size(lengths)
            length = lengths(i)
            if (unit*real(length, dp) <= width) return
        end do
    end function longest

    !> Draws a bar with a tick at each unit; it is as long as from the middle of its first tick to
    !> that of its last.
    pure subroutine draw_bar(page, start, number, unit, words)
        type(page_type), intent(inout) :: page      !! gets it
        real(dp), intent(in) :: start(2)            !! its left end, in
        integer, intent(in) :: number               !! of units
        real(dp), intent(in) :: unit                !! in
        character(*), intent(in) :: words           !! above it
        type(label_type) :: label
        real(dp) :: at(2), reach
        integer :: i

        at = start + [unit*real(number, dp), 0.0_dp]
        call page%draw(style%bar, reshape([start, at], [2, 2]))
        do i = 0, number
            at = start + [unit*real(i, dp), 0.0_dp]
            reach = merge(end_tick, tick, i == 0 .or. i == number)
            call page%draw(style%bar, reshape([at - [0.0_dp, reach], at + [0.0_dp, reach]], [2, 2]))
        end do
        label%text = words
        label%height = height
        label%side = side%right
        call page%write(style%sheet_words, start + [2.0_dp*gap, end_tick + gap], label)
    end subroutine draw_bar

end module export_pattern_bars
