!> The picture of a sweep: every variant by its first two objectives, the front, the best. Of one
!> objective it is shown over the first variable.
module app_sweep_plot
    use app_files, only: base_name, result_file_type
    use app_picture_folder, only: add_picture, begin_folder, draw_pictures, folder_type
    use app_plot, only: default_folder
    use base_constants, only: version
    use base_digits, only: shortest
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: to_text
    use export_gnuplot_text, only: quoted
    use sweep_front, only: best_of, front_of
    use sweep_record, only: record_type, state
    use sweep_study, only: objectives_of, study_type
    use sweep_summary, only: aim_of
    implicit none (type, external)
    private

    public :: plot_sweep

    !> The one picture, and the scripts that it loads.
    character(*), parameter :: picture = 'front', scripts(2) = ['sweep.gp', 'style.gp']

contains

    !> Draws the picture into the folder of the deck's pictures.
    !>
    !> Fails with `cause%file_trouble` where a file can't be written, or gnuplot is missing or
    !> fails.
    subroutine plot_sweep(deck, study, records, error)
        character(*), intent(in) :: deck                    !! name of the deck
        type(study_type), intent(in) :: study               !! the sweep
        type(record_type), intent(in) :: records(:)         !! all variants, marked
        type(error_type), allocatable, intent(out) :: error !! see above
        type(folder_type) :: folder
        type(result_file_type) :: file
        type(output_type) :: data, script
        integer :: number(4)

        folder%path = default_folder(deck)
        folder%format = 'svg'
        allocate (folder%picture(0))
        call begin_folder(folder, scripts, error)
        if (allocated(error)) return
        call file%begin(folder%path//'/'//picture//'.dat', data, error)
        if (allocated(error)) return
        call print_data(study, records, number, data)
        call file%complete(data, error)
        if (allocated(error)) return
        call file%begin(folder%path//'/'//picture//'.gp', script, error)
        if (allocated(error)) return
        call print_script(deck, study, number, folder%format, script)
        call file%complete(script, error)
        if (allocated(error)) return
        call add_picture(folder, picture)
        call draw_pictures(folder, error)
    end subroutine plot_sweep

    !> Prints four blocks of points: variants that miss a limit, that keep all, the front, the best.
    subroutine print_data(study, records, number, out)
        type(study_type), intent(in) :: study       !! the sweep
        type(record_type), intent(in) :: records(:) !! all variants, marked
        integer, intent(out) :: number(4)           !! points of each block
        type(output_type), intent(inout) :: out     !! where they go
        integer :: i

        number = 0
        call print_block(pack([(i, i = 1, size(records))], records%state == state%limit), 1)
        call print_block(pack([(i, i = 1, size(records))], records%state == state%ok), 2)
        call print_block(front_of(study, records), 3)
        if (number(3) > 0) call print_block([best_of(study, records)], 4)

    contains

        !> Prints one block; an empty one is none.
        subroutine print_block(chosen, block)
            integer, intent(in) :: chosen(:)    !! its variants
            integer, intent(in) :: block        !! which block
            real(dp) :: at(2)
            integer :: k

            number(block) = size(chosen)
            do k = 1, size(chosen)
                at = point_of(study, records(chosen(k)))
                call out%line(shortest(at(1))//' '//shortest(at(2)))
            end do
            if (size(chosen) == 0) return
            call out%line('')
            call out%line('')
        end subroutine print_block

    end subroutine print_data

    !> Where a variant stands in the picture.
    pure function point_of(study, record) result(at)
        type(study_type), intent(in) :: study       !! the sweep
        type(record_type), intent(in) :: record     !! measured
        real(dp) :: at(2)
        integer, allocatable :: chosen(:)

        allocate (chosen, source=objectives_of(study))
        if (size(chosen) > 1) then
            at = record%measure(study%column(chosen(:2)))
        else
            at = [record%value(1), record%measure(study%column(chosen(1)))]
        end if
    end function point_of

    !> Prints the script.
    subroutine print_script(deck, study, number, format, out)
        character(*), intent(in) :: deck        !! name of the deck
        type(study_type), intent(in) :: study   !! the sweep
        integer, intent(in) :: number(4)        !! points of each block
        character(*), intent(in) :: format      !! svg, pdf, png or txt, where not told otherwise
        type(output_type), intent(inout) :: out !! where it goes
        integer, allocatable :: chosen(:)
        character(:), allocatable :: heading, x_axis
        integer :: i

        allocate (chosen, source=objectives_of(study))
        heading = base_name(deck)
        if (study%job%title /= '') heading = study%job%title
        x_axis = trim(study%plan%variable(1)%name)
        if (size(chosen) > 1) x_axis = aim_of(study%job%sweep%wanted(chosen(1)))
        call out%line('# Variants of a sweep, by LOFT '//version//'. To draw it again, here:')
        call out%line('#     gnuplot '//picture//'.gp')
        call out%line('#     gnuplot -e "format=''pdf''" '//picture//'.gp')
        call out%line('picture = '//quoted(picture))
        call out%line('heading = '//quoted(heading))
        call out%line('x_axis = '//quoted(x_axis))
        call out%line('y_axis = '//quoted(aim_of(study%job%sweep%wanted(chosen(min(2, &
            size(chosen)))))))
        call out%line('array number[4]')
        do i = 1, size(number)
            call out%line('number['//to_text(i)//'] = '//to_text(number(i)))
        end do
        call out%line('if (!exists("format")) format = '//quoted(format))
        call out%line('load ''sweep.gp''')
    end subroutine print_script

end module app_sweep_plot
