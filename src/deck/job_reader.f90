!> A body deck, read into a job. All faults of the deck are collected, each on its card; a card in
!> error is left out of the job and the others stay.
module deck_job_reader
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use deck_body_card, only: card_type
    use deck_body_stream, only: met, sort_by_line, stream_type
    use deck_control_card, only: heading_type
    use deck_job, only: job_type
    use deck_job_deed, only: finish_job, take_card
    use deck_job_state, only: state_type
    use deck_source, only: source_type
    implicit none (type, external)
    private

    public :: read_job

contains

    !> Reads a body deck to its end.
    !>
    !> Fails with `cause%file_trouble` where the source can't be read.
    subroutine read_job(source, heading, job, faults, error)
        type(source_type), intent(inout) :: source          !! where the lines come from
        type(heading_type), intent(in) :: heading           !! what `read_opening` found
        type(job_type), intent(out) :: job                  !! what the deck asks for
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added, in deck order
        type(error_type), allocatable, intent(out) :: error !! see above
        type(stream_type) :: stream
        type(state_type) :: state
        type(card_type) :: card
        integer :: before, outcome

        before = faults%count
        stream%heading = heading
        do
            call stream%next_card(source, card, outcome, faults, error)
            if (allocated(error)) return
            if (outcome == met%finished) exit
            if (outcome == met%card) then
                call take_card(state, card, faults)
            else
                state%open%is_sound = .false.
            end if
        end do
        call finish_job(state, stream%heading, faults)
        call sort_by_line(faults, before + 1)
        job = state%job
    end subroutine read_job

end module deck_job_reader
