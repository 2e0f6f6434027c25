!> `loft plot`: the arcs of a deck as pictures. A folder gets data and script of each picture, the
!> scripts these load, and what gnuplot draws; it needs nothing outside itself, so that it can be
!> moved or sent and its pictures be drawn again.
module app_plot
    use app_files, only: base_name, deck_file_type, make_folder, result_file_type
    use app_gnuplot, only: draw, folder_word, has_gnuplot
    use app_options, only: options_type
    use app_pictures, only: read_pictures
    use app_share, only: find_scripts
    use app_status, only: status
    use base_error, only: cause, error_type, fail
    use base_output, only: output_type
    use base_posix, only: standard_output
    use deck_source, only: line_type, source_type
    use export_gnuplot_data, only: print_gnuplot_data
    use export_gnuplot_script, only: print_gnuplot_script
    use export_picture, only: frame_of, frame_type, picture_type
    implicit none (type, external)
    private

    public :: plot_deck

    !> The scripts that those of the pictures load.
    character(*), parameter :: shared_scripts(2) = [character(9) :: 'style.gp', 'curves.gp']

    !> What is to be done.
    type :: plot_type
        character(:), allocatable :: deck   !! name as the user gave it; `-` is standard input
        character(:), allocatable :: folder !! where the files go
        character(:), allocatable :: format !! svg, pdf, png or txt
        type(picture_type) :: picture(4)    !! the pictures; those without curves are not made
    end type plot_type

