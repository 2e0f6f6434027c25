!> A stretch of skin as rational B-spline surfaces: the rows of its sections (`export_shell_rows`)
!> are fitted over u, all on the same breaks, so that sections that share a track share its poles.
!> Around a section the surfaces are exact.
module export_shell_fit
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_taylor, only: taylor_type
    use export_shell_pace, only: divisor_at, pace_type, station_at
    use export_shell_ribs, only: ends_type
    use export_shell_rows, only: form, pole_count, poles_of, rows_at, rows_type
    use export_shell_stretch, only: stretch_type, track_at
    use geom_bspline, only: bspline_type
    use geom_bspline_surface, only: bspline_surface_type
    use geom_spline_fit, only: fit_knots, fit_nodes, fit_values
    implicit none (type, external)
    private

    public :: fit_type, fit_rows, track_spline, rib_spline, slot_surface

    !> The rows of a stretch as splines of u. Poles are homogeneous: STA, BL, WL times weight, and
    !> weight.
    type :: fit_type
        type(pace_type) :: pace                         !! how the station runs
        integer :: degree = 0                           !! along u
        real(dp), allocatable :: breaks(:)              !! of u, rising from 0 to 1
        real(dp), allocatable :: track(:, :, :)         !! shape (4, poles, tracks)
        real(dp), allocatable :: middle(:, :, :)        !! V1 of the slots: (4, poles, slots)
    end type fit_type

