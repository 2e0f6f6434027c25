!> Where a function of one variable is zero in an interval: samples that crowd towards both ends, a
!> search for the least magnitude wherever three samples show one, and bisection to the last bit.
!>
!> The function is to be smooth inside; at the ends it may have the infinite slope of a root. Two
!> zeros closer together than the samples are found where the function between them has one extreme
!> that three neighbouring samples show; that is so of any pair further apart than two samples.
module geom_zeros
    use base_constants, only: pi
    use base_kinds, only: dp
    use geom_zero_search, only: changes, narrow, new_search, search_type, zero_of
    implicit none (type, external)
    private

    public :: function_type, zeros_of, zero_between, sample_points, sample_type, samples_of
    public :: brackets_among, zeros_between

    !> Samples of an interval besides its ends: the nearest to an end is 1/4000 of the length
    !> from it, the widest apart are 1/40 of the length.
    integer, parameter :: samples = 63

    !> A function: extend it with what it needs to know, and with `values` where many values at once
    !> cost less.
    type, abstract :: function_type
    contains
        procedure(value_at), deferred :: at
        procedure :: values => one_by_one
    end type function_type

    !> A function at the samples of an interval and its ends.
    type :: sample_type
        real(dp) :: x(samples + 2) = 0.0_dp !! where, in order
        real(dp) :: y(samples + 2) = 0.0_dp !! the values
    end type sample_type

    abstract interface
        !> The value of the function.
        pure real(dp) function value_at(f, x)
            import :: dp, function_type
            implicit none (type, external)
            class(function_type), intent(in) :: f !! the function
            real(dp), intent(in) :: x             !! where
        end function value_at
    end interface

    !> Steps that narrow an extreme: each takes .618 of the interval.
    integer, parameter :: narrowings = 60
    !> How many times the changes of two steps in turn a value must be to be beyond the reach of all
    !> further ones, each of which changes a smooth function by .4 of the one before.
    real(dp), parameter :: hopeless = 1.0e3_dp
    !> Samples that differ by less than this part of their size show no extreme that reaches zero.
    real(dp), parameter :: level = 1.0e-6_dp
    !> Zeros that are searched for together.
    integer, parameter :: block = 512

