!> `make bench`: the tables of a 1970 deck beside the obvious programs for them, in Fortran and in
!> C, and beside the mere writing of as many bytes. The obvious program reads the cards with
!> list-directed READ, solves the five equations, takes the nearer root and prints abscissa,
!> ordinate, slope, angle and radius of curvature with formatted WRITE.
!>
!> Each side runs in a process of its own and writes a file in memory (/dev/shm), all in turn; the
!> best of five turns counts. Called as `tables obvious DECK` this is the obvious program.
program tables
    use, intrinsic :: iso_fortran_env, only: error_unit, output_unit
    use base_constants, only: degrees
    use base_kinds, only: dp, i64
    use base_text, only: to_text
    implicit none (type, external)

    integer, parameter :: cards = 20000, turns = 5, growths = 4
    real(dp), parameter :: step = 0.8_dp, shift = 100.0_dp
    !> Rows of a card.
    integer, parameter :: rows = 101
    !> What all sides write: a file in memory.
    character(*), parameter :: target_file = '/dev/shm/loft-bench.out'

    !> A command and the best of its times.
    type :: side_type
        character(:), allocatable :: name       !! what it is, for a table
        character(:), allocatable :: command    !! for the shell
        real(dp) :: best = huge(1.0_dp)         !! seconds
        integer(i64) :: bytes = 0               !! written
    end type side_type

    character(4096) :: word, own_name

    call get_command_argument(1, word)
    if (word == 'obvious') then
        call get_command_argument(2, word)
        call run_obvious(trim(word))
    else
        call get_command_argument(0, own_name)
        call compare(trim(own_name), value_of('LOFT'), value_of('BENCH'))
    end if

