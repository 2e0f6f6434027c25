!> A 1970 deck run a few cards at a time, as many as have arrived: each thread reads a card and
!> computes it, and the tables are printed in the order of the deck before LOFT waits for more. What
!> is wrong with a card is reported as it is met; the other cards run.
module app_run_conics
    use app_files, only: base_name
    use app_input, only: deck_input_type
    use app_options, only: options_type
    use app_run_card, only: card_result_type, compute_card
    use app_status, only: status
    use base_error, only: error_type, fail
    use base_fault, only: fault_list_type
    use base_kinds, only: i64
    use base_memory, only: has_little_memory
    use base_output, only: output_type
    use deck_conic_deck, only: card_image_type, conic_deck_type, found
    use deck_source, only: source_type
    use report_conic_listing, only: conic_listing_type
    use report_csv, only: print_csv_header
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: run_conics

    !> Cards of a batch, at most; as many as a block of the source has.
    integer, parameter :: most_cards = 1024
    !> Fewer cards than this are computed by one thread.
    integer, parameter :: least_shared = 8

    !> Cards that have arrived.
    type :: batch_type
        integer :: count = 0                                    !! how many are read
        integer :: taken = 0                                    !! how many of them by a thread
        type(card_image_type) :: image(most_cards)              !! the cards
        type(fault_list_type) :: faults(most_cards)             !! met before each
        type(fault_list_type) :: last_faults                    !! met behind the last
        type(error_type), allocatable :: error                  !! the source can't be read
        logical :: is_whole = .false.                           !! no more can be had at once
        logical :: is_last = .false.                            !! the deck is at its end
        type(card_result_type) :: result(most_cards)            !! what became of them
        integer :: at(most_cards) = 0                           !! of each: which of these
        integer :: spare(most_cards) = 0                        !! those not in use
        integer :: spares = 0                                   !! how many
        integer :: is_ready(most_cards + 1) = 0                 !! 1: it is computed
        integer :: printed = 0                                  !! how many are printed
        integer :: printing = 0                                 !! 1: a thread prints
    end type batch_type

    !> A run on its way.
    type :: run_type
        type(options_type) :: options           !! what was asked for
        character(:), allocatable :: name       !! of the deck, as the user gave it
        type(conic_deck_type) :: deck           !! the deck, as far as it is read
        type(conic_listing_type) :: listing     !! the pages of an ieee listing
        integer :: exit_status = status%done    !! so far
        logical :: is_confined = .false.        !! there is no memory for a second thread
    end type run_type

