!> A table of a deck as a line to be audited: its figures as readings, in the order of their rows,
!> then what is known besides.
module audit_item
    use audit_audit, only: audit_type
    use audit_figure, only: figure_type, form, read_figure, scale_type, &
        unit_of, value_of
    use audit_printing, only: printing
    use audit_reading, only: add, line_type, meaning, new_reading, reading_type, sort
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use deck_audit, only: audit_table_type, entry_kind, known
    implicit none (type, external)
    private

    public :: item_type, new_item, softened, is_contradicted, add_reading, entry_of, number_of, &
        point_of

    !> A table and what is found of it.
    type :: item_type
        type(audit_table_type) :: table         !! as the deck has it
        type(line_type) :: line                 !! its figures and what else is known
        integer, allocatable :: entry(:)        !! entry of each reading; 0: of another table
        type(audit_type) :: audit               !! what is found
        logical :: is_audited = .false.         !! there were readings enough
    end type item_type

    !> Ways of printing, in the order of the words of the PRINTED card.
    integer, parameter :: ways(0:4) = [printing%unknown, printing%rounded, printing%truncated, &
        printing%of_1970, printing%half_even]
    !> Meanings of what is known, by `entry_kind`.
    integer, parameter :: meanings(4) = [meaning%printed, meaning%exact, meaning%rounded, &
        meaning%between]

    !> How far a punched ordinate may be from a printed one: units of the last place of the table.
    !> It was rounded, and .0005 was added in 1970.
    real(dp), parameter, public :: room = 1.5_dp

