!> Tests of control lines as shapes.
program test_drawing_line
    use base_error, only: cause, error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_build, only: build_body
    use body_ledger, only: joint_type
    use body_line, only: line_type
    use cut_plane, only: cut_kind
    use deck_job, only: job_type
    use export_drawing, only: shape_kind, shape_type
    use export_drawing_line, only: draw_line
    use geom_bspline, only: spline_point
    use geom_chain, only: chain_type, chain_value
    use support_bodies, only: constant_view, control_line
    use support_book, only: text_file
    use support_computed, only: job_of_text
    use support_drawn, only: curve_count, is_end_to_end, largest_error
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults
    type(body_type) :: body
    type(joint_type), allocatable :: joints(:)
    type(shape_type) :: shape
    type(error_type), allocatable :: error
    type(line_type) :: line
    type(chain_type) :: none
    real(dp), parameter :: tolerances(3) = [1.0e-3_dp, 1.0e-5_dp, 1.0e-8_dp]
    integer :: i

    call job_of_text(text_file('cards/fuselage.crd'), job, faults)
    call build_body(job, 1, body, joints, faults)
    call draw_line(body%lines(1), 1, 1.0e-3_dp, shape, error)
    call tap%same(shape%name//'|'//shape%title, 'UCL|LINE UCL', 'a line has its name')
    call tap%ok(shape%kind == shape_kind%line .and. shape%number == 1 .and. .not. shape%is_half, &
        'it is a line, with its number')
    call tap%ok(shape%plane%kind == cut_kind%buttock .and. abs(shape%plane%through(2)) <= 0.0_dp, &
        'seen in side view')
    call tap%ok(size(shape%contours) == 1 .and. curve_count(shape, .true.) == 5, &
        'one contour of five exact arcs, as on its cards')
    do i = 1, size(tolerances)
        call draw_line(body%lines(2), 2, tolerances(i), shape, error)
        call tap%ok(.not. allocated(error), 'a line of two views is drawn')
        call tap%ok(largest_error(shape) <= tolerances(i) .and. largest_error(shape) > 0.0_dp, &
            'within the tolerance, its error measured')
        call tap%ok(off_line(body%lines(2)) <= 3.0_dp*tolerances(i), &
            'where the chains of its views are')
        call tap%ok(is_end_to_end(shape) .and. size(shape%contours) == 1, &
            'its curves meet in the same numbers')
    end do
    call draw_line(body%lines(4), 4, 1.0e-3_dp, shape, error)
    call tap%ok(.not. allocated(shape%contours), 'a line of angles has no curve')
    line = control_line('DATUM', constant_view(2.0_dp), none)
    call draw_line(line, 1, 1.0e-3_dp, shape, error)
    call tap%ok(.not. allocated(shape%contours), 'nor has a constant without an end')
    line = body%lines(2)
    call draw_line(line, 2, 1.0e-17_dp, shape, error)
    call tap%ok(allocated(error), 'a tolerance below rounding is refused')
    if (allocated(error)) call tap%ok(error%cause == cause%no_convergence, 'as what it is')
    call tap%finish()

contains

    !> How far points of the curves are from the chains, where these are not steep.
    real(dp) function off_line(from) result(off)
        type(line_type), intent(in) :: from
        real(dp) :: at(3)
        integer :: k, n
        off = 0.0_dp
        do k = 1, size(shape%contours(1)%curves)
            do n = 0, 100
                at = spline_point(shape%contours(1)%curves(k)%spline, real(n, dp)/100.0_dp)
                if (at(1) < 3.0_dp) cycle
                off = max(off, norm2(at(2:) - [chain_value(from%plan, at(1)), &
                    chain_value(from%side, at(1))]))
            end do
        end do
    end function off_line

end program test_drawing_line
