!> The numbers of a line's card: what values good figures allow for each, and the round numbers
!> among those.
!>
!> | name   | number                                       |
!> |--------|----------------------------------------------|
!> | Y1, Y3 | ordinates of the first and the last point    |
!> | S1, S3 | slopes there                                 |
!> | Y2     | ordinate of the shoulder point               |
!> | RHO    | shape ratio of the arc between first and last |
module audit_parameter
    use audit_agreement, only: deepen
    use audit_bounds, only: find_bounds
    use audit_climb, only: most_unknowns
    use audit_condition, only: condition_type, residual
    use audit_curve, only: quantity_at, quantity_type
    use audit_figure, only: figure_length
    use audit_fit, only: fit_type, room_of_1970
    use audit_printing, only: printing
    use audit_problem, only: hold
    use audit_reading, only: sort
    use audit_root, only: root_of_1970
    use audit_round, only: numbers_between, round_numbers
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: parameter_type, pair_type, bound_parameter, fix_parameter, find_pairs

    !> A number of the card.
    type :: parameter_type
        character(4) :: name = ''             !! see above
        type(quantity_type) :: quantity       !! what it is of the conic
        logical :: exists = .false.           !! the conic has it
        logical :: is_limited = .false.       !! the good figures bound it
        real(dp) :: value = 0.0_dp            !! by the best line
        real(dp) :: low = 0.0_dp              !! least value that the good figures allow
        real(dp) :: high = 0.0_dp             !! greatest value that they allow
        character(figure_length), allocatable :: round(:) !! numbers of fewest decimals in between
    end type parameter_type

    !> Two round numbers that the good figures allow together.
    type :: pair_type
        character(figure_length) :: first = ''  !! the one
        character(figure_length) :: second = '' !! the other
    end type pair_type

    !> A parameter fixed to a number is given so much room, relative to its size or to 1.
    real(dp), parameter :: room = 1.0e-9_dp
    !> How far, in units of the last place, a value may be off the bounds of its figure: rounding.
    real(dp), parameter :: noise = 1.0e-6_dp

