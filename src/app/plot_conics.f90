!> The pictures of a 1970 deck: side view, plan view, sections, and what has no such name.
module app_plot_conics
    use app_files, only: result_file_type
    use app_input, only: deck_input_type
    use app_picture_folder, only: add_picture, begin_folder, folder_type
    use app_pictures, only: read_pictures
    use base_error, only: error_type
    use base_output, only: output_type
    use export_gnuplot_data, only: print_gnuplot_data
    use export_gnuplot_script, only: print_gnuplot_script
    use export_picture, only: frame_of, frame_type, picture_type
    implicit none (type, external)
    private

    public :: plot_conics

    !> The scripts that those of the pictures load.
    character(*), parameter :: shared_scripts(2) = [character(9) :: 'style.gp', 'curves.gp']

contains

    !> Reads a 1970 deck and writes data and scripts of its pictures.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read or a file not be written.
    subroutine plot_conics(input, folder, is_faulty, messages, error)
        type(deck_input_type), intent(inout) :: input       !! the deck, at its first card
        type(folder_type), intent(inout) :: folder          !! gets the pictures
        logical, intent(out) :: is_faulty                   !! a card was in error
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(picture_type) :: pictures(4)
        integer :: i

        call read_pictures(input, pictures, is_faulty, messages, error)
        if (allocated(error) .or. all(pictures%count == 0)) return
        call begin_folder(folder, shared_scripts, error)
        do i = 1, size(pictures)
            if (allocated(error)) return
            if (pictures(i)%count > 0) call write_picture(pictures(i), folder, error)
        end do
    end subroutine plot_conics

    !> Writes data and script of a picture.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine write_picture(picture, folder, error)
        type(picture_type), intent(in) :: picture           !! the picture
        type(folder_type), intent(inout) :: folder          !! gets it
        type(error_type), allocatable, intent(out) :: error !! see above
        type(result_file_type) :: data_file, script_file
        type(output_type) :: data, script
        type(frame_type) :: frame

        frame = frame_of(picture)
        call data_file%begin(folder%path//'/'//picture%name//'.dat', data, error)
        if (allocated(error)) return
        call print_gnuplot_data(picture, frame, data)
        call data_file%complete(data, error)
        if (allocated(error)) return
        call script_file%begin(folder%path//'/'//picture%name//'.gp', script, error)
        if (allocated(error)) return
        call print_gnuplot_script(picture, frame, folder%format, script)
        call script_file%complete(script, error)
        if (.not. allocated(error)) call add_picture(folder, picture%name)
    end subroutine write_picture

end module app_plot_conics
