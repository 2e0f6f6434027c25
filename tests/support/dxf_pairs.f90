!> A reader of DXF files for tests: pairs of group code and value.
module support_dxf_pairs
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: pairs_type, read_pairs, numbers_of

    !> All pairs of a file, in order.
    type :: pairs_type
        integer :: count = 0                        !! pairs
        logical :: is_valid = .false.               !! each code a number, no line left over
        integer, allocatable :: code(:)             !! group codes
        character(260), allocatable :: value(:)     !! values as they stand
    contains
        procedure :: entity_count
        procedure :: find
        procedure :: text
    end type pairs_type

contains

    !> Reads a file.
    subroutine read_pairs(text, pairs)
        character(*), intent(in) :: text        !! the file
        type(pairs_type), intent(out) :: pairs  !! its pairs
        character(260) :: line
        integer :: first, length, lines, i, at, status

        lines = count([(text(i:i) == new_line('a'), i=1, len(text))])
        allocate (pairs%code(lines/2 + 1), pairs%value(lines/2 + 1))
        pairs%is_valid = mod(lines, 2) == 0 .and. lines > 0
        first = 1
        do i = 1, lines
            length = index(text(first:), new_line('a')) - 1
            line = text(first:first + length - 1)
            first = first + length + 1
            at = (i + 1)/2
            if (at + at > i) then
                read (line, *, iostat=status) pairs%code(at)
                if (status /= 0) pairs%is_valid = .false.
            else
                pairs%value(at) = line
            end if
        end do
        pairs%count = lines/2
        pairs%is_valid = pairs%is_valid .and. first == len(text) + 1
    end subroutine read_pairs

    !> How many things of a kind there are on a layer; of any layer where it is empty.
    integer function entity_count(pairs, kind, layer) result(number)
        class(pairs_type), intent(in) :: pairs  !! of a file
        character(*), intent(in) :: kind        !! POLYLINE...
        character(*), intent(in) :: layer       !! its name, or empty
        integer :: i, k

        number = 0
        do i = 1, pairs%count
            if (pairs%code(i) /= 0 .or. pairs%value(i) /= kind) cycle
            if (layer == '') number = number + 1
            do k = i + 1, pairs%count
                if (pairs%code(k) == 0) exit
                if (pairs%code(k) == 8 .and. pairs%value(k) == layer .and. layer /= '') &
                    number = number + 1
            end do
        end do
    end function entity_count

    !> Where a pair stands, counted from 1; 0: nowhere.
    integer function find(pairs, code, value, from) result(at)
        class(pairs_type), intent(in) :: pairs  !! of a file
        integer, intent(in) :: code             !! group code
        character(*), intent(in) :: value       !! blanks around it do not count
        integer, intent(in) :: from             !! first pair to look at
        do at = from, pairs%count
            if (pairs%code(at) == code .and. adjustl(pairs%value(at)) == adjustl(value)) return
        end do
        at = 0
    end function find

    !> The value of the first pair of a code from a place on; empty where there is none.
    function text(pairs, code, from)
        class(pairs_type), intent(in) :: pairs  !! of a file
        integer, intent(in) :: code             !! group code
        integer, intent(in) :: from             !! first pair to look at
        character(:), allocatable :: text
        integer :: i
        text = ''
        do i = max(1, from), pairs%count
            if (pairs%code(i) /= code) cycle
            text = trim(adjustl(pairs%value(i)))
            return
        end do
    end function text

    !> The numbers of a code in the things of a kind, in order.
    function numbers_of(pairs, kind, code) result(numbers)
        type(pairs_type), intent(in) :: pairs   !! of a file
        character(*), intent(in) :: kind        !! VERTEX...
        integer, intent(in) :: code             !! group code
        real(dp), allocatable :: numbers(:)
        real(dp) :: number
        logical :: is_inside
        integer :: i

        allocate (numbers(0))
        is_inside = .false.
        do i = 1, pairs%count
            if (pairs%code(i) == 0) is_inside = pairs%value(i) == kind
            if (.not. is_inside .or. pairs%code(i) /= code) cycle
            read (pairs%value(i), *) number
            numbers = [numbers, number]
        end do
    end function numbers_of

end module support_dxf_pairs