contains

    !> A parameter of a fitted conic: its value, its bounds and the round numbers within.
    pure type(parameter_type) function bound_parameter(fit, name, quantity) result(parameter)
        type(fit_type), intent(in) :: fit           !! the conic and its good readings
        character(*), intent(in) :: name            !! what it is called
        type(quantity_type), intent(in) :: quantity !! what it is
        real(dp) :: between(2)

        parameter%name = name
        parameter%quantity = quantity
        allocate (parameter%round(0))
        if (fit%met < 0) return
        call quantity_at(fit%k, fit%problem%frame, quantity, parameter%value, parameter%exists)
        if (.not. parameter%exists) return
        if (quantity%sort <= sort%abscissa) parameter%quantity%near = parameter%value
        call find_bounds(fit%problem, fit%member, fit%k, parameter%quantity, between, &
            parameter%is_limited)
        parameter%low = between(1)
        parameter%high = between(2)
        if (parameter%is_limited) parameter%round = round_numbers(between(1), between(2))
    end function bound_parameter

    !> The same conic with a parameter fixed. `is_allowed` is false where the good figures do not
    !> allow it; `fit` is of no use then.
    pure subroutine fix_parameter(fit, quantity, value, is_allowed)
        type(fit_type), intent(inout) :: fit        !! the conic and its good readings
        type(quantity_type), intent(in) :: quantity !! which parameter
        real(dp), intent(in) :: value               !! its number
        logical, intent(out) :: is_allowed          !! see above
        type(condition_type) :: condition
        logical :: held(size(fit%member) + 1)
        integer :: against(most_unknowns), n

        n = size(fit%member) + 1
        condition%quantity = quantity
        condition%unit = room*max(1.0_dp, abs(value))
        condition%centre = value
        condition%low = value - condition%unit
        condition%high = value + condition%unit
        if (quantity%sort <= sort%abscissa) condition%quantity%near = value
        fit%problem%condition = [fit%problem%condition, condition]
        fit%problem%is_exact = [fit%problem%is_exact, .true.]
        fit%problem%is_sure = [fit%problem%is_sure, .false.]
        fit%problem%column = [fit%problem%column, 1]
        fit%given_up = [fit%given_up, .false.]
        fit%problem%is_held = [fit%problem%is_held, .true.]
        held = fit%problem%is_held
        call hold(fit%problem, held)
        fit%member = [fit%member, .not. fit%problem%is_held(n)]
        associate (free => fit%problem%free_to(:, :fit%problem%freedom + 1))
            fit%k = matmul(free, matmul(fit%k, free))
        end associate
        is_allowed = norm2(fit%k) > 0.0_dp
        if (.not. is_allowed) return
        fit%k = fit%k/norm2(fit%k)
        call deepen(fit%problem, fit%member, fit%k, fit%depth, against)
        is_allowed = fit%depth >= 0.0_dp
        if (is_allowed) is_allowed = meets_all(fit)
    end subroutine fix_parameter

    !> True where a conic meets all its good readings, as their values tell.
    pure logical function meets_all(fit)
        type(fit_type), intent(in) :: fit !! the conic and its good readings
        real(dp) :: off, excess
        logical :: exists
        integer :: i

        meets_all = .true.
        do i = 1, size(fit%member)
            if (.not. fit%member(i)) cycle
            call residual(fit%problem%condition(i), fit%k, fit%problem%frame, off, excess, exists)
            meets_all = meets_all .and. exists .and. excess <= room_of_1970
        end do
    end function meets_all

    !> All pairs of numbers of so many decimals that the good figures allow two parameters together.
    pure function find_pairs(fit, first, second, decimals) result(pairs)
        type(fit_type), intent(in) :: fit           !! the conic and its good readings
        type(quantity_type), intent(in) :: first    !! one parameter
        type(quantity_type), intent(in) :: second   !! the other
        integer, intent(in) :: decimals             !! of both
        type(pair_type), allocatable :: pairs(:)
        character(figure_length), allocatable :: ones(:), others(:)
        type(parameter_type) :: one, other
        type(fit_type) :: fixed, both
        real(dp) :: value
        integer :: i, j
        logical :: is_allowed

        allocate (pairs(0), ones(0), others(0))
        one = bound_parameter(fit, '', first)
        if (.not. one%is_limited) return
        ones = numbers_between(one%low, one%high, decimals)
        do i = 1, size(ones)
            read (ones(i), *) value
            fixed = fit
            call fix_parameter(fixed, first, value, is_allowed)
            if (.not. is_allowed) cycle
            other = bound_parameter(fixed, '', second)
            if (.not. other%is_limited) cycle
            others = numbers_between(other%low, other%high, decimals)
            do j = 1, size(others)
                both = fixed
                read (others(j), *) value
                call fix_parameter(both, second, value, is_allowed)
                if (is_allowed) is_allowed = prints_all(both)
                if (is_allowed) pairs = [pairs, pair_type(ones(i), others(j))]
            end do
        end do
    end function find_pairs

    !> True where a conic prints all its good figures, also with the root of the 1970 program.
    pure logical function prints_all(fit)
        type(fit_type), intent(in) :: fit !! the conic and its good readings
        real(dp) :: written
        integer :: i

        prints_all = .true.
        if (fit%printing /= printing%of_1970) return
        do i = 1, size(fit%member)
            associate (it => fit%problem%condition(i))
                if (.not. (fit%member(i) .and. it%is_of_1970) .or. &
                    it%quantity%sort > sort%abscissa) cycle
                written = root_of_1970(fit%k, fit%problem%frame, it%quantity, it%unit)
                prints_all = prints_all .and. written >= it%low - noise*it%unit .and. &
                    written <= it%high + noise*it%unit
            end associate
        end do
    end function prints_all

end module audit_parameter
