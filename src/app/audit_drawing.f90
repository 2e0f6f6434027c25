!> The picture of an audited table: what each figure is off, in units of its last place, along the
!> line; the band of what printing alone explains; suspects by name.
module app_audit_drawing
    use audit_cross, only: table_title
    use audit_figure, only: scale_type, unit_of
    use audit_finding, only: finding_type
    use audit_item, only: item_type
    use audit_printing, only: allowed, printing_name
    use audit_reading, only: meaning, sort
    use audit_words, only: corrected, is_doubtful
    use base_kinds, only: dp, i64
    use export_body_drawing, only: drawing_type, word_side
    implicit none (type, external)
    private

    public :: residual_drawing

    !> Dots of the box between the axes, and room beside the first and the last row, in parts.
    real(dp), parameter :: box(2) = [760.0_dp, 400.0_dp], margin = 0.08_dp
    !> Units of the last place that are shown; what is further off stands at the edge.
    real(dp), parameter :: shown = 5.0_dp, edge = 4.4_dp
    !> Dots from a mark to its words, and between lines of words that would meet.
    real(dp), parameter :: beside = 10.0_dp, line_height = 15.0_dp
    integer, parameter :: most_lines = 6

contains

    !> The picture of the rows of a table along X or along Y; without layers where it has none.
    pure type(drawing_type) function residual_drawing(item, sorts, heading, unit) result(drawing)
        type(item_type), intent(in) :: item     !! a table that was audited
        integer, intent(in) :: sorts            !! `sort%ordinate` or `sort%abscissa`
        character(*), intent(in) :: heading     !! title of the deck
        character(*), intent(in) :: unit        !! name of its unit
        real(dp) :: reach(2)
        integer :: i

        drawing%script = 'chart'
        drawing%heading = heading
        drawing%view = table_title(item)//': figures less the line found'
        drawing%note = 'band: what printing explains ('//printing_name(item%audit%printing)// &
            '); rings: suspects [likely figure], at the edge where further off'
        drawing%x_axis = merge('X', 'Y', sorts == sort%ordinate)//', '//unit
        drawing%y_axis = 'units of the last place'
        reach = [huge(reach), -huge(reach)]
        do i = 1, size(item%entry)
            if (.not. is_shown(item, i, sorts)) cycle
            reach = [min(reach(1), item%line%reading(i)%along), &
                max(reach(2), item%line%reading(i)%along)]
        end do
        if (reach(1) > reach(2)) return
        if (.not. reach(1) < reach(2)) reach = reach + [-1.0_dp, 1.0_dp]
        drawing%low = [reach(1) - margin*(reach(2) - reach(1)), -shown]
        drawing%high = [reach(2) + margin*(reach(2) - reach(1)), shown]
        drawing%dot = (drawing%high - drawing%low)/box
        call draw_band(item, drawing)
        do i = 1, size(item%entry)
            if (is_shown(item, i, sorts)) call draw_figure(item, i, drawing)
        end do
        if (drawing%count == 0) call drawing%write_words('no figure is suspect', &
            [0.5_dp*sum(reach), edge], word_side%middle, 0)
    end function residual_drawing

    !> True for a row along X or Y that the line found has a value for, and that can be read.
    pure logical function is_shown(item, reading, sorts)
        type(item_type), intent(in) :: item     !! the table
        integer, intent(in) :: reading          !! which
        integer, intent(in) :: sorts            !! `sort%ordinate` or `sort%abscissa`
        associate (it => item%line%reading(reading))
            is_shown = it%meaning == meaning%printed .and. it%sort == sorts .and. &
                it%figure%is_sound .and. item%audit%finding(reading)%is_reached
        end associate
    end function is_shown

    !> Draws the zero line, and what a sound figure may be off.
    pure subroutine draw_band(item, drawing)
        type(item_type), intent(in) :: item             !! the table
        type(drawing_type), intent(inout) :: drawing    !! gets them
        real(dp) :: between(2), sides(2)
        integer :: k

        between = allowed(0_i64, item%audit%scale, item%audit%printing)/unit_of(item%audit%scale)
        sides = [drawing%low(1), drawing%high(1)]
        call drawing%draw('line', reshape([sides(1), 0.0_dp, sides(2), 0.0_dp], [2, 2]))
        do k = 1, 2
            call drawing%draw('mirror', reshape([sides(1), -between(k), sides(2), -between(k)], &
                [2, 2]))
        end do
    end subroutine draw_band

    !> Draws a figure, with words where it is suspect.
    pure subroutine draw_figure(item, reading, drawing)
        type(item_type), intent(in) :: item             !! the table
        integer, intent(in) :: reading                  !! which
        type(drawing_type), intent(inout) :: drawing    !! gets it
        real(dp) :: at(2)

        associate (finding => item%audit%finding(reading))
            at = [item%line%reading(reading)%along, max(-edge, min(edge, finding%residual))]
            call drawing%draw('tooth', reshape([at(1), 0.0_dp, at], [2, 2]))
            if (is_doubtful(finding)) then
                call drawing%draw('joint', reshape(at, [2, 1]))
                call name_suspect(item, reading, at, drawing)
            else
                call drawing%draw('point', reshape(at, [2, 1]))
            end if
        end associate
    end subroutine draw_figure

    !> Writes what a suspect is, towards the middle, where there is room.
    pure subroutine name_suspect(item, reading, at, drawing)
        type(item_type), intent(in) :: item             !! the table
        integer, intent(in) :: reading                  !! which
        real(dp), intent(in) :: at(2)                   !! its mark
        type(drawing_type), intent(inout) :: drawing    !! gets it
        character(:), allocatable :: text
        real(dp) :: places(2, most_lines), inward
        integer :: k, side

        associate (finding => item%audit%finding(reading))
            text = trim(item%line%reading(reading)%figure%text)//' ['//trim(corrected(finding))//']'
        end associate
        inward = -sign(1.0_dp, at(2))
        side = merge(word_side%left, word_side%right, &
            at(1) > 0.5_dp*(drawing%low(1) + drawing%high(1)))
        do k = 1, most_lines
            places(:, k) = at + drawing%dot*[real(side, dp)*beside, &
                inward*line_height*real(k - 1, dp)]
        end do
        call drawing%write_where_free(text, places, side)
    end subroutine name_suspect

end module app_audit_drawing
