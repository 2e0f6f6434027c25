!> Tables of a 1970 deck as comma-separated values, in full: every number in the fewest figures that
!> read back as the same double.
!>
!>     card,axis,x,y,slope,curvature
!>     1,X,-30,-10,0.114,-0.0008
module report_csv
    use base_kinds, only: i64
    use base_output, only: output_type
    use base_text, only: to_text
    use body_card_tables, only: card_table_type
    use base_digits, only: shortest
    use report_slope, only: slope_text
    implicit none (type, external)
    private

    public :: print_csv_header, print_csv_table

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
        character(:), allocatable :: front
        integer :: i

        front = to_text(card)//merge(',X,', ',Y,', table%axis == 1)
        do i = 1, size(table%row)
            associate (row => table%row(i))
                call out%line(front//shortest(row%x)//','//shortest(row%y)//','// &
                    slope_text(row%slope)//','//shortest(row%curvature))
            end associate
        end do
    end subroutine print_csv_table

end module report_csv
