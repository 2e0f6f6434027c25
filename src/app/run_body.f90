!> A body deck run: read whole, each body built and cut, then printed. All faults of the deck are
!> collected; what is sound runs.
module app_run_body
    use api_computed_body, only: compute_body, computed_body_type, how_type, judge_body
    use app_files, only: base_name
    use app_input, only: deck_input_type
    use app_options, only: options_type
    use app_status, only: status
    use base_error, only: cause, error_type, fail
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use body_faired, only: faired_views
    use cut_faired, only: faired_cut, measured_cut, points_around
    use cut_outline, only: cut_type
    use deck_job, only: job_type
    use deck_job_reader, only: read_job
    use report_body_listing, only: body_listing_type
    use report_cut_csv, only: print_cut_csv, print_cut_csv_header
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: run_body_deck

contains

    !> Runs a body deck. The exit status is `status%done`, or `status%faulty` where a card was in
    !> error or a clearance is too small.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read, and with `cause%usage` where
    !> the arithmetic of 1970 is asked for.
    subroutine run_body_deck(options, input, out, messages, exit_status, error)
        type(options_type), intent(in) :: options           !! format
        type(deck_input_type), intent(inout) :: input       !! the deck, at its first card
        type(output_type), intent(inout) :: out             !! the result
        type(output_type), intent(inout) :: messages        !! diagnostics
        integer, intent(out) :: exit_status                 !! one of `status%...`
        type(error_type), allocatable, intent(out) :: error !! see above
        type(fault_list_type) :: faults
        type(job_type) :: job

        exit_status = status%unusable
        if (options%arithmetic == 's360') then
            call fail(error, cause%usage, input%name//' is a body deck; --arithmetic s360 runs '// &
                '1970 decks only')
            return
        end if
        call read_job(input%source, input%opening%heading, job, faults, error)
        if (allocated(error)) then
            error%message = input%name//': '//error%message
            return
        end if
        if (options%format == 'csv') then
            call print_csv(job, out, faults)
        else
            call print_listing(job, base_name(input%name), out, faults)
        end if
        call print_faults(faults, input%name, .false., messages)
        exit_status = merge(status%faulty, status%done, faults%has_errors(0))
    end subroutine run_body_deck

    !> Prints the points of all cuts.
    subroutine print_csv(job, out, faults)
        type(job_type), intent(in) :: job               !! what the deck asks for
        type(output_type), intent(inout) :: out         !! where it goes
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(computed_body_type) :: computed
        type(cut_type) :: cut
        type(error_type), allocatable :: error
        integer :: i, k, number

        call print_cut_csv_header(out)
        number = 0
        do i = 1, size(job%body)
            call judge_body(job, i, computed, faults, how_type(is_shared=.true.))
            do k = 1, size(computed%cuts)
                number = number + 1
                call print_cut_csv(number, computed%cuts(k), computed%sections, out)
            end do
            do k = 1, size(computed%outlines)
                number = number + 1
                call faired_cut(computed%outlines(k), points_around, cut, error)
                if (allocated(error)) cycle
                call print_cut_csv(number, cut, [computed%outlines(k)%name], out)
            end do
        end do
    end subroutine print_csv

    !> Prints the listing: title page, then body by body.
    subroutine print_listing(job, deck_name, out, faults)
        type(job_type), intent(in) :: job               !! what the deck asks for
        character(*), intent(in) :: deck_name           !! without folders
        type(output_type), intent(inout) :: out         !! where it goes
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(body_listing_type) :: listing
        type(computed_body_type) :: computed
        type(cut_type) :: measured
        integer :: i, k

        call listing%begin(job, deck_name, out)
        do i = 1, size(job%body)
            call compute_body(job, i, computed, faults, how_type(is_shared=.true.))
            call listing%print_body_head(computed%body, computed%joints, out)
            call listing%print_faired_lines(faired_views(job%body(i), computed%body%lines), out)
            call listing%print_body_ring(computed%body, computed%ring, out)
            call listing%print_body_patches(computed%panels, out)
            call listing%print_body_ducts(computed%ducts, computed%duct_measures, out)
            call listing%print_offset_tables(computed%heights, computed%half_breadths, &
                computed%sections, out)
            call listing%print_body_measures(computed%measure, out)
            call listing%print_body_clearances(computed%clearances, out)
            do k = 1, size(computed%cuts)
                call listing%print_body_cut(computed%cuts(k), computed%sections, out)
                call listing%print_body_arcs(computed%cuts(k), computed%arcs(k)%tables, out)
            end do
            do k = 1, size(computed%outlines)
                call listing%print_body_outline(computed%outlines(k), out)
                measured = measured_cut(computed%outlines(k))
                call listing%print_body_arcs(measured, computed%outline_arcs(k)%tables, out)
            end do
        end do
    end subroutine print_listing

end module app_run_body