contains

    !> A variable of the environment.
    function value_of(name) result(value)
        character(*), intent(in) :: name !! its name
        character(:), allocatable :: value
        character(4096) :: room
        call get_environment_variable(name, room)
        value = trim(room)
    end function value_of

    !> Times all sides and prints the section.
    subroutine compare(self, loft, bench)
        character(*), intent(in) :: self    !! path of this program
        character(*), intent(in) :: loft    !! path of LOFT
        character(*), intent(in) :: bench   !! folder with the C program
        type(side_type) :: side(9)
        character(:), allocatable :: deck, plain
        integer :: turn, i

        deck = bench//'/tables.crd'
        plain = quoted(bench//'/plain')
        call make_deck(deck, cards)
        side(1) = side_type('obvious Fortran', quoted(self)//' obvious '//quoted(deck))
        side(2) = side_type('C, printf', plain//' print '//quoted(deck))
        side(3) = side_of('listing', '', 1, loft, deck)
        side(4) = side_of('listing', '', 2, loft, deck)
        side(5) = side_of('CSV', '--format csv ', 1, loft, deck)
        side(6) = side_of('CSV', '--format csv ', 2, loft, deck)
        side(7) = side_of('s360', '--arithmetic s360 ', 1, loft, deck)
        side(8) = side_of('s360', '--arithmetic s360 ', 2, loft, deck)
        call take_time(side(4))
        side(9) = side_type('write alone', plain//' write '//to_text(side(4)%bytes))
        do turn = 1, turns
            do i = 1, size(side)
                call take_time(side(i))
            end do
        end do
        call print_sides(side)
        call print_growth(loft, deck)
        call execute_command_line('rm -f '//quoted(deck)//' '//target_file)
    end subroutine compare

    !> A run of LOFT.
    function side_of(name, options, threads, loft, deck) result(side)
        character(*), intent(in) :: name    !! what it prints
        character(*), intent(in) :: options !! of `loft run`
        integer, intent(in) :: threads      !! how many
        character(*), intent(in) :: loft    !! its path
        character(*), intent(in) :: deck    !! the deck
        type(side_type) :: side
        side%name = 'LOFT '//name//', '//to_text(threads)//trim(merge(' thread ', ' threads', &
            threads == 1))
        side%command = 'OMP_NUM_THREADS='//to_text(threads)//' '//quoted(loft)//' run '// &
            options//quoted(deck)
    end function side_of

    !> Prints the times of all sides.
    subroutine print_sides(side)
        type(side_type), intent(in) :: side(:)  !! the obvious one, C, LOFT, the floor
        integer :: i

        call say('## Tables')
        call say('')
        call say('A 1970 deck of '//to_text(cards)//' cards and '//to_text(cards*rows)// &
            ' rows. The obvious programs read the same cards and print the same five columns')
        call say('(`tests/bench/tables.f90`, `plain.c`). LOFT also finds every fault of a card,')
        call say('describes each conic, rounds every figure correctly and numbers its pages. All')
        call say('write a new file in /dev/shm; `write alone` writes the bytes of the listing')
        call say('there, from memory. Two threads need two cores that have nothing else to do.')
        call say('')
        call say('| program | seconds | MB | MB/s | million rows/s | times the obvious | '// &
            'times printf | writes |')
        call say('|---|---|---|---|---|---|---|---|')
        do i = 1, size(side)
            call say('| '//side(i)%name//' | '//decimal(side(i)%best, 3)//' | '// &
                decimal(real(side(i)%bytes, dp)/1.0e6_dp, 0)//' | '// &
                decimal(real(side(i)%bytes, dp)/1.0e6_dp/side(i)%best, 0)//' | '// &
                decimal(real(cards*rows, dp)/1.0e6_dp/side(i)%best, 2)//' | '// &
                decimal(side(1)%best/side(i)%best, 1)//' | '// &
                decimal(side(2)%best/side(i)%best, 1)//' | '// &
                decimal(side(i)%best/side(size(side))%best, 1)//' |')
        end do
        call say('')
    end subroutine print_sides

    !> Prints how the time of a listing grows with the cards.
    subroutine print_growth(loft, deck)
        character(*), intent(in) :: loft !! path of LOFT
        character(*), intent(in) :: deck !! where the decks go
        type(side_type) :: side
        integer :: i, turn, count

        call say('| cards of a listing, 2 threads | seconds | microseconds a card |')
        call say('|---|---|---|')
        do i = 0, growths - 1
            count = 5000*2**i
            call make_deck(deck, count)
            side = side_of('listing', '', 2, loft, deck)
            do turn = 1, turns
                call take_time(side)
            end do
            call say('| '//to_text(count)//' | '//decimal(side%best, 3)//' | '// &
                decimal(1.0e6_dp*side%best/real(count, dp), 1)//' |')
        end do
    end subroutine print_growth

    !> Prints a line.
    subroutine say(text)
        character(*), intent(in) :: text !! the line
        write (output_unit, '(a)') text
    end subroutine say

    !> A number with so many decimals.
    function decimal(value, decimals) result(text)
        real(dp), intent(in) :: value   !! the number
        integer, intent(in) :: decimals !! 0 to 9
        character(:), allocatable :: text
        character(32) :: field
        write (field, '(f32.'//to_text(decimals)//')') value
        text = trim(adjustl(field))
        if (decimals == 0) text = text(:len(text) - 1)
    end function decimal

    !> A path as one word of the shell.
    pure function quoted(path)
        character(*), intent(in) :: path    !! without an apostrophe
        character(:), allocatable :: quoted
        quoted = ''''//path//''''
    end function quoted

    !> Writes the deck: the first card of SAE 700202, its shoulder point raised little by little.
    subroutine make_deck(path, count)
        character(*), intent(in) :: path    !! where it goes
        integer, intent(in) :: count        !! cards
        integer :: unit, i
        open (newunit=unit, file=path, action='write', status='replace')
        do i = 1, count
            write (unit, '(2f8.3,f8.5,4f8.3,f8.5,2f6.3,i2)') -30.0_dp, -10.0_dp, 0.114_dp, 0.0_dp, &
                -7.1_dp + 0.001_dp*real(mod(i, 100), dp), 50.0_dp, -4.0_dp, 0.0523_dp, &
                step, 0.0_dp, 0
        end do
        close (unit)
    end subroutine make_deck

    !> Runs a command, which writes a new file; keeps its time where it is the best, and how much it
    !> wrote.
    subroutine take_time(side)
        type(side_type), intent(inout) :: side !! the command
        integer(i64) :: start, finish, rate
        integer :: status
        call execute_command_line('rm -f '//target_file)
        call system_clock(start, rate)
        call execute_command_line(side%command//' > '//target_file, exitstat=status)
        call system_clock(finish)
        if (status /= 0) then
            write (error_unit, '(a,i0,2a)') 'status ', status, ' of ', side%command
            stop 1, quiet=.true.
        end if
        side%best = min(side%best, real(finish - start, dp)/real(rate, dp))
        inquire (file=target_file, size=side%bytes)
    end subroutine take_time

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

end program tables
