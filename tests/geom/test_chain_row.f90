!> A chain at a row of abscissas, across a joint, at its ends and at a vertical tangent, figure for
!> figure what it is at one after another.
program test_chain_row
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use geom_chain, only: chain_jet, chain_type, constant_chain, new_chain
    use geom_chain_row, only: jet_row_type, row_jets
    use geom_jet, only: jet_type
    use geom_twofold_short, only: width
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(chain_type) :: chain
    type(arc_type) :: arc
    type(jet_row_type) :: jets
    type(jet_type) :: jet
    type(error_type), allocatable :: error
    real(dp) :: x(width)
    logical :: is_vertical(width), is_upright
    integer :: i, wrong(4)

    call arc_through(end_type([0.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), [2.0_dp, 4.0_dp], &
        end_type([5.0_dp, 5.0_dp], [1.0_dp, 0.0_dp]), arc, error)
    call new_chain([arc, line_between([5.0_dp, 5.0_dp], [8.0_dp, 5.0_dp])], chain, error)
    x = [(8.0_dp*real(i - 1, dp)/real(width - 1, dp), i=1, width)]
    x(10) = 5.0_dp
    call row_jets(chain, x, .true., jets, is_vertical)
    wrong = 0
    do i = 1, width
        call chain_jet(chain, x(i), jet, is_upright)
        if (jets%value(i) /= jet%value) wrong(1) = wrong(1) + 1
        if (jets%first(i) /= jet%first) wrong(2) = wrong(2) + 1
        if (abs(jets%second(i) - jet%second) > 1.0e-14_dp*abs(jet%second)) wrong(3) = wrong(3) + 1
        if (is_vertical(i) .neqv. is_upright) wrong(4) = wrong(4) + 1
    end do
    call tap%ok(wrong(1) == 0, 'ordinates are those of one after another')
    call tap%ok(wrong(2) == 0, 'slopes, too')
    call tap%ok(wrong(3) == 0, 'second derivatives, but for rounding')
    call tap%ok(wrong(4) == 0 .and. is_vertical(1), 'the vertical tangent is known')
    call tap%near(maxval(abs(jets%value - sqrt(merge(10.0_dp*x - x**2, 25.0_dp, x < 5.0_dp)))), &
        0.0_dp, 1.0e-15_dp, 'a quarter circle and a line')
    call constant_chain(3.0_dp, chain)
    call row_jets(chain, x, .true., jets, is_vertical)
    call tap%ok(all(jets%value == 3.0_dp) .and. all(jets%first == 0.0_dp), 'a constant')
    call tap%finish()
end program test_chain_row
