!> Points of cards, and their weights.
program test_points
    use base_decimal, only: decimal_type
    use base_kinds, only: dp
    use body_points, only: points_of, weights_of
    use deck_job, only: ending, piece, piece_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(piece_type) :: cards(3)

    cards%kind = piece%point
    allocate (cards(1)%value, source=[decimal_type(1, 0), decimal_type(25, -1), decimal_type(7, 0)])
    allocate (cards(2)%value, source=[decimal_type(2, 0), decimal_type(-5, -1), decimal_type(4, 0)])
    allocate (cards(3)%value, source=[decimal_type(3, 0), decimal_type(0, 0), decimal_type(0, 0)])
    cards(2)%ending = ending%weight
    cards(3)%ending = ending%weight
    call tap%ok(all(points_of(cards) == reshape([1.0_dp, 2.5_dp, 2.0_dp, -0.5_dp, 3.0_dp, &
        0.0_dp], [2, 3])), 'points by columns')
    call tap%ok(all(weights_of(cards, decimal_type(10, 0)) == [10.0_dp, 4.0_dp, 0.0_dp]), &
        'a weight of its own, also zero, or the usual one')
    call tap%ok(size(points_of(cards(:0)), 2) == 0, 'no points')
    call tap%finish()
end program test_points
