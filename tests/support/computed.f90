!> A body deck, read and computed as `loft run` does it.
module support_computed
    use api_computed_body, only: compute_body, computed_body_type
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use deck_job, only: job_type
    use deck_job_reader, only: read_job
    use deck_kind, only: opening_type, read_opening
    use deck_source, only: source_type
    use support_book, only: text_file
    use support_tap, only: tap_type
    implicit none (type, external)
    private

    public :: job_of_text, computed_text, computed_deck

contains

    !> What the text of a body deck asks for.
    subroutine job_of_text(text, job, faults)
        character(*), intent(in) :: text                !! a body deck
        type(job_type), intent(out) :: job              !! what it asks for
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(source_type) :: source
        type(opening_type) :: opening
        type(error_type), allocatable :: error

        call source%from_text(text)
        call read_opening(source, opening, faults, error)
        if (allocated(error)) error stop 'a deck in memory cannot be read'
        call read_job(source, opening%heading, job, faults, error)
        if (allocated(error)) error stop 'a deck in memory cannot be read'
    end subroutine job_of_text

    !> The first body of a deck with its cuts, measures and clearances.
    subroutine computed_text(text, computed, faults)
        character(*), intent(in) :: text                    !! a body deck
        type(computed_body_type), intent(out) :: computed   !! what came out
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added
        type(job_type) :: job
        call job_of_text(text, job, faults)
        call compute_body(job, 1, computed, faults)
    end subroutine computed_text

    !> The first body of a deck of cards/, which must be without fault.
    subroutine computed_deck(tap, name, computed)
        type(tap_type), intent(inout) :: tap                !! the tally
        character(*), intent(in) :: name                    !! of the deck, without its ending
        type(computed_body_type), intent(out) :: computed   !! what came out
        type(fault_list_type) :: faults
        integer :: i

        call computed_text(text_file('cards/'//name//'.crd'), computed, faults)
        call tap%ok(faults%count == 0, name//': the deck runs without a fault')
        do i = 1, faults%count
            call tap%note(faults%item(i)%message)
        end do
    end subroutine computed_deck

end module support_computed
