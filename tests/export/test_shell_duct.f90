!> A duct as a shell: both loops go round, counter-clockwise seen from outside, their common edges
!> are used once each way; so is its image.
program test_shell_duct
    use base_kinds, only: dp
    use body_duct, only: duct_type
    use body_panel, only: mirrored_panel, panel_type
    use export_shell, only: skin_model_type
    use export_shell_duct, only: shell_of_duct
    use geom_bspline, only: spline_from, spline_point, spline_to
    use support_ducts, only: s_duct
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(duct_type) :: duct

    duct = s_duct()
    call check(duct%panel, 'DUCT', 'of a duct')
    call check(mirrored_panel(duct%panel), 'DUCT PORT', 'of its image')
    call tap%finish()

contains

    !> Checks a shell.
    subroutine check(panel, name, words)
        type(panel_type), intent(in) :: panel   !! a duct
        character(*), intent(in) :: name        !! of its faces
        character(*), intent(in) :: words       !! for the checks
        type(skin_model_type) :: model
        integer :: uses(-1:1, 6), i, k, begin, before
        logical :: is_chain, is_outward
        real(dp) :: worst

        call shell_of_duct(panel, model)
        call tap%ok(size(model%faces) == 2 .and. model%faces(1)%name == name .and. &
            model%faces(2)%name == name, 'two faces '//words)
        uses = 0
        is_chain = .true.
        worst = 0.0_dp
        do i = 1, 2
            associate (sides => model%faces(i)%sides)
                do k = 1, 4
                    uses(merge(1, -1, sides(k)%is_forward), sides(k)%edge) = &
                        uses(merge(1, -1, sides(k)%is_forward), sides(k)%edge) + 1
                    associate (one => model%edges(sides(k)%edge), &
                        other => model%edges(sides(1 + modulo(k - 2, 4))%edge))
                        begin = merge(one%from, one%to, sides(k)%is_forward)
                        before = merge(other%to, other%from, &
                            sides(1 + modulo(k - 2, 4))%is_forward)
                        is_chain = is_chain .and. begin == before
                        worst = max(worst, norm2(spline_point(one%curve, spline_from(one%curve)) &
                            - model%vertices(one%from)%at), norm2(spline_point(one%curve, &
                            spline_to(one%curve)) - model%vertices(one%to)%at))
                    end associate
                end do
            end associate
        end do
        call tap%ok(is_chain, 'sides are end to end '//words)
        call tap%near(worst, 0.0_dp, 0.0_dp, 'edges end in their vertices, exactly, '//words)
        call tap%ok(all(uses(1, 5:6) == 1 .and. uses(-1, 5:6) == 1) .and. all(sum(uses(:, :4), &
            dim=1) == 1), 'edges along are used once each way '//words)
        is_outward = .true.
        do i = 1, 2
            is_outward = is_outward .and. faces_out(model, i)
        end do
        call tap%ok(is_outward, 'the loops are counter-clockwise from outside '//words)
    end subroutine check

    !> True where the loop of a face runs counter-clockwise as seen from its side of the duct: the
    !> vector area of the polygon along it points there.
    logical function faces_out(model, number)
        type(skin_model_type), intent(in) :: model
        integer, intent(in) :: number
        integer, parameter :: steps = 40
        real(dp) :: at(3, 0:steps), area(3)
        integer :: i, k

        area = 0.0_dp
        do k = 1, 4
            associate (side => model%faces(number)%sides(k))
                associate (curve => model%edges(side%edge)%curve)
                    do i = 0, steps
                        at(:, i) = spline_point(curve, spline_from(curve) + real(i, dp)/ &
                            real(steps, dp)*(spline_to(curve) - spline_from(curve)))
                    end do
                end associate
                if (.not. side%is_forward) at = at(:, steps:0:-1)
            end associate
            do i = 1, steps
                area = area + cshift(at(:, i - 1), 1)*cshift(at(:, i), 2) &
                    - cshift(at(:, i - 1), 2)*cshift(at(:, i), 1)
            end do
        end do
        faces_out = dot_product(area, centre(model, number) - centre(model, 3 - number)) > 0.0_dp
    end function faces_out

    !> The mean pole of a face.
    function centre(model, number) result(mean)
        type(skin_model_type), intent(in) :: model
        integer, intent(in) :: number
        real(dp) :: mean(3)
        associate (surface => model%faces(number)%surface)
            mean = sum(sum(surface%pole, dim=3), dim=2)/real(size(surface%weight), dp)
        end associate
    end function centre

end program test_shell_duct
