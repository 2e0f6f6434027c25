!> Figures as they are printed.
program test_figure
    use audit_figure, only: bare, figure_type, form, is_printed_so, print_figure, read_figure, &
        scale_type, unit_of, value_of
    use base_kinds, only: dp, i64
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(figure_type) :: figure

    figure = read_figure('  -15.999 ', form%decimal)
    call tap%ok(figure%is_sound .and. figure%units == -15999 .and. figure%scale%decimals == 3, &
        'a decimal figure is read in units of its last place')
    call tap%near(value_of(figure%units, figure%scale), -15.999_dp, 0.0_dp, 'and is worth them')
    figure = read_figure('-.904', form%decimal)
    call tap%ok(figure%is_sound .and. figure%units == -904, 'a zero before the point may lack')
    figure = read_figure('+7', form%decimal)
    call tap%ok(figure%is_sound .and. figure%units == 7 .and. figure%scale%decimals == 0, &
        'so may the point, and a plus sign may stand')
    figure = read_figure('-7.?9', form%decimal)
    call tap%ok(figure%is_unread .and. .not. figure%is_sound, 'a ? is an unreadable character')
    figure = read_figure('   ', form%decimal)
    call tap%ok(figure%is_blank .and. .not. figure%is_sound, 'blanks are no figure')
    call tap%ok(.not. any([is_sound('1.2.3'), is_sound('12,5'), is_sound('-'), is_sound('.'), &
        is_sound('O.5'), is_sound('123456789012345678.5')]), &
        'two points, a comma, no digit, a letter or too many digits are not sound')

    figure = read_figure('4-7-3', form%eighths)
    call tap%ok(figure%is_sound .and. figure%units == 443, &
        'feet, inches and eighths are read in eighths')
    call tap%near(value_of(figure%units, figure%scale), 55.375_dp, 0.0_dp, 'and are worth inches')
    figure = read_figure('-0-0-5', form%eighths)
    call tap%ok(figure%is_sound .and. figure%units == -5, 'negative ones too')
    call tap%ok(.not. any([is_sound_eighths('4-12-3'), is_sound_eighths('4-7-8'), &
        is_sound_eighths('4-7'), is_sound_eighths('4--3'), is_sound_eighths('4-7-3-1'), &
        is_sound_eighths('4.5')]), '12 inches, 8 eighths and missing parts are not sound')

    call tap%same(trim(print_figure(-904_i64, scale_type(form%decimal, 3))), '-0.904', &
        'a figure less than one is printed with its zero')
    call tap%same(trim(print_figure(120_i64, scale_type(form%decimal, 0))), '120', &
        'a whole number without a point')
    call tap%same(trim(print_figure(-443_i64, scale_type(form%eighths, 0))), '-4-7-3', &
        'eighths as feet, inches, eighths')
    call tap%near(unit_of(scale_type(form%decimal, 2)), 0.01_dp, 0.0_dp, 'two decimals: .01')
    call tap%near(unit_of(scale_type(form%eighths, 0)), 0.125_dp, 0.0_dp, 'eighths: .125 inch')
    call tap%same(trim(bare(' -00.904')), '-0.904', 'figures are compared with one zero in front')
    call tap%same(trim(bare('+.5')), '0.5', 'and without a plus sign')
    call tap%ok(is_printed_so('-7.?9', '-7.09') .and. .not. is_printed_so('-7.?9', '-7.08') .and. &
        .not. is_printed_so('7.?', '7.09'), 'each ? stands for one character')
    call tap%finish()

contains

    !> True where a text is a sound decimal figure.
    pure logical function is_sound(text)
        character(*), intent(in) :: text !! any text
        type(figure_type) :: figure
        figure = read_figure(text, form%decimal)
        is_sound = figure%is_sound
    end function is_sound

    !> True where a text is sound feet, inches and eighths.
    pure logical function is_sound_eighths(text)
        character(*), intent(in) :: text !! any text
        type(figure_type) :: figure
        figure = read_figure(text, form%eighths)
        is_sound_eighths = figure%is_sound
    end function is_sound_eighths

end program test_figure
