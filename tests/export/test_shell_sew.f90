!> Tests of sewing: which bonds become one edge, which faces one shell.
program test_shell_sew
    use base_kinds, only: dp
    use export_shell, only: skin_model_type
    use export_shell_panels, only: panel_type
    use export_shell_sew, only: sew
    use support_skins, only: deck_body, edge_uses, is_chained, take_panels
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(panel_type), allocatable :: panels(:)
    type(skin_model_type) :: model
    real(dp), allocatable :: corners(:, :)

    call take_panels(deck_body('ellipsoid'), panels, corners)
    call sew(corners, panels, model)
    call tap%ok(size(model%vertices) == 5 .and. size(model%edges) == 8 .and. &
        size(model%faces) == 4, 'half an ellipsoid: 5 vertices, 8 edges, 4 faces')
    call tap%ok(is_chained(model), 'its sides follow each other')
    call tap%ok(count(sum(edge_uses(model), dim=1) == 2) == 4, 'four edges are shared')
    call tap%ok(size(model%shells) == 1 .and. .not. any(model%shells%is_closed), &
        'it is one open shell')
    call tap%ok(size(model%shells(1)%faces) == 4, 'of all four faces')

    call sew(corners, panels([1, 4]), model)
    call tap%ok(size(model%shells) == 2 .and. size(model%edges) == 6, &
        'two faces that touch in a point are two shells')
    call sew(corners, panels([1, 2, 2]), model)
    call tap%ok(maxval(edge_uses(model)) == 1 .and. size(model%edges) == 8, &
        'a face that is there twice has edges of its own')
    call tap%ok(size(model%shells) == 2, 'and is a shell of its own')
    panels(2)%bonds%key%side = 7
    call sew(corners, panels([1, 2]), model)
    call tap%ok(size(model%shells) == 2, 'what is parted is not sewn')
    call sew(corners, panels(:0), model)
    call tap%ok(size(model%shells) == 0 .and. size(model%vertices) == 0, 'nothing gives nothing')
    call tap%finish()
end program test_shell_sew
