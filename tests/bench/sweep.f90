!> How many variants of `cards/sweep.crd` LOFT computes in a second: with one thread and with two,
!> and, where there is MPI, with one, two and four ranks. All are run in turn, five times, each in
!> its own process, rows to /dev/null; the best of each counts.
program sweep
    use, intrinsic :: iso_fortran_env, only: output_unit
    use base_kinds, only: dp, i64
    implicit none (type, external)

    integer, parameter :: turns = 5, variants = 60
    character(*), parameter :: deck = 'cards/sweep.crd', &
        ranks = 'OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun '// &
        '--oversubscribe -n '
    character(24), parameter :: name(5) = [character(24) :: '1 thread', '2 threads', '1 rank', &
        '2 ranks', '4 ranks']
    character(4096) :: loft
    character(:), allocatable :: program
    real(dp) :: best(5), seconds
    logical :: is_there(5)
    integer :: i, turn, status

    call get_environment_variable('LOFT', loft)
    program = ' '''//trim(loft)
    is_there(:2) = .true.
    call execute_command_line('command -v mpirun > /dev/null && test -x'//program//'-mpi''', &
        exitstat=status)
    is_there(3:) = status == 0
    best = huge(1.0_dp)
    do turn = 1, turns
        do i = 1, 5
            if (.not. is_there(i)) cycle
            seconds = seconds_of(command(i))
            best(i) = min(best(i), seconds)
        end do
    end do
    write (output_unit, '(a)') '## Design sweeps', '', &
        'Variants of `'//deck//'` in a second: each is read, built, and measured for volume, '// &
        'wetted area, a floor and a', 'clearance. Ranks are processes of `loft-mpi`, with '// &
        'their '// &
        'start; they share the cores named above.', '', '| | variants/s | to 1 thread |', &
        '|---|---:|---:|'
    do i = 1, 5
        if (is_there(i)) write (output_unit, '(3a,f0.1,a,f0.2,a)') '| ', trim(name(i)), ' | ', &
            real(variants, dp)/best(i), ' | ', best(1)/best(i), ' |'
    end do
    if (.not. all(is_there)) write (output_unit, '(/a)') 'There is no MPI on this machine.'

contains

    !> The line of shell of a case.
    function command(number) result(line)
        integer, intent(in) :: number !! which case
        character(:), allocatable :: line
        character, parameter :: count(5) = ['1', '2', '1', '2', '4']
        line = 'OMP_NUM_THREADS='//count(number)//program//''' sweep '//deck
        if (number > 2) line = 'OMP_NUM_THREADS=1 '//ranks//count(number)//program//'-mpi'' '// &
            'sweep '//deck
        line = line//' > /dev/null'
    end function command

    !> How long a line of shell takes.
    real(dp) function seconds_of(line)
        character(*), intent(in) :: line !! it
        integer(i64) :: begun, ended, rate
        integer :: ignored
        call system_clock(begun, rate)
        call execute_command_line(line, exitstat=ignored)
        call system_clock(ended)
        seconds_of = real(ended - begun, dp)/real(rate, dp)
        if (ignored /= 0) error stop 'the sweep failed'
    end function seconds_of

end program sweep
