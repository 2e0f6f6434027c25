!> How the station runs along a stretch of skin: x(u), u from 0 to 1, and the divisor that goes with
!> it.
!>
!> Where a line of the stretch is vertical at an end, the station goes with the square of u there,
!> as the lines are smooth in u then; elsewhere its pace is not zero. Or it goes as along a conic:
!> x = X/D with X and D of the second degree, by which quadrics become rational surfaces exactly.
module export_shell_pace
    use base_constants, only: vertical_slope
    use base_kinds, only: dp
    use body_line, only: line_type
    use body_taylor, only: taylor_type
    use geom_arc, only: arc_type, weight
    use geom_chain, only: chain_type
    use geom_stroke, only: stroke_kind, stroke_part, stroke_place, stroke_tangent, stroke_type
    use geom_twofold, only: to_real
    implicit none (type, external)
    private

    public :: pace_type, power_pace, conic_pace, station_at, divisor_at

    !> The way of the station.
    type :: pace_type
        real(dp) :: from = 0.0_dp           !! least station, deck units
        real(dp) :: to = 0.0_dp             !! greatest station, deck units
        logical :: is_blunt(2) = .false.    !! its pace is zero at that end
        logical :: is_conic = .false.       !! as along a conic
        real(dp) :: leaving = 0.0_dp        !! of that conic: v1 of `geom_arc` along STA, deck units
        real(dp) :: arriving = 0.0_dp       !! v3 along STA, deck units
        real(dp) :: weight = 1.0_dp         !! w
    end type pace_type

    !> The least weight of a conic that the station may follow: the divisor is that of a pole.
    real(dp), parameter :: least_weight = 0.2_dp

contains

    !> The station as a polynomial of u: of the first degree, of the second where one end is blunt,
    !> of the third where both are.
    pure type(pace_type) function power_pace(lines, from, to) result(pace)
        type(line_type), intent(in) :: lines(:) !! of the stretch; each view is one stroke
        real(dp), intent(in) :: from            !! deck units
        real(dp), intent(in) :: to              !! above `from`, deck units
        integer :: i

        pace%from = from
        pace%to = to
        do i = 1, size(lines)
            if (lines(i)%has_side) call look_at(lines(i)%side)
            if (lines(i)%has_plan) call look_at(lines(i)%plan)
            if (lines(i)%has_angle) call look_at(lines(i)%angle)
        end do
    contains
        !> Looks where a view is vertical.
        pure subroutine look_at(view)
            type(chain_type), intent(in) :: view !! one stroke, or a constant
            if (view%is_constant) return
            pace%is_blunt(1) = pace%is_blunt(1) .or. is_vertical_at(view%stroke(1), from)
            pace%is_blunt(2) = pace%is_blunt(2) .or. is_vertical_at(view%stroke(1), to)
        end subroutine look_at
    end function power_pace

    !> True where a stroke is vertical, as cards say it.
    pure logical function is_vertical_at(stroke, sta) result(is_vertical)
        type(stroke_type), intent(in) :: stroke !! towards greater stations
        real(dp), intent(in) :: sta             !! deck units
        real(dp) :: along(2)
        along = stroke_tangent(stroke, stroke_place(stroke, sta))
        is_vertical = abs(along(2)) >= vertical_slope*abs(along(1))
    end function is_vertical_at

    !> The station as along the first curved view of some lines; a polynomial pace, as `power_pace`
    !> makes it, where there is none or its weight is too small.
    pure type(pace_type) function conic_pace(lines, from, to) result(pace)
        type(line_type), intent(in) :: lines(:) !! of the stretch; each view is one stroke
        real(dp), intent(in) :: from            !! deck units
        real(dp), intent(in) :: to              !! above `from`, deck units
        integer :: i

        pace = power_pace(lines, from, to)
        do i = 1, size(lines)
            if (lines(i)%has_side) call follow(lines(i)%side)
            if (lines(i)%has_plan) call follow(lines(i)%plan)
        end do
    contains
        !> Follows a view, where it is the first curved one.
        pure subroutine follow(view)
            type(chain_type), intent(in) :: view !! one stroke, or a constant
            type(stroke_type) :: stroke
            type(arc_type) :: part
            if (view%is_constant .or. pace%is_conic) return
            stroke = view%stroke(1)
            if (stroke%kind /= stroke_kind%conic) return
            stroke = stroke_part(stroke, stroke_place(stroke, from), stroke_place(stroke, to))
            part = stroke%arc
            if (part%is_line .or. weight(part) < least_weight) return
            pace%is_conic = .true.
            pace%weight = weight(part)
            pace%leaving = part%size*to_real(part%leaving(1))
            pace%arriving = part%size*to_real(part%arriving(1))
        end subroutine follow
    end function conic_pace

    !> The station at u with its first derivative (the second is not worked), reckoned from the
    !> nearer end.
    pure type(taylor_type) function station_at(pace, u) result(sta)
        type(pace_type), intent(in) :: pace !! any
        real(dp), intent(in) :: u           !! 0 to 1
        real(dp) :: length, v

        length = pace%to - pace%from
        v = 1.0_dp - u
        if (pace%is_conic) then
            sta = along_conic(pace, u)
        else if (all(pace%is_blunt)) then
            sta = taylor_type(pace%from + length*u**2*(3.0_dp - 2.0_dp*u), 6.0_dp*length*u*v)
            if (u > 0.5_dp) sta%value = pace%to - length*v**2*(3.0_dp - 2.0_dp*v)
        else if (pace%is_blunt(1)) then
            sta = taylor_type(pace%from + length*u**2, 2.0_dp*length*u)
            if (u > 0.5_dp) sta%value = pace%to - length*v*(1.0_dp + u)
        else if (pace%is_blunt(2)) then
            sta = taylor_type(pace%to - length*v**2, 2.0_dp*length*v)
            if (u < 0.5_dp) sta%value = pace%from + length*u*(1.0_dp + v)
        else
            sta = taylor_type(pace%from + length*u, length)
            if (u > 0.5_dp) sta%value = pace%to - length*v
        end if
    end function station_at

    !> The station along a conic.
    pure type(taylor_type) function along_conic(pace, u) result(sta)
        type(pace_type), intent(in) :: pace !! conic
        real(dp), intent(in) :: u           !! 0 to 1
        real(dp) :: length, a, b, d

        length = pace%to - pace%from
        a = 1.0_dp - u
        b = u
        d = divisor_at(pace, u)
        sta%value = pace%from + (2.0_dp*a*b*pace%leaving + b*b*length)/d
        if (u > 0.5_dp) sta%value = pace%to - (2.0_dp*a*b*pace%arriving + a*a*length)/d
        sta%first = 2.0_dp*(a*a*pace%leaving + a*b*length + b*b*pace%arriving)/d**2
    end function along_conic

    !> The divisor D at u: above zero, 1 at both ends; 1 everywhere where the pace is a polynomial.
    pure real(dp) function divisor_at(pace, u) result(d)
        type(pace_type), intent(in) :: pace !! any
        real(dp), intent(in) :: u           !! 0 to 1
        d = 1.0_dp
        if (pace%is_conic) d = (1.0_dp - 2.0_dp*u)**2 &
            + 2.0_dp*u*(1.0_dp - u)*(1.0_dp + pace%weight)
    end function divisor_at

end module export_shell_pace
