!> Patches on a sphere, a cylinder and a cone: sides cut by planes, and sides tangent to the skin,
!> against the normals of these surfaces; and what is said of patches that can't be.
program test_tangent_patches
    use api_computed_body, only: computed_body_type, cut_body
    use base_constants, only: degrees
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use body_panel, only: panel_type
    use deck_job, only: job_type
    use geom_bspline_surface, only: surface_jet
    use support_faults, only: said
    use support_job_deck, only: job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    !> The upper starboard quarter of the sphere of radius 50 about STA 50.
    character(*), parameter :: ball = 'LINE,UCL,SIDE|CIRCLE,0,0,10,30,50,50|'// &
        'CIRCLE,50,50,90,30,100,0|LINE,MHB,SIDE,0.|LINE,MHB,PLAN|'// &
        '0,0,999.999,50,50,100,0,999.999|LINE,USH,SIDE|0,0,999.999,20,32,50,40,0|'// &
        '50,40,0,90,24,100,0,999.999|LINE,USH,PLAN|0,0,999.999,20,24,50,30,0|'// &
        '50,30,0,90,18,100,0,999.999|SECTION,UPPER,UCL,USH,MHB,0,999.999|'// &
        'POINTS,NUMBER,9|WATERLN,20,,,,KEEL|BUTTOCK,10,,,,RIDGE|'// &
        'PLANE,65,20,30,1,-.25,.125,,,,TILT|STATION,50|'
    !> The upper starboard quarter of the cylinder of radius 10 about the axis of STA.
    character(*), parameter :: pipe = 'LINE,UCL,SIDE|STRAIGHT,0,10,40,10|LINE,MHB,SIDE,0.|'// &
        'LINE,MHB,PLAN|STRAIGHT,0,10,40,10|LINE,SHO,SIDE|STRAIGHT,0,8,40,8|LINE,SHO,PLAN|'// &
        'STRAIGHT,0,6,40,6|SECTION,TOP,UCL,SHO,MHB,0,999.999|'// &
        'POINTS,NUMBER,9|WATERLN,6,,,,LOW|BUTTOCK,5,,,,HIGH|STATION,5|'
    !> A rhombus in WL 30 and lines that leave it level and then rise.
    character(*), parameter :: flat = 'LINE,L1,SIDE,30|LINE,L1,PLAN|STRAIGHT,0,0,10,5|'// &
        'LINE,L2,SIDE,30|LINE,L2,PLAN|STRAIGHT,10,5,20,0|LINE,L3,SIDE,30|LINE,L3,PLAN|'// &
        'STRAIGHT,0,0,10,-5|LINE,L4,SIDE,30|LINE,L4,PLAN|STRAIGHT,10,-5,20,0|'// &
        'LINE,M1,SIDE|10,30,0,15,30.5,20,32,.4|LINE,M1,PLAN|STRAIGHT,10,5,20,10|'// &
        'LINE,M2,SIDE|20,30,0,25,30.5,30,32,.4|LINE,M2,PLAN|STRAIGHT,20,0,30,5|'// &
        'LINE,M3,SIDE|STRAIGHT,20,32,30,32|LINE,M3,PLAN|STRAIGHT,20,10,30,5|'
    type(tap_type) :: tap
    type(computed_body_type) :: it
    type(fault_list_type) :: faults

    call prove_sphere()
    call prove_cylinder()
    call prove_neighbours()
    call prove_faults()
    call tap%finish()

