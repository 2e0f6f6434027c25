!> Tests of caps: in which loops they come, which way they look, what is parted.
program test_shell_caps
    use base_kinds, only: dp
    use export_shell_caps, only: add_caps, bond_corners
    use export_shell_panels, only: mirrored_panel, panel_type
    use support_skins, only: deck_body, take_panels, text_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(panel_type), allocatable :: panels(:)
    real(dp), allocatable :: corners(:, :)
    character, parameter :: nl = new_line('a')
    !> Pods off BL 0: whole rings, port and starboard.
    character(*), parameter :: pod = 'TITLE,POD'//nl//'LINE,TOP,SIDE,5.'//nl// &
        'LINE,TOP,PLAN,20.'//nl//'LINE,LOW,SIDE,-5.'//nl//'LINE,LOW,PLAN,20.'//nl// &
        'LINE,OUT,SIDE,0.'//nl//'LINE,OUT,PLAN,25.'//nl//'LINE,IN,SIDE,0.'//nl// &
        'LINE,IN,PLAN,15.'//nl//'SECTION,OUTER,TOP,OUT,LOW,0.,0.,0.,50.'//nl// &
        'SECTION,INNER,TOP,IN,LOW,0.,0.,0.,50.'//nl

    call take('cone')
    call add_caps(corners, .false., panels)
    call tap%ok(size(panels) == 8, 'loops over BL 0 get no cap where the deck does not say so')
    call add_caps(corners, .true., panels)
    call tap%ok(size(panels) == 9, 'a cone gets one where it ends')
    associate (cap => panels(size(panels)))
        call tap%same(cap%face%name, 'CAP STA 100', 'named by its station')
        call tap%ok(all(cap%face%normal == [1.0_dp, 0.0_dp, 0.0_dp]), 'it looks aft')
        call tap%ok(cap%face%origin(1) == 100.0_dp .and. cap%face%is_flat, 'flat, at its station')
        call tap%ok(size(cap%bonds) == 4 .and. is_loop(cap), 'four sides in a loop')
        call tap%ok(all(cap%bonds%key%side == 2), 'of ribs where skin ends')
    end associate

    call take_panels(text_body(pod), panels, corners)
    call tap%ok(size(panels) == 2, 'a pod is two panels')
    panels = [panels, mirrored_panel(panels(1)), mirrored_panel(panels(2))]
    call add_caps(corners, .false., panels)
    call tap%ok(size(panels) == 8, 'each of two pods gets two caps, whatever the deck says')
    call tap%ok(all([is_loop(panels(5)), is_loop(panels(6)), is_loop(panels(7)), &
        is_loop(panels(8))]), 'all are loops')
    call tap%ok(count([panels(5)%face%normal(1), panels(6)%face%normal(1), &
        panels(7)%face%normal(1), panels(8)%face%normal(1)] > 0.0_dp) == 2, &
        'two look aft, two forward')

    call take_panels(text_body(pod), panels, corners)
    panels = panels(1:1)
    call add_caps(corners, .true., panels)
    call tap%ok(size(panels) == 1 .and. all(panels(1)%bonds%key%side == 0), &
        'what makes no loop is left as it is')
    call tap%finish()

contains

    !> Both halves of a deck.
    subroutine take(name)
        character(*), intent(in) :: name
        type(panel_type), allocatable :: whole(:)
        integer :: i, n
        call take_panels(deck_body(name), panels, corners)
        n = size(panels)
        allocate (whole(2*n))
        do i = 1, n
            whole(i) = panels(i)
            whole(n + i) = mirrored_panel(panels(i))
        end do
        call move_alloc(whole, panels)
    end subroutine take

    !> True where each side of a panel begins where the one before ends.
    logical function is_loop(panel)
        type(panel_type), intent(in) :: panel
        integer :: ends(2), next(2), k, n
        n = size(panel%bonds)
        is_loop = n > 0
        do k = 1, n
            ends = bond_corners(panel%bonds(k), corners)
            next = bond_corners(panel%bonds(mod(k, n) + 1), corners)
            is_loop = is_loop .and. ends(2) == next(1)
        end do
    end function is_loop

end program test_shell_caps
