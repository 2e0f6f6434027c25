!> The parts of a deck brought to the unit of the file and handed to the writer of the format.
module app_export_write
    use app_export_parts, only: parts_type
    use app_export_request, only: request_type
    use app_option_table, only: is_one_of
    use app_progress, only: tell_progress
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: to_text
    use export_cpacs, only: write_cpacs
    use export_drawing_name, only: safe_name
    use export_drawing_scale, only: scaled_drawing
    use export_dxf, only: write_dxf
    use export_hrm, only: write_hrm
    use export_iges, only: write_iges
    use export_mesh, only: mesh_type, scale_mesh
    use export_mesh_build, only: build_mesh, build_panel_mesh
    use export_mesh_merge, only: append_mesh
    use export_network, only: networks_type, scale_networks
    use export_network_build, only: build_networks
    use export_nc, only: write_nc
    use export_obj, only: write_obj
    use export_pattern, only: lay_out
    use export_pattern_page, only: page_type
    use export_pdf, only: write_pdf
    use export_receipt, only: receipt_type
    use export_settings, only: settings_type
    use export_shell, only: skin_model_type
    use export_shell_build, only: build_shell, scale_shell
    use export_shell_duct, only: shell_of_duct
    use export_shell_merge, only: append_model
    use export_shell_patch, only: shell_of_patch
    use export_step, only: write_step
    use export_stl, only: write_stl
    use export_wgs, only: write_wgs
    implicit none (type, external)
    private

    public :: has_curves, has_lines, keeps_tolerance, widest_tolerance, scale_parts
    public :: write_parts, write_sheets

