!> How closely the skin wants to be divided, along the body and around each section, so that flat
!> triangles stay near to it.
!>
!> Over a cell of steps h along u (`cut_measure_sheet`) and k of the share (`export_mesh_share`) the
!> better of the two ways to part it into triangles is off the skin by no more than
!>
!>     (L' h**2 + N' k**2)/8,   L' = max(|L|, a |M|), N' = max(|N|, |M|/a)
!>
!> to second order, for any a > 0 (since 2 |M| h k <= a |M| h**2 + |M| k**2/a). The product L' N',
!> and with it the number of triangles, is least for each a between |L/M| and |M/N|; of these the
!> nearest to |Su|/|Sk| is taken, for which both steps are of one length. So the square root of L'/8
!> says how many steps are needed for a tolerance of 1, and the turn of the normal how many for an
!> angle of 1.
module export_mesh_density
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: is_point, trace_at
    use body_taylor, only: taylor_type
    use cut_measure_body, only: stops_of
    use cut_measure_ring, only: sections_at
    use cut_measure_sheet, only: frame_at, frame_type, new_span, span_type, spot_at, station_of
    use export_mesh_form, only: form_at, form_type, turn_along
    use export_mesh_share, only: pace_at, parameter_at
    implicit none (type, external)
    private

    public :: need_type, stretch_type, density_type, find_density

    !> Samples along a stretch and around a section, each in the middle of its part.
    integer, parameter, public :: samples_along = 48, samples_around = 24

    !> How many steps are wanted for one of the parameter, at the samples over 0 to 1.
    type :: need_type
        real(dp), allocatable :: chord(:)   !! for a tolerance of 1 deck unit
        real(dp), allocatable :: turn(:)    !! for an angle of 1 radian
    end type need_type

    !> A stretch of a body between two stops.
    type :: stretch_type
        real(dp) :: from = 0.0_dp           !! least station, deck units
        real(dp) :: to = 0.0_dp             !! greatest station, deck units
        integer, allocatable :: sections(:) !! those that are there, in the body's list; may be none
        type(span_type) :: span             !! how u runs over the stations
        type(need_type) :: need             !! along it, over u
    end type stretch_type

    !> All of a body.
    type :: density_type
        type(stretch_type), allocatable :: stretches(:) !! in order of stations, end to end
        type(need_type), allocatable :: around(:)       !! of each section of the body, over shares
    end type density_type

