!> Cuts as an NC program: straight pieces, or circular arcs where a shape asks for them, in G-code,
!> in the words that LinuxCNC, Fanuc and Grbl have in common. X and Y are u and v of the cut: the
!> loft's own ordinates, so that a point of the program can be looked up in a table of offsets.
!>
!>     %                               (senders for Grbl leave it out)
!>     (CUT 1 STATION 20, 2 PIECES)
!>     G20                             inches; G21 millimetres
!>     G17 G90 G94 G40 G49 G80         XY plane, absolute, feed a minute, nothing compensated
!>     G0 Z0.5000                      above everything
!>     G0 X0.0000 Y12.5000
!>     G1 Z-0.2500 F15.0
!>     G1 X0.3137 Y12.4961 F30.0
!>     ...
!>     M30
!>
!> The centre of the tool follows the outline. Several cuts stand one after another at their common
!> origin, with a program stop (M0) between them for the next piece of stock. Of a cut the insides
!> of the skin come first: while they are cut, the piece still hangs in its stock.
!>
!> Arcs are G2 (clockwise) and G3 in the plane of G17; I and J lead from the start of an arc to its
!> centre, as all of these controls take it unless they are told otherwise. Where one was, G91.1
!> sets it right; Fanuc does not know that word, so the program has it not.
module export_nc
    use base_constants, only: version
    use base_digits, only: shortest
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_finite
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use base_text, only: compact, counted, to_text
    use export_arcs, only: decimals_of_arcs
    use export_axis, only: axis_names
    use export_chords, only: decimals_for
    use export_drawing, only: contour_type, drawing_type, shape_type
    use export_drawn, only: check_shapes, check_tolerance, draw_shapes
    use export_nc_follow, only: follow_arcs, follow_chords
    use export_nc_path, only: farthest, path_type, put_path, read_figures, run_type
    use export_nc_word, only: comment, word
    use export_receipt, only: entity_type, receipt_type
    use export_settings, only: settings_type
    use export_units, only: find_unit, unit_type
    implicit none (type, external)
    private

    public :: write_nc

    !> Decimals that controls show, in inches and in millimetres.
    integer, parameter :: inch_decimals = 4, metric_decimals = 3
    !> The feed into the material, in parts of that along the outline.
    real(dp), parameter :: plunge_part = 0.5_dp

