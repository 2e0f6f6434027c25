!> The way along a track: points, coordinates and speed.
!>
!> Lengths are integrated over a parameter t from 0 to 1, STA = from + (to - from) sin(pi t/2)**2,
!> in which a track is smooth also where it turns back in STA, and where a round nose begins.
module cut_walk
    use base_constants, only: pi
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_skin, only: skin_at, skin_type
    use cut_plane, only: plane_type
    use cut_point, only: tangent_of
    use cut_track, only: place_on, track_type
    use cut_track_row, only: step_type, walk_on_track
    use geom_place, only: place_type
    use geom_quadrature, only: integrand_type
    use geom_zeros, only: function_type
    implicit none (type, external)
    private

    public :: coordinate_type, speed_type, point_at, skin_on, station_of, parameter_of

    !> One coordinate along a track, from a level on, over STA.
    type, extends(function_type) :: coordinate_type
        type(body_type), allocatable :: body    !! finished
        type(plane_type) :: plane               !! not across STA
        type(track_type) :: track               !! of that body and plane
        integer :: axis = 1                     !! 1 STA, 2 BL, 3 WL
        real(dp) :: level = 0.0_dp              !! deck units
    contains
        procedure :: at => coordinate_at
        procedure :: values => coordinates_at
    end type coordinate_type

    !> The speed |dp/dt| along a track.
    type, extends(integrand_type) :: speed_type
        type(body_type), allocatable :: body    !! finished
        type(plane_type) :: plane               !! not across STA
        type(track_type) :: track               !! of that body and plane
    contains
        procedure :: at => speed_at
        procedure :: values => speeds_at
    end type speed_type

contains

    !> The station of a parameter.
    pure real(dp) function station_of(track, t) result(sta)
        type(track_type), intent(in) :: track   !! any
        real(dp), intent(in) :: t               !! 0 to 1
        sta = track%from%sta + (track%to%sta - track%from%sta)*sin(0.5_dp*pi*t)**2
        sta = min(max(sta, track%from%sta), track%to%sta)
    end function station_of

    !> The parameter of a station.
    pure real(dp) function parameter_of(track, sta) result(t)
        type(track_type), intent(in) :: track   !! any
        real(dp), intent(in) :: sta             !! from its beginning to its end, deck units
        t = 2.0_dp/pi*asin(sqrt((sta - track%from%sta)/(track%to%sta - track%from%sta)))
    end function parameter_of

    !> The skin at a station of a track.
    pure type(skin_type) function skin_on(body, plane, track, sta) result(skin)
        type(body_type), intent(in) :: body         !! finished
        type(plane_type), intent(in) :: plane       !! not across STA
        type(track_type), intent(in) :: track       !! of that body and plane
        real(dp), intent(in) :: sta                 !! deck units
        type(place_type) :: place
        logical :: is_arc
        call place_on(body, plane, track, sta, place, is_arc)
        skin = skin_at(body%lines, body%sections(track%section), sta, place)
    end function skin_on

    !> The point of a track at a station: STA, BL, WL, deck units.
    pure function point_at(body, plane, track, sta) result(at)
        type(body_type), intent(in) :: body         !! finished
        type(plane_type), intent(in) :: plane       !! not across STA
        type(track_type), intent(in) :: track       !! of that body and plane
        real(dp), intent(in) :: sta                 !! deck units
        real(dp) :: at(3)
        type(skin_type) :: skin
        skin = skin_on(body, plane, track, sta)
        at = skin%at
    end function point_at

    !> A coordinate less its level at a station.
    pure real(dp) function coordinate_at(f, x) result(value)
        class(coordinate_type), intent(in) :: f     !! which, on which track
        real(dp), intent(in) :: x                   !! station, deck units
        real(dp) :: at(3)
        at = point_at(f%body, f%plane, f%track, x)
        value = at(f%axis) - f%level
    end function coordinate_at

    !> A coordinate less its level at stations.
    pure subroutine coordinates_at(f, x, y)
        class(coordinate_type), intent(in) :: f     !! which, on which track
        real(dp), intent(in) :: x(:)                !! stations, deck units
        real(dp), intent(out) :: y(:)               !! one for each
        type(step_type) :: steps(size(x))
        integer :: i

        call walk_on_track(f%body, f%plane, f%track, x, steps)
        do i = 1, size(x)
            if (steps(i)%is_done) then
                y(i) = steps(i)%at(f%axis) - f%level
            else
                y(i) = f%at(x(i))
            end if
        end do
    end subroutine coordinates_at

    !> The speed at t: (dSTA/dt)/(dSTA/ds).
    pure real(dp) function speed_at(f, t) result(speed)
        class(speed_type), intent(in) :: f  !! on which track
        real(dp), intent(in) :: t           !! 0 to 1
        type(skin_type) :: skin
        real(dp) :: way(3), pace

        skin = skin_on(f%body, f%plane, f%track, station_of(f%track, t))
        way = tangent_of(skin%normal, f%plane, f%track, f%body%sections(f%track%section)%outward)
        pace = 0.5_dp*pi*(f%track%to%sta - f%track%from%sta)*sin(pi*t)
        speed = 0.0_dp
        if (abs(way(1)) > 0.0_dp) speed = pace/abs(way(1))
    end function speed_at

    !> The speeds at some t.
    pure subroutine speeds_at(f, t, value)
        class(speed_type), intent(in) :: f  !! on which track
        real(dp), intent(in) :: t(:)        !! 0 to 1
        real(dp), intent(out) :: value(:)   !! one for each
        type(step_type) :: steps(size(t))
        real(dp) :: sta(size(t))
        integer :: i

        do i = 1, size(t)
            sta(i) = station_of(f%track, t(i))
        end do
        call walk_on_track(f%body, f%plane, f%track, sta, steps)
        do i = 1, size(t)
            value(i) = 0.0_dp
            if (.not. steps(i)%is_done) then
                value(i) = f%at(t(i))
            else if (abs(steps(i)%way(1)) > 0.0_dp) then
                value(i) = 0.5_dp*pi*(f%track%to%sta - f%track%from%sta)*sin(pi*t(i)) &
                    /abs(steps(i)%way(1))
            end if
        end do
    end subroutine speeds_at

end module cut_walk
