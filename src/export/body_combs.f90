!> The control lines of a body with their curvature combs: a row a line, side view on the left, plan
!> view on the right, all to one scale over the same stations. Joints are marked.
module export_body_combs
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_body_comb, only: comb_type, new_comb
    use export_body_curves, only: body_range, chain_strokes
    use export_body_drawing, only: drawing_type, mark_of, stroke_type, word_side
    use export_body_sheet, only: round_steps
    use geom_chain, only: chain_joints, chain_type, chain_value
    implicit none (type, external)
    private

    public :: combs_drawing

    !> In dots: the sheet across, room for the words of a row, between columns, between rows, least
    !> height of a row, a full tooth, from tooth to tooth, around the sheet, title.
    real(dp), parameter :: across = 1400.0_dp, room = 246.0_dp, gutter = 40.0_dp, &
        between = 26.0_dp, least_row = 46.0_dp, reach = 60.0_dp, spacing = 7.0_dp, edge = 34.0_dp, &
        title = 70.0_dp
    !> Dots from line to line of words.
    real(dp), parameter :: line_height = 14.0_dp
    !> Stations marked, about.
    integer, parameter :: stations = 8

    !> One view of a line, where it stands.
    type :: panel_type
        character(:), allocatable :: title          !! its name and the view
        type(chain_type) :: chain                   !! the view
        type(stroke_type), allocatable :: line(:)   !! its arcs
        type(comb_type) :: comb                     !! its comb
        real(dp) :: low = 0.0_dp                    !! least ordinate of these, deck units
        real(dp) :: high = 0.0_dp                   !! greatest, deck units
    end type panel_type

