!> Sides trimmed where they meet, on a cylinder.
program test_build_sides
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_build_sides, only: trimmed_sides
    use body_panel_side, only: side_type
    use body_trace, only: trace_type, world_type
    use deck_job, only: job_type
    use support_pipe, only: pipe_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(side_type) :: side(4)
    type(error_type), allocatable :: error

    call trim_them('PATCH,P,10,SHO,30,MHB')
    call tap%ok(.not. allocated(error), 'arcs between a line and the end of the section')
    if (.not. allocated(error)) then
        call prove('1', 1, [10.0_dp, 10.0_dp, 0.0_dp], [10.0_dp, 6.0_dp, 8.0_dp])
        call prove('2', 2, [10.0_dp, 6.0_dp, 8.0_dp], [30.0_dp, 6.0_dp, 8.0_dp])
        call prove('3', 3, [30.0_dp, 6.0_dp, 8.0_dp], [30.0_dp, 10.0_dp, 0.0_dp])
        call prove('4', 4, [30.0_dp, 10.0_dp, 0.0_dp], [10.0_dp, 10.0_dp, 0.0_dp])
    end if
    call trim_them('PATCH,P,SHO,10,MHB,50')
    call tap%has(message(), 'side 4 (station 50.) meets no section', 'a station without arcs')
    call trim_them('LINE,FAR,SIDE,8|LINE,FAR,PLAN,6.5|PATCH,P,10,FAR,30,MHB')
    call tap%has(message(), 'side 1 (station 10.) and side 2 (line FAR) do not meet: the '// &
        'gap is 0.307764', 'a gap is told')
    call tap%finish()

contains

    !> Trims the sides of a patch on the cylinder.
    subroutine trim_them(cards)
        character(*), intent(in) :: cards !! behind those of the cylinder
        type(job_type) :: job
        type(fault_list_type) :: faults
        type(world_type) :: world
        call pipe_body(cards, job, world%body, faults)
        world%asked = job%body(1)
        allocate (world%traces(0))
        world%gap = 1.0e-3_dp
        call trimmed_sides(world%asked%patch(1), world, side, error)
    end subroutine trim_them

    !> What is said.
    function message() result(words)
        character(:), allocatable :: words
        words = ''
        if (allocated(error)) words = error%message
    end function message

    !> The ends of a side, and its middle on the cylinder.
    subroutine prove(name, number, first, last)
        character(*), intent(in) :: name    !! of the side
        integer, intent(in) :: number       !! 1 to 4
        real(dp), intent(in) :: first(3)    !! where it begins
        real(dp), intent(in) :: last(3)     !! where it ends
        real(dp) :: middle(3)
        call tap%near(max(norm2(side(number)%at(0.0_dp) - first), &
            norm2(side(number)%at(1.0_dp) - last)), 0.0_dp, 1.0e-13_dp, 'ends of side '//name)
        middle = side(number)%at(0.5_dp)
        call tap%near(norm2(middle(2:)), 10.0_dp, 1.0e-13_dp, 'middle of side '//name)
    end subroutine prove

end program test_build_sides
