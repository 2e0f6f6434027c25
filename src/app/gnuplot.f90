!> Runs gnuplot. The only place where LOFT starts another program.
module app_gnuplot
    use, intrinsic :: iso_c_binding, only: c_int
    use app_signals, only: guard_file, release_file
    use base_error, only: cause, error_type, fail
    use base_file_facts, only: facts_of_file, file_facts_type
    use base_posix, only: c_getpid, c_raise, c_rename, c_text, c_unlink, last_error
    use base_text, only: to_text
    implicit none (type, external)
    private

    public :: has_gnuplot, draw, shell_word, folder_word

    !> The interrupt signal, and the exit status of a shell that got it.
    integer(c_int), parameter :: interrupt = 2_c_int
    integer, parameter :: was_interrupted = 130

contains

    !> True where the shell finds gnuplot.
    logical function has_gnuplot()
        has_gnuplot = shell_status('command -v gnuplot >/dev/null 2>&1') == 0
    end function has_gnuplot

    !> Lets gnuplot draw one picture: `gnuplot NAME.gp` in the folder, drawing NAME.FORMAT. The
    !> picture gets its name when gnuplot is through; what gnuplot complains of goes to standard
    !> error.
    !>
    !> Fails with `cause%file_trouble` where gnuplot does or draws nothing; a picture that was there
    !> before stays. An interrupt from the keyboard, which the shell and gnuplot get and LOFT does
    !> not while it waits for them, ends LOFT too.
    subroutine draw(folder, name, format, error)
        character(*), intent(in) :: folder                  !! where script and data are
        character(*), intent(in) :: name                    !! of the picture, a plain word
        character(*), intent(in) :: format                  !! svg, pdf, png or txt
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: picture, unfinished
        integer(c_int) :: ignored
        type(file_facts_type) :: facts
        integer :: status, guard

        picture = name//'.'//format
        unfinished = picture//'.part'//to_text(int(c_getpid()))
        call guard_file(folder//'/'//unfinished, guard)
        status = shell_status('trap ''exit '//to_text(was_interrupted)//''' INT; cd '// &
            folder_word(folder)//' && gnuplot -d -e "format='''//format//'''; output='''// &
            unfinished//'''" '//name//'.gp </dev/null >/dev/null')
        if (status == was_interrupted) ignored = c_raise(interrupt)
        facts = facts_of_file(folder//'/'//unfinished)
        if (status /= 0 .or. facts%length == 0) then
            call fail(error, cause%file_trouble, folder//'/'//picture// &
                ': gnuplot did not draw it (its exit status is '//to_text(status)//')')
        else if (c_rename(c_text(folder//'/'//unfinished), c_text(folder//'/'//picture)) < 0) then
            call fail(error, cause%file_trouble, folder//'/'//picture//': '//trim(last_error()))
        end if
        if (allocated(error)) ignored = c_unlink(c_text(folder//'/'//unfinished))
        call release_file(guard)
    end subroutine draw

    !> Runs a line of shell; its exit status, or -1 where there is no shell.
    integer function shell_status(line) result(status)
        character(*), intent(in) :: line !! the line; every word of a user in it by `shell_word`
        integer :: trouble

        status = -1
        call execute_command_line(line, exitstat=status, cmdstat=trouble)
        if (trouble /= 0 .and. status == 0) status = -1
    end function shell_status

    !> Any text as one word of a shell line: in single quotes, its own quotes as '\''.
    pure function shell_word(text) result(word)
        character(*), intent(in) :: text !! any bytes but a null
        character(:), allocatable :: word
        integer :: i

        word = ''''
        do i = 1, len(text)
            if (text(i:i) == '''') then
                word = word//'''\'''''
            else
                word = word//text(i:i)
            end if
        end do
        word = word//''''
    end function shell_word

    !> A folder as the word behind `cd`, which takes it for nothing else: neither an option nor a
    !> folder of CDPATH.
    pure function folder_word(folder) result(word)
        character(*), intent(in) :: folder !! any path
        character(:), allocatable :: word
        word = shell_word(folder)
        if (index(folder, '/') /= 1) word = shell_word('./'//folder)
    end function folder_word

end module app_gnuplot
