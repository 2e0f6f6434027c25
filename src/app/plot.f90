!> `loft plot`: a deck as pictures, in a folder.
module app_plot
    use app_files, only: base_name
    use app_input, only: close_input, deck_input_type, open_input
    use app_options, only: options_type
    use app_picture_folder, only: draw_pictures, folder_type
    use app_plot_audit, only: plot_audit
    use app_plot_body, only: plot_body
    use app_plot_conics, only: plot_conics
    use app_status, only: status
    use base_error, only: cause, error_type, fail
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use deck_kind, only: deck_kind_of
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: plot_deck, default_folder

contains

    !> Draws a deck. The exit status is `status%done`, or `status%faulty` where a card was in error.
    !>
    !> Fails with `cause%usage` where the folder is `-`, and with `cause%file_trouble` where the
    !> deck can't be read, a file not be written, or gnuplot is missing or fails. Data and scripts
    !> need no gnuplot.
    subroutine plot_deck(options, exit_status, messages, error)
        type(options_type), intent(in) :: options           !! deck, folder, format
        integer, intent(out) :: exit_status                 !! one of `status%...`
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(folder_type) :: folder
        type(deck_input_type) :: input
        type(fault_list_type) :: faults
        logical :: is_faulty

        exit_status = status%unusable
        call settle(options, folder, error)
        if (allocated(error)) return
        call open_input(options%operand(1)%text, input, faults, error)
        if (.not. allocated(error)) then
            call print_faults(faults, input%name, .false., messages)
            if (input%opening%kind == deck_kind_of%body) then
                call plot_body(input, folder, is_faulty, messages, error)
            else if (input%opening%kind >= deck_kind_of%audit) then
                call plot_audit(input, folder, is_faulty, messages, error)
            else
                call plot_conics(input, folder, is_faulty, messages, error)
            end if
        end if
        call close_input(input)
        if (.not. allocated(error)) call draw_pictures(folder, error)
        if (allocated(error)) return
        exit_status = merge(status%faulty, status%done, is_faulty .or. faults%has_errors(0))
    end subroutine plot_deck

    !> Settles what the command line leaves open: svg; the deck's name without its ending and
    !> `-plots`.
    !>
    !> Fails with `cause%usage`.
    pure subroutine settle(options, folder, error)
        type(options_type), intent(in) :: options           !! the command line
        type(folder_type), intent(inout) :: folder          !! gets path and format
        type(error_type), allocatable, intent(out) :: error !! see above

        allocate (folder%picture(0))
        folder%format = options%format
        if (folder%format == '') folder%format = 'svg'
        folder%path = options%output
        if (folder%path == '-') then
            call fail(error, cause%usage, '-o -: pictures go to a folder; give its name')
        else if (folder%path == '') then
            folder%path = default_folder(options%operand(1)%text)
        end if
    end subroutine settle

    !> The folder for the pictures of a deck where none is named.
    pure function default_folder(deck) result(folder)
        character(*), intent(in) :: deck !! its name
        character(:), allocatable :: folder
        integer :: point

        folder = base_name(deck)
        point = index(folder, '.', back=.true.)
        if (point > 1) folder = folder(:point - 1)
        if (deck == '-') folder = 'loft'
        folder = folder//'-plots'
    end function default_folder

end module app_plot
