!> The skin as a surface of two parameters with its exact derivatives: a sheet is a part of a
!> section between two stations where its lines are smooth. u goes from 0 at the fore end to 1 at
!> the aft end, t from 0 at the start of the section's arc to 1 at its finish.
!>
!> Where a line has an infinite slope at an end, the station goes with the square of u there: the
!> surface is smooth in u as it is not in STA. With the notation of `geom_arc`, S the shoulder point
!> from the start and c = 2 h the chord,
!>
!>     b2 = t1 x S/(t1 x c),   b0 = (c - S) x t3/(c x t3),   k = sqrt(b0 b2)
!>     v1 = t1 (S x c)/(2 k t1 x c),   w = (1 - b0 - b2)/(2 k),   g = v1 - w h,   v3 = w h - g
!>
!> are worked in numbers that carry their derivatives over u along (`body_taylor`).
module cut_measure_sheet
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: section_arc, section_type
    use body_surface, only: patch_at, patch_type
    use body_taylor, only: cross, operator(*), operator(+), operator(-), taylor_type
    use geom_arc, only: arc_type
    use geom_jet, only: jet_type
    implicit none (type, external)
    private

    public :: span_type, new_span, station_of, frame_type, frame_at, spot_type, spot_at

    !> Stations between two stops, and how u runs over them.
    type :: span_type
        real(dp) :: from = 0.0_dp               !! least station, deck units
        real(dp) :: to = 0.0_dp                 !! greatest station, deck units
        logical :: is_blunt(2) = .false.        !! a line has an infinite slope at that end
    end type span_type

    !> A section at one u: the parts of its arc, each with its derivatives over u.
    type :: frame_type
        type(taylor_type) :: sta                !! the station, deck units
        type(taylor_type) :: middle(2)          !! of the chord, BL and WL, deck units
        type(taylor_type) :: half(2)            !! h, deck units
        type(taylor_type) :: bulge(2)           !! g, deck units
        type(taylor_type) :: leaving(2)         !! v1, deck units
        type(taylor_type) :: arriving(2)        !! v3, deck units
        type(taylor_type) :: fullness           !! q = 1 + w
    end type frame_type

    !> A point of a sheet with its derivatives: STA, BL, WL, deck units.
    type :: spot_type
        real(dp) :: at(3) = 0.0_dp  !! the point
        real(dp) :: u(3) = 0.0_dp   !! first derivative over u
        real(dp) :: t(3) = 0.0_dp   !! over t
        real(dp) :: uu(3) = 0.0_dp  !! second derivative over u
        real(dp) :: ut(3) = 0.0_dp  !! over u and t
        real(dp) :: tt(3) = 0.0_dp  !! over t
    end type spot_type

    !> Where it is looked whether a slope grows without limit: this part of the span from its end.
    real(dp), parameter :: inset = 1.0e-9_dp

