!> What a plane takes from the sections of a body as curves in space, that patches can have for
!> sides: one curve for each run of tracks that turn into each other in STA.
!>
!> A track goes by t from 0 to 1, STA = from + (to - from) sin(pi t/2)**2, and is smooth in t also
!> where it turns; tracks get parts of the parameter that go with the roots of their ranges, so that
!> the speed is the same on both sides of a turn.
module cut_trace
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_panel_side, only: curve_side
    use body_trace, only: arcs_at, trace_type
    use cut_event, only: happening
    use cut_meeting, only: is_across
    use cut_plane, only: plane_type
    use cut_request, only: request_type
    use cut_track, only: track_type, tracks_on
    use cut_walk, only: point_at, station_of
    use geom_bspline, only: bspline_type
    use geom_curve_fit, only: curve_function_type, fit_curve
    implicit none (type, external)
    private

    public :: traces_of

    !> Tracks that turn into each other.
    type, extends(curve_function_type) :: run_type
        type(body_type), allocatable :: body            !! finished
        type(plane_type) :: plane                       !! not across STA
        type(track_type), allocatable :: track(:)       !! in order
        logical, allocatable :: is_forward(:)           !! each is run through aft
        real(dp), allocatable :: until(:)               !! the parameter at which each ends
    contains
        procedure :: at => run_point
    end type run_type

    !> How near the curves are to the skin, relative to their size: less than panels to their sides.
    real(dp), parameter :: nearness = 1.0e-10_dp
    !> Points by which the size of a curve is measured.
    integer, parameter :: size_points = 16

contains

    !> The curves of a plane on all sections. Those that can't be fitted, which are not smooth, are
    !> left out.
    pure function traces_of(body, request) result(traces)
        type(body_type), intent(in) :: body         !! finished
        type(request_type), intent(in) :: request   !! the plane, limits along STA
        type(trace_type), allocatable :: traces(:)
        type(track_type), allocatable :: tracks(:)
        type(trace_type), allocatable :: more(:)
        real(dp) :: limit(2)
        integer :: i

        allocate (traces(0), more(0))
        if (is_across(request%plane)) then
            traces = arcs_at(body, request%plane%through(1))
            return
        end if
        limit = [-huge(1.0_dp), huge(1.0_dp)]
        if (request%limit(1)%has_from) limit(1) = request%limit(1)%from
        if (request%limit(1)%has_to) limit(2) = request%limit(1)%to
        allocate (tracks(0))
        do i = 1, size(body%sections)
            tracks = tracks_on(body, i, request%plane, limit)
            more = traces_on(body, request%plane, i, tracks)
            traces = [traces, more]
        end do
    end function traces_of

    !> The curves of the tracks of a section.
    pure function traces_on(body, plane, section, tracks) result(traces)
        type(body_type), intent(in) :: body         !! finished
        type(plane_type), intent(in) :: plane       !! not across STA
        integer, intent(in) :: section              !! in the body's list
        type(track_type), intent(in) :: tracks(:)   !! of it, in order of STA
        type(trace_type), allocatable :: traces(:)
        type(trace_type) :: trace
        type(run_type) :: run
        type(bspline_type) :: curve
        type(error_type), allocatable :: error
        real(dp) :: largest, place
        logical :: is_free(size(tracks))
        integer :: i

        allocate (traces(0))
        is_free = .true.
        trace%section = section
        do i = 1, size(tracks)
            if (.not. is_free(i)) cycle
            call find_run(body, plane, tracks, i, is_free, run)
            call fit_curve(run, nearness*size_of(run), curve, largest, place, error)
            if (allocated(error)) cycle
            trace%side = curve_side(curve)
            traces = [traces, trace]
        end do
    end function traces_on

    !> The tracks that turn into one, or it turns into.
    pure subroutine find_run(body, plane, tracks, first, is_free, run)
        type(body_type), intent(in) :: body         !! finished
        type(plane_type), intent(in) :: plane       !! not across STA
        type(track_type), intent(in) :: tracks(:)   !! of one section
        integer, intent(in) :: first                !! which of them
        logical, intent(inout) :: is_free(:)        !! of none yet; those taken are not any more
        type(run_type), intent(out) :: run          !! in its order
        real(dp) :: root(size(tracks))
        integer :: i

        run%body = body
        run%plane = plane
        run%track = [tracks(first)]
        run%is_forward = [.true.]
        is_free(first) = .false.
        call go_on(tracks, is_free, run)
        run%track = run%track(size(run%track):1:-1)
        run%is_forward = .not. run%is_forward(size(run%is_forward):1:-1)
        call go_on(tracks, is_free, run)
        do i = 1, size(run%track)
            root(i) = sqrt(run%track(i)%to%sta - run%track(i)%from%sta)
        end do
        associate (n => size(run%track))
            run%until = [(sum(root(:i))/sum(root(:n)), i = 1, n)]
            run%until(n) = 1.0_dp
        end associate
    end subroutine find_run

    !> Adds what a run turns into, as far as it goes.
    pure subroutine go_on(tracks, is_free, run)
        type(track_type), intent(in) :: tracks(:)   !! of one section
        logical, intent(inout) :: is_free(:)        !! of none yet; those taken are not any more
        type(run_type), intent(inout) :: run        !! gets them behind
        integer :: i
        logical :: is_aft, has_more

        has_more = .true.
        do while (has_more)
            has_more = .false.
            associate (last => run%track(size(run%track)))
                is_aft = run%is_forward(size(run%track))
                do i = 1, size(tracks)
                    if (.not. is_free(i)) cycle
                    if (is_aft) has_more = last%to%kind == happening%turn .and. &
                        tracks(i)%to%kind == happening%turn .and. &
                        abs(tracks(i)%to%sta - last%to%sta) <= 0.0_dp
                    if (.not. is_aft) has_more = last%from%kind == happening%turn .and. &
                        tracks(i)%from%kind == happening%turn .and. &
                        abs(tracks(i)%from%sta - last%from%sta) <= 0.0_dp
                    if (has_more) exit
                end do
            end associate
            if (.not. has_more) return
            run%track = [run%track, tracks(i)]
            run%is_forward = [run%is_forward, .not. is_aft]
            is_free(i) = .false.
        end do
    end subroutine go_on

    !> The point of a run.
    pure function run_point(f, t) result(point)
        class(run_type), intent(in) :: f    !! the run
        real(dp), intent(in) :: t           !! 0 to 1
        real(dp) :: point(3), from, share
        integer :: i

        i = min(1 + count(f%until <= t), size(f%until))
        from = 0.0_dp
        if (i > 1) from = f%until(i - 1)
        share = min((t - from)/(f%until(i) - from), 1.0_dp)
        if (.not. f%is_forward(i)) share = 1.0_dp - share
        point = point_at(f%body, f%plane, f%track(i), station_of(f%track(i), share))
    end function run_point

    !> The largest distance between points of a run.
    pure real(dp) function size_of(run)
        type(run_type), intent(in) :: run !! any
        integer :: i
        size_of = tiny(1.0_dp)
        do i = 1, size_points
            size_of = max(size_of, norm2(run%at(real(i, dp)/real(size_points, dp)) &
                - run%at(0.0_dp)))
        end do
    end function size_of

end module cut_trace
