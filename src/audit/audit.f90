!> The audit of a line: from its printed figures back to the conic, or chain of conics, that most of
!> them come from, the verdict on each figure, and the numbers of the card.
!>
!>     call make_audit(line, audit, error)
module audit_audit
    use audit_card, only: card_type, make_card
    use audit_chain, only: split_line
    use audit_curve, only: quantity_type
    use audit_figure, only: form, read_figure, scale_type, unit_of
    use audit_finding, only: finding_type
    use audit_fit, only: fit_readings, fit_type
    use audit_joint, only: find_joint
    use audit_judge, only: judge_readings
    use audit_parameter, only: bound_parameter, parameter_type
    use audit_printing, only: printing
    use audit_rival, only: settle_rivals
    use audit_reading, only: common_decimals, line_type, meaning, sort
    use audit_slip, only: slip
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: audit_type, piece_type, make_audit

    !> One conic of a line.
    type :: piece_type
        type(fit_type) :: fit                      !! the conic and what it meets
        logical, allocatable :: chosen(:)          !! readings that are of it, one a reading
        real(dp) :: first = 0.0_dp                 !! abscissa where it begins: end or joint
        real(dp) :: last = 0.0_dp                  !! abscissa where it ends
        type(parameter_type) :: parameter(5)       !! Y1, S1, Y2, Y3, S3
        type(card_type) :: card                    !! round numbers that give all good figures
    end type piece_type

    !> How sure a slip must be before a number known exactly is put right.
    real(dp), parameter :: sure_enough = 0.95_dp

    !> What an audit finds.
    type :: audit_type
        type(line_type) :: line                    !! what was audited
        type(scale_type) :: scale                  !! places its figures are printed to
        integer :: printing = 0                    !! one of `printing%...`, the best
        integer :: met_by(4) = -1                  !! readings met by each way; -1: not tried
        type(piece_type), allocatable :: piece(:)  !! conics in order
        type(finding_type), allocatable :: finding(:) !! one a reading
    end type audit_type

