!> The pictures of a deck of printed tables: of each table what its figures are off.
module app_plot_audit
    use app_audit_drawing, only: residual_drawing
    use app_files, only: base_name
    use app_input, only: deck_input_type
    use app_picture_drawing, only: write_drawing
    use app_picture_folder, only: begin_folder, folder_type
    use app_picture_name, only: safe_word
    use audit_cross, only: table_title
    use audit_deck, only: audit_the_deck, deck_audit_type
    use audit_reading, only: sort
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use base_text, only: row_of, to_text
    use deck_audit, only: audit_deck_type
    use deck_audit_file, only: read_tables
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: plot_audit

    !> The scripts that those of the pictures load.
    character(*), parameter :: shared_scripts(3) = [character(10) :: 'style.gp', 'strokes.gp', &
        'chart.gp']

contains

    !> Reads a deck of printed tables and writes data and scripts of its pictures.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read or a file not be written.
    subroutine plot_audit(input, folder, is_faulty, messages, error)
        type(deck_input_type), intent(inout) :: input       !! the deck, at its first card
        type(folder_type), intent(inout) :: folder          !! gets the pictures
        logical, intent(out) :: is_faulty                   !! a card was in error
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(audit_deck_type) :: deck
        type(deck_audit_type) :: found
        type(fault_list_type) :: faults
        character(:), allocatable :: heading
        integer :: i, sorts

        is_faulty = .false.
        call read_tables(input%source, input%opening, deck, faults, error)
        if (allocated(error)) then
            error%message = input%name//': '//error%message
            return
        end if
        call print_faults(faults, input%name, .false., messages)
        is_faulty = faults%has_errors(0)
        if (deck%count == 0) return
        call audit_the_deck(deck, found)
        heading = deck%title
        if (heading == '') heading = base_name(input%name)
        call begin_folder(folder, shared_scripts, error)
        do i = 1, size(found%item)
            if (.not. found%item(i)%is_audited) cycle
            do sorts = sort%ordinate, sort%abscissa
                if (.not. allocated(error)) call write_drawing(residual_drawing(found%item(i), &
                    sorts, heading, deck%units), picture_name(i, found, sorts), folder, error)
            end do
        end do
    end subroutine plot_audit

    !> The name of the files of a picture: `audit-01-mhb-side`, `audit-08-sta10-station-10-y`.
    pure function picture_name(i, found, sorts) result(name)
        integer, intent(in) :: i                    !! which table
        type(deck_audit_type), intent(in) :: found  !! the audit
        integer, intent(in) :: sorts                !! `sort%ordinate` or `sort%abscissa`
        character(:), allocatable :: name

        name = to_text(i)
        name = 'audit-'//row_of('0', 2 - len(name))//name//'-'//safe_word(table_title( &
            found%item(i)))
        if (name(len(name):) == '.') name = name(:len(name) - 1)
        if (sorts == sort%abscissa) name = name//'-y'
    end function picture_name

end module app_plot_audit
