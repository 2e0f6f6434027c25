!> How finely panels are divided: a saddle, whose rulings are straight.
program test_mesh_grid
    use base_kinds, only: dp
    use body_panel, only: panel_type
    use export_mesh_grid, only: grid_cells, panel_place_normal
    use support_saddle, only: saddle
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(panel_type) :: panel
    real(dp) :: at(3), normal(3)
    integer :: fine(2), rough(2)

    panel = saddle()
    rough = grid_cells(panel, 1.0_dp, 90.0_dp)
    fine = grid_cells(panel, 1.0e-3_dp, 90.0_dp)
    call tap%ok(all(rough == 2), 'no fewer than two cells each way')
    ! Only diagonals bend: h k |Suv.n|/4 = 4/4/(cells) in a third of the tolerance.
    call tap%ok(real(product(fine), dp) >= 4.0_dp/4.0_dp/(1.0e-3_dp/3.0_dp) .and. &
        product(fine) < 4*3000, 'as many as the twist wants')
    fine = grid_cells(panel, 1.0_dp, 1.0_dp)
    call tap%ok(all(fine > 15), 'or the angle')
    call panel_place_normal(panel, [0.5_dp, 0.5_dp], at, normal)
    call tap%near(norm2(at - [5.0_dp, 5.0_dp, 1.0_dp]), 0.0_dp, 1.0e-14_dp, 'the middle')
    call tap%near(norm2(normal - [-0.2_dp, -0.2_dp, 1.0_dp]/sqrt(1.08_dp)), 0.0_dp, 1.0e-14_dp, &
        'its normal')
    call tap%finish()
end program test_mesh_grid
