!> The receipt of an export as text: what was made of which deck, a line for each entity, the
!> largest error of all, and what else is to be known. No dates: the same deck gives the same
!> receipt.
!>
!>     LOFT 0.1.0 EXPORT RECEIPT
!>     FILE       nose.igs
!>     DECK       nose.crd
!>     SHA-256    9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08
!>     UNITS      INCHES
!>     TOLERANCE  0.001
!>
!>     ENTITY          KIND                             POINTS SPANS    ERROR       STA ...
!>     STA_20          126 B-SPLINE CURVE         EXACT      9     4       0.
module export_receipt_text
    use base_constants, only: version
    use base_digits, only: fixed, scientific, shortest
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: printable, right, row_of, to_text
    use export_receipt, only: entity_type, receipt_type
    implicit none (type, external)
    private

    public :: heading_type, print_receipt

    !> Columns of a receipt, and of its parts.
    integer, parameter :: page = 100, name_columns = 16, kind_columns = 27, grade_columns = 6, &
        points_columns = 6, spans_columns = 6, error_columns = 9, place_columns = 10

    !> What a receipt says before its entities.
    type :: heading_type
        character(:), allocatable :: files      !! names of what was written, each with a line end
        character(:), allocatable :: deck       !! its name, without folders
        character(:), allocatable :: checksum   !! SHA-256 of its bytes
        character(:), allocatable :: units      !! of the file: INCHES, MM, FEET or M
        real(dp) :: tolerance = 0.0_dp          !! asked for, in units of the file; 0: none
    end type heading_type