contains

    !> The span between two stations, for sections that are all there throughout.
    pure type(span_type) function new_span(body, chosen, from, to) result(span)
        type(body_type), intent(in) :: body     !! finished
        integer, intent(in) :: chosen(:)        !! the sections, in the body's list
        real(dp), intent(in) :: from            !! deck units
        real(dp), intent(in) :: to              !! above `from`, deck units
        integer :: i

        span%from = from
        span%to = to
        do i = 1, size(chosen)
            associate (section => body%sections(chosen(i)))
                if (grows(body, section, from, inset*(to - from))) span%is_blunt(1) = .true.
                if (grows(body, section, to, inset*(from - to))) span%is_blunt(2) = .true.
            end associate
        end do
    end function new_span

    !> True where a slope grows towards an end of a span as that of a square root does: doubled each
    !> time the distance is quartered.
    pure logical function grows(body, section, end, step)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), intent(in) :: end                 !! station of the end, deck units
        real(dp), intent(in) :: step                !! a short way inwards, deck units
        real(dp) :: near(6), far(6)

        near = slopes(body, section, end + step)
        far = slopes(body, section, end + 4.0_dp*step)
        grows = any(near > 1.5_dp*far .and. near > 1.0_dp)
    end function grows

    !> How fast the three points of a section move along STA, BL and WL of each.
    pure function slopes(body, section, sta)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), intent(in) :: sta                 !! deck units
        real(dp) :: slopes(6)
        type(patch_type) :: patch
        type(arc_type) :: arc

        patch = patch_at(body%lines, section, sta, arc)
        slopes = reshape(abs(patch%point%first), [6])
    end function slopes

    !> The station at u, with its derivatives; reckoned from the nearer end.
    pure type(taylor_type) function station_of(span, u) result(sta)
        type(span_type), intent(in) :: span !! any span
        real(dp), intent(in) :: u           !! 0 to 1
        real(dp) :: length, v

        length = span%to - span%from
        v = 1.0_dp - u
        if (all(span%is_blunt)) then
            sta%value = span%from + length*sin(0.5_dp*pi*u)**2
            if (u > 0.5_dp) sta%value = span%to - length*sin(0.5_dp*pi*v)**2
            sta%first = 0.5_dp*pi*length*sin(pi*min(u, v))
            sta%second = 0.5_dp*pi**2*length*cos(pi*u)
        else if (span%is_blunt(1)) then
            sta = taylor_type(span%from + length*u**2, 2.0_dp*length*u, 2.0_dp*length)
            if (u > 0.5_dp) sta%value = span%to - length*v*(1.0_dp + u)
        else if (span%is_blunt(2)) then
            sta = taylor_type(span%to - length*v**2, 2.0_dp*length*v, -2.0_dp*length)
            if (u < 0.5_dp) sta%value = span%from + length*u*(1.0_dp + v)
        else
            sta = taylor_type(span%from + length*u, length, 0.0_dp)
            if (u > 0.5_dp) sta%value = span%to - length*v
        end if
    end function station_of

    !> A section at one u of a span. Fails as `section_arc` where it has no arc there.
    pure subroutine frame_at(body, section, sta, frame, error)
        type(body_type), intent(in) :: body                 !! finished
        type(section_type), intent(in) :: section           !! one of its sections
        type(taylor_type), intent(in) :: sta                !! from `station_of`
        type(frame_type), intent(out) :: frame              !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(patch_type) :: patch
        type(arc_type) :: arc

        call section_arc(body%lines, section, sta%value, arc, error)
        if (allocated(error)) return
        patch = patch_at(body%lines, section, sta%value, arc)
        frame = framed(sta, along(patch%point, sta), along(patch%tangent, sta), arc)
    end subroutine frame_at

    !> The parts of an arc from its five conditions.
    pure type(frame_type) function framed(sta, point, tangent, arc) result(frame)
        type(taylor_type), intent(in) :: sta            !! the station
        type(taylor_type), intent(in) :: point(2, 3)    !! start, shoulder, finish
        type(taylor_type), intent(in) :: tangent(2, 2)  !! at start and finish, either way
        type(arc_type), intent(in) :: arc               !! their arc
        type(taylor_type), dimension(2) :: chord, shoulder
        type(taylor_type) :: b0, b2, k, reach, w

        chord = point(:, 3) - point(:, 1)
        frame%sta = sta
        frame%half = times(0.5_dp, chord)
        frame%middle = point(:, 1) + frame%half
        w%value = 1.0_dp
        if (arc%is_line) then
            frame%leaving = frame%half
        else
            shoulder = point(:, 2) - point(:, 1)
            b2 = quotient(cross(tangent(:, 1), shoulder), cross(tangent(:, 1), chord))
            b0 = quotient(cross(chord - shoulder, tangent(:, 2)), cross(chord, tangent(:, 2)))
            k = root(times(4.0_dp, b0*b2))
            reach = quotient(cross(shoulder, chord), k*cross(tangent(:, 1), chord))
            w = quotient(w - b0 - b2, k)
            frame%leaving(1) = reach*tangent(1, 1)
            frame%leaving(2) = reach*tangent(2, 1)
        end if
        frame%fullness = w + taylor_type(1.0_dp)
        frame%bulge(1) = frame%leaving(1) - w*frame%half(1)
        frame%bulge(2) = frame%leaving(2) - w*frame%half(2)
        frame%arriving(1) = w*frame%half(1) - frame%bulge(1)
        frame%arriving(2) = w*frame%half(2) - frame%bulge(2)
    end function framed

    !> The point of a frame at t.
    pure type(spot_type) function spot_at(frame, t) result(spot)
        type(frame_type), intent(in) :: frame   !! a section at one u
        real(dp), intent(in) :: t               !! 0 to 1
        type(taylor_type) :: p, n, d
        real(dp) :: a, b, turn, change
        integer :: axis

        a = 1.0_dp - t
        b = t
        d = taylor_type((a - b)**2) + times(2.0_dp*a*b, frame%fullness)
        change = 2.0_dp*(a - b)*(frame%fullness%value - 2.0_dp)
        spot%at(1) = frame%sta%value
        spot%u(1) = frame%sta%first
        spot%uu(1) = frame%sta%second
        do axis = 1, 2
            p = frame%middle(axis) + quotient(times(2.0_dp*a*b, frame%bulge(axis)) &
                + times((b - a)*(b + a), frame%half(axis)), d)
            n = quotient(times(2.0_dp*a*a, frame%leaving(axis)) + times(4.0_dp*a*b, &
                frame%half(axis)) + times(2.0_dp*b*b, frame%arriving(axis)), d*d)
            turn = 4.0_dp*((a - b)*frame%half(axis)%value - a*frame%leaving(axis)%value &
                + b*frame%arriving(axis)%value)
            spot%at(axis + 1) = p%value
            spot%u(axis + 1) = p%first
            spot%uu(axis + 1) = p%second
            spot%t(axis + 1) = n%value
            spot%ut(axis + 1) = n%first
            spot%tt(axis + 1) = (turn/d%value - 2.0_dp*n%value*change)/d%value
        end do
    end function spot_at

    !> An ordinate over STA as one over u.
    elemental type(taylor_type) function along(jet, sta) result(over)
        type(jet_type), intent(in) :: jet       !! over STA
        type(taylor_type), intent(in) :: sta    !! over u
        over = taylor_type(jet%value, jet%first*sta%first, &
            jet%second*sta%first**2 + jet%first*sta%second)
    end function along

    !> `x*a` for a number that does not change.
    elemental type(taylor_type) function times(x, a)
        real(dp), intent(in) :: x           !! any number
        type(taylor_type), intent(in) :: a  !! any
        times = taylor_type(x*a%value, x*a%first, x*a%second)
    end function times

    !> `a/b`.
    elemental type(taylor_type) function quotient(a, b) result(c)
        type(taylor_type), intent(in) :: a !! any
        type(taylor_type), intent(in) :: b !! not zero
        c%value = a%value/b%value
        c%first = (a%first - c%value*b%first)/b%value
        c%second = (a%second - 2.0_dp*c%first*b%first - c%value*b%second)/b%value
    end function quotient

    !> The square root.
    elemental type(taylor_type) function root(a) result(c)
        type(taylor_type), intent(in) :: a !! above zero
        c%value = sqrt(a%value)
        c%first = 0.5_dp*a%first/c%value
        c%second = (0.5_dp*a%second - c%first**2)/c%value
    end function root

end module cut_measure_sheet
