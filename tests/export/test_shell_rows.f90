!> Tests of sections as rows: the rational curves of their poles are the sections' arcs.
program test_shell_rows
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: section_arc
    use export_shell_rows, only: form, forms_of, pole_count, poles_of, rows_at, rows_type
    use export_shell_stretch, only: stretch_type, stretches_of
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_place, only: place_at
    use support_skins, only: deck_body, text_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(stretch_type), allocatable :: stretches(:)
    character, parameter :: nl = new_line('a')
    !> Sections are circles of radius 5 through the 3-4-5 points, 286 degrees of them; a flat side.
    character(*), parameter :: round = 'TITLE,ROUND'//nl//'LINE,TOP,SIDE,8.'//nl// &
        'LINE,LOW,SIDE,2.'//nl//'LINE,OUT,SIDE,5.'//nl//'LINE,OUT,PLAN,9.'//nl// &
        'LINE,MID,SIDE,5.'//nl//'SECTION,RING,TOP,OUT,LOW,1.333333333333333,' // &
        '-1.333333333333333,0.,10.'//nl//'SECTION,FLAT,TOP,MID,LOW,999.999,999.999,0.,10.'//nl

    body = deck_body('fuselage')
    call judge('LOWER', 5, 250.0_dp, form%arc)
    call judge('SIDE', 5, 203.0_dp, form%arc)
    call judge('FILLET', 5, 279.0_dp, form%halves)
    call judge('UPPER', 2, 55.0_dp, form%halves)
    body = text_body(round)
    call judge('RING', 1, 3.0_dp, form%halves)
    call judge('FLAT', 1, 3.0_dp, form%line)
    call judge('FLAT', 1, 3.0_dp, form%arc)
    call judge_forms()
    call tap%ok(pole_count(form%line) == 2 .and. pole_count(form%arc) == 3 .and. &
        pole_count(form%halves) == 5, 'a line has 2 poles, an arc 3, two halves 5')
    call tap%finish()

contains

    !> The curve of the poles of a section at a station runs with the arc, place by place.
    subroutine judge(name, which, sta, shape)
        character(*), intent(in) :: name
        integer, intent(in) :: which, shape
        real(dp), intent(in) :: sta
        type(rows_type) :: rows
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        real(dp) :: poles(3, pole_count(shape)), worst, at(3), t
        integer :: k, section, i
        section = findloc(body%sections%name == name, .true., dim=1)
        call stretches_of(body, 1.0e-3_dp, .false., stretches)
        k = findloc(stretches(which)%slots%number == section, .true., dim=1)
        call rows_at(stretches(which), stretches(which)%slots(k), sta, rows, error)
        call tap%ok(.not. allocated(error), name//': it has rows')
        call section_arc(body%lines, body%sections(section), sta, arc, error)
        poles = poles_of([rows%start, 1.0_dp], [rows%middle, rows%weight], [rows%finish, 1.0_dp], &
            shape)
        call tap%ok(shape == form%arc .or. all(poles(3, :) > 0.0_dp), name//': weights of poles')
        worst = 0.0_dp
        do i = 0, 20
            t = real(i, dp)/20.0_dp
            at = homogeneous(poles, t)
            worst = max(worst, norm2(at(:2)/at(3) - point(arc, place_at(t))))
        end do
        call tap%ok(worst < 1.0e-13_dp, name//': the curve of the poles is the section')
    end subroutine judge

    !> The homogeneous point of Bezier arcs end to end over 0..1, by de Casteljau.
    recursive function homogeneous(poles, t) result(at)
        real(dp), intent(in) :: poles(:, :), t
        real(dp) :: at(3)
        real(dp) :: work(3, 3)
        if (size(poles, 2) == 5) then
            if (t < 0.5_dp) at = homogeneous(poles(:, :3), 2.0_dp*t)
            if (t >= 0.5_dp) at = homogeneous(poles(:, 3:), 2.0_dp*t - 1.0_dp)
        else if (size(poles, 2) == 2) then
            at = (1.0_dp - t)*poles(:, 1) + t*poles(:, 2)
        else
            work = poles
            work(:, 1:2) = (1.0_dp - t)*work(:, 1:2) + t*work(:, 2:3)
            at = (1.0_dp - t)*work(:, 1) + t*work(:, 2)
        end if
    end function homogeneous

    !> Which form sections get.
    subroutine judge_forms()
        type(rows_type) :: rows
        type(error_type), allocatable :: error
        call stretches_of(body, 1.0e-3_dp, .false., stretches)
        call tap%ok(all(forms_of(stretches, 2) == [form%halves, form%line]), &
            'past 180 degrees a section is in halves, a flat one a line')
        call rows_at(stretches(1), stretches(1)%slots(1), 3.0_dp, rows, error)
        call tap%near(rows%weight, -0.8_dp, 1.0e-14_dp, 'its weight is cos(286/2)')
        body = deck_body('ellipsoid')
        call stretches_of(body, 1.0e-3_dp, .false., stretches)
        call tap%ok(all(forms_of(stretches, 2) == form%arc), 'quarters are arcs')
    end subroutine judge_forms

end program test_shell_rows
