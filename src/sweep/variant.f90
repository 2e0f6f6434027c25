!> One variant: its deck read as any deck is, its bodies built, measured and held against the
!> limits. Whatever keeps it from that is said in its row.
module sweep_variant
    use base_decimal, only: to_real
    use base_fault, only: fault_list_type, severity
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use base_tolerances, only: decimal_noise, ulp
    use body_build, only: build_body
    use body_gap_faults, only: report_gaps
    use cut_clearance, only: check_clearance
    use cut_clearance_map, only: map_type, new_map
    use deck_job, only: job_type
    use deck_sweep, only: goal, wanted_type
    use sweep_component, only: component_of
    use sweep_image, only: write_variant
    use sweep_measure, only: measure_of, measured_type, value_type
    use sweep_plan, only: values_of
    use sweep_record, only: record_type, state
    use sweep_study, only: read_text, study_type
    implicit none (type, external)
    private

    public :: compute_variant

contains

    !> Computes a variant.
    subroutine compute_variant(study, number, record)
        type(study_type), intent(in) :: study       !! the sweep
        integer, intent(in) :: number               !! which variant, from 1
        type(record_type), intent(out) :: record    !! what came out
        type(measured_type), allocatable :: bodies(:)
        type(fault_list_type) :: faults
        type(job_type) :: job
        character(:), allocatable :: text

        record%number = number
        record%value = values_of(study%plan, number)
        call write_variant(study%image, record%value, text)
        call read_text(text, job, faults)
        allocate (record%measure(size(study%shown)), record%has(size(study%shown)))
        record%measure = 0.0_dp
        record%has = .false.
        record%state = state%ok
        record%why = ''
        if (.not. faults%has_errors(0)) call build_bodies(job, bodies, faults)
        if (faults%has_errors(0)) then
            record%state = state%fault
            call find_first_error(faults, record%why)
            return
        end if
        call check_components(job, bodies, record)
        call take_measures(study, job%sweep%wanted, bodies, record)
        if (record%state /= state%fault) call check_limits(study, job%sweep%wanted, record)
    end subroutine compute_variant

    !> Builds all bodies. Patches, outlines and ducts, of which nothing is measured, are left out.
    subroutine build_bodies(job, bodies, faults)
        type(job_type), intent(in) :: job                           !! of the variant
        type(measured_type), allocatable, intent(out) :: bodies(:)  !! its bodies
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        integer :: i

        allocate (bodies(size(job%body)))
        do i = 1, size(bodies)
            call build_body(job, i, bodies(i)%body, bodies(i)%joints, faults)
            call report_gaps(job%body(i), bodies(i)%body, faults)
        end do
    end subroutine build_bodies

    !> The first error in words.
    pure subroutine find_first_error(faults, words)
        type(fault_list_type), intent(in) :: faults     !! with at least one
        character(:), allocatable, intent(out) :: words !! where it stands, and what it is
        integer :: i, more

        words = ''
        more = -1
        do i = 1, faults%count
            if (faults%item(i)%severity /= severity%error) cycle
            more = more + 1
            if (more > 0) cycle
            associate (fault => faults%item(i))
                if (fault%line > 0) words = 'line '//to_text(fault%line)
                if (fault%line > 0 .and. fault%first > 0) words = words//', columns '// &
                    to_text(fault%first)//'-'//to_text(fault%last)
                if (fault%line > 0) words = words//': '
                words = words//fault%message
            end associate
        end do
        if (more > 0) words = words//' (and '//to_text(more)//' more)'
    end subroutine find_first_error

    !> Looks how clear the components are; CHECK cards are limits.
    subroutine check_components(job, bodies, record)
        type(job_type), intent(in) :: job                   !! of the variant
        type(measured_type), intent(inout) :: bodies(:)     !! get their clearances
        type(record_type), intent(inout) :: record          !! gets the state
        type(map_type) :: map
        integer :: i, k

        do i = 1, size(bodies)
            associate (asked => job%body(i)%check)
                allocate (bodies(i)%clearances(size(asked)))
                if (size(asked) > 0) map = new_map(bodies(i)%body)
                do k = 1, size(asked)
                    associate (found => bodies(i)%clearances(k))
                        call check_clearance(bodies(i)%body, map, component_of(asked(k)), found)
                        if (found%is_short) call miss(record, 'clearance '//trim(found%name)// &
                            ' '//compact(found%gap)//' is below '//compact(found%asked))
                    end associate
                end do
            end associate
        end do
    end subroutine check_components

    !> A limit is missed.
    pure subroutine miss(record, words)
        type(record_type), intent(inout) :: record  !! gets state and words
        character(*), intent(in) :: words           !! which limit, by what
        record%state = state%limit
        if (record%why /= '') record%why = record%why//'; '
        record%why = record%why//words
    end subroutine miss

    !> Takes the measures, each once.
    subroutine take_measures(study, wanted, bodies, record)
        type(study_type), intent(in) :: study               !! the sweep
        type(wanted_type), intent(in) :: wanted(:)          !! as the deck of the variant has them
        type(measured_type), intent(inout) :: bodies(:)     !! of the variant
        type(record_type), intent(inout) :: record          !! gets the measures
        type(value_type) :: value
        integer :: i

        do i = 1, size(study%shown)
            associate (item => wanted(study%shown(i)))
                call measure_of(bodies(item%body), item, value)
                record%has(i) = .not. allocated(value%why)
                record%measure(i) = value%number
                if (.not. record%has(i)) call want(record, trim(item%name), value%why)
            end associate
        end do
    end subroutine take_measures

    !> A measure does not exist. A reason that holds for several is said once.
    pure subroutine want(record, name, why)
        type(record_type), intent(inout) :: record  !! gets state and words
        character(*), intent(in) :: name            !! of the measure
        character(*), intent(in) :: why             !! why there is none

        if (record%state /= state%fault) record%why = ''
        record%state = state%fault
        if (index(record%why, ': '//why) > 0) return
        if (record%why /= '') record%why = record%why//'; '
        record%why = record%why//name//': '//why
    end subroutine want

    !> Holds the measures against their limits.
    pure subroutine check_limits(study, wanted, record)
        type(study_type), intent(in) :: study       !! the sweep
        type(wanted_type), intent(in) :: wanted(:)  !! as the deck of the variant has them
        type(record_type), intent(inout) :: record  !! with its measures; gets the state
        real(dp) :: number, bound
        integer :: i

        do i = 1, size(study%column)
            associate (item => wanted(i))
                if (item%goal /= goal%range) cycle
                number = record%measure(study%column(i))
                bound = to_real(item%from)
                if (item%has_from .and. is_beyond(bound, number)) call miss(record, &
                    trim(item%name)//' '//compact(number)//' is below '//compact(bound))
                bound = to_real(item%to)
                if (item%has_to .and. is_beyond(number, bound)) call miss(record, &
                    trim(item%name)//' '//compact(number)//' is above '//compact(bound))
            end associate
        end do
    end subroutine check_limits

    !> True where a number is above another by more than rounding.
    elemental logical function is_beyond(number, other)
        real(dp), intent(in) :: number  !! a number
        real(dp), intent(in) :: other   !! another
        is_beyond = number - other > decimal_noise*ulp*max(abs(number), abs(other))
    end function is_beyond

end module sweep_variant
