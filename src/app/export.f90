!> `loft export`: a deck as a file that a workshop cuts from or a CAD system reads, and its receipt.
module app_export
    use api_computed_body, only: computed_body_type
    use app_export_body, only: draw_curves, read_bodies
    use app_export_conics, only: choose_cards, read_conics
    use app_export_parts, only: parts_type
    use app_export_request, only: read_request, request_type, settle_request
    use app_export_write, only: has_curves, has_lines, keeps_tolerance, &
        scale_parts, widest_tolerance, write_parts, write_sheets
    use app_file_set, only: file_set_type
    use app_files, only: base_name
    use app_input, only: close_input, deck_input_type, open_input, refuse_tables, spare_deck
    use app_options, only: options_type
    use app_progress, only: begin_progress, end_progress, tell_progress
    use app_status, only: status
    use base_error, only: cause, error_type, fail
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_posix, only: standard_output
    use base_text, only: printable
    use deck_kind, only: deck_kind_of
    use export_pattern_page, only: page_type
    use export_receipt, only: receipt_type
    use export_receipt_text, only: heading_type, print_receipt
    use export_svg, only: write_svg
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: export_deck

    !> Formats made of bodies, which a 1970 deck has not.
    character(*), parameter :: body_formats = ' stl obj hrm wgs csv '

    !> An export on its way.
    type :: export_type
        character(:), allocatable :: deck       !! as the user gave it; `-` is standard input
        character(:), allocatable :: output     !! as the user gave it; `-` is standard output
        type(request_type) :: request           !! what is asked for
        type(heading_type) :: heading           !! of the receipt
        type(receipt_type) :: receipt           !! what was written
        type(file_set_type) :: files            !! results, receipt
        logical :: is_loose = .false.           !! the result is no file that another stands beside
    end type export_type

