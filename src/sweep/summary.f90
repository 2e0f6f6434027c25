!> What a sweep found, for the eye: how many variants, the Pareto front as a table, the best.
module sweep_summary
    use base_digits, only: fixed, scientific, shortest
    use base_exact, only: is_zero
    use base_kinds, only: dp, i64
    use base_text, only: counted, right, row_of, to_text
    use deck_body_card, only: field_text
    use deck_sweep, only: goal, wanted_type
    use sweep_front, only: best_of, front_of
    use sweep_record, only: record_type, state
    use sweep_study, only: objectives_of, study_type
    implicit none (type, external)
    private

    public :: summary_of, aim_of

    !> Columns of a figure, and rows of the front that are printed.
    integer, parameter :: width = 12, most_rows = 100
    !> Figures of the greatest measure of a column, and the powers of ten that it has without one.
    integer, parameter :: figures = 7, most_decimals = 8, smallest = -4, largest = 8
    !> Figures of measures with a power of ten.
    integer, parameter :: few_figures = 4

contains

    !> The summary, line by line.
    function summary_of(study, records, lead) result(text)
        type(study_type), intent(in) :: study       !! the sweep
        type(record_type), intent(in) :: records(:) !! all variants, marked
        character(*), intent(in) :: lead            !! what every line begins with
        character(:), allocatable :: text
        character(*), parameter :: methods(3) = ['a full grid      ', 'a Latin hypercube', &
            'a list           ']
        integer :: number(3), i
        integer, allocatable :: front(:)

        number = [(count(records%state == i), i = 1, 3)]
        allocate (front, source=front_of(study, records))
        text = lead//counted(int(size(records), i64), 'variant')//', '// &
            trim(methods(study%plan%method))//': '//to_text(number(state%ok))// &
            ' keep all limits, '//to_text(number(state%limit))//' miss one, '// &
            to_text(number(state%fault))//' can''t be built or measured'// &
            new_line('a')
        text = text//lead//'Objectives:'//objective_words(study)//new_line('a')
        if (size(front) == 0) then
            text = text//lead//'No variant keeps all limits: there is no front and no best.'// &
                new_line('a')//lead//'Variant 1: '//records(1)%why//new_line('a')
            return
        end if
        text = text//lead//'Pareto front, '//counted(int(size(front), i64), 'variant')//':'// &
            new_line('a')//table_of(study, records, front, lead)
        text = text//lead//'Best: variant '//to_text(best_of(study, records))//best_words(study)// &
            new_line('a')
    end function summary_of

    !> The objectives in words: ` VOLUME MAX, WETTED MIN`.
    function objective_words(study) result(words)
        type(study_type), intent(in) :: study !! the sweep
        character(:), allocatable :: words
        integer, allocatable :: chosen(:)
        integer :: i

        allocate (chosen, source=objectives_of(study))
        words = ''
        do i = 1, size(chosen)
            if (i > 1) words = words//','
            words = words//' '//aim_of(study%job%sweep%wanted(chosen(i)))
        end do
    end function objective_words

    !> An objective in words: `VOLUME MAX`, `WETTED NEAR 30.`.
    function aim_of(wanted) result(words)
        type(wanted_type), intent(in) :: wanted !! with an aim
        character(:), allocatable :: words
        words = trim(wanted%name)//' '//field_text(wanted%card, 3)
        if (wanted%goal == goal%near) words = words//' '//field_text(wanted%card, 4)
    end function aim_of

    !> How the best one was found.
    function best_words(study) result(words)
        type(study_type), intent(in) :: study !! the sweep
        character(:), allocatable :: words
        words = ''
        if (size(objectives_of(study)) > 1) words = ', on the front the nearest to the best of '// &
            'each objective'
    end function best_words

    !> The front as a table.
    function table_of(study, records, front, lead) result(text)
        type(study_type), intent(in) :: study       !! the sweep
        type(record_type), intent(in) :: records(:) !! all variants
        integer, intent(in) :: front(:)             !! those of the front
        character(*), intent(in) :: lead            !! what every line begins with
        character(:), allocatable :: text
        character(width) :: cell(min(size(front), most_rows), size(study%shown))
        integer :: i, k

        do k = 1, size(cell, 2)
            cell(:, k) = column_of([(records(front(i))%measure(k), i = 1, size(cell, 1))])
        end do
        text = lead//heading_of(study)//new_line('a')
        do i = 1, size(cell, 1)
            associate (record => records(front(i)))
                text = text//lead//right(to_text(record%number), 10)
                do k = 1, size(record%value)
                    text = text//right(shortest(record%value(k)), width)
                end do
            end associate
            do k = 1, size(cell, 2)
                text = text//cell(i, k)
            end do
            text = text//new_line('a')
        end do
        if (size(front) > most_rows) text = text//lead//row_of(' ', 3)//'and '// &
            to_text(size(front) - most_rows)//' more, marked in the result'//new_line('a')
    end function table_of

    !> The names above the columns of the table.
    function heading_of(study) result(text)
        type(study_type), intent(in) :: study !! the sweep
        character(:), allocatable :: text
        integer :: k

        text = '   variant'
        do k = 1, size(study%plan%variable)
            text = text//right(trim(study%plan%variable(k)%name), width)
        end do
        do k = 1, size(study%shown)
            text = text//right(trim(study%job%sweep%wanted(study%shown(k))%name), width)
        end do
    end function heading_of

    !> The measures of a column, all with as many decimals, so that their points are in line: the
    !> greatest has seven figures. Where points would take too much room all have powers of ten.
    pure function column_of(measures) result(column)
        real(dp), intent(in) :: measures(:) !! of the rows of the table
        character(width) :: column(size(measures))
        real(dp) :: greatest
        integer :: i, power

        power = figures - 1
        greatest = maxval(abs(measures))
        if (.not. is_zero(greatest)) power = floor(log10(greatest))
        do i = 1, size(measures)
            if (power >= smallest .and. power <= largest) then
                column(i) = fixed(measures(i), width, min(most_decimals, &
                    max(0, figures - 1 - power)))
            else
                column(i) = scientific(measures(i), width, few_figures)
            end if
        end do
    end function column_of

end module sweep_summary
