!> How the points of a cut are spread along the conic arc of a station.
module cut_arc_spread
    use base_constants, only: largest_table
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use cut_request, only: cut_rule, request_type
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_contour, only: contour_of, contour_point_type
    use geom_length, only: arc_length, places_by_length
    use geom_place, only: at_finish, at_shoulder, at_start, place_type
    use geom_subarc, only: place_between
    implicit none (type, external)
    private

    public :: places_on

    !> Halvings of an arc for chords: what is left is below the rounding of its points.
    integer, parameter :: deepest = 40

contains

    !> The places of the points of an arc, in order, both ends included. Where STA is stepped, which
    !> is constant here, these are 25 at equal lengths.
    !>
    !> Fails with `cause%too_many` where there are more than `largest_table`, and with the causes of
    !> `contour_of`, `arc_length` and `places_by_length`.
    pure subroutine places_on(arc, request, places, error)
        type(arc_type), intent(in) :: arc                           !! x is BL, y is WL
        type(request_type), intent(in) :: request                   !! the rule
        type(place_type), allocatable, intent(out) :: places(:)     !! see above
        type(error_type), allocatable, intent(out) :: error         !! see above
        type(contour_point_type), allocatable :: rows(:)
        type(request_type), parameter :: usual = request_type()
        real(dp) :: length

        select case (request%rule)
        case (cut_rule%step)
            if (request%axis == 1) then
                call places_by_length(arc, usual%number, places, error)
            else
                call contour_of(arc, request%axis - 1, request%grid, rows, error)
                if (.not. allocated(error)) places = rows%place
            end if
        case (cut_rule%number)
            call places_by_length(arc, max(2, request%number), places, error)
        case (cut_rule%length)
            call arc_length(arc, length, error)
            if (allocated(error)) return
            if (length/request%step > largest_table) then
                call fail(error, cause%too_many, 'lengths of '//compact(request%step)// &
                    ' divide an arc of '//compact(length)//' into too many; LOFT makes at most '// &
                    to_text(largest_table)//' points: take longer ones')
                return
            end if
            call places_by_length(arc, 1 + max(1, nint(length/request%step)), places, error)
        case (cut_rule%chord)
            call within_chords(arc, request%step, places, error)
        end select
    end subroutine places_on

    !> Places such that no chord is further than a tolerance from the arc: from the start on, what
    !> is ahead is halved until its chord is near enough. Fails with `cause%too_many`.
    pure subroutine within_chords(arc, tolerance, places, error)
        type(arc_type), intent(in) :: arc                           !! any arc
        real(dp), intent(in) :: tolerance                           !! deck units, above zero
        type(place_type), allocatable, intent(out) :: places(:)     !! in order, ends included
        type(error_type), allocatable, intent(out) :: error         !! see above
        type(place_type), allocatable :: found(:)
        type(place_type) :: ahead(deepest)
        integer :: count, left

        allocate (found(largest_table))
        found(1) = at_start
        count = 1
        ahead(:2) = [at_finish, at_shoulder]
        left = merge(1, 2, arc%is_line)
        do while (left > 0)
            if (left < deepest .and. off_chord(arc, [found(count), ahead(left)]) > tolerance) then
                ahead(left + 1) = place_between(arc, found(count), ahead(left))
                left = left + 1
                cycle
            end if
            if (count == largest_table) then
                call fail(error, cause%too_many, 'chords within '//compact(tolerance)// &
                    ' of an arc are too many; LOFT makes at most '//to_text(largest_table)// &
                    ' points: take a larger tolerance')
                return
            end if
            count = count + 1
            found(count) = ahead(left)
            left = left - 1
        end do
        places = found(:count)
    end subroutine within_chords

    !> The greatest distance of the part of an arc between two places from its chord: that of its
    !> shoulder.
    pure real(dp) function off_chord(arc, places) result(distance)
        type(arc_type), intent(in) :: arc           !! any arc
        type(place_type), intent(in) :: places(2)   !! in order
        real(dp) :: ends(2, 2), chord(2), off(2)

        ends(:, 1) = point(arc, places(1))
        ends(:, 2) = point(arc, places(2))
        chord = ends(:, 2) - ends(:, 1)
        off = point(arc, place_between(arc, places(1), places(2))) - ends(:, 1)
        distance = abs(off(1)*chord(2) - off(2)*chord(1))/max(norm2(chord), tiny(1.0_dp))
    end function off_chord

end module cut_arc_spread
