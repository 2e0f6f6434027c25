!> Tests of what is marked on a part. That words hide nothing is proved by the points of the circle
!> and by the corners of all other words.
program test_pattern_marks
    use base_kinds, only: dp
    use cut_plane, only: station_plane
    use export_drawing, only: shape_type
    use export_pattern_marks, only: draw_bevels, draw_lines, draw_name, line_type, name_lines
    use export_pattern_page, only: item_kind, label_corners
    use export_pattern_part, only: new_part, part_type
    use export_pattern_style, only: style
    use export_receipt, only: receipt_type
    use support_shapes, only: add_circle, add_path, new_shape
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(shape_type) :: shape
    type(part_type) :: part
    type(receipt_type) :: receipt
    type(line_type), allocatable :: lines(:)

    shape = new_shape('STA_20', 'STATION 20', station_plane(20.0_dp))
    call add_circle(shape, [0.0_dp, 3.0_dp], 9.0_dp, .false., 24)
    call add_circle(shape, [0.0_dp, 3.0_dp], 8.968_dp, .true., 0)
    call new_part(shape, 1.0_dp, 1.0e-4_dp, part, receipt)
    call draw_lines(shape, part, lines)
    call draw_bevels(shape, part)
    call name_lines(lines, part)
    call draw_name(shape%title, part)

    call tap%ok(count_of(style%bevel) == 24 .and. count_of(style%bevel_words) == 24, &
        'every bevel has its tick and its degrees')
    call tap%ok(has_words('+12.0'//char(194)//char(176)) .and. has_words('-12.0'//char(194)// &
        char(176)) .and. has_words('0.0'//char(194)//char(176)), &
        'open is +, closed is -, square has no sign')
    call tap%ok(count_of(style%centre) == 1 .and. count_of(style%fold) == 0, &
        'there is one centre line')
    call tap%ok(has_words('C') .and. has_words('L'), 'with its symbol')
    call tap%ok(has_words('WL 10') .and. has_words('BL 5 PORT') .and. has_words('BL 5 STBD'), &
        'lines have names')
    call tap%ok(.not. has_words('BL 0'), 'the centre line has its symbol for a name')
    call tap%ok(has_words('STATION 20'), 'the part has its name on it')
    call tap%ok(hidden_points() == 0, 'no words hide the outline')
    call tap%ok(crossing_words() == 0, 'no words hide other words')

    shape = new_shape('STA_20', 'STATION 20', station_plane(20.0_dp))
    shape%is_half = .true.
    call add_path(shape, reshape([0.0_dp, -5.0_dp, 8.0_dp, -5.0_dp, 8.0_dp, 5.0_dp, 0.0_dp, &
        5.0_dp], [2, 4]))
    call new_part(shape, 1.0_dp, 1.0e-3_dp, part, receipt)
    call draw_lines(shape, part, lines)
    call name_lines(lines, part)
    call tap%ok(count_of(style%fold) == 1 .and. has_words('FOLD ON CENTRE LINE'), &
        'a half is folded on its centre line')
    call tap%finish()

contains

    !> How many items have a style.
    integer function count_of(kind) result(number)
        integer, intent(in) :: kind !! one of `style%...`
        number = count(part%page%items(:part%page%count)%style == kind)
    end function count_of

    !> True where words are on the part.
    logical function has_words(words) result(has)
        character(*), intent(in) :: words !! all of a label
        integer :: i
        has = .false.
        do i = 1, part%page%count
            if (part%page%items(i)%kind == item_kind%words) &
                has = has .or. part%page%items(i)%label%text == words
        end do
    end function has_words

    !> Points of the circle that are inside of a label.
    integer function hidden_points() result(number)
        real(dp) :: corners(2, 4), at(2), angle
        integer :: i, k

        number = 0
        do i = 1, part%page%count
            if (part%page%items(i)%kind /= item_kind%words) cycle
            corners = label_corners(part%page%items(i)%at(:, 1), part%page%items(i)%label)
            do k = 1, 3600
                angle = real(k, dp)*acos(-1.0_dp)/1800.0_dp
                at = [0.0_dp, 3.0_dp] + 9.0_dp*[cos(angle), sin(angle)]
                if (is_in(at, corners)) number = number + 1
            end do
        end do
    end function hidden_points

    !> Corners and middles of labels that are inside of others; C and L of the symbol are one.
    integer function crossing_words() result(number)
        real(dp) :: first(2, 4), second(2, 4)
        integer :: i, k, e

        number = 0
        do i = 1, part%page%count
            do k = 1, part%page%count
                if (i == k) cycle
                associate (a => part%page%items(i), b => part%page%items(k))
                    if (a%kind /= item_kind%words .or. b%kind /= item_kind%words) cycle
                    if (len(a%label%text) == 1) cycle
                    first = label_corners(a%at(:, 1), a%label)
                    second = label_corners(b%at(:, 1), b%label)
                end associate
                do e = 1, 4
                    if (is_in(second(:, e), first)) number = number + 1
                end do
                if (is_in(0.25_dp*sum(second, dim=2), first)) number = number + 1
            end do
        end do
    end function crossing_words

    !> True for a point inside of a rectangle.
    logical function is_in(at, corners)
        real(dp), intent(in) :: at(2)           !! the point
        real(dp), intent(in) :: corners(2, 4)   !! in order
        real(dp) :: along(2), up(2)
        along = corners(:, 2) - corners(:, 1)
        up = corners(:, 4) - corners(:, 1)
        is_in = dot_product(at - corners(:, 1), along) > 0.0_dp .and. &
            dot_product(at - corners(:, 2), along) < 0.0_dp .and. &
            dot_product(at - corners(:, 1), up) > 0.0_dp .and. &
            dot_product(at - corners(:, 4), up) < 0.0_dp
    end function is_in

end program test_pattern_marks
