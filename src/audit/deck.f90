!> The audit of a deck of printed tables. Lines come first, sections after them: where the control
!> lines of a section's points were audited, the section is held to them, within what a figure of
!> theirs may stand for.
!>
!> Tables printed by one program are printed one way. Where a table does not tell how, the way is
!> taken that most figures of all such tables are met by.
module audit_deck
    use audit_audit, only: audit_type, make_audit
    use audit_cross, only: control_of, cross_checks, cross_type
    use audit_figure, only: figure_length, form, print_figure, read_figure
    use audit_finding, only: finding_type
    use audit_item, only: add_reading, entry_of, is_contradicted, item_type, new_item, number_of, &
        point_of, room, softened
    use audit_printing, only: printed_units, printing
    use audit_reading, only: decimals_met, meaning, reading_type, sort
    use audit_steps, only: judge_step
    use audit_value, only: row_at, value_at, value_type
    use base_error, only: error_type
    use base_kinds, only: dp
    use deck_audit, only: audit_deck_type, audit_view, known
    implicit none (type, external)
    private

    public :: deck_audit_type, audit_the_deck

    !> What is found of a deck.
    type :: deck_audit_type
        type(item_type), allocatable :: item(:)         !! its tables, in deck order
        type(finding_type), allocatable :: step(:, :)   !! XI and YI of each
        type(cross_type), allocatable :: cross(:)       !! tables held against one another
    end type deck_audit_type

    !> The share of a table's figures that is some of them.
    real(dp), parameter :: some = 0.3_dp

