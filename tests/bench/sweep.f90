!> How many variants of the nose of `cards/sweep.crd` LOFT computes in a second: with one thread and
!> with two, and, where there is MPI, with one, two and four ranks. 240 variants, so that the start
!> of the processes, which is measured by itself, is a small part. All are run in turn, three times,
!> rows to /dev/null; the best of each counts.
program sweep
    use, intrinsic :: iso_fortran_env, only: output_unit
    use base_kinds, only: dp, i64
    implicit none (type, external)

    integer, parameter :: turns = 3, variants = 240
    character(*), parameter :: deck = 'cards/sweep.crd', &
        more = 'sed "s/^SWEEP   LATIN   60 /SWEEP   LATIN   240/" '//deck//' | ', &
        ranks = 'OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun '// &
        '--oversubscribe -n '
    character(9), parameter :: name(5) = [character(9) :: '1 thread', '2 threads', '1 rank', &
        '2 ranks', '4 ranks']
    character, parameter :: count(5) = ['1', '2', '1', '2', '4']
    character(4096) :: loft
    real(dp) :: best(5), start(5)
    logical :: is_there(5)
    integer :: i, turn, status

    call get_environment_variable('LOFT', loft)
    is_there(:2) = .true.
    call execute_command_line('command -v mpirun > /dev/null && test -x '''//trim(loft)// &
        '-mpi''', exitstat=status)
    is_there(3:) = status == 0
    best = huge(1.0_dp)
    start = huge(1.0_dp)
    do turn = 1, turns
        do i = 1, 5
            if (.not. is_there(i)) cycle
            start(i) = min(start(i), seconds_of(command(i, '--variant 1')))
            best(i) = min(best(i), seconds_of(command(i, '')))
        end do
    end do
    call print_section()

contains

    !> The section of the page.
    subroutine print_section()
        write (output_unit, '(a)') '## Design sweeps', '', &
            'Variants of `'//deck//'` in a second, 240 of them: each is read, built, and '// &
            'measured for volume, wetted area, a', 'floor and a clearance. Ranks are processes '// &
            'of `loft-mpi`; they share the cores named above, so that four', 'of them on two '// &
            'cores can''t be faster than two. The start, which the rate includes, is the time '// &
            'of a sweep', 'that only prints the deck of a variant.', '', &
            '| | variants/s | to 1 thread | start, s |', '|---|---:|---:|---:|'
        do i = 1, 5
            if (is_there(i)) write (output_unit, '(3a,f0.1,a,f0.2,a,f0.2,a)') '| ', &
                trim(name(i)), ' | ', real(variants, dp)/best(i), ' | ', best(1)/best(i), ' | ', &
                start(i), ' |'
        end do
        if (.not. all(is_there)) write (output_unit, '(/a)') 'There is no MPI on this machine.'
    end subroutine print_section

    !> The line of shell of a case.
    function command(number, option) result(line)
        integer, intent(in) :: number       !! which case
        character(*), intent(in) :: option  !! of the sweep
        character(:), allocatable :: line

        if (number > 2) then
            line = more//ranks//count(number)//' '''//trim(loft)//'-mpi'''
        else
            line = more//'OMP_NUM_THREADS='//count(number)//' '''//trim(loft)//''''
        end if
        line = line//' sweep - '//option//' > /dev/null'
    end function command

    !> How long a line of shell takes.
    real(dp) function seconds_of(line)
        character(*), intent(in) :: line !! it
        integer(i64) :: begun, ended, rate
        integer :: status
        call system_clock(begun, rate)
        call execute_command_line(line, exitstat=status)
        call system_clock(ended)
        seconds_of = real(ended - begun, dp)/real(rate, dp)
        if (status /= 0) error stop 'the sweep failed'
    end function seconds_of

end program sweep
