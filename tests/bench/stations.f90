!> `make bench`: how the time of `loft run` grows with the stations of a deck, by one thread and by
!> two. Every run is a process of its own; the best of three counts.
program stations
    use, intrinsic :: iso_fortran_env, only: output_unit
    use base_kinds, only: dp, i64
    use base_text, only: to_text
    implicit none (type, external)

    integer, parameter :: turns = 3, counts(4) = [100, 1000, 10000, 100000]
    character(*), parameter :: deck = 'cards/nose.crd'
    character(4096) :: loft, folder
    character(:), allocatable :: many
    character(120) :: line
    real(dp) :: best(2)
    integer :: i, turn, threads

    call get_environment_variable('LOFT', loft)
    call get_environment_variable('BENCH', folder)
    many = trim(folder)//'/stations.crd'
    call say('## Decks of many stations')
    call say('')
    call say('`loft run` of the nose (`'//deck//'`) with nothing but stations, 25 points each,')
    call say('with all that is known of them; the listing goes to /dev/null. Cuts are made side by')
    call say('side and printed in order; the last column is of one thread. A body whose cuts would')
    call say('fill more than 2 GiB is refused.')
    call say('')
    call say('| stations | 1 thread, seconds | 2 threads, seconds | microseconds a station |')
    call say('|---|---|---|---|')
    do i = 1, size(counts)
        call write_deck(counts(i))
        best = huge(1.0_dp)
        do turn = 1, turns
            do threads = 1, 2
                best(threads) = min(best(threads), seconds_of('OMP_NUM_THREADS='// &
                    to_text(threads)//' '''//trim(loft)//''' run '''//many//''' > /dev/null'))
            end do
        end do
        write (line, '(a,i0,3(a,f0.3),a)') '| ', counts(i), ' | ', best(1), ' | ', best(2), &
            ' | ', 1.0e6_dp*best(1)/real(counts(i), dp), ' |'
        call say(trim(line))
    end do

contains

    !> Writes the nose with so many stations in 50 inches.
    subroutine write_deck(count)
        integer, intent(in) :: count
        character(132) :: card
        integer :: in, out, status

        open (newunit=in, file=deck, action='read', status='old')
        open (newunit=out, file=many, action='write', status='replace')
        do
            read (in, '(a)', iostat=status) card
            if (status /= 0 .or. card(:7) == 'STATION') exit
            write (out, '(a)') trim(card)
        end do
        write (out, '(a,f0.6,a)') 'STATION,0.,50.,', 50.0_dp/real(count - 1, dp), ','
        write (out, '(a)') 'END'
        close (in)
        close (out)
    end subroutine write_deck

    !> How long a line of shell takes, wall clock.
    real(dp) function seconds_of(command) result(seconds)
        character(*), intent(in) :: command
        integer(i64) :: start, finish, rate
        integer :: status

        call system_clock(start, rate)
        call execute_command_line(command, exitstat=status)
        call system_clock(finish)
        if (status /= 0) error stop 'a run of the bench failed'
        seconds = real(finish - start, dp)/real(rate, dp)
    end function seconds_of

    !> A line of the page.
    subroutine say(text)
        character(*), intent(in) :: text
        write (output_unit, '(a)') text
        flush (output_unit)
    end subroutine say

end program stations
