!> A point of which nothing was said has nothing.
program test_outline
    use cut_outline, only: cut_point_type, cut_type, outline_type, piece_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(cut_point_type) :: point
    type(outline_type) :: outline
    type(piece_type) :: piece
    type(cut_type) :: cut

    call tap%ok(.not. (point%has_normal .or. point%has_slope .or. point%has_curvature), &
        'a fresh point has no normal, slope or curvature')
    call tap%ok(.not. outline%is_closed, 'a fresh outline is open')
    call tap%ok(.not. (piece%is_arc .or. piece%is_image), 'a fresh piece is no arc and no image')
    call tap%ok(.not. cut%is_flange_forward, 'a flange is aft where nothing is said')
    call tap%finish()
end program test_outline