contains

    !> Writes a program.
    !>
    !> Fails with `cause%usage` where the unit is neither the inch nor the millimetre, feed, depth
    !> or safe height are not set or on the wrong side of zero, the tolerance is not above zero, or
    !> a coordinate is beyond any machine; with `cause%no_arc` where one is no finite number; and
    !> where `follow_chords` or `follow_arcs` does.
    subroutine write_nc(drawing, settings, out, receipt, error)
        type(drawing_type), intent(in) :: drawing           !! in the unit of the file
        type(settings_type), intent(in) :: settings         !! tolerance, half, feed, depth, safe
        type(output_type), intent(inout) :: out             !! gets the program
        type(receipt_type), intent(inout) :: receipt        !! gets what is in it
        type(error_type), allocatable, intent(out) :: error !! see above
        type(shape_type), allocatable :: shapes(:)
        type(unit_type) :: unit
        type(run_type) :: run
        integer :: i

        call find_unit(drawing%units, unit, error)
        if (.not. allocated(error)) call check_settings(settings, unit, error)
        if (allocated(error)) return
        call draw_shapes(drawing, settings%is_half, .false., shapes)
        call check_shapes(shapes, error)
        if (allocated(error)) return
        call put_head(out, drawing, shapes, settings, unit)
        do i = 1, size(shapes)
            run = run_of(shapes(i), settings, unit)
            if (i == 1) call out%line('G0 '//word('Z', run%safe, run%decimals))
            if (i > 1) call put_stop(out, 'NEXT PIECE OF STOCK')
            call put_shape(out, shapes(i), run, receipt, error)
            if (allocated(error)) return
        end do
        call out%line('M5')
        call out%line('M30')
        call out%line('%')
    end subroutine write_nc

    !> Fails with `cause%usage` where a program can't be made with these settings.
    pure subroutine check_settings(settings, unit, error)
        type(settings_type), intent(in) :: settings         !! as asked for
        type(unit_type), intent(in) :: unit                 !! of the drawing
        type(error_type), allocatable, intent(out) :: error !! see above

        if (unit%name /= 'INCHES' .and. unit%name /= 'MM') then
            call fail(error, cause%usage, 'the drawing is in '//trim(unit%name)// &
                '; NC machines know inches and millimetres: --units in or --units mm')
            return
        end if
        call check_tolerance(settings%tolerance, error)
        if (allocated(error)) return
        if (.not. all(is_finite([settings%feed, settings%safe, settings%depth]))) then
            call fail(error, cause%usage, 'feed, depth and safe height must be numbers')
        else if (.not. settings%feed > 0.0_dp) then
            call fail(error, cause%usage, 'a feed of '//shortest(settings%feed)// &
                '; --feed is above 0')
        else if (.not. settings%safe > 0.0_dp) then
            call fail(error, cause%usage, 'a safe height of '//shortest(settings%safe)// &
                '; --safe is above 0, which is the top of the stock')
        else if (.not. settings%depth < 0.0_dp) then
            call fail(error, cause%usage, 'a depth of '//shortest(settings%depth)// &
                '; --depth is below 0, which is the top of the stock')
        else if (max(settings%feed, settings%safe, -settings%depth) >= farthest) then
            call fail(error, cause%usage, 'feed, depth and safe height must be below '// &
                shortest(farthest))
        end if
    end subroutine check_settings

    !> How the paths of a shape are run.
    pure type(run_type) function run_of(shape, settings, unit) result(run)
        type(shape_type), intent(in) :: shape       !! the cut
        type(settings_type), intent(in) :: settings !! as asked for
        type(unit_type), intent(in) :: unit         !! of the drawing
        integer :: usual

        usual = merge(metric_decimals, inch_decimals, unit%is_metric)
        run = run_type(settings%safe, settings%depth, settings%feed, plunge_part*settings%feed, &
            settings%tolerance, decimals_for(settings%tolerance, usual))
        run%has_arcs = shape%arcs > 0.0_dp
        if (.not. run%has_arcs) return
        run%tolerance = shape%arcs
        run%decimals = decimals_of_arcs(shape%arcs, usual)
    end function run_of

    !> Puts what stands before the first cut.
    subroutine put_head(out, drawing, shapes, settings, unit)
        type(output_type), intent(inout) :: out     !! gets it
        type(drawing_type), intent(in) :: drawing   !! what is cut
        type(shape_type), intent(in) :: shapes(:)   !! of it
        type(settings_type), intent(in) :: settings !! as asked for
        type(unit_type), intent(in) :: unit         !! of the drawing

        call out%line('%')
        call out%line(comment('LOFT '//version))
        call out%line(comment('DECK '//drawing%deck))
        if (drawing%title /= '') call out%line(comment('TITLE '//drawing%title))
        call out%line(comment('ALL DIMENSIONS IN '//unit%name))
        call out%line(comment('WITHIN '//compact(maxval(merge(shapes%arcs, settings%tolerance, &
            shapes%arcs > 0.0_dp)))//' '//trim(unit%short)//' OF THE EXACT SHAPE'))
        if (any(shapes%arcs > 0.0_dp)) call out%line(comment( &
            'I AND J LEAD FROM THE START OF AN ARC TO ITS CENTRE'))
        call out%line(comment('THE CENTRE OF THE TOOL FOLLOWS THE OUTLINE'))
        call out%line(comment('NO CUTTER COMPENSATION, NO TOOL CHANGE, NO SPINDLE SPEED'))
        call out%line(comment('START THE SPINDLE BY HAND OR PUT S AND M3 BEHIND THESE LINES'))
        call out%line(trim(merge('G21', 'G20', unit%is_metric)))
        call out%line('G17 G90 G94 G40 G49 G80')
    end subroutine put_head

    !> Puts the stop between two cuts, or between the two sides of a skin.
    subroutine put_stop(out, next)
        type(output_type), intent(inout) :: out     !! gets it
        character(*), intent(in) :: next            !! what comes next
        call out%line('M5')
        call out%line(comment(next//' - START THE SPINDLE AGAIN'))
        call out%line('M0')
    end subroutine put_stop

    !> Puts the contours of a cut, those of the inside of the skin first. Between them the machine
    !> stops: a frame inside of the skin ends with the first.
    subroutine put_shape(out, shape, run, receipt, error)
        type(output_type), intent(inout) :: out             !! gets them
        type(shape_type), intent(in) :: shape               !! the cut
        type(run_type), intent(in) :: run                   !! how paths are run
        type(receipt_type), intent(inout) :: receipt        !! gets the paths
        type(error_type), allocatable, intent(out) :: error !! see `write_nc`
        logical :: is_inside
        integer :: i, turn

        call out%line(comment('CUT '//to_text(shape%number)//' '//shape%title))
        call out%line(comment(counted(int(shape%quantity, i64), 'piece')//', '//axes_of(shape)))
        if (run%has_arcs) call out%line(comment('CIRCULAR ARCS WITHIN '//compact(run%tolerance)))
        do turn = 1, 2
            is_inside = turn == 1
            if (turn == 2 .and. any(shape%contours%is_inside)) &
                call put_stop(out, 'NEXT THE OUTSIDE OF THE SKIN')
            if (any(shape%contours%is_inside)) call out%line(comment( &
                merge('INSIDE OF THE SKIN ', 'OUTSIDE OF THE SKIN', is_inside)))
            do i = 1, size(shape%contours)
                if (shape%contours(i)%is_inside .neqv. is_inside) cycle
                call put_contour(out, shape, shape%contours(i), run, receipt, error)
                if (allocated(error)) return
            end do
        end do
    end subroutine put_shape

    !> What X and Y of a cut are.
    pure function axes_of(shape) result(words)
        type(shape_type), intent(in) :: shape   !! the cut
        character(:), allocatable :: words
        character(3) :: names(2)
        names = axis_names(shape%kind)
        words = 'X IS '//trim(names(1))//', Y IS '//trim(names(2))
    end function axes_of

    !> Puts a contour as a path. What has shrunk to a point is left out.
    subroutine put_contour(out, shape, contour, run, receipt, error)
        type(output_type), intent(inout) :: out             !! gets the path
        type(shape_type), intent(in) :: shape               !! whose contour it is
        type(contour_type), intent(in) :: contour           !! what to cut
        type(run_type), intent(in) :: run                   !! how
        type(receipt_type), intent(inout) :: receipt        !! gets the path
        type(error_type), allocatable, intent(out) :: error !! see `write_nc`
        type(entity_type) :: entity
        type(path_type) :: path

        if (run%has_arcs) then
            call follow_arcs(shape, contour, run, path, entity, error)
        else
            call follow_chords(shape, contour, run, path, entity, error)
        end if
        if (.not. allocated(error)) call check_reach(shape, path, run%decimals, receipt, error)
        if (allocated(error)) return
        if (size(path%segments) == 0) then
            call receipt%say(shape%name//': an outline that is a point is not cut')
            return
        end if
        call put_path(out, path, run)
        entity%name = shape%name
        if (contour%is_inside) entity%kind = entity%kind//' INSIDE'
        entity%points = size(path%segments) + merge(0, 1, contour%is_closed)
        entity%has_place = .true.
        call receipt%add(entity)
    end subroutine put_contour

    !> Fails where a coordinate is beyond any machine; says so where it has more figures than some
    !> controls read.
    pure subroutine check_reach(shape, path, decimals, receipt, error)
        type(shape_type), intent(in) :: shape               !! the cut
        type(path_type), intent(in) :: path                 !! along a contour of it
        integer, intent(in) :: decimals                     !! of coordinates
        type(receipt_type), intent(inout) :: receipt        !! gets the warning
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: most
        integer :: i

        most = maxval(abs(path%start))
        do i = 1, size(path%segments)
            most = max(most, maxval(abs(path%segments(i)%to)))
        end do
        if (most >= farthest) then
            call fail(error, cause%usage, shape%title//' has a coordinate of '//shortest(most)// &
                '; an NC program takes less than '//shortest(farthest))
        else if (most >= 10.0_dp**(read_figures - decimals)) then
            call say_once(receipt, shape%name//': coordinates have more than '// &
                to_text(read_figures)//' figures, which Fanuc and Grbl do not read')
        end if
    end subroutine check_reach

    !> Adds a line to a receipt that does not have it.
    pure subroutine say_once(receipt, line)
        type(receipt_type), intent(inout) :: receipt    !! gets it
        character(*), intent(in) :: line                !! no line end
        if (allocated(receipt%notes)) then
            if (index(receipt%notes, line) > 0) return
        end if
        call receipt%say(line)
    end subroutine say_once

end module export_nc
