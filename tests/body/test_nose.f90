!> Rounded noses: caps against spheres, upright and sheared, the nose of SAE 700202, lines that are
!> left alone, and noses that can't be rounded.
program test_nose
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_build, only: build_body
    use body_gap, only: section_gaps
    use body_ledger, only: joint_type
    use deck_job, only: job_type
    use geom_arc_point, only: curvature
    use geom_chain, only: chain_type, chain_value
    use geom_place, only: at_start
    use support_job_deck, only: job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: good = 1.0e-12_dp
    !> Straight lines from a point, sine .6 off the axis, and a section on them.
    character(*), parameter :: section = 'SECTION,UP,UCL,USH,MHB,0.,999.999', &
        cone = 'LINE,UCL,SIDE|STRAIGHT,0.,0.,80.,60.|LINE,USH,SIDE|STRAIGHT,0.,0.,80.,48.|'// &
        'LINE,USH,PLAN|STRAIGHT,0.,0.,80.,36.|LINE,MHB,SIDE,0.|LINE,MHB,PLAN|'// &
        'STRAIGHT,0.,0.,80.,60.|', bottom = 'LINE,LCL,SIDE|STRAIGHT,0.,0.,80.,-60.|'
    !> Table 1 of SAE 700202.
    character(*), parameter :: book = 'LINE,MHB,SIDE|-30.,-10.,.114,0.,-7.1,50.,-4.,.0523|'// &
        'LINE,MHB,PLAN|-30.,0.,.577,0.,11.9,50.,21.5,.1405|'// &
        'LINE,LSH,SIDE|-30.,-10.,-.268,0.,-16.,50.,-21.2,-.0697|'// &
        'LINE,LSH,PLAN|-30.,0.,.404,0.,9.,50.,18.2,.1316|'// &
        'LINE,LCL,SIDE|-30.,-10.,-.384,0.,-18.,50.,-24.1,-.0871|'// &
        'SECTION,LOWER,LCL,LSH,MHB,0.,999.999'
    type(tap_type) :: tap
    type(body_type) :: body, sharp
    type(joint_type), allocatable :: joints(:)
    type(fault_list_type) :: faults

    call prove_cone()
    call prove_sheared_cone()
    call prove_book()
    call prove_bystanders()
    call prove_composite()
    call prove_faults()
    call tap%finish()

