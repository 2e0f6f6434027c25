!> Apex, axis and steepness of sharp noses.
program test_nose_cone
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_line, only: line_type
    use body_nose_cone, only: cone_type, find_cone, offset_at
    use deck_job, only: view
    use geom_arc, only: end_type
    use geom_jet, only: jet_type
    use support_bodies, only: conic_view, constant_view, control_line, straight_view, upright
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: apex(2) = [-4.0_dp, 3.0_dp], flat(2) = [-4.0_dp, 0.0_dp], &
        gap = 1.0e-3_dp
    type(tap_type) :: tap
    type(line_type) :: top, wide, low, late
    type(cone_type) :: cone
    type(error_type), allocatable :: error
    type(jet_type) :: offset
    logical :: is_mine(4), is_vertical

    top = control_line('TOP', straight_view(apex, [6.0_dp, 8.0_dp]), constant_view(0.0_dp))
    low = control_line('LOW', straight_view(apex, [6.0_dp, 2.0_dp]), constant_view(0.0_dp))
    wide = control_line('WIDE', constant_view(3.0_dp), straight_view(flat, [4.0_dp, 2.0_dp]))
    late = control_line('LATE', straight_view([0.0_dp, 9.0_dp], [9.0_dp, 9.0_dp]), &
        constant_view(5.0_dp))

    call find_cone([top, wide, low, late], [.true., .true., .true., .true.], gap, cone, is_mine, &
        error)
    call tap%ok(.not. allocated(error), 'a point nose is one')
    call tap%ok(all(cone%apex == apex), 'its apex is where the foremost line begins')
    call tap%ok(all(is_mine .eqv. [.true., .true., .true., .false.]), &
        'lines further aft are none of it')
    call tap%near(cone%axis, 0.2_dp, 1.0e-15_dp, 'the axis is between slopes .5 and -.1')
    call tap%near(cone%steepness, 0.3_dp, 1.0e-15_dp, &
        'off which they are .3, more than .25 in plan')
    call tap%ok(cone%aft == 9.0_dp, 'the lines reach to 9')
    call offset_at(cone, low%side, view%side, 1.0_dp, offset, is_vertical)
    call tap%near(offset%value, -1.5_dp, 1.0e-15_dp, 'offsets are counted from the axis')
    call tap%near(offset%first, -0.3_dp, 1.0e-15_dp, 'slopes too')
    call offset_at(cone, wide%plan, view%plan, 0.0_dp, offset, is_vertical)
    call tap%ok(offset%value == 1.0_dp .and. .not. is_vertical, 'in plan from BL 0')

    call find([top, wide, low], [.true., .false., .false.])
    call tap%ok(error%cause == cause%not_single_valued, 'one line alone has no angle')
    low%plan = constant_view(0.5_dp*gap)
    call find([top, wide, low], [.true., .true., .true.])
    call tap%ok(.not. allocated(error), 'a line may miss the apex by the gap of joints')
    low%plan = constant_view(2.0_dp*gap)
    call find([top, wide, low], [.true., .true., .true.])
    call tap%ok(error%cause == cause%joint_gap, 'no more')
    call find([top, wide, low], [.true., .true., .false.])
    call tap%ok(.not. allocated(error), 'unless nothing stands on it')
    low = control_line('LOW', conic_view(end_type(apex, upright), [0.0_dp, 0.0_dp], &
        end_type([9.0_dp, -1.0_dp], [1.0_dp, 0.0_dp])), constant_view(0.0_dp))
    call find([top, wide, low], [.true., .true., .true.])
    call tap%ok(error%cause == cause%not_single_valued, 'an upright line is no point nose')
    top = control_line('TOP', constant_view(1.0_dp), constant_view(0.0_dp))
    call find([top], [.true.])
    call tap%ok(error%cause == cause%joint_gap, 'constants have no nose')
    call tap%finish()

contains

    !> Finds the cone of some lines.
    subroutine find(lines, is_used)
        type(line_type), intent(in) :: lines(:)
        logical, intent(in) :: is_used(:)
        call find_cone(lines, is_used, gap, cone, is_mine(:size(lines)), error)
    end subroutine find

end program test_nose_cone
