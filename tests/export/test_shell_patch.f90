!> A patch as a shell: its loop goes round, counter-clockwise seen from outside; so does its image.
program test_shell_patch
    use base_kinds, only: dp
    use body_panel, only: mirrored_panel, panel_type
    use export_shell, only: skin_model_type
    use export_shell_patch, only: shell_of_patch
    use geom_bspline, only: spline_point
    use support_saddle, only: saddle
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(skin_model_type) :: model
    type(panel_type) :: pointed

    call shell_of_patch(saddle(), model)
    call tap%same(model%faces(1)%name, 'SADDLE', 'a face has the name of the patch')
    call tap%ok(size(model%shells) == 1 .and. .not. model%shells(1)%is_closed, 'an open shell')
    call check_loop('of a patch', 1.0_dp)
    call shell_of_patch(mirrored_panel(saddle()), model)
    call tap%same(model%faces(1)%name, 'SADDLE PORT', 'an image is said to be')
    call check_loop('of its image', 1.0_dp)
    pointed = saddle()
    pointed%surface%pole(:, 1, :) = spread(pointed%surface%pole(:, 1, 1), 2, 6)
    pointed%point = 4
    call shell_of_patch(pointed, model)
    call tap%ok(size(model%edges) == 3 .and. count(model%faces(1)%sides%edge == 0) == 1, &
        'a side that is a point has no edge')
    call check_loop('of a patch with a point', 1.0_dp)
    call tap%finish()

contains

    !> Each side begins where the one before ends, and the loop runs counter-clockwise from above.
    subroutine check_loop(name, sense)
        character(*), intent(in) :: name    !! of the check
        real(dp), intent(in) :: sense       !! sign of the area it goes round
        integer :: i, begin(4), end(4)
        real(dp) :: area, ends(3, 2)
        logical :: fits

        fits = .true.
        area = 0.0_dp
        do i = 1, 4
            associate (side => model%faces(1)%sides(i))
                begin(i) = side%vertex
                end(i) = side%vertex
                if (side%edge == 0) cycle
                associate (edge => model%edges(side%edge))
                    begin(i) = merge(edge%from, edge%to, side%is_forward)
                    end(i) = merge(edge%to, edge%from, side%is_forward)
                    ends(:, 1) = spline_point(edge%curve, 0.0_dp)
                    ends(:, 2) = spline_point(edge%curve, 1.0_dp)
                    fits = fits .and. norm2(ends(:, 1) - model%vertices(edge%from)%at) <= 0.0_dp &
                        .and. norm2(ends(:, 2) - model%vertices(edge%to)%at) <= 0.0_dp
                    if (.not. side%is_forward) ends = ends(:, 2:1:-1)
                    area = area + ends(1, 1)*ends(2, 2) - ends(1, 2)*ends(2, 1)
                end associate
            end associate
        end do
        call tap%ok(all(begin == cshift(end, -1)), 'the loop '//name//' goes round')
        call tap%ok(fits, 'edges '//name//' end in their vertices')
        call tap%ok(sense*area > 0.0_dp, 'the loop '//name//' is counter-clockwise')
    end subroutine check_loop

end program test_shell_patch
