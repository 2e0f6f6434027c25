!> One conic from readings of which some are bad: the one that meets the most of them exactly,
!> numbers known exactly among them, printed as the most of them say.
!>
!> First all numbers known exactly are held. Where figures are left over, each such number is given
!> up for once: that is kept where more readings agree for it, one given up counting against it.
module audit_fit
    use audit_agreement, only: agree
    use audit_condition, only: residual
    use audit_curve, only: side_of
    use audit_figure, only: scale_type
    use audit_printing, only: printing
    use audit_problem, only: hold, new_problem, problem_type
    use audit_reading, only: line_type
    use audit_search, only: find_conic
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: fit_type, fit_readings

    !> A conic and the readings that it meets.
    type :: fit_type
        type(problem_type) :: problem              !! the readings as conditions
        real(dp) :: k(6) = 0.0_dp                  !! the conic, deepest inside their bounds
        logical, allocatable :: member(:)          !! conditions it meets, those held left out
        logical, allocatable :: given_up(:)        !! numbers known exactly that it does not meet
        real(dp) :: depth = 0.0_dp                 !! inside the bounds, units of the last place
        integer :: met = -1                        !! readings met, those held with them; -1: none
        integer :: printing = 1                    !! one of `printing%...`
        integer :: met_by(4) = -1                  !! readings met by way of printing; -1: not tried
    end type fit_type

    !> How far, in units of the last place, a figure may be missed: what the square root of the 1970
    !> program may do, and rounding.
    real(dp), parameter, public :: room_of_1970 = 0.11_dp

    !> Draws that find a straight line which as many figures are on as a conic can be worth.
    integer, parameter :: straight_draws = 24

