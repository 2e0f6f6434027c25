!> Tests of reference lines. Oracles: round numbers worked by hand.
program test_dxf_page
    use base_kinds, only: dp
    use export_drawing, only: drawing_type, shape_kind, shape_type
    use export_dxf_page, only: add_references, page_axes, page_type, words_side
    use support_sketch, only: add_shape, new_drawing, new_shape
    use support_tap, only: tap_type
    implicit none (type, external)
    type(tap_type) :: tap

    call check_axes()
    call check_grid()
    call check_fractions()
    call check_sizes()
    call tap%finish()

contains

    subroutine check_axes()
        type(drawing_type) :: drawing
        type(shape_type) :: shape
        character(:), allocatable :: u_name, v_name

        drawing = new_drawing(1.0e-3_dp)
        shape = new_shape('STA-1', 1.0_dp)
        call add_shape(drawing, shape)
        call add_shape(drawing, shape)
        call page_axes(drawing, .false., u_name, v_name)
        call tap%same(u_name//' '//v_name, 'BL WL', 'stations: butt lines and waterlines')
        shape%kind = shape_kind%waterline
        call add_shape(drawing, shape)
        shape%kind = shape_kind%buttock
        call add_shape(drawing, shape)
        call page_axes(drawing, .false., u_name, v_name)
        call tap%same(u_name//' '//v_name, 'BL/STA WL/BL', 'cuts of several kinds: each name once')
        call page_axes(drawing, .true., u_name, v_name)
        call tap%same(u_name//' '//v_name, 'STA WL', 'in space: the side view')
    end subroutine check_axes

    subroutine check_grid()
        type(page_type) :: page
        integer :: i, zero

        page%low = [-12.0_dp, -5.0_dp]
        page%high = [12.0_dp, 15.0_dp]
        call add_references(page, 'BL', 'WL')
        call tap%near(page%height, 0.2_dp, 1.0e-15_dp, 'letters a hundredth of the size, about')
        call tap%ok(size(page%references) == 10 .and. size(page%ordinates) == 10, &
            'lines every 5 inches, each with its ordinate')
        zero = 0
        do i = 1, 5
            if (abs(page%references(i)%from(1)) <= 0.0_dp) zero = i
        end do
        call tap%ok(zero == 3, 'the centre line is in the middle')
        call tap%same(page%ordinates(3)%text, 'CL BL 0', 'and says so')
        call tap%same(page%ordinates(1)%text, 'BL -10', 'butt lines have their sign')
        call tap%same(page%ordinates(10)%text, 'WL 15', 'waterlines too')
        call tap%ok(page%ordinates(10)%side == words_side%right .and. &
            page%ordinates(10)%at(1) < page%references(10)%from(1), &
            'their ordinate ends at the left of the line')
        call tap%ok(page%references(1)%from(2) < page%low(2) .and. &
            page%references(1)%to(2) > page%high(2), 'lines reach beyond the shapes')
        call tap%ok(size(page%words) == 0 .and. size(page%ticks) == 0, 'there are no words yet')
    end subroutine check_grid

    subroutine check_fractions()
        type(page_type) :: page
        page%low = [0.0_dp, 0.0_dp]
        page%high = [0.8_dp, 0.5_dp]
        call add_references(page, 'STA', 'WL')
        call tap%same(page%ordinates(4)%text, 'STA 0.3', 'three tenths are .3')
        call tap%ok(abs(page%references(4)%from(1) - 0.3_dp) <= 0.0_dp, 'to the last bit')
        call tap%same(page%ordinates(1)%text, 'STA 0', 'a station of zero is no centre line')
    end subroutine check_fractions

    subroutine check_sizes()
        type(page_type) :: page
        page%low = [1.0e15_dp, -2.0_dp]
        page%high = [1.0e15_dp + 4.0_dp, 2.0_dp]
        call add_references(page, 'STA', 'WL')
        call tap%ok(size(page%references) > 2 .and. size(page%references) < 30, &
            'far from the origin there are not more lines')
        call check_point()
        call check_huge()
    end subroutine check_sizes

    subroutine check_point()
        type(page_type) :: page
        page%low = [3.0_dp, 4.0_dp]
        page%high = page%low
        call add_references(page, 'BL', 'WL')
        call tap%ok(page%height > 0.0_dp .and. size(page%references) == 2, &
            'a point has a cross of lines')
    end subroutine check_point

    subroutine check_huge()
        type(page_type) :: page
        page%low = -1.0e80_dp
        page%high = 1.0e80_dp
        call add_references(page, 'BL', 'WL')
        call tap%ok(size(page%references) == 22, 'any size has round numbers')
    end subroutine check_huge

end program test_dxf_page
