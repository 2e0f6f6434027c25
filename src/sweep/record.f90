!> What is known of one variant, and its row in the result:
!>
!>     variant,HIGH,RHO,VOLUME,WETTED,state,front,why
!>     12,-7.5,.45,8013.2,2911.7,ok,1,
!>     13,-7.5,.55,,,fault,0,"line 9, columns 57-64: ..."
!>
!> Two lines stand before the rows: which deck, which columns. Numbers are the shortest that read
!> back the same, so that a row read is the record written.
module sweep_record
    use base_constants, only: version
    use base_digits, only: shortest
    use base_kinds, only: dp
    use base_text, only: printable, to_text
    use sweep_study, only: study_type
    implicit none (type, external)
    private

    public :: record_type, header_of, row_of_record, read_row

    !> What became of a variant.
    type, public :: state_list
        integer :: none = 0     !! not computed yet
        integer :: ok = 1       !! it was measured and keeps all limits
        integer :: limit = 2    !! it was measured and misses a limit
        integer :: fault = 3    !! it can't be built, or not be measured
    end type state_list
    type(state_list), parameter, public :: state = state_list()

    !> The states in words, from `state%ok`.
    character(*), parameter, public :: state_word(3) = ['ok   ', 'limit', 'fault']

    !> Characters of a number in a row, and the power of ten behind them, at most.
    integer, parameter :: longest_number = 28, largest_exponent = 280

    !> A variant.
    type :: record_type
        integer :: number = 0                   !! which, from 1
        real(dp), allocatable :: value(:)       !! of the variables
        real(dp), allocatable :: measure(:)     !! column by column; 0 where there is none
        logical, allocatable :: has(:)          !! there is one
        integer :: state = 0                    !! one of `state%...`
        logical :: is_front = .false.           !! no other variant is better in all objectives
        character(:), allocatable :: why        !! where the state is not ok: why
    end type record_type

