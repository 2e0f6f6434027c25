!> The surfaces of a stretch of skin, within a tolerance, with few poles.
!>
!> First a single span is tried, with the least degree that does; one that gives the skin itself,
!> but for rounding, is taken before all others. Else the degree is 5, and spans in which the
!> distance from the skin is too large are halved, until it is small enough everywhere; then it is
!> tried whether fewer spans of other lengths do, as the distance goes with the power of the length
!> that is one above the degree (C. de Boor, "A Practical Guide to Splines", revised ed., Springer
!> 2001, chapter XII).
module export_shell_surfaces
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use base_tolerances, only: ulp
    use export_shell_distance, only: measure_span, miss_type, sheet_type
    use export_shell_fit, only: fit_rows, fit_type, slot_surface
    use export_shell_pace, only: conic_pace, pace_type
    use export_shell_ribs, only: ends_type
    use export_shell_rows, only: form
    use export_shell_stretch, only: stretch_type, used_lines
    use geom_bspline_surface, only: bspline_surface_type
    implicit none (type, external)
    private

    public :: fitted_type, fit_stretch

    !> The surfaces of a stretch.
    type :: fitted_type
        type(fit_type) :: fit                                       !! rows over u
        type(bspline_surface_type), allocatable :: surface(:)       !! of the slots; none of a wall
        type(miss_type), allocatable :: miss(:)                     !! largest distances: (slots)
        real(dp), allocatable :: span_miss(:)                       !! of each span
        logical, allocatable :: is_exact(:)                         !! the skin itself: (slots)
        integer, allocatable :: form(:)                             !! `form%...`: (slots)
    end type fitted_type

    !> The highest degree along u.
    integer, parameter :: highest_degree = 5
    !> Spans are halved where they miss by more than this part of the tolerance, as the largest
    !> distance may be between the places measured.
    real(dp), parameter :: kept_part = 0.9_dp
    !> Bounds of the halving: spans of a stretch, and parts of it that a span is.
    integer, parameter :: most_spans = 500
    real(dp), parameter :: shortest_span = 2.0_dp**(-24)
    !> How often fewer spans are tried, and the least that a span is taken to miss by: parts of what
    !> it may. The most is as much above it: a span that can't be measured misses by `huge`.
    integer, parameter :: most_tries = 8
    real(dp), parameter :: least_miss = 1.0e-5_dp
    !> A surface is the skin itself where it misses it by no more than this many ulp of its largest
    !> coordinate.
    real(dp), parameter :: exact_ulps = 64.0_dp

