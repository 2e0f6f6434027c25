!> Tokens and instances of STEP files. Escapes are those of ISO 10303-21:2002, 6.3.3.
program test_step_text
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_step_text, only: put_statement, step_file_type, step_list, step_logical, &
        step_real, step_reference, step_references, step_string
    use support_step_records, only: is_sound
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(step_file_type) :: file
    type(output_type) :: out
    character(256) :: every
    integer :: i, number
    real(dp) :: value

    call tap%same(step_string(''), '''''', 'nothing is an empty string')
    call tap%same(step_string('STA 20'), '''STA 20''', 'plain words stay')
    call tap%same(step_string('it''s'), '''it''''s''', 'an apostrophe is doubled')
    call tap%same(step_string('a\b'), '''a\\b''', 'so is a reverse solidus')
    call tap%same(step_string('\X2\'), '''\\X2\\''', 'what looks like an escape is none')
    call tap%same(step_string('caf'//char(195)//char(169)), '''caf\X2\00E9\X0\''', &
        'a letter beyond ASCII goes by its number')
    call tap%same(step_string(char(240)//char(159)//char(155)//char(169)), &
        '''\X4\0001F6E9\X0\''', 'one beyond 16 bits by a longer one')
    call tap%same(step_string('a'//achar(10)//char(255)//char(195)), '''a\X\0A\X\FF\X\C3''', &
        'control characters and bytes that are no UTF-8 by their own')
    do i = 1, 256
        every(i:i) = char(i - 1)
    end do
    call tap%ok(is_sound(step_string(every), 80), 'of all bytes none leaves the string')

    call tap%same(step_real(0.0_dp), '0.', 'zero')
    call tap%same(step_real(-0.0_dp), '0.', 'zero has no sign')
    call tap%same(step_real(-30.0_dp), '-30.', 'a whole number has a point')
    call tap%same(step_real(0.1_dp), '0.1', 'the fewest figures')
    call tap%same(step_real(1.0e-7_dp), '1.E-07', 'a power has a point before it')
    call tap%same(step_real(-1.5e-300_dp), '-1.5E-300', 'a small number')
    call tap%same(step_real(1.0e20_dp), '1.E+20', 'a large number')
    value = sqrt(0.5_dp)
    every = step_real(value)
    read (every, *) value
    call tap%ok(value == sqrt(0.5_dp), 'a number reads back as the same')

    call tap%same(step_list([1.0_dp, 0.25_dp, -2.0_dp]), '(1.,0.25,-2.)', 'numbers')
    call tap%same(step_list([1.0_dp]), '(1.)', 'one number')
    call tap%same(step_list([3, 1, 3]), '(3,1,3)', 'whole numbers')
    call tap%same(step_reference(12), '#12', 'a reference')
    call tap%same(step_references([12, 7]), '(#12,#7)', 'references')
    call tap%same(step_references([integer ::]), '()', 'no references')
    call tap%same(step_logical(.true.)//step_logical(.false.), '.T..F.', 'truth')

    call tap%same(file%text(), '', 'a new file has no instance')
    call file%add('CARTESIAN_POINT('''',(0.,0.,0.))', number)
    call tap%ok(number == 1, 'the first instance is number 1')
    call file%add('VERTEX_POINT('''',#1)', number)
    call tap%ok(number == 2, 'the next is number 2')
    call tap%same(file%text(), '#1=CARTESIAN_POINT('''',(0.,0.,0.));'//new_line('a')// &
        '#2=VERTEX_POINT('''',#1);'//new_line('a'), 'the data section')

    call put_statement(out, 'A('//repeat('1234567,', 12)//'''x,'//repeat('y', 90)//''',1)')
    call tap%same(out%text(), 'A('//repeat('1234567,', 9)//new_line('a')// &
        repeat('1234567,', 3)//new_line('a')//'''x,'//repeat('y', 90)//''','//new_line('a')// &
        '1);'//new_line('a'), 'lines break behind commas, never in a string')
    call tap%finish()

end program test_step_text