contains

    !> A table made ready for its audit.
    pure type(item_type) function new_item(table) result(item)
        type(audit_table_type), intent(in) :: table !! as the deck has it
        integer :: i, what

        item%table = table
        allocate (item%entry(0), item%line%reading(0))
        item%line%name = table%name
        item%line%scale = scale_type(merge(form%eighths, form%decimal, table%is_fie), &
            table%decimals)
        item%line%printing = ways(table%printing)
        item%line%conics = table%conics
        item%line%shift = table%shift
        do i = 1, table%count
            if (table%entry(i)%kind == entry_kind%row) call add_row(item, i)
        end do
        do what = 1, known%e
            i = entry_of(table, what)
            if (i > 0) call add_known(item, i)
        end do
    end function new_item

    !> The line of a table, held to no number known exactly that another reading contradicts.
    !> Where a control line contradicts, its figure may be held in place of it.
    pure type(line_type) function softened(item, holds_lines) result(line)
        type(item_type), intent(in) :: item         !! a table
        logical, intent(in) :: holds_lines          !! figures of control lines are held
        integer :: i, k

        line = item%line
        do i = 1, size(item%entry)
            if (.not. is_contradicted(item, i)) cycle
            line%reading(i)%meaning = meaning%rounded
            if (.not. holds_lines) cycle
            do k = 1, size(item%entry)
                if (item%entry(k) == 0 .and. is_equal(line%reading(k)%along, &
                    line%reading(i)%along)) line%reading(k)%meaning = meaning%exact
            end do
        end do
    end function softened

    !> True for an ordinate known exactly of which a row at the same X, or a control line, says
    !> otherwise: one of the two is bad.
    elemental logical function is_contradicted(item, known_one) result(is)
        type(item_type), intent(in) :: item !! a table
        integer, intent(in) :: known_one    !! which reading
        real(dp) :: value, between(2)
        integer :: i

        is = .false.
        associate (it => item%line%reading(known_one))
            if (it%sort /= sort%ordinate .or. it%meaning /= meaning%exact .or. &
                .not. it%figure%is_sound) return
            value = value_of(it%figure%units, it%figure%scale)
            do i = 1, size(item%entry)
                associate (other => item%line%reading(i))
                    if (other%sort /= sort%ordinate .or. other%column /= 1 .or. &
                        .not. is_equal(other%along, it%along)) cycle
                    if (other%meaning == meaning%between) then
                        between = [other%low, other%high]
                    else if (other%meaning == meaning%printed .and. other%figure%is_sound) then
                        between = value_of(other%figure%units, other%figure%scale) + &
                            [-room, room]*unit_of(other%figure%scale)
                    else
                        cycle
                    end if
                    is = is .or. value < between(1) .or. value > between(2)
                end associate
            end do
        end associate
    end function is_contradicted

    !> Puts a row behind the readings.
    pure subroutine add_row(item, i)
        type(item_type), intent(inout) :: item !! gets it
        integer, intent(in) :: i               !! which entry
        type(reading_type) :: reading

        associate (entry => item%table%entry(i))
            reading = new_reading(merge(sort%abscissa, sort%ordinate, entry%is_along_y), &
                entry%along, entry%text, form_of=item%line%scale%form)
            reading%column = entry%column
        end associate
        call add_reading(item, reading, i)
    end subroutine add_row

    !> Puts what is known besides behind the readings. The X of a point is no reading, for every
    !> other figure of the point stands on it.
    pure subroutine add_known(item, i)
        type(item_type), intent(inout) :: item !! gets it
        integer, intent(in) :: i               !! which entry
        type(reading_type) :: reading
        integer :: point, sorts

        associate (entry => item%table%entry(i))
            sorts = sort_of(entry%what)
            if (sorts == 0) return
            reading%sort = sorts
            point = point_of(entry%what)
            if (entry%kind == entry_kind%between) then
                reading%meaning = meaning%between
                reading%low = entry%low
                reading%high = entry%high
            else
                reading = new_reading(sorts, 0.0_dp, entry%text, meanings(entry%kind), &
                    form_of_text(entry%text, sorts, item%line%scale%form))
            end if
            if (point > 0) reading%along = number_of(item%table, x_of(point))
            if (sorts == sort%coefficient) reading%letter = entry%what - known%a + 1
        end associate
        call add_reading(item, reading, i)
    end subroutine add_known

    !> Puts a reading behind the others.
    pure subroutine add_reading(item, reading, i)
        type(item_type), intent(inout) :: item     !! gets it
        type(reading_type), intent(in) :: reading  !! one more
        integer, intent(in) :: i                   !! its entry, or 0
        call add(item%line, reading)
        item%entry = [item%entry, i]
    end subroutine add_reading

    !> Figures of a table of feet-inches-eighths may be decimal besides; then they have no dash.
    pure integer function form_of_text(text, sorts, of_table) result(form_of)
        character(*), intent(in) :: text !! the figure
        integer, intent(in) :: sorts     !! one of `sort%...`
        integer, intent(in) :: of_table  !! form of the table
        form_of = form%decimal
        if (sorts <= sort%abscissa .and. index(text(2:), '-') > 0) form_of = of_table
    end function form_of_text

    !> Which reading a number known is; 0: none.
    pure integer function sort_of(what)
        integer, intent(in) :: what !! one of `known%...`
        select case (what)
        case (known%y1, known%y2, known%y3)
            sort_of = sort%ordinate
        case (known%s1, known%s3)
            sort_of = sort%slope
        case (known%a:known%e)
            sort_of = sort%coefficient
        case default
            sort_of = 0
        end select
    end function sort_of

    !> Which point a number known belongs to; 0: none.
    pure integer function point_of(what) result(point)
        integer, intent(in) :: what !! one of `known%...`
        integer, parameter :: points(15) = [1, 1, 1, 2, 2, 3, 3, 3, 0, 0, 0, 0, 0, 0, 0]
        point = points(what)
    end function point_of

    !> The X of a point among what is known.
    pure integer function x_of(point)
        integer, intent(in) :: point !! 1 to 3
        integer, parameter :: places(3) = [known%x1, known%x2, known%x3]
        x_of = places(point)
    end function x_of

    !> The entry of a number known; 0: it is not.
    pure integer function entry_of(table, what) result(i)
        type(audit_table_type), intent(in) :: table !! any
        integer, intent(in) :: what                 !! one of `known%...`
        i = 0
        if (table%count > 0) i = findloc(table%entry(:table%count)%what, what, dim=1)
    end function entry_of

    !> A number known as a double; zero where it is not.
    pure real(dp) function number_of(table, what) result(number)
        type(audit_table_type), intent(in) :: table !! any
        integer, intent(in) :: what                 !! one of `known%...`
        type(figure_type) :: figure
        integer :: i

        number = 0.0_dp
        i = entry_of(table, what)
        if (i == 0) return
        figure = read_figure(table%entry(i)%text, form%decimal)
        number = value_of(figure%units, figure%scale)
    end function number_of

end module audit_item