contains

    !> Audits all tables of a deck.
    subroutine audit_the_deck(deck, found)
        type(audit_deck_type), intent(in) :: deck       !! the tables
        type(deck_audit_type), intent(out) :: found     !! what is found
        logical :: is_section(deck%count)
        integer :: i, way

        allocate (found%item(deck%count), found%step(2, deck%count))
        do i = 1, deck%count
            found%item(i) = new_item(deck%table(i))
            is_section(i) = held_by_lines(found%item(i))
        end do
        call share_decimals(found%item)
        call audit_some(found%item, .not. is_section)
        way = common_way(found%item)
        call audit_alike(found%item, way, .not. is_section)
        do i = 1, deck%count
            if (is_section(i)) call hold_to_lines(found%item, i)
        end do
        call audit_some(found%item, is_section)
        call audit_alike(found%item, common_way(found%item), is_section)
        do i = 1, deck%count
            found%step(1, i) = judge_step(found%item(i), known%xi)
            found%step(2, i) = judge_step(found%item(i), known%yi)
        end do
        found%cross = cross_checks(found%item)
    end subroutine audit_the_deck

    !> Gives tables that do not say it the decimals that most figures of the deck have, where the
    !> table has some such figures; a scan may have damaged most of them.
    pure subroutine share_decimals(item)
        type(item_type), intent(inout) :: item(:) !! the tables
        integer :: met(0:figure_length), own(0:figure_length), i, common

        met = 0
        do i = 1, size(item)
            if (is_undecided(item(i))) met = met + decimals_met(item(i)%line%reading)
        end do
        common = maxloc(met, dim=1) - 1
        do i = 1, size(item)
            own = decimals_met(item(i)%line%reading)
            if (is_undecided(item(i)) .and. real(own(common), dp) >= some*real(sum(own), dp)) &
                item(i)%line%scale%decimals = common
        end do
    end subroutine share_decimals

    !> True for a table of which the decimals are to be found.
    pure logical function is_undecided(item)
        type(item_type), intent(in) :: item !! a table
        is_undecided = item%line%scale%form == form%decimal .and. item%line%scale%decimals < 0
    end function is_undecided

    !> True for a section that says which lines its points are on.
    pure logical function held_by_lines(item)
        type(item_type), intent(in) :: item !! a table
        held_by_lines = item%table%view == audit_view%station .and. any(item%table%control /= '')
    end function held_by_lines

    !> Audits some of the tables, side by side: none looks at another.
    subroutine audit_some(item, chosen)
        type(item_type), intent(inout) :: item(:)   !! the tables
        logical, intent(in) :: chosen(:)            !! which
        integer :: i
        !$omp parallel do schedule(dynamic, 1) default(none) shared(item, chosen)
        do i = 1, size(item)
            if (chosen(i)) call audit_one(item(i))
        end do
        !$omp end parallel do
    end subroutine audit_some

    !> Audits a table. Where readings contradict numbers known exactly, the line is found again
    !> without holding those, once with the control line's figures held in their place; that one is
    !> taken which most readings agree on.
    pure subroutine audit_one(item)
        type(item_type), intent(inout) :: item      !! the table
        type(audit_type) :: other
        type(error_type), allocatable :: error
        integer :: i

        call make_audit(item%line, item%audit, error)
        item%is_audited = .not. allocated(error)
        if (.not. any(is_contradicted(item, [(i, i = 1, size(item%entry))]))) return
        do i = 1, 2
            call make_audit(softened(item, i == 1), other, error)
            if (allocated(error)) cycle
            if (item%is_audited) then
                if (agreeing(other) <= agreeing(item%audit)) cycle
            end if
            item%audit = other
            item%is_audited = .true.
        end do
    end subroutine audit_one

    !> Readings that agree on a line, less the exact numbers that had to be given up for it.
    pure integer function agreeing(audit)
        type(audit_type), intent(in) :: audit !! of a table
        integer :: i
        agreeing = 0
        do i = 1, size(audit%piece)
            agreeing = agreeing + audit%piece(i)%fit%met - count(audit%piece(i)%fit%given_up)
        end do
    end function agreeing

    !> The way of printing that most figures of tables of unknown printing are met by.
    pure integer function common_way(item) result(way)
        type(item_type), intent(in) :: item(:) !! tables, audited or not
        integer :: met(4), i

        met = 0
        do i = 1, size(item)
            if (item(i)%is_audited .and. item(i)%line%printing == printing%unknown) &
                met = met + max(item(i)%audit%met_by, 0)
        end do
        way = maxloc(met, dim=1)
    end function common_way

    !> Audits again, with the common way, the tables of unknown printing that another way fits no
    !> better.
    subroutine audit_alike(item, way, chosen)
        type(item_type), intent(inout) :: item(:)   !! the tables
        integer, intent(in) :: way                  !! one of `printing%...`
        logical, intent(in) :: chosen(:)            !! which
        logical :: again(size(item))
        integer :: met_by(4, size(item)), i

        do i = 1, size(item)
            associate (it => item(i))
                met_by(:, i) = it%audit%met_by
                again(i) = chosen(i) .and. it%is_audited .and. &
                    it%line%printing == printing%unknown .and. it%audit%printing /= way
                if (again(i)) again(i) = it%audit%met_by(way) == maxval(it%audit%met_by)
                if (again(i)) it%line%printing = way
            end associate
        end do
        call audit_some(item, again)
        do i = 1, size(item)
            if (.not. again(i)) cycle
            item(i)%line%printing = printing%unknown
            item(i)%audit%met_by = met_by(:, i)
        end do
    end subroutine audit_alike

    !> Adds to the readings of a section what its control lines say of its points. An X that its
    !> line does not allow is left for the line's.
    pure subroutine hold_to_lines(item, i)
        type(item_type), intent(inout) :: item(:)   !! the tables, lines audited
        integer, intent(in) :: i                    !! the section
        integer, parameter :: x(3) = [known%x1, known%x2, known%x3]
        type(reading_type) :: reading
        type(value_type) :: found
        real(dp) :: along
        integer :: point, of

        do point = 1, 3
            along = number_of(item(i)%table, x(point))
            of = control_of(item, i, point, 1)
            if (of > 0) then
                found = value_at(item(of), sort%ordinate, item(i)%table%at)
                if (found%exists .and. (entry_of(item(i)%table, x(point)) == 0 .or. &
                    abs(along - found%value) > room*found%unit + 0.5_dp*(found%high - found%low))) &
                    call move_point(item(i), point, found%value, along)
            end if
            of = control_of(item, i, point, 2)
            if (of == 0) cycle
            found = value_at(item(of), sort%ordinate, item(i)%table%at)
            if (.not. found%exists) cycle
            reading%sort = sort%ordinate
            reading%meaning = meaning%between
            reading%along = along
            reading%low = found%low - room*found%unit
            reading%high = found%high + room*found%unit
            reading%figure = read_figure(figure_of(item(of), item(i)%table%at, found), form%decimal)
            call add_reading(item(i), reading, 0)
        end do
    end subroutine hold_to_lines

    !> The figure of a control line at a station: as printed or corrected in its table, or else as
    !> its value would be printed.
    pure character(figure_length) function figure_of(item, at, found) result(text)
        type(item_type), intent(in) :: item     !! the line
        real(dp), intent(in) :: at              !! the station, deck units
        type(value_type), intent(in) :: found   !! its value there
        integer :: row

        row = row_at(item, sort%ordinate, at)
        if (row > 0) then
            text = item%audit%finding(row)%likely
        else
            text = print_figure(printed_units(found%value, item%audit%scale, &
                item%audit%printing), item%audit%scale)
        end if
    end function figure_of

    !> Puts what is known of a point of a section at another X.
    pure subroutine move_point(item, point, to, along)
        type(item_type), intent(inout) :: item  !! the section
        integer, intent(in) :: point            !! 1 to 3
        real(dp), intent(in) :: to              !! the other X
        real(dp), intent(inout) :: along        !! its X
        integer :: r

        do r = 1, size(item%entry)
            if (item%entry(r) == 0) cycle
            associate (entry => item%table%entry(item%entry(r)))
                if (entry%what == 0) cycle
                if (point_of(entry%what) == point) item%line%reading(r)%along = to
            end associate
        end do
        along = to
    end subroutine move_point

end module audit_deck