contains

    !> The combs of a body. Views that are constant have none; there are no layers where all are.
    pure type(drawing_type) function combs_drawing(body, heading, unit) result(drawing)
        type(body_type), intent(in) :: body         !! finished
        character(*), intent(in) :: heading         !! title of the deck
        character(*), intent(in) :: unit            !! name of its unit
        type(panel_type) :: panels(2)
        real(dp) :: range(2), shift(2), top, dot
        integer :: i, k

        range = body_range([body])
        drawing%script = 'sheet'
        drawing%heading = heading
        drawing%note = ''
        drawing%view = 'Control lines and their curvature, all to one scale, in '//unit
        drawing%x_axis = ''
        drawing%y_axis = ''
        dot = (range(2) - range(1))/(0.5_dp*(across - 2.0_dp*edge - gutter) - room)
        drawing%dot = dot
        shift = [0.0_dp, 0.5_dp*(across - 2.0_dp*edge + gutter)*dot]
        top = 0.0_dp
        do i = 1, size(body%lines)
            associate (line => body%lines(i))
                panels(1) = new_panel(trim(line%name)//' side', line%has_side, line%side, &
                    range, dot)
                panels(2) = new_panel(trim(line%name)//' plan', line%has_plan, line%plan, &
                    range, dot)
            end associate
            if (.not. any([size(panels(1)%line), size(panels(2)%line)] > 0)) cycle
            do k = 1, 2
                call draw_panel(panels(k), [shift(k), top - panels(k)%high], &
                    range(1) + shift(k) - room*dot, drawing)
            end do
            top = top - max(least_row*dot, maxval(panels%high - panels%low)) - between*dot
        end do
        call draw_stations(range, shift, [0.0_dp, top], drawing)
        drawing%low = [range(1) - (room + edge)*dot, top - edge*dot]
        drawing%high = [range(2) + shift(2) + edge*dot, (edge + title)*dot]
        call drawing%write_words(heading, [drawing%low(1) + edge*dot, title*dot], &
            word_side%right, 2)
        call drawing%write_words(drawing%view, [drawing%low(1) + edge*dot, &
            title*dot - 1.8_dp*line_height*dot], word_side%right, 1)
    end function combs_drawing

    !> A view of a line with its comb; without arcs where it is not given or constant.
    pure type(panel_type) function new_panel(title, is_given, chain, range, dot) result(panel)
        character(*), intent(in) :: title       !! its name
        logical, intent(in) :: is_given         !! the line has this view
        type(chain_type), intent(in) :: chain   !! the view
        real(dp), intent(in) :: range(2)        !! stations, deck units
        real(dp), intent(in) :: dot             !! deck units a dot
        integer :: i

        panel%title = title
        allocate (panel%line(0))
        if (.not. is_given .or. chain%is_constant) return
        panel%chain = chain
        panel%line = chain_strokes(chain, range)
        panel%comb = new_comb(chain, reach*dot, spacing*dot)
        panel%low = huge(1.0_dp)
        panel%high = -huge(1.0_dp)
        do i = 1, size(panel%line)
            panel%low = min(panel%low, minval(panel%line(i)%at(2, :)))
            panel%high = max(panel%high, maxval(panel%line(i)%at(2, :)))
        end do
        do i = 1, size(panel%comb%ridge)
            panel%low = min(panel%low, minval(panel%comb%ridge(i)%at(2, :)))
            panel%high = max(panel%high, maxval(panel%comb%ridge(i)%at(2, :)))
        end do
    end function new_panel

    !> Draws a view of a line with its comb, joints and words.
    pure subroutine draw_panel(panel, shift, left, drawing)
        type(panel_type), intent(in) :: panel           !! the view
        real(dp), intent(in) :: shift(2)                !! from the deck to the sheet
        real(dp), intent(in) :: left                    !! where its words begin
        type(drawing_type), intent(inout) :: drawing    !! gets it
        real(dp), allocatable :: joints(:)
        real(dp) :: at(2), dot
        integer :: i

        if (size(panel%line) == 0) return
        do i = 1, size(panel%comb%tooth)
            call drawing%draw('tooth', shifted(panel%comb%tooth(i)%at, shift))
        end do
        do i = 1, size(panel%comb%ridge)
            call drawing%draw('ridge', shifted(panel%comb%ridge(i)%at, shift))
        end do
        do i = 1, size(panel%line)
            call drawing%draw('line', shifted(panel%line(i)%at, shift))
        end do
        allocate (joints(0))
        joints = chain_joints(panel%chain)
        do i = 1, size(joints)
            call drawing%draw('joint', shifted(reshape([joints(i), &
                chain_value(panel%chain, joints(i))], [2, 1]), shift))
        end do
        dot = drawing%dot(2)
        at = [left, panel%high + shift(2) - 0.5_dp*line_height*dot]
        call drawing%write_words(panel%title, at, word_side%right, 1)
        at(2) = at(2) - 1.2_dp*line_height*dot
        if (panel%comb%factor > 0.0_dp) then
            call drawing%write_words('teeth '//mark_of(panel%comb%factor)//' x curvature'// &
                cut_off_words(panel%comb), at, word_side%right, 0)
            at(2) = at(2) - line_height*dot
            call drawing%write_words('greatest '//figures(panel%comb%greatest)//' at STA '// &
                figures(panel%comb%greatest_at), at, word_side%right, 0)
        else
            call drawing%write_words('straight', at, word_side%right, 0)
        end if
    end subroutine draw_panel

    !> What is said of a comb whose longest teeth are not shown whole.
    pure function cut_off_words(comb) result(text)
        type(comb_type), intent(in) :: comb !! any comb
        character(:), allocatable :: text
        text = ''
        if (comb%is_cut_off) text = ', cut off'
    end function cut_off_words

    !> A number to four figures.
    pure function figures(value) result(text)
        real(dp), intent(in) :: value !! a finite number
        character(:), allocatable :: text
        character(12) :: field
        real(dp) :: rounded
        write (field, '(es12.3e3)') value
        read (field, *) rounded
        text = mark_of(rounded)
    end function figures

    !> Draws stations across both columns.
    pure subroutine draw_stations(range, shift, ends, drawing)
        real(dp), intent(in) :: range(2)                !! least and greatest, deck units
        real(dp), intent(in) :: shift(2)                !! of the columns to the right, deck units
        real(dp), intent(in) :: ends(2)                 !! top and bottom of the sheet, deck units
        type(drawing_type), intent(inout) :: drawing    !! gets them
        real(dp), allocatable :: sta(:)
        real(dp) :: x
        integer :: i, k

        allocate (sta(0))
        sta = round_steps(range(1), range(2), stations)
        do i = 1, size(sta)
            do k = 1, 2
                x = sta(i) + shift(k)
                call drawing%draw('grid', reshape([x, ends(1), x, ends(2)], [2, 2]))
                call drawing%write_words(mark_of(sta(i)), &
                    [x, ends(1) + line_height*drawing%dot(2)], word_side%middle, 0)
                call drawing%write_words(mark_of(sta(i)), &
                    [x, ends(2) - line_height*drawing%dot(2)], word_side%middle, 0)
            end do
        end do
    end subroutine draw_stations

    !> Points moved, by columns.
    pure function shifted(at, shift)
        real(dp), intent(in) :: at(:, :)    !! points
        real(dp), intent(in) :: shift(2)    !! how far
        real(dp) :: shifted(2, size(at, 2))
        shifted(1, :) = at(1, :) + shift(1)
        shifted(2, :) = at(2, :) + shift(2)
    end function shifted

end module export_body_combs
