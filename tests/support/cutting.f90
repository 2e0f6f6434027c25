!> Cuts for the tests: a request in one line, and how far the points of a cut are from what an
!> ellipsoid says of them.
module support_cutting
    use base_decimal, only: decimal_type, new_grid
    use base_error, only: error_type
    use base_kinds, only: dp, i64
    use body_body, only: body_type
    use cut_make, only: make_cut
    use cut_outline, only: cut_point_type, cut_type
    use cut_plane, only: height_over, plane_through, plane_type
    use cut_request, only: cut_rule, request_type
    implicit none (type, external)
    private

    public :: cut_of, by_number, by_step, plane_of, misses_type, misses_of

    !> Largest misses of the points of a cut from an ellipsoid.
    type :: misses_type
        real(dp) :: surface = 0.0_dp    !! distance from the surface
        real(dp) :: plane = 0.0_dp      !! distance from the plane
        real(dp) :: normal = 0.0_dp     !! length of the difference of the unit normals
        real(dp) :: bevel = 0.0_dp      !! degrees
        real(dp) :: slope = 0.0_dp      !! angle between the tangents, radians
        real(dp) :: curvature = 0.0_dp  !! relative
        integer :: points = 0           !! how many points
        integer :: bare = 0             !! of these, without normal, slope or curvature
    end type misses_type

contains

    !> A cut by number of points.
    function by_number(plane, number) result(request)
        type(plane_type), intent(in) :: plane
        integer, intent(in) :: number
        type(request_type) :: request
        request%plane = plane
        request%rule = cut_rule%number
        request%number = number
    end function by_number

    !> A cut by steps of an axis from zero on, the step in thousandths.
    function by_step(plane, axis, thousandths) result(request)
        type(plane_type), intent(in) :: plane
        integer, intent(in) :: axis, thousandths
        type(request_type) :: request
        type(error_type), allocatable :: error
        request%plane = plane
        request%rule = cut_rule%step
        request%axis = axis
        call new_grid(decimal_type(0_i64, 0), decimal_type(int(thousandths, i64), -3), &
            request%grid, error)
        if (allocated(error)) error stop 'a grid of a test is none'
    end function by_step

    !> The plane through a point across a normal.
    function plane_of(point, normal) result(plane)
        real(dp), intent(in) :: point(3), normal(3)
        type(plane_type) :: plane
        type(error_type), allocatable :: error
        call plane_through(point, normal, plane, error)
        if (allocated(error)) error stop 'a plane of a test is none'
    end function plane_of

    !> A cut that must succeed.
    function cut_of(body, request) result(cut)
        type(body_type), intent(in) :: body
        type(request_type), intent(in) :: request
        type(cut_type) :: cut
        type(error_type), allocatable :: error
        call make_cut(body, request, cut, error)
        if (allocated(error)) error stop 'a cut of a test failed: '//error%message
    end function cut_of

    !> How far a cut is from the ellipsoid about a centre with semi-axes; the flange is aft.
    function misses_of(cut, axes, centre) result(worst)
        type(cut_type), intent(in) :: cut
        real(dp), intent(in) :: axes(3), centre(3)
        type(misses_type) :: worst
        integer :: i, k
        do i = 1, size(cut%outlines)
            do k = 1, size(cut%outlines(i)%points)
                worst%points = worst%points + 1
                call judge(cut, cut%outlines(i)%points(k), axes, centre, worst)
            end do
        end do
    end function misses_of

    !> Adds one point: f = (x/a)**2 + (y/b)**2 + (z/c)**2 - 1, its gradient and its Hessian.
    subroutine judge(cut, point, axes, centre, worst)
        type(cut_type), intent(in) :: cut
        type(cut_point_type), intent(in) :: point
        real(dp), intent(in) :: axes(3), centre(3)
        type(misses_type), intent(inout) :: worst
        real(dp) :: p(3), g(3), n(3), f(3), way(3), kappa, tangent(2)

        p = point%at - centre
        g = 2.0_dp*p/axes**2
        n = g/norm2(g)
        f = cut%plane%normal/norm2(cut%plane%normal)
        worst%surface = max(worst%surface, abs(sum((p/axes)**2) - 1.0_dp)/norm2(g))
        worst%plane = max(worst%plane, abs(height_over(cut%plane, point%at)))
        if (.not. (point%has_normal .and. point%has_slope .and. point%has_curvature)) then
            worst%bare = worst%bare + 1
            return
        end if
        worst%normal = max(worst%normal, norm2(n - point%normal))
        way = cshift(n, 1)*cshift(f, 2) - cshift(n, 2)*cshift(f, 1)
        way = way/norm2(way)
        kappa = 2.0_dp*sum((way/axes)**2)/norm2(g - dot_product(g, f)*f)
        worst%curvature = max(worst%curvature, abs(abs(point%curvature)/kappa - 1.0_dp))
        tangent = [1.0_dp, point%slope%value]
        if (point%slope%is_vertical) tangent = [0.0_dp, 1.0_dp]
        worst%slope = max(worst%slope, abs(dot_product(way, cut%plane%u)*tangent(2) &
            - dot_product(way, cut%plane%v)*tangent(1))/norm2(tangent))
        if (f(findloc(abs(f) > 0.0_dp, .true., dim=1)) < 0.0_dp) f = -f
        worst%bevel = max(worst%bevel, &
            abs(sin(point%bevel*acos(-1.0_dp)/180.0_dp) + dot_product(n, f)))
    end subroutine judge

end module support_cutting
