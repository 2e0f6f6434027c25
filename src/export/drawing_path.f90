!> A smooth curve of a drawing as it is known exactly: its points and directions over a parameter
!> from 0 to 1. Curves of cuts are in the plane of the cut, (u, v, 0), those of lines in space.
module export_drawing_path
    use base_kinds, only: dp
    use geom_curve_fit, only: curve_function_type
    implicit none (type, external)
    private

    public :: path_type, paced, pace_of

    !> A curve with its directions.
    type, abstract, extends(curve_function_type) :: path_type
    contains
        procedure(way_interface), deferred :: way !! the direction at a parameter
    end type path_type

    abstract interface
        !> The direction of a path, ahead.
        pure function way_interface(f, t) result(way)
            import :: dp, path_type
            implicit none (type, external)
            class(path_type), intent(in) :: f   !! the path
            real(dp), intent(in) :: t           !! 0 to 1
            real(dp) :: way(3)                  !! any length; zero where there is none
        end function way_interface
    end interface

    !> Bound of a pace: with it the cubic of `paced` stands still nowhere inside.
    real(dp), parameter :: quickest = 2.0_dp

contains

    !> A station between two others, over t from 0 to 1: the cubic with given paces at its ends. A
    !> curve that is vertical where it begins or ends, like a root of the station, is smooth over t
    !> where the pace is zero, and of even speed there where the pace is `pace_of`.
    pure real(dp) function paced(from, to, pace, t) result(sta)
        real(dp), intent(in) :: from    !! where t is 0, deck units
        real(dp), intent(in) :: to      !! where t is 1, deck units; may be below
        real(dp), intent(in) :: pace(2) !! of the station at its ends, in parts of the mean
        real(dp), intent(in) :: t       !! 0 to 1

        if (t <= 0.5_dp) then
            sta = from + (to - from)*share(pace(1), pace(2), t)
        else
            sta = to - (to - from)*share(pace(2), pace(1), 1.0_dp - t)
        end if
        sta = min(max(sta, min(from, to)), max(from, to))
    contains
        !> The share of the way that is done.
        pure real(dp) function share(first, last, x)
            real(dp), intent(in) :: first   !! pace where x is 0
            real(dp), intent(in) :: last    !! pace where x is 1
            real(dp), intent(in) :: x       !! 0 to 1
            share = x*(first + x*(3.0_dp - 2.0_dp*first - last + x*(first + last - 2.0_dp)))
        end function share
    end function paced

    !> The pace of the station at an end of a curve that gives the curve its mean speed there.
    elemental real(dp) function pace_of(slant, length, span) result(pace)
        real(dp), intent(in) :: slant   !! part of the curve's unit direction along STA
        real(dp), intent(in) :: length  !! of the curve, about, deck units
        real(dp), intent(in) :: span    !! stations it takes, not zero, deck units
        pace = min(quickest, abs(slant)*length/abs(span))
    end function pace_of

end module export_drawing_path
