!> Names of the files of pictures of cuts.
program test_picture_name
    use app_picture_name, only: cut_name
    use base_kinds, only: dp
    use cut_outline, only: cut_type
    use cut_plane, only: station_plane, waterline_plane
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(cut_type) :: cut

    cut%plane = station_plane(20.0_dp)
    call tap%same(cut_name(1, cut), 'cut-01-station-20', 'a station')
    cut%plane = waterline_plane(-4.5_dp)
    cut%name = 'Floor/2'
    call tap%same(cut_name(112, cut), 'cut-112-waterline-minus-4.5-floor-2', &
        'a waterline below zero, with a name')
    call tap%finish()

end program test_picture_name
