!> The journal of a sweep: `FILE.partial`, to which each variant is written as a whole row the
!> moment it is finished, in whatever order that is, with its seal. It stays when LOFT is stopped or
!> killed; `--resume` reads it and goes on. A last row that was torn is cut off and computed again.
!> When all variants are done the result is written anew, in order, under its own name, and the
!> journal is removed.
module app_journal
    use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_null_ptr, c_ptr
    use app_progress, only: tell_progress, time_words
    use app_signals, only: advise
    use app_whole_file, only: read_whole
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_equal
    use base_kinds, only: i64
    use base_output, only: output_type
    use base_posix, only: c_fclose, c_fileno, c_fopen, c_text, c_unlink, last_error
    use base_text, only: to_text
    use sweep_keeper, only: keeper_type
    use sweep_plan, only: values_of
    use sweep_record, only: header_of, read_row, record_type, row_of_record, state
    use sweep_seal, only: sealed, unseal
    use sweep_study, only: study_type
    implicit none (type, external)
    private

    public :: journal_type, pending_of

    !> A journal, and all that is known of the sweep so far.
    type, extends(keeper_type) :: journal_type
        type(record_type), allocatable :: record(:)     !! of all variants; number 0: not done yet
        character(:), allocatable :: header             !! the lines before the rows
        character(:), allocatable, private :: path      !! of the journal; not set: there is none
        type(c_ptr), private :: stream = c_null_ptr
        type(output_type), private :: out
        integer, private :: done = 0                    !! finished variants
        integer, private :: sound = 0                   !! those that keep all limits
        integer, private :: done_before = 0             !! those that were in the journal
        integer(i64), private :: begun = 0              !! ticks of the clock when it was opened
    contains
        procedure :: begin
        procedure :: open => open_journal
        procedure :: keep => keep_in_journal
        procedure :: close => close_journal
        procedure :: remove
    end type journal_type

