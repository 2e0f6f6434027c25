!> The instances of a STEP file, read as ISO 10303-21 says and not as LOFT writes.
module support_step_records
    use base_text, only: columns
    implicit none (type, external)
    private

    public :: record_type, records_of, record_named, count_of, refers_back, is_sound

    !> One instance.
    type :: record_type
        integer :: number = 0                   !! `#12=...`
        character(:), allocatable :: text       !! behind `=`, in one line
    end type record_type

contains

    !> The instances of the data section, in order.
    function records_of(text) result(records)
        character(*), intent(in) :: text !! a file, or a data section alone
        type(record_type), allocatable :: records(:)
        character(:), allocatable :: statement
        type(record_type) :: record
        integer :: i
        logical :: is_string

        allocate (records(0))
        statement = ''
        is_string = .false.
        do i = 1, len(text)
            if (text(i:i) == new_line('a')) cycle
            if (text(i:i) == '''') is_string = .not. is_string
            if (text(i:i) /= ';' .or. is_string) then
                statement = statement//text(i:i)
                cycle
            end if
            if (statement(1:1) == '#') then
                read (statement(2:index(statement, '=') - 1), *) record%number
                record%text = statement(index(statement, '=') + 1:)
                call append(records, record)
            end if
            statement = ''
        end do
    end function records_of

    !> Adds an instance. (Array constructors of types with texts leak in gfortran 12.)
    subroutine append(records, record)
        type(record_type), allocatable, intent(inout) :: records(:) !! get it
        type(record_type), intent(in) :: record                     !! the next
        type(record_type), allocatable :: grown(:)

        allocate (grown(size(records) + 1))
        grown(:size(records)) = records
        grown(size(grown)) = record
        call move_alloc(grown, records)
    end subroutine append

    !> The text of an instance by its number; empty where there is none.
    pure function record_named(records, number) result(text)
        type(record_type), intent(in) :: records(:) !! a data section
        integer, intent(in) :: number               !! which
        character(:), allocatable :: text
        integer :: i
        text = ''
        do i = 1, size(records)
            if (records(i)%number == number) text = records(i)%text
        end do
    end function record_named

    !> How many instances are of an entity, alone or with others.
    pure integer function count_of(records, entity) result(count)
        type(record_type), intent(in) :: records(:) !! a data section
        character(*), intent(in) :: entity          !! its name
        integer :: i, at
        count = 0
        do i = 1, size(records)
            at = index(records(i)%text, entity//'(')
            if (at > 1) then
                if (scan(records(i)%text(at - 1:at - 1), '()') == 0 .or. &
                    records(i)%text(1:1) /= '(') at = 0
            end if
            if (at > 0) count = count + 1
        end do
    end function count_of

    !> True where numbers rise by one from 1 and each reference is to an instance before.
    function refers_back(records) result(is_so)
        type(record_type), intent(in) :: records(:) !! a data section
        logical :: is_so
        integer :: i, k, last, number
        character(12) :: digits
        logical :: is_string

        is_so = size(records) > 0
        do i = 1, size(records)
            is_so = is_so .and. records(i)%number == i
            is_string = .false.
            do k = 1, len(records(i)%text)
                if (records(i)%text(k:k) == '''') is_string = .not. is_string
                if (records(i)%text(k:k) /= '#' .or. is_string) cycle
                last = k + verify(records(i)%text(k + 1:), '0123456789') - 1
                digits = columns(records(i)%text, k + 1, last)
                read (digits, *) number
                is_so = is_so .and. number >= 1 .and. number < i
            end do
        end do
    end function refers_back

    !> True where a text is printable ASCII in lines of at most some columns but for single tokens,
    !> with quotes and parentheses in pairs.
    function is_sound(text, widest) result(is_so)
        character(*), intent(in) :: text    !! a file
        integer, intent(in) :: widest       !! columns
        logical :: is_so
        integer :: i, first, depth
        logical :: is_string

        is_so = .true.
        is_string = .false.
        depth = 0
        first = 1
        do i = 1, len(text)
            if (text(i:i) == new_line('a')) then
                if (i - first > widest) is_so = is_so .and. &
                    scan(text(first:i - 2), ',') == 0 .or. scan(text(first:i - 1), '''') > 0
                first = i + 1
                is_so = is_so .and. .not. is_string
                cycle
            end if
            is_so = is_so .and. iachar(text(i:i)) >= 32 .and. iachar(text(i:i)) < 127
            if (text(i:i) == '''') is_string = .not. is_string
            if (is_string) cycle
            if (text(i:i) == '(') depth = depth + 1
            if (text(i:i) == ')') depth = depth - 1
            if (text(i:i) == ';') is_so = is_so .and. depth == 0
        end do
        is_so = is_so .and. .not. is_string .and. depth == 0
    end function is_sound

end module support_step_records
