!> Flat faces of IGES files: plane, boundary in space and in the plane's parameters.
program test_iges_cap
    use base_kinds, only: dp
    use export_iges_cap, only: add_cap
    use export_iges_file, only: entry_type, iges_file_type
    use export_shell, only: skin_model_type
    use support_iges_deck, only: deck_of, deck_type
    use support_iges_shapes, only: box_lid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(iges_file_type) :: file
    type(skin_model_type) :: model
    type(deck_type) :: deck
    real(dp) :: plane(36), space(28), over(28), at(3)
    integer :: pointer, heads(10), tail, i, curves(2)
    character(:), allocatable :: record

    model = box_lid()
    call add_cap(file, entry_type(level=9), model, model%faces(2), 3, pointer)
    deck = deck_of(file%directory%text()//file%parameters%text())
    call tap%ok(deck%entities(128) == 1 .and. deck%entities(126) == 6 .and. &
        deck%entities(102) == 2 .and. deck%entities(142) == 1 .and. deck%entities(144) == 1, &
        'a plane, three curves twice, two composites, a boundary, a trimmed surface')
    call tap%ok(pointer == 21 .and. deck%field(21, 1) == '144', 'which it points to')
    call tap%same(deck%record(21), '144,1,1,0,19,0,1,3;', 'the trimmed surface has its parts')
    call tap%same(deck%record(19), '142,0,1,17,9,3;', 'the boundary: surface, over it, in space')
    call tap%same(deck%record(9), '102,3,3,5,7;', 'the boundary in space')
    call tap%same(deck%record(17), '102,3,11,13,15;', 'and over the plane')
    call tap%ok(deck%field(1, 9) == '00010000' .and. deck%field(9, 9) == '00010000' .and. &
        deck%field(17, 9) == '00010500' .and. deck%field(11, 9) == '00010500' .and. &
        deck%field(19, 9) == '00010000' .and. deck%field(21, 9) == '00000000', &
        'only the whole stands for itself')

    record = deck%record(1)
    read (record(:len(record) - 1), *) heads, plane(:28)
    call tap%ok(all(heads == [128, 1, 1, 1, 1, 0, 0, 1, 0, 0]), 'the plane is bilinear')
    ! Knots, weights, poles, ranges; its normal points forward, out of the body.
    associate (u => plane(1:4), v => plane(5:8), pole => reshape(plane(13:24), [3, 4]))
        call tap%ok(all(abs(pole(1, :)) == 0.0_dp), 'it is at STA 0')
        at = crossed(pole(:, 2) - pole(:, 1), pole(:, 3) - pole(:, 1))
        call tap%ok(at(1) < 0.0_dp, 'it faces forward')
        call tap%near(-at(1), (u(4) - u(1))*(v(4) - v(1)), 1.0e-14_dp, 'its parameters are lengths')
        call tap%ok(abs(at(1)) < 4.0_dp + 1.0e-14_dp, 'and it is no larger than needed')
        call tap%ok(all(plane(25:28) == [u(1), u(4), v(1), v(4)]), 'with its ranges')
        do i = 0, 2
            curves = [3 + 2*i, 11 + 2*i]
            call read_ends(curves(1), space(:6))
            call read_ends(curves(2), over(:6))
            call tap%ok(norm2(mapped(over(:2)) - space(:3)) < 1.0e-14_dp .and. &
                norm2(mapped(over(4:5)) - space(4:6)) < 1.0e-14_dp .and. over(3) == 0.0_dp, &
                'both boundaries are one')
            if (i > 0) call tap%ok(all(space(:3) == space(26:28)), 'curve follows curve')
            space(26:28) = space(4:6)
        end do
        call read_ends(3, space(:6))
        call tap%ok(all(space(:3) == space(26:28)), 'and they close')
    end associate
    call tap%ok(all(space(:3) == [0.0_dp, 0.0_dp, 2.0_dp]), 'the first is turned to go around')
    call tap%finish()

contains

    !> The first and the last pole of a 126.
    subroutine read_ends(pointer, ends)
        integer, intent(in) :: pointer      !! to it
        real(dp), intent(out) :: ends(6)    !! both
        real(dp), allocatable :: numbers(:)
        integer :: poles, degree

        record = deck%record(pointer)
        read (record, *) tail, poles, degree
        poles = poles + 1
        allocate (numbers(poles + degree + 1 + 4*poles))
        read (record(:len(record) - 1), *) heads(:7), numbers
        ends(:3) = numbers(2*poles + degree + 2:2*poles + degree + 4)
        ends(4:) = numbers(size(numbers) - 2:)
    end subroutine read_ends

    !> The point of the plane over its parameters.
    function mapped(uv) result(p)
        real(dp), intent(in) :: uv(2)   !! u and v
        real(dp) :: p(3)
        p = plane(13:15) + &
            (uv(1) - plane(1))/(plane(4) - plane(1))*(plane(16:18) - plane(13:15)) + &
            (uv(2) - plane(5))/(plane(8) - plane(5))*(plane(19:21) - plane(13:15))
    end function mapped

    !> The vector across two others.
    pure function crossed(a, b) result(c)
        real(dp), intent(in) :: a(3)    !! first
        real(dp), intent(in) :: b(3)    !! second
        real(dp) :: c(3)
        c = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
    end function crossed

end program test_iges_cap
