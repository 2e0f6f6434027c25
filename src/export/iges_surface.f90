!> Surfaces of an IGES file: 128 rational B-spline surface (IGES 5.3, 4.24).
module export_iges_surface
    use base_exact, only: is_equal
    use export_iges_curve, only: name_with
    use export_iges_file, only: entry_type, iges_file_type
    use export_iges_record, only: record_type
    use geom_bspline_surface, only: bspline_surface_type
    implicit none (type, external)
    private

    public :: add_surface, turned_outward

contains

    !> Adds a surface: upper indices, degrees, whether closed along u and v, polynomial, periodic;
    !> knots, weights and poles with u running first, the ranges of u and v. Readers refuse a
    !> surface without its ranges.
    subroutine add_surface(file, entry, surface, name, pointer)
        type(iges_file_type), intent(inout) :: file         !! gets it
        type(entry_type), intent(in) :: entry               !! for the directory
        type(bspline_surface_type), intent(in) :: surface   !! in space
        integer, intent(in) :: name                         !! pointer to its name; 0: none
        integer, intent(out) :: pointer                     !! to the entity
        type(record_type) :: record
        integer :: poles(2), i, j

        poles = shape(surface%weight)
        call record%whole(128)
        call record%whole(poles(1) - 1)
        call record%whole(poles(2) - 1)
        call record%whole(surface%degree(1))
        call record%whole(surface%degree(2))
        associate (pole => surface%pole, weight => surface%weight)
            call record%whole(merge(1, 0, all(is_equal(pole(:, 1, :), pole(:, poles(1), :)))))
            call record%whole(merge(1, 0, all(is_equal(pole(:, :, 1), pole(:, :, poles(2))))))
            call record%whole(merge(1, 0, all(is_equal(weight, weight(1, 1)))))
        end associate
        call record%whole(0)
        call record%whole(0)
        call record%reals(surface%u_knot)
        call record%reals(surface%v_knot)
        do j = 1, poles(2)
            call record%reals(surface%weight(:, j))
        end do
        do j = 1, poles(2)
            do i = 1, poles(1)
                call record%reals(surface%pole(:, i, j))
            end do
        end do
        call record%reals([surface%u_knot(1), surface%u_knot(size(surface%u_knot)), &
            surface%v_knot(1), surface%v_knot(size(surface%v_knot))])
        call name_with(record, name)
        call file%add(128, entry, record, pointer)
    end subroutine add_surface

    !> The same surface with v running the other way, so that its normal points to the other side.
    pure type(bspline_surface_type) function turned_outward(surface) result(turned)
        type(bspline_surface_type), intent(in) :: surface !! whose normal points inward
        integer :: knots, poles

        turned = surface
        knots = size(surface%v_knot)
        poles = size(surface%weight, 2)
        associate (from => surface%v_knot(1), to => surface%v_knot(knots))
            turned%v_knot = from + (to - surface%v_knot(knots:1:-1))
            turned%v_knot(knots - surface%degree(2):) = to
        end associate
        turned%pole = surface%pole(:, :, poles:1:-1)
        turned%weight = surface%weight(:, poles:1:-1)
    end function turned_outward

end module export_iges_surface
