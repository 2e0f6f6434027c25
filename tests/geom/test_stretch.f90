!> An arc divided at its extremes, and the steps counted on each stretch.
program test_stretch
    use base_decimal, only: decimal_type, grid_type, new_grid
    use base_error, only: cause, error_type
    use base_kinds, only: dp, i64
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_stretch, only: divide, stretch_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc
    type(grid_type) :: grid
    type(stretch_type), allocatable :: stretch(:)
    type(error_type), allocatable :: error

    ! Three quarters of the unit circle, from (1, 0) over (-1, 0) to (0, -1).
    call arc_through(end_type([1.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), [-1.0_dp, 0.0_dp], &
        end_type([0.0_dp, -1.0_dp], [1.0_dp, 0.0_dp]), arc, error)
    call new_grid(decimal_type(10_i64, -1), decimal_type(-3_i64, -1), grid, error)
    call divide(arc, 1, grid, stretch, error)
    call tap%ok(size(stretch) == 2, 'X turns back once')
    call tap%ok(.not. stretch(1)%rising .and. stretch(2)%rising, 'and goes down before up')
    call tap%ok(stretch(1)%count == 6 .and. stretch(2)%count == 3, 'steps strictly inside')
    call tap%ok(.not. any(stretch%touches), 'none meets the extreme')
    call new_grid(decimal_type(10_i64, -1), decimal_type(-5_i64, -1), grid, error)
    call divide(arc, 1, grid, stretch, error)
    call tap%ok(stretch(1)%touches .and. stretch(1)%touched == 4, 'the fourth half does')
    call new_grid(decimal_type(1_i64, 0), decimal_type(1_i64, -9), grid, error)
    call divide(arc, 1, grid, stretch, error)
    call tap%ok(allocated(error), 'too many rows fail')
    if (allocated(error)) call tap%ok(error%cause == cause%too_many, 'and say so')
    call tap%finish()

end program test_stretch