contains

    !> The zeros in an interval, in order, each once: where the sign changes and, of extremes, where
    !> the magnitude is within `noise`. Ends within `noise` are none. A function within `noise` at
    !> all samples has none.
    pure function zeros_of(f, from, to, noise) result(zeros)
        class(function_type), intent(in) :: f !! the function
        real(dp), intent(in) :: from          !! lower end
        real(dp), intent(in) :: to            !! upper end
        real(dp), intent(in) :: noise         !! magnitude that is nothing but round-off
        real(dp), allocatable :: zeros(:)
        real(dp), allocatable :: brackets(:, :)
        integer :: i

        allocate (brackets(2, 0))
        brackets = brackets_among(f, samples_of(f, from, to), noise)
        zeros = [(zero_between(f, brackets(1, i), brackets(2, i)), i=1, size(brackets, 2))]
    end function zeros_of

    !> A function at the samples of an interval.
    pure type(sample_type) function samples_of(f, from, to) result(sample)
        class(function_type), intent(in) :: f !! the function
        real(dp), intent(in) :: from          !! lower end
        real(dp), intent(in) :: to            !! upper end
        sample%x = [from, sample_points(from, to), to]
        sample%y(1) = f%at(from)
        call f%values(sample%x(2:samples + 1), sample%y(2:samples + 1))
        sample%y(samples + 2) = f%at(to)
    end function samples_of

    !> The places between which the zeros of `zeros_of` are, where the samples are known; an extreme
    !> that is a zero stands twice.
    pure function brackets_among(f, sample, noise) result(brackets)
        class(function_type), intent(in) :: f       !! the function
        type(sample_type), intent(in) :: sample     !! of it
        real(dp), intent(in) :: noise               !! magnitude that is nothing but round-off
        real(dp), allocatable :: brackets(:, :)     !! shape (2, zeros)
        real(dp) :: found(2, 3*samples), x(samples + 2), y(samples + 2), extreme
        integer :: i, clear, count

        count = 0
        x = sample%x
        y = sample%y
        if (any(abs(y) > noise)) then
            clear = findloc(abs(y) > noise, .true., dim=1)
            call settle(y, noise)
            if (changes(y(1), y(2))) call add(x(1), x(2), found, count)
            if (abs(y(2)) > noise) clear = 2
            do i = 3, size(x)
                if (changes(y(i - 1), y(i))) call add(x(clear), x(i), found, count)
                if (abs(y(i)) > noise) clear = i
                if (.not. is_nearing(y(i - 2:i))) cycle
                extreme = least_magnitude(f, x(i - 2), x(i), sign(1.0_dp, y(i)))
                if (abs(f%at(extreme)) <= noise) then
                    call add(extreme, extreme, found, count)
                else if (changes(y(i), f%at(extreme))) then
                    call add(x(i - 2), extreme, found, count)
                    call add(extreme, x(i), found, count)
                end if
            end do
        end if
        brackets = found(:, :count)
    end function brackets_among

    !> Adds a pair of places.
    pure subroutine add(from, to, brackets, count)
        real(dp), intent(in) :: from                !! one
        real(dp), intent(in) :: to                  !! the other
        real(dp), intent(inout) :: brackets(:, :)   !! gets them
        integer, intent(inout) :: count             !! of its pairs that are used
        count = count + 1
        brackets(:, count) = [from, to]
    end subroutine add

    !> The values of a function.
    pure subroutine one_by_one(f, x, y)
        class(function_type), intent(in) :: f   !! the function
        real(dp), intent(in) :: x(:)            !! where
        real(dp), intent(out) :: y(:)           !! one for each
        integer :: i
        do i = 1, size(x)
            y(i) = f%at(x(i))
        end do
    end subroutine one_by_one

    !> Gives values that are nothing but round-off the sign of the value before.
    pure subroutine settle(y, noise)
        real(dp), intent(inout) :: y(:) !! samples, one of them at least above the noise
        real(dp), intent(in) :: noise   !! magnitude that is nothing but round-off
        integer :: i, first

        first = findloc(abs(y) > noise, .true., dim=1)
        y(:first - 1) = sign(y(:first - 1), y(first))
        do i = first + 1, size(y)
            if (abs(y(i)) <= noise) y(i) = sign(y(i), y(i - 1))
        end do
    end subroutine settle

    !> The samples of an interval, in order, without its ends.
    pure function sample_points(from, to) result(x)
        real(dp), intent(in) :: from !! lower end
        real(dp), intent(in) :: to   !! upper end
        real(dp) :: x(samples)
        integer :: i
        do i = 1, samples
            x(i) = from + (to - from)*sin(0.5_dp*pi*real(i, dp)/real(samples + 1, dp))**2
        end do
    end function sample_points

    !> True where three values of one sign have their least magnitude in the middle, and differ by
    !> more than what is nothing beside them.
    pure logical function is_nearing(y)
        real(dp), intent(in) :: y(3) !! neighbouring values
        is_nearing = .not. any(changes(y(1), y(2:3))) .and. abs(y(2)) <= min(abs(y(1)), abs(y(3))) &
            .and. max(abs(y(1)), abs(y(3))) - abs(y(2)) >= level*abs(y(2))
    end function is_nearing

    !> Where `side*f` is least in an interval, by the golden section; it stops where this is below
    !> zero, or so far above that what is left of the interval can't take it there.
    pure real(dp) function least_magnitude(f, from, to, side) result(best)
        class(function_type), intent(in) :: f !! the function
        real(dp), intent(in) :: from          !! lower end
        real(dp), intent(in) :: to            !! upper end
        real(dp), intent(in) :: side          !! 1 or -1: sign of the function at the ends
        real(dp), parameter :: golden = 0.5_dp*(sqrt(5.0_dp) - 1.0_dp)
        real(dp) :: low, high, inner(2), value(2), change
        integer :: i

        low = from
        high = to
        inner = [high - golden*(high - low), low + golden*(high - low)]
        value = side*[f%at(inner(1)), f%at(inner(2))]
        change = maxval(value)
        do i = 1, narrowings
            if (any(value < 0.0_dp)) exit
            if (minval(value) > hopeless*max(change, abs(value(1) - value(2)))) exit
            change = abs(value(1) - value(2))
            if (value(1) <= value(2)) then
                high = inner(2)
                inner = [high - golden*(high - low), inner(1)]
                value = [side*f%at(inner(1)), value(1)]
            else
                low = inner(1)
                inner = [inner(2), low + golden*(high - low)]
                value = [value(2), side*f%at(inner(2))]
            end if
        end do
        best = inner(minloc(value, dim=1))
    end function least_magnitude

    !> The zero between two places where the signs differ, to the last bit, and near 0 to the square
    !> of the last bit of the range; of one place, that.
    pure real(dp) function zero_between(f, from, to) result(zero)
        class(function_type), intent(in) :: f !! the function
        real(dp), intent(in) :: from          !! one end
        real(dp), intent(in) :: to            !! the other end, the sign is another there
        type(search_type) :: search

        search = new_search([from, to], [f%at(from), f%at(to)])
        do while (.not. search%is_over)
            call narrow(search, f%at(search%next))
        end do
        zero = zero_of(search)
    end function zero_between

    !> What `zero_between` says of a function less one level after another, with the values of many
    !> searches asked for together.
    pure subroutine zeros_between(f, brackets, levels, zeros)
        class(function_type), intent(in) :: f       !! the function
        real(dp), intent(in) :: brackets(:, :)      !! shape (2, zeros): see `brackets_among`
        real(dp), intent(in) :: levels(:)           !! one for each
        real(dp), intent(out) :: zeros(:)           !! one for each
        integer :: first, last
        do first = 1, size(levels), block
            last = min(first + block - 1, size(levels))
            call search_together(f, brackets(:, first:last), levels(first:last), zeros(first:last))
        end do
    end subroutine zeros_between

    !> A block of them.
    pure subroutine search_together(f, brackets, levels, zeros)
        class(function_type), intent(in) :: f       !! the function
        real(dp), intent(in) :: brackets(:, :)      !! shape (2, zeros)
        real(dp), intent(in) :: levels(:)           !! one for each
        real(dp), intent(out) :: zeros(:)           !! one for each
        type(search_type), allocatable :: search(:)
        integer, allocatable :: left(:)
        real(dp) :: y(size(levels), 2)
        integer :: i

        allocate (search(size(levels)), left(0))
        call f%values(brackets(1, :), y(:, 1))
        call f%values(brackets(2, :), y(:, 2))
        do i = 1, size(levels)
            search(i) = new_search(brackets(:, i), y(i, :) - levels(i))
        end do
        left = pack([(i, i=1, size(levels))], .not. search%is_over)
        do while (size(left) > 0)
            call f%values(search(left)%next, y(:size(left), 1))
            do i = 1, size(left)
                call narrow(search(left(i)), y(i, 1) - levels(left(i)))
            end do
            left = pack(left, .not. search(left)%is_over)
        end do
        zeros = zero_of(search)
    end subroutine search_together

end module geom_zeros