contains

    !> Sides of every kind of plane on a sphere.
    subroutine prove_sphere()
        call build(ball//'PATCH,P,30,RIDGE,70,KEEL,,,,TANGENT1,TANGENT2,TANGENT3,TANGENT4')
        call tap%same(said(faults), '', 'a patch between two stations, a buttock and a waterline')
        if (size(it%panels) /= 1) return
        ! Radius 50 about (50, 0, 0): at STA 30 and BL 10 WL is sqrt(2500 - 400 - 100).
        call prove_corner('fore and up', 1, [30.0_dp, 10.0_dp, sqrt(2000.0_dp)])
        call prove_corner('aft and up', 2, [70.0_dp, 10.0_dp, sqrt(2000.0_dp)])
        call prove_corner('aft and down', 3, [70.0_dp, sqrt(1700.0_dp), 20.0_dp])
        call prove_corner('fore and down', 4, [30.0_dp, sqrt(1700.0_dp), 20.0_dp])
        call prove_normals('sphere', [1, 2, 3, 4], 2.0e-5_dp)
        call build(ball//'PATCH,P,TILT,70,KEEL,,,,TANGENT1')
        call tap%has(said(faults), 'SIDE4 is missing', 'three sides are too few')
        call build(ball//'PATCH,P,RIDGE,TILT,KEEL,30.,,,,TANGENT1,TANGENT2,TANGENT3,TANGENT4')
        call tap%same(said(faults), '', 'a patch with a side that a tilted plane cuts')
        if (size(it%panels) == 1) call prove_normals('sphere', [1, 2, 3, 4], 2.0e-5_dp)
    end subroutine prove_sphere

    !> On a cylinder, FLAT too, and with sides named in either way.
    subroutine prove_cylinder()
        call build(pipe//'PATCH,P,12,HIGH,25,LOW,FLAT,,,TANGENT1,TANGENT2,TANGENT3,TANGENT4')
        call tap%same(said(faults), '', 'a patch on a cylinder')
        if (size(it%panels) == 1) call prove_normals('cylinder', [1, 2, 3, 4], 2.0e-5_dp)
        call build(pipe//'PATCH,P,12,LOW,25,HIGH,,,,TANGENT1,TANGENT4')
        call tap%has(said(faults), 'patch P faces the other way than the skin beside it; name '// &
            'its sides the other way round', 'sides named clockwise are warned of')
        if (size(it%panels) == 1) call prove_normals('cylinder', [1, 4], 2.0e-5_dp)
        ! The line SHO lies on the skin; stations between it and a cut end where they meet.
        call build(pipe//'PATCH,P,12,SHO,25,LOW,,,,TANGENT2')
        call tap%same(said(faults), '', 'a line on the skin is a side')
        if (size(it%panels) /= 1) return
        call prove_corner('on the line', 2, [25.0_dp, 6.0_dp, 8.0_dp])
        call prove_normals('cylinder', [2], 2.0e-5_dp)
    end subroutine prove_cylinder

    !> Beside another patch, and beside its own image.
    subroutine prove_neighbours()
        real(dp) :: uv(2), at(3), u(3), v(3), off
        integer :: i

        call build(pipe//'PATCH,A,5,HIGH,20,LOW,,,,TANGENT1,TANGENT2,TANGENT3,TANGENT4|'// &
            'PATCH,B,20,HIGH,30,LOW,,,,TANGENT1')
        call tap%ok(size(it%panels) == 2, 'two patches in a row')
        if (size(it%panels) == 2) call tap%ok(it%panels(2)%joint(1)%name == 'TOP', &
            'the skin comes before a patch')
        call build(pipe//flat//'PATCH,A,L3,L4,L2,L1|PATCH,B,L2,M2,M3,M1,,,,TANGENT1')
        call tap%same(said(faults), '', 'a patch beside one off the skin')
        if (size(it%panels) == 2) then
            call tap%ok(it%panels(2)%joint(1)%name == 'A', 'is tangent to that')
            it%panels = it%panels(2:)
            call prove_way('its normals are upright along it', 1, [0.0_dp, 0.0_dp, 1.0_dp])
        end if
        call build(pipe//'LINE,K1,SIDE,30|LINE,K2,SIDE|0,30,0,5,29.75,10,29,-.2|LINE,K2,PLAN|'// &
            'STRAIGHT,0,0,10,5|LINE,K3,SIDE|10,29,.2,15,29.75,20,30,0|LINE,K3,PLAN|'// &
            'STRAIGHT,10,5,20,0|PATCH,ROOF,K1,K3,POINT,K2,,,,TANGENT1')
        call tap%same(said(faults), '', 'a patch with a side in BL 0')
        if (size(it%panels) /= 1) return
        call tap%ok(it%panels(1)%joint(1)%name == 'MIRROR', 'is smooth with its image')
        call prove_way('its normals are upright there', 1, [0.0_dp, 0.0_dp, 1.0_dp])
        off = 0.0_dp
        do i = 0, 20
            uv = place(1, real(i, dp)/20.0_dp)
            call surface_jet(it%panels(1)%surface, uv(1), uv(2), at, u, v)
            off = max(off, abs(at(2)), abs(at(3) - 30.0_dp))
        end do
        call tap%near(off, 0.0_dp, 1.0e-14_dp, 'the side is kept')
    end subroutine prove_neighbours

    !> What can't be.
    subroutine prove_faults()
        call wrong(ball//'PATCH,P,30,70,RIDGE,KEEL', 'are both no lines', 'two stations in a row')
        call wrong(ball//'PATCH,P,TILT,KEEL,RIDGE,30', 'do not meet: the gap is', &
            'sides that do not meet')
        call wrong(ball//'PATCH,P,RIDGE,30,TILT,KEEL', 'go round in the order', 'sides in disorder')
        call wrong(ball//'PATCH,P,30,RIGE,70,KEEL', 'there is no LINE RIGE, and no cut of that '// &
            'name, on the cards before; did you mean RIDGE?', 'a cut misspelt')
        call wrong(ball//'WATERLN,60,,,,SKY|PATCH,P,30,SKY,70,KEEL', &
            'side 2 (cut SKY) meets no section', 'a cut that misses the body')
        call wrong(ball//'PATCH,P,30,RIDGE,130,KEEL', &
            'side 3 (station 130.) meets no section', 'a station beyond the body')
        call wrong(pipe//'LINE,FAR,SIDE|STRAIGHT,0,30,40,30|PATCH,P,5,HIGH,20,FAR', &
            'do not meet: the gap is', 'a line off the skin')
        call wrong(pipe//'LINE,OUT,SIDE|STRAIGHT,5,6,20,6|LINE,OUT,PLAN|5,8,1,12,12,20,8,-1|'// &
            'PATCH,P,5,HIGH,20,OUT,,,,TANGENT4', 'TANGENT4: side 4 is not on the skin', &
            'a side without skin')
        call wrong(pipe//'LINE,OUT,SIDE|STRAIGHT,5,6,20,6|LINE,OUT,PLAN|5,8,1,12,12,20,8,-1|'// &
            'PATCH,P,5,HIGH,20,OUT,,,,TANGENT1', 'TANGENT1: side 4 begins at an angle of', &
            'a side that leaves the skin')
        call wrong(ball//'PATCH,P,30,RIDGE,70,KEEL,,60.,65.', 'not between FROM and TO', &
            'corners beyond FROM')
    end subroutine prove_faults

    !> Builds a body.
    subroutine build(deck)
        character(*), intent(in) :: deck !! cards with | between them
        type(job_type) :: job
        type(computed_body_type) :: fresh
        call job_of(deck, job, faults)
        it = fresh
        allocate (it%panels(0))
        if (faults%has_errors(0)) return
        deallocate (it%panels)
        call cut_body(job, 1, it, faults)
    end subroutine build

    !> What is said of a deck that makes no panel.
    subroutine wrong(deck, words, name)
        character(*), intent(in) :: deck    !! cards with | between them
        character(*), intent(in) :: words   !! in what is said
        character(*), intent(in) :: name    !! of the check
        call build(deck)
        call tap%has(said(faults), words, name)
        call tap%ok(size(it%panels) == 0, name//' make no panel')
    end subroutine wrong

    !> A corner of the patch against the point that planes and surface have in common.
    subroutine prove_corner(name, number, wanted)
        character(*), intent(in) :: name        !! which
        integer, intent(in) :: number           !! 1 to 4
        real(dp), intent(in) :: wanted(3)       !! STA, BL, WL
        real(dp) :: at(3), u(3), v(3), uv(2)
        uv = place(number, 1.0_dp)
        call surface_jet(it%panels(1)%surface, uv(1), uv(2), at, u, v)
        call tap%near(norm2(at - wanted), 0.0_dp, 1.0e-8_dp, 'the corner '//name)
    end subroutine prove_corner

    !> Points and normals along sides against those of the surface.
    subroutine prove_normals(surface, sides, most)
        character(*), intent(in) :: surface !! sphere or cylinder
        integer, intent(in) :: sides(:)     !! which
        real(dp), intent(in) :: most        !! degrees
        real(dp) :: at(3), u(3), v(3), n(3), wanted(3), uv(2), angle, off
        integer :: i, k

        do k = 1, size(sides)
            angle = 0.0_dp
            off = 0.0_dp
            do i = 0, 1000
                uv = place(sides(k), real(i, dp)/1000.0_dp)
                call surface_jet(it%panels(1)%surface, uv(1), uv(2), at, u, v)
                n = [u(2)*v(3) - u(3)*v(2), u(3)*v(1) - u(1)*v(3), u(1)*v(2) - u(2)*v(1)]
                if (surface == 'sphere') then
                    wanted = (at - [50.0_dp, 0.0_dp, 0.0_dp])/50.0_dp
                else
                    wanted = [0.0_dp, at(2:)]/10.0_dp
                end if
                off = max(off, abs(norm2(wanted) - 1.0_dp))
                angle = max(angle, degrees*asin(norm2(n/norm2(n)*dot_product(wanted, n/norm2(n)) &
                    - wanted)))
            end do
            call tap%near(off, 0.0_dp, 2.0e-9_dp, 'side '//to_text(sides(k))// &
                ' is on the '//surface)
            call tap%near(angle, 0.0_dp, most, 'and has its normals, within '//to_text(20)// &
                ' millionths of a degree')
            call tap%ok(it%panels(1)%joint(sides(k))%angle <= most .and. &
                it%panels(1)%joint(sides(k))%name /= '', 'as the joint says')
        end do
    end subroutine prove_normals

    !> The normals along a side against one direction.
    subroutine prove_way(name, number, wanted)
        character(*), intent(in) :: name        !! of the check
        integer, intent(in) :: number           !! 1 to 4
        real(dp), intent(in) :: wanted(3)       !! of unit length
        real(dp) :: uv(2), at(3), u(3), v(3), n(3), off
        integer :: i
        off = 0.0_dp
        do i = 1, 99
            uv = place(number, real(i, dp)/100.0_dp)
            call surface_jet(it%panels(1)%surface, uv(1), uv(2), at, u, v)
            n = [u(2)*v(3) - u(3)*v(2), u(3)*v(1) - u(1)*v(3), u(1)*v(2) - u(2)*v(1)]
            off = max(off, norm2(n/norm2(n) - wanted))
        end do
        call tap%near(off, 0.0_dp, 1.0e-9_dp, name)
    end subroutine prove_way

    !> The parameters of a place on a side.
    function place(number, t) result(uv)
        integer, intent(in) :: number   !! 1 to 4
        real(dp), intent(in) :: t       !! 0 to 1
        real(dp) :: uv(2)
        real(dp) :: corner(2, 5)
        corner = reshape([0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, &
            0.0_dp], [2, 5])
        uv = (1.0_dp - t)*corner(:, number) + t*corner(:, number + 1)
    end function place

end program test_tangent_patches