contains

    !> Draws a deck. The exit status is `status%done`, or `status%faulty` where a card was in error.
    !>
    !> Fails with `cause%usage` where the folder is `-`, and with `cause%file_trouble` where
    !> the deck can't be read, a file not be written, or gnuplot is missing or fails. Data and
    !> scripts need no gnuplot.
    subroutine plot_deck(options, exit_status, messages, error)
        type(options_type), intent(in) :: options           !! deck, folder, format
        integer, intent(out) :: exit_status                 !! one of `status%...`
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(plot_type) :: plot
        logical :: is_faulty

        exit_status = status%unusable
        call settle(options, plot, error)
        if (allocated(error)) return
        call read_pictures(plot%deck, plot%picture, is_faulty, messages, error)
        if (allocated(error)) return
        if (any(plot%picture%count > 0)) then
            call write_files(plot, error)
            if (.not. allocated(error)) call draw_pictures(plot, error)
            if (allocated(error)) return
        end if
        exit_status = merge(status%faulty, status%done, is_faulty)
    end subroutine plot_deck

    !> Settles what the command line leaves open: svg; the deck's name without its ending and
    !> `-plots`.
    !>
    !> Fails with `cause%usage`.
    pure subroutine settle(options, plot, error)
        type(options_type), intent(in) :: options           !! the command line
        type(plot_type), intent(inout) :: plot              !! gets deck, folder and format
        type(error_type), allocatable, intent(out) :: error !! see above

        plot%format = options%format
        if (plot%format == '') plot%format = 'svg'
        plot%folder = options%output
        if (plot%folder == '-') then
            call fail(error, cause%usage, '-o -: pictures go to a folder; give its name')
        else
            plot%deck = options%operand(1)%text
            if (plot%folder == '') plot%folder = default_folder(plot%deck)
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

    !> Writes everything but the pictures.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine write_files(plot, error)
        type(plot_type), intent(in) :: plot                 !! what is drawn, and where
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: scripts
        integer :: i

        call find_scripts(trim(shared_scripts(1)), scripts, error)
        if (.not. allocated(error)) call make_folder(plot%folder, error)
        do i = 1, size(shared_scripts)
            if (allocated(error)) return
            call copy_file(scripts, plot%folder, trim(shared_scripts(i)), error)
        end do
        do i = 1, size(plot%picture)
            if (allocated(error)) return
            if (plot%picture(i)%count > 0) call write_picture(plot, plot%picture(i), error)
        end do
    end subroutine write_files

    !> Writes data and script of a picture.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine write_picture(plot, picture, error)
        type(plot_type), intent(in) :: plot                 !! folder and format
        type(picture_type), intent(in) :: picture           !! the picture
        type(error_type), allocatable, intent(out) :: error !! see above
        type(result_file_type) :: data_file, script_file
        type(output_type) :: data, script
        type(frame_type) :: frame

        frame = frame_of(picture)
        call data_file%begin(plot%folder//'/'//picture%name//'.dat', data, error)
        if (allocated(error)) return
        call print_gnuplot_data(picture, frame, data)
        call data_file%complete(data, error)
        if (allocated(error)) return
        call script_file%begin(plot%folder//'/'//picture%name//'.gp', script, error)
        if (allocated(error)) return
        call print_gnuplot_script(picture, frame, plot%format, script)
        call script_file%complete(script, error)
    end subroutine write_picture

    !> Copies a text file from a folder to another.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine copy_file(from, to, name, error)
        character(*), intent(in) :: from                    !! folder
        character(*), intent(in) :: to                      !! folder
        character(*), intent(in) :: name                    !! of the file
        type(error_type), allocatable, intent(out) :: error !! see above
        type(result_file_type) :: file
        type(output_type) :: out
        type(error_type), allocatable :: trouble

        call file%begin(to//'/'//name, out, error)
        if (allocated(error)) return
        call print_file(from//'/'//name, out, trouble)
        if (allocated(trouble)) then
            call file%abandon()
            call move_alloc(trouble, error)
        else
            call file%complete(out, error)
        end if
    end subroutine copy_file

    !> Prints a text file without form feeds before lines and blanks behind.
    !>
    !> Fails with `cause%file_trouble` where it can't be read.
    subroutine print_file(name, out, error)
        character(*), intent(in) :: name                    !! of the file
        type(output_type), intent(inout) :: out             !! where it goes
        type(error_type), allocatable, intent(out) :: error !! see above
        type(deck_file_type) :: file
        type(source_type) :: source
        type(line_type) :: line
        character, parameter :: form_feed = achar(12)
        logical :: has_line

        call file%open(name, source, error)
        if (allocated(error)) return
        do
            call source%next_line(line, has_line, error)
            if (allocated(error)) error%message = name//': '//error%message
            if (allocated(error) .or. .not. has_line) exit
            if (index(line%text, form_feed) == 1) line%text = line%text(2:)
            call out%line(trim(line%text))
        end do
        call file%close()
    end subroutine print_file

    !> Lets gnuplot draw the pictures. Standard output gets their names, or, as text, themselves.
    !>
    !> Fails with `cause%file_trouble` where there is no gnuplot, or it fails on some picture; the
    !> others are drawn.
    subroutine draw_pictures(plot, error)
        type(plot_type), intent(in) :: plot                 !! what is drawn, and where
        type(error_type), allocatable, intent(out) :: error !! see above
        type(error_type), allocatable :: trouble
        type(output_type) :: answer
        integer :: i

        if (.not. has_gnuplot()) then
            call fail(error, cause%file_trouble, 'no gnuplot is found: data and scripts are '// &
                'written, no picture is drawn; install the package gnuplot-nox (or gnuplot), '// &
                'then: cd '//folder_word(plot%folder)//' && gnuplot'//scripts_of(plot))
            return
        end if
        call answer%attach(standard_output)
        do i = 1, size(plot%picture)
            if (plot%picture(i)%count == 0) cycle
            call draw(plot%folder, plot%picture(i)%name, plot%format, trouble)
            if (.not. allocated(trouble)) call show(plot, plot%picture(i)%name, answer, trouble)
            if (allocated(trouble) .and. .not. allocated(error)) call move_alloc(trouble, error)
        end do
        call answer%flush(trouble)
        if (allocated(trouble) .and. .not. allocated(error)) call move_alloc(trouble, error)
    end subroutine draw_pictures

    !> Says that a picture is drawn: its name, or, as text, itself.
    !>
    !> Fails with `cause%file_trouble` where the text can't be read.
    subroutine show(plot, name, answer, error)
        type(plot_type), intent(in) :: plot                 !! folder and format
        character(*), intent(in) :: name                    !! of the picture
        type(output_type), intent(inout) :: answer          !! what the user sees
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: path

        path = plot%folder//'/'//name//'.'//plot%format
        if (plot%format == 'txt') then
            call print_file(path, answer, error)
        else
            call answer%line(path)
        end if
    end subroutine show

    !> The scripts of the pictures, each with a blank in front.
    pure function scripts_of(plot) result(names)
        type(plot_type), intent(in) :: plot !! the pictures
        character(:), allocatable :: names
        integer :: i
        names = ''
        do i = 1, size(plot%picture)
            if (plot%picture(i)%count > 0) names = names//' '//plot%picture(i)%name//'.gp'
        end do
    end function scripts_of

end module app_plot
