!> How the points of a cut are spread along a track: the stations at which it has points.
module cut_spread
    use base_constants, only: largest_table
    use base_decimal, only: grid_type
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp, i64
    use base_list, only: list_type
    use base_order, only: ascending
    use base_text, only: compact, to_text
    use base_tolerances, only: decimal_noise, spacing_tolerance, ulp
    use body_body, only: body_type, smooth_stops
    use body_section, only: trace_at, trace_type
    use cut_plane, only: plane_type
    use cut_request, only: cut_rule, request_type
    use cut_track, only: track_type
    use cut_walk, only: coordinate_type, parameter_of, point_at, speed_type, station_of
    use geom_spacing, only: new_scale, parameters_at, scale_type
    use geom_triangle, only: rounding
    use geom_vector, only: cross
    use geom_zeros, only: brackets_among, sample_type, samples_of, zeros_between
    implicit none (type, external)
    private

    public :: stations_on, steps_inside

    !> Halvings of a track for chords: what is left is below the rounding of its points.
    integer, parameter :: deepest = 40
    !> How far above the rounding of its points a section must rise for smooth outlines.
    real(dp), parameter :: nearly_shrunk = 1.0e6_dp

contains

    !> The stations of the points of a track, in order, both its ends included.
    !>
    !> Fails with `cause%too_many` where there are more than `largest_table`, and with
    !> `cause%no_convergence` where a length can't be found.
    pure subroutine stations_on(body, track, request, stations, error)
        type(body_type), intent(in) :: body                     !! finished
        type(track_type), intent(in) :: track                   !! of that body and request
        type(request_type), intent(in) :: request               !! the rule
        real(dp), allocatable, intent(out) :: stations(:)       !! deck units
        type(error_type), allocatable, intent(out) :: error     !! see above
        real(dp), allocatable :: inside(:)

        allocate (inside(0))
        select case (request%rule)
        case (cut_rule%step)
            if (request%axis == 1) then
                call steps_inside(request%grid, [track%from%sta, track%to%sta], inside, error)
            else
                call crossings(body, track, request, inside, error)
            end if
        case (cut_rule%chord)
            call within_chords(body, request%plane, track, request%step, inside, error)
        case default
            call equal_lengths(body, track, request, inside, error)
        end select
        if (allocated(error)) return
        stations = [track%from%sta, inside, track%to%sta]
    end subroutine stations_on

    !> The stepped ordinates strictly inside of a range, further than lost decimals from its ends,
    !> in ascending order. Fails with `cause%too_many`.
    pure subroutine steps_inside(grid, ends, ordinates, error)
        type(grid_type), intent(in) :: grid                     !! the stepped ordinates
        real(dp), intent(in) :: ends(2)                         !! deck units, in order
        real(dp), allocatable, intent(out) :: ordinates(:)      !! deck units
        type(error_type), allocatable, intent(out) :: error     !! see above
        real(dp) :: steps(2), noise
        integer(i64) :: k, first, last

        steps = [grid%steps_to(ends(1)), grid%steps_to(ends(2))]
        if (abs(steps(2) - steps(1)) > largest_table .or. any(abs(steps) > huge(1))) then
            call fail(error, cause%too_many, 'the steps between '//compact(ends(1))//' and '// &
                compact(ends(2))//' are too many; LOFT makes at most '//to_text(largest_table)// &
                ' points: take a longer step, or start the steps nearer to them')
            return
        end if
        first = floor(minval(steps), i64)
        last = ceiling(maxval(steps), i64)
        allocate (ordinates(0))
        ordinates = [(grid%ordinate(k), k=first, last)]
        if (steps(2) < steps(1)) ordinates = ordinates(size(ordinates):1:-1)
        noise = decimal_noise*ulp*maxval(abs(ends))
        ordinates = pack(ordinates, ordinates > ends(1) + noise .and. ordinates < ends(2) - noise)
    end subroutine steps_inside

    !> The stations where a track passes the stepped ordinates of BL or WL.
    pure subroutine crossings(body, track, request, stations, error)
        type(body_type), intent(in) :: body                     !! finished
        type(track_type), intent(in) :: track                   !! of that body and request
        type(request_type), intent(in) :: request               !! axis and grid
        real(dp), allocatable, intent(inout) :: stations(:)     !! deck units, in order
        type(error_type), allocatable, intent(out) :: error     !! see `stations_on`
        type(coordinate_type) :: along
        type(sample_type) :: known, sample
        type(list_type) :: places, passed
        real(dp), allocatable :: levels(:), brackets(:, :)
        integer :: i

        along%body = body
        along%plane = request%plane
        along%track = track
        along%axis = request%axis
        known = samples_of(along, track%from%sta, track%to%sta)
        call steps_inside(request%grid, [minval(known%y), maxval(known%y)], levels, error)
        if (allocated(error)) return
        allocate (brackets(2, 0))
        sample = known
        do i = 1, size(levels)
            along%level = levels(i)
            sample%y = known%y - levels(i)
            brackets = brackets_among(along, sample, 0.0_dp)
            call places%add(reshape(brackets, [size(brackets)]))
            call passed%add(spread(levels(i), 1, size(brackets, 2)))
        end do
        levels = passed%all()
        brackets = reshape(places%all(), [2, size(levels)])
        deallocate (stations)
        allocate (stations(size(levels)))
        along%level = 0.0_dp
        call zeros_between(along, brackets, levels, stations)
        stations = ascending(stations)
    end subroutine crossings

    !> The stations inside that divide a track into equal lengths. Fails with `cause%too_many` and
    !> with the causes of `new_scale`.
    pure subroutine equal_lengths(body, track, request, stations, error)
        type(body_type), intent(in) :: body                     !! finished
        type(track_type), intent(in) :: track                   !! of that body and request
        type(request_type), intent(in) :: request               !! number or length
        real(dp), allocatable, intent(inout) :: stations(:)     !! deck units
        type(error_type), allocatable, intent(out) :: error     !! see `stations_on`
        type(speed_type) :: speed
        type(scale_type) :: scale
        real(dp), allocatable :: stops(:), length(:), t(:)
        integer :: parts, i

        speed%body = body
        speed%plane = request%plane
        speed%track = track
        allocate (stops(0))
        stops = smooth_stops(body, body%sections(track%section))
        stops = pack(stops, stops > track%from%sta .and. stops < track%to%sta)
        stops = [0.0_dp, (parameter_of(track, stops(i)), i=1, size(stops)), 1.0_dp]
        call new_scale(speed, stops, spacing_tolerance, scale, error)
        if (allocated(error)) call blame_section(body, track, error)
        if (allocated(error)) return
        parts = max(1, request%number - 1)
        if (request%rule == cut_rule%length) then
            if (scale%length/request%step > largest_table) then
                call fail(error, cause%too_many, 'lengths of '//compact(request%step)// &
                    ' divide an outline of '//compact(scale%length)//' into too many; LOFT '// &
                    'makes at most '//to_text(largest_table)//' points: take longer ones')
                return
            end if
            parts = max(1, nint(scale%length/request%step))
        end if
        allocate (length(parts - 1), t(parts - 1))
        do i = 1, parts - 1
            length(i) = scale%length*real(i, dp)/real(parts, dp)
        end do
        call parameters_at(scale, length, t)
        stations = [(station_of(track, t(i)), i=1, parts - 1)]
    end subroutine equal_lengths

    !> Tells of a length that can't be found where the section has nearly shrunk to a line or a
    !> point, so that its outline is lost in the rounding of its points.
    pure subroutine blame_section(body, track, error)
        type(body_type), intent(in) :: body                     !! finished
        type(track_type), intent(in) :: track                   !! of that body
        type(error_type), allocatable, intent(inout) :: error   !! its message is changed
        type(trace_type) :: trace
        real(dp) :: middle, chord(2), rise, noise

        middle = 0.5_dp*(track%from%sta + track%to%sta)
        associate (section => body%sections(track%section))
            trace = trace_at(body%lines, section, middle)
            noise = rounding(trace%start%point, trace%shoulder, trace%finish%point)
            chord = trace%finish%point - trace%start%point
            rise = abs(cross(trace%shoulder - trace%start%point, chord))/max(norm2(chord), noise)
            if (rise > nearly_shrunk*noise) return
            error%message = 'section '//trim(section%name)//' is nearly a line or a point at '// &
                'station '//compact(middle)//': it rises by '//compact(rise)//' where rounding '// &
                'moves its points by '//compact(noise)//', and '//error%message// &
                '; ask for points by steps of STA, or end the section before'
        end associate
    end subroutine blame_section

    !> The stations inside such that no chord is further than a tolerance from the track: from its
    !> start on, what is ahead is halved until its chord is near enough. Fails with
    !> `cause%too_many`.
    pure subroutine within_chords(body, plane, track, tolerance, stations, error)
        type(body_type), intent(in) :: body                     !! finished
        type(plane_type), intent(in) :: plane                   !! not across STA
        type(track_type), intent(in) :: track                   !! of that body and plane
        real(dp), intent(in) :: tolerance                       !! deck units, above zero
        real(dp), allocatable, intent(inout) :: stations(:)     !! deck units
        type(error_type), allocatable, intent(out) :: error     !! see above
        real(dp), allocatable :: found(:)
        real(dp) :: ahead(deepest)
        integer :: count, left, i

        allocate (found(largest_table))
        found(1) = 0.0_dp
        count = 1
        ahead(:2) = [1.0_dp, 0.5_dp]
        left = 2
        do while (left > 0)
            if (left < deepest .and. .not. is_flat(found(count), ahead(left))) then
                ahead(left + 1) = 0.5_dp*(found(count) + ahead(left))
                left = left + 1
                cycle
            end if
            if (count == largest_table) then
                call fail(error, cause%too_many, 'chords within '//compact(tolerance)// &
                    ' of an outline are too many; LOFT makes at most '//to_text(largest_table)// &
                    ' points: take a larger tolerance')
                return
            end if
            count = count + 1
            found(count) = ahead(left)
            left = left - 1
        end do
        stations = [(station_of(track, found(i)), i=2, count - 1)]
    contains
        !> True where the quarters of a stretch are as near to its chord as asked.
        pure logical function is_flat(from, to)
            real(dp), intent(in) :: from    !! parameter
            real(dp), intent(in) :: to      !! parameter
            real(dp) :: ends(3, 2), off(3), chord(3), span
            integer :: quarter
            ends(:, 1) = point_at(body, plane, track, station_of(track, from))
            ends(:, 2) = point_at(body, plane, track, station_of(track, to))
            chord = ends(:, 2) - ends(:, 1)
            span = max(dot_product(chord, chord), tiny(1.0_dp))
            is_flat = .true.
            do quarter = 1, 3
                off = point_at(body, plane, track, &
                    station_of(track, from + 0.25_dp*real(quarter, dp)*(to - from))) - ends(:, 1)
                off = off - dot_product(off, chord)/span*chord
                is_flat = is_flat .and. norm2(off) <= tolerance
            end do
        end function is_flat
    end subroutine within_chords

end module cut_spread
