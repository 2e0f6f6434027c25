!> Tables as CSV: the header of the contract, full precision, no decoration.
program test_csv
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use body_card_tables, only: card_table_type
    use geom_arc_point, only: slope_type
    use report_csv, only: print_csv_header, print_csv_table
    use support_tap, only: tap_type
    implicit none (type, external)

    character, parameter :: feed = new_line('a')
    type(tap_type) :: tap
    type(card_table_type) :: table
    type(output_type) :: header, x_rows, y_rows

    call print_csv_header(header)
    call tap%same(header%text(), 'card,axis,x,y,slope,curvature'//feed, &
        'the header is the contract''s')

    allocate (table%row(2))
    table%row(1)%x = -30.0e0_dp
    table%row(1)%y = 0.1e0_dp
    table%row(1)%slope = slope_type(0.0e0_dp, .true.)
    table%row(1)%curvature = -0.0e0_dp
    table%row(2)%x = 1.0e0_dp/3.0e0_dp
    table%row(2)%y = 1.0e22_dp
    table%row(2)%slope = slope_type(-2.5e-7_dp, .false.)
    table%row(2)%curvature = 1.0e0_dp
    call print_csv_table(table, 3_i64, x_rows)
    call tap%same(x_rows%text(), '3,X,-30,0.1,inf,0'//feed// &
        '3,X,0.3333333333333333,1e+22,-2.5e-07,1'//feed, &
        'the fewest figures that read back; a vertical slope is inf; no minus before zero')
    table%axis = 2
    call print_csv_table(table, 12_i64, y_rows)
    call tap%ok(index(y_rows%text(), '12,Y,-30,') == 1, 'a table by steps of Y says so')
    call tap%finish()

end program test_csv
