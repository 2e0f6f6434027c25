!> Tests of tool paths. Oracle: G-code written by hand.
program test_nc_path
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_nc_path, only: path_type, put_path, run_type, segment_type, straight_path
    use support_tap, only: tap_type
    implicit none (type, external)
    character, parameter :: nl = new_line('a')
    type(run_type), parameter :: run = run_type(safe=0.25_dp, depth=-0.125_dp, feed=20.0_dp, &
        plunge=10.0_dp, tolerance=1.0e-3_dp, decimals=4)
    real(dp), parameter :: square(2, 4) = reshape([0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, &
        0.0_dp, 1.0_dp], [2, 4])
    type(tap_type) :: tap

    call check_open()
    call check_closed()
    call check_arcs()
    call tap%finish()

contains

    subroutine check_open()
        type(output_type) :: out
        call put_path(out, straight_path(square(:, :3), .false.), run)
        call tap%same(out%text(), 'G0 X0.0000 Y0.0000'//nl//'G1 Z-0.1250 F10.0'//nl// &
            'G1 X1.0000 Y0.0000 F20.0'//nl//'G1 X1.0000 Y1.0000'//nl//'G0 Z0.2500'//nl, &
            'an open path: to its start, down, along, up')
    end subroutine check_open

    subroutine check_closed()
        type(path_type) :: path
        path = straight_path(square, .true.)
        call tap%ok(size(path%segments) == 4, 'a closed square has four pieces')
        call tap%ok(all(abs(path%segments(4)%to - path%start) <= 0.0_dp), 'and ends where it began')
        path = straight_path(square, .false.)
        call tap%ok(size(path%segments) == 3, 'an open one three')
    end subroutine check_closed

    subroutine check_arcs()
        type(output_type) :: out
        type(path_type) :: path
        path%start = [1.0_dp, 0.0_dp]
        allocate (path%segments(2))
        path%segments(1) = segment_type(to=[0.0_dp, 1.0_dp], is_arc=.true., &
            centre=[0.0_dp, 0.0_dp])
        path%segments(2) = segment_type(to=[1.0_dp, 2.0_dp], is_arc=.true., is_clockwise=.true., &
            centre=[1.0_dp, 1.0_dp])
        call put_path(out, path, run)
        call tap%has(out%text(), nl//'G3 X0.0000 Y1.0000 I-1.0000 J0.0000 F20.0'//nl, &
            'an arc to the left is G3, its centre counted from its start')
        call tap%has(out%text(), nl//'G2 X1.0000 Y2.0000 I1.0000 J0.0000'//nl, &
            'one to the right is G2')
    end subroutine check_arcs

end program test_nc_path
