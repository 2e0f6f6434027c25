!> The length of a stroke, and places at equal lengths along it.
module geom_stroke_length
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_tolerances, only: quadrature_tolerance, spacing_tolerance
    use geom_length, only: arc_length, places_by_length
    use geom_place, only: at_finish, at_start, place_at, place_type
    use geom_quadrature, only: integrand_type, integrate
    use geom_stroke, only: stroke_jet, stroke_kind, stroke_type
    implicit none (type, external)
    private

    public :: stroke_length, stroke_places

    !> The speed |dC/dt| of a stroke that is no conic.
    type, extends(integrand_type) :: speed_type
        type(stroke_type) :: stroke     !! of which stroke
    contains
        procedure :: at => speed_at
    end type speed_type

    !> Stretches of a curve whose lengths are kept, and steps that place a point in one.
    integer, parameter :: stretches = 64, most_steps = 60

contains

    !> The length of a stroke, deck units. Fails with `cause%no_convergence`, from quadrature.
    pure subroutine stroke_length(stroke, length, error)
        type(stroke_type), intent(in) :: stroke             !! any
        real(dp), intent(out) :: length                     !! deck units
        type(error_type), allocatable, intent(out) :: error !! see above
        type(speed_type) :: speed

        if (stroke%kind == stroke_kind%conic) then
            call arc_length(stroke%arc, length, error)
        else
            speed%stroke = stroke
            call integrate(speed, 0.0_dp, 1.0_dp, quadrature_tolerance, length, error)
        end if
    end subroutine stroke_length

    !> Places at equal lengths along a stroke, both ends included.
    !>
    !> Fails with `cause%no_convergence`, from quadrature.
    pure subroutine stroke_places(stroke, number, places, error)
        type(stroke_type), intent(in) :: stroke                     !! any
        integer, intent(in) :: number                               !! of places, 2 or more
        type(place_type), allocatable, intent(out) :: places(:)     !! in order
        type(error_type), allocatable, intent(out) :: error         !! see above
        type(speed_type) :: speed
        real(dp) :: reached(0:stretches), target
        integer :: i, k

        if (stroke%kind == stroke_kind%conic) then
            call places_by_length(stroke%arc, number, places, error)
            return
        end if
        speed%stroke = stroke
        reached(0) = 0.0_dp
        do k = 1, stretches
            call integrate(speed, share(k - 1), share(k), spacing_tolerance, reached(k), error)
            if (allocated(error)) return
            reached(k) = reached(k - 1) + reached(k)
        end do
        allocate (places(number))
        places(1) = at_start
        places(number) = at_finish
        k = 1
        do i = 2, number - 1
            target = reached(stretches)*real(i - 1, dp)/real(number - 1, dp)
            do while (reached(k) < target)
                k = k + 1
            end do
            places(i) = place_at(parameter_at(speed, [share(k - 1), share(k)], &
                target - reached(k - 1)))
        end do
    end subroutine stroke_places

    !> The parameter at which a stretch begins.
    pure real(dp) function share(number)
        integer, intent(in) :: number !! 0 to `stretches`
        share = real(number, dp)/real(stretches, dp)
    end function share

    !> The parameter at a length from the start of a stretch: Newton's method between bounds. A
    !> length that rounding keeps from its tolerance does as it is.
    pure real(dp) function parameter_at(speed, stretch, length) result(t)
        type(speed_type), intent(in) :: speed   !! of the curve
        real(dp), intent(in) :: stretch(2)      !! parameters of its ends
        real(dp), intent(in) :: length          !! deck units
        type(error_type), allocatable :: rough
        real(dp) :: bounds(2), done, pace
        integer :: i

        bounds = stretch
        t = 0.5_dp*sum(stretch)
        do i = 1, most_steps
            call integrate(speed, stretch(1), t, spacing_tolerance, done, rough)
            if (abs(done - length) <= spacing_tolerance*length) return
            bounds(merge(1, 2, done < length)) = t
            pace = speed%at(t)
            if (abs(length - done) < pace*(bounds(2) - bounds(1))) t = t + (length - done)/pace
            if (.not. (t > bounds(1) .and. t < bounds(2))) t = 0.5_dp*sum(bounds)
        end do
    end function parameter_at

    !> The speed at a parameter.
    pure real(dp) function speed_at(f, t) result(speed)
        class(speed_type), intent(in) :: f  !! of which curve
        real(dp), intent(in) :: t           !! 0 to 1
        real(dp), dimension(2) :: point, first, second
        call stroke_jet(f%stroke, t, point, first, second)
        speed = norm2(first)
    end function speed_at

end module geom_stroke_length
