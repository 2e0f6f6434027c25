!> `make bench`: how long LOFT takes beside the obvious Fortran program for the same deck, which
!> reads the cards with list-directed READ, solves the five equations, takes the nearer root and
!> prints abscissa, ordinate, slope, angle and radius of curvature with formatted WRITE.
!>
!> Both are run in turn, each in its own process with its output to /dev/null; shown is the median
!> of the ratios of five turns. Called as `bench obvious DECK` it is the obvious program.
program bench
    use, intrinsic :: iso_fortran_env, only: error_unit, output_unit
    use base_constants, only: degrees
    use base_kinds, only: dp, i64
    implicit none (type, external)

    integer, parameter :: cards = 1000, turns = 5
    real(dp), parameter :: step = 0.4_dp, shift = 100.0_dp
    character(4096) :: word, program_name

    call get_command_argument(1, word)
    if (word == 'obvious') then
        call get_command_argument(2, word)
        call run_obvious(trim(word))
    else
        call get_command_argument(0, program_name)
        call get_environment_variable('LOFT', word)
        call compare(trim(word), trim(program_name))
    end if

contains

    !> Times the ways of LOFT against the obvious program.
    subroutine compare(loft, self)
        character(*), intent(in) :: loft    !! path of LOFT
        character(*), intent(in) :: self    !! path of this program
        character(:), allocatable :: deck, obvious, run

        deck = self//'.crd'
        call make_deck(deck)
        obvious = quoted(self)//' obvious '//quoted(deck)
        run = quoted(loft)//' run '
        write (output_unit, '(i0,a,i0,a)') cards, ' cards of ', nint(80.0_dp/step) + 1, &
            ' rows each; time of LOFT over that of the obvious program'
        call print_ratio('ieee listing', run//quoted(deck), obvious)
        call print_ratio('ieee csv', run//'--format csv '//quoted(deck), obvious)
        call print_ratio('s360 listing', run//'--arithmetic s360 '//quoted(deck), obvious)
        call execute_command_line('rm -f '//quoted(deck))
    end subroutine compare

    !> A path as one word of the shell.
    pure function quoted(path)
        character(*), intent(in) :: path    !! without an apostrophe
        character(:), allocatable :: quoted
        quoted = ''''//path//''''
    end function quoted

    !> Writes the deck: the first card of SAE 700202, its shoulder point raised little by little.
    subroutine make_deck(path)
        character(*), intent(in) :: path    !! where it goes
        integer :: unit, i
        open (newunit=unit, file=path, action='write', status='replace')
        do i = 1, cards
            write (unit, '(2f8.3,f8.5,4f8.3,f8.5,2f6.3,i2)') -30.0_dp, -10.0_dp, 0.114_dp, 0.0_dp, &
                -7.1_dp + 0.001_dp*real(mod(i, 100), dp), 50.0_dp, -4.0_dp, 0.0523_dp, &
                step, 0.0_dp, 0
        end do
        close (unit)
    end subroutine make_deck

    !> Prints the median ratio of the times of two commands, run in turn.
    subroutine print_ratio(name, command, other)
        character(*), intent(in) :: name    !! what the first command is
        character(*), intent(in) :: command !! the first
        character(*), intent(in) :: other   !! the second
        real(dp) :: ratio(turns)
        integer :: i
        do i = 1, turns
            ratio(i) = seconds(command)/seconds(other)
        end do
        write (output_unit, '(a,t16,f8.2,a,f0.2,a,f0.2)') name, median(ratio), '   from ', &
            minval(ratio), ' to ', maxval(ratio)
    end subroutine print_ratio

    !> Time of a command, seconds.
    real(dp) function seconds(command)
        character(*), intent(in) :: command !! for the shell
        integer(i64) :: start, finish, rate
        integer :: status
        call system_clock(start, rate)
        call execute_command_line(command//' > /dev/null', exitstat=status)
        call system_clock(finish)
        if (status /= 0) then
            write (error_unit, '(a,i0,2a)') 'status ', status, ' of ', command
            stop 1, quiet=.true.
        end if
        seconds = real(finish - start, dp)/real(rate, dp)
    end function seconds

    !> The middle one of an odd count of numbers.
    pure real(dp) function median(value)
        real(dp), intent(in) :: value(:)    !! in any order
        integer :: i
        do i = 1, size(value)
            median = value(i)
            if (count(value < median) <= size(value)/2 .and. &
                count(value > median) <= size(value)/2) return
        end do
    end function median

    !> The obvious program.
    subroutine run_obvious(deck)
        character(*), intent(in) :: deck    !! cards with blanks between their numbers
        real(dp) :: card(10)
        integer :: unit, status, ityp
        open (newunit=unit, file=deck, action='read', status='old')
        do
            read (unit, *, iostat=status) card, ityp
            if (status /= 0) exit
            call print_table(card, coefficients_of(card))
        end do
        close (unit)
    end subroutine run_obvious

    !> The conic of a card by elimination with partial pivoting, in the shifted frame.
    pure function coefficients_of(card) result(a)
        real(dp), intent(in) :: card(10)    !! X1 Y1 S1 X2 Y2 X3 Y3 S3 XI YI
        real(dp) :: a(5), w(5, 6), row(6), x(3), y(3)
        integer :: i, k, pivot

        x = card([1, 4, 6]) + shift
        y = card([2, 5, 7]) + shift
        do i = 1, 3
            w(i, :) = [x(i)**2, x(i)*y(i), y(i)**2, x(i), y(i), -1.0_dp]
        end do
        w(4, :) = [2.0_dp*x(1), y(1) + card(3)*x(1), 2*card(3)*y(1), 1.0_dp, card(3), 0.0_dp]
        w(5, :) = [2*x(3), y(3) + card(8)*x(3), 2*card(8)*y(3), 1.0_dp, card(8), 0.0_dp]
        do k = 1, 5
            pivot = k - 1 + maxloc(abs(w(k:, k)), dim=1)
            row = w(pivot, :)
            w(pivot, :) = w(k, :)
            w(k, :) = row/row(k)
            do i = 1, 5
                if (i /= k) w(i, :) = w(i, :) - w(i, k)*w(k, :)
            end do
        end do
        a = w(:, 6)
    end function coefficients_of

    !> Steps X and prints a row for each step.
    subroutine print_table(card, k)
        real(dp), intent(in) :: card(10)    !! X1 Y1 S1 X2 Y2 X3 Y3 S3 XI YI
        real(dp), intent(in) :: k(5)        !! A to E
        real(dp) :: x, y, h, g, r, fx, fy, radius
        integer :: i

        y = card(2) + shift
        do i = 0, nint((card(6) - card(1))/card(9))
            x = card(1) + real(i, dp)*card(9) + shift
            h = k(2)*x + k(5)
            g = (k(1)*x + k(4))*x + 1.0_dp
            r = sqrt(abs(h**2 - 4*k(3)*g))
            if (abs((-h + r)/(2*k(3)) - y) < abs((-h - r)/(2*k(3)) - y)) then
                y = (-h + r)/(2*k(3))
            else
                y = (-h - r)/(2*k(3))
            end if
            fx = 2*k(1)*x + k(2)*y + k(4)
            fy = k(2)*x + 2*k(3)*y + k(5)
            radius = sqrt(fx**2 + fy**2)**3/(2*k(2)*fx*fy - 2*k(1)*fy**2 - 2*k(3)*fx**2)
            write (output_unit, '(2f14.4,f14.6,f12.4,f22.4)') x - shift, y - shift, -fx/fy, &
                atan(-fx/fy)*degrees, radius*sign(1.0_dp, fy)
        end do
    end subroutine print_table

end program bench