contains

    !> Exports a deck. The exit status is `status%done`, or `status%faulty` where a card was in
    !> error; what is sound is then exported.
    !>
    !> Fails with `cause%usage` where the command line asks for what can't be, or there is nothing
    !> to export; with `cause%file_trouble` where a file can't be read or written; and where a shape
    !> can't be fitted. No file is then made or changed.
    subroutine export_deck(options, exit_status, messages, error)
        type(options_type), intent(in) :: options           !! deck, result, what is asked for
        integer, intent(out) :: exit_status                 !! one of `status%...`
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(export_type) :: export
        type(parts_type) :: parts

        exit_status = status%unusable
        export%deck = options%operand(1)%text
        export%output = options%output
        call read_request(options, export%request, error)
        if (allocated(error)) return
        call begin_progress()
        call tell_progress('reading the deck')
        call read_parts(export, parts, messages, error)
        if (.not. allocated(error)) then
            if (.not. is_hollow(parts)) call write_files(export, parts, error)
            if (allocated(error)) call export%files%abandon()
        end if
        call end_progress()
        if (allocated(error)) return
        if (.not. is_hollow(parts)) call show_receipt(export, messages, error)
        if (.not. allocated(error)) exit_status = merge(status%faulty, status%done, parts%is_faulty)
    end subroutine export_deck

    !> True where nothing of a deck is sound: its faults have been said, and there is nothing to
    !> write.
    pure logical function is_hollow(parts)
        type(parts_type), intent(in) :: parts !! of the deck
        is_hollow = parts%is_faulty .and. size(parts%bodies) == 0 .and. &
            size(parts%drawing%cuts) == 0
    end function is_hollow

    !> Reads the deck and makes the parts that the format is written from, in units of the file.
    !>
    !> Fails as `export_deck`.
    subroutine read_parts(export, parts, messages, error)
        type(export_type), intent(inout) :: export          !! gets units and heading
        type(parts_type), intent(out) :: parts              !! see above
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(deck_input_type) :: input
        type(fault_list_type) :: faults, later
        type(computed_body_type), allocatable :: computed(:)
        character(64) :: checksum
        real(dp) :: factor

        input%has_checksum = .true.
        call open_input(export%deck, input, faults, error)
        if (.not. allocated(error)) call refuse_tables(input, error)
        if (.not. allocated(error)) call spare_deck(export%deck, export%output, error)
        if (.not. allocated(error)) then
            call print_faults(faults, input%name, .false., messages)
            if (input%opening%kind == deck_kind_of%body) then
                call read_bodies(input, deck_name(export), computed, parts, later, error)
                call print_faults(later, input%name, .false., messages)
            else
                call read_conics(input, deck_name(export), parts, messages, error)
            end if
            parts%is_faulty = parts%is_faulty .or. faults%has_errors(0)
        end if
        if (.not. allocated(error)) call input%source%read_checksum(checksum, error)
        call close_input(input)
        if (.not. allocated(error)) &
            call settle_request(export%request, parts%drawing%units, factor, error)
        if (.not. allocated(error)) call refuse_bodies(export%request, parts, error)
        if (allocated(error)) return
        if (.not. parts%is_body_deck) then
            call choose_cards(export%request, parts, error)
        else if (has_curves(export%request)) then
            call draw_curves(computed, export%request, has_lines(export%request), parts, error)
        end if
        if (export%request%settings%has_arcs .and. .not. allocated(error)) &
            parts%drawing%cuts%arcs = export%request%tolerance
        if (.not. allocated(error)) call scale_parts(export%request, factor, parts)
        export%heading%deck = deck_name(export)
        export%heading%checksum = checksum
        export%heading%units = export%request%units
        if (keeps_tolerance(export%request, parts)) &
            export%heading%tolerance = widest_tolerance(export%request, parts)
        export%heading%files = ''
    end subroutine read_parts

    !> Fails with `cause%usage` where a format is made of bodies and a deck has none.
    pure subroutine refuse_bodies(request, parts, error)
        type(request_type), intent(in) :: request           !! the format
        type(parts_type), intent(in) :: parts               !! of the deck
        type(error_type), allocatable, intent(out) :: error !! see above

        if (index(body_formats, ' '//request%format//' ') == 0) return
        if (.not. parts%is_body_deck) then
            call fail(error, cause%usage, 'a 1970 deck has no body, and '//request%format// &
                ' is made of bodies; its curves go with: svg pdf dxf iges step nc')
        else if (size(parts%bodies) == 0 .and. .not. parts%is_faulty) then
            if (size(parts%panels) > 0 .and. index(' stl obj ', request%format) > 0) return
            call fail(error, cause%usage, 'the deck has no section, and '//request%format// &
                ' is made of sections; it takes a SECTION card')
        end if
    end subroutine refuse_bodies

    !> The name of the deck for people.
    pure function deck_name(export) result(name)
        type(export_type), intent(in) :: export !! the deck as the user gave it
        character(:), allocatable :: name
        name = base_name(export%deck)
        if (name == '-') name = 'standard input'
    end function deck_name

    !> Writes the result, or several, and the receipt; all get their names, or none.
    !>
    !> Fails as `export_deck`; the files must then be given up.
    subroutine write_files(export, parts, error)
        type(export_type), intent(inout) :: export          !! gets receipt and files
        type(parts_type), intent(in) :: parts               !! in units of the file
        type(error_type), allocatable, intent(out) :: error !! see above
        type(output_type) :: out, paper

        if (export%request%format == 'svg') then
            call write_pages(export, parts, error)
        else
            call begin_result(export, export%output, out, error)
            if (allocated(error)) return
            call write_parts(export%request, parts, out, export%receipt, error)
            if (.not. allocated(error)) call export%files%finish(out, error)
        end if
        if (allocated(error)) return
        if (.not. export%is_loose) then
            call spare_deck(export%deck, export%output//'.receipt', error)
            if (.not. allocated(error)) &
                call export%files%begin(export%output//'.receipt', paper, error)
            if (allocated(error)) return
            call print_receipt(export%heading, export%receipt, paper)
            call export%files%finish(paper, error)
        end if
        if (.not. allocated(error)) call export%files%publish(error)
    end subroutine write_files

    !> Begins a result.
    !>
    !> Fails with `cause%usage` where it would replace the deck, and with `cause%file_trouble`.
    subroutine begin_result(export, name, out, error)
        type(export_type), intent(inout) :: export          !! gets the file
        character(*), intent(in) :: name                    !! of the file
        type(output_type), intent(inout) :: out             !! will go there
        type(error_type), allocatable, intent(out) :: error !! see above

        call spare_deck(export%deck, name, error)
        if (.not. allocated(error)) call export%files%begin(name, out, error)
        if (allocated(error)) return
        export%is_loose = export%files%is_device()
        export%heading%files = export%heading%files// &
            printable(base_name(name))//new_line('a')
    end subroutine begin_result

    !> Writes sheets as files of SVG.
    !>
    !> Fails as `export_deck`.
    subroutine write_pages(export, parts, error)
        type(export_type), intent(inout) :: export          !! gets receipt and files
        type(parts_type), intent(in) :: parts               !! in units of the file
        type(error_type), allocatable, intent(out) :: error !! see above
        type(page_type), allocatable :: pages(:)
        integer :: i

        allocate (pages(0))
        call write_sheets(export%request, parts, pages, export%receipt, error)
        if (allocated(error)) return
        do i = 1, size(pages)
            call write_page(export, pages(i), error)
            if (allocated(error)) return
        end do
    end subroutine write_pages

    !> Writes a sheet as a file; where there can be several, its name stands behind that of the
    !> result.
    !>
    !> Fails as `begin_result`.
    subroutine write_page(export, page, error)
        type(export_type), intent(inout) :: export          !! gets the file
        type(page_type), intent(in) :: page                 !! the sheet
        type(error_type), allocatable, intent(out) :: error !! see above
        type(output_type) :: out
        character(:), allocatable :: name
        integer :: point

        name = export%output
        point = index(name, '.', back=.true.)
        if (point <= index(name, '/', back=.true.) + 1) point = len(name) + 1
        if (export%request%settings%is_each .or. export%request%settings%paper /= '') &
            name = name(:point - 1)//'-'//page%name//name(point:)
        call begin_result(export, name, out, error)
        if (allocated(error)) return
        call write_svg(page, out)
        call export%files%finish(out, error)
    end subroutine write_page

    !> Prints the receipt on standard output, or, where the result may have gone there, on standard
    !> error.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine show_receipt(export, messages, error)
        type(export_type), intent(in) :: export             !! done
        type(output_type), intent(inout) :: messages        !! standard error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(output_type) :: answer

        if (export%is_loose) then
            call print_receipt(export%heading, export%receipt, messages)
            return
        end if
        call answer%attach(standard_output)
        call print_receipt(export%heading, export%receipt, answer)
        call answer%flush(error)
    end subroutine show_receipt

end module app_export
