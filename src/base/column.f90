!> A column of a table: numbers with fixed decimals below one another, four figures at a time. The
!> four are looked up among all there are: a number of a usual size costs a division or two by a
!> constant, and one load and one store for each four columns. Larger ones are left to
!> `base_figures`.
module base_column
    use base_figures, only: put_units
    use base_kinds, only: i64
    implicit none (type, external)
    private

    public :: put_column

    !> Figures looked up at a time.
    integer, parameter :: four = 4
    !> How many such groups there are, and how many that leave room for a minus.
    integer(i64), parameter :: groups = 10000, signed = 1000
    !> The figures.
    character(*), parameter :: figure = '0123456789'

contains

    !> Writes numbers given in units of their last decimal, the i-th so that it ends in column
    !> `last` of the i-th row. What stands in front of a number stays, but for blanks that fill at
    !> least four columns before its point; the row must have as many columns as the number needs.
    pure subroutine put_column(units, decimals, last, width, text)
        integer(i64), intent(in), contiguous :: units(:) !! the numbers
        integer, intent(in) :: decimals         !! figures behind the point, 4 to 8
        integer, intent(in) :: last             !! column of the last figure, `decimals` + 9 or more
        integer, intent(in) :: width            !! columns of a row
        character(*), intent(inout) :: text     !! the rows, one after the other
        integer(i64), parameter :: splits(four:2*four) = 10_i64**int([0, 1, 2, 3, 4], i64)
        integer(i64) :: whole, upper, split, place, end
        integer :: i

        split = splits(decimals)
        end = int(last, i64)
        do i = 1, size(units)
            place = end
            upper = abs(units(i))
            whole = upper/groups
            text(place - 3:place) = group(upper - whole*groups)
            if (decimals > four) then
                upper = whole
                whole = upper/split
                text(place - 7:place - 4) = group(upper - whole*split)
            end if
            place = place - int(decimals, i64)
            text(place:place) = '.'
            if (whole >= groups) then
                upper = whole
                whole = upper/groups
                text(place - 4:place - 1) = group(upper - whole*groups)
                place = place - four
            end if
            upper = whole - merge(signed, 0_i64, units(i) < 0)
            if (upper < merge(0_i64, groups, units(i) < 0)) then
                text(place - 4:place - 1) = front(upper)
            else if (whole < groups) then
                text(place - 5:place - 5) = '-'
                text(place - 4:place - 1) = group(whole)
            else
                call put_units(abs(units(i)), units(i) < 0, decimals, text, int(end))
            end if
            end = end + int(width, i64)
        end do
    end subroutine put_column

    !> Four figures, zeros in front.
    pure character(four) function group(number)
        integer(i64), intent(in) :: number !! 0 to 9999
        integer :: a, b, c, d
        character(four), parameter :: all_groups(0:groups - 1) = [((((figure(a:a)//figure(b:b)// &
            figure(c:c)//figure(d:d), d=1, 10), c=1, 10), b=1, 10), a=1, 10)]
        group = all_groups(number)
    end function group

    !> The front of a number in four columns, blanks before it.
    pure character(four) function front(number)
        integer(i64), intent(in) :: number !! 0 to 9999; below zero: 1000 is added, a minus put
        integer :: a, b, c, d
        character(four), parameter :: fronts(-signed:groups - 1) = [ &
            (((merge('-', ' ', b > 1)//merge(figure(b:b), merge('-', ' ', c > 1), b > 1)// &
            merge(figure(c:c), '-', b + c > 2)//figure(d:d), d=1, 10), c=1, 10), b=1, 10), &
            ((((merge(figure(a:a), ' ', a > 1)//merge(figure(b:b), ' ', a + b > 2)// &
            merge(figure(c:c), ' ', a + b + c > 3)//figure(d:d), &
            d=1, 10), c=1, 10), b=1, 10), a=1, 10)]
        front = fronts(number)
    end function front

end module base_column