contains

    !> Prints a receipt.
    subroutine print_receipt(heading, receipt, out)
        type(heading_type), intent(in) :: heading   !! what stands before the entities
        type(receipt_type), intent(in) :: receipt   !! the entities, and notes
        type(output_type), intent(inout) :: out     !! where it goes
        integer :: i

        call out%line('LOFT '//version//' EXPORT RECEIPT')
        call print_lines('FILE', heading%files, out)
        call print_lines('DECK', heading%deck//new_line('a'), out)
        call out%line('SHA-256    '//heading%checksum)
        call out%line('UNITS      '//heading%units)
        if (heading%tolerance > 0.0_dp) then
            call out%line('TOLERANCE  '//shortest(heading%tolerance))
        else
            call out%line('TOLERANCE  NONE')
        end if
        call out%line('')
        call out%line(left('ENTITY', name_columns)//left('KIND', kind_columns)// &
            left('', grade_columns)//right('POINTS', points_columns)// &
            right('SPANS', spans_columns)//right('ERROR', error_columns)// &
            right('STA', place_columns)//right('BL', place_columns)//right('WL', place_columns))
        do i = 1, receipt%count
            call print_entity(receipt%entities(i), out)
        end do
        call out%line('')
        call print_largest(receipt, out)
        if (.not. allocated(receipt%notes)) return
        call out%line('')
        call print_notes(receipt%notes, out)
    end subroutine print_receipt

    !> Prints lines behind a word that stands before the first of them.
    subroutine print_lines(word, lines, out)
        character(*), intent(in) :: word            !! in front
        character(*), intent(in) :: lines           !! each with its end
        type(output_type), intent(inout) :: out     !! where they go
        character(:), allocatable :: head, line
        integer :: first, last

        head = word
        first = 1
        do while (first <= len(lines))
            last = first + index(lines(first:), new_line('a')) - 2
            line = lines(first:last)
            call out%line(left(head, 11)//printable(line))
            head = ''
            first = last + 2
        end do
    end subroutine print_lines

    !> Prints an entity: one line, or a second one where name or kind are longer than their columns.
    subroutine print_entity(entity, out)
        type(entity_type), intent(in) :: entity     !! what was written
        type(output_type), intent(inout) :: out     !! where it goes
        character(:), allocatable :: name, numbers
        integer :: i

        name = printable(entity%name)
        numbers = left(merge('EXACT ', 'APPROX', entity%is_exact), grade_columns)// &
            right(to_text(entity%points), points_columns)
        if (entity%spans > 0) then
            numbers = numbers//right(to_text(entity%spans), spans_columns)
        else
            numbers = numbers//row_of(' ', spans_columns)
        end if
        numbers = numbers//right(error_text(entity%error), error_columns)
        if (entity%has_place) then
            do i = 1, 3
                numbers = numbers//' '//fixed(entity%worst(i), place_columns - 1, 2)
            end do
        end if
        if (len(name) >= name_columns .or. len(entity%kind) >= kind_columns) then
            call out%line(name)
            name = ''
        end if
        if (len(entity%kind) >= kind_columns) then
            call out%line(row_of(' ', name_columns)//entity%kind)
            call out%line(row_of(' ', name_columns + kind_columns)//numbers)
        else
            call out%line(left(name, name_columns)//left(entity%kind, kind_columns)//numbers)
        end if
    end subroutine print_entity

    !> Prints how many entities there are, and the largest error of all with its place.
    subroutine print_largest(receipt, out)
        type(receipt_type), intent(in) :: receipt   !! with its entities
        type(output_type), intent(inout) :: out     !! where it goes
        character(:), allocatable :: text
        integer :: exact, worst

        if (receipt%count == 0) then
            call out%line('NO ENTITIES')
            return
        end if
        exact = count(receipt%entities(:receipt%count)%is_exact)
        text = to_text(exact)//' EXACT, '//to_text(receipt%count - exact)//' APPROXIMATE'
        if (receipt%count > 1) text = to_text(receipt%count)//' ENTITIES: '//text
        call out%line(text)
        worst = maxloc(receipt%entities(:receipt%count)%error, 1)
        associate (entity => receipt%entities(worst))
            text = 'LARGEST ERROR '//trim(adjustl(error_text(entity%error)))
            if (entity%error > 0.0_dp) text = text//' IN '//printable(entity%name)
            if (entity%has_place .and. entity%error > 0.0_dp) text = text//' AT STA '// &
                plain(entity%worst(1))//' BL '//plain(entity%worst(2))//' WL '// &
                plain(entity%worst(3))
        end associate
        call print_notes(text//new_line('a'), out)
    end subroutine print_largest

    !> Prints lines of plain words; a line that is too long goes on below, indented.
    subroutine print_notes(notes, out)
        character(*), intent(in) :: notes           !! each with its end
        type(output_type), intent(inout) :: out     !! where they go
        character(*), parameter :: indent = '    '
        character(:), allocatable :: rest, line
        integer :: first, last, cut

        first = 1
        do while (first <= len(notes))
            last = first + index(notes(first:), new_line('a')) - 2
            rest = notes(first:last)
            rest = printable(rest)
            do while (len(rest) > page)
                cut = index(rest(:page + 1), ' ', back=.true.)
                if (cut <= len(indent) + 1) cut = page
                line = rest(:cut)
                call out%line(trim(line))
                rest = indent//rest(cut + 1:)
            end do
            call out%line(rest)
            first = last + 2
        end do
    end subroutine print_notes

    !> An error in three figures.
    pure function error_text(error) result(text)
        real(dp), intent(in) :: error !! not negative
        character(:), allocatable :: text
        if (is_zero(error)) then
            text = '0.'
        else
            text = scientific(error, error_columns + 1, 3)
        end if
    end function error_text

    !> A coordinate with two decimals, without blanks.
    pure function plain(ordinate) result(text)
        real(dp), intent(in) :: ordinate !! in units of the file
        character(:), allocatable :: text
        text = trim(adjustl(fixed(ordinate, 16, 2)))
    end function plain

    !> A text at the left of its columns, or as it is where it needs more.
    pure function left(text, width) result(placed)
        character(*), intent(in) :: text !! any text
        integer, intent(in) :: width     !! columns
        character(:), allocatable :: placed
        placed = text//row_of(' ', width - len(text))
    end function left

end module export_receipt_text