contains

    !> The two lines before the rows.
    pure function header_of(study, checksum) result(header)
        type(study_type), intent(in) :: study       !! the sweep
        character(*), intent(in) :: checksum        !! SHA-256 of the deck
        character(:), allocatable :: header
        integer :: i

        header = '# loft '//version//' sweep of '//to_text(study%plan%count)// &
            ' variants, deck '//checksum//new_line('a')//'variant'
        do i = 1, size(study%plan%variable)
            header = header//','//trim(study%plan%variable(i)%name)
        end do
        do i = 1, size(study%shown)
            header = header//','//trim(study%job%sweep%wanted(study%shown(i))%name)
        end do
        header = header//',state,front,why'//new_line('a')
    end function header_of

    !> The row of a variant, without line feed. Before all are done nobody knows the front.
    pure function row_of_record(record, knows_front) result(row)
        type(record_type), intent(in) :: record !! the variant
        logical, intent(in) :: knows_front      !! else its field stays empty
        character(:), allocatable :: row
        integer :: i

        row = to_text(record%number)
        do i = 1, size(record%value)
            row = row//','//shortest(record%value(i))
        end do
        do i = 1, size(record%measure)
            row = row//','
            if (record%has(i)) row = row//shortest(record%measure(i))
        end do
        row = row//','//trim(state_word(record%state))//','
        if (knows_front) row = row//merge('1', '0', record%is_front)
        row = row//','//quoted(record%why)
    end function row_of_record

    !> A text as the last field of a row: in quotes, its own doubled; nothing stays nothing.
    pure function quoted(text) result(field)
        character(*), intent(in) :: text !! any
        character(:), allocatable :: field
        integer :: i

        field = ''
        if (text == '') return
        field = '"'
        do i = 1, len(text)
            if (text(i:i) == '"') field = field//'"'
            field = field//printable(text(i:i))
        end do
        field = field//'"'
    end function quoted

    !> Reads a row. A variant that is not at fault has all measures.
    pure subroutine read_row(row, study, record, is_sound)
        character(*), intent(in) :: row             !! without line feed
        type(study_type), intent(in) :: study       !! the sweep
        type(record_type), intent(out) :: record    !! the variant
        logical, intent(out) :: is_sound            !! it is a row of this sweep
        integer :: next, variables, columns, i
        real(dp) :: number
        logical :: has

        variables = size(study%plan%variable)
        columns = size(study%shown)
        allocate (record%value(variables), record%measure(columns), record%has(columns))
        next = 1
        call take_number(row, next, number, has, is_sound)
        is_sound = is_sound .and. has .and. number >= 1.0_dp .and. &
            number <= real(study%plan%count, dp)
        if (is_sound) record%number = nint(number)
        do i = 1, variables + columns
            if (.not. is_sound) return
            call take_number(row, next, number, has, is_sound)
            if (i <= variables) then
                record%value(i) = number
            else
                record%measure(i - variables) = number
                record%has(i - variables) = has
            end if
        end do
        if (is_sound) call take_state(row, next, record, is_sound)
        is_sound = is_sound .and. (record%state == state%fault .or. all(record%has))
    end subroutine read_row

    !> Takes the field that begins at a place, up to its comma.
    pure subroutine take_field(row, next, text, is_sound)
        character(*), intent(in) :: row                     !! the row
        integer, intent(inout) :: next                      !! where it begins; moved behind it
        character(:), allocatable, intent(out) :: text      !! the field
        logical, intent(out) :: is_sound                    !! a comma ends it
        integer :: comma

        text = ''
        comma = 0
        if (next <= len(row)) comma = index(row(next:), ',')
        is_sound = comma > 0
        if (.not. is_sound) return
        text = row(next:next + comma - 2)
        next = next + comma
    end subroutine take_field

    !> Takes a number, or nothing.
    pure subroutine take_number(row, next, number, has, is_sound)
        character(*), intent(in) :: row     !! the row
        integer, intent(inout) :: next      !! where it begins; moved behind it
        real(dp), intent(out) :: number     !! 0 where the field is empty
        logical, intent(out) :: has         !! it is not
        logical, intent(out) :: is_sound    !! it is a number or empty
        character(:), allocatable :: text
        integer :: trouble

        number = 0.0_dp
        call take_field(row, next, text, is_sound)
        has = text /= ''
        if (.not. is_sound .or. .not. has) return
        is_sound = verify(text, '0123456789+-.e') == 0 .and. len(text) <= longest_number
        if (is_sound) is_sound = is_of_range(text)
        if (.not. is_sound) return
        read (text, *, iostat=trouble) number
        is_sound = trouble == 0
    end subroutine take_number

    !> True for a number whose power of ten a double is sure to hold.
    pure logical function is_of_range(text)
        character(*), intent(in) :: text !! figures, signs, points and the letter e
        integer :: power, trouble

        power = 0
        trouble = 0
        if (index(text, 'e') > 0) read (text(index(text, 'e') + 1:), *, iostat=trouble) power
        is_of_range = trouble == 0 .and. abs(power) < largest_exponent
    end function is_of_range

    !> Takes state, front and why.
    pure subroutine take_state(row, next, record, is_sound)
        character(*), intent(in) :: row             !! the row
        integer, intent(inout) :: next              !! where they begin
        type(record_type), intent(inout) :: record  !! gets them
        logical, intent(out) :: is_sound            !! they are what they should be
        character(:), allocatable :: text, front

        call take_field(row, next, text, is_sound)
        if (is_sound) call take_field(row, next, front, is_sound)
        if (.not. is_sound) return
        record%state = findloc(state_word == text, .true., 1)
        record%is_front = front == '1'
        is_sound = record%state > 0 .and. len(text) > 0
        text = row(next:)
        record%why = ''
        if (len(text) == 0) return
        is_sound = is_sound .and. len(text) > 2
        if (.not. is_sound) return
        record%why = unquoted(text(2:len(text) - 1))
        is_sound = quoted(record%why) == text
    end subroutine take_state

    !> A text with one quote for two.
    pure function unquoted(field) result(text)
        character(*), intent(in) :: field !! between its quotes
        character(:), allocatable :: text
        integer :: i

        text = ''
        i = 1
        do while (i <= len(field))
            text = text//field(i:i)
            if (index(field(i:), '""') == 1) i = i + 1
            i = i + 1
        end do
    end function unquoted

end module sweep_record
