!> Tests of the skin of bodies: closed forms, areas and volumes, tolerances measured anew, solids of
!> bodies that step, end in lines, have one side, and bodies that close nowhere.
program test_shell_build
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_measure_body, only: body_measure_type, measure_body
    use export_shell, only: skin_model_type
    use export_shell_build, only: scale_shell
    use geom_bspline_surface, only: surface_point
    use support_skins, only: deck_body, edge_uses, furthest, is_chained, skin_area, skin_of, &
        skin_volume, text_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character, parameter :: nl = new_line('a')
    !> Half of a round body: upper and lower quarters of radius 10 at STA 50, round nose at STA 0.
    character(*), parameter :: bullet = &
        'LINE,UCL,SIDE'//nl//'0.,0.,999.999,20.,8.,50.,10.,0.'//nl// &
        'LINE,LCL,SIDE'//nl//'0.,0.,999.999,20.,-8.,50.,-10.,0.'//nl// &
        'LINE,MHB,SIDE,0.'//nl//'LINE,MHB,PLAN'//nl//'0.,0.,999.999,20.,8.,50.,10.,0.'//nl// &
        'LINE,USH,SIDE'//nl//'0.,0.,999.999,20.,6.4,50.,8.,0.'//nl// &
        'LINE,USH,PLAN'//nl//'0.,0.,999.999,20.,4.8,50.,6.,0.'//nl// &
        'LINE,LSH,SIDE'//nl//'0.,0.,999.999,20.,-6.4,50.,-8.,0.'//nl// &
        'LINE,LSH,PLAN,USH'//nl

    call judge_quadric('ellipsoid', [120.0_dp, 0.0_dp, 30.0_dp], [100.0_dp, 60.0_dp, 50.0_dp])
    call judge_quadric('sphere', [50.0_dp, 0.0_dp, 0.0_dp], [50.0_dp, 50.0_dp, 50.0_dp])
    call judge_measures('cone', 1.0e-3_dp)
    call judge_measures('paraboloid', 1.0e-3_dp)
    call judge_measures('round-nose', 1.0e-3_dp)
    call judge_measures('fuselage', 1.0e-3_dp)
    call judge_measures('fuselage', 1.0e-6_dp)
    call judge_measures('nose', 1.0e-3_dp)
    call judge_measures('nose', 1.0e-6_dp)
    call judge_cone()
    call judge_fuselage()
    call judge_scale()
    call judge_step()
    call judge_joins()
    call judge_ends_in_lines()
    call judge_walls()
    call judge_open()
    call judge_bad()
    call tap%finish()

