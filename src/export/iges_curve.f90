!> Points and curves of an IGES file: 116 point, 110 line, 126 rational B-spline curve (IGES 5.3,
!> 4.13, 4.18, 4.23).
module export_iges_curve
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use export_iges_file, only: entry_type, iges_file_type
    use export_iges_record, only: record_type
    use geom_bspline, only: bspline_type, is_rational, spline_from, spline_to
    implicit none (type, external)
    private

    public :: add_point, add_line, add_spline, name_with

    !> No normal: the curve is not said to be in a plane.
    real(dp), parameter, public :: no_normal(3) = 0.0_dp

contains

    !> Adds a point.
    subroutine add_point(file, entry, at, name, pointer)
        type(iges_file_type), intent(inout) :: file     !! gets it
        type(entry_type), intent(in) :: entry           !! for the directory
        real(dp), intent(in) :: at(3)                   !! STA, BL, WL
        integer, intent(in) :: name                     !! pointer to its name; 0: none
        integer, intent(out) :: pointer                 !! to the entity
        type(record_type) :: record

        call record%whole(116)
        call record%reals(at)
        call record%whole(0)
        call name_with(record, name)
        call file%add(116, entry, record, pointer)
    end subroutine add_point

    !> Adds a straight line.
    subroutine add_line(file, entry, ends, name, pointer)
        type(iges_file_type), intent(inout) :: file     !! gets it
        type(entry_type), intent(in) :: entry           !! for the directory
        real(dp), intent(in) :: ends(3, 2)              !! STA, BL, WL of each
        integer, intent(in) :: name                     !! pointer to its name; 0: none
        integer, intent(out) :: pointer                 !! to the entity
        type(record_type) :: record

        call record%whole(110)
        call record%reals(ends(:, 1))
        call record%reals(ends(:, 2))
        call name_with(record, name)
        call file%add(110, entry, record, pointer)
    end subroutine add_line

    !> Adds a B-spline: upper index, degree, whether in a plane, closed, polynomial, periodic;
    !> knots, weights, poles, where it begins and ends, and the normal of its plane.
    subroutine add_spline(file, entry, spline, normal, name, pointer)
        type(iges_file_type), intent(inout) :: file     !! gets it
        type(entry_type), intent(in) :: entry           !! for the directory
        type(bspline_type), intent(in) :: spline        !! in space
        real(dp), intent(in) :: normal(3)               !! of its plane, unit vector; or `no_normal`
        integer, intent(in) :: name                     !! pointer to its name; 0: none
        integer, intent(out) :: pointer                 !! to the entity
        type(record_type) :: record
        integer :: poles, i

        poles = size(spline%weight)
        call record%whole(126)
        call record%whole(poles - 1)
        call record%whole(spline%degree)
        call record%whole(merge(1, 0, norm2(normal) > 0.0_dp))
        call record%whole(merge(1, 0, all(is_equal(spline%pole(:, 1), spline%pole(:, poles)))))
        call record%whole(merge(0, 1, is_rational(spline)))
        call record%whole(0)
        call record%reals(spline%knot)
        call record%reals(spline%weight)
        do i = 1, poles
            call record%reals(spline%pole(:, i))
        end do
        call record%reals([spline_from(spline), spline_to(spline)])
        call record%reals(normal)
        call name_with(record, name)
        call file%add(126, entry, record, pointer)
    end subroutine add_spline

    !> Ends a record with its name: no associativities, one property (2.2.4.5.2).
    subroutine name_with(record, name)
        type(record_type), intent(inout) :: record      !! all parameters of an entity
        integer, intent(in) :: name                     !! pointer to its name; 0: none
        if (name == 0) return
        call record%whole(0)
        call record%whole(1)
        call record%whole(name)
    end subroutine name_with

end module export_iges_curve
