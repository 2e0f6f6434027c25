!> Cuts of panels: outlines, their order, images of symmetric bodies.
program test_panel
    use base_error, only: error_type
    use base_kinds, only: dp
    use cut_outline, only: cut_type
    use cut_panel, only: cut_panels
    use cut_plane, only: buttock_plane, plane_through, plane_type, waterline_plane
    use cut_request, only: request_type
    use support_saddle, only: saddle
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(request_type) :: request
    type(error_type), allocatable :: error
    type(cut_type) :: cut

    request%plane = waterline_plane(1.0_dp)
    call cut_panels([saddle()], 2, .true., request, cut, error)
    call tap%ok(size(cut%patched) == 1, 'a waterline cuts the half that is there')
    associate (points => cut%patched(1)%points)
        call tap%ok(size(points) == 25 .and. all(points%section == 3), &
            'points count on from the sections')
        call tap%near(points(1)%at(1), 2.5_dp, 1.0e-12_dp, 'it begins at its foremost end')
        call tap%near(cut%off_plane, 0.0_dp, 1.0e-14_dp, 'within rounding of the plane')
    end associate
    cut = cut_type()
    request%plane = buttock_plane(-5.0_dp)
    call cut_panels([saddle()], 2, .true., request, cut, error)
    call tap%ok(size(cut%patched) == 1, 'a buttock to port cuts the image')
    call tap%near(cut%patched(1)%points(25)%at(3), 2.0_dp, 1.0e-13_dp, 'where it is')
    call tap%ok(cut%patched(1)%points(1)%normal(3) > 0.0_dp, 'with the same side outside')
    cut = cut_type()
    call plane_through([5.0_dp, 0.0_dp, 0.0_dp], [1.0_dp, 0.1_dp, 0.0_dp], request%plane, error)
    call cut_panels([saddle()], 2, .true., request, cut, error)
    call tap%ok(size(cut%patched) == 2, 'a plane across BL 0 at an angle cuts both')
    cut = cut_type()
    call cut_panels([saddle()], 2, .false., request, cut, error)
    call tap%ok(size(cut%patched) == 1, 'of a body of one side it cuts that')
    call tap%finish()
end program test_panel
