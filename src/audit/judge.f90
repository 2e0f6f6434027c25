!> The verdict on each figure of a conic, and of those that are not good the likely true figure.
!>
!> The likely figure is found as T. Bayes would: each figure that the good ones allow, by the share
!> of the allowed values that are printed so, times the likelihood that it is read as what is there
!> (`audit_slip`); how sure it is, is its share of all of them and of mere chance.
module audit_judge
    use audit_agreement, only: conflicts, deepen
    use audit_bounds, only: find_bounds
    use audit_climb, only: most_unknowns
    use audit_curve, only: extreme, quantity_at, quantity_type, roots_of
    use audit_figure, only: figure_length, figure_type, form, print_figure, scale_type, unit_of, &
        value_of
    use audit_finding, only: finding_type, verdict
    use audit_fit, only: fit_type
    use audit_printing, only: allowed, printed_units, printing
    use audit_reading, only: line_type, meaning, reading_type, sort
    use audit_root, only: root_of_1970, root_room
    use audit_slip, only: chance_likelihood, slip, slip_likelihood
    use base_constants, only: vertical_slope
    use base_exact, only: is_equal
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: judge_readings, quantity_of

    !> The most figures that are weighed against each other.
    integer, parameter :: half = 400, most_candidates = 2*half + 1
    !> The weight of a figure one unit outside of what the good figures allow, and of the one that
    !> the best line gives.
    real(dp), parameter :: outside = 1.0e-5_dp, by_best_line = 2.0_dp

