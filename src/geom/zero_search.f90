!> The search for the zero of a function between two places where its signs differ, one value after
!> another, so that the searches of many zeros can ask for their values together.
!>
!> Source: M. Dowell, P. Jarratt, "A modified regula falsi method for computing the root of an
!> equation", BIT 11 (1971), pp. 168-174 (the Illinois rule), with a halving every third time.
module geom_zero_search
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    implicit none (type, external)
    private

    public :: search_type, new_search, narrow, zero_of, changes

    !> A search: as long as it is not over, the value at `next` is wanted.
    type :: search_type
        logical :: is_over = .false.        !! the zero is found
        real(dp) :: next = 0.0_dp           !! strictly between the places
        real(dp) :: x(2) = 0.0_dp           !! the places
        real(dp) :: y(2) = 0.0_dp           !! the values there, by the Illinois rule halved
        real(dp) :: off(2) = 0.0_dp         !! their magnitudes
        real(dp) :: least = 0.0_dp          !! places nearer to each other are one
        integer :: steps = 0                !! so far
        integer :: moved = 0                !! which place moved last
    end type search_type

    !> Halvings that take any interval of doubles to its last bit.
    integer, parameter :: halvings = 1100

contains

    !> The search between two places; it is over where they are one.
    pure type(search_type) function new_search(x, y) result(search)
        real(dp), intent(in) :: x(2) !! the places
        real(dp), intent(in) :: y(2) !! the values there, of different signs
        search%x = x
        search%y = y
        search%off = abs(y)
        search%least = ulp**2*maxval(abs(x))
        search%is_over = .not. abs(x(2) - x(1)) > 0.0_dp
        if (.not. search%is_over) call propose(search)
    end function new_search

    !> Takes the value that was wanted.
    pure subroutine narrow(search, value)
        type(search_type), intent(inout) :: search  !! not over
        real(dp), intent(in) :: value               !! at `next`
        integer :: moved

        moved = merge(2, 1, changes(search%y(1), value))
        search%x(moved) = search%next
        search%y(moved) = value
        search%off(moved) = abs(value)
        if (moved == search%moved) search%y(3 - moved) = 0.5_dp*search%y(3 - moved)
        search%moved = moved
        if (abs(value) > 0.0_dp) then
            call propose(search)
        else
            search%is_over = .true.
        end if
    end subroutine narrow

    !> Says where the next value is wanted: on the chord where this gains more than halving does.
    pure subroutine propose(search)
        type(search_type), intent(inout) :: search !! gets it, or is over

        search%steps = search%steps + 1
        associate (x => search%x, y => search%y, next => search%next)
            next = x(1) - y(1)*((x(2) - x(1))/(y(2) - y(1)))
            if (mod(search%steps, 3) == 0 .or. .not. is_inside(search)) &
                next = x(1) + 0.5_dp*(x(2) - x(1))
        end associate
        search%is_over = search%steps > halvings .or. .not. is_inside(search)
    end subroutine propose

    !> True where `next` is strictly between the places.
    pure logical function is_inside(search)
        type(search_type), intent(in) :: search !! any
        is_inside = search%next > minval(search%x) + search%least &
            .and. search%next < maxval(search%x) - search%least
    end function is_inside

    !> The zero, to the last bit, and near 0 to the square of the last bit of the range.
    elemental real(dp) function zero_of(search) result(zero)
        type(search_type), intent(in) :: search !! that is over
        zero = search%x(minloc(search%off, dim=1))
    end function zero_of

    !> True where two values have different signs, which zeros have, too.
    elemental logical function changes(first, second)
        real(dp), intent(in) :: first  !! a value
        real(dp), intent(in) :: second !! the next
        changes = sign(1.0_dp, first)*sign(1.0_dp, second) < 0.0_dp
    end function changes

end module geom_zero_search
