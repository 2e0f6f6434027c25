!> Conic arcs of an IGES file: 104, always in standard position, with the form number that says what
!> it is, and the transformation matrix 124 that puts it where it belongs (IGES 5.3, 4.5, 4.21).
!>
!> Readers find out what a conic is from its coefficients, and take parabolas in any other position
!> for flat ellipses or hyperbolas; so the coefficients that are zero must be zero. They work with
!> centre and axes; an arc of which these are far away would suffer from their rounding, and is
!> better a B-spline.
module export_iges_conic
    use base_kinds, only: dp
    use base_tolerances, only: agreement_ulps, ulp
    use cut_plane, only: in_space, plane_type, true_shape
    use export_drawing, only: curve_type
    use export_iges_curve, only: name_with
    use export_iges_file, only: entry_type, iges_file_type, iges_status
    use export_iges_record, only: record_type
    use geom_bspline, only: spline_from, spline_point, spline_to
    use geom_conic, only: conic_kind
    use geom_conic_axes, only: axes_of, axes_type, coefficients_of, distance_from_axes, reach_of, &
        to_axes
    implicit none (type, external)
    private

    public :: add_conic, suits_conic, conic_error

    !> How far axes and centre of a conic may reach, in parts of the chord: readers lose three
    !> figures at most.
    real(dp), parameter :: longest_reach = 1000.0_dp
    !> Points of a curve at which it is compared with its conic.
    integer, parameter :: compared = 32

contains

    !> True for a curve that can be a conic of the file: its spline is on it within rounding.
    pure logical function suits_conic(curve, plane) result(suits)
        type(curve_type), intent(in) :: curve   !! of a shape
        type(plane_type), intent(in) :: plane   !! of the shape
        type(axes_type) :: axes

        suits = .false.
        if (.not. curve%is_conic) return
        axes = axes_of(curve%arc)
        if (axes%kind == conic_kind%line) return
        if (reach_of(axes, curve%arc) > longest_reach) return
        suits = conic_error(curve, plane) <= agreement_ulps*ulp*maxval(abs(curve%spline%pole))
    end function suits_conic

    !> The largest distance of the spline of a curve from its conic in standard position.
    pure real(dp) function conic_error(curve, plane) result(error)
        type(curve_type), intent(in) :: curve   !! a curved conic arc
        type(plane_type), intent(in) :: plane   !! of its shape
        type(axes_type) :: axes
        real(dp) :: t
        integer :: i

        axes = axes_of(curve%arc)
        error = 0.0_dp
        associate (from => spline_from(curve%spline), to => spline_to(curve%spline))
            do i = 0, compared
                t = from + real(i, dp)/real(compared, dp)*(to - from)
                error = max(error, distance_from_axes(axes, &
                    true_shape(plane, spline_point(curve%spline, t))))
            end do
        end associate
    end function conic_error

    !> Adds a conic arc: its equation, the height of its plane, where it begins and ends.
    subroutine add_conic(file, entry, curve, plane, name, pointer)
        type(iges_file_type), intent(inout) :: file     !! gets it
        type(entry_type), intent(in) :: entry           !! for the directory
        type(curve_type), intent(in) :: curve           !! which suits
        type(plane_type), intent(in) :: plane           !! of its shape
        integer, intent(in) :: name                     !! pointer to its name; 0: none
        integer, intent(out) :: pointer                 !! to the entity
        type(entry_type) :: conic
        type(record_type) :: record
        type(axes_type) :: axes

        axes = axes_of(curve%arc)
        conic = entry
        conic%form = form_of(axes%kind)
        call add_matrix(file, axes, plane, conic%matrix)
        call record%whole(104)
        call record%reals(coefficients_of(axes))
        call record%reals([0.0_dp])
        call record%reals(to_axes(axes, curve%arc%start))
        call record%reals(to_axes(axes, curve%arc%finish))
        call name_with(record, name)
        call file%add(104, conic, record, pointer)
    end subroutine add_conic

    !> The form number of a kind of conic.
    pure integer function form_of(kind) result(form)
        integer, intent(in) :: kind !! one of `conic_kind%...`, not a line
        form = 1
        if (kind == conic_kind%hyperbola) form = 2
        if (kind == conic_kind%parabola) form = 3
    end function form_of

    !> Adds the matrix that brings a conic from its standard position to its place: a rotation, and
    !> where the origin goes.
    subroutine add_matrix(file, axes, plane, pointer)
        type(iges_file_type), intent(inout) :: file     !! gets it
        type(axes_type), intent(in) :: axes             !! in the plane
        type(plane_type), intent(in) :: plane           !! of the shape
        integer, intent(out) :: pointer                 !! to the entity
        type(record_type) :: record
        real(dp) :: origin(3), x(3), y(3), z(3)
        integer :: i

        origin = in_space(plane, axes%origin)
        x = axes%x(1)*plane%u + axes%x(2)*plane%v
        y = axes%y(1)*plane%u + axes%y(2)*plane%v
        z = [x(2)*y(3) - x(3)*y(2), x(3)*y(1) - x(1)*y(3), x(1)*y(2) - x(2)*y(1)]
        call record%whole(124)
        do i = 1, 3
            call record%reals([x(i), y(i), z(i), origin(i)])
        end do
        call file%add(124, entry_type(status=iges_status%part), record, pointer)
    end subroutine add_matrix

end module export_iges_conic