contains

    !> Fits the rows of a stretch; at both ends they are those of its ribs.
    !>
    !> Fails as `rows_at` where a section has no arc, and as `fit_values`.
    pure subroutine fit_rows(stretch, ends, fit, error)
        type(stretch_type), intent(in) :: stretch           !! any
        type(ends_type), intent(in) :: ends                 !! of it
        type(fit_type), intent(inout) :: fit                !! pace, degree and breaks; gets poles
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp), allocatable :: nodes(:), values(:, :, :), poles(:, :)
        integer :: i, n, tracks, slots

        allocate (nodes, source=fit_nodes(fit%breaks, fit%degree))
        n = size(nodes)
        tracks = size(stretch%tracks)
        slots = size(stretch%slots)
        allocate (values(4, tracks + slots, n), poles(4*(tracks + slots), n))
        do i = 2, n - 1
            call inner_values(stretch, fit%pace, nodes(i), values(:, :, i), error)
            if (allocated(error)) return
        end do
        call end_values(stretch, ends, 1, values(:, :, 1))
        call end_values(stretch, ends, 2, values(:, :, n))
        call fit_values(fit%breaks, fit%degree, reshape(values, shape(poles)), poles, error)
        if (allocated(error)) return
        values = reshape(poles, shape(values))
        fit%track = reshape(values(:, :tracks, :), [4, n, tracks], order=[1, 3, 2])
        fit%middle = reshape(values(:, tracks + 1:, :), [4, n, slots], order=[1, 3, 2])
    end subroutine fit_rows

    !> The rows of all tracks and of V1 of all slots at a u inside. Fails as `rows_at`.
    pure subroutine inner_values(stretch, pace, u, values, error)
        type(stretch_type), intent(in) :: stretch           !! any
        type(pace_type), intent(in) :: pace                 !! how the station runs
        real(dp), intent(in) :: u                           !! above 0, below 1
        real(dp), intent(out) :: values(:, :)               !! shape (4, tracks + slots)
        type(error_type), allocatable, intent(out) :: error !! see above
        type(rows_type) :: rows
        type(taylor_type) :: sta
        integer :: k, tracks

        tracks = size(stretch%tracks)
        sta = station_at(pace, u)
        do k = 1, tracks
            values(:, k) = [sta%value, track_at(stretch, stretch%tracks(k), sta%value), 1.0_dp]
        end do
        do k = 1, size(stretch%slots)
            call rows_at(stretch, stretch%slots(k), sta%value, rows, error)
            if (allocated(error)) return
            values(:, tracks + k) = [rows%weight*sta%value, rows%middle, rows%weight]
        end do
        values = divisor_at(pace, u)*values
    end subroutine inner_values

    !> The same at an end.
    pure subroutine end_values(stretch, ends, end, values)
        type(stretch_type), intent(in) :: stretch           !! any
        type(ends_type), intent(in) :: ends                 !! of it
        integer, intent(in) :: end                          !! 1: fore, 2: aft
        real(dp), intent(out) :: values(:, :)               !! shape (4, tracks + slots)
        real(dp) :: sta
        integer :: k, tracks

        tracks = size(stretch%tracks)
        sta = merge(stretch%pace%from, stretch%pace%to, end == 1)
        do k = 1, size(stretch%slots)
            associate (rows => ends%rows(end, k), track => stretch%slots(k)%track)
                values(:, track(1)) = [sta, rows%start, 1.0_dp]
                values(:, track(2)) = [sta, rows%finish, 1.0_dp]
                values(:, tracks + k) = [rows%weight*sta, rows%middle, rows%weight]
            end associate
        end do
    end subroutine end_values

    !> The curve of a track.
    pure type(bspline_type) function track_spline(fit, track) result(curve)
        type(fit_type), intent(in) :: fit   !! with its poles
        integer, intent(in) :: track        !! which
        integer :: i

        curve%degree = fit%degree
        allocate (curve%knot, source=fit_knots(fit%breaks, fit%degree))
        allocate (curve%weight, source=fit%track(4, :, track))
        allocate (curve%pole(3, size(curve%weight)))
        do i = 1, 3
            curve%pole(i, :) = fit%track(i, :, track)/curve%weight
        end do
    end function track_spline

    !> The surface of a section in a stretch. Weights that are not above zero say that there are too
    !> few breaks.
    pure type(bspline_surface_type) function slot_surface(fit, stretch, ends, slot, which) &
        result(surface)
        type(fit_type), intent(in) :: fit           !! with its poles
        type(stretch_type), intent(in) :: stretch   !! of it
        type(ends_type), intent(in) :: ends         !! of it
        integer, intent(in) :: slot                 !! which slot
        integer, intent(in) :: which                !! one of `form%...`
        integer :: i, n

        associate (track => stretch%slots(slot)%track)
            n = size(fit%track, 2)
            surface%degree = [fit%degree, merge(1, 2, which == form%line)]
            allocate (surface%u_knot, source=fit_knots(fit%breaks, fit%degree))
            surface%v_knot = around(which)
            allocate (surface%pole(3, n, pole_count(which)), surface%weight(n, pole_count(which)))
            do i = 1, n
                call put_row(poles_of(fit%track(:, i, track(1)), fit%middle(:, i, slot), &
                    fit%track(:, i, track(2)), which), i, surface)
            end do
            do i = 1, 2
                call close_end(merge(1, n, i == 1), ends%rib(i, slot) == 0)
            end do
        end associate
    contains
        !> Brings the poles of an end to its station exactly, or all of them to one point.
        pure subroutine close_end(row, is_point)
            integer, intent(in) :: row      !! which u pole
            logical, intent(in) :: is_point !! the section is a point there
            integer :: j
            do j = 2, size(surface%weight, 2) - 1
                surface%pole(1, row, j) = surface%pole(1, row, 1)
                if (is_point) surface%pole(:, row, j) = surface%pole(:, row, 1)
            end do
        end subroutine close_end
    end function slot_surface

    !> The curve of a rib, as the surfaces have it that end on it; a straight one in degree 1.
    pure type(bspline_type) function rib_spline(rows, sta, which) result(curve)
        type(rows_type), intent(in) :: rows     !! it
        real(dp), intent(in) :: sta             !! its station, deck units
        integer, intent(in) :: which            !! one of `form%...`
        real(dp) :: poles(3, pole_count(which))
        integer :: i

        poles = poles_of([rows%start, 1.0_dp], [rows%middle, rows%weight], &
            [rows%finish, 1.0_dp], which)
        curve%degree = merge(1, 2, which == form%line)
        allocate (curve%knot, source=around(which))
        allocate (curve%weight, source=poles(3, :))
        allocate (curve%pole(3, size(curve%weight)))
        do i = 1, size(curve%weight)
            curve%pole(:, i) = [sta, poles(:2, i)/poles(3, i)]
        end do
    end function rib_spline

    !> The knots around a section.
    pure function around(which) result(knots)
        integer, intent(in) :: which !! one of `form%...`
        real(dp), allocatable :: knots(:)
        select case (which)
        case (form%line)
            knots = real([0, 0, 1, 1], dp)
        case (form%arc)
            knots = real([0, 0, 0, 1, 1, 1], dp)
        case default
            knots = [0.0_dp, 0.0_dp, 0.0_dp, 0.5_dp, 0.5_dp, 1.0_dp, 1.0_dp, 1.0_dp]
        end select
    end function around

    !> Puts the poles at one place of u to a surface. A weight that is not above zero stays; its
    !> pole is not used.
    pure subroutine put_row(poles, row, surface)
        real(dp), intent(in) :: poles(:, :)                     !! homogeneous: (4, v poles)
        integer, intent(in) :: row                              !! which u pole
        type(bspline_surface_type), intent(inout) :: surface    !! gets them
        integer :: j

        surface%weight(row, :) = poles(4, :)
        do j = 1, size(poles, 2)
            surface%pole(:, row, j) = poles(:3, j)
            if (poles(4, j) > 0.0_dp) surface%pole(:, row, j) = poles(:3, j)/poles(4, j)
        end do
    end subroutine put_row

end module export_shell_fit
