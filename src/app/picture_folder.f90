!> A folder of pictures: data and script of each picture, the scripts these load, and what gnuplot
!> draws. It needs nothing outside itself, so that it can be moved or sent and its pictures be drawn
!> again.
module app_picture_folder
    use api_deck_file, only: deck_file_type
    use app_files, only: make_folder, result_file_type
    use app_gnuplot, only: draw, folder_word, has_gnuplot
    use app_share, only: find_scripts
    use base_error, only: cause, error_type, fail
    use base_output, only: output_type
    use base_posix, only: standard_output
    use deck_source, only: line_type, source_type
    implicit none (type, external)
    private

    public :: folder_type, name_type, begin_folder, add_picture, draw_pictures

    !> The name of a picture.
    type :: name_type
        character(:), allocatable :: text !! a plain word: name of its files without ending
    end type name_type

    !> A folder.
    type :: folder_type
        character(:), allocatable :: path       !! where it is
        character(:), allocatable :: format     !! svg, pdf, png or txt
        integer :: count = 0                    !! pictures
        type(name_type), allocatable :: picture(:) !! `picture(1:count)`, in order of drawing
    end type folder_type

contains

    !> Makes the folder, where it is not there, with the scripts that all pictures load.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine begin_folder(folder, scripts, error)
        type(folder_type), intent(in) :: folder             !! path and format are set
        character(*), intent(in) :: scripts(:)              !! names of the scripts
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: source
        integer :: i

        call find_scripts(trim(scripts(1)), source, error)
        if (.not. allocated(error)) call make_folder(folder%path, error)
        do i = 1, size(scripts)
            if (allocated(error)) return
            call copy_file(source, folder%path, trim(scripts(i)), error)
        end do
    end subroutine begin_folder

    !> Notes a picture whose data and script are complete.
    subroutine add_picture(folder, name)
        type(folder_type), intent(inout) :: folder  !! gets it
        character(*), intent(in) :: name            !! a plain word
        type(name_type), allocatable :: grown(:)
        integer :: i

        if (folder%count == size(folder%picture)) then
            allocate (grown(2*folder%count + 1))
            do i = 1, folder%count
                call move_alloc(folder%picture(i)%text, grown(i)%text)
            end do
            call move_alloc(grown, folder%picture)
        end if
        folder%count = folder%count + 1
        folder%picture(folder%count)%text = name
    end subroutine add_picture

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
    subroutine draw_pictures(folder, error)
        type(folder_type), intent(in) :: folder             !! complete but for the pictures
        type(error_type), allocatable, intent(out) :: error !! see above
        type(error_type), allocatable :: trouble
        type(output_type) :: answer
        integer :: i

        if (folder%count == 0) return
        if (.not. has_gnuplot()) then
            call fail(error, cause%file_trouble, 'no gnuplot is found: data and scripts are '// &
                'written, no picture is drawn; install the package gnuplot-nox (or gnuplot), '// &
                'then: cd '//folder_word(folder%path)//' && gnuplot'//scripts_of(folder))
            return
        end if
        call answer%attach(standard_output)
        do i = 1, folder%count
            associate (name => folder%picture(i)%text)
                call draw(folder%path, name, folder%format, trouble)
                if (.not. allocated(trouble)) call show(folder, name, answer, trouble)
            end associate
            if (allocated(trouble) .and. .not. allocated(error)) call move_alloc(trouble, error)
        end do
        call answer%flush(trouble)
        if (allocated(trouble) .and. .not. allocated(error)) call move_alloc(trouble, error)
    end subroutine draw_pictures

    !> Says that a picture is drawn: its name, or, as text, itself.
    !>
    !> Fails with `cause%file_trouble` where the text can't be read.
    subroutine show(folder, name, answer, error)
        type(folder_type), intent(in) :: folder             !! where it is
        character(*), intent(in) :: name                    !! of the picture
        type(output_type), intent(inout) :: answer          !! what the user sees
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: path

        path = folder%path//'/'//name//'.'//folder%format
        if (folder%format == 'txt') then
            call print_file(path, answer, error)
        else
            call answer%line(path)
        end if
    end subroutine show

    !> The scripts of the pictures, each with a blank in front.
    pure function scripts_of(folder) result(names)
        type(folder_type), intent(in) :: folder !! with its pictures
        character(:), allocatable :: names
        integer :: i
        names = ''
        do i = 1, folder%count
            names = names//' '//folder%picture(i)%text//'.gp'
        end do
    end function scripts_of

end module app_picture_folder
