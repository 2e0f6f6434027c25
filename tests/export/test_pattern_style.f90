!> Tests of the looks of a pattern.
program test_pattern_style
    use base_kinds, only: dp
    use export_pattern_style, only: layer_of, layers, look_of, look_type, style
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(look_type) :: look
    integer :: i, cut

    cut = 0
    do i = 1, 19
        if (trim(layers(layer_of(i))) == 'outline') cut = cut + i
        look = look_of(i)
        if (look%is_filled .neqv. look%width <= 0.0_dp) call tap%ok(.false., 'lines have a weight')
        if (mod(count(look%dash > 0.0_dp), 2) /= 0) call tap%ok(.false., 'dashes come in pairs')
    end do
    call tap%ok(cut == style%outline, 'nothing but outlines is in the layer that is cut')
    look = look_of(style%outline)
    call tap%near(25.4_dp*look%width, 0.35_dp, 1.0e-12_dp, 'an outline is .35 mm thick')
    call tap%ok(all(look%dash <= 0.0_dp), 'and unbroken')
    look = look_of(style%inside)
    call tap%ok(count(look%dash > 0.0_dp) == 2, 'the inside of the skin is dashed')
    look = look_of(style%centre)
    call tap%ok(count(look%dash > 0.0_dp) == 4, 'the centre line is dash and dot')
    call tap%ok(all([(trim(layers(layer_of(i))), i=style%bar, style%map_part)] == 'sheet'), &
        'bars, crosses and maps belong to the sheet')
    call tap%finish()
end program test_pattern_style
