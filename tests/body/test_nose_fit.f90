!> Which radii fit a nose.
program test_nose_fit
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_line, only: line_type
    use body_nose_cap, only: new_nose, nose_type
    use body_nose_cone, only: cone_type
    use body_nose_fit, only: find_fitting, fit_nose
    use support_bodies, only: constant_view, control_line, straight_view
    use support_tap, only: tap_type
    implicit none (type, external)

    logical, parameter :: yes(2) = .true., first(2) = [.true., .false.]
    type(cone_type), parameter :: cone = cone_type(apex=[0.0_dp, 0.0_dp], axis=0.0_dp, &
        steepness=0.75_dp, aft=80.0_dp)
    type(tap_type) :: tap
    type(line_type) :: lines(2)
    type(nose_type) :: nose
    type(error_type), allocatable :: error

    lines(1) = control_line('TOP', straight_view([0.0_dp, 0.0_dp], [80.0_dp, 60.0_dp]), &
        constant_view(0.0_dp))
    lines(2) = control_line('MHB', constant_view(0.0_dp), &
        straight_view([0.0_dp, 0.0_dp], [40.0_dp, 16.0_dp]))
    call fit_nose(lines, yes, yes, new_nose(cone, 15.0_dp), nose, error)
    call tap%ok(.not. allocated(error), 'a radius of 15 fits')
    call tap%near(nose%height, 12.0_dp, 1.0e-14_dp, &
        'the height is the greatest offset at the blend')
    call fit_nose(lines, yes, yes, new_nose(cone, 37.0_dp), nose, error)
    call tap%ok(.not. allocated(error), 'so does 37, which ends at 39.5')
    call fit_nose(lines, yes, yes, new_nose(cone, 38.0_dp), nose, error)
    call tap%ok(error%cause == cause%no_arc .and. index(error%message, 'MHB ends at 40.') > 0, &
        '38 ends behind a line')
    call tap%same(words_of(lines, yes, yes, cone, 38.0_dp), &
        'the largest radius that fits is 37.49', '37.5 would end just with it')
    call tap%same(words_of(lines, yes, yes, cone, 3.8e7_dp), &
        'the largest radius that fits is 37.49', 'from however far')
    lines(2) = control_line('MHB', straight_view([4.0_dp, 0.0_dp], [40.0_dp, 0.0_dp]), &
        constant_view(3.0_dp))
    call tap%same(words_of(lines, yes, first, cone, 38.0_dp), &
        'the largest radius that fits is 3.75', 'a line may begin where the cap ends')
    lines(1) = control_line('TOP', straight_view([0.0_dp, 0.0_dp], [8.0e5_dp, 6.0e5_dp]), &
        constant_view(0.0_dp))
    call tap%same(words_of(lines(:1), yes(:1), yes(:1), cone_type(apex=[0.0_dp, 0.0_dp], &
        axis=0.0_dp, steepness=0.75_dp, aft=8.0e5_dp), 1.0e6_dp), &
        'the largest radius that fits is 749900.', 'large ones are rounded down, too')
    call tap%same(words_of(lines(:1), yes(:1), yes(:1), cone_type(apex=[1.0_dp, 0.0_dp], &
        axis=0.0_dp, steepness=0.75_dp, aft=0.5_dp), 1.0_dp), 'no radius fits', 'where none does')
    call tap%finish()

contains

    !> The words of `find_fitting`.
    function words_of(lines, is_used, is_mine, cone, radius) result(words)
        type(line_type), intent(in) :: lines(:)
        logical, intent(in) :: is_used(:), is_mine(:)
        type(cone_type), intent(in) :: cone
        real(dp), intent(in) :: radius
        character(:), allocatable :: words
        call find_fitting(lines, is_used, is_mine, cone, radius, words)
    end function words_of

end program test_nose_fit
