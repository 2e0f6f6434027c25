!> The increments of a table, XI and YI of a 1970 card, against the ordinates that its rows stand
!> at: each is one increment further than the one before, and the first one from point 1.
module audit_steps
    use audit_figure, only: figure_type, form, print_figure, read_figure, unit_of, value_of
    use audit_finding, only: finding_type, verdict
    use audit_item, only: entry_of, item_type, number_of
    use audit_printing, only: printed_units, printing
    use audit_slip, only: slip_likelihood
    use base_kinds, only: dp, i64
    use deck_audit, only: entry_kind, known
    implicit none (type, external)
    private

    public :: judge_step, find_step

contains

    !> What is found of an increment. The verdict is `verdict%none` where it is not given, or where
    !> the table has no row along it.
    pure type(finding_type) function judge_step(item, what) result(finding)
        type(item_type), intent(in) :: item !! a table that was audited
        integer, intent(in) :: what         !! `known%xi` or `known%yi`
        type(figure_type) :: figure
        real(dp) :: likelihood
        integer(i64) :: units
        integer :: i

        i = entry_of(item%table, what)
        if (i == 0) return
        call find_step(item, what == known%yi, finding%computed, finding%is_reached)
        if (.not. finding%is_reached) return
        figure = read_figure(item%table%entry(i)%text, form%decimal)
        associate (scale => figure%scale)
            units = printed_units(finding%computed, scale, printing%rounded)
            finding%low = finding%computed
            finding%high = finding%computed
            finding%computed_figure = print_figure(units, scale)
            finding%likely = finding%computed_figure
            finding%verdict = verdict%unreadable
            if (figure%is_sound) then
                finding%residual = (value_of(figure%units, scale) - finding%computed)/unit_of(scale)
                finding%verdict = merge(verdict%agrees, verdict%suspect, figure%units == units)
            end if
            if (finding%verdict == verdict%agrees) finding%likely = figure%text
            if (finding%verdict /= verdict%agrees) call slip_likelihood(figure%text, units, &
                [huge(units), huge(units)], scale, likelihood, finding%slip)
        end associate
    end function judge_step

    !> The increment by the rows: from row to row, or from point 1 to the only row.
    pure subroutine find_step(item, is_along_y, step, is_found)
        type(item_type), intent(in) :: item     !! a table that was audited
        logical, intent(in) :: is_along_y       !! of YI
        real(dp), intent(out) :: step           !! deck units
        logical, intent(out) :: is_found        !! there is a row
        real(dp) :: along(2)
        integer :: i, rows

        rows = 0
        along(1) = start_of(item, is_along_y)
        do i = 1, item%table%count
            associate (entry => item%table%entry(i))
                if (entry%kind /= entry_kind%row .or. (entry%is_along_y .neqv. is_along_y)) cycle
                rows = rows + 1
                if (rows == 2) along(1) = along(2)
                along(2) = entry%along
            end associate
            if (rows == 2) exit
        end do
        is_found = rows > 0
        step = 0.0_dp
        if (is_found) step = along(2) - along(1)
    end subroutine find_step

    !> X or Y of point 1: what is likely, where it was found bad.
    pure real(dp) function start_of(item, is_along_y) result(start)
        type(item_type), intent(in) :: item     !! a table that was audited
        logical, intent(in) :: is_along_y       !! Y is asked for
        type(figure_type) :: figure
        integer :: i

        start = number_of(item%table, merge(known%y1, known%x1, is_along_y))
        if (.not. (is_along_y .and. item%is_audited)) return
        i = findloc(item%entry, entry_of(item%table, known%y1), dim=1)
        if (i == 0) return
        figure = read_figure(item%audit%finding(i)%likely, form%decimal)
        if (figure%is_sound) start = value_of(figure%units, figure%scale)
    end function start_of

end module audit_steps
