!> The result of a sweep: rows in order with the front marked, the best deck beside them (where
!> there is no best, not even that of a sweep before), the summary. A regular file is written when
!> all variants are done; what can't be replaced by a whole file (standard output, a device, a FIFO,
!> a link) is opened at the start, so that nothing is computed in vain.
module app_sweep_result
    use, intrinsic :: iso_c_binding, only: c_int
    use app_file_set, only: file_set_type
    use app_files, only: can_be_replaced
    use app_journal, only: journal_type
    use base_error, only: error_type
    use base_output, only: output_type
    use base_posix, only: c_text, c_unlink, standard_output
    use sweep_front, only: best_of, mark_front
    use sweep_image, only: write_variant
    use sweep_plan, only: values_of
    use sweep_record, only: row_of_record
    use sweep_study, only: study_type
    use sweep_summary, only: summary_of
    implicit none (type, external)
    private

    public :: result_type, write_deck

    !> What the best deck is called, behind the name of the result.
    character(*), parameter, public :: best_ending = '.best.crd'

    !> A result.
    type :: result_type
        character(:), allocatable :: name   !! as the user gave it; may be empty
        logical :: is_file = .false.        !! it is a regular file, or will be one
        type(file_set_type), private :: files
        type(output_type), private :: out
    contains
        procedure :: begin => begin_result
        procedure :: conclude
    end type result_type

contains

    !> Begins a result.
    !>
    !> Fails with `cause%file_trouble` where it can't be opened.
    subroutine begin_result(result, name, error)
        class(result_type), intent(inout) :: result         !! the result
        character(*), intent(in) :: name                    !! as the user gave it; may be empty
        type(error_type), allocatable, intent(out) :: error !! see above

        result%name = name
        result%is_file = name /= '' .and. name /= '-'
        if (result%is_file) result%is_file = can_be_replaced(name)
        if (.not. result%is_file) call result%files%begin(name, result%out, error)
    end subroutine begin_result

    !> Writes the result when all variants are done, and then removes the journal.
    !>
    !> Fails with `cause%file_trouble`; the journal then stays.
    subroutine conclude(result, study, journal, best, error)
        class(result_type), intent(inout) :: result         !! begun
        type(study_type), intent(in) :: study               !! the sweep
        type(journal_type), intent(inout) :: journal        !! with all variants
        integer, intent(out) :: best                        !! the best variant; 0: there is none
        type(error_type), allocatable, intent(out) :: error !! see above
        integer(c_int) :: ignored

        call mark_front(study, journal%record)
        best = best_of(study, journal%record)
        if (result%is_file) call result%files%begin(result%name, result%out, error)
        if (allocated(error)) return
        call print_rows(journal, result%out)
        if (.not. result%is_file) call result%out%put(summary_of(study, journal%record, '# '))
        call result%files%finish(result%out, error)
        if (.not. allocated(error) .and. result%is_file .and. best > 0) &
            call put_deck(result%files, result%name//best_ending, study, best, error)
        if (.not. allocated(error)) call result%files%publish(error)
        if (allocated(error)) then
            call result%files%abandon()
            return
        end if
        call journal%remove()
        if (.not. result%is_file) return
        if (best == 0) ignored = c_unlink(c_text(result%name//best_ending))
        call print_summary(result%name, study, journal, best, error)
    end subroutine conclude

    !> Prints header and rows.
    subroutine print_rows(journal, out)
        type(journal_type), intent(in) :: journal   !! with all variants
        type(output_type), intent(inout) :: out     !! where they go
        integer :: i
        call out%put(journal%header)
        do i = 1, size(journal%record)
            call out%line(row_of_record(journal%record(i), .true.))
        end do
    end subroutine print_rows

    !> Writes the deck of a variant, as a result by itself.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine write_deck(name, study, number, error)
        character(*), intent(in) :: name                    !! as the user gave it; may be empty
        type(study_type), intent(in) :: study               !! the sweep
        integer, intent(in) :: number                       !! which variant
        type(error_type), allocatable, intent(out) :: error !! see above
        type(file_set_type) :: files

        call put_deck(files, name, study, number, error)
        if (.not. allocated(error)) call files%publish(error)
    end subroutine write_deck

    !> Puts the deck of a variant to results that belong together.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine put_deck(files, name, study, number, error)
        type(file_set_type), intent(inout) :: files         !! gets it, finished
        character(*), intent(in) :: name                    !! of the deck; may be empty
        type(study_type), intent(in) :: study               !! the sweep
        integer, intent(in) :: number                       !! which variant
        type(error_type), allocatable, intent(out) :: error !! see above
        type(output_type) :: out
        character(:), allocatable :: text

        call files%begin(name, out, error)
        if (allocated(error)) return
        call write_variant(study%image, values_of(study%plan, number), text)
        call out%put(text)
        call files%finish(out, error)
    end subroutine put_deck

    !> Prints the summary on standard output.
    !>
    !> Fails with `cause%file_trouble`.
    subroutine print_summary(name, study, journal, best, error)
        character(*), intent(in) :: name                    !! of the result
        type(study_type), intent(in) :: study               !! the sweep
        type(journal_type), intent(in) :: journal           !! with all variants
        integer, intent(in) :: best                         !! the best variant; 0: there is none
        type(error_type), allocatable, intent(out) :: error !! see above
        type(output_type) :: answer

        call answer%attach(standard_output)
        call answer%put(summary_of(study, journal%record, ''))
        call answer%line('Rows: '//name)
        if (best > 0) call answer%line('Deck of the best: '//name//best_ending)
        call answer%flush(error)
    end subroutine print_summary

end module app_sweep_result
