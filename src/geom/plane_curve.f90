!> Smooth curves in a plane, and where their curvature changes its ways.
module geom_plane_curve
    use base_kinds, only: dp
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: plane_curve_type, curvature_stops

    !> A smooth curve in a plane, over a parameter from 0 to 1.
    type, abstract :: plane_curve_type
    contains
        procedure(jet_interface), deferred :: jet !! point and derivatives at a parameter
    end type plane_curve_type

    abstract interface
        !> The point of a curve and its first two derivatives.
        pure subroutine jet_interface(f, t, point, first, second)
            import :: dp, plane_curve_type
            implicit none (type, external)
            class(plane_curve_type), intent(in) :: f    !! the curve
            real(dp), intent(in) :: t                   !! 0 to 1
            real(dp), intent(out) :: point(2)           !! deck units
            real(dp), intent(out) :: first(2)           !! not zero
            real(dp), intent(out) :: second(2)          !! second derivative
        end subroutine jet_interface
    end interface

    !> Samples of a curve that show where its curvature turns, and steps that narrow one place.
    integer, parameter :: samples = 512, narrowings = 80
    !> Curvature, in parts of the largest, that is none.
    real(dp), parameter :: no_curvature = 1.0e-9_dp
    !> Speed over the parameter, deck units, below which a curve stands still.
    real(dp), parameter :: slowest = 1.0e-90_dp

contains

    !> The parameters between which the curvature only grows or only falls and has one sign: the
    !> ends, zeros and extremes, as `samples` show them.
    pure function curvature_stops(f) result(stops)
        class(plane_curve_type), intent(in) :: f !! the curve
        real(dp), allocatable :: stops(:)
        real(dp) :: bend(0:samples), t(0:samples), noise
        integer :: i

        t = [(real(i, dp)/real(samples, dp), i=0, samples)]
        do i = 0, samples
            bend(i) = curvature_at(f, t(i))
        end do
        noise = no_curvature*maxval(abs(bend))
        where (abs(bend) <= noise) bend = 0.0_dp
        stops = [0.0_dp]
        do i = 1, samples - 1
            if (bend(i - 1)*bend(i) < 0.0_dp) stops = [stops, zero_of(f, t(i - 1), t(i))]
            if (.not. abs(bend(i)) > 0.0_dp) then
                if (abs(bend(i - 1)) > 0.0_dp .or. abs(bend(i + 1)) > 0.0_dp) stops = [stops, t(i)]
            else if ((abs(bend(i)) - abs(bend(i - 1)))*(abs(bend(i + 1)) - abs(bend(i))) &
                <= 0.0_dp .and. turns(bend(i - 1:i + 1))) then
                stops = [stops, extreme_of(f, t(i - 1), t(i + 1), abs(bend(i)) > abs(bend(i - 1)))]
            end if
        end do
        if (bend(samples - 1)*bend(samples) < 0.0_dp) &
            stops = [stops, zero_of(f, t(samples - 1), t(samples))]
        stops = [stops, 1.0_dp]
    contains
        !> True where three curvatures of one sign have their extreme in the middle, by more than
        !> noise.
        pure logical function turns(three)
            real(dp), intent(in) :: three(3) !! neighbours
            turns = minval(three)*maxval(three) > 0.0_dp .and. &
                max(abs(three(2) - three(1)), abs(three(3) - three(2))) > noise
        end function turns
    end function curvature_stops

    !> The curvature, 1/deck unit, positive where the curve turns left; none where it stands still.
    pure real(dp) function curvature_at(f, t) result(bend)
        class(plane_curve_type), intent(in) :: f    !! the curve
        real(dp), intent(in) :: t                   !! 0 to 1
        real(dp), dimension(2) :: point, first, second
        real(dp) :: speed
        call f%jet(t, point, first, second)
        speed = norm2(first)
        bend = 0.0_dp
        if (speed > slowest) bend = cross(first, second)/speed**3
    end function curvature_at

    !> Where the curvature changes its sign.
    pure real(dp) function zero_of(f, from, to) result(t)
        class(plane_curve_type), intent(in) :: f    !! the curve
        real(dp), intent(in) :: from                !! parameter
        real(dp), intent(in) :: to                  !! parameter, the sign is another there
        real(dp) :: low, high, bend
        integer :: i

        low = from
        high = to
        bend = curvature_at(f, from)
        do i = 1, narrowings
            t = 0.5_dp*(low + high)
            if (curvature_at(f, t)*bend > 0.0_dp) then
                low = t
            else
                high = t
            end if
        end do
    end function zero_of

    !> Where the magnitude of the curvature has its extreme, by the golden section.
    pure real(dp) function extreme_of(f, from, to, is_greatest) result(t)
        class(plane_curve_type), intent(in) :: f    !! the curve
        real(dp), intent(in) :: from                !! parameter
        real(dp), intent(in) :: to                  !! parameter
        logical, intent(in) :: is_greatest          !! not the least
        real(dp), parameter :: golden = 0.6180339887498949_dp
        real(dp) :: ends(2), inner(2), value(2), way
        integer :: i

        way = merge(-1.0_dp, 1.0_dp, is_greatest)
        ends = [from, to]
        inner = [to - golden*(to - from), from + golden*(to - from)]
        value = way*[abs(curvature_at(f, inner(1))), abs(curvature_at(f, inner(2)))]
        do i = 1, narrowings/2
            if (value(1) <= value(2)) then
                ends(2) = inner(2)
                inner = [ends(2) - golden*(ends(2) - ends(1)), inner(1)]
                value = [way*abs(curvature_at(f, inner(1))), value(1)]
            else
                ends(1) = inner(1)
                inner = [inner(2), ends(1) + golden*(ends(2) - ends(1))]
                value = [value(2), way*abs(curvature_at(f, inner(2)))]
            end if
        end do
        t = 0.5_dp*sum(ends)
    end function extreme_of

end module geom_plane_curve
