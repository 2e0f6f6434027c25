!> What a sweep found, for the eye: how many variants, the Pareto front as a table, the best.
module sweep_summary
    use base_digits, only: shortest
    use base_kinds, only: dp, i64
    use base_text, only: compact, counted, right, row_of, to_text
    use deck_body_card, only: field_text
    use deck_sweep, only: method
    use sweep_front, only: best_of, front_of
    use sweep_record, only: record_type, state
    use sweep_study, only: objectives_of, study_type
    implicit none (type, external)
    private

    public :: summary_of

    !> Columns of a figure, and rows of the front that are printed.
    integer, parameter :: width = 12, most_rows = 100

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
            to_text(number(state%fault))//' can''t be built'//new_line('a')
        text = text//lead//'Objectives:'//objective_words(study)//new_line('a')
        if (size(front) == 0) then
            text = text//lead//'No variant keeps all limits: there is no front and no best.'// &
                new_line('a')
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
            associate (wanted => study%job%sweep%wanted(chosen(i)))
                if (i > 1) words = words//','
                words = words//' '//trim(wanted%name)//' '//field_text(wanted%card, 3)
                if (field_text(wanted%card, 4) /= '') words = words//' '// &
                    field_text(wanted%card, 4)
            end associate
        end do
    end function objective_words

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
        integer :: i, k

        text = lead//'   variant'
        do k = 1, size(study%plan%variable)
            text = text//right(trim(study%plan%variable(k)%name), width)
        end do
        do k = 1, size(study%shown)
            text = text//right(trim(study%job%sweep%wanted(study%shown(k))%name), width)
        end do
        text = text//new_line('a')
        do i = 1, min(size(front), most_rows)
            associate (record => records(front(i)))
                text = text//lead//right(to_text(record%number), 10)
                do k = 1, size(record%value)
                    text = text//right(shortest(record%value(k)), width)
                end do
                do k = 1, size(record%measure)
                    text = text//right(figure(record%measure(k)), width)
                end do
                text = text//new_line('a')
            end associate
        end do
        if (size(front) > most_rows) text = text//lead//row_of(' ', 3)//'and '// &
            to_text(size(front) - most_rows)//' more, marked in the result'//new_line('a')
    end function table_of

    !> A measure in a column.
    function figure(value) result(text)
        real(dp), intent(in) :: value !! a finite number
        character(:), allocatable :: text
        text = compact(value)
        if (len(text) > width - 1) text = right(shortest(rounded(value)), 1)
    end function figure

    !> A number rounded to so many figures as a column has room for.
    pure real(dp) function rounded(value)
        real(dp), intent(in) :: value !! not zero
        character(32) :: text
        write (text, '(es24.7e3)') value
        read (text, *) rounded
    end function rounded

end module sweep_summary
