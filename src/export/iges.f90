!> An IGES file, version 5.3, of a drawing and a skin: cuts and control lines as rational B-splines
!> in space, or as conics and lines where that is asked for, and the skin as B-spline surfaces.
!>
!> Each cut has a level of its own, the control lines have one, and so has the skin; property 406
!> says what a level is for. Cuts are whole, also where the deck gives their half.
!>
!> Source: "Initial Graphics Exchange Specification, IGES 5.3", U.S. Product Data Association, 1996.
module export_iges
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: right, to_text
    use export_drawing, only: drawing_type, shape_type
    use export_drawn, only: draw_shapes
    use export_iges_card, only: section_type
    use export_iges_file, only: iges_file_type
    use export_iges_head, only: put_global, put_start, resolution_of
    use export_iges_shape, only: add_level, add_shape
    use export_iges_skin, only: add_skin, has_skin
    use export_receipt, only: receipt_type
    use export_settings, only: settings_type
    use export_shell, only: skin_model_type
    use export_units, only: find_unit, unit_type
    implicit none (type, external)
    private

    public :: write_iges

contains

    !> Writes an IGES file.
    !>
    !> Fails with `cause%usage` where the drawing has an unknown unit, with `cause%no_arc` where
    !> there is neither a curve nor a face to write.
    subroutine write_iges(drawing, model, settings, out, receipt, error)
        type(drawing_type), intent(in) :: drawing           !! cuts and lines, may have none
        type(skin_model_type), intent(in) :: model          !! skin, in the same unit; may be empty
        type(settings_type), intent(in) :: settings         !! conics or splines, tolerance
        type(output_type), intent(inout) :: out             !! where to
        type(receipt_type), intent(inout) :: receipt        !! gets curves and faces
        type(error_type), allocatable, intent(out) :: error !! see above
        type(iges_file_type) :: file
        type(section_type) :: start, global
        type(unit_type) :: unit
        character(:), allocatable :: levels

        call find_unit(drawing%units, unit, error)
        if (allocated(error)) return
        call add_all(file, drawing, model, settings%has_conics, levels, receipt)
        if (file%directory%count == 0) then
            call fail(error, cause%no_arc, 'there is nothing to export: no skin, no cut, no line')
            return
        end if
        start = section_type('S')
        global = section_type('G')
        call put_start(start, drawing, levels)
        call put_global(global, drawing, unit, largest_of(drawing, model), &
            resolution_of(unit, settings%tolerance))
        call out%put(start%text())
        call out%put(global%text())
        call out%put(file%directory%text())
        call out%put(file%parameters%text())
        call put_end(out, [start%count, global%count, file%directory%count, file%parameters%count])
    end subroutine write_iges

    !> Adds all there is, and says what is on which level.
    subroutine add_all(file, drawing, model, has_conics, levels, receipt)
        type(iges_file_type), intent(inout) :: file             !! gets it
        type(drawing_type), intent(in) :: drawing               !! cuts and lines
        type(skin_model_type), intent(in) :: model              !! skin
        logical, intent(in) :: has_conics                       !! conics and lines as such
        character(:), allocatable, intent(out) :: levels        !! a line for each, with its end
        type(receipt_type), intent(inout) :: receipt            !! gets curves and faces
        type(shape_type), allocatable :: cuts(:)
        integer :: level, i

        level = 0
        levels = ''
        if (allocated(drawing%cuts)) then
            call draw_shapes(drawing, .false., .false., cuts)
            do i = 1, size(cuts)
                call open_level(cuts(i)%name//': '//cuts(i)%title)
                call add_shape(file, cuts(i), level, has_conics, receipt)
            end do
        end if
        if (has_lines(drawing)) then
            call open_level('CONTROL LINES')
            do i = 1, size(drawing%lines)
                call add_shape(file, drawing%lines(i), level, has_conics, receipt)
            end do
        end if
        if (has_skin(model)) then
            call open_level('SKIN')
            call add_skin(file, model, level, receipt)
        end if
    contains
        !> Begins the next level.
        subroutine open_level(words)
            character(*), intent(in) :: words !! what is on it
            level = level + 1
            levels = levels//'Level '//to_text(level)//': '//words//new_line('a')
            call add_level(file, level, words)
        end subroutine open_level
    end subroutine add_all

    !> True for a drawing with control lines.
    pure logical function has_lines(drawing)
        type(drawing_type), intent(in) :: drawing   !! any drawing
        has_lines = .false.
        if (allocated(drawing%lines)) has_lines = size(drawing%lines) > 0
    end function has_lines

    !> The largest magnitude of a coordinate; of curves and surfaces that of their poles, which they
    !> are within.
    pure real(dp) function largest_of(drawing, model) result(largest)
        type(drawing_type), intent(in) :: drawing       !! cuts and lines
        type(skin_model_type), intent(in) :: model      !! skin
        integer :: i

        largest = 0.0_dp
        if (allocated(drawing%cuts)) largest = largest_in(drawing%cuts)
        if (allocated(drawing%lines)) largest = max(largest, largest_in(drawing%lines))
        if (.not. has_skin(model)) return
        do i = 1, size(model%faces)
            if (model%faces(i)%is_flat) cycle
            largest = max(largest, maxval(abs(model%faces(i)%surface%pole)))
        end do
    end function largest_of

    !> The largest magnitude of a coordinate of shapes.
    pure real(dp) function largest_in(shapes) result(largest)
        type(shape_type), intent(in) :: shapes(:)   !! cuts or lines
        integer :: i, j, k

        largest = 0.0_dp
        do i = 1, size(shapes)
            do j = 1, size(shapes(i)%contours)
                associate (contour => shapes(i)%contours(j))
                    largest = max(largest, maxval(abs(contour%at)))
                    do k = 1, size(contour%curves)
                        largest = max(largest, maxval(abs(contour%curves(k)%spline%pole)))
                    end do
                end associate
            end do
        end do
    end function largest_in

    !> Puts the last card: how many cards each section has (2.2.4.6).
    subroutine put_end(out, counts)
        type(output_type), intent(inout) :: out     !! where to
        integer, intent(in) :: counts(4)            !! of S, G, D and P
        character, parameter :: letters(4) = ['S', 'G', 'D', 'P']
        type(section_type) :: section
        character(32) :: data
        integer :: i

        do i = 1, 4
            data(8*i - 7:8*i) = letters(i)//right(to_text(counts(i)), 7)
        end do
        section = section_type('T')
        call section%put_card(data)
        call out%put(section%text())
    end subroutine put_end

end module export_iges
