!> Tests of the surfaces of stretches: how many poles a tolerance takes, which are exact, bounds.
program test_shell_surfaces
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_shell_ribs, only: ribs_of, ribs_type
    use export_shell_rows, only: form, forms_of
    use export_shell_stretch, only: stretch_type, stretches_of
    use export_shell_surfaces, only: fit_stretch, fitted_type
    use support_skins, only: deck_body, text_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(fitted_type) :: coarse, fine, finest
    type(error_type), allocatable :: error
    integer :: spans(3)

    call fit(deck_body('nose'), 1, 1.0e-2_dp, coarse)
    call fit(deck_body('nose'), 1, 1.0e-4_dp, fine)
    call fit(deck_body('nose'), 1, 1.0e-6_dp, finest)
    spans = [size(coarse%span_miss), size(fine%span_miss), size(finest%span_miss)]
    call tap%ok(spans(1) < spans(2) .and. spans(2) < spans(3), 'less tolerance, more spans')
    call tap%ok(spans(3) < 20, 'the nose takes less than 20 of them for 1e-6')
    call tap%ok(finest%miss(1)%distance < 1.0e-6_dp .and. &
        maxval(finest%span_miss) == finest%miss(1)%distance, 'it keeps the tolerance')
    call tap%ok(minval(finest%span_miss) > 1.0e-9_dp, 'no span is much better than it must be')
    call tap%ok(.not. any(finest%is_exact) .and. all(finest%form == form%arc), &
        'it is not exact; its sections are arcs')
    call tap%ok(all(finest%surface(1)%weight > 0.0_dp), 'weights are above zero')
    call tap%ok(coarse%fit%degree < 5 .or. spans(1) > 1, 'a single span has the least degree')

    call fit(deck_body('cone'), 1, 1.0e-3_dp, coarse)
    call tap%ok(coarse%fit%degree == 1 .and. all(coarse%is_exact), 'a cone is of degree 1, exactly')
    call fit(deck_body('paraboloid'), 1, 1.0e-3_dp, coarse)
    call tap%ok(coarse%fit%degree == 2 .and. all(coarse%is_exact) .and. &
        .not. coarse%fit%pace%is_conic, 'a paraboloid of degree 2')
    call fit(deck_body('ellipsoid'), 2, 1.0_dp, coarse)
    call tap%ok(coarse%fit%degree == 2 .and. all(coarse%is_exact) .and. &
        coarse%fit%pace%is_conic, 'an ellipsoid, too, along a conic, whatever the tolerance')
    call fit(deck_body('round-nose'), 1, 1.0e-3_dp, coarse)
    call tap%ok(all(coarse%is_exact), 'the cap of a round nose is a sphere, exactly')

    call fit(deck_body('ellipsoid'), 1, 1.0e-15_dp, coarse)
    call tap%ok(size(coarse%span_miss) == 1, &
        'asked for less than rounding an ellipsoid still has one span')
    call refuse()
    call tap%finish()

contains

    !> Fits a stretch of a body, which must succeed.
    subroutine fit(body, which, tolerance, fitted)
        type(body_type), intent(in) :: body
        integer, intent(in) :: which
        real(dp), intent(in) :: tolerance
        type(fitted_type), intent(out) :: fitted
        call try(body, which, tolerance, fitted)
        call tap%ok(.not. allocated(error), 'a stretch is fitted')
    end subroutine fit

    !> Fits a stretch of a body.
    subroutine try(body, which, tolerance, fitted)
        type(body_type), intent(in) :: body
        integer, intent(in) :: which
        real(dp), intent(in) :: tolerance
        type(fitted_type), intent(out) :: fitted
        type(stretch_type), allocatable :: stretches(:)
        type(ribs_type) :: ribs
        call stretches_of(body, tolerance, .false., stretches)
        call ribs_of(stretches, ribs, error)
        call fit_stretch(stretches(which), ribs%ends(which), &
            forms_of(stretches, size(body%sections)), tolerance, fitted, error)
    end subroutine try

    !> A section past 180 degrees has no single arc with weights above zero: however many spans.
    subroutine refuse()
        character, parameter :: nl = new_line('a')
        type(body_type) :: body
        type(stretch_type), allocatable :: stretches(:)
        type(ribs_type) :: ribs
        type(fitted_type) :: fitted
        body = text_body('TITLE,ROUND'//nl//'LINE,TOP,SIDE,8.'//nl//'LINE,LOW,SIDE,2.'//nl// &
            'LINE,OUT,SIDE,5.'//nl//'LINE,OUT,PLAN,9.'//nl// &
            'SECTION,RING,TOP,OUT,LOW,1.333333333333333,-1.333333333333333,0.,10.'//nl)
        call stretches_of(body, 1.0e-3_dp, .false., stretches)
        call ribs_of(stretches, ribs, error)
        call fit_stretch(stretches(1), ribs%ends(1), [form%arc], 1.0e-3_dp, fitted, error)
        call tap%ok(allocated(error), 'what no number of spans can do is refused')
        if (.not. allocated(error)) return
        call tap%ok(error%cause == cause%no_convergence, 'as not reached')
        call tap%has(error%message, 'between stations 0. and 10.', 'with its stations')
        call fit_stretch(stretches(1), ribs%ends(1), [form%halves], 1.0e-3_dp, fitted, error)
        call tap%ok(.not. allocated(error), 'in halves it is made')
        if (.not. allocated(error)) call tap%ok(all(fitted%is_exact), 'exactly')
    end subroutine refuse

end program test_shell_surfaces
