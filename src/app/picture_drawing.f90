!> A drawing as files in a folder of pictures.
module app_picture_drawing
    use app_files, only: result_file_type
    use app_picture_folder, only: add_picture, folder_type
    use base_error, only: error_type
    use base_output, only: output_type
    use export_body_drawing, only: drawing_type
    use export_body_gnuplot, only: print_drawing_data, print_drawing_script
    implicit none (type, external)
    private

    public :: write_drawing

contains

    !> Writes data and script of a drawing, where there is something on it.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine write_drawing(drawing, name, folder, error)
        type(drawing_type), intent(in) :: drawing           !! what is drawn
        character(*), intent(in) :: name                    !! of its files
        type(folder_type), intent(inout) :: folder          !! gets it
        type(error_type), allocatable, intent(out) :: error !! see above
        type(result_file_type) :: data_file, script_file
        type(output_type) :: data, script
        type(drawing_type) :: named

        if (drawing%layers == 0) return
        named = drawing
        named%name = name
        call data_file%begin(folder%path//'/'//name//'.dat', data, error)
        if (allocated(error)) return
        call print_drawing_data(named, data)
        call data_file%complete(data, error)
        if (allocated(error)) return
        call script_file%begin(folder%path//'/'//name//'.gp', script, error)
        if (allocated(error)) return
        call print_drawing_script(named, folder%format, script)
        call script_file%complete(script, error)
        if (.not. allocated(error)) call add_picture(folder, name)
    end subroutine write_drawing

end module app_picture_drawing