contains

    !> Half angle of sine .6: with radius 15 the sphere about station 25, from 10 to 16.
    subroutine prove_cone()
        integer :: i
        real(dp) :: x, r, worst

        call build('NOSE,15.|'//cone//bottom//lower())
        call tap%same(words_of(faults), '', 'a cone is rounded')
        call tap%ok(body%has_nose .and. body%nose_radius == 15.0_dp, 'which the body knows')
        call tap%ok(all(body%sections%from == 10.0_dp), 'it begins at the pole of the sphere')
        worst = 0.0_dp
        do i = 0, 280
            x = 10.0_dp + 0.25_dp*real(i, dp)
            r = merge(sqrt(max(225.0_dp - (x - 25.0_dp)**2, 0.0_dp)), 0.75_dp*x, x < 16.0_dp)
            worst = max(worst, abs(chain_value(body%lines(1)%side, x) - r), &
                abs(chain_value(body%lines(2)%side, x) - 0.8_dp*r), &
                abs(chain_value(body%lines(2)%plan, x) - 0.6_dp*r), &
                abs(chain_value(body%lines(3)%plan, x) - r), &
                abs(chain_value(body%lines(3)%side, x)), &
                abs(chain_value(body%lines(4)%side, x) + r))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-13_dp, 'lines are the sphere, then the cone')
        call tap%ok(body%lines(3)%side%is_constant, 'a constant on the axis stays one')
        call tap%ok(all(joints%sta == 16.0_dp) .and. size(joints) == 5, &
            'joints of the caps are in the ledger')
        call tap%ok(all(joints%line == [character(8) :: 'UCL', 'USH', 'USH', 'MHB', 'LCL']), &
            'in the order of the lines')
    end subroutine prove_cone

    !> The cone with all WL raised by .2 of the station less 3: the sphere is raised alike.
    subroutine prove_sheared_cone()
        integer :: i
        real(dp) :: x, r, worst

        call build('NOSE,15.|LINE,UCL,SIDE|STRAIGHT,-40.,7.,40.,83.|LINE,USH,SIDE|'// &
            'STRAIGHT,-40.,7.,40.,71.|LINE,USH,PLAN|STRAIGHT,-40.,0.,40.,36.|LINE,MHB,SIDE|'// &
            'STRAIGHT,-40.,7.,40.,23.|LINE,MHB,PLAN|STRAIGHT,-40.,0.,40.,60.|'// &
            'LINE,LCL,SIDE|STRAIGHT,-40.,7.,40.,-37.|'//lower())
        call tap%same(words_of(faults), '', 'a cone with a rising axis is rounded')
        worst = 0.0_dp
        do i = 0, 280
            x = 10.0_dp + 0.25_dp*real(i, dp)
            r = merge(sqrt(max(225.0_dp - (x - 25.0_dp)**2, 0.0_dp)), 0.75_dp*x, x < 16.0_dp)
            worst = max(worst, &
                abs(chain_value(body%lines(1)%side, x - 40.0_dp) - (7.0_dp + 0.2_dp*x + r)), &
                abs(chain_value(body%lines(2)%side, x - 40.0_dp) &
                - (7.0_dp + 0.2_dp*x + 0.8_dp*r)), &
                abs(chain_value(body%lines(2)%plan, x - 40.0_dp) - 0.6_dp*r), &
                abs(chain_value(body%lines(3)%side, x - 40.0_dp) - (7.0_dp + 0.2_dp*x)), &
                abs(chain_value(body%lines(4)%side, x - 40.0_dp) - (7.0_dp + 0.2_dp*x - r)))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-12_dp, 'it is the sphere, sheared')
        call tap%ok(all(body%sections%from == -30.0_dp), 'from its pole on')
    end subroutine prove_sheared_cone

    !> Slopes at the nose: .577 in plan is the steepest, the axis falls by (.114 - .384)/2.
    subroutine prove_book()
        real(dp), parameter :: axis = -0.135_dp, sine = 0.577_dp/sqrt(1.0_dp + 0.577_dp**2), &
            tip = -30.0_dp + (1.0_dp/sine - 1.0_dp), blend = -30.0_dp + (1.0_dp/sine - sine)
        real(dp) :: height
        integer :: i

        call build(book)
        sharp = body
        call build('NOSE,1.|'//book)
        call tap%same(words_of(faults), '', 'the nose of the book is rounded')
        call tap%near(body%sections(1)%from, tip, good, 'from where a cone of its slope would be')
        call tap%near(body%lines(1)%side%knot(2), blend, good, 'to where it would end')
        height = chain_value(sharp%lines(1)%plan, blend)
        do i = 1, 3
            call tap%near(chain_value(body%lines(i)%side, tip), -10.0_dp + axis*(tip + 30.0_dp), &
                good, 'in side view a line begins on the axis')
            call prove_view(body%lines(i)%side, chain_value(sharp%lines(i)%side, blend) + 10.0_dp &
                - axis*(blend + 30.0_dp), height)
            call tap%near(chain_value(body%lines(i)%side, 20.0_dp), &
                chain_value(sharp%lines(i)%side, 20.0_dp), good, 'further aft it is as it was')
            if (.not. body%lines(i)%has_plan) cycle
            call prove_view(body%lines(i)%plan, chain_value(sharp%lines(i)%plan, blend), height)
            call tap%near(chain_value(body%lines(i)%plan, 20.0_dp), &
                chain_value(sharp%lines(i)%plan, 20.0_dp), good, 'in plan too')
        end do
        call tap%near(maxval(abs(joints%jump%direction)), 0.0_dp, 1.0e-9_dp, 'slopes go on')
        call tap%ok(size(section_gaps(body, body%sections(1))) == 0, 'the section is everywhere')
    end subroutine prove_book

    !> A cap of the book begins upright and curved by 1 (offset/height)**2.
    subroutine prove_view(view, offset, height)
        type(chain_type), intent(in) :: view
        real(dp), intent(in) :: offset, height

        call tap%ok(view%stroke(1)%arc%start_tangent(1) == 0.0_dp .and. &
            view%stroke(1)%arc%start_tangent(2)*offset > 0.0_dp, 'its cap begins upright, outwards')
        call tap%near(curvature(view%stroke(1)%arc, at_start)*(offset/height)**2, &
            -sign(1.0_dp, offset), 1.0e-10_dp, 'with the radius of its share')
    end subroutine prove_view

    !> Lines aft of the cap, lines without sections and angles have no part in it.
    subroutine prove_bystanders()
        call build('NOSE,15.|'//cone//bottom//'LINE,FIN,SIDE|STRAIGHT,16.,20.,80.,90.|'// &
            'LINE,FSH,SIDE|STRAIGHT,16.,15.,80.,80.|LINE,FSH,PLAN,2.|LINE,REF,SIDE|'// &
            'STRAIGHT,-5.,3.,80.,90.|LINE,ANG,ANGLE|STRAIGHT,5.,90.,80.,85.|'// &
            'SECTION,UP,UCL,USH,MHB,0.,ANG|SECTION,FIN,FIN,FSH,UCL,0.,999.999')
        call tap%same(words_of(faults), '', 'lines aft of the cap do no harm')
        call tap%ok(size(body%lines(5)%side%stroke) == 1 .and. body%lines(5)%from == 16.0_dp, &
            'they stay as they are')
        call tap%ok(body%lines(7)%from == -5.0_dp, 'so does a line that no section takes')
        call tap%ok(body%lines(8)%from == 5.0_dp .and. size(body%lines(8)%angle%stroke) == 1, &
            'and an angle')
        call build('NOSE,15.|'//cone(:index(cone, 'LINE,MHB') - 1)//'LINE,MHB,SIDE,0.|LINE,MHB,'// &
            'PLAN|STRAIGHT,0.,0.,80.,60.|LINE,LCL,SIDE,0.|SECTION,LO,LCL,USH,MHB,0.,999.999')
        call tap%same(words_of(faults), '', 'a flat bottom leaves the nose with the axis')
        call tap%ok(size(body%lines(4)%side%stroke) == 2 .and. body%lines(4)%to == 80.0_dp, &
            'off which the constant is rounded')
    end subroutine prove_bystanders

    !> Joints of a line forward of the cap's end go, those aft of it stay.
    subroutine prove_composite()
        call build('NOSE,15.|'//cone//'LINE,LCL,SIDE|STRAIGHT,0.,0.,8.,-6.|'// &
            'STRAIGHT,8.,-6.,40.,-30.|STRAIGHT,40.,-30.,80.,-32.,KNUCKLE|'//lower())
        call tap%same(words_of(faults), '', 'a line of many pieces is rounded')
        call tap%ok(size(joints) == 6, 'a joint within the cap is gone')
        call tap%ok(joints(6)%sta == 40.0_dp .and. joints(6)%is_knuckle .and. &
            joints(5)%sta == 16.0_dp, 'one aft of it stays behind the cap')
        call tap%ok(all(body%lines(4)%side%knot == [10.0_dp, 16.0_dp, 40.0_dp, 80.0_dp]), &
            'so it is in the line')
    end subroutine prove_composite

    !> Noses that stay sharp.
    subroutine prove_faults()
        call refuse('NOSE,76.|'//cone//bottom//lower(), 'the cap would end at station '// &
            '81.066667, but line UCL ends at 80.; the largest radius that fits is 74.99', &
            'a radius too large for the lines')
        call tap%ok(.not. body%has_nose .and. all(body%sections%from == 0.0_dp) .and. &
            size(joints) == 0, 'then the nose is sharp')
        call refuse('NOSE,15.|'//cone//'LINE,LCL,SIDE|STRAIGHT,0.,-1.,80.,-60.|'//lower(), &
            'at station 0. line LCL is at BL 0., WL -1.; all lines that begin there must meet '// &
            'in one point, as UCL does in BL 0, WL 0.', 'a blunt nose')
        call refuse('NOSE,15.|'//cone//'LINE,LCL,SIDE|STRAIGHT,4.,-3.,80.,-60.|'//lower(), &
            'line LCL begins at station 4., forward of 16., where the cap would end; '// &
            'the largest radius that fits is 3.75', 'a line that begins within the cap')
        call refuse('NOSE,15.|'//cone//'LINE,LCL,SIDE|0.,0.,999.999,30.,-20.,60.,-25.,0.|'// &
            lower(), 'line LCL is upright at station 0. and thus round already; take NOSE out, '// &
            'or give the line an end slope', 'a nose that is round')
        call refuse('NOSE,15.|'//cone//'LINE,LCL,SIDE|STRAIGHT,0.,0.,8.,-6.|'// &
            'STRAIGHT,8.,-6.,12.,-1.|STRAIGHT,12.,-1.,80.,-60.|'//lower(), &
            'no cap fits line LCL: in side view its tangent at station 16., where the cap '// &
            'would end, crosses the nose axis aft of the nose at station 10.; the largest '// &
            'radius that fits is ', 'a line too hollow')
        call refuse('NOSE,15.|LINE,A,SIDE|STRAIGHT,0.,0.,9.,9.|LINE,B,SIDE|'// &
            'STRAIGHT,0.,0.,9.,9.|LINE,C,SIDE|STRAIGHT,0.,0.,9.,9.|SECTION,S,A,B,C,0.,999.999', &
            'all lines leave the nose in one direction; slopes that differ there make a nose '// &
            'that can be rounded', 'a nose that is a line')
        call refuse('NOSE,15.|LINE,A,SIDE,1.|LINE,B,SIDE,2.|LINE,C,SIDE,3.|'// &
            'SECTION,S,A,B,C,0.,999.999,0.,10.', 'all lines are constants and meet nowhere; '// &
            'take NOSE out', 'no nose at all')
        call build('NOSE,15.|'//cone)
        call tap%ok(faults%count == 0, 'without sections there is nothing to say')
    end subroutine prove_faults

    !> The deck has a fault on the radius of its first card; a slope break is not of interest.
    subroutine refuse(deck, words, name)
        character(*), intent(in) :: deck, words, name
        character(:), allocatable :: all_words
        call build(deck)
        all_words = words_of(faults)
        call tap%ok(index(all_words, '1:6-8 error: the nose stays sharp: '//words) > 0, &
            name//' is refused')
        if (index(all_words, words) == 0) call tap%note(all_words)
    end subroutine refuse

    !> The upper section and one to the lower centre line.
    function lower()
        character(:), allocatable :: lower
        lower = section//'|SECTION,LO,LCL,USH,MHB,0.,999.999'
    end function lower

    !> Builds the first body of a deck.
    subroutine build(deck)
        character(*), intent(in) :: deck
        type(job_type) :: job
        type(fault_list_type) :: read_faults, none
        call job_of(deck, job, read_faults)
        if (read_faults%has_errors(0)) call tap%note(words_of(read_faults))
        faults = none
        call build_body(job, 1, body, joints, faults)
    end subroutine build

end program test_nose
