!> Tables of a 1970 deck as comma-separated values, in full: every number in the fewest figures that
!> read back as the same double.
!>
!>     card,axis,x,y,slope,curvature
!>     1,X,-30,-10,0.114,-0.0008
module report_csv
    use base_figures, only: put_text, put_whole
    use base_kinds, only: i64
    use base_output, only: output_type
    use base_shortest, only: put_shortest, widest_shortest
    use body_card_tables, only: card_table_type
    implicit none (type, external)
    private

    public :: print_csv_header, print_csv_table

    !> Bytes of the longest line: a card's number, the axis, four numbers.
    integer, parameter :: longest_line = 4*widest_shortest + 32

contains

    !> Prints the header line.
    subroutine print_csv_header(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%line('card,axis,x,y,slope,curvature')
    end subroutine print_csv_header

    !> Prints one table, a line a row. A vertical slope is `inf`.
    subroutine print_csv_table(table, card, out)
        type(card_table_type), intent(in) :: table !! the table
        integer(i64), intent(in) :: card           !! which data card of the deck, from 1
        type(output_type), intent(inout) :: out    !! where it goes
        character(longest_line) :: line
        integer :: front, i, next

        front = 1
        call put_whole(card, line, front)
        call put_text(merge(',X,', ',Y,', table%axis == 1), line, front)
        do i = 1, size(table%row)
            next = front
            associate (row => table%row(i))
                call put_shortest(row%x, line, next)
                call put_text(',', line, next)
                call put_shortest(row%y, line, next)
                call put_text(',', line, next)
                if (row%slope%is_vertical) then
                    call put_text('inf', line, next)
                else
                    call put_shortest(row%slope%value, line, next)
                end if
                call put_text(',', line, next)
                call put_shortest(row%curvature, line, next)
                call put_text(new_line('a'), line, next)
                call out%put(line(:next - 1))
            end associate
        end do
    end subroutine print_csv_table

end module report_csv
