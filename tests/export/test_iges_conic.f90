!> Conics of IGES files: read back by the equation and the matrix, as a reader does it.
program test_iges_conic
    use base_kinds, only: dp
    use base_text, only: to_text
    use cut_plane, only: buttock_plane, plane_type
    use export_drawing, only: curve_type
    use export_iges_conic, only: add_conic, conic_error, suits_conic
    use export_iges_file, only: entry_type, iges_file_type
    use geom_arc, only: line_between
    use geom_bspline, only: spline_point
    use support_iges_deck, only: deck_of, deck_type
    use support_iges_shapes, only: arc_of_rho, curve_of, oblique
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(curve_type) :: curve

    call check(sqrt(2.0_dp) - 1.0_dp, oblique(), 1)
    call check(0.3_dp, buttock_plane(4.5_dp), 1)
    call check(0.5_dp, oblique(), 3)
    call check(0.5_dp, buttock_plane(4.5_dp), 3)
    call check(0.7_dp, oblique(), 2)
    call check(0.7_dp, buttock_plane(4.5_dp), 2)

    curve = curve_of(line_between([0.0_dp, 0.0_dp], [1.0_dp, 2.0_dp]), oblique())
    call tap%ok(.not. suits_conic(curve, oblique()), 'a line is no conic')
    curve = curve_of(arc_of_rho(0.5_dp + 1.0e-7_dp), oblique())
    call tap%ok(.not. suits_conic(curve, oblique()), 'a centre far away is left to splines')
    curve = curve_of(arc_of_rho(0.4_dp), oblique())
    call tap%ok(suits_conic(curve, oblique()), 'a near one is not')
    curve%spline%pole(:, 2) = curve%spline%pole(:, 2) + 1.0e-9_dp
    call tap%ok(.not. suits_conic(curve, oblique()), 'a spline that is off its arc is')
    call tap%ok(conic_error(curve, oblique()) > 1.0e-10_dp, 'by as much as it is off')
    curve%is_conic = .false.
    call tap%ok(.not. suits_conic(curve, oblique()), 'and so is a curve of another kind')
    call tap%finish()

contains

    !> Writes an arc and reads it back.
    subroutine check(rho, plane, form)
        real(dp), intent(in) :: rho             !! of the arc
        type(plane_type), intent(in) :: plane   !! where it is
        integer, intent(in) :: form             !! that it must have
        type(iges_file_type) :: file
        type(deck_type) :: deck
        real(dp) :: k(6), height, ends(2, 2), matrix(4, 3), r(3, 3), at(3), local(3), off
        integer :: pointer, i, kind
        character(:), allocatable :: record
        character(4) :: name

        write (name, '(f4.2)') rho
        curve = curve_of(arc_of_rho(rho), plane)
        call tap%ok(suits_conic(curve, plane), name//': a conic')
        call add_conic(file, entry_type(level=2), curve, plane, 0, pointer)
        deck = deck_of(file%directory%text()//file%parameters%text())
        call tap%ok(pointer == 3 .and. deck%field(3, 7) == '1' .and. deck%field(3, 5) == '2', &
            name//': it refers to its matrix')
        call tap%same(deck%field(3, 15), to_text(form), name//': it has its form')
        record = deck%record(3)
        read (record(:len(record) - 1), *) kind, k, height, ends
        call tap%ok(kind == 104 .and. height == 0.0_dp, name//': it is in its plane')
        select case (form)
        case (1)
            call tap%ok(all(k([2, 4, 5]) == 0.0_dp) .and. k(1) > 0.0_dp .and. k(3) >= k(1) .and. &
                k(6) < 0.0_dp, name//': in standard position')
        case (2)
            call tap%ok(all(k([2, 4, 5]) == 0.0_dp) .and. k(1) > 0.0_dp .and. k(3) < 0.0_dp .and. &
                k(6) < 0.0_dp, name//': in standard position')
        case (3)
            call tap%ok(all(k([1, 2, 5, 6]) == 0.0_dp) .and. k(3) > 0.0_dp .and. k(4) < 0.0_dp, &
                name//': in standard position')
        end select
        record = deck%record(1)
        read (record(:len(record) - 1), *) kind, matrix
        r = matrix(:3, :)
        call tap%ok(kind == 124 .and. all(abs(matmul(r, transpose(r)) - identity()) < 1.0e-15_dp) &
            .and. determinant(r) > 0.0_dp, name//': its matrix is a rotation')
        off = 0.0_dp
        do i = 0, 20
            ! `matrix` has the rows of R by columns, so that a vector times it is its inverse.
            at = spline_point(curve%spline, real(i, dp)/20.0_dp) - matrix(4, :)
            local = matmul(r, at)
            off = max(off, abs(local(3)), abs(k(1)*local(1)**2 + k(3)*local(2)**2 + k(4)*local(1) &
                + k(6))/norm2([2*k(1)*local(1) + k(4), 2*k(3)*local(2)]))
            if (i == 0) off = max(off, norm2(local(:2) - ends(:, 1)))
            if (i == 20) off = max(off, norm2(local(:2) - ends(:, 2)))
            if (form == 2 .and. local(1) < 0.0_dp) off = 1.0_dp
        end do
        call tap%near(off, 0.0_dp, 2.0e-14_dp, name//': the curve fulfils it, from end to end')
        call tap%ok(form /= 1 .or. ends(1, 1)*ends(2, 2) - ends(2, 1)*ends(1, 2) > 0.0_dp, &
            name//': an ellipse goes counter-clockwise')
    end subroutine check

    !> The unit matrix.
    pure function identity() result(e)
        real(dp) :: e(3, 3)
        integer :: i
        e = 0.0_dp
        do i = 1, 3
            e(i, i) = 1.0_dp
        end do
    end function identity

    !> The determinant of a matrix.
    pure real(dp) function determinant(m)
        real(dp), intent(in) :: m(3, 3) !! any
        determinant = m(1, 1)*(m(2, 2)*m(3, 3) - m(2, 3)*m(3, 2)) - m(1, 2)*(m(2, 1)*m(3, 3) - &
            m(2, 3)*m(3, 1)) + m(1, 3)*(m(2, 1)*m(3, 2) - m(2, 2)*m(3, 1))
    end function determinant

end program test_iges_conic
