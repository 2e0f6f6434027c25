!> The rows of a section (`export_shell_rows`) at an end of a stretch. Where it shrinks to a point
!> or to a line there, V1 and w are limits, worked from stations near the end.
module export_shell_limits
    use base_constants, only: pi
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use body_section, only: is_point, trace_at
    use body_taylor, only: taylor_type
    use export_shell_pace, only: station_at
    use export_shell_rows, only: rows_at, rows_type
    use export_shell_stretch, only: slot_type, stretch_type
    implicit none (type, external)
    private

    public :: end_rows

    !> V1 and w at an end.
    type :: limit_type
        real(dp) :: middle(2) = 0.0_dp      !! V1, deck units
        real(dp) :: weight = 0.0_dp         !! w
        logical :: is_line = .false.        !! the section is straight near the end
        real(dp) :: doubt = huge(1.0_dp)    !! by how much the same polynomial misses w, and V1 in
                                            !! parts of the stretch, at a place nearer to the end
    end type limit_type

    !> Limits are worked from so many stations within a part of u, this one or one of those that are
    !> quarters of the one before: the best by its doubt.
    integer, parameter :: inner = 10, narrowings = 4
    real(dp), parameter :: first_part = 0.0625_dp
    !> Where the polynomial is tried: parts of that part from the end.
    real(dp), parameter :: nearer = 0.003_dp

contains

    !> The rows of a section at an end of a stretch: where it is a point or has shrunk to a line,
    !> limits. Fails where there are none.
    pure subroutine end_rows(stretch, slot, end, rows, error)
        type(stretch_type), intent(in) :: stretch           !! any
        type(slot_type), intent(in) :: slot                 !! one of its slots
        integer, intent(in) :: end                          !! 1: the fore end, 2: the aft end
        type(rows_type), intent(out) :: rows                !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(limit_type) :: limit, best
        real(dp) :: sta
        integer :: i

        sta = merge(stretch%pace%from, stretch%pace%to, end == 1)
        call rows_at(stretch, slot, sta, rows, error)
        if (slot%number == 0) return
        if (.not. (allocated(error) .or. rows%is_line)) return
        do i = 0, narrowings
            call find_limit(stretch, slot, end, first_part*0.25_dp**i, limit, error)
            if (allocated(error)) return
            if (limit%doubt < best%doubt) best = limit
        end do
        rows%middle = best%middle
        rows%weight = best%weight
        rows%is_line = best%is_line
        if (rows%is_line) rows%middle = 0.5_dp*(rows%start + rows%finish)
        if (is_point(trace_at(stretch%body%lines, slot%section, sta))) &
            rows%middle = rows%weight*rows%start
        if (rows%weight > -1.0_dp) return
        call fail(error, cause%no_arc, 'section '//trim(slot%section%name)// &
            ' has no conic that it nears at station '//compact(sta))
    end subroutine end_rows

    !> V1 and w at an end as the polynomial through stations near it has them. Fails as `rows_at`.
    pure subroutine find_limit(stretch, slot, end, part, limit, error)
        type(stretch_type), intent(in) :: stretch           !! any
        type(slot_type), intent(in) :: slot                 !! one of its slots
        integer, intent(in) :: end                          !! 1: the fore end, 2: the aft end
        real(dp), intent(in) :: part                        !! of u, where the stations are
        type(limit_type), intent(out) :: limit              !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(rows_type) :: near(0:inner)
        real(dp) :: way, share(inner)
        type(taylor_type) :: sta
        integer :: i

        do i = 0, inner
            way = part*nearer
            if (i > 0) way = 0.5_dp*part*(1.0_dp - cos(angle_of(i)))
            sta = station_at(stretch%pace, merge(way, 1.0_dp - way, end == 1))
            call rows_at(stretch, slot, sta%value, near(i), error)
            if (allocated(error)) return
        end do
        share = shares_at(nearer)
        limit%doubt = abs(weight_of() - near(0)%weight) &
            + norm2(middle_of() - near(0)%middle)/(stretch%pace%to - stretch%pace%from)
        share = shares_at(0.0_dp)
        limit%weight = weight_of()
        limit%middle = middle_of()
        limit%is_line = all(near%is_line)
    contains
        !> w as the stations have it by their shares.
        pure real(dp) function weight_of()
            weight_of = sum(share*near(1:)%weight)
        end function weight_of

        !> V1 too.
        pure function middle_of() result(middle)
            real(dp) :: middle(2)
            middle = [sum(share*near(1:)%middle(1)), sum(share*near(1:)%middle(2))]
        end function middle_of
    end subroutine find_limit

    !> What the stations near an end count for a place as near or nearer: the polynomial through
    !> Chebyshev's points (J.-P. Berrut and L. N. Trefethen, "Barycentric Lagrange interpolation",
    !> SIAM Review 46 (2004), 5.3).
    pure function shares_at(place) result(share)
        real(dp), intent(in) :: place !! parts of their stretch from the end; none of the points
        real(dp) :: share(inner)
        integer :: i

        do i = 1, inner
            share(i) = (-1.0_dp)**i*sin(angle_of(i))/ &
                (1.0_dp - cos(angle_of(i)) - 2.0_dp*place)
        end do
        share = share/sum(share)
    end function shares_at

    !> The angle of one of Chebyshev's points.
    pure real(dp) function angle_of(number)
        integer, intent(in) :: number !! from the end on
        angle_of = 0.5_dp*pi*real(2*number - 1, dp)/real(inner, dp)
    end function angle_of

end module export_shell_limits
