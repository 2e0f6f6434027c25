!> A sweep made ready: its deck as text and as job, its plan, the columns of its result. It is made
!> from the bytes of the deck alone, so that any process can make it for itself.
module sweep_study
    use base_error, only: error_type
    use base_fault, only: fault_list_type, new_fault, severity
    use deck_job, only: job_type
    use deck_job_reader, only: read_job
    use deck_kind, only: deck_kind_of, opening_type, read_opening
    use deck_source, only: source_type
    use deck_sweep, only: has_aim, wanted_type
    use sweep_image, only: image_type, new_image
    use sweep_plan, only: new_plan, plan_type
    implicit none (type, external)
    private

    public :: study_type, new_study, read_text, objectives_of

    !> A sweep made ready.
    type :: study_type
        type(image_type) :: image           !! the deck as text
        type(job_type) :: job               !! the deck as it stands
        type(plan_type) :: plan             !! its variants
        integer, allocatable :: column(:)   !! of each measure that is looked at, its column
        integer, allocatable :: shown(:)    !! of each column, the first measure it shows
    end type study_type

contains

    !> Makes a sweep ready. What is wrong is a fault; where one of them is an error there is none.
    subroutine new_study(text, study, faults)
        character(*), intent(in) :: text                !! all bytes of the deck
        type(study_type), intent(out) :: study          !! the sweep
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        call read_text(text, study%job, faults)
        if (faults%has_errors(0)) return
        call new_plan(study%job%sweep, study%plan, faults)
        if (faults%has_errors(0)) return
        study%image = new_image(text, study%job%sweep%target)
        call find_columns(study)
        if (size(objectives_of(study)) == 0) call faults%add(new_fault(severity%error, 0, 0, &
            'no OBJECT card with MIN, MAX or NEAR, as OBJECT VOLUME MAX: nothing says which '// &
            'variant is better'))
    end subroutine new_study

    !> Reads a body deck from a text.
    subroutine read_text(text, job, faults)
        character(*), intent(in) :: text                !! all bytes of the deck
        type(job_type), intent(out) :: job              !! what it asks for
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(source_type) :: source
        type(opening_type) :: opening
        type(error_type), allocatable :: error

        call source%from_text(text)
        call read_opening(source, opening, faults, error)
        if (.not. allocated(error)) then
            if (opening%kind == deck_kind_of%body) then
                call read_job(source, opening%heading, job, faults, error)
            else
                call faults%add(new_fault(severity%error, 0, 0, &
                    'no body deck; loft sweep takes '// &
                    'decks with lines, sections and VARY cards (see loft help cards)'))
            end if
        end if
        if (allocated(error)) call faults%add(new_fault(severity%error, 0, 0, error%message))
    end subroutine read_text

    !> One column for each name of a measure.
    pure subroutine find_columns(study)
        type(study_type), intent(inout) :: study    !! with its job; gets the columns
        type(wanted_type), allocatable :: wanted(:)
        integer :: i, k

        allocate (wanted, source=study%job%sweep%wanted)
        allocate (study%column(size(wanted)), study%shown(0))
        do i = 1, size(wanted)
            study%column(i) = 0
            do k = 1, size(study%shown)
                if (wanted(study%shown(k))%name == wanted(i)%name) study%column(i) = k
            end do
            if (study%column(i) > 0) cycle
            study%shown = [study%shown, i]
            study%column(i) = size(study%shown)
        end do
    end subroutine find_columns

    !> The measures that have an aim.
    pure function objectives_of(study) result(chosen)
        type(study_type), intent(in) :: study !! with its job
        integer, allocatable :: chosen(:)
        integer :: i
        associate (wanted => study%job%sweep%wanted)
            chosen = pack([(i, i = 1, size(wanted))], has_aim(wanted))
        end associate
    end function objectives_of

end module sweep_study
