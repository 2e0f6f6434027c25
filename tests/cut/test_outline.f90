!> A point of which nothing was said has nothing; lists of cuts.
program test_outline
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use cut_outline, only: cut_at, cut_point_type, cut_type, keep_cuts, note_type, outline_type, &
        piece_type, room_of
    use cut_plane, only: buttock_plane, cut_kind, station_plane
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(cut_point_type) :: point
    type(outline_type) :: outline
    type(piece_type) :: piece
    type(cut_type) :: cut
    type(cut_type), allocatable :: cuts(:)
    real(dp), parameter :: asked(5) = [30.0_dp, 10.0_dp, 30.0_dp, 20.0_dp, 10.0_dp]
    integer :: i, bare

    call tap%ok(.not. (point%has_normal .or. point%has_slope .or. point%has_curvature), &
        'a fresh point has no normal, slope or curvature')
    call tap%ok(.not. outline%is_closed, 'a fresh outline is open')
    call tap%ok(.not. (piece%is_arc .or. piece%is_image), 'a fresh piece is no arc and no image')
    call tap%ok(.not. cut%is_flange_forward, 'a flange is aft where nothing is said')

    allocate (cuts(6))
    do i = 1, 5
        cuts(i)%plane = station_plane(asked(i))
    end do
    cuts(6)%plane = buttock_plane(5.0_dp)
    call tap%ok(all(is_equal(cut_at(cuts, cut_kind%station, 1), [30.0_dp, 10.0_dp, 20.0_dp])), &
        'stations are listed as they come, each once')
    call tap%ok(size(cut_at(cuts, cut_kind%waterline, 3)) == 0, 'waterlines where there are none')

    bare = int(room_of(cuts(2)))
    allocate (cuts(2)%outlines(1), cuts(2)%notes(1))
    allocate (cuts(2)%outlines(1)%points(1000), cuts(2)%outlines(1)%pieces(1))
    cuts(2)%outlines(1)%points%at(1) = 7.0_dp
    cuts(2)%notes(1) = note_type(.true., 'kept')
    cuts(2)%name = 'SECOND'
    cuts(2)%disagreement = 0.5_dp
    cuts(2)%patches = 3
    call tap%ok(int(room_of(cuts(2))) > bare + 1000*8*5, 'a cut takes the room of its points')
    call keep_cuts([.false., .true., .false., .false., .false., .true.], cuts)
    call tap%ok(size(cuts) == 2, 'some of the cuts are kept')
    associate (kept => cuts(1))
        call tap%ok(kept%name == 'SECOND' .and. kept%patches == 3 .and. &
            is_equal(kept%disagreement, 0.5_dp) .and. is_equal(kept%plane%through(1), 10.0_dp), &
            'with what was said of them')
        call tap%ok(size(kept%outlines) == 1 .and. kept%notes(1)%is_error, 'outlines and notes')
        call tap%ok(all(is_equal(kept%outlines(1)%points%at(1), 7.0_dp)), 'and points')
    end associate
    call tap%ok(cuts(2)%plane%kind == cut_kind%buttock, 'in their order')
    call tap%finish()
end program test_outline
