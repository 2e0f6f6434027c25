!> A straight line or a circle on which one goes: what a spiral joins; and the arc of it that ends
!> at another point.
module geom_track
    use base_constants, only: pi
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_tolerances, only: decimal_noise, ulp
    use geom_arc, only: arc_type, line_between
    use geom_arc_by_circle, only: circle_by_radius
    use geom_conic, only: conic_kind
    use geom_conic_axes, only: axes_of, axes_type
    use geom_twofold, only: to_real
    use geom_vector, only: at_text, cross
    implicit none (type, external)
    private

    public :: track_type, track_of, backwards, left_of, arc_to

    !> A straight line or a circle, and which way one goes on it.
    type :: track_type
        logical :: is_line = .true.         !! it has no centre
        real(dp) :: start(2) = 0.0_dp       !! a point of it, deck units
        real(dp) :: finish(2) = 0.0_dp      !! another
        real(dp) :: along(2) = 0.0_dp       !! of a line: its unit vector
        real(dp) :: centre(2) = 0.0_dp      !! of a circle, deck units
        real(dp) :: radius = 0.0_dp         !! of a circle, positive where it turns left
    end type track_type

contains

    !> The line or circle of an arc. Fails with `cause%no_arc` where it is neither.
    pure subroutine track_of(arc, which, track, error)
        type(arc_type), intent(in) :: arc                   !! any
        character(*), intent(in) :: which                   !! of the card, for the message
        type(track_type), intent(out) :: track              !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(axes_type) :: axes

        track%is_line = arc%is_line
        track%start = arc%start
        track%finish = arc%finish
        if (arc%is_line) then
            track%along = (arc%finish - arc%start)/norm2(arc%finish - arc%start)
            return
        end if
        axes = axes_of(arc)
        if (axes%kind == conic_kind%ellipse .and. abs(axes%a - axes%b) <= 0.0_dp) then
            track%centre = axes%origin
            track%radius = sign(axes%a, to_real(cross(arc%leaving, arc%half)))
        else
            call fail(error, cause%no_arc, 'the card '//which//' it is neither a straight line '// &
                'nor a circular arc; a spiral joins only these')
        end if
    end subroutine track_of

    !> The same, gone along backwards.
    elemental type(track_type) function backwards(track) result(back)
        type(track_type), intent(in) :: track !! any
        back = track
        back%start = track%finish
        back%finish = track%start
        back%along = -track%along
        back%radius = -track%radius
    end function backwards

    !> A vector, turned left by a quarter.
    pure function left_of(along) result(left)
        real(dp), intent(in) :: along(2) !! any
        real(dp) :: left(2)
        left = [-along(2), along(1)]
    end function left_of

    !> The arc on the line or circle of an arc from its start to a point there, before its end or
    !> beyond.
    !>
    !> Fails with `cause%no_arc` where the point is not ahead of the start, of a circle by half a
    !> turn at most.
    pure subroutine arc_to(arc, point, new, error)
        type(arc_type), intent(in) :: arc                   !! a line, or of a circle
        real(dp), intent(in) :: point(2)                    !! deck units
        type(arc_type), intent(out) :: new                  !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(track_type) :: track
        real(dp) :: ahead, noise, u(2), v(2)

        call track_of(arc, 'at', track, error)
        if (allocated(error)) return
        noise = decimal_noise*ulp*max(maxval(abs(point)), maxval(abs(arc%start)))
        if (track%is_line) then
            ahead = dot_product(point - arc%start, track%along)
        else
            u = arc%start - track%centre
            v = point - track%centre
            ahead = atan2(cross(u, v), dot_product(u, v))*sign(1.0_dp, track%radius)
            if (ahead < -pi + noise/abs(track%radius)) ahead = pi
            ahead = ahead*abs(track%radius)
        end if
        if (ahead <= noise) then
            call fail(error, cause%no_arc, 'the spiral meets it at '//at_text(point)// &
                ', beyond its other end at '//at_text(arc%start))
        else if (track%is_line) then
            new = line_between(arc%start, point)
        else
            call circle_by_radius(arc%start, point, track%radius, new, error)
        end if
    end subroutine arc_to

end module geom_track