contains

    !> Runs the cards of a deck whose beginning has been read. The exit status is `status%done`, or
    !> `status%faulty` where a card was in error.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read.
    subroutine run_conics(options, input, out, messages, exit_status, error)
        type(options_type), intent(in) :: options           !! mode and format
        type(deck_input_type), intent(inout) :: input       !! the deck, at its first card
        type(output_type), intent(inout) :: out             !! the result
        type(output_type), intent(inout) :: messages        !! diagnostics
        integer, intent(out) :: exit_status                 !! one of `status%...`
        type(error_type), allocatable, intent(out) :: error !! see above
        type(run_type) :: run
        type(batch_type), allocatable :: batch
        integer :: i

        run%options = options
        run%name = input%name
        run%is_confined = has_little_memory()
        run%deck%heading = input%opening%heading
        allocate (batch)
        do i = most_cards, 1, -1
            call give_result(batch, i)
        end do
        if (options%format == 'csv') call print_csv_header(out)
        do
            call begin_batch(run%deck, input%source, batch)
            call run_batch(run, input%source, batch, out, messages)
            call report_faults(run, batch%last_faults, messages)
            if (batch%is_last .or. out%has_failed()) exit
        end do
        exit_status = run%exit_status
        if (allocated(batch%error)) call fail(error, batch%error%cause, &
            input%name//': '//batch%error%message)
    end subroutine run_conics

    !> Reads the first cards of a batch: one, or the end of the deck, and as many as it takes to
    !> make threads worth their while, where so many are at hand.
    subroutine begin_batch(deck, source, batch)
        type(conic_deck_type), intent(inout) :: deck        !! the deck
        type(source_type), intent(inout) :: source          !! where its lines come from
        type(batch_type), intent(inout) :: batch            !! gets the cards

        batch%count = 0
        batch%taken = 0
        batch%printed = 0
        batch%is_ready = 0
        batch%is_whole = .false.
        do while (.not. batch%is_whole .and. batch%count < least_shared)
            call read_card(deck, source, batch)
        end do
    end subroutine begin_batch

    !> Reads a card of a batch. After the last that can be had at once the batch is whole; it is the
    !> last batch where the deck is at its end, or can't be read.
    subroutine read_card(deck, source, batch)
        type(conic_deck_type), intent(inout) :: deck        !! the deck
        type(source_type), intent(inout) :: source          !! where its lines come from
        type(batch_type), intent(inout) :: batch            !! gets the card
        type(fault_list_type) :: faults
        integer :: outcome

        call deck%next_image(source, batch%image(batch%count + 1), outcome, faults, batch%error)
        batch%is_last = allocated(batch%error) .or. outcome == found%finished
        if (batch%is_last) then
            batch%last_faults = faults
            batch%is_whole = .true.
        else
            batch%count = batch%count + 1
            if (faults%count > 0) batch%faults(batch%count) = faults
            batch%is_whole = batch%count == most_cards .or. .not. source%has_line()
        end if
    end subroutine read_card

    !> Takes the next card of a batch for a thread; 0 where there is none.
    subroutine take_card(deck, source, batch, which)
        type(conic_deck_type), intent(inout) :: deck        !! the deck
        type(source_type), intent(inout) :: source          !! where its lines come from
        type(batch_type), intent(inout) :: batch            !! the cards
        integer, intent(out) :: which                       !! of them

        which = 0
        !$omp critical (cards)
        if (batch%taken == batch%count .and. .not. batch%is_whole) &
            call read_card(deck, source, batch)
        if (batch%taken < batch%count) then
            batch%taken = batch%taken + 1
            which = batch%taken
        end if
        !$omp end critical (cards)
    end subroutine take_card

    !> Computes the cards of a batch, many side by side, and prints them in order. A card that is
    !> ready before its turn is printed by the thread that has finished the card before it, or the
    !> next one that comes; no thread waits for another.
    subroutine run_batch(run, source, batch, out, messages)
        type(run_type), intent(inout) :: run            !! the run
        type(source_type), intent(inout) :: source      !! where more cards come from
        type(batch_type), intent(inout) :: batch        !! the cards; their faults are taken
        type(output_type), intent(inout) :: out         !! the result
        type(output_type), intent(inout) :: messages    !! diagnostics
        integer :: i

        !$omp parallel default(none) shared(run, source, batch, out, messages) private(i) &
        !$omp if (.not. (batch%is_whole .or. run%is_confined))
        do
            call take_card(run%deck, source, batch, i)
            if (i == 0) exit
            call take_result(batch, batch%at(i))
            associate (it => batch%result(batch%at(i)))
                call it%faults%clear()
                if (batch%faults(i)%count > 0) it%faults = batch%faults(i)
                call batch%faults(i)%clear()
                call compute_card(run%options, batch%image(i), it)
            end associate
            !$omp atomic write release
            batch%is_ready(i) = 1
            !$omp end atomic
            call print_ready(run, batch, out, messages)
        end do
        !$omp end parallel
        call print_ready(run, batch, out, messages)
    end subroutine run_batch

    !> Takes a result that is not in use: the one given back last, whose texts still are next to a
    !> processor. Of a thousand a handful is in use where the threads keep step.
    subroutine take_result(batch, which)
        type(batch_type), intent(inout) :: batch    !! the results
        integer, intent(out) :: which               !! of them
        !$omp critical (results)
        which = batch%spare(batch%spares)
        batch%spares = batch%spares - 1
        !$omp end critical (results)
    end subroutine take_result

    !> Gives a result back.
    subroutine give_result(batch, which)
        type(batch_type), intent(inout) :: batch    !! the results
        integer, intent(in) :: which                !! of them
        !$omp critical (results)
        batch%spares = batch%spares + 1
        batch%spare(batch%spares) = which
        !$omp end critical (results)
    end subroutine give_result

    !> Prints the cards whose turn has come, unless another thread is at it.
    subroutine print_ready(run, batch, out, messages)
        type(run_type), intent(inout) :: run            !! the run
        type(batch_type), intent(inout) :: batch        !! its cards
        type(output_type), intent(inout) :: out         !! the result
        type(output_type), intent(inout) :: messages    !! diagnostics
        integer :: others, ready

        !$omp atomic capture seq_cst
        others = batch%printing
        batch%printing = 1
        !$omp end atomic
        if (others /= 0) return
        do
            !$omp atomic read acquire
            ready = batch%is_ready(batch%printed + 1)
            !$omp end atomic
            if (ready == 0) exit
            batch%printed = batch%printed + 1
            call print_card(run, batch%result(batch%at(batch%printed)), out, messages)
            call give_result(batch, batch%at(batch%printed))
        end do
        !$omp atomic write release
        batch%printing = 0
        !$omp end atomic
    end subroutine print_ready

    !> Prints what became of a card.
    subroutine print_card(run, it, out, messages)
        type(run_type), intent(inout) :: run            !! the run
        type(card_result_type), intent(inout) :: it     !! the card; its text is given up
        type(output_type), intent(inout) :: out         !! the result
        type(output_type), intent(inout) :: messages    !! diagnostics

        if (out%has_failed()) return
        if (run%options%arithmetic == 's360' .or. run%options%format == 'csv') then
            call it%text%pour(out, 1_i64, it%text%length())
        else
            if (it%count == 1) call run%listing%begin(run%deck%heading, base_name(run%name))
            call run%listing%print_block(it%block, out)
        end if
        call it%text%clear()
        call it%block%text%clear()
        call report_faults(run, it%faults, messages)
    end subroutine print_card

    !> Prints faults at once.
    subroutine report_faults(run, faults, messages)
        type(run_type), intent(inout) :: run            !! the run
        type(fault_list_type), intent(in) :: faults     !! what was met
        type(output_type), intent(inout) :: messages    !! diagnostics
        type(error_type), allocatable :: ignored

        if (faults%count == 0) return
        call print_faults(faults, run%name, .false., messages)
        call messages%flush(ignored)
        if (faults%has_errors(0)) run%exit_status = status%faulty
    end subroutine report_faults

end module app_run_conics
