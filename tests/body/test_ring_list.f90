!> Meetings, loose ends and stretches grow from stretch to stretch.
program test_ring_list
    use base_kinds, only: dp
    use body_ring_list, only: add_loose, add_meeting, add_stretch, closure, is_broken, &
        loose_end_type, meeting_type, ring_type, sort_meetings, stretch_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(ring_type) :: ring

    allocate (ring%meetings(0), ring%loose(0), ring%stretches(0))
    call add_meeting(meeting([3, 0], 0.0_dp, 1.0_dp, 0.5_dp), ring%meetings)
    call add_meeting(meeting([3, 0], 1.0_dp, 2.0_dp, 0.7_dp), ring%meetings)
    call add_meeting(meeting([3, 0], 2.0_dp, 3.0_dp, 0.6_dp), ring%meetings)
    call tap%ok(size(ring%meetings) == 1, 'a meeting that goes on is one')
    call tap%ok(ring%meetings(1)%from == 0.0_dp .and. ring%meetings(1)%to == 3.0_dp, 'that long')
    call tap%ok(ring%meetings(1)%break == 0.7_dp .and. ring%meetings(1)%sta == 1.5_dp, &
        'with the largest break of all')
    call add_meeting(meeting([3, 0], 4.0_dp, 5.0_dp, 0.1_dp), ring%meetings)
    call add_meeting(meeting([2, 3], 4.0_dp, 5.0_dp, 0.001_dp), ring%meetings)
    call add_meeting(meeting([2, 0], 0.0_dp, 5.0_dp, 0.0_dp), ring%meetings)
    call add_meeting(meeting([1, 4], 0.0_dp, 5.0_dp, 0.0_dp), ring%meetings)
    call tap%ok(size(ring%meetings) == 5, 'one behind a gap is another, as are other ends')
    call sort_meetings(ring%meetings)
    call tap%ok(all(ring%meetings%end(1) == [1, 2, 2, 3, 3]), 'they are sorted by ends')
    call tap%ok(all(ring%meetings%end(2) == [4, 3, 0, 0, 0]), 'the mirror image last')
    call tap%ok(ring%meetings(4)%from < ring%meetings(5)%from, 'then by stations')
    call tap%ok(all(is_broken(ring%meetings) .eqv. [.false., .false., .false., .true., .true.]), &
        'a hundredth of a degree is a break')

    call add_loose(loose_end_type(2, 4, 0.0_dp, 1.0_dp, [0.0_dp, 0.3_dp], 0.1_dp), ring%loose)
    call add_loose(loose_end_type(2, 4, 1.0_dp, 2.0_dp, [0.4_dp, 0.3_dp], 1.1_dp), ring%loose)
    call add_loose(loose_end_type(2, 4, 2.0_dp, 3.0_dp, [0.0_dp, 0.4_dp], 2.1_dp), ring%loose)
    call tap%ok(size(ring%loose) == 1 .and. ring%loose(1)%to == 3.0_dp, 'so do loose ends')
    call tap%ok(ring%loose(1)%gap(1) == 0.4_dp .and. ring%loose(1)%sta == 1.1_dp, &
        'with the largest gap')
    call add_loose(loose_end_type(2, 0, 3.0_dp, 4.0_dp, [0.0_dp, 0.0_dp], 3.0_dp), ring%loose)
    call tap%ok(size(ring%loose) == 2, 'another next end begins another')

    call add_stretch(stretch_type(closure%round, 0.0_dp, 1.0_dp), ring%stretches)
    call add_stretch(stretch_type(closure%round, 1.0_dp, 2.0_dp), ring%stretches)
    call add_stretch(stretch_type(closure%open, 2.0_dp, 3.0_dp), ring%stretches)
    call add_stretch(stretch_type(closure%open, 4.0_dp, 5.0_dp), ring%stretches)
    call tap%ok(size(ring%stretches) == 3, 'stretches of one closure are one, unless apart')
    call tap%ok(ring%stretches(1)%to == 2.0_dp, 'and as long')
    call tap%finish()

contains

    !> A meeting whose largest break is in the middle.
    pure type(meeting_type) function meeting(ends, from, to, break)
        integer, intent(in) :: ends(2)
        real(dp), intent(in) :: from, to, break
        meeting = meeting_type(ends, from, to, break, 0.5_dp*(from + to))
    end function meeting

end program test_ring_list
