!> Ordinates of an arc at a row of abscissas: a parabola and a hyperbola in closed form.
program test_ordinate_row
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use geom_arc_row, only: place_of_row, place_row_type
    use geom_crossing, only: crossing
    use geom_ordinate_row, only: row_ordinates
    use geom_place, only: place_type
    use geom_twofold_short, only: width
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc
    type(place_row_type) :: place
    type(place_type) :: one
    type(error_type), allocatable :: error
    real(dp) :: x(width), y(width), along(width, 2)
    integer :: i

    x = [(2.0_dp*real(i, dp)/real(width + 1, dp), i=1, width)]
    call arc_through(end_type([0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp]), [1.0_dp, 1.0_dp], &
        end_type([2.0_dp, 4.0_dp], [1.0_dp, 4.0_dp]), arc, error)
    call row_ordinates(arc, x, y, along, place)
    call tap%near(maxval(abs(y - x**2)), 0.0_dp, 1.0e-15_dp, 'y = x**2')
    call tap%near(maxval(abs(along(:, 2)/along(:, 1) - 2.0_dp*x)), 0.0_dp, 2.0e-15_dp, &
        'with its slope')
    one = crossing(arc, 1, x(7), rising=.true.)
    associate (other => place_of_row(place, 7))
        call tap%near(other%beta%high/other%alpha%high, one%beta%high/one%alpha%high, &
            1.0e-15_dp, 'at the same place')
    end associate
    call arc_through(end_type([1.0_dp, 2.0_dp], [1.0_dp, -2.0_dp]), [2.0_dp, 1.0_dp], &
        end_type([4.0_dp, 0.5_dp], [1.0_dp, -0.125_dp]), arc, error)
    x = 1.0_dp + 1.49_dp*x
    call row_ordinates(arc, x, y, along, place)
    call tap%near(maxval(abs(y - 2.0_dp/x)), 0.0_dp, 1.0e-15_dp, 'y = 2/x')
    call tap%near(maxval(abs(along(:, 2)/along(:, 1) + 2.0_dp/x**2)), 0.0_dp, 2.0e-15_dp, &
        'with its slope')
    arc = line_between([1.0_dp, 0.0_dp], [5.0_dp, 8.0_dp])
    call row_ordinates(arc, x, y, along, place)
    call tap%near(maxval(abs(y - 2.0_dp*(x - 1.0_dp))), 0.0_dp, 1.0e-15_dp, 'a line')
    call tap%finish()
end program test_ordinate_row
