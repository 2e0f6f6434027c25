!> From the point cards of a view of a control line to its chain: a spline through measured offsets,
!> a faired curve near them, or a Bezier curve of poles.
module body_build_points
    use base_error, only: cause, error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use base_tolerances, only: type_tolerance
    use body_points, only: points_of, weights_of
    use deck_body_card, only: blame, blame_span
    use deck_job, only: ending, origin, piece_real, piece_type, view_type
    use geom_arc, only: direction_of_slope
    use geom_chain, only: chain_type, new_chain
    use geom_cubic_spline, only: cubic_spline_type, open_spline, spline_end, spline_end_type, &
        spline_segment
    use geom_fairing, only: fair, fairing_type
    use geom_fairing_curve, only: uniform_segments
    use geom_fairing_system, only: fairing_data_type, fairing_end
    use geom_stroke, only: bezier_stroke, stroke_type
    implicit none (type, external)
    private

    public :: build_points

    !> Poles of a Bezier curve at most: beyond, its shape no longer follows them.
    integer, parameter :: most_poles = 26

contains

    !> Builds the chain of a view that is given by points. What is wrong is said of the card: too
    !> few points, points that are one, a line that turns back in STA.
    pure subroutine build_points(given, gap, chain, faults)
        type(view_type), intent(in) :: given                    !! by points
        real(dp), intent(in) :: gap                             !! largest gap, deck units
        type(chain_type), allocatable, intent(out) :: chain     !! where nothing is in error
        type(fault_list_type), intent(inout) :: faults          !! what is wrong is added
        type(stroke_type), allocatable :: strokes(:)
        type(chain_type) :: built
        type(error_type), allocatable :: error
        integer :: before

        before = faults%count
        allocate (strokes(0))
        if (given%origin == origin%spline) then
            call spline_strokes(given, strokes, faults)
        else if (given%origin == origin%fair) then
            call fair_strokes(given, strokes, faults)
        else
            call bezier_strokes(given, strokes, faults)
        end if
        if (faults%has_errors(before)) return
        call new_chain(strokes, gap, built, error)
        if (allocated(error)) then
            call blame_turn(given, strokes, gap, error%message, faults)
        else
            allocate (chain, source=built)
        end if
    end subroutine build_points

    !> The segments of the spline through the points.
    pure subroutine spline_strokes(given, strokes, faults)
        type(view_type), intent(in) :: given                        !! a spline
        type(stroke_type), allocatable, intent(inout) :: strokes(:) !! one from point to point
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        type(cubic_spline_type) :: spline
        type(spline_end_type) :: ends(2)
        type(error_type), allocatable :: error
        real(dp) :: at(2, size(given%piece))
        integer :: i, last

        at = points_of(given%piece)
        last = size(given%piece)
        if (last > 1) then
            ends(1) = end_of(given%piece(1), at(:, 2) - at(:, 1), given%is_uniform)
            ends(2) = end_of(given%piece(last), at(:, last) - at(:, last - 1), given%is_uniform)
        end if
        call open_spline(at, given%is_uniform, ends, spline, error)
        if (allocated(error)) then
            call blame(given%piece(merge(twin(at), last, error%cause == cause%points_coincide)) &
                %card, 1, error%message, faults)
            return
        end if
        deallocate (strokes)
        allocate (strokes(last - 1))
        do i = 1, last - 1
            strokes(i) = bezier_stroke(spline_segment(spline, i))
        end do
    end subroutine spline_strokes

    !> The segments of the faired curve near the points, held at the first and the last.
    pure subroutine fair_strokes(given, strokes, faults)
        type(view_type), intent(in) :: given                        !! a faired line
        type(stroke_type), allocatable, intent(inout) :: strokes(:) !! one from point to point
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        type(fairing_data_type) :: data
        type(fairing_type) :: fairing
        type(error_type), allocatable :: error
        real(dp), allocatable :: pole(:, :, :)
        integer :: i, last

        last = size(given%piece)
        data%ends = fairing_end%held
        data%point = points_of(given%piece)
        data%weight = weights_of(given%piece, given%weight)
        call fair(data, 0.0_dp, fairing, error)
        if (allocated(error)) then
            call blame(given%piece(last)%card, 1, error%message, faults)
            return
        end if
        allocate (pole, source=uniform_segments(fairing%vertex, fairing%is_closed))
        call put_on_stations(data%point(1, :), fairing%near)
        pole(:, 1, :) = fairing%near(:, :last - 1)
        pole(:, 4, :) = fairing%near(:, 2:)
        deallocate (strokes)
        allocate (strokes(last - 1))
        do i = 1, last - 1
            strokes(i) = bezier_stroke(pole(:, :, i))
        end do
    end subroutine fair_strokes

    !> Puts the points of a faired curve on the stations of those measured where nothing but
    !> rounding keeps them off: where the stations are even. So the joints of several lines are at
    !> one station.
    pure subroutine put_on_stations(station, near)
        real(dp), intent(in) :: station(:)      !! of the measured points
        real(dp), intent(inout) :: near(:, :)   !! points of the curve, by columns
        where (abs(near(1, :) - station) <= type_tolerance*maxval(abs(station))) &
            near(1, :) = station
    end subroutine put_on_stations

    !> The second of the first two neighbours that are one; 1 where there are none.
    pure integer function twin(at)
        real(dp), intent(in) :: at(:, :) !! points by columns
        do twin = 2, size(at, 2)
            if (all(abs(at(:, twin) - at(:, twin - 1)) <= 0.0_dp)) return
        end do
        twin = 1
    end function twin

    !> What a card asks at an end. A slope says a direction; it is pointed along the chord.
    pure type(spline_end_type) function end_of(item, chord, is_uniform) result(asked)
        type(piece_type), intent(in) :: item    !! the first or the last point
        real(dp), intent(in) :: chord(2)        !! of the segment there, along the line
        logical, intent(in) :: is_uniform       !! the tangent is then as long as the chord
        real(dp) :: tangent(2)

        if (item%ending == ending%parabola) asked%kind = spline_end%parabolic
        if (item%ending /= ending%slope) return
        asked%kind = spline_end%clamped
        tangent = direction_of_slope(piece_real(item, 3))
        if (dot_product(tangent, chord) < 0.0_dp) tangent = -tangent
        tangent = tangent/norm2(tangent)
        if (is_uniform) tangent = norm2(chord)*tangent
        allocate (asked%tangent, source=tangent)
    end function end_of

    !> The Bezier curve of the poles.
    pure subroutine bezier_strokes(given, strokes, faults)
        type(view_type), intent(in) :: given                        !! a Bezier curve
        type(stroke_type), allocatable, intent(inout) :: strokes(:) !! gets the curve
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        integer :: last

        last = size(given%piece)
        if (last < 2) then
            call blame(given%piece(last)%card, 1, &
                'a Bezier curve of one pole; it takes at least 2', faults)
        else if (last > most_poles) then
            call blame(given%piece(most_poles + 1)%card, 1, 'more than '//to_text(most_poles)// &
                ' poles; take a SPLINE, which follows its points', faults)
        else
            deallocate (strokes)
            allocate (strokes(1))
            strokes(1) = bezier_stroke(points_of(given%piece))
        end if
    end subroutine bezier_strokes

    !> Blames the points of the first stroke that makes no chain alone, or all of them.
    pure subroutine blame_turn(given, strokes, gap, message, faults)
        type(view_type), intent(in) :: given            !! by points
        type(stroke_type), intent(in) :: strokes(:)     !! its strokes
        real(dp), intent(in) :: gap                     !! largest gap, deck units
        character(*), intent(in) :: message             !! what is wrong with the whole
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        type(chain_type) :: alone
        type(error_type), allocatable :: error
        integer :: i

        do i = 1, size(strokes)
            call new_chain(strokes(i:i), gap, alone, error)
            if (.not. allocated(error)) cycle
            call blame_span(given%piece(i + 1)%card, 1, 2, error%message, faults)
            return
        end do
        call blame_span(given%piece(size(given%piece))%card, 1, 2, message, faults)
    end subroutine blame_turn

end module body_build_points