contains

    !> Fits the surfaces of a stretch. Those that are the skin itself keep any tolerance.
    !>
    !> Fails with `cause%no_convergence` where the tolerance can't be kept with `most_spans` spans,
    !> and as `section_arc` where a section has no arc.
    pure subroutine fit_stretch(stretch, ends, forms, tolerance, fitted, error)
        type(stretch_type), intent(in) :: stretch           !! any
        type(ends_type), intent(in) :: ends                 !! of it
        integer, intent(in) :: forms(:)                     !! of the sections: `form%...`
        real(dp), intent(in) :: tolerance                   !! deck units
        type(fitted_type), intent(out) :: fitted            !! its surfaces
        type(error_type), allocatable, intent(out) :: error !! see above

        call fit_single_span(stretch, ends, forms, tolerance, fitted, error)
        if (allocated(error)) return
        do while (any(fitted%span_miss > kept_part*tolerance) .and. .not. all(fitted%is_exact))
            call halve_spans(stretch, kept_part*tolerance, fitted, error)
            if (allocated(error)) return
            call fit_all(stretch, ends, forms, fitted, error)
            if (allocated(error)) return
        end do
        if (size(fitted%span_miss) > 2 .and. .not. all(fitted%is_exact)) &
            call spare_spans(stretch, ends, forms, kept_part*tolerance, fitted)
    end subroutine fit_stretch

    !> Looks for fewer spans that do, of such lengths that all miss by about the same.
    pure subroutine spare_spans(stretch, ends, forms, most, fitted)
        type(stretch_type), intent(in) :: stretch           !! any
        type(ends_type), intent(in) :: ends                 !! of it
        integer, intent(in) :: forms(:)                     !! of the sections: `form%...`
        real(dp), intent(in) :: most                        !! by how much they may miss, deck units
        type(fitted_type), intent(inout) :: fitted          !! halved; gets fewer spans
        type(fitted_type) :: trial
        type(error_type), allocatable :: error
        real(dp), allocatable :: need(:)
        integer :: try, spans, too_few

        trial = fitted
        too_few = 1
        do try = 1, most_tries
            need = (max(min(trial%span_miss, most/least_miss)/most, least_miss)) &
                **(1.0_dp/real(highest_degree + 1, dp))
            spans = min(max(ceiling(sum(need)), too_few + 1), size(fitted%span_miss) - 1)
            if (spans <= too_few) return
            trial%fit%breaks = evened(trial%fit%breaks, need, spans)
            call fit_all(stretch, ends, forms, trial, error)
            if (allocated(error)) return
            if (any(trial%span_miss > most)) then
                too_few = spans
            else
                fitted = trial
            end if
        end do
    end subroutine spare_spans

    !> So many breaks that each span between them has the same part of the need of all.
    pure function evened(breaks, need, spans) result(even)
        real(dp), intent(in) :: breaks(:)   !! rising
        real(dp), intent(in) :: need(:)     !! of the spans between them, above zero
        integer, intent(in) :: spans        !! how many there shall be
        real(dp) :: even(spans + 1)
        real(dp) :: before, wanted
        integer :: i, k

        even(1) = breaks(1)
        even(spans + 1) = breaks(size(breaks))
        before = 0.0_dp
        k = 1
        do i = 2, spans
            wanted = sum(need)*real(i - 1, dp)/real(spans, dp)
            do while (before + need(k) < wanted .and. k < size(need))
                before = before + need(k)
                k = k + 1
            end do
            even(i) = breaks(k) + (breaks(k + 1) - breaks(k))*(wanted - before)/need(k)
        end do
    end function evened

    !> Fits a stretch with a single span: exactly, or within the tolerance with the least degree, or
    !> with the highest degree as well as that does. Fails as `section_arc`.
    pure subroutine fit_single_span(stretch, ends, forms, tolerance, fitted, error)
        type(stretch_type), intent(in) :: stretch           !! any
        type(ends_type), intent(in) :: ends                 !! of it
        integer, intent(in) :: forms(:)                     !! of the sections: `form%...`
        real(dp), intent(in) :: tolerance                   !! deck units
        type(fitted_type), intent(out) :: fitted            !! its surfaces
        type(error_type), allocatable, intent(out) :: error !! see above
        type(fitted_type) :: trial
        type(pace_type) :: conic
        logical :: is_kept
        integer :: try
        integer, parameter :: degrees(6) = [1, 2, 2, 3, 4, highest_degree]

        conic = conic_pace(used_lines(stretch), stretch%pace%from, stretch%pace%to)
        is_kept = .false.
        do try = 1, size(degrees)
            if (is_kept .and. degrees(try) > 2) return
            trial%fit%pace = stretch%pace
            if (try == 3) trial%fit%pace = conic
            if (try == 3 .and. .not. conic%is_conic) cycle
            trial%fit%degree = degrees(try)
            trial%fit%breaks = [0.0_dp, 1.0_dp]
            call fit_all(stretch, ends, forms, trial, error)
            if (allocated(error)) return
            if (is_kept .and. .not. all(trial%is_exact)) cycle
            fitted = trial
            if (all(trial%is_exact)) return
            is_kept = trial%span_miss(1) <= kept_part*tolerance
        end do
    end subroutine fit_single_span

    !> Fits and measures the surfaces of a stretch on given breaks. Fails as `section_arc`.
    pure subroutine fit_all(stretch, ends, forms, fitted, error)
        type(stretch_type), intent(in) :: stretch           !! any
        type(ends_type), intent(in) :: ends                 !! of it
        integer, intent(in) :: forms(:)                     !! of the sections: `form%...`
        type(fitted_type), intent(inout) :: fitted          !! has pace, degree, breaks
        type(error_type), allocatable, intent(out) :: error !! see above
        type(sheet_type) :: sheet
        integer :: k

        call fit_rows(stretch, ends, fitted%fit, error)
        if (allocated(error)) return
        call clear(size(stretch%slots), fitted)
        sheet%body = stretch%body
        sheet%pace = fitted%fit%pace
        sheet%slide = stretch%touch
        do k = 1, size(stretch%slots)
            if (stretch%slots(k)%number == 0) cycle
            fitted%form(k) = forms(stretch%slots(k)%number)
            fitted%surface(k) = slot_surface(fitted%fit, stretch, ends, k, fitted%form(k))
            sheet%section = stretch%slots(k)%section
            sheet%surface = fitted%surface(k)
            call measure_spans(sheet, fitted%fit%breaks, fitted%span_miss, fitted%miss(k), error)
            if (allocated(error)) return
            fitted%is_exact(k) = fitted%miss(k)%distance <= &
                exact_ulps*ulp*maxval(abs(fitted%surface(k)%pole))
        end do
    end subroutine fit_all

    !> Makes room for what is fitted and measured. Walls are exact.
    pure subroutine clear(slots, fitted)
        integer, intent(in) :: slots                !! of the stretch
        type(fitted_type), intent(inout) :: fitted  !! has breaks

        if (allocated(fitted%surface)) deallocate (fitted%surface, fitted%miss, fitted%span_miss, &
            fitted%is_exact, fitted%form)
        allocate (fitted%surface(slots), fitted%miss(slots), fitted%is_exact(slots), &
            fitted%form(slots), fitted%span_miss(size(fitted%fit%breaks) - 1))
        fitted%span_miss = 0.0_dp
        fitted%is_exact = .true.
        fitted%form = form%line
    end subroutine clear

    !> Measures the spans of a surface. One with a weight that is not above zero is no surface: it
    !> misses by `huge`. Fails as `section_arc`.
    pure subroutine measure_spans(sheet, breaks, span_miss, worst, error)
        type(sheet_type), intent(in) :: sheet               !! any
        real(dp), intent(in) :: breaks(:)                   !! of its u
        real(dp), intent(inout) :: span_miss(:)             !! of each span, raised
        type(miss_type), intent(inout) :: worst             !! of all, raised
        type(error_type), allocatable, intent(out) :: error !! see above
        type(miss_type) :: miss
        integer :: i

        if (.not. all(sheet%surface%weight > 0.0_dp)) then
            worst%distance = huge(1.0_dp)
            span_miss = huge(1.0_dp)
            return
        end if
        do i = 1, size(span_miss)
            miss = miss_type()
            call measure_span(sheet, breaks(i), breaks(i + 1), miss, error)
            if (allocated(error)) return
            span_miss(i) = max(span_miss(i), miss%distance)
            if (miss%distance >= worst%distance) worst = miss
        end do
    end subroutine measure_spans

    !> Halves the spans that miss by too much. Fails with `cause%no_convergence` where there were
    !> too many spans, or too short ones.
    pure subroutine halve_spans(stretch, most, fitted, error)
        type(stretch_type), intent(in) :: stretch           !! any
        real(dp), intent(in) :: most                        !! how much they may, deck units
        type(fitted_type), intent(inout) :: fitted          !! measured; gets new breaks
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp), allocatable :: finer(:)
        logical, allocatable :: is_kept(:)
        integer :: n

        n = size(fitted%span_miss)
        allocate (finer(2*n + 1), is_kept(2*n + 1))
        finer(1::2) = fitted%fit%breaks
        finer(2::2) = 0.5_dp*(fitted%fit%breaks(:n) + fitted%fit%breaks(2:))
        is_kept(1::2) = .true.
        is_kept(2::2) = fitted%span_miss > most
        fitted%fit%breaks = pack(finer, is_kept)
        n = size(fitted%fit%breaks)
        if (n - 1 <= most_spans .and. minval(fitted%fit%breaks(2:) - fitted%fit%breaks(:n - 1)) &
            >= shortest_span) return
        call fail(error, cause%no_convergence, 'between stations '//compact(stretch%pace%from)// &
            ' and '//compact(stretch%pace%to)//' the surfaces of the skin do not come within '// &
            compact(most)//' of it with '//to_text(n - 1)//' spans; give a greater tolerance, '// &
            'or mend the lines there')
    end subroutine halve_spans

end module export_shell_surfaces
