!> The plan of a sweep: how many variants there are and which value each variable has in each, all
!> fixed before the first is computed.
!>
!> A full grid counts like the figures of a number: the variable of the last VARY card changes with
!> every variant. A Latin hypercube of n variants cuts the range of each variable into n equal
!> strata; each stratum is met by one variant, which one and where in it by chance. A stratum
!> narrower than the last decimal of a field is met as nearly as may be.
!>
!> Source: M. D. McKay, R. J. Beckman, W. J. Conover, "A comparison of three methods for selecting
!> values of input variables in the analysis of output from a computer code", Technometrics 21
!> (1979), pp. 239-245, section 2.1 (Latin hypercube sampling).
module sweep_plan
    use base_decimal, only: decimal_type, to_real
    use base_fault, only: fault_list_type, new_fault, severity
    use base_kinds, only: dp, i64
    use base_text, only: counted, to_text
    use deck_body_card, only: blame
    use deck_job_vary, only: most_variants
    use deck_sweep, only: method, sweep_type, variable_type
    use sweep_figure, only: field_figure, figure_value
    use sweep_random, only: new_random, next_share, random_type, shuffled
    implicit none (type, external)
    private

    public :: plan_type, new_plan, values_of

    !> A plan.
    type :: plan_type
        integer :: count = 0                            !! variants
        type(variable_type), allocatable :: variable(:) !! what varies
        integer, allocatable :: values(:)               !! grid, list: values of each variable
        integer :: method = 1                           !! one of `method%...`
        real(dp), allocatable :: share(:, :)            !! Latin: variant, variable; 0 to 1 of range
    end type plan_type