contains

    !> Audits a line.
    !>
    !> Fails with `cause%too_few` where the readings are too few for a conic.
    pure subroutine make_audit(line, audit, error)
        type(line_type), intent(in) :: line                 !! what is known
        type(audit_type), intent(out) :: audit              !! what is found
        type(error_type), allocatable, intent(out) :: error !! see above
        logical, allocatable :: chosen(:, :)
        integer :: i

        audit%line = line
        audit%scale = line%scale
        if (.not. allocated(audit%line%reading)) allocate (audit%line%reading(0))
        if (audit%scale%form == form%decimal .and. audit%scale%decimals < 0) &
            audit%scale%decimals = common_decimals(audit%line%reading)
        call split_line(audit%line, audit%scale, chosen)
        allocate (audit%piece(size(chosen, 2)), audit%finding(size(audit%line%reading)))
        do i = 1, size(audit%piece)
            audit%piece(i)%chosen = chosen(:, i)
            where (chosen(:, i)) audit%finding%piece = i
        end do
        call find_printing(audit)
        do i = 1, size(audit%piece)
            if (audit%piece(i)%fit%met < 0) then
                call fail(error, cause%too_few, 'the readings of '//trim(line%name)// &
                    ' are too few for a conic')
                return
            end if
        end do
        call find_ends(audit)
        do i = 1, size(audit%piece)
            call audit_piece(audit%line, audit%scale, audit%piece(i), audit%finding)
        end do
        audit%line%printing = line%printing
    end subroutine make_audit

    !> Fits all conics, and finds the way of printing that meets most readings of all of them.
    pure subroutine find_printing(audit)
        type(audit_type), intent(inout) :: audit !! its pieces are chosen
        integer :: i

        audit%met_by = 0
        do i = 1, size(audit%piece)
            call fit_readings(audit%line, audit%scale, audit%piece(i)%chosen, audit%piece(i)%fit)
            audit%met_by = audit%met_by + audit%piece(i)%fit%met_by
        end do
        where (audit%met_by < 0) audit%met_by = -1
        audit%printing = audit%line%printing
        if (audit%printing /= printing%unknown) return
        audit%printing = maxloc(audit%met_by, dim=1)
        if (size(audit%piece) == 1) audit%printing = audit%piece(1)%fit%printing
        audit%line%printing = audit%printing
        do i = 1, size(audit%piece)
            if (audit%piece(i)%fit%printing /= audit%printing) call fit_readings(audit%line, &
                audit%scale, audit%piece(i)%chosen, audit%piece(i)%fit)
        end do
    end subroutine find_printing

    !> The ends of all conics: the first and the last known abscissa, and joints between.
    pure subroutine find_ends(audit)
        type(audit_type), intent(inout) :: audit !! its conics are fitted
        real(dp) :: joint, row(2)
        integer :: i

        do i = 1, size(audit%piece)
            call find_extent(audit%line, audit%piece(i))
        end do
        do i = 1, size(audit%piece) - 1
            row = [audit%piece(i)%last, audit%piece(i + 1)%first]
            joint = find_joint(audit%piece(i)%fit, audit%piece(i + 1)%fit, row, &
                near_to(audit%line, audit%piece(i), row(1)), unit_of(audit%scale))
            audit%piece(i)%last = joint
            audit%piece(i + 1)%first = joint
        end do
    end subroutine find_ends

    !> The first and the last known abscissa of a conic.
    pure subroutine find_extent(line, piece)
        type(line_type), intent(in) :: line      !! the line
        type(piece_type), intent(inout) :: piece !! one conic of it
        logical :: counts(size(line%reading))
        counts = piece%chosen .and. (line%reading%sort == sort%ordinate .or. &
            line%reading%sort == sort%slope)
        if (.not. any(counts)) return
        piece%first = minval(line%reading%along, mask=counts)
        piece%last = maxval(line%reading%along, mask=counts)
        associate (first => line%reading(findloc(counts, .true., dim=1))%along)
            if (first <= 0.5_dp*(piece%first + piece%last)) return
        end associate
        piece%first = maxval(line%reading%along, mask=counts)
        piece%last = minval(line%reading%along, mask=counts)
    end subroutine find_extent

    !> Audits one conic. A number known exactly that was given up, and is surely another one by a
    !> slip, is put right and the conic is sought anew.
    pure subroutine audit_piece(line, scale, piece, finding)
        type(line_type), intent(in) :: line             !! the line
        type(scale_type), intent(in) :: scale           !! of its table
        type(piece_type), intent(inout) :: piece        !! its readings are chosen
        type(finding_type), intent(inout) :: finding(:) !! one a reading; those chosen are filled in
        type(line_type) :: mended
        type(finding_type) :: kept(size(finding))
        logical :: is_mended(size(finding))
        integer :: i, reading

        mended = line
        is_mended = .false.
        call judge_piece(line, scale, piece, finding)
        do i = 1, size(piece%fit%given_up)
            if (.not. piece%fit%given_up(i)) cycle
            reading = piece%fit%problem%condition(i)%reading
            associate (it => finding(reading))
                if (it%sure < sure_enough .or. it%slip == slip%none) cycle
                mended%reading(reading)%figure = &
                    read_figure(it%likely, line%reading(reading)%figure%scale%form)
                is_mended(reading) = .true.
            end associate
        end do
        if (.not. any(is_mended)) return
        kept = finding
        call fit_readings(mended, scale, piece%chosen, piece%fit)
        call judge_piece(mended, scale, piece, finding)
        where (is_mended) finding = kept
    end subroutine audit_piece

    !> Bounds the numbers of a fitted conic, makes its card and judges its readings.
    pure subroutine judge_piece(line, scale, piece, finding)
        type(line_type), intent(in) :: line             !! the line
        type(scale_type), intent(in) :: scale           !! of its table
        type(piece_type), intent(inout) :: piece        !! its conic is fitted
        type(finding_type), intent(inout) :: finding(:) !! one a reading; those chosen are filled in
        integer :: rival(size(finding))

        call judge_readings(line, scale, piece%chosen, piece%fit, finding)
        call settle_rivals(line, scale, piece%chosen, piece%fit, finding)
        rival = finding%rival
        call find_parameters(line, piece)
        call make_card(piece%fit, piece%parameter, piece%card)
        call judge_readings(line, scale, piece%chosen, piece%fit, finding)
        finding%rival = rival
    end subroutine judge_piece

    !> The numbers of the card of a conic: its shoulder point is the exact point between its ends,
    !> or else one in the middle of them.
    pure subroutine find_parameters(line, piece)
        type(line_type), intent(in) :: line      !! the line
        type(piece_type), intent(inout) :: piece !! one conic of it; its ends are known
        character(4), parameter :: names(5) = [character(4) :: 'Y1', 'S1', 'Y2', 'Y3', 'S3']
        integer, parameter :: sorts(5) = [sort%ordinate, sort%slope, sort%ordinate, &
            sort%ordinate, sort%slope]
        type(quantity_type) :: quantity
        real(dp) :: at(5), middle
        integer :: i

        middle = 0.5_dp*(piece%first + piece%last)
        do i = 1, size(line%reading)
            if (.not. piece%chosen(i) .or. line%reading(i)%sort /= sort%ordinate .or. &
                line%reading(i)%meaning == meaning%printed) cycle
            if ((line%reading(i)%along - piece%first)*(piece%last - line%reading(i)%along) > &
                0.0_dp) middle = line%reading(i)%along
        end do
        at = [piece%first, piece%first, middle, piece%last, piece%last]
        do i = 1, 5
            quantity = quantity_type(sort=sorts(i), along=at(i), near=near_to(line, piece, at(i)))
            piece%parameter(i) = bound_parameter(piece%fit, names(i), quantity)
        end do
    end subroutine find_parameters

    !> The ordinate of the good reading of the first column nearest to an abscissa.
    pure real(dp) function near_to(line, piece, x) result(near)
        type(line_type), intent(in) :: line   !! the line
        type(piece_type), intent(in) :: piece !! one conic of it
        real(dp), intent(in) :: x             !! abscissa, deck units
        real(dp) :: nearest, apart
        integer :: i

        near = 0.0_dp
        nearest = huge(nearest)
        associate (fit => piece%fit)
            do i = 1, size(fit%member)
                if (.not. (fit%member(i) .or. fit%problem%is_held(i))) cycle
                associate (it => line%reading(fit%problem%condition(i)%reading))
                    if (it%sort /= sort%ordinate .or. it%column /= 1) cycle
                    apart = abs(it%along - x)
                end associate
                if (apart >= nearest) cycle
                nearest = apart
                near = fit%problem%condition(i)%centre
            end do
        end associate
    end function near_to

end module audit_audit
