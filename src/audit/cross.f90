!> What two tables of one deck say of the same ordinate, side by side:
!>
!> - the points of a section and the control lines that they are on;
!> - a section, a butt line and a waterline of the same name where they meet;
!> - two tables of the same line.
module audit_cross
    use audit_figure, only: figure_length, figure_type, form, print_figure, read_figure, &
        unit_of, value_of
    use audit_finding, only: verdict
    use audit_item, only: entry_of, item_type
    use audit_printing, only: allowed, printed_units, printing
    use audit_reading, only: meaning, sort
    use audit_value, only: row_at, value_at, value_type
    use base_exact, only: is_equal
    use base_kinds, only: dp, i64
    use deck_audit, only: audit_view, known
    implicit none (type, external)
    private

    public :: cross_type, side_type, cross_checks, table_title, control_of

    !> What one table says.
    type :: side_type
        integer :: table = 0                    !! which table of the deck
        logical :: is_printed = .false.         !! by a figure, not only by the line found
        logical :: is_sound = .false.           !! the figure is not suspect
        character(figure_length) :: text = ''   !! the figure, or the value as it would be printed
        real(dp) :: value = 0.0_dp              !! deck units
        real(dp) :: low = 0.0_dp                !! least that it may stand for
        real(dp) :: high = 0.0_dp               !! greatest that it may stand for
        real(dp) :: unit = 1.0_dp               !! of the last place, deck units
    end type side_type

    !> Two tables and the same ordinate.
    type :: cross_type
        character(48) :: what = ''          !! which ordinate
        type(side_type) :: side(2)          !! what each table says
        real(dp) :: apart = 0.0_dp          !! first less second, units of the coarser last place
        logical :: agrees = .false.         !! one value may be behind both
    end type cross_type

    !> The names of the tables by `audit_view%...`.
    character(9), parameter :: view_names(5) = [character(9) :: 'SIDE', 'PLAN', 'STATION', &
        'BUTT LINE', 'WATERLINE']
    !> Words for the points of a section.
    character(2), parameter :: point_words(2, 3) = reshape(['X1', 'Y1', 'X2', 'Y2', 'X3', 'Y3'], &
        [2, 3])