contains

    !> The best conic. `fit%met` is -1 where the readings are too few for any.
    pure subroutine fit_readings(line, scale, chosen, fit)
        type(line_type), intent(in) :: line   !! the line
        type(scale_type), intent(in) :: scale !! of its table
        logical, intent(in) :: chosen(:)      !! readings that count
        type(fit_type), intent(out) :: fit    !! see above
        type(fit_type) :: tried, straight
        integer :: met_by(4), way

        met_by = -1
        do way = printing%rounded, printing%of_1970
            if (line%printing /= printing%unknown .and. line%printing /= way .and. &
                .not. (line%printing == printing%half_even .and. way == printing%rounded)) cycle
            call fit_printed(line, scale, way, chosen, .false., tried)
            call fit_printed(line, scale, way, chosen, .true., straight)
            if (is_straight_enough(straight, tried)) tried = straight
            met_by(way) = tried%met
            if (.not. allocated(fit%member)) then
                fit = tried
            else if (is_better(tried, fit)) then
                fit = tried
            end if
        end do
        if (line%printing == printing%half_even) fit%printing = line%printing
        fit%met_by = met_by
    end subroutine fit_readings

    !> True where a straight line is as well founded as a conic, which has three numbers more and so
    !> meets three more figures whatever they are. A line needs a figure to prove it.
    pure logical function is_straight_enough(straight, conic) result(is)
        type(fit_type), intent(in) :: straight  !! the line
        type(fit_type), intent(in) :: conic     !! the conic
        integer, parameter :: numbers = 2, more_of_conic = 3
        is = straight%met > numbers .and. straight%met + more_of_conic > conic%met
    end function is_straight_enough

    !> The best conic, or straight line, for one way of printing.
    pure subroutine fit_printed(line, scale, way, chosen, is_straight, fit)
        type(line_type), intent(in) :: line   !! the line
        type(scale_type), intent(in) :: scale !! of its table
        integer, intent(in) :: way            !! one of `printing%...`
        logical, intent(in) :: chosen(:)      !! readings that count
        logical, intent(in) :: is_straight    !! a straight line is sought
        type(fit_type), intent(out) :: fit    !! see above
        type(fit_type) :: tried, best
        integer :: i

        fit%problem = new_problem(line, scale, way, chosen)
        fit%problem%is_straight = is_straight
        fit%printing = way
        allocate (fit%member(size(fit%problem%condition)), fit%given_up(size(fit%member)))
        fit%given_up = .false.
        call meet(fit)
        do
            if (fit%met >= size(fit%member)) return
            best = fit
            do i = 1, size(fit%member)
                if (.not. fit%problem%is_exact(i) .or. fit%given_up(i)) cycle
                if (fit%problem%is_sure(i)) cycle
                tried = fit
                tried%given_up(i) = .true.
                call meet(tried)
                if (is_better(tried, best)) best = tried
            end do
            if (.not. is_better(best, fit)) return
            fit = best
        end do
    end subroutine fit_printed

    !> True where a conic meets more readings than another, or as many with less freedom.
    pure logical function is_better(fit, than)
        type(fit_type), intent(in) :: fit  !! one
        type(fit_type), intent(in) :: than !! the other
        is_better = fit%met > than%met .or. (fit%met == than%met .and. &
            freedom_of(fit) < freedom_of(than))
    end function is_better

    !> The degrees of freedom left by numbers known exactly, also by slopes whose points are not.
    pure integer function freedom_of(fit) result(freedom)
        type(fit_type), intent(in) :: fit !! any
        freedom = fit%problem%freedom - count(fit%member .and. fit%problem%is_exact)
    end function freedom_of

    !> Finds the conic that holds the exact numbers not given up, and meets the most of the others.
    pure subroutine meet(fit)
        type(fit_type), intent(inout) :: fit !! its problem and what is given up are known
        logical :: counts(size(fit%member)), found

        fit%met = -1
        fit%member = .false.
        call hold(fit%problem, fit%problem%is_exact .and. .not. fit%given_up)
        counts = .not. (fit%problem%is_held .or. fit%given_up)
        if (fit%problem%is_straight) then
            call find_conic(fit%problem, counts, fit%k, found, straight_draws)
        else
            call find_conic(fit%problem, counts, fit%k, found)
        end if
        if (.not. found) return
        call agree(fit%problem, counts, fit%k, fit%member, fit%depth)
        call prove(fit)
        fit%met = count(fit%member) + count(fit%problem%is_held)
        call take_sides(fit)
    end subroutine meet

    !> Leaves out figures that the conic does not meet when it is worked out.
    pure subroutine prove(fit)
        type(fit_type), intent(inout) :: fit !! its conic is known
        real(dp) :: off, excess
        logical :: exists
        integer :: i
        do i = 1, size(fit%member)
            if (.not. fit%member(i)) cycle
            call residual(fit%problem%condition(i), fit%k, fit%problem%frame, off, excess, exists)
            fit%member(i) = exists .and. excess <= room_of_1970
        end do
    end subroutine prove

    !> A column of a table is one side of its conic: figures met on the other side are not met, and
    !> numbers held there count against the conic.
    pure subroutine take_sides(fit)
        type(fit_type), intent(inout) :: fit !! its conic is known
        integer :: side(size(fit%member)), i
        logical :: alike(size(fit%member))

        do i = 1, size(side)
            side(i) = 0
            if (fit%member(i) .or. fit%problem%is_held(i)) &
                side(i) = side_of(fit%k, fit%problem%frame, fit%problem%condition(i)%quantity)
        end do
        do i = 1, size(side)
            if (side(i) == 0) cycle
            alike = fit%problem%condition%quantity%sort == fit%problem%condition(i)%quantity%sort &
                .and. fit%problem%column == fit%problem%column(i)
            if (2*abs(count(alike .and. side == side(i))) >= count(alike .and. side /= 0)) cycle
            fit%met = fit%met - merge(2, 1, fit%problem%is_held(i))
            fit%member(i) = .false.
        end do
    end subroutine take_sides

end module audit_fit
