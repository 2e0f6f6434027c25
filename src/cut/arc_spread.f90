!> How the points of a cut are spread along the conic arc of a station.
module cut_arc_spread
    use base_error, only: error_type
    use base_kinds, only: dp
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

    !> Halvings of an arc for chords: 2**16 chords are more than any tolerance needs.
    integer, parameter :: deepest = 16

contains

    !> The places of the points of an arc, in order, both ends included. Where STA is stepped, which
    !> is constant here, these are 25 at equal lengths.
    !>
    !> Fails with the causes of `contour_of`, `arc_length` and `places_by_length`.
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
            call places_by_length(arc, 1 + max(1, nint(length/request%step)), places, error)
        case (cut_rule%chord)
            places = within_chords(arc, request%step)
        end select
    end subroutine places_on

    !> Places such that no chord is further than a tolerance from the arc.
    pure function within_chords(arc, tolerance) result(places)
        type(arc_type), intent(in) :: arc       !! any arc
        real(dp), intent(in) :: tolerance       !! deck units, above zero
        type(place_type), allocatable :: places(:), finer(:)
        integer :: i, depth

        allocate (finer(0))
        places = [at_start, at_shoulder, at_finish]
        if (arc%is_line) places = [at_start, at_finish]
        do depth = 1, deepest
            finer = places(:1)
            do i = 2, size(places)
                if (off_chord(arc, places(i - 1:i)) > tolerance) &
                    finer = [finer, place_between(arc, places(i - 1), places(i))]
                finer = [finer, places(i)]
            end do
            if (size(finer) == size(places)) exit
            places = finer
        end do
    end function within_chords

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
