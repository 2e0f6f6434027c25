!> `make bench`: points of cuts a second on one core, beside OpenCASCADE's section of the exported
!> skin, and how the cost grows with points, sections and stations.
!>
!> Data of the picture go to BENCH/cuts.dat: points asked and seconds, a block for each kind of cut.
program cuts
    use, intrinsic :: iso_fortran_env, only: output_unit
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use body_body, only: body_type
    use cut_make, only: make_cut
    use cut_outline, only: cut_point_type, cut_type
    use cut_plane, only: buttock_plane, oblique_plane, plane_type, station_plane, waterline_plane
    use cut_request, only: cut_fact, cut_rule, request_type
    use support_bodies, only: ellipsoid, nose_of_the_book
    implicit none (type, external)

    integer, parameter :: turns = 5
    !> The planes of the nose, as `section.py` has them: millimetres, point and normal.
    character(*), parameter :: name(4) = [character(9) :: 'station', 'waterline', 'buttock', &
        'oblique']
    character(*), parameter :: in_step(4) = [character(24) :: '508,0,0,1,0,0', &
        '0,0,-406.4,0,0,1', '0,114.3,0,0,1,0', '508,0,-406.4,1,0,-1']
    type(body_type) :: nose
    type(plane_type) :: plane(4)
    type(error_type), allocatable :: error

    nose = nose_of_the_book()
    plane(1) = station_plane(20.0_dp)
    plane(2) = waterline_plane(-16.0_dp)
    plane(3) = buttock_plane(4.5_dp)
    call oblique_plane([20.0_dp, -16.0_dp], [30.0_dp, -6.0_dp], plane(4), error)
    call say('## Cuts')
    call say('')
    call say('The nose of SAE 700202 (`cards/nose.crd`), cut by `make_cut` as a user of the')
    call say('library calls it. One core does all; its time is that of the processor, not of the')
    call say('wall, and the best of five turns. By a rough count of the formulas, not measured, a')
    call say('point costs 600 operations of floating point in a station and 4,000 in other planes,')
    call say('most of them in numbers of twice the working precision, done in rows two at a time:')
    call say('these are the limit. A point is written with all that is known of it in '// &
        bytes_of_point()//' bytes.')
    call say('Built for processors with AVX2, by')
    call say('`make "FLAGS.release=-O2 -g -ffp-contract=off -mavx2"`, LOFT does rows four at a')
    call say('time: the same figures, sooner.')
    call say('')
    call print_rates()
    call print_sections()
    call print_growth()

contains

    !> The bytes that a point of a cut takes.
    function bytes_of_point() result(text)
        character(:), allocatable :: text
        type(cut_point_type) :: point
        text = to_text(storage_size(point)/8)
    end function bytes_of_point

    !> Points a second, of many points on one cut and of many cuts with fewer.
    subroutine print_rates()
        call say('| points | asked for | points a second | goal |')
        call say('|---|---|---|---|')
        call print_rate(1, 1, 20000, cut_fact%slope, 'position and slope', '10 million')
        call print_rate(1, 200, 1000, cut_fact%slope, 'position and slope', '10 million')
        call print_rate(1, 20, 20000, cut_fact%bevel, 'with normal and bevel', '3 million')
        call print_rate(1, 20, 20000, cut_fact%all, 'with curvature, proved by a second way', '')
        call print_rate(4, 1, 20000, cut_fact%slope, 'position and slope', '2 million')
        call print_rate(4, 1, 20000, cut_fact%bevel, 'with normal and bevel', '2 million')
        call print_rate(4, 1, 20000, cut_fact%all, 'with curvature, proved by a second way', '')
        call say('')
    end subroutine print_rates

    !> A row of that table.
    subroutine print_rate(kind, count, points, facts, what, goal)
        integer, intent(in) :: kind, count, points, facts
        character(*), intent(in) :: what, goal
        character(120) :: line
        real(dp) :: rate
        rate = real(count, dp)*real(points, dp)/best(nose, plane(kind), count, points, facts)
        write (line, '(a,i0,a,i0,5a,f6.2,3a)') '| ', count, ' x ', points, ', ', trim(name(kind)), &
            ' | ', what, ' | ', 1.0e-6_dp*rate, ' million | ', goal, ' |'
        call say(trim(line))
    end subroutine print_rate

    !> The best time of some cuts, seconds; those of stations are at different ones.
    real(dp) function best(body, plane, count, points, facts)
        type(body_type), intent(in) :: body
        type(plane_type), intent(in) :: plane
        integer, intent(in) :: count, points, facts
        type(request_type) :: request
        type(cut_type) :: cut
        type(error_type), allocatable :: error
        real(dp) :: start, finish
        integer :: turn, i

        best = huge(1.0_dp)
        request%plane = plane
        request%rule = cut_rule%number
        request%number = points
        request%facts = facts
        do turn = 1, turns
            call cpu_time(start)
            do i = 1, count
                if (plane%kind == 1) request%plane = station_plane(plane%through(1) &
                    + 0.01_dp*real(i - 1, dp))
                call make_cut(body, request, cut, error)
                if (allocated(error)) error stop 'a cut of the bench failed'
            end do
            call cpu_time(finish)
            best = min(best, finish - start)
        end do
    end function best

    !> Cuts at 1,000 points beside OpenCASCADE's sections.
    subroutine print_sections()
        character(:), allocatable :: table
        character(4096) :: loft, judges, folder
        character(120) :: line
        real(dp) :: seconds(turns), ours, exact
        integer :: unit, status, i

        call get_environment_variable('LOFT', loft)
        call get_environment_variable('JUDGES', judges)
        call get_environment_variable('BENCH', folder)
        table = trim(folder)//'/section'
        call execute_command_line('test -x '''//trim(judges)//'/bin/python'' && '''//trim(loft)// &
            ''' export cards/nose.crd -o '''//table//'.step'' > /dev/null && '''//trim(judges)// &
            '/bin/python'' tests/bench/section.py '''//table//'.step'' 5 '// &
            trim(in_step(1))//' '//trim(in_step(2))//' '//trim(in_step(3))//' '// &
            trim(in_step(4))//' > '''//table//'.txt''', exitstat=status)
        call say('### Beside OpenCASCADE')
        call say('')
        if (status /= 0) then
            call say('OpenCASCADE is not installed here (`make deps-test`); this part was left')
            call say('out.')
            call say('')
            return
        end if
        call say('`BRepAlgoAPI_Section` of the skin that `loft export cards/nose.crd` writes as')
        call say('STEP, by the same planes, without any points on the curves that come out; the')
        call say('cut of LOFT has 1,000 points. The skin has both halves of the nose; of planes')
        call say('that cut both alike LOFT works out one, which is half of these ratios but for')
        call say('the buttock.')
        call say('')
        call say('| plane | OpenCASCADE | LOFT, slopes | LOFT, all and proved '// &
            '| ratio, slopes | ratio, all |')
        call say('|---|---|---|---|---|---|')
        open (newunit=unit, file=table//'.txt', action='read', status='old')
        do i = 1, 4
            read (unit, *) seconds
            ours = best(nose, plane(i), 1, 1000, cut_fact%slope)
            exact = best(nose, plane(i), 1, 1000, cut_fact%all)
            write (line, '(3a,f7.1,a,f7.3,a,f7.3,a,i0,a,i0,a)') '| ', trim(name(i)), ' | ', &
                1.0e3_dp*minval(seconds), ' ms | ', 1.0e3_dp*ours, ' ms | ', 1.0e3_dp*exact, &
                ' ms | ', nint(minval(seconds)/ours), ' | ', nint(minval(seconds)/exact), ' |'
            call say(trim(line))
        end do
        close (unit)
        call say('')
    end subroutine print_sections

    !> How the time grows: with the points of a cut, the sections of a body and the number of cuts.
    subroutine print_growth()
        integer, parameter :: points(6) = [2, 10, 100, 1000, 10000, 100000]
        character(4096) :: folder
        character(120) :: line
        real(dp) :: seconds(4)
        type(body_type) :: body
        integer :: unit, i, k

        call get_environment_variable('BENCH', folder)
        open (newunit=unit, file=trim(folder)//'/cuts.dat', action='write', status='replace')
        call say('### How it grows')
        call say('')
        call say('One cut with all that is known of its points, milliseconds.')
        call say('')
        call say('| points | station | waterline | buttock | oblique |')
        call say('|---|---|---|---|---|')
        do k = 1, size(points)
            do i = 1, 4
                seconds(i) = best(nose, plane(i), 1, points(k), cut_fact%all)
            end do
            write (unit, '(i0,4es13.4)') points(k), seconds
            write (line, '(a,i0,4(a,f9.3),a)') '| ', points(k), &
                (' | ', 1.0e3_dp*seconds(i), i=1, 4), ' |'
            call say(trim(line))
        end do
        close (unit)
        call say('')
        call say('![Time of a cut over its points](performance-cuts.svg)')
        call say('')
        call say('| sections | stations, 25 points each | milliseconds | microseconds a section |')
        call say('|---|---|---|---|')
        do k = 1, 3
            body = many_sections(ellipsoid([60.0_dp, 5.0_dp, 7.0_dp], 30.0_dp, 0.0_dp), 4**(k - 1))
            do i = 1, 3
                seconds(1) = best(body, station_plane(20.0_dp), 10**(i - 1), 25, cut_fact%all)
                write (line, '(a,i0,a,i0,a,f9.3,a,f8.2,a)') '| ', size(body%sections), ' | ', &
                    10**(i - 1), ' | ', 1.0e3_dp*seconds(1), ' | ', 1.0e6_dp*seconds(1) &
                    /real(10**(i - 1)*size(body%sections), dp), ' |'
                call say(trim(line))
            end do
        end do
    end subroutine print_growth

    !> A body with its sections several times over.
    function many_sections(body, times) result(many)
        type(body_type), intent(in) :: body
        integer, intent(in) :: times
        type(body_type) :: many
        integer :: i
        many = body
        do i = 2, times
            many%sections = [many%sections, body%sections]
        end do
    end function many_sections

    !> A line of the page.
    subroutine say(line)
        character(*), intent(in) :: line
        write (output_unit, '(a)') line
        flush (output_unit)
    end subroutine say

end program cuts
