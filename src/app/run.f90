!> `loft run`: a deck in, its tables out.
module app_run
    use app_files, only: result_file_type
    use app_input, only: close_input, deck_input_type, open_input, refuse_tables, spare_deck
    use app_options, only: options_type
    use app_run_body, only: run_body_deck
    use app_run_conics, only: run_conics
    use app_status, only: status
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use deck_kind, only: deck_kind_of
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: run_deck

contains

    !> Runs a deck. The exit status is `status%done`, or `status%faulty` where a card was in error.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read or the result not be written,
    !> and with `cause%usage` where the result would take the place of the deck.
    subroutine run_deck(options, exit_status, messages, error)
        type(options_type), intent(in) :: options           !! deck, mode, format, result
        integer, intent(out) :: exit_status                 !! one of `status%...`
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(deck_input_type) :: input
        type(result_file_type) :: result_file
        type(output_type) :: out
        type(fault_list_type) :: faults
        character(:), allocatable :: name
        integer :: status_of_run

        name = '-'
        if (size(options%operand) > 0) name = options%operand(1)%text
        exit_status = status%unusable
        call open_input(name, input, faults, error)
        if (.not. allocated(error)) call refuse_tables(input, error)
        if (.not. allocated(error)) call spare_deck(name, options%output, error)
        if (.not. allocated(error)) call result_file%begin(options%output, out, error)
        if (.not. allocated(error)) then
            call print_faults(faults, name, .false., messages)
            if (input%opening%kind == deck_kind_of%body) then
                call run_body_deck(options, input, out, messages, status_of_run, error)
            else
                call run_conics(options, input, out, messages, status_of_run, error)
            end if
            if (faults%has_errors(0)) status_of_run = status%faulty
        end if
        call close_input(input)
        if (allocated(error)) then
            call result_file%abandon()
        else
            call result_file%complete(out, error)
        end if
        if (.not. allocated(error)) exit_status = status_of_run
    end subroutine run_deck

end module app_run