contains

    !> All pairs of what tables say of the same ordinate.
    pure function cross_checks(item) result(cross)
        type(item_type), intent(in) :: item(:) !! the tables, audited
        type(cross_type), allocatable :: cross(:)
        integer :: i, j

        allocate (cross(0))
        do i = 1, size(item)
            if (item(i)%table%view == audit_view%station) call check_points(item, i, cross)
        end do
        do i = 1, size(item)
            do j = 1, size(item)
                if (i == j .or. item(i)%table%name /= item(j)%table%name) cycle
                if (item(i)%table%view > item(j)%table%view) cycle
                if (item(i)%table%view == item(j)%table%view) then
                    if (i < j) call check_doubles(item, i, j, cross)
                else
                    call check_meeting(item, i, j, cross)
                end if
            end do
        end do
    end function cross_checks

    !> The points of a section against its control lines.
    pure subroutine check_points(item, i, cross)
        type(item_type), intent(in) :: item(:)                  !! the tables
        integer, intent(in) :: i                                !! a section
        type(cross_type), allocatable, intent(inout) :: cross(:) !! gets them
        integer, parameter :: what(2, 3) = reshape([known%x1, known%y1, known%x2, known%y2, &
            known%x3, known%y3], [2, 3])
        type(cross_type) :: one
        integer :: point, axis, of, entry

        do point = 1, 3
            do axis = 1, 2
                of = control_of(item, i, point, axis)
                entry = entry_of(item(i)%table, what(axis, point))
                if (of == 0 .or. entry == 0) cycle
                one%what = point_words(axis, point)
                one%side(1) = side_of_entry(item, i, entry)
                one%side(2) = side_of(item, of, sort%ordinate, item(i)%table%at)
                call add_if_whole(one, cross)
            end do
        end do
    end subroutine check_points

    !> The table of the control line that a point of a section is on, PLAN for X, SIDE for Y; 0 for
    !> none.
    pure integer function control_of(item, i, point, axis) result(of)
        type(item_type), intent(in) :: item(:)  !! the tables
        integer, intent(in) :: i                !! a section
        integer, intent(in) :: point            !! 1 to 3
        integer, intent(in) :: axis             !! 1: X, 2: Y
        integer :: j
        of = 0
        associate (name => item(i)%table%control(point))
            if (name == '') return
            do j = 1, size(item)
                if (item(j)%table%name == name .and. item(j)%table%view == &
                    merge(audit_view%plan, audit_view%side, axis == 1)) of = j
            end do
        end associate
    end function control_of

    !> Two tables of the same line, row by row.
    pure subroutine check_doubles(item, i, j, cross)
        type(item_type), intent(in) :: item(:)                  !! the tables
        integer, intent(in) :: i                                !! one
        integer, intent(in) :: j                                !! the other, of the same view
        type(cross_type), allocatable, intent(inout) :: cross(:) !! gets them
        type(cross_type) :: one
        integer :: k, n

        if (item(i)%table%view >= audit_view%station .and. &
            .not. is_equal(item(i)%table%at, item(j)%table%at)) return
        do k = 1, size(item(i)%line%reading)
            n = item(i)%entry(k)
            associate (it => item(i)%line%reading(k))
                if (n == 0 .or. it%meaning /= meaning%printed .or. it%column /= 1) cycle
                one%side(2) = side_of(item, j, it%sort, it%along)
                if (.not. one%side(2)%is_printed) cycle
                one%side(1) = side_of(item, i, it%sort, it%along)
                one%what = trim(merge('AT X', 'AT Y', it%sort == sort%ordinate))//' '// &
                    item(i)%table%entry(n)%along_text
            end associate
            call add_if_whole(one, cross)
        end do
    end subroutine check_doubles

    !> A section, a butt line and a waterline where two of them meet.
    pure subroutine check_meeting(item, i, j, cross)
        type(item_type), intent(in) :: item(:)                  !! the tables
        integer, intent(in) :: i                                !! one
        integer, intent(in) :: j                                !! the other, of a later view
        type(cross_type), allocatable, intent(inout) :: cross(:) !! gets them
        type(cross_type) :: one
        type(value_type) :: meeting

        associate (a => item(i)%table, b => item(j)%table)
            if (a%view == audit_view%station .and. b%view == audit_view%buttock) then
                one%what = 'WL AT STA '//trim(a%at_text)//' BL '//b%at_text
                one%side(1) = side_of(item, i, sort%ordinate, b%at)
                one%side(2) = side_of(item, j, sort%ordinate, a%at)
            else if (a%view == audit_view%station .and. b%view == audit_view%waterline) then
                one%what = 'BL AT STA '//trim(a%at_text)//' WL '//b%at_text
                one%side(1) = side_of(item, i, sort%abscissa, b%at)
                one%side(2) = side_of(item, j, sort%ordinate, a%at)
            else if (a%view == audit_view%buttock .and. b%view == audit_view%waterline) then
                one%what = 'WL AT BL '//trim(a%at_text)//', STA OF WL '//b%at_text
                meeting = value_at(item(j), sort%abscissa, a%at)
                if (.not. meeting%exists) return
                one%side(1) = side_of(item, i, sort%ordinate, meeting%value)
                one%side(2) = side_of_number(j, b%at, b%at_text)
            end if
        end associate
        call add_if_whole(one, cross)
    end subroutine check_meeting

    !> What a table says of an ordinate.
    pure type(side_type) function side_of(item, i, sorts, along) result(side)
        type(item_type), intent(in) :: item(:)  !! the tables
        integer, intent(in) :: i                !! which
        integer, intent(in) :: sorts            !! `sort%ordinate` or `sort%abscissa`
        real(dp), intent(in) :: along           !! deck units
        type(value_type) :: found
        integer :: reading

        if (.not. item(i)%is_audited) return
        reading = row_at(item(i), sorts, along)
        if (reading == 0) found = value_at(item(i), sorts, along)
        if (reading > 0) then
            side = side_of_reading(item(i), reading)
        else if (found%exists) then
            side%value = found%value
            side%low = found%low
            side%high = found%high
            side%unit = found%unit
            side%is_sound = .true.
            side%text = print_figure(printed_units(found%value, item(i)%audit%scale, &
                item(i)%audit%printing), item(i)%audit%scale)
        end if
        side%table = merge(i, 0, side%text /= '')
    end function side_of

    !> What a figure says.
    pure type(side_type) function side_of_reading(item, reading) result(side)
        type(item_type), intent(in) :: item     !! its table
        integer, intent(in) :: reading          !! which
        real(dp) :: between(2)

        associate (figure => item%line%reading(reading)%figure)
            side%text = figure%text
            side%is_printed = .true.
            side%is_sound = item%audit%finding(reading)%verdict <= verdict%rounding
            side%unit = unit_of(figure%scale)
            if (.not. figure%is_sound) return
            between = allowed(figure%units, figure%scale, item%audit%printing)
            side%value = value_of(figure%units, figure%scale)
            side%low = between(1)
            side%high = between(2)
        end associate
    end function side_of_reading

    !> What a number of a section's card says: punched as it was printed in another table.
    pure type(side_type) function side_of_entry(item, i, entry) result(side)
        type(item_type), intent(in) :: item(:)  !! the tables
        integer, intent(in) :: i                !! which
        integer, intent(in) :: entry            !! its entry
        integer :: reading

        side = side_of_number(i, 0.0_dp, item(i)%table%entry(entry)%text)
        reading = findloc(item(i)%entry, entry, dim=1)
        if (reading > 0 .and. item(i)%is_audited) side%is_sound = &
            item(i)%audit%finding(reading)%verdict <= verdict%rounding
    end function side_of_entry

    !> What a number of a card says.
    pure type(side_type) function side_of_number(i, at, text) result(side)
        integer, intent(in) :: i            !! which table
        real(dp), intent(in) :: at          !! the number, where its text is none
        character(*), intent(in) :: text    !! the number as it is on the card
        type(figure_type) :: figure
        real(dp) :: between(2)

        figure = read_figure(text, form%decimal)
        side%table = i
        side%text = text
        side%is_printed = .true.
        side%is_sound = figure%is_sound
        side%unit = unit_of(figure%scale)
        side%value = at
        if (figure%is_sound) side%value = value_of(figure%units, figure%scale)
        between = allowed(figure%units, figure%scale, printing%rounded)
        side%low = between(1)
        side%high = between(2)
    end function side_of_number

    !> Adds a pair of which both sides say something.
    pure subroutine add_if_whole(one, cross)
        type(cross_type), intent(inout) :: one                  !! the pair
        type(cross_type), allocatable, intent(inout) :: cross(:) !! gets it
        type(cross_type), allocatable :: longer(:)
        real(dp) :: room

        if (any(one%side%table == 0)) return
        room = maxval(one%side%unit)
        one%apart = (one%side(1)%value - one%side(2)%value)/room
        one%agrees = one%side(1)%low <= one%side(2)%high + room .and. &
            one%side(2)%low <= one%side(1)%high + room
        allocate (longer(size(cross) + 1))
        longer(:size(cross)) = cross
        longer(size(longer)) = one
        call move_alloc(longer, cross)
    end subroutine add_if_whole

    !> What a table is called: `MHB SIDE`, `LOWER STATION 10.`.
    pure function table_title(item) result(title)
        type(item_type), intent(in) :: item !! any
        character(len_trim(item%table%name, i64) + &
            len_trim(view_names(item%table%view), i64) + len_trim(item%table%at_text, i64) + &
            merge(1_i64, 2_i64, item%table%at_text == '')) :: title
        title = trim(item%table%name)//' '//trim(view_names(item%table%view))//' '// &
            item%table%at_text
    end function table_title

end module audit_cross
