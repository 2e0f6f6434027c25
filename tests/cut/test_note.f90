!> Notes of a cut: sections without arcs, sections in the plane, ways that do not agree.
program test_note
    use base_kinds, only: dp
    use body_body, only: body_type, finish_body
    use cut_note, only: note_disagreement, note_sections
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, waterline_plane
    use support_bodies, only: constant_view, control_line, ellipsoid, level, plain_section, &
        straight_view, upright
    use support_cutting, only: by_number, cut_of
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: all_stations(2) = [-100.0_dp, 100.0_dp]
    type(tap_type) :: tap
    type(body_type) :: body
    type(cut_type) :: cut

    body = ellipsoid([5.0_dp, 2.0_dp, 1.0_dp], 0.0_dp, 0.0_dp)
    call note_sections(body, buttock_plane(0.0_dp), all_stations, cut%notes)
    call tap%ok(size(cut%notes) == 0, 'of an ellipsoid there is nothing to say')
    call check_slab()
    call check_gap()
    call check_disagreement()
    call tap%finish()

contains

    !> A flat side at BL 2, from station 0 to 10.
    subroutine check_slab()
        body = body_type()
        allocate (body%lines(0), body%sections(0))
        body%lines = [control_line('LOW', straight_view([0.0_dp, 0.0_dp], [10.0_dp, 0.0_dp]), &
            constant_view(2.0_dp)), control_line('MID', constant_view(1.5_dp), &
                constant_view(2.0_dp)), &
            control_line('HIGH', constant_view(3.0_dp), constant_view(2.0_dp))]
        body%sections = [plain_section('SIDE', [1, 2, 3], upright, upright)]
        call finish_body(body)
        cut = cut_of(body, by_number(buttock_plane(2.0_dp), 3))
        call tap%ok(size(cut%notes) == 1, 'a flat side in the plane is noted')
        if (size(cut%notes) == 1) call tap%same(cut%notes(1)%message, &
            'section SIDE lies in the '// &
            'plane of the cut from station 0. to 10.; it has no outline there, but those of '// &
            'its neighbours', 'with its stations')
        cut = cut_of(body, by_number(waterline_plane(1.0_dp), 3))
        call tap%ok(size(cut%notes) == 0 .and. size(cut%outlines) == 1, &
            'a waterline cuts it in a line')
    end subroutine check_slab

    !> A shoulder line that goes below the keel at station 5.
    subroutine check_gap()
        type(cut_type) :: above

        body%lines(1) = control_line('KEEL', constant_view(0.0_dp), constant_view(0.0_dp))
        body%lines(2) = control_line('SHO', straight_view([0.0_dp, 0.5_dp], [10.0_dp, -0.5_dp]), &
            constant_view(1.9_dp))
        body%sections = [plain_section('S', [1, 2, 3], level, upright)]
        call finish_body(body)
        cut = cut_of(body, by_number(waterline_plane(0.75_dp), 3))
        call tap%ok(size(cut%notes) == 1 .and. cut%notes(1)%is_error, 'a gap is an error')
        call note_sections(body, waterline_plane(3.5_dp), all_stations, above%notes)
        call tap%ok(size(above%notes) == 0, 'not of a plane that passes its lines by')
        call tap%same(cut%notes(1)%message, 'section S does not exist from station 5. to 10.; '// &
            'what is said of its SECTION card says why', 'which says where')
        call tap%near(cut%outlines(1)%points(3)%at(1), 5.0_dp, 1.0e-6_dp, 'the outline ends there')
        body%sections = [body%sections, body%sections]
        body%sections(2)%is_port = .true.
        body%is_symmetric = .false.
        call finish_body(body)
        cut = cut_of(body, by_number(waterline_plane(0.75_dp), 3))
        call tap%ok(size(cut%notes) == 1 .and. size(cut%outlines) == 2, &
            'of a section of both sides it is said once')
    end subroutine check_gap

    !> A disagreement is an error where it is more than rounding.
    subroutine check_disagreement()
        cut = cut_of(ellipsoid([5.0_dp, 2.0_dp, 1.0_dp], 0.0_dp, 0.0_dp), &
            by_number(waterline_plane(0.5_dp), 3))
        call tap%ok(size(cut%notes) == 0, 'ways that agree are not spoken of')
        cut%disagreement = 2.0e-10_dp
        call note_disagreement(cut)
        call tap%ok(size(cut%notes) == 1 .and. cut%notes(1)%is_error, &
            'ways that do not are an error')
    end subroutine check_disagreement

end program test_note
