!> The curves that sides may be parts of, on a cylinder.
program test_side_curves
    use base_error, only: cause, error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_panel_side, only: side_type
    use body_side_curves, only: list_curves, side_words
    use body_trace, only: world_type
    use deck_job, only: job_type
    use support_pipe, only: pipe_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults
    type(world_type) :: world
    type(side_type), allocatable :: curve(:)
    type(error_type), allocatable :: error

    call pipe_body('LINE,LEVEL,SIDE,4.|PATCH,P,10,LEVEL,50,MHB,,3.,44.', job, world%body, faults)
    world%asked = job%body(1)
    allocate (world%traces(0))
    call list(1)
    call tap%ok(size(curve) == 1, 'a station has the arc of the section')
    call list(2)
    call tap%ok(size(curve) == 1, 'a line is one curve')
    if (size(curve) == 1) call tap%ok(norm2(curve(1)%at(0.0_dp) - [3.0_dp, 0.0_dp, 4.0_dp]) + &
        norm2(curve(1)%at(1.0_dp) - [44.0_dp, 0.0_dp, 4.0_dp]) <= 0.0_dp, &
        'an endless one ends with FROM and TO')
    call list(3)
    call tap%ok(allocated(error), 'a station beyond the body has none')
    if (allocated(error)) call tap%ok(error%cause == cause%beyond_lines, 'which is an error')
    call tap%same(trim(side_words(world%asked%patch(1), world, 2)), &
        'side 2 (line LEVEL)', 'its words')
    world%asked%patch(1)%range%has_from = .false.
    world%asked%patch(1)%range%has_to = .false.
    call list(2)
    if (size(curve) == 1) call tap%ok(norm2(curve(1)%at(0.0_dp) - [0.0_dp, 0.0_dp, 4.0_dp]) + &
        norm2(curve(1)%at(1.0_dp) - [50.0_dp, 0.0_dp, 4.0_dp]) <= 0.0_dp, &
        'else where other lines and the stations of the patch do')
    call tap%finish()

contains

    !> Lists the curves of a side.
    subroutine list(number)
        integer, intent(in) :: number !! which side
        call list_curves(world%asked%patch(1), number, world, curve, error)
    end subroutine list

end program test_side_curves
