!> Cuts as CSV: the header of the contract, absent values as empty fields.
program test_cut_csv
    use base_kinds, only: dp
    use base_output, only: output_type
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, station_plane
    use geom_arc_point, only: slope_type
    use report_cut_csv, only: print_cut_csv, print_cut_csv_header
    use support_tap, only: tap_type
    implicit none (type, external)

    character, parameter :: feed = new_line('a')
    type(tap_type) :: tap
    type(output_type) :: header, rows, other
    type(cut_type) :: cut

    call print_cut_csv_header(header)
    call tap%same(header%text(), 'cut,kind,section,sta,bl,wl,slope,curvature,bevel'//feed, &
        'the header is the contract''s')

    cut%plane = station_plane(20.0_dp)
    allocate (cut%outlines(1))
    allocate (cut%outlines(1)%points(3))
    associate (point => cut%outlines(1)%points)
        point%section = [1, 1, 2]
        point(1)%at = [20.0_dp, 0.0_dp, -0.1_dp]
        point(2)%at = [20.0_dp, 0.5_dp, 1.0_dp]
        point(2)%has_slope = .true.
        point(2)%slope = slope_type(0.0_dp, .true.)
        point(2)%has_curvature = .true.
        point(2)%curvature = -0.25_dp
        point(2)%has_normal = .true.
        point(2)%bevel = 1.5_dp
        point(3)%at = [20.0_dp, 1.0_dp, 2.0_dp]
        point(3)%has_slope = .true.
        point(3)%slope = slope_type(2.0_dp, .false.)
    end associate
    call print_cut_csv(4, cut, [character(8) :: 'LOWER', 'UPPER'], rows)
    call tap%same(rows%text(), '4,station,LOWER,20,0,-0.1,,,'//feed// &
        '4,station,LOWER,20,0.5,1,inf,-0.25,1.5'//feed// &
        '4,station,UPPER,20,1,2,2,,'//feed, &
        'a row a point; what does not exist is an empty field')
    cut%plane = buttock_plane(4.5_dp)
    call print_cut_csv(5, cut, [character(8) :: 'LOWER', 'UPPER'], other)
    call tap%ok(index(other%text(), '5,buttock,LOWER,') == 1, 'the kind is named')
    call tap%finish()

end program test_cut_csv
