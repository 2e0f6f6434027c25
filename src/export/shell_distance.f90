!> How far a surface is from the skin, measured: normal to the skin; along its edges normal to the
!> control lines, so that a face neither falls short of its edge nor passes it.
!>
!> A point of the surface is compared with the point of the skin at the same u and t (`place_at` of
!> the section's arc; t is v). Where these miss each other along the skin, too, the foot of the
!> normal is sought by Newton's steps, so that the curvature of the skin does not count.
module export_shell_distance
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: section_arc, section_type
    use body_taylor, only: taylor_type
    use cut_measure_sheet, only: frame_at, frame_type, spot_at, spot_type
    use export_shell_pace, only: pace_type, station_at
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_bspline_surface, only: bspline_surface_type, surface_point
    use geom_place, only: place_at
    implicit none (type, external)
    private

    public :: sheet_type, miss_type, measure_span, skin_distance

    !> A surface with the skin that it stands for.
    type :: sheet_type
        type(body_type) :: body                 !! lines of one arc a view
        type(section_type) :: section           !! on them
        type(pace_type) :: pace                 !! how the station runs
        real(dp) :: slide = 0.0_dp              !! how far points may miss each other along the skin
        type(bspline_surface_type) :: surface   !! of the section
    end type sheet_type

    !> A largest distance.
    type :: miss_type
        real(dp) :: distance = 0.0_dp       !! deck units
        real(dp) :: at(3) = 0.0_dp          !! of the surface: STA, BL, WL
    end type miss_type

    !> The skin at one u: its section, and how it changes along u.
    type :: slice_type
        real(dp) :: u = 0.0_dp      !! where
        type(arc_type) :: arc       !! the section
        type(frame_type) :: frame   !! with its derivatives
    end type slice_type

    !> Places of a span, and of a section with its ends, at which is measured. Those of a span crowd
    !> towards its ends, as the error of interpolation does in the first and the last one.
    integer, parameter :: stations = 17, around = 11
    !> Newton's steps at most.
    integer, parameter :: steps = 3

contains

    !> Raises the largest distance by that of a span of a surface. Fails as `section_arc`.
    pure subroutine measure_span(sheet, from, to, miss, error)
        type(sheet_type), intent(in) :: sheet               !! any
        real(dp), intent(in) :: from                        !! u where the span begins
        real(dp), intent(in) :: to                          !! u where it ends
        type(miss_type), intent(inout) :: miss              !! so far
        type(error_type), allocatable, intent(out) :: error !! see above
        type(slice_type) :: slice
        real(dp) :: t, found
        integer :: i, k

        do i = 1, stations
            call new_slice(sheet, from + (to - from)*sin(0.25_dp*pi*real(2*i - 1, dp)/ &
                real(stations, dp))**2, slice, error)
            if (allocated(error)) return
            do k = 0, around - 1
                t = real(k, dp)/real(around - 1, dp)
                found = skin_distance(sheet, slice, t)
                if (.not. found > miss%distance) cycle
                miss = miss_type(found, surface_point(sheet%surface, slice%u, t))
            end do
        end do
    end subroutine measure_span

    !> The skin at a u inside. Fails as `section_arc`.
    pure subroutine new_slice(sheet, u, slice, error)
        type(sheet_type), intent(in) :: sheet               !! any
        real(dp), intent(in) :: u                           !! above 0, below 1
        type(slice_type), intent(out) :: slice              !! there
        type(error_type), allocatable, intent(out) :: error !! see above
        type(taylor_type) :: sta

        slice%u = u
        sta = station_at(sheet%pace, u)
        call section_arc(sheet%body%lines, sheet%section, sta%value, slice%arc, error)
        if (allocated(error)) return
        call frame_at(sheet%body, sheet%section, sta, slice%frame, error)
    end subroutine new_slice

    !> The distance of a point of a surface, deck units.
    pure real(dp) function skin_distance(sheet, slice, t) result(distance)
        type(sheet_type), intent(in) :: sheet   !! any
        type(slice_type), intent(in) :: slice   !! of it
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp) :: at(3), step(2), foot
        type(slice_type) :: near
        type(spot_type) :: spot
        type(error_type), allocatable :: error
        logical :: is_edge
        integer :: i

        at = surface_point(sheet%surface, slice%u, t)
        is_edge = t <= 0.0_dp .or. t >= 1.0_dp
        near = slice
        foot = t
        do i = 1, steps
            spot = spot_at(near%frame, foot)
            spot%at(2:) = point(near%arc, place_at(foot))
            call compare(at - spot%at, spot, is_edge, step, distance)
            if (norm2(step(1)*spot%u + step(2)*spot%t) <= sheet%slide) return
            foot = min(max(foot + step(2), 0.0_dp), 1.0_dp)
            call new_slice(sheet, inside(near%u + step(1)), near, error)
            if (allocated(error)) return
        end do
    end function skin_distance

    !> The u of a slice that is not at an end.
    pure real(dp) function inside(u)
        real(dp), intent(in) :: u !! any
        real(dp), parameter :: margin = 1.0e-6_dp
        inside = min(max(u, margin), 1.0_dp - margin)
    end function inside

    !> Parts the way from a point of the skin into what is along the skin, or along a control line,
    !> and the rest; a way where there is no skin to go along is all rest.
    pure subroutine compare(way, spot, is_edge, step, distance)
        real(dp), intent(in) :: way(3)          !! STA, BL, WL
        type(spot_type), intent(in) :: spot     !! the point of the skin
        logical, intent(in) :: is_edge          !! it is on a control line
        real(dp), intent(out) :: step(2)        !! along the skin, as u and t
        real(dp), intent(out) :: distance       !! the rest, deck units
        real(dp) :: uu, ut, tt, off, rest(3)
        real(dp), parameter :: flattest = 1.0e-12_dp

        uu = dot_product(spot%u, spot%u)
        ut = dot_product(spot%u, spot%t)
        tt = dot_product(spot%t, spot%t)
        off = uu*tt - ut**2
        step = 0.0_dp
        if (is_edge) then
            if (uu > 0.0_dp) step(1) = dot_product(way, spot%u)/uu
        else if (off > flattest*uu*tt) then
            step(1) = (dot_product(way, spot%u)*tt - dot_product(way, spot%t)*ut)/off
            step(2) = (dot_product(way, spot%t)*uu - dot_product(way, spot%u)*ut)/off
        end if
        rest = way - step(1)*spot%u - step(2)*spot%t
        distance = norm2(rest)
    end subroutine compare

end module export_shell_distance
