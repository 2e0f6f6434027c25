!> Whether a radius fits a nose, and the largest that does.
module body_nose_fit
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use body_line, only: line_type
    use body_nose_cap, only: check_cap, new_nose, nose_type
    use body_nose_cone, only: cone_type, offset_at
    use deck_job, only: view
    use geom_jet, only: jet_type
    implicit none (type, external)
    private

    public :: fit_nose, find_fitting

    !> Halvings that find the largest radius that fits, and the figures of it that are said.
    integer, parameter :: halvings = 60, figures = 4

contains

    !> A nose with its height, where all lines can be capped.
    !>
    !> Fails with `cause%no_arc` where the radius is too large for a line.
    pure subroutine fit_nose(lines, is_used, is_mine, asked, nose, error)
        type(line_type), intent(in) :: lines(:)             !! of the body
        logical, intent(in) :: is_used(:)                   !! sections stand on it
        logical, intent(in) :: is_mine(:)                   !! it begins in the apex
        type(nose_type), intent(in) :: asked                !! without height
        type(nose_type), intent(out) :: nose                !! with its height
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i

        nose = asked
        do i = 1, size(lines)
            if (is_mine(i)) call widen_nose(lines(i), nose, error)
            if (is_used(i) .and. .not. is_mine(i) .and. lines(i)%from < nose%blend) then
                call fail(error, cause%no_arc, 'line '//trim(lines(i)%name)// &
                    ' begins at station '//compact(lines(i)%from)//', forward of '// &
                    compact(nose%blend)//', where the cap would end')
            end if
            if (allocated(error)) return
        end do
        do i = 1, size(lines)
            if (.not. is_mine(i)) cycle
            call check_cap(nose, lines(i)%side, view%side, error)
            if (.not. allocated(error)) call check_cap(nose, lines(i)%plan, view%plan, error)
            if (.not. allocated(error)) cycle
            error%message = 'no cap fits line '//trim(lines(i)%name)//': '//error%message
            return
        end do
    end subroutine fit_nose

    !> Takes a line into the height of a nose.
    !>
    !> Fails with `cause%no_arc` where the line ends before the cap would.
    pure subroutine widen_nose(line, nose, error)
        type(line_type), intent(in) :: line                 !! a line from the apex
        type(nose_type), intent(inout) :: nose              !! gets the height
        type(error_type), allocatable, intent(out) :: error !! see above
        type(jet_type) :: side, plan
        logical :: is_vertical

        if (min(line%to, nose%cone%aft) <= nose%blend) then
            call fail(error, cause%no_arc, 'the cap would end at station '// &
                compact(nose%blend)//', but line '//trim(line%name)//' ends at '// &
                compact(min(line%to, nose%cone%aft)))
            return
        end if
        call offset_at(nose%cone, line%side, view%side, nose%blend, side, is_vertical)
        call offset_at(nose%cone, line%plan, view%plan, nose%blend, plan, is_vertical)
        nose%height = max(nose%height, abs(side%value), abs(plan%value))
    end subroutine widen_nose

    !> What would be right for a radius that is too large: the largest that fits, found by halving
    !> between it and one that does, and rounded down.
    pure subroutine find_fitting(lines, is_used, is_mine, cone, radius, words)
        type(line_type), intent(in) :: lines(:)         !! of the body
        logical, intent(in) :: is_used(:)               !! sections stand on it
        logical, intent(in) :: is_mine(:)               !! it begins in the apex
        type(cone_type), intent(in) :: cone             !! the sharp nose
        real(dp), intent(in) :: radius                  !! does not fit, deck units
        character(:), allocatable, intent(out) :: words !! the end of a sentence
        real(dp) :: largest, above
        integer :: i

        above = radius
        largest = 0.0_dp
        do i = 1, halvings
            if (fits(0.5_dp*(largest + above))) then
                largest = 0.5_dp*(largest + above)
            else
                above = 0.5_dp*(largest + above)
            end if
        end do
        words = 'no radius fits'
        if (largest > 0.0_dp) words = 'the largest radius that fits is '//compact(floored(largest))
    contains
        !> True where a nose of a radius fits.
        pure logical function fits(trial)
            real(dp), intent(in) :: trial !! deck units
            type(error_type), allocatable :: error
            type(nose_type) :: nose
            call fit_nose(lines, is_used, is_mine, new_nose(cone, trial), nose, error)
            fits = .not. allocated(error)
        end function fits
    end subroutine find_fitting

    !> A number rounded down to a few figures.
    pure real(dp) function floored(value)
        real(dp), intent(in) :: value !! above zero
        integer :: power
        power = figures - 1 - floor(log10(value))
        if (power >= 0) then
            floored = aint(value*10.0_dp**power)/10.0_dp**power
        else
            floored = aint(value/10.0_dp**(-power))*10.0_dp**(-power)
        end if
    end function floored

end module body_nose_fit
