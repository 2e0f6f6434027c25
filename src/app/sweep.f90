!> `loft sweep`: the variants of a deck, computed by all threads of a machine or, as `loft-mpi`, by
!> many processes; one row each, the Pareto front, the best as a deck.
module app_sweep
    use app_input, only: spare_deck
    use app_journal, only: journal_type, pending_of
    use app_options, only: options_type, was_given
    use app_progress, only: begin_progress, end_progress
    use app_status, only: status
    use app_sweep_plot, only: plot_sweep
    use app_sweep_result, only: best_ending, result_type, write_deck
    use app_whole_file, only: read_whole
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_sha256, only: sha256_type
    use base_text, only: to_text
    use report_fault, only: print_faults
    use sweep_ranks, only: join_team, leave_team, share_text, team_type
    use sweep_study, only: new_study, study_type
    use sweep_work, only: follow_work, lead_work
    implicit none (type, external)
    private

    public :: sweep_deck

contains

    !> Sweeps a deck. The exit status is `status%done`, or `status%faulty` where a card is in error
    !> or no variant keeps all limits.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read or a result not be written, and
    !> with `cause%usage` where the result would take the place of the deck.
    subroutine sweep_deck(options, exit_status, messages, error)
        type(options_type), intent(in) :: options           !! deck, result
        integer, intent(out) :: exit_status                 !! one of `status%...`
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(team_type) :: team

        call join_team(team)
        if (team%rank == 0) then
            call lead(options, team, exit_status, messages, error)
        else
            exit_status = status%done
            call follow()
        end if
        call leave_team()
    end subroutine sweep_deck

    !> What ranks other than 0 do: they get the text of the deck, or nothing where it was no use.
    subroutine follow()
        type(study_type) :: study
        type(fault_list_type) :: faults
        character(:), allocatable :: text

        call share_text(text)
        if (text == '') return
        call new_study(text, study, faults)
        call follow_work(study)
    end subroutine follow

    !> What rank 0 does, or a program that runs alone.
    subroutine lead(options, team, exit_status, messages, error)
        type(options_type), intent(in) :: options           !! deck, result
        type(team_type), intent(in) :: team                 !! the processes
        integer, intent(out) :: exit_status                 !! one of `status%...`
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(study_type) :: study
        type(journal_type) :: journal
        type(result_type) :: result
        character(:), allocatable :: text
        logical :: is_ready

        exit_status = status%unusable
        call prepare(options, text, study, messages, is_ready, error)
        if (.not. is_ready .and. .not. allocated(error)) exit_status = status%faulty
        if (is_ready .and. was_given(options, '--variant')) then
            call print_variant(options, study, error)
            if (.not. allocated(error)) exit_status = status%done
            is_ready = .false.
        end if
        if (is_ready) call result%begin(options%output, error)
        if (is_ready .and. .not. allocated(error)) &
            call open_journal(options, text, study, result, journal, error)
        is_ready = is_ready .and. .not. allocated(error)
        if (.not. is_ready) text = ''
        call share_text(text)
        if (.not. is_ready) return
        call begin_progress()
        call lead_work(study, team, pending_of(journal), journal, error)
        call end_progress()
        call journal%close()
        if (.not. allocated(error)) call conclude(options, study, journal, result, exit_status, &
            error)
    end subroutine lead

    !> Reads the deck and makes the sweep ready. What is wrong with its cards is printed.
    !>
    !> Fails with `cause%file_trouble` where it can't be read, and with `cause%usage` where a result
    !> would take its place.
    subroutine prepare(options, text, study, messages, is_ready, error)
        type(options_type), intent(in) :: options               !! deck, result
        character(:), allocatable, intent(out) :: text          !! all bytes of the deck
        type(study_type), intent(out) :: study                  !! the sweep
        type(output_type), intent(inout) :: messages            !! diagnostics
        logical, intent(out) :: is_ready                        !! no card is in error
        type(error_type), allocatable, intent(out) :: error     !! see above
        type(fault_list_type) :: faults

        is_ready = .false.
        associate (name => options%operand(1)%text, result => options%output)
            call read_whole(name, text, error)
            if (.not. allocated(error)) call spare_deck(name, result, error)
            if (.not. allocated(error) .and. result /= '' .and. result /= '-') &
                call spare_deck(name, result//best_ending, error)
            if (allocated(error)) return
            call new_study(text, study, faults)
            call print_faults(faults, name, .false., messages)
        end associate
        is_ready = .not. faults%has_errors(0)
    end subroutine prepare

    !> Prints the deck of one variant.
    !>
    !> Fails with `cause%usage` where there is no such variant, and with `cause%file_trouble`.
    subroutine print_variant(options, study, error)
        type(options_type), intent(in) :: options           !! which variant, result
        type(study_type), intent(in) :: study               !! the sweep
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: number
        integer :: i

        do i = 1, size(options%given)
            if (options%given(i)%name == '--variant') number = options%given(i)%number
        end do
        if (number < 1.0_dp .or. number > real(study%plan%count, dp) .or. &
            .not. is_equal(number, anint(number))) then
            call fail(error, cause%usage, '--variant: the sweep has variants 1 to '// &
                to_text(study%plan%count))
        else
            call write_deck(options%output, study, nint(number), error)
        end if
    end subroutine print_variant

    !> Opens the journal; only a result that is a regular file has one.
    !>
    !> Fails with `cause%usage` where there is nothing to resume, and as the journal does.
    subroutine open_journal(options, text, study, result, journal, error)
        type(options_type), intent(in) :: options           !! --resume
        character(*), intent(in) :: text                    !! all bytes of the deck
        type(study_type), intent(in) :: study               !! the sweep
        type(result_type), intent(in) :: result             !! begun
        type(journal_type), intent(inout) :: journal        !! the journal
        type(error_type), allocatable, intent(out) :: error !! see above
        type(sha256_type) :: sum
        logical :: is_resumed

        call sum%take(text)
        call journal%begin(study, sum%hex())
        is_resumed = was_given(options, '--resume')
        if (result%is_file) then
            call journal%open(result%name, study, is_resumed, error)
        else if (is_resumed) then
            call fail(error, cause%usage, '--resume goes with -o FILE, a regular file: beside '// &
                'it, in FILE.partial, stands what was done')
        end if
    end subroutine open_journal

    !> Writes the result when all variants are done, and draws the picture.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine conclude(options, study, journal, result, exit_status, error)
        type(options_type), intent(in) :: options           !! deck, --plot
        type(study_type), intent(in) :: study               !! the sweep
        type(journal_type), intent(inout) :: journal        !! with all variants
        type(result_type), intent(inout) :: result          !! begun
        integer, intent(inout) :: exit_status               !! one of `status%...`
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: best

        call result%conclude(study, journal, best, error)
        if (.not. allocated(error) .and. was_given(options, '--plot')) &
            call plot_sweep(options%operand(1)%text, study, journal%record, error)
        if (.not. allocated(error)) exit_status = merge(status%done, status%faulty, best > 0)
    end subroutine conclude

end module app_sweep
