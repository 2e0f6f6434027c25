!> Variants of an ellipsoid against closed forms; variants that miss limits or can't be built.
program test_variant
    use base_constants, only: pi
    use base_kinds, only: dp
    use support_ellipsoid, only: ellipsoid_study, ellipsoid_text
    use support_tap, only: tap_type
    use sweep_record, only: record_type, state
    use sweep_study, only: study_type
    use sweep_variant, only: compute_variant
    implicit none (type, external)

    type(tap_type) :: tap

    call closed_forms()
    call spheroids()
    call limits()
    call varied_questions()
    call faults()
    call tap%finish()

contains

    !> Volume, area, width, height, centroid, clearance of every variant of a grid.
    subroutine closed_forms()
        type(study_type) :: study
        type(record_type) :: record
        real(dp) :: b, c, wrong(6)
        integer :: i

        study = ellipsoid_study(ellipsoid_text('1.25,2.75,4', '1.,2.5,3', &
            'CHECK,POINT,0.,0.,0.,0.,CENTRE|OBJECT,VOLUME,MAX|OBJECT,AREA,SHOW,,3.|'// &
            'OBJECT,WIDTH,SHOW,,3.,.5|OBJECT,HEIGHT,SHOW,,-3.,.5|OBJECT,CENTROID,SHOW|'// &
            'OBJECT,CLEAR,SHOW,,CENTRE'), tap)
        call tap%ok(study%plan%count == 12, 'a grid of 12')
        wrong = 0.0_dp
        do i = 1, study%plan%count
            call compute_variant(study, i, record)
            b = record%value(1)
            c = record%value(2)
            if (record%state /= state%ok) call tap%ok(.false., record%why)
            call worst(wrong(1), record%measure(1), 4.0_dp/3.0_dp*pi*5.0_dp*b*c)
            call worst(wrong(2), record%measure(2), pi*b*c*0.64_dp)
            call worst(wrong(3), record%measure(3), 2.0_dp*b*sqrt(0.64_dp - (0.5_dp/c)**2))
            call worst(wrong(4), record%measure(4), 2.0_dp*c*sqrt(0.64_dp - (0.5_dp/b)**2))
            call worst(wrong(5), 1.0_dp + record%measure(5), 1.0_dp)
            call worst(wrong(6), record%measure(6), min(b, c))
        end do
        call tap%near(wrong(1), 0.0_dp, 1.0e-12_dp, 'volumes are 4/3 pi a b c')
        call tap%near(wrong(2), 0.0_dp, 1.0e-12_dp, 'areas are pi b c (1 - x^2/a^2)')
        call tap%near(wrong(3), 0.0_dp, 1.0e-12_dp, 'widths on a waterline')
        call tap%near(wrong(4), 0.0_dp, 1.0e-12_dp, 'heights on a butt line')
        call tap%near(wrong(5), 0.0_dp, 1.0e-12_dp, 'the centroid is the centre')
        call tap%near(wrong(6), 0.0_dp, 1.0e-9_dp, 'the clearance of the centre is the least '// &
            'half axis')
    end subroutine closed_forms

    !> Keeps the largest relative difference.
    subroutine worst(largest, value, expected)
        real(dp), intent(inout) :: largest
        real(dp), intent(in) :: value, expected
        largest = max(largest, abs(value/expected - 1.0_dp))
    end subroutine worst

    !> Wetted areas of prolate spheroids: 2 pi r^2 (1 + a/(r e) asin e); girths of circles.
    subroutine spheroids()
        type(study_type) :: study
        type(record_type) :: record
        real(dp) :: r, e, wrong(2)
        integer :: i

        study = ellipsoid_study('SWEEP,LIST'//new_line('a')//ellipsoid_text('1.,3.,5', '1.,3.,5', &
            'OBJECT,WETTED,MIN|OBJECT,GIRTH,SHOW,,0.'), tap)
        wrong = 0.0_dp
        do i = 1, study%plan%count
            call compute_variant(study, i, record)
            r = record%value(1)
            e = sqrt(1.0_dp - (r/5.0_dp)**2)
            call worst(wrong(1), record%measure(1), 2.0_dp*pi*r**2*(1.0_dp + 5.0_dp/(r*e)*asin(e)))
            call worst(wrong(2), record%measure(2), 2.0_dp*pi*r)
        end do
        call tap%near(wrong(1), 0.0_dp, 1.0e-10_dp, 'wetted areas of spheroids')
        call tap%near(wrong(2), 0.0_dp, 1.0e-12_dp, 'girths of circles')
    end subroutine spheroids

    subroutine limits()
        type(study_type) :: study
        type(record_type) :: record
        study = ellipsoid_study(ellipsoid_text('1.,3.,3', '1.,3.,2', &
            'CHECK,SPHERE,0.,0.,0.,.5,.75,BALL|OBJECT,VOLUME,MAX|LIMIT,VOLUME,,150.|'// &
            'LIMIT,WIDTH,4.,,0.,0.,FLOOR'), tap)
        call compute_variant(study, 1, record)
        call tap%ok(record%state == state%limit, 'a variant that misses limits is measured')
        call tap%same(record%why, 'clearance BALL 0.5 is below 0.75; FLOOR 2. is below 4.', &
            'and says which')
        call compute_variant(study, 4, record)
        call tap%ok(record%state == state%ok, 'a limit that is just kept is kept')
        call tap%same(record%why, '', 'there is nothing to say')
        call compute_variant(study, 6, record)
        call tap%same(record%why, 'VOLUME 188.495559 is above 150.', 'a greatest value')
        call tap%ok(all(record%has), 'all is measured')
    end subroutine limits

    !> Stations and limits that vary: A = pi b c (1 - x^2/a^2), at the station of the variant.
    subroutine varied_questions()
        type(study_type) :: study
        type(record_type) :: record
        real(dp) :: wrong, area, least
        integer :: i, misjudged

        study = ellipsoid_study('SWEEP,LATIN,25'//new_line('a')//ellipsoid_text('1.,3.', &
            '1.,3.', 'OBJECT,AREA,MAX,,3.|VARY,OF,PLACE,-4.5,4.5|LIMIT,WIDTH,2.,,0.,0.|'// &
            'VARY,FROM,LEAST,1.,7.'), tap)
        wrong = 0.0_dp
        misjudged = 0
        do i = 1, study%plan%count
            call compute_variant(study, i, record)
            area = pi*record%value(1)*record%value(2)*(1.0_dp - (record%value(3)/5.0_dp)**2)
            least = record%value(4)
            call worst(wrong, record%measure(1), area)
            if (record%state == state%limit .neqv. 2.0_dp*record%value(1) < least) &
                misjudged = misjudged + 1
        end do
        call tap%near(wrong, 0.0_dp, 1.0e-5_dp, 'a measure is taken where its card says in '// &
            'the deck of the variant (shoulder points fit eight columns)')
        call tap%ok(misjudged == 0, 'and held against the limit of that deck')
    end subroutine varied_questions

    subroutine faults()
        type(study_type) :: study
        type(record_type) :: record
        study = ellipsoid_study(ellipsoid_text('-1.,1.,3', '1.,3.,2', 'OBJECT,VOLUME,MAX'), tap)
        call compute_variant(study, 3, record)
        call tap%ok(record%state == state%fault .and. .not. record%has(1), &
            'a body without breadth has no volume')
        call tap%ok(index(record%why, 'line ') == 1 .and. index(record%why, 'columns ') > 0, &
            'the row says where: '//record%why)
        study = ellipsoid_study(ellipsoid_text('1.,2.,2', '1.,2.,2', &
            'OBJECT,WIDTH,MAX,,9.,0.,FAR|OBJECT,AREA,SHOW,,0.'), tap)
        call compute_variant(study, 1, record)
        call tap%ok(record%state == state%fault, 'a measure where the body is not')
        call tap%same(record%why, 'FAR: the section at station 9. does not meet waterline 0.', &
            'says so')
        call tap%ok(record%has(2) .and. .not. record%has(1), 'the others are there')
        study = ellipsoid_study(ellipsoid_text('1.,2.,2', '1.,2.,2', &
            'OBJECT,VOLUME,MAX|OBJECT,CENTROID,SHOW|OBJECT,GIRTH,SHOW,,9.'), tap)
        study%image%text(1:5) = '* not'
        call compute_variant(study, 1, record)
        call tap%same(record%why, 'VOLUME: between stations -5. and 0. the section ends at '// &
            'BL 0 but the deck does not say CLOSE; GIRTH: the body has no section at station 9.', &
            'a reason that holds for two measures is said once')
    end subroutine faults

end program test_variant