contains

    !> Judges the readings chosen by their conic.
    pure subroutine judge_readings(line, scale, chosen, fit, finding)
        type(line_type), intent(in) :: line             !! the line
        type(scale_type), intent(in) :: scale           !! of its table
        logical, intent(in) :: chosen(:)                !! readings of this conic
        type(fit_type), intent(in) :: fit               !! the conic
        type(finding_type), intent(inout) :: finding(:) !! one a reading; those chosen are filled in
        integer :: of(size(chosen)), i

        of = 0
        do i = 1, size(fit%member)
            of(fit%problem%condition(i)%reading) = i
        end do
        do i = 1, size(chosen)
            if (chosen(i)) call compute(line, scale, i, of, fit, finding(i))
        end do
        do i = 1, size(chosen)
            if (chosen(i)) call judge_one(line, scale, i, of, fit, finding)
        end do
    end subroutine judge_readings

    !> True where a reading is met by the conic.
    pure logical function is_met(reading, of, fit)
        integer, intent(in) :: reading    !! which
        integer, intent(in) :: of(:)      !! the condition of each reading, 0: none
        type(fit_type), intent(in) :: fit !! the conic
        is_met = of(reading) > 0
        if (is_met) is_met = fit%member(of(reading)) .or. fit%problem%is_held(of(reading))
    end function is_met

    !> The quantity that a reading is of, on the root on which the nearest good reading of its
    !> column is.
    pure type(quantity_type) function quantity_of(line, which, of, fit) result(quantity)
        type(line_type), intent(in) :: line !! the line
        integer, intent(in) :: which        !! which reading
        integer, intent(in) :: of(:)        !! the condition of each reading, 0: none
        type(fit_type), intent(in) :: fit   !! the conic
        real(dp) :: apart, nearest, roots(2)
        integer :: i, found

        associate (it => line%reading(which), frame => fit%problem%frame)
            quantity = quantity_type(sort=it%sort, letter=it%letter, along=it%along, &
                shift=line%shift)
            if (of(which) > 0) quantity%near = fit%problem%condition(of(which))%quantity%near
            if (of(which) == 0 .and. it%figure%is_sound) &
                quantity%near = value_of(it%figure%units, it%figure%scale)
            if (it%sort == sort%coefficient .or. is_met(which, of, fit)) return
            nearest = huge(nearest)
            do i = 1, size(line%reading)
                if (.not. is_met(i, of, fit)) cycle
                if (line%reading(i)%column /= it%column) cycle
                if (line%reading(i)%sort /= it%sort .and. .not. (it%sort == sort%slope .and. &
                    line%reading(i)%sort == sort%ordinate)) cycle
                apart = abs(line%reading(i)%along - it%along)
                if (apart >= nearest) cycle
                call roots_of(fit%k, frame, line%reading(i)%along, &
                    merge(1, 2, it%sort == sort%abscissa), roots, found)
                if (found < 2) cycle
                nearest = apart
                quantity%side = merge(1, -1, &
                    2.0_dp*fit%problem%condition(of(i))%quantity%near > sum(roots))
            end do
        end associate
    end function quantity_of

    !> The value of a reading by the conic.
    pure subroutine compute(line, scale, which, of, fit, finding)
        type(line_type), intent(in) :: line         !! the line
        type(scale_type), intent(in) :: scale       !! of its table
        integer, intent(in) :: which                !! which reading
        integer, intent(in) :: of(:)                !! the condition of each reading, 0: none
        type(fit_type), intent(in) :: fit           !! the conic
        type(finding_type), intent(inout) :: finding !! of the reading
        type(quantity_type) :: quantity
        type(scale_type) :: places
        real(dp) :: written
        integer :: way

        quantity = quantity_of(line, which, of, fit)
        call quantity_at(fit%k, fit%problem%frame, quantity, finding%computed, finding%is_reached)
        if (.not. finding%is_reached) return
        call places_of(line%reading(which), scale, fit%printing, places, way)
        written = finding%computed
        if (way == printing%of_1970) &
            written = root_of_1970(fit%k, fit%problem%frame, quantity, unit_of(places))
        finding%low = written
        finding%high = written
        finding%computed_figure = print_figure(printed_units(written, places, way), places)
    end subroutine compute

    !> To what places a reading is printed, and how.
    pure subroutine places_of(reading, scale, table_way, places, way)
        type(reading_type), intent(in) :: reading !! which
        type(scale_type), intent(in) :: scale     !! of the table
        integer, intent(in) :: table_way          !! how the table is printed
        type(scale_type), intent(out) :: places   !! see above
        integer, intent(out) :: way               !! one of `printing%...`
        places = reading%figure%scale
        way = printing%rounded
        if (reading%meaning /= meaning%printed .or. reading%sort >= sort%slope) return
        places = scale
        way = table_way
    end subroutine places_of

    !> The verdict on a reading, and what is likely right.
    pure subroutine judge_one(line, scale, which, of, fit, finding)
        type(line_type), intent(in) :: line             !! the line
        type(scale_type), intent(in) :: scale           !! of its table
        integer, intent(in) :: which                    !! which reading
        integer, intent(in) :: of(:)                    !! the condition of each reading, 0: none
        type(fit_type), intent(in) :: fit               !! the conic
        type(finding_type), intent(inout) :: finding(:) !! one a reading
        type(quantity_type) :: quantity
        real(dp) :: between(2), best(2), u
        integer(i64) :: beside(2)
        type(scale_type) :: places
        integer :: way
        logical :: is_limited

        associate (reading => line%reading(which), found => finding(which))
            call places_of(reading, scale, fit%printing, places, way)
            u = unit_of(places)
            found%verdict = verdict%agrees
            if (reading%figure%is_sound .and. found%is_reached) found%residual = &
                (value_of(reading%figure%units, reading%figure%scale) - found%computed)/u
            if (reading%sort == sort%slope .and. min(abs(found%computed), abs(value_of( &
                reading%figure%units, reading%figure%scale))) >= vertical_slope) &
                found%residual = 0.0_dp
            found%likely = reading%figure%text
            found%slip = slip%none
            found%sure = 1.0_dp
            found%evidence = 1.0_dp
            if (is_met(which, of, fit)) return
            quantity = quantity_of(line, which, of, fit)
            if (reading%sort <= sort%abscissa) quantity%near = found%computed
            call find_bounds(fit%problem, fit%member, fit%k, quantity, between, is_limited)
            if (is_at_vertical(line%reading, which)) call widen(fit, quantity%along, between)
            best = [found%low, found%high]
            if (way == printing%of_1970) between = between + [-0.1_dp, 0.1_dp]*root_room(fit%k, &
                fit%problem%frame, quantity, u)
            found%low = minval(between)
            found%high = maxval(between)
            found%verdict = verdict%suspect
            if (reading%figure%is_blank) found%verdict = verdict%blank
            if (reading%figure%is_unread) found%verdict = verdict%unreadable
            if (reading%meaning == meaning%between .or. .not. found%is_reached) return
            if (of(which) > 0) then
                if (any(abs(reading%figure%units - printed_units(best, places, way)) <= 1)) &
                    found%verdict = verdict%rounding
            end if
            call neighbours(line, which, finding, places, way, beside)
            call restore(reading, places, way, beside, best, found)
        end associate
    end subroutine judge_one

    !> True for an ordinate at whose abscissa the line is said to be vertical.
    pure logical function is_at_vertical(reading, which) result(is_at)
        type(reading_type), intent(in) :: reading(:) !! of the line
        integer, intent(in) :: which                 !! which reading
        integer :: i
        is_at = .false.
        if (reading(which)%sort /= sort%ordinate) return
        do i = 1, size(reading)
            if (reading(i)%sort /= sort%slope .or. .not. reading(i)%figure%is_sound) cycle
            is_at = is_at .or. (is_equal(reading(i)%along, reading(which)%along) .and. &
                abs(value_of(reading(i)%figure%units, reading(i)%figure%scale)) >= vertical_slope)
        end do
    end function is_at_vertical

    !> Widens the bounds of an ordinate at a vertical tangent: a little of the abscissa, less than
    !> any figure shows, is much of the ordinate there.
    pure subroutine widen(fit, along, between)
        type(fit_type), intent(in) :: fit         !! the conic
        real(dp), intent(in) :: along             !! abscissa of the tangent, deck units
        real(dp), intent(inout) :: between(2)     !! least and greatest ordinate
        real(dp), parameter :: little = 2.0e-4_dp
        type(quantity_type) :: end
        real(dp) :: roots(2), at
        integer :: found, side
        logical :: exists

        end = quantity_type(sort=extreme, near=along)
        call quantity_at(fit%k, fit%problem%frame, end, at, exists)
        if (.not. exists) return
        do side = -1, 1, 2
            call roots_of(fit%k, fit%problem%frame, at + real(side, dp)*little, 2, roots, found)
            if (found < 2) cycle
            between = [min(between(1), roots(1)), max(between(2), roots(2))]
        end do
    end subroutine widen

    !> What the rows before and after would be printed as, in units of the last place.
    pure subroutine neighbours(line, which, finding, places, way, beside)
        type(line_type), intent(in) :: line          !! the line
        integer, intent(in) :: which                 !! which reading
        type(finding_type), intent(in) :: finding(:) !! of all
        type(scale_type), intent(in) :: places       !! to print to
        integer, intent(in) :: way                   !! one of `printing%...`
        integer(i64), intent(out) :: beside(2)       !! see above
        integer :: side, i

        beside = huge(beside)
        do side = 1, 2
            i = which + 2*side - 3
            if (i < 1 .or. i > size(finding)) cycle
            if (line%reading(i)%sort /= line%reading(which)%sort .or. &
                line%reading(i)%column /= line%reading(which)%column .or. &
                .not. finding(i)%is_reached) cycle
            beside(side) = printed_units(finding(i)%computed, places, way)
        end do
    end subroutine neighbours

    !> The likely true figure of a reading, the slip that explains it and how sure that is.
    pure subroutine restore(reading, places, way, beside, by_line, found)
        type(reading_type), intent(in) :: reading    !! which
        type(scale_type), intent(in) :: places       !! that it should have
        integer, intent(in) :: way                   !! one of `printing%...`
        integer(i64), intent(in) :: beside(2)        !! the true figures of the rows beside
        real(dp), intent(in) :: by_line(2)           !! what the best line gives, from and to
        type(finding_type), intent(inout) :: found   !! its bounds are known
        real(dp) :: weight, likelihood, chance, best, all, weights
        integer(i64) :: first, last, units
        integer :: kind

        first = printed_units(found%low, places, way) - 1
        last = printed_units(found%high, places, way) + 1
        if (last - first >= most_candidates) then
            first = printed_units(found%computed, places, way) - half
            last = first + most_candidates - 1
        end if
        chance = chance_likelihood(reading%figure%text)
        best = 0.0_dp
        all = 0.0_dp
        weights = 0.0_dp
        do units = first, last
            weight = outside + by_best_line*share_of(allowed(units, places, way), by_line)
            if (units > first .and. units < last) weight = weight + &
                share_of(allowed(units, places, way), [found%low, found%high])
            call slip_likelihood(reading%figure%text, units, beside, places, likelihood, kind)
            likelihood = weight*(likelihood + chance)
            all = all + likelihood
            weights = weights + weight
            if (likelihood <= best) cycle
            best = likelihood
            found%likely = print_figure(units, places)
            found%slip = kind
        end do
        found%sure = best/all
        found%evidence = all/weights
    end subroutine restore

    !> The share of some values that is between two others.
    pure real(dp) function share_of(between, values) result(share)
        real(dp), intent(in) :: between(2) !! least and greatest
        real(dp), intent(in) :: values(2)  !! least and greatest
        real(dp) :: width
        width = max(values(2) - values(1), 1.0e-9_dp*(between(2) - between(1)))
        share = min(between(2), values(1) + width) - max(between(1), values(1))
        share = max(share, 0.0_dp)/width
    end function share_of

end module audit_judge
