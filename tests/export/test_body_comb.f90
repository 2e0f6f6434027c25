!> Tests of curvature combs: of a circle all teeth are equal, of an ellipse the curvature is known.
program test_body_comb
    use base_error, only: error_type
    use base_kinds, only: dp
    use export_body_comb, only: comb_type, new_comb
    use geom_arc, only: arc_through, arc_type, line_between
    use geom_triangle, only: end_type
    use geom_chain, only: chain_type, new_chain
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(comb_type) :: comb
    real(dp) :: lengths(2)

    comb = new_comb(ellipse(10.0_dp, 10.0_dp), 4.0_dp, 1.0_dp)
    lengths = [norm2(comb%tooth(1)%at(:, 2) - comb%tooth(1)%at(:, 1)), &
        norm2(comb%tooth(size(comb%tooth))%at(:, 2) - comb%tooth(size(comb%tooth))%at(:, 1))]
    call tap%near(comb%greatest, -0.1_dp, 1.0e-14_dp, 'a circle of 10 has the curvature -.1 above')
    call tap%near(comb%factor, 20.0_dp, 1.0e-12_dp, 'the factor is round, the teeth not too long')
    call tap%ok(all(abs(lengths - 2.0_dp) < 1.0e-12_dp), 'its teeth are all equal')
    call tap%ok(norm2(comb%tooth(3)%at(:, 2)) > 11.9_dp, 'and on the outside of the bend')
    call tap%ok(.not. comb%is_cut_off, 'none is cut off')
    call tap%ok(size(comb%tooth) >= 16, 'they stand about as close as asked')
    comb = new_comb(ellipse(50.0_dp, 5.0_dp), 4.0_dp, 1.0_dp)
    call tap%near(abs(comb%greatest), 2.0_dp, 1.0e-12_dp, 'the end of an ellipse: a/b**2')
    call tap%near(comb%greatest_at, -50.0_dp, 1.0e-12_dp, 'is its foremost point')
    call tap%ok(comb%is_cut_off, 'whose teeth are cut off')
    comb = new_comb(straight(), 4.0_dp, 1.0_dp)
    call tap%ok(size(comb%tooth) == 0 .and. .not. comb%factor > 0.0_dp, &
        'a straight line has no comb')
    call tap%finish()

contains

    !> The upper forward quarter of an ellipse about the origin.
    type(chain_type) function ellipse(a, b) result(chain)
        real(dp), intent(in) :: a, b
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        call arc_through(end_type([-a, 0.0_dp], [0.0_dp, 1.0_dp]), [-0.6_dp*a, 0.8_dp*b], &
            end_type([0.0_dp, b], [1.0_dp, 0.0_dp]), arc, error)
        if (allocated(error)) error stop 'no arc'
        call new_chain([arc], chain, error)
        if (allocated(error)) error stop 'no chain'
    end function ellipse

    !> A straight line.
    type(chain_type) function straight() result(chain)
        type(error_type), allocatable :: error
        call new_chain([line_between([0.0_dp, 1.0_dp], [7.0_dp, 2.0_dp])], chain, error)
        if (allocated(error)) error stop 'no chain'
    end function straight

end program test_body_comb
