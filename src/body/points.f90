!> The point cards of a SPLINE, BEZIER or FAIR line, or of a FAIRED outline, as numbers.
module body_points
    use base_decimal, only: decimal_type, to_real
    use base_kinds, only: dp
    use deck_job, only: ending, piece_real, piece_type
    implicit none (type, external)
    private

    public :: points_of, weights_of

contains

    !> The points, by columns.
    pure function points_of(pieces) result(at)
        type(piece_type), intent(in) :: pieces(:) !! points
        real(dp) :: at(2, size(pieces))
        integer :: i
        do i = 1, size(pieces)
            at(:, i) = piece_real(pieces(i), [1, 2])
        end do
    end function points_of

    !> The weights of points to be faired: their own, or what holds for all others.
    pure function weights_of(pieces, usual) result(weight)
        type(piece_type), intent(in) :: pieces(:)   !! points
        type(decimal_type), intent(in) :: usual     !! of those without one
        real(dp) :: weight(size(pieces))
        integer :: i
        weight = to_real(usual)
        do i = 1, size(pieces)
            if (pieces(i)%ending == ending%weight) weight(i) = piece_real(pieces(i), 3)
        end do
    end function weights_of

end module body_points