contains

    !> Begins a journal that is only kept in memory.
    subroutine begin(journal, study, checksum)
        class(journal_type), intent(inout) :: journal   !! the journal
        type(study_type), intent(in) :: study           !! the sweep
        character(*), intent(in) :: checksum            !! SHA-256 of the deck
        allocate (journal%record(study%plan%count))
        journal%header = header_of(study, checksum)
        call system_clock(journal%begun)
    end subroutine begin

    !> Opens the journal beside a result. To resume is to read what is in it, or, where there is
    !> none, in a result that is whole.
    !>
    !> Fails with `cause%file_trouble` where there is one and nobody said that it is to be gone on
    !> with, where it is of another deck, where a row of it is none, or with the system's words.
    subroutine open_journal(journal, result, study, is_resumed, error)
        class(journal_type), intent(inout) :: journal       !! begun
        character(*), intent(in) :: result                  !! name of the result
        type(study_type), intent(in) :: study               !! the sweep
        logical, intent(in) :: is_resumed                   !! it is to be gone on with
        type(error_type), allocatable, intent(out) :: error !! see above
        logical :: has_journal, has_result
        integer(i64) :: kept

        kept = 0
        journal%path = result//'.partial'
        inquire (file=journal%path, exist=has_journal)
        inquire (file=result, exist=has_result)
        if (has_journal .and. .not. is_resumed) then
            call fail(error, cause%file_trouble, journal%path//' is there, of a sweep that was '// &
                'stopped: --resume goes on with it; without it, remove that file first')
        else if (has_journal) then
            call read_rows(journal, journal%path, study, .true., kept, error)
        else if (has_result .and. is_resumed) then
            call read_rows(journal, result, study, .false., kept, error)
            kept = 0
            if (journal%done == study%plan%count) return
        end if
        if (.not. allocated(error)) call open_to_append(journal, kept, has_journal, error)
        journal%done_before = journal%done
    end subroutine open_journal

    !> Opens the file to put rows behind what is kept of it.
    !>
    !> Fails with `cause%file_trouble` and the system's words.
    subroutine open_to_append(journal, kept, is_there, error)
        class(journal_type), intent(inout) :: journal       !! with its path
        integer(i64), intent(in) :: kept                    !! bytes that stay
        logical, intent(in) :: is_there                     !! the file is there
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: trouble

        trouble = 0
        if (is_there) call cut_off(journal%path, kept, trouble)
        if (trouble == 0) journal%stream = c_fopen(c_text(journal%path), c_text('a'))
        if (trouble /= 0 .or. .not. c_associated(journal%stream)) then
            call fail(error, cause%file_trouble, journal%path//': '//trim(last_error()))
            return
        end if
        call journal%out%attach(c_fileno(journal%stream))
        call advise('; --resume goes on with '//journal%path)
        if (kept == 0) call write_known(journal, error)
    end subroutine open_to_append

    !> Writes the header and the rows that are known, from a result that was not whole.
    !>
    !> Fails with `cause%file_trouble` and the system's words.
    subroutine write_known(journal, error)
        class(journal_type), intent(inout) :: journal       !! open
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i

        call journal%out%put(journal%header)
        do i = 1, size(journal%record)
            if (journal%record(i)%number > 0) &
                call journal%out%line(sealed(row_of_record(journal%record(i), .false.)))
        end do
        call journal%out%flush(error)
        if (allocated(error)) error%message = journal%path//': '//error%message
    end subroutine write_known

    !> Cuts off what stands in a file behind so many bytes.
    subroutine cut_off(path, kept, trouble)
        character(*), intent(in) :: path    !! of a regular file
        integer(i64), intent(in) :: kept    !! bytes that stay
        integer, intent(out) :: trouble     !! not 0: it could not be done
        integer :: unit

        open (newunit=unit, file=path, access='stream', form='unformatted', status='old', &
            action='readwrite', iostat=trouble)
        if (trouble /= 0) return
        write (unit, pos=kept + 1, iostat=trouble)
        if (trouble == 0) endfile (unit, iostat=trouble)
        close (unit)
    end subroutine cut_off

    !> Reads the rows of a journal, or of a result.
    !>
    !> Fails with `cause%file_trouble` where it is of another deck, or a whole row is none.
    subroutine read_rows(journal, name, study, has_seals, kept, error)
        class(journal_type), intent(inout) :: journal       !! gets the variants
        character(*), intent(in) :: name                    !! of the file
        type(study_type), intent(in) :: study               !! the sweep
        logical, intent(in) :: has_seals                    !! it is a journal
        integer(i64), intent(out) :: kept                   !! bytes of header and whole rows
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: text
        integer(i64) :: feed
        integer :: line

        kept = 0
        call read_whole(name, text, error)
        if (allocated(error)) return
        if (index(journal%header, text) == 1) return
        if (index(text, journal%header) /= 1) then
            call fail(error, cause%file_trouble, name//' is of another deck, or this deck was '// &
                'changed, or it is of another version of LOFT; remove it, or give -o another name')
            return
        end if
        kept = len(journal%header, i64)
        line = 2
        do
            feed = index(text(kept + 1:), new_line('a'), kind=i64)
            if (feed == 0) exit
            line = line + 1
            associate (row => text(kept + 1:kept + feed - 1))
                if (has_seals) then
                    call take_sealed_row(journal, row, study, error)
                else
                    call take_row(journal, row, study, error)
                end if
            end associate
            if (allocated(error)) then
                error%message = name//':'//to_text(line)//': '//error%message
                return
            end if
            kept = kept + feed
        end do
    end subroutine read_rows

    !> Takes a row with its seal.
    !>
    !> Fails with `cause%file_trouble` where it does not fit its seal, or is none of this sweep.
    subroutine take_sealed_row(journal, row, study, error)
        class(journal_type), intent(inout) :: journal       !! gets the variant
        character(*), intent(in) :: row                     !! without line feed
        type(study_type), intent(in) :: study               !! the sweep
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: unsealed
        logical :: fits

        call unseal(row, unsealed, fits)
        if (fits) then
            call take_row(journal, unsealed, study, error)
        else
            call fail(error, cause%file_trouble, 'a row that was damaged; remove the line, and '// &
                'its variant is computed again')
        end if
    end subroutine take_sealed_row

    !> Takes a row: its variables have the values that the plan gives its variant.
    !>
    !> Fails with `cause%file_trouble` where it is none.
    subroutine take_row(journal, row, study, error)
        class(journal_type), intent(inout) :: journal       !! gets the variant
        character(*), intent(in) :: row                     !! without line feed
        type(study_type), intent(in) :: study               !! the sweep
        type(error_type), allocatable, intent(out) :: error !! see above
        type(record_type) :: record
        logical :: is_sound

        call read_row(row, study, record, is_sound)
        if (is_sound) is_sound = all(is_equal(record%value, values_of(study%plan, record%number)))
        if (.not. is_sound) then
            call fail(error, cause%file_trouble, 'no row of this sweep; remove the line, and '// &
                'its variant is computed again')
            return
        end if
        call file_away(journal, record)
    end subroutine take_row

    !> Puts a variant in its place and counts it, where it is not there yet.
    subroutine file_away(journal, record)
        class(journal_type), intent(inout) :: journal   !! gets the variant
        type(record_type), intent(in) :: record         !! finished

        associate (place => journal%record(record%number))
            if (place%number == 0) journal%done = journal%done + 1
            if (place%number == 0 .and. record%state == state%ok) journal%sound = journal%sound + 1
            place = record
        end associate
    end subroutine file_away

    !> Keeps a variant: its row goes to the file at once.
    !>
    !> Fails with `cause%file_trouble` and the system's words.
    subroutine keep_in_journal(keeper, record, error)
        class(journal_type), intent(inout) :: keeper        !! the journal
        type(record_type), intent(in) :: record             !! a finished variant
        type(error_type), allocatable, intent(out) :: error !! see above

        if (c_associated(keeper%stream)) then
            call keeper%out%line(sealed(row_of_record(record, .false.)))
            call keeper%out%flush(error)
            if (allocated(error)) then
                error%message = keeper%path//': '//error%message//'; --resume goes on from here'
                return
            end if
        end if
        call file_away(keeper, record)
        call tell_progress('variant '//to_text(keeper%done)//' of '// &
            to_text(size(keeper%record))//', '//to_text(keeper%sound)//' keep all limits, '// &
            time_words(seconds_left(keeper))//' left')
    end subroutine keep_in_journal

    !> The seconds that are left at the pace so far.
    integer(i64) function seconds_left(journal)
        class(journal_type), intent(in) :: journal !! at least one was computed since it was opened
        integer(i64) :: now, rate

        call system_clock(now, rate)
        seconds_left = (now - journal%begun)/int(journal%done - journal%done_before, i64)* &
            int(size(journal%record) - journal%done, i64)/rate
    end function seconds_left

    !> Numbers of the variants that are not done.
    pure function pending_of(journal) result(pending)
        type(journal_type), intent(in) :: journal !! the journal
        integer, allocatable :: pending(:)
        integer :: i
        pending = pack([(i, i = 1, size(journal%record))], journal%record%number == 0)
    end function pending_of

    !> Closes the file; it stays.
    subroutine close_journal(journal)
        class(journal_type), intent(inout) :: journal !! the journal
        integer(c_int) :: ignored
        call advise('')
        if (c_associated(journal%stream)) ignored = c_fclose(journal%stream)
        journal%stream = c_null_ptr
    end subroutine close_journal

    !> Removes the file: the result is whole under its own name.
    subroutine remove(journal)
        class(journal_type), intent(inout) :: journal !! the journal
        integer(c_int) :: ignored
        call journal%close()
        if (allocated(journal%path)) ignored = c_unlink(c_text(journal%path))
    end subroutine remove

end module app_journal
