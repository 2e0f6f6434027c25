!> Tests of the model of a skin as `export_shell` promises it, on the decks: edges are the surfaces'
!> own, pole by pole, vertices are the ends of edges, a closed shell uses each edge once each way,
!> the halves are mirror images.
program test_shell
    use base_kinds, only: dp
    use export_shell, only: edge_type, face_type, side_type, skin_model_type
    use geom_bspline, only: bspline_type
    use geom_bspline_surface, only: edge_spline
    use support_skins, only: deck_body, edge_uses, is_chained, skin_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call judge('ellipsoid', .true.)
    call judge('sphere', .true.)
    call judge('cone', .true.)
    call judge('paraboloid', .true.)
    call judge('round-nose', .true.)
    call judge('fuselage', .true.)
    call judge('nose', .false.)
    call tap%finish()

contains

    !> A deck, as open shells and as solids.
    subroutine judge(name, closes)
        character(*), intent(in) :: name !! of the deck
        logical, intent(in) :: closes    !! its solid is closed
        type(skin_model_type) :: model
        integer, allocatable :: uses(:, :)

        model = skin_of(deck_body(name), 1.0e-3_dp, .true.)
        allocate (uses, source=edge_uses(model))
        call tap%ok(is_chained(model), name//': sides follow each other around each face')
        call tap%ok(all(uses <= 1), name//': no edge is used twice the same way')
        call tap%ok(all(uses == 1) .eqv. closes, name//': each edge is used once each way, or open')
        call tap%ok(all(model%shells%is_closed) .eqv. closes, name//': the shells say so')
        call tap%ok(ends_are_vertices(model), name//': edges end in their vertices, exactly')
        call tap%ok(own_edges(model), name//': edges are those of the surfaces, pole by pole')
        call tap%ok(halves_mirror(model), name//': the port half is the mirror image, exactly')
        call tap%ok(.not. any_minus_zero(model), name//': no coordinate is -0')
    end subroutine judge

    !> True where the first and the last pole of each edge are its vertices.
    logical function ends_are_vertices(model) result(are)
        type(skin_model_type), intent(in) :: model
        integer :: i, n
        are = .true.
        do i = 1, size(model%edges)
            associate (edge => model%edges(i))
                n = size(edge%curve%weight)
                are = are .and. all(edge%curve%pole(:, 1) == model%vertices(edge%from)%at) &
                    .and. all(edge%curve%pole(:, n) == model%vertices(edge%to)%at)
            end associate
        end do
    end function ends_are_vertices

    !> True where the sides of each surface are its edge lines, in the order stated; a side that is
    !> a point has all its poles there.
    logical function own_edges(model) result(own)
        type(skin_model_type), intent(in) :: model
        type(bspline_type) :: line
        integer :: i, k, side
        own = .true.
        do i = 1, size(model%faces)
            associate (face => model%faces(i))
                if (face%is_flat) cycle
                own = own .and. size(face%sides) == 4
                do k = 1, 4
                    side = merge(k, modulo(1 - k, 4) + 1, face%is_outward)
                    line = edge_spline(face%surface, side)
                    own = own .and. is_side(model, face%sides(k), line)
                end do
            end associate
        end do
    end function own_edges

    !> True where a side is an edge line of a surface, either way.
    logical function is_side(model, side, line)
        type(skin_model_type), intent(in) :: model
        type(side_type), intent(in) :: side
        type(bspline_type), intent(in) :: line
        integer :: n, i
        n = size(line%weight)
        if (side%edge == 0) then
            is_side = all([(all(line%pole(:, i) == model%vertices(side%vertex)%at), i=1, n)])
            return
        end if
        associate (curve => model%edges(side%edge)%curve)
            is_side = size(curve%weight) == n
            if (.not. is_side) return
            is_side = all(curve%pole == line%pole) .and. all(curve%weight == line%weight)
            if (.not. is_side) is_side = all(curve%pole(:, n:1:-1) == line%pole) .and. &
                all(curve%weight(n:1:-1) == line%weight)
        end associate
    end function is_side

    !> True where each port surface is that of a starboard one, BL with the other sign.
    logical function halves_mirror(model) result(mirror)
        type(skin_model_type), intent(in) :: model
        integer, allocatable :: port(:), starboard(:)
        integer :: i
        starboard = pack([(i, i=1, size(model%faces))], &
            .not. (model%faces%is_port .or. model%faces%is_flat))
        port = pack([(i, i=1, size(model%faces))], model%faces%is_port)
        mirror = size(port) == size(starboard)
        if (.not. mirror) return
        do i = 1, size(port)
            associate (one => model%faces(starboard(i)), other => model%faces(port(i)))
                mirror = mirror .and. one%section == other%section .and. &
                    (one%is_outward .neqv. other%is_outward) .and. &
                    all(one%surface%weight == other%surface%weight) .and. &
                    all(one%surface%pole(2, :, :) == -other%surface%pole(2, :, :)) .and. &
                    all(one%surface%pole([1, 3], :, :) == other%surface%pole([1, 3], :, :))
            end associate
        end do
    end function halves_mirror

    !> True where a zero has a sign.
    logical function any_minus_zero(model) result(any_minus)
        type(skin_model_type), intent(in) :: model
        integer :: i
        any_minus = .false.
        do i = 1, size(model%faces)
            if (model%faces(i)%is_flat) cycle
            associate (pole => model%faces(i)%surface%pole)
                any_minus = any_minus .or. any(pole == 0.0_dp .and. sign(1.0_dp, pole) < 0.0_dp)
            end associate
        end do
        do i = 1, size(model%edges)
            associate (pole => model%edges(i)%curve%pole)
                any_minus = any_minus .or. any(pole == 0.0_dp .and. sign(1.0_dp, pole) < 0.0_dp)
            end associate
        end do
        do i = 1, size(model%vertices)
            associate (at => model%vertices(i)%at)
                any_minus = any_minus .or. any(at == 0.0_dp .and. sign(1.0_dp, at) < 0.0_dp)
            end associate
        end do
    end function any_minus_zero

end program test_shell
