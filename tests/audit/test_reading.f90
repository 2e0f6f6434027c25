!> What is known of a line.
program test_reading
    use audit_figure, only: form
    use audit_reading, only: add, common_decimals, line_type, meaning, new_reading, sort
    use base_kinds, only: dp
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line

    call add(line, new_reading(sort%ordinate, 5.0_dp, '-6.717'))
    call add(line, new_reading(sort%ordinate, 10.0_dp, '-6.438'))
    call add(line, new_reading(sort%ordinate, 15.0_dp, '-6.0209'))
    call add(line, new_reading(sort%abscissa, -4.0_dp, '12.5', meaning%exact))
    call add(line, new_reading(sort%abscissa, -4.0_dp, '13.5', meaning%exact))
    call add(line, new_reading(sort%abscissa, -4.0_dp, '14.5', meaning%exact))
    call add(line, new_reading(sort%ordinate, 20.0_dp, '4-7-3', form_of=form%eighths))
    call tap%ok(size(line%reading) == 7, 'readings are put one behind the other')
    call tap%same(trim(line%reading(2)%figure%text), '-6.438', 'each keeps its text')
    call tap%ok(line%reading(1)%meaning == meaning%printed .and. &
        line%reading(4)%meaning == meaning%exact, 'a figure is of the table unless it says more')
    call tap%ok(line%reading(7)%figure%units == 443, 'a figure has its form')
    call tap%ok(common_decimals(line%reading(:6)) == 3, &
        'the decimals of a table are those of most of its own figures')
    call tap%finish()
end program test_reading