contains

    !> An ellipsoid: each point of each surface is on it, each face is exact.
    subroutine judge_quadric(name, centre, axes)
        character(*), intent(in) :: name
        real(dp), intent(in) :: centre(3), axes(3)
        type(skin_model_type) :: model
        real(dp) :: p(3), worst, pi
        integer :: i, j, k
        model = skin_of(deck_body(name), 1.0e-6_dp, .true.)
        pi = acos(-1.0_dp)
        worst = 0.0_dp
        do i = 1, size(model%faces)
            do j = 0, 16
                do k = 0, 16
                    p = (surface_point(model%faces(i)%surface, real(j, dp)/16.0_dp, &
                        real(k, dp)/16.0_dp) - centre)/axes
                    worst = max(worst, abs(norm2(p) - 1.0_dp))
                end do
            end do
        end do
        call tap%ok(worst < 1.0e-14_dp, name//': all points are on the quadric')
        call tap%ok(all(model%faces%is_exact), name//': all faces are exact')
        call tap%ok(maxval(model%faces%error) < 1.0e-12_dp, name//': as measured')
        call tap%ok(size(model%faces) == 8 .and. sum([(size(model%faces(i)%surface%weight), &
            i=1, 8)]) == 72, name//': eight faces of nine poles')
        call tap%near(skin_volume(model), 4.0_dp*pi/3.0_dp*product(axes), 1.0e-9_dp*product(axes), &
            name//': volume, outward')
    end subroutine judge_quadric

    !> A deck: area and volume by Gauss's rule are those of the sections; no point is further from
    !> the skin than the faces say.
    subroutine judge_measures(name, tolerance)
        character(*), intent(in) :: name
        real(dp), intent(in) :: tolerance
        type(skin_model_type) :: model
        type(body_type) :: body
        type(body_measure_type) :: measure
        real(dp) :: distance
        body = deck_body(name)
        call measure_body(body, [real(dp) :: ], measure)
        model = skin_of(body, tolerance, .true.)
        distance = furthest(body, model, 9)
        call tap%ok(maxval(model%faces%error) <= tolerance, name//': within the tolerance')
        call tap%ok(distance <= tolerance, name//': so it is at other places')
        call tap%ok(distance <= 1.1_dp*maxval(model%faces%error) + 1.0e-11_dp, &
            name//': no place is much worse than the face says')
        call tap%near(skin_area(model), measure%wetted_area, &
            tolerance*1.0e-2_dp*measure%wetted_area, name//': wetted area')
        if (measure%has_volume) call tap%near(skin_volume(model), measure%volume, &
            tolerance*measure%wetted_area, name//': volume, outward')
    end subroutine judge_measures

    !> A cone is ruled: two poles along the body.
    subroutine judge_cone()
        type(skin_model_type) :: model
        integer :: i
        model = skin_of(deck_body('cone'), 1.0e-3_dp, .false.)
        call tap%ok(all(model%faces%is_exact), 'cone: all faces are exact')
        call tap%ok(all([(size(model%faces(i)%surface%weight) == 6, i=1, size(model%faces))]), &
            'cone: of two by three poles')
    end subroutine judge_cone

    !> The fuselage is one solid, its dorsal fairing sewn to the skin that it begins in.
    subroutine judge_fuselage()
        type(skin_model_type) :: model
        integer, parameter :: fillet = 11, ridge = 12
        model = skin_of(deck_body('fuselage'), 1.0e-3_dp, .true.)
        call tap%ok(size(model%shells) == 1 .and. size(model%faces) == 26, &
            'fuselage: one shell of 24 faces and two caps')
        call tap%ok(model%faces(fillet)%sides(4)%edge == 0 .and. &
            model%faces(ridge)%sides(4)%edge == 0, 'fuselage: the fairing begins in a point')
        call tap%ok(all(model%vertices(model%faces(ridge)%sides(4)%vertex)%at == &
            [200.0_dp, 0.0_dp, 26.0_dp]), 'fuselage: which is on the centre line')
        call tap%same(model%faces(ridge)%name, 'RIDGE STA 200 TO 280', 'faces have names')
        call tap%same(model%faces(24)%name, 'RIDGE P STA 200 TO 280', 'the port half a P in them')
        call tap%same(model%faces(26)%name, 'CAP STA 280', 'caps their station')
        call tap%ok(size(model%faces(26)%sides) == 8 .and. all(model%faces(26)%normal == &
            [1.0_dp, 0.0_dp, 0.0_dp]), 'a cap has a side for each section and looks aft')
        call tap%ok(all(model%faces(25)%normal == [-1.0_dp, 0.0_dp, 0.0_dp]), 'or forward')
    end subroutine judge_fuselage

    !> Another unit is the same skin.
    subroutine judge_scale()
        type(skin_model_type) :: model, scaled
        integer :: i
        model = skin_of(deck_body('fuselage'), 1.0e-3_dp, .true.)
        scaled = model
        call scale_shell(scaled, 25.4_dp)
        call tap%near(skin_volume(scaled), 25.4_dp**3*skin_volume(model), 1.0_dp, &
            'a skin in millimetres has 25.4**3 the volume')
        call tap%ok(all([(all(scaled%edges(i)%curve%pole(:, 1) == &
            scaled%vertices(scaled%edges(i)%from)%at), i=1, size(scaled%edges))]), &
            'edges still end in their vertices, exactly')
        call tap%ok(maxval(scaled%faces%error) == 25.4_dp*maxval(model%faces%error), &
            'errors are in the new unit')
        call tap%ok(all(scaled%faces(26)%origin == 25.4_dp*model%faces(26)%origin), 'caps move')
    end subroutine judge_scale

    !> A frustum of a body whose upper half steps down at STA 20.
    subroutine judge_step()
        character(*), parameter :: deck = 'TITLE,STEP'//nl//'CLOSE'//nl// &
            'LINE,UCL,SIDE,10.'//nl//'LINE,UC2,SIDE,5.'//nl//'LINE,LCL,SIDE,-10.'//nl// &
            'LINE,MHB,SIDE,0.'//nl//'LINE,MHB,PLAN,10.'//nl//'LINE,USH,SIDE,8.'//nl// &
            'LINE,US2,SIDE,4.'//nl//'LINE,USH,PLAN,6.'//nl//'LINE,US2,PLAN,6.'//nl// &
            'LINE,LSH,SIDE,-8.'//nl//'LINE,LSH,PLAN,6.'//nl// &
            'SECTION,FORE,UCL,USH,MHB,0.,999.999,0.,20.'//nl// &
            'SECTION,AFT,UC2,US2,MHB,0.,999.999,20.,50.'//nl// &
            'SECTION,LOWER,LCL,LSH,MHB,0.,999.999,0.,50.'//nl
        type(skin_model_type) :: model
        integer, allocatable :: uses(:, :)
        real(dp) :: quarter
        model = skin_of(text_body(deck), 1.0e-3_dp, .true.)
        quarter = acos(-1.0_dp)*25.0_dp
        call tap%ok(size(model%shells) == 2 .and. all(model%shells%is_closed), &
            'a body that steps: two solids')
        call tap%ok(count(model%faces%is_flat) == 4, 'with a cap at each end')
        call tap%near(skin_volume(model), quarter*(4.0_dp*20.0_dp + 3.0_dp*30.0_dp), 1.0e-9_dp, &
            'their volume is that of the cylinders')
        model = skin_of(text_body(deck), 1.0e-3_dp, .false.)
        allocate (uses, source=edge_uses(model))
        call tap%ok(size(model%shells) == 1 .and. .not. any(model%faces%is_flat), &
            'as a skin it hangs together by what does not step')
        call tap%ok(count(sum(uses, dim=1) == 1) == 12, 'and is open where it begins, steps, ends')
    end subroutine judge_step

    !> Sections that follow each other with a shoulder .0001 off.
    subroutine judge_joins()
        character(*), parameter :: deck = 'TITLE,JOIN'//nl//'CLOSE'//nl// &
            'LINE,UCL,SIDE,10.'//nl//'LINE,LCL,SIDE,-10.'//nl//'LINE,MHB,SIDE,0.'//nl// &
            'LINE,MHB,PLAN,10.'//nl//'LINE,USH,SIDE,8.'//nl//'LINE,US2,SIDE,8.0001'//nl// &
            'LINE,USH,PLAN,6.'//nl//'LINE,US2,PLAN,6.'//nl//'LINE,LSH,SIDE,-8.'//nl// &
            'LINE,LSH,PLAN,6.'//nl//'SECTION,FORE,UCL,USH,MHB,0.,999.999,0.,20.'//nl// &
            'SECTION,AFT,UCL,US2,MHB,0.,999.999,20.,50.'//nl// &
            'SECTION,LOWER,LCL,LSH,MHB,0.,999.999,0.,50.'//nl
        type(skin_model_type) :: model
        type(body_type) :: body
        body = text_body(deck)
        model = skin_of(body, 1.0e-3_dp, .true.)
        call tap%ok(size(model%shells) == 1 .and. all(model%shells%is_closed), &
            'a miss within a quarter of the tolerance is sewn')
        call tap%ok(maxval(model%faces%error) > 2.0e-5_dp .and. &
            maxval(model%faces%error) < 1.0e-3_dp, 'and told in the error')
        call tap%ok(furthest(body, model, 9) < 1.0e-3_dp, 'which keeps the tolerance')
        model = skin_of(body, 1.0e-4_dp, .true.)
        call tap%ok(size(model%shells) == 2 .and. all(model%shells%is_closed), &
            'a greater one is a step')
    end subroutine judge_joins

    !> A body of elliptic sections whose height runs out: the halves meet in a line.
    subroutine judge_ends_in_lines()
        character(*), parameter :: deck = 'TITLE,STERN'//nl//'CLOSE'//nl// &
            'LINE,UCL,SIDE'//nl//'STRAIGHT,0.,10.,30.,0.'//nl// &
            'LINE,LCL,SIDE'//nl//'STRAIGHT,0.,-10.,30.,0.'//nl//'LINE,MHB,SIDE,0.'//nl// &
            'LINE,MHB,PLAN,10.'//nl//'LINE,USH,SIDE'//nl//'STRAIGHT,0.,8.,30.,0.'//nl// &
            'LINE,USH,PLAN,6.'//nl//'LINE,LSH,SIDE'//nl//'STRAIGHT,0.,-8.,30.,0.'//nl// &
            'LINE,LSH,PLAN,6.'//nl//'SECTION,UPPER,UCL,USH,MHB,0.,999.999'//nl// &
            'SECTION,LOWER,LCL,LSH,MHB,0.,999.999'//nl
        type(skin_model_type) :: model
        integer :: i
        model = skin_of(text_body(deck), 1.0e-6_dp, .true.)
        call tap%ok(size(model%shells) == 1 .and. all(model%shells%is_closed), &
            'a body that ends in a line: one solid')
        call tap%ok(count(model%faces%is_flat) == 1, 'with one cap, at its other end')
        call tap%ok(count([(model%edges(i)%curve%degree == 1 .and. &
            all(model%edges(i)%curve%pole(1, :) == 30.0_dp), i=1, size(model%edges))]) == 2, &
            'the line is two straight edges')
        call tap%near(skin_volume(model), 0.5_dp*acos(-1.0_dp)*100.0_dp*30.0_dp, 1.0e-9_dp, &
            'its volume is half of the cylinder''s')
    end subroutine judge_ends_in_lines

    !> One half of a body, which the deck says to close.
    subroutine judge_walls()
        type(skin_model_type) :: model
        integer, allocatable :: wall(:)
        integer :: i
        model = skin_of(text_body('TITLE,SIDE'//nl//'SYMMETRY,NO'//nl//'CLOSE'//nl//bullet// &
            'SECTION,UPPER,UCL,USH,MHB,0.,999.999'//nl//'SECTION,LOWER,LCL,LSH,MHB,0.,999.999'// &
            nl), 1.0e-3_dp, .true.)
        wall = pack([(i, i=1, size(model%faces))], [(index(model%faces(i)%name, 'WALL') == 1, &
            i=1, size(model%faces))])
        call tap%ok(size(model%shells) == 1 .and. all(model%shells%is_closed), &
            'one side, closed: one solid')
        call tap%ok(is_chained(model), 'its sides follow each other')
        call tap%ok(size(wall) == 1, 'it has a wall')
        call tap%ok(all(model%faces(wall(1))%normal == [0.0_dp, -1.0_dp, 0.0_dp]) .and. &
            all(model%faces(wall(1))%origin == 0.0_dp), 'in BL 0, which looks to port')
        call tap%near(skin_volume(model), acos(-1.0_dp)*50.0_dp*100.0_dp/3.0_dp, 1.0e-6_dp, &
            'its volume is that of half of half a spheroid')
    end subroutine judge_walls

    !> Skins that are open though a solid was asked for.
    subroutine judge_open()
        type(skin_model_type) :: model
        model = skin_of(deck_body('nose'), 1.0e-3_dp, .true.)
        call tap%ok(size(model%shells) == 1 .and. .not. any(model%shells%is_closed) .and. &
            .not. any(model%faces%is_flat), 'the nose is an open skin, without caps')
        model = skin_of(text_body('TITLE,OPEN'//nl//bullet//'SECTION,UPPER,UCL,USH,MHB,0.,999.999' &
            //nl//'SECTION,LOWER,LCL,LSH,MHB,0.,999.999'//nl), 1.0e-3_dp, .true.)
        call tap%ok(.not. any(model%faces%is_flat), 'no caps where the deck does not say CLOSE')
        call tap%ok(size(model%shells) == 1 .and. size(model%shells(1)%faces) == 4, &
            'but its halves hang together')
        model = skin_of(text_body('TITLE,UPPER'//nl//'CLOSE'//nl//bullet// &
            'SECTION,UPPER,UCL,USH,MHB,0.,999.999'//nl), 1.0e-3_dp, .true.)
        call tap%ok(size(model%faces) == 2 .and. .not. any(model%shells%is_closed), &
            'an upper half alone is open')
    end subroutine judge_open

    !> Bodies with nothing and with gaps.
    subroutine judge_bad()
        type(skin_model_type) :: model
        type(body_type) :: body
        real(dp) :: least, most
        integer :: i

        model = skin_of(text_body('TITLE,NONE'//nl//bullet), 1.0e-3_dp, .true.)
        call tap%ok(size(model%faces) == 0 .and. size(model%shells) == 0 .and. &
            size(model%vertices) == 0, 'a body without sections has no faces')
        body = deck_body('ellipsoid')
        body%sections%to = body%sections%from
        model = skin_of(body, 1.0e-3_dp, .true.)
        call tap%ok(size(model%faces) == 0, 'nor has one of no length')
        body = text_body('TITLE,GAP'//nl//'CLOSE'//nl//'LINE,UCL,SIDE,10.'//nl// &
            'LINE,MHB,SIDE,0.'//nl//'LINE,MHB,PLAN,10.'//nl//'LINE,USH,SIDE'//nl// &
            'STRAIGHT,0.,6.,50.,10.2'//nl//'LINE,USH,PLAN'//nl//'STRAIGHT,0.,8.,50.,9.5'//nl// &
            'SECTION,UPPER,UCL,USH,MHB,0.,999.999,0.,50.'//nl)
        model = skin_of(body, 1.0e-3_dp, .true.)
        least = minval([(model%vertices(i)%at(1), i=1, size(model%vertices))])
        most = maxval([(model%vertices(i)%at(1), i=1, size(model%vertices))])
        call tap%ok(size(model%faces) == 2 .and. least == 0.0_dp .and. most < 47.7_dp &
            .and. most > 47.4_dp, 'where the conic is lost the skin ends a little before')
    end subroutine judge_bad

end program test_shell_build