contains

    !> Makes the plan. What keeps it from being made is a fault on a card.
    pure subroutine new_plan(sweep, plan, faults)
        type(sweep_type), intent(in) :: sweep           !! what the deck says
        type(plan_type), intent(out) :: plan            !! the plan
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: before

        before = faults%count
        plan%variable = sweep%variable
        plan%method = sweep%method
        plan%values = sweep%variable%count
        if (size(plan%variable) == 0) then
            call faults%add(new_fault(severity%error, 0, 0, 'no VARY card: nothing varies; a '// &
                'VARY card stands right behind the card it varies'))
        else if (plan%method == method%latin) then
            plan%count = sweep%count
            call spread_latin(plan, sweep%seed)
        else
            call check_counts(plan, faults)
            if (faults%has_errors(before)) return
            if (plan%method == method%list) then
                call check_list(plan, faults)
            else
                call check_grid(plan, faults)
            end if
        end if
    end subroutine new_plan

    !> Every range must say how many values it has.
    pure subroutine check_counts(plan, faults)
        type(plan_type), intent(in) :: plan             !! with its variables
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i
        do i = 1, size(plan%variable)
            if (plan%values(i) == 0) call blame(plan%variable(i)%card, 6, 'COUNT is missing: '// &
                'how many values from FROM to TO (SWEEP LATIN needs none)', faults)
        end do
    end subroutine check_counts

    !> The k-th variant has the k-th value of every variable: all have as many.
    pure subroutine check_list(plan, faults)
        type(plan_type), intent(inout) :: plan          !! gets its count
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i

        plan%count = plan%values(1)
        do i = 2, size(plan%values)
            if (plan%values(i) == plan%count) cycle
            call blame(plan%variable(i)%card, 1, trim(plan%variable(i)%name)//' has '// &
                counted(int(plan%values(i), i64), 'value')//', '//trim(plan%variable(1)%name)// &
                ' has '//to_text(plan%count)//'; with SWEEP LIST all have as many', faults)
        end do
    end subroutine check_list

    !> A grid may not have more variants than anyone can wait for. Blamed is the first card with
    !> which it has.
    pure subroutine check_grid(plan, faults)
        type(plan_type), intent(inout) :: plan          !! gets its count
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: words
        real(dp) :: number
        integer :: first

        number = product(real(plan%values, dp))
        if (number <= real(most_variants, dp)) then
            plan%count = product(plan%values)
            return
        end if
        do first = 1, size(plan%values) - 1
            if (product(real(plan%values(:first), dp)) > real(most_variants, dp)) exit
        end do
        call say_grid(plan%values, words)
        associate (variable => plan%variable(first))
            call blame(variable%card, merge(1, 6, variable%is_list), 'the grid has '//words// &
                ' variants, more than '//to_text(most_variants)// &
                '; smaller COUNTs, or SWEEP LATIN with as many variants as there is time for', &
                faults)
        end associate
    end subroutine check_grid

    !> Says in words how many variants a grid has: `10 x 20 = 200`.
    pure subroutine say_grid(values, words)
        integer, intent(in) :: values(:)                !! of each variable
        character(:), allocatable, intent(out) :: words !! the sentence
        real(dp) :: number
        integer :: i

        words = to_text(values(1))
        do i = 2, size(values)
            words = words//' x '//to_text(values(i))
        end do
        number = product(real(values, dp))
        if (size(values) > 1 .and. number < 1.0e15_dp) words = words//' = '// &
            to_text(nint(number, i64))
    end subroutine say_grid

    !> Spreads the variants of a Latin hypercube.
    pure subroutine spread_latin(plan, seed)
        type(plan_type), intent(inout) :: plan  !! with its count; gets the shares
        integer, intent(in) :: seed             !! of the deck
        type(random_type) :: random
        integer, allocatable :: stratum(:)
        real(dp) :: within
        integer :: i, k

        allocate (plan%share(plan%count, size(plan%variable)), stratum(plan%count))
        do k = 1, size(plan%variable)
            random = new_random(seed, k)
            call shuffled(random, stratum)
            do i = 1, plan%count
                call next_share(random, within)
                plan%share(i, k) = (real(stratum(i) - 1, dp) + within)/real(plan%count, dp)
            end do
        end do
    end subroutine spread_latin

    !> The values of all variables in a variant, as they fit a field of a card.
    pure function values_of(plan, number) result(value)
        type(plan_type), intent(in) :: plan !! the plan
        integer, intent(in) :: number       !! the variant, from 1
        real(dp) :: value(size(plan%variable))
        integer :: k, rest, place

        rest = number - 1
        do k = size(value), 1, -1
            if (plan%method == method%latin) then
                value(k) = value_at(plan%variable(k), plan%share(number, k), plan%count)
                cycle
            end if
            place = number - 1
            if (plan%method == method%grid) place = mod(rest, plan%values(k))
            rest = rest/plan%values(k)
            value(k) = rounded(stepped_value(plan%variable(k), place, plan%values(k)))
        end do
    end function values_of

    !> A number as it fits a field of a card.
    pure real(dp) function rounded(number)
        real(dp), intent(in) :: number !! a value of a variable
        rounded = figure_value(field_figure(number))
    end function rounded

    !> A value at a share of a range, as it fits a field; of a list the one that has that share.
    !> A value that would be rounded out of its stratum is taken from the middle of it.
    pure real(dp) function value_at(variable, share, strata) result(value)
        type(variable_type), intent(in) :: variable !! with its range or list
        real(dp), intent(in) :: share               !! above 0, below 1
        integer, intent(in) :: strata               !! equal parts of the range
        real(dp) :: stratum, bound(2)
        integer :: place

        if (variable%is_list) then
            place = min(variable%count, 1 + int(share*real(variable%count, dp)))
            value = rounded(to_real(variable%value(place)))
            return
        end if
        value = rounded(between(variable%value, share))
        stratum = aint(share*real(strata, dp))
        bound = [between(variable%value, stratum/real(strata, dp)), &
            between(variable%value, (stratum + 1.0_dp)/real(strata, dp))]
        if (value < bound(1) .or. value >= bound(2)) value = rounded(0.5_dp*sum(bound))
    end function value_at

    !> A value of a list, or of as many evenly from end to end.
    pure real(dp) function stepped_value(variable, place, count) result(value)
        type(variable_type), intent(in) :: variable !! with its range or list
        integer, intent(in) :: place                !! which, from 0
        integer, intent(in) :: count                !! how many
        if (variable%is_list) then
            value = to_real(variable%value(place + 1))
        else
            value = between(variable%value, real(place, dp)/real(count - 1, dp))
        end if
    end function stepped_value

    !> A value at a share of the way from one to another; at the ends exactly these.
    pure real(dp) function between(ends, share) result(value)
        type(decimal_type), intent(in) :: ends(2)   !! from and to
        real(dp), intent(in) :: share               !! 0 to 1
        value = (1.0_dp - share)*to_real(ends(1)) + share*to_real(ends(2))
    end function between

end module sweep_plan
