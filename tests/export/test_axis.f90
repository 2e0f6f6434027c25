!> Tests of the names of axes. Oracle: the true shapes of `cut_plane`, whose unit vectors say along
!> which ordinate u and v run.
program test_axis
    use base_kinds, only: dp
    use cut_plane, only: buttock_plane, plane_type, station_plane, waterline_plane
    use export_axis, only: axis_names
    use export_drawing, only: shape_kind
    use support_tap, only: tap_type
    implicit none (type, external)
    type(tap_type) :: tap
    character(3), parameter :: ordinates(3) = ['STA', 'BL ', 'WL ']

    call check_plane(station_plane(20.0_dp), shape_kind%station, 'station')
    call check_plane(buttock_plane(4.5_dp), shape_kind%buttock, 'buttock')
    call check_plane(waterline_plane(-16.0_dp), shape_kind%waterline, 'waterline')
    call tap%ok(all(axis_names(shape_kind%oblique) == ['BL ', 'V  ']), &
        'an oblique plane has butt lines across and its own way up')
    call tap%ok(all(axis_names(shape_kind%plane) == ['U  ', 'V  ']), &
        'any other plane has axes of its own')
    call tap%ok(all(axis_names(shape_kind%card) == ['X  ', 'Y  ']), &
        'a card of 1970 has X and Y')
    call tap%finish()

contains

    subroutine check_plane(plane, kind, name)
        type(plane_type), intent(in) :: plane   !! of a cut
        integer, intent(in) :: kind             !! of the shape
        character(*), intent(in) :: name        !! of the cut
        character(3) :: names(2)
        names = axis_names(kind)
        call tap%same(names(1), ordinates(maxloc(abs(plane%u), dim=1)), name//': to the right')
        call tap%same(names(2), ordinates(maxloc(abs(plane%v), dim=1)), name//': upwards')
    end subroutine check_plane

end program test_axis
