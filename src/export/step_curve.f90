!> Points, directions and curves of a STEP file (ISO 10303-42, clause 4).
!>
!> A rational spline is an instance of many entities at once, which is how STEP writes what is both
!> a B-spline with knots and a rational one; a polynomial spline is a plain one, which every reader
!> knows. Straight edges are lines. Native conics are not written: readers lose them.
module export_step_curve
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_text, only: to_text
    use export_step_text, only: step_file_type, step_list, step_logical, step_real, &
        step_reference, step_references, step_string
    use geom_bspline, only: bspline_type, is_rational
    use geom_bspline_basis, only: breaks_of
    implicit none (type, external)
    private

    public :: add_point, add_direction, add_placement, add_curve, add_edge_curve
    public :: curve_word, knot_words

contains

    !> Adds a point.
    subroutine add_point(file, at, number)
        type(step_file_type), intent(inout) :: file !! gets it
        real(dp), intent(in) :: at(3)               !! STA, BL, WL
        integer, intent(out) :: number              !! of the instance
        call file%add('CARTESIAN_POINT('''','//step_list(at)//')', number)
    end subroutine add_point

    !> Adds a direction.
    subroutine add_direction(file, along, number)
        type(step_file_type), intent(inout) :: file !! gets it
        real(dp), intent(in) :: along(3)            !! not zero
        integer, intent(out) :: number              !! of the instance
        call file%add('DIRECTION('''','//step_list(along)//')', number)
    end subroutine add_direction

    !> Adds a place with axes: z as given, x the way of the coordinate axis that z is farthest from.
    subroutine add_placement(file, origin, z, number)
        type(step_file_type), intent(inout) :: file !! gets it
        real(dp), intent(in) :: origin(3)           !! STA, BL, WL
        real(dp), intent(in) :: z(3)                !! unit vector
        integer, intent(out) :: number              !! of the instance
        real(dp) :: x(3)
        integer :: parts(3), axis

        axis = minloc(abs(z), dim=1)
        x = -z(axis)*z
        x(axis) = x(axis) + 1.0_dp
        call add_point(file, origin, parts(1))
        call add_direction(file, z, parts(2))
        call add_direction(file, x/norm2(x), parts(3))
        call file%add('AXIS2_PLACEMENT_3D('''','//step_reference(parts(1))//','// &
            step_reference(parts(2))//','//step_reference(parts(3))//')', number)
    end subroutine add_placement

    !> Adds the curve of an edge: a line where it is straight.
    subroutine add_edge_curve(file, spline, number)
        type(step_file_type), intent(inout) :: file !! gets it
        type(bspline_type), intent(in) :: spline    !! in space
        integer, intent(out) :: number              !! of the instance
        real(dp) :: way(3)
        integer :: point, along, vector

        if (size(spline%weight) > 2) then
            call add_curve(file, spline, '', number)
            return
        end if
        way = spline%pole(:, 2) - spline%pole(:, 1)
        call add_point(file, spline%pole(:, 1), point)
        call add_direction(file, way/norm2(way), along)
        call file%add('VECTOR('''','//step_reference(along)//','//step_real(norm2(way))//')', &
            vector)
        call file%add('LINE('''','//step_reference(point)//','//step_reference(vector)//')', number)
    end subroutine add_edge_curve

    !> Adds a spline.
    subroutine add_curve(file, spline, name, number)
        type(step_file_type), intent(inout) :: file !! gets it
        type(bspline_type), intent(in) :: spline    !! in space
        character(*), intent(in) :: name            !! any bytes
        integer, intent(out) :: number              !! of the instance
        integer :: poles(size(spline%weight)), i
        character(:), allocatable :: form, knots

        do i = 1, size(poles)
            call add_point(file, spline%pole(:, i), poles(i))
        end do
        form = to_text(spline%degree)//','//step_references(poles)//',.UNSPECIFIED.,'// &
            step_logical(is_closed(spline))//',.F.'
        knots = knot_words(spline%knot)
        if (is_rational(spline)) then
            call file%add('(BOUNDED_CURVE()B_SPLINE_CURVE('//form// &
                ')B_SPLINE_CURVE_WITH_KNOTS('//knots// &
                ',.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE('// &
                step_list(spline%weight)//')REPRESENTATION_ITEM('//step_string(name)//'))', number)
        else
            call file%add(curve_word(spline)//'('//step_string(name)//','//form//','//knots// &
                ',.UNSPECIFIED.)', number)
        end if
    end subroutine add_curve

    !> True where a spline ends where it begins.
    pure logical function is_closed(spline)
        type(bspline_type), intent(in) :: spline !! in space
        is_closed = all(is_equal(spline%pole(:, 1), spline%pole(:, size(spline%weight))))
    end function is_closed

    !> What a spline is in STEP.
    pure function curve_word(spline) result(word)
        type(bspline_type), intent(in) :: spline !! any spline
        character(:), allocatable :: word
        word = 'B_SPLINE_CURVE_WITH_KNOTS'
        if (is_rational(spline)) word = 'RATIONAL_B_SPLINE_CURVE'
    end function curve_word

    !> Knots as STEP has them: how often each stands, and the different ones.
    pure function knot_words(knot) result(words)
        real(dp), intent(in) :: knot(:) !! not falling
        character(:), allocatable :: words
        real(dp), allocatable :: breaks(:)
        integer :: i

        allocate (breaks, source=breaks_of(knot))
        words = step_list([(count(is_equal(knot, breaks(i))), i=1, size(breaks))])//','// &
            step_list(breaks)
    end function knot_words

end module export_step_curve
