!> The slopes across a side of a panel that keep it tangent to what lies beside: the ribbon.
!>
!> Between the corners the slope goes as on any other side, by Hermite's functions from the tangents
!> of the sides that begin there and the twists; then its part along the normal n of the neighbour
!> is taken away, R = R0 - (R0.n) n. In a corner R0 is a tangent of the next side: this must lie in
!> the tangent plane there, or nothing is tangent to both. What little it is beside it stays there
!> and fades to the middle, so that the panel keeps its sides.
module body_ribbon
    use base_constants, only: degrees
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use base_tolerances, only: panel_tolerance, tangency_tolerance
    use body_beside, only: beside_type, normal_beside
    use geom_bspline, only: bspline_type, spline_jet
    use geom_coons_blend, only: blend, blend_jet
    use geom_coons_spline, only: corner_of, spline_frame_type
    use geom_curve_fit, only: curve_function_type, fit_curve
    use geom_vector, only: image
    implicit none (type, external)
    private

    public :: add_ribbon

    !> A ribbon before it is a spline.
    type, extends(curve_function_type) :: ribbon_type
        type(beside_type) :: beside                 !! what it is tangent to
        type(bspline_type) :: side                  !! along growing u or v
        logical :: is_turned = .false.              !! the side of the card runs the other way
        real(dp) :: slope(3, 0:1) = 0.0_dp          !! across it in its corners
        real(dp) :: twist(3, 0:1) = 0.0_dp          !! there
        real(dp) :: rest(3, 0:1) = 0.0_dp           !! what slopes are beside the tangent plane
    contains
        procedure :: at => ribbon_at
    end type ribbon_type

    !> Where the skin bends suddenly a ribbon is fitted less closely: tolerances one after another.
    real(dp), parameter :: looser(3) = [1.0_dp, 1.0e3_dp, 2.0e4_dp]

contains

    !> Gives a side of a frame its ribbon. Fails with `cause%joint_gap` where a side beside it
    !> leaves the tangent plane in the corner, and with `cause%no_convergence` where the skin has an
    !> edge across the side.
    pure subroutine add_ribbon(number, beside, frame, error)
        integer, intent(in) :: number                       !! which side
        type(beside_type), intent(in) :: beside             !! what lies beside it
        type(spline_frame_type), intent(inout) :: frame     !! gets the ribbon
        type(error_type), allocatable, intent(out) :: error !! see above
        type(ribbon_type) :: ribbon
        real(dp) :: largest, place, scale
        integer :: end, i, uv(2)

        ribbon%beside = beside
        ribbon%side = frame%side(number)
        ribbon%is_turned = number > 2
        do end = 0, 1
            uv = corner_of(number, end)
            ribbon%slope(:, end) = frame%slope_u(:, uv(1), uv(2))
            if (mod(number, 2) == 1) ribbon%slope(:, end) = frame%slope_v(:, uv(1), uv(2))
            ribbon%twist(:, end) = frame%twist(:, uv(1), uv(2))
            call check_corner(ribbon, number, end, error)
            if (allocated(error)) return
        end do
        scale = max(norm2(ribbon%slope(:, 0)), norm2(ribbon%slope(:, 1)), tiny(scale))
        do i = 1, size(looser)
            call fit_curve(ribbon, looser(i)*panel_tolerance*scale, frame%ribbon(number), largest, &
                place, error)
            if (.not. allocated(error)) return
        end do
        error%message = 'TANGENT'//to_text(number)//': the skin beside side '//to_text(number)// &
            ' has an edge across it'
    end subroutine add_ribbon

    !> Looks whether the side that begins in a corner does so in the tangent plane.
    pure subroutine check_corner(ribbon, number, end, error)
        type(ribbon_type), intent(inout) :: ribbon          !! with its slopes; gets the rest
        integer, intent(in) :: number                       !! of its side
        integer, intent(in) :: end                          !! 0 where it begins, 1 where it ends
        type(error_type), allocatable, intent(out) :: error !! see `add_ribbon`
        real(dp) :: normal(3), angle
        integer :: other

        associate (slope => ribbon%slope(:, end))
            if (all(is_zero(slope))) return
            normal = normal_at(ribbon, real(end, dp))
            ribbon%rest(:, end) = dot_product(normal, slope)*normal
            angle = degrees*asin(min(abs(dot_product(normal, slope))/norm2(slope), 1.0_dp))
        end associate
        if (angle <= tangency_tolerance) return
        other = merge(2, 4, end == 1)
        if (mod(number, 2) == 0) other = merge(3, 1, end == 1)
        call fail(error, cause%joint_gap, 'TANGENT'//to_text(number)//': side '//to_text(other)// &
            ' begins at an angle of '//compact(angle)// &
            ' degrees to the skin beside side '//to_text(number)//'; only what is tangent to it'// &
            ' there (within '//compact(tangency_tolerance)//') lets the patch be so')
    end subroutine check_corner

    !> The normal beside a place of the side.
    pure function normal_at(ribbon, t) result(normal)
        type(ribbon_type), intent(in) :: ribbon !! any
        real(dp), intent(in) :: t               !! 0 to 1, along growing u or v
        real(dp) :: normal(3), at(3), way(3), second(3)

        call spline_jet(ribbon%side, t, at, way, second)
        normal = normal_beside(ribbon%beside, at, way, merge(1.0_dp - t, t, ribbon%is_turned))
    end function normal_at

    !> The slope across the side.
    pure function ribbon_at(f, t) result(point)
        class(ribbon_type), intent(in) :: f     !! the ribbon
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp) :: point(3), along(0:2, 0:2, 0:1), normal(3)

        along = blend_jet(blend%slopes, t)
        point = image(f%slope, along(0, 0, :)) + image(f%twist, along(0, 1, :))
        normal = normal_at(f, t)
        point = point - dot_product(point, normal)*normal + image(f%rest, along(0, 0, :))
    end function ribbon_at

end module body_ribbon
