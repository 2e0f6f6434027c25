!> Products of vectors.
program test_vector
    use base_kinds, only: dp
    use geom_twofold, only: to_real, twofold
    use geom_vector, only: at_text, cross, dot, image
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), parameter :: east(2) = [1.0_dp, 0.0_dp], north(2) = [0.0_dp, 1.0_dp]

    call tap%ok(cross(east, north) == 1.0_dp, 'north is left of east')
    call tap%ok(cross(north, east) == -1.0_dp, 'east is right of north')
    call tap%ok(cross([0.1_dp, 0.3_dp], [1.0_dp, 3.0_dp]) == 2.0_dp**(-55), &
        'the area of decimals in line is what their rounding leaves: .1*3 - .3 is 2**-55')
    call tap%ok(to_real(cross(twofold([2.0_dp, 1.0_dp]), twofold([3.0_dp, 5.0_dp]))) == 7.0_dp, &
        'the twofold product agrees with one by hand')
    call tap%ok(to_real(cross(twofold([2.0_dp, 1.0_dp]), [3.0_dp, 5.0_dp])) == 7.0_dp, &
        'so does the mixed one')
    call tap%ok(to_real(dot(twofold([2.0_dp, 1.0_dp]), twofold([3.0_dp, 5.0_dp]))) == 11.0_dp, &
        'the inner product agrees with one by hand')
    call tap%ok(to_real(dot(twofold([2.0_dp, 1.0_dp]), [3.0_dp, 5.0_dp])) == 11.0_dp, &
        'so does the mixed inner product')
    call tap%ok(all(image(reshape([1.0_dp, 2.0_dp, 3.0_dp, 4.0_dp, 5.0_dp, 6.0_dp], [2, 3]), &
        [1.0_dp, -1.0_dp, 2.0_dp]) == [8.0_dp, 10.0_dp]), 'a matrix times a vector, by hand')
    call tap%same(at_text([12.5_dp, -3.0_dp]), '(12.5, -3.)', 'a point is written as in a sentence')
    call tap%finish()
end program test_vector