contains

    !> Looks at the whole skin. Fails as `section_arc` where a section has no arc.
    pure subroutine find_density(body, density, error)
        type(body_type), intent(in) :: body                 !! finished
        type(density_type), intent(out) :: density          !! what is wanted
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp), allocatable :: stops(:)
        integer :: i, k

        allocate (stops(0))
        stops = stops_of(body)
        allocate (density%stretches(max(0, size(stops) - 1)), density%around(size(body%sections)))
        do i = 1, size(density%around)
            density%around(i) = no_need(samples_around)
        end do
        do i = 1, size(density%stretches)
            associate (stretch => density%stretches(i))
                stretch%from = stops(i)
                stretch%to = stops(i + 1)
                stretch%sections = sections_at(body, 0.5_dp*(stops(i) + stops(i + 1)))
                stretch%span = new_span(body, stretch%sections, stops(i), stops(i + 1))
                stretch%need = no_need(samples_along)
                do k = 1, size(stretch%sections)
                    call look_along(body, stretch%sections(k), stretch%span, stretch%need, &
                        density%around(stretch%sections(k)), error)
                    if (allocated(error)) return
                end do
            end associate
        end do
    end subroutine find_density

    !> Nothing wanted yet.
    pure type(need_type) function no_need(samples) result(need)
        integer, intent(in) :: samples !! how many
        allocate (need%chord(samples), source=0.0_dp)
        allocate (need%turn(samples), source=0.0_dp)
    end function no_need

    !> Looks at a section over a stretch.
    pure subroutine look_along(body, number, span, along, around, error)
        type(body_type), intent(in) :: body                 !! finished
        integer, intent(in) :: number                       !! which section
        type(span_type), intent(in) :: span                 !! the stretch
        type(need_type), intent(inout) :: along             !! raised to what is wanted along it
        type(need_type), intent(inout) :: around            !! and around it
        type(error_type), allocatable, intent(out) :: error !! the section has no arc
        type(frame_type) :: frame
        type(taylor_type) :: sta
        integer :: i, j

        do i = 1, samples_along
            sta = station_of(span, (real(i, dp) - 0.5_dp)/real(samples_along, dp))
            associate (section => body%sections(number))
                if (is_point(trace_at(body%lines, section, sta%value))) cycle
                call frame_at(body, section, sta, frame, error)
            end associate
            if (allocated(error)) return
            do j = 1, samples_around
                call look_at(frame, (real(j, dp) - 0.5_dp)/real(samples_around, dp), &
                    along%chord(i), along%turn(i), around%chord(j), around%turn(j))
            end do
        end do
    end subroutine look_along

    !> Looks at one point.
    pure subroutine look_at(frame, share, chord_along, turn_u, chord_around, turn_k)
        type(frame_type), intent(in) :: frame           !! the section at a u
        real(dp), intent(in) :: share                   !! where on it
        real(dp), intent(inout) :: chord_along          !! raised to sqrt(L'/8)
        real(dp), intent(inout) :: turn_u               !! raised to the turn along u
        real(dp), intent(inout) :: chord_around         !! raised to sqrt(N'/8)
        real(dp), intent(inout) :: turn_k               !! raised to the turn along the share
        type(form_type) :: form
        real(dp) :: along(2), around(2), ratio, l, m, n

        form = form_at(spot_at(frame, parameter_at(share, frame%fullness%value - 1.0_dp)))
        if (.not. form%is_there) return
        along = [1.0_dp, drift(frame, share)]
        around = [0.0_dp, pace_at(share, frame%fullness%value - 1.0_dp)]
        l = abs(dot_product(along, matmul(form%second, along)))
        m = abs(dot_product(along, matmul(form%second, around)))
        n = abs(dot_product(around, matmul(form%second, around)))
        ratio = sqrt(dot_product(along, matmul(form%first, along)) &
            /dot_product(around, matmul(form%first, around)))
        if (m > 0.0_dp) ratio = between(ratio, [l, m], [m, n])
        chord_along = max(chord_along, sqrt(0.125_dp*max(l, ratio*m)))
        chord_around = max(chord_around, sqrt(0.125_dp*max(n, m/ratio)))
        turn_u = max(turn_u, turn_along(form, along))
        turn_k = max(turn_k, turn_along(form, around))
    end subroutine look_at

    !> A number moved to between two quotients, of which the second may be infinite.
    pure real(dp) function between(number, first, second) result(moved)
        real(dp), intent(in) :: number      !! above zero
        real(dp), intent(in) :: first(2)    !! over, under: the under above zero
        real(dp), intent(in) :: second(2)   !! over, under: the over above zero
        logical :: is_over(2)

        is_over = number*[first(2), second(2)] > [first(1), second(1)]
        moved = number
        if (is_over(1) .neqv. is_over(2)) return
        moved = first(1)/first(2)
        if (is_over(1) .neqv. moved*second(2) > second(1)) moved = second(1)/second(2)
    end function between

    !> How fast the parameter at a share changes along u, because the weight of the arc does.
    pure real(dp) function drift(frame, share)
        type(frame_type), intent(in) :: frame   !! the section at a u
        real(dp), intent(in) :: share           !! where on it
        real(dp) :: weight, step
        real(dp), parameter :: part = 1.0e-4_dp

        weight = frame%fullness%value - 1.0_dp
        step = part*frame%fullness%value
        drift = frame%fullness%first*(parameter_at(share, weight + step) &
            - parameter_at(share, weight - step))/(2.0_dp*step)
    end function drift

end module export_mesh_density