contains

    !> True for a format that has cuts in it.
    pure logical function has_curves(request)
        type(request_type), intent(in) :: request !! the format
        has_curves = is_one_of(request%format, 'svg pdf dxf iges step nc')
    end function has_curves

    !> True for a format that has control lines in it: those where things stand in space.
    pure logical function has_lines(request)
        type(request_type), intent(in) :: request !! the format
        has_lines = is_one_of(request%format, 'iges step') .or. request%settings%is_in_space
    end function has_lines

    !> True for a file that is within the tolerance: all but sections at the stations of the deck.
    pure logical function keeps_tolerance(request, parts)
        type(request_type), intent(in) :: request   !! the format
        type(parts_type), intent(in) :: parts       !! the stations
        keeps_tolerance = .not. is_one_of(request%format, 'hrm wgs csv') .or. &
            request%has_tolerance .or. size(parts%stations) == 0
    end function keeps_tolerance

    !> The tolerance that all of a file keeps: that asked for, or that of an ARCS card where it is
    !> larger.
    pure real(dp) function widest_tolerance(request, parts) result(tolerance)
        type(request_type), intent(in) :: request   !! settled
        type(parts_type), intent(in) :: parts       !! in units of the file
        tolerance = request%settings%tolerance
        if (is_one_of(request%format, 'dxf nc') .and. .not. request%settings%is_in_space) &
            tolerance = max(tolerance, maxval([0.0_dp, parts%drawing%cuts%arcs]))
    end function widest_tolerance

    !> Brings the curves of a deck to the unit of the file.
    pure subroutine scale_parts(request, factor, parts)
        type(request_type), intent(in) :: request           !! the unit
        real(dp), intent(in) :: factor                      !! units of the file in one of the deck
        type(parts_type), intent(inout) :: parts            !! the curves; bodies stay as they are
        parts%drawing = scaled_drawing(parts%drawing, factor, request%units)
        parts%factor = factor
    end subroutine scale_parts

    !> Lays the cuts of a deck out on sheets.
    !>
    !> Fails as `lay_out`.
    subroutine write_sheets(request, parts, pages, receipt, error)
        type(request_type), intent(in) :: request               !! sheets, paper
        type(parts_type), intent(in) :: parts                   !! in units of the file
        type(page_type), allocatable, intent(out) :: pages(:)   !! the sheets
        type(receipt_type), intent(inout) :: receipt            !! gets what is on them
        type(error_type), allocatable, intent(out) :: error     !! see above
        call tell_progress('laying out the sheets')
        call lay_out(parts%drawing, request%settings, pages, receipt, error)
    end subroutine write_sheets

    !> Writes the file of any format but SVG.
    !>
    !> Fails as its writer.
    subroutine write_parts(request, parts, out, receipt, error)
        type(request_type), intent(in) :: request           !! format and settings
        type(parts_type), intent(in) :: parts               !! in units of the file
        type(output_type), intent(inout) :: out             !! where it goes
        type(receipt_type), intent(inout) :: receipt        !! gets what is in it
        type(error_type), allocatable, intent(out) :: error !! see above
        type(page_type), allocatable :: pages(:)

        select case (request%format)
        case ('pdf')
            allocate (pages(0))
            call write_sheets(request, parts, pages, receipt, error)
            if (.not. allocated(error)) call write_pdf(pages, out, error)
        case ('dxf')
            call write_dxf(parts%drawing, request%settings, out, receipt, error)
        case ('nc')
            call write_nc(parts%drawing, request%settings, out, receipt, error)
        case ('iges', 'step')
            call write_skin(request, parts, out, receipt, error)
        case ('stl', 'obj')
            call write_mesh(request, parts, out, receipt, error)
        case default
            call write_sections(request, parts, out, receipt, error)
        end select
    end subroutine write_parts

    !> Writes curves and skin as a CAD file.
    !>
    !> Fails where a skin can't be fitted, and as the writer.
    subroutine write_skin(request, parts, out, receipt, error)
        type(request_type), intent(in) :: request           !! IGES or STEP
        type(parts_type), intent(in) :: parts               !! in units of the file
        type(output_type), intent(inout) :: out             !! where it goes
        type(receipt_type), intent(inout) :: receipt        !! gets what is in it
        type(error_type), allocatable, intent(out) :: error !! see above
        type(skin_model_type) :: model

        call build_model(request, parts, model, error)
        if (allocated(error)) return
        call tell_progress('writing')
        if (request%format == 'iges') then
            call write_iges(parts%drawing, model, request%settings, out, receipt, error)
        else
            call write_step(parts%drawing, model, request%settings, out, receipt, error)
        end if
    end subroutine write_skin

    !> The skins of all bodies as surfaces, in units of the file.
    !>
    !> Fails where a skin can't be fitted.
    subroutine build_model(request, parts, model, error)
        type(request_type), intent(in) :: request           !! tolerance; open or closed
        type(parts_type), intent(in) :: parts               !! the bodies
        type(skin_model_type), intent(out) :: model         !! faces may be none
        type(error_type), allocatable, intent(out) :: error !! see above
        type(skin_model_type) :: skin
        integer :: i, k

        allocate (skin%vertices(0), skin%edges(0), skin%faces(0), skin%shells(0))
        call append_model(model, skin)
        do i = 1, size(parts%bodies)
            call tell_progress('fitting the skin of body '//to_text(i)//' of '// &
                to_text(size(parts%bodies)))
            call build_shell(parts%bodies(i), request%tolerance, &
                .not. request%settings%is_open, skin, error)
            if (allocated(error)) return
            do k = 1, size(skin%faces)
                skin%faces(k)%name = name_in(parts, i, skin%faces(k)%name)
            end do
            skin%shells%name = name_in(parts, i, 'SKIN')
            call append_model(model, skin)
        end do
        do i = 1, size(parts%panels)
            if (parts%panels(i)%is_round) then
                call shell_of_duct(parts%panels(i), skin)
            else
                call shell_of_patch(parts%panels(i), skin)
            end if
            call append_model(model, skin)
        end do
        call scale_shell(model, parts%factor)
    end subroutine build_model

    !> The name of a part of a body: of several bodies the body's name stands before it.
    pure function name_in(parts, number, name) result(full)
        type(parts_type), intent(in) :: parts   !! the bodies
        integer, intent(in) :: number           !! which body
        character(*), intent(in) :: name        !! of the part
        character(:), allocatable :: full
        full = name
        if (size(parts%bodies) == 1) return
        full = trim(parts%bodies(number)%name)
        if (full == '') full = 'BODY '//to_text(number)
        full = full//' '//name
    end function name_in

    !> Writes the bodies as triangles.
    !>
    !> Fails where a mesh can't be made.
    subroutine write_mesh(request, parts, out, receipt, error)
        type(request_type), intent(in) :: request           !! STL or OBJ
        type(parts_type), intent(in) :: parts               !! the bodies
        type(output_type), intent(inout) :: out             !! where it goes
        type(receipt_type), intent(inout) :: receipt        !! gets what is in it
        type(error_type), allocatable, intent(out) :: error !! see above
        type(mesh_type) :: mesh, skin
        integer :: i, k

        do i = 1, size(parts%bodies)
            call tell_progress('triangles of body '//to_text(i)//' of '// &
                to_text(size(parts%bodies)))
            call build_mesh(parts%bodies(i), deck_settings(request), skin, error, &
                pack(parts%panels, parts%owner == i))
            if (allocated(error)) return
            do k = 1, size(skin%parts)
                skin%parts(k)%name = name_in(parts, i, skin%parts(k)%name)
            end do
            call append_mesh(mesh, skin)
        end do
        call build_panel_mesh(pack(parts%panels, parts%owner == 0), deck_settings(request), skin, &
            error)
        if (allocated(error)) return
        if (skin%triangle_count > 0) call append_mesh(mesh, skin)
        mesh%deck = parts%drawing%deck
        mesh%title = parts%drawing%title
        call scale_mesh(mesh, parts%factor, request%units)
        call tell_progress('writing')
        if (request%format == 'stl') then
            call write_stl(mesh, request%settings%is_binary, out, receipt)
        else
            call write_obj(mesh, out, receipt)
        end if
    end subroutine write_mesh

    !> Writes the bodies as sections for design tools.
    !>
    !> Fails where networks can't be made.
    subroutine write_sections(request, parts, out, receipt, error)
        type(request_type), intent(in) :: request           !! HRM, WGS or CSV
        type(parts_type), intent(in) :: parts               !! the bodies, the stations
        type(output_type), intent(inout) :: out             !! where it goes
        type(receipt_type), intent(inout) :: receipt        !! gets what is in it
        type(error_type), allocatable, intent(out) :: error !! see above
        type(networks_type) :: networks, of_body
        integer :: i, k

        allocate (networks%list(0))
        do i = 1, size(parts%bodies)
            call tell_progress('sections of body '//to_text(i)//' of '// &
                to_text(size(parts%bodies)))
            call build_networks(parts%bodies(i), stations_for(request, parts, i), &
                deck_settings(request), request%format /= 'wgs', of_body, error)
            if (allocated(error)) return
            do k = 1, size(of_body%list)
                if (request%format == 'wgs') &
                    of_body%list(k)%name = name_in(parts, i, of_body%list(k)%name)
                of_body%list(k)%name = safe_name(of_body%list(k)%name)
            end do
            networks%list = [networks%list, of_body%list]
            networks%is_by_deck = of_body%is_by_deck
        end do
        if (size(parts%panels) > 0) call receipt%say( &
            'PATCH and DUCT are not in this file; IGES, STEP, STL and OBJ have them')
        networks%deck = parts%drawing%deck
        networks%title = parts%drawing%title
        call scale_networks(networks, parts%factor, request%units)
        select case (request%format)
        case ('hrm')
            call write_hrm(networks, out, receipt)
        case ('wgs')
            call write_wgs(networks, out, receipt)
        case default
            call write_cpacs(networks, out, receipt, error)
        end select
    end subroutine write_sections

    !> The stations at which a body is cut for design tools: those of the deck, or none where they
    !> are to be chosen for the tolerance.
    pure function stations_for(request, parts, number) result(stations)
        type(request_type), intent(in) :: request   !! has a tolerance, or not
        type(parts_type), intent(in) :: parts       !! the stations of the deck
        integer, intent(in) :: number               !! which body
        real(dp), allocatable :: stations(:)

        allocate (stations(0))
        if (request%has_tolerance) return
        stations = pack(parts%stations%sta, parts%stations%body == number)
    end function stations_for

    !> The settings with the tolerance in units of the deck.
    pure type(settings_type) function deck_settings(request) result(settings)
        type(request_type), intent(in) :: request !! settled
        settings = request%settings
        settings%tolerance = request%tolerance
    end function deck_settings

end module app_export_write
