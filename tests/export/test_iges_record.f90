!> Values of IGES records: reals with a point, Hollerith texts with the right counts.
program test_iges_record
    use base_kinds, only: dp
    use export_iges_record, only: hollerith, iges_real, plain, record_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(record_type) :: record
    real(dp) :: back
    integer :: i
    character(40) :: text
    real(dp), parameter :: samples(9) = [0.1_dp, -1.0_dp/3.0_dp, 1.0e-7_dp, 6.02214076e23_dp, &
        -1.7976931348623157e308_dp, 4.9e-320_dp, 123456789012345680.0_dp, 1.0e16_dp, 254.0_dp]

    call tap%same(iges_real(0.0_dp), '0.', 'zero has a point')
    call tap%same(iges_real(-0.0_dp), '0.', 'and no sign')
    call tap%same(iges_real(-30.0_dp), '-30.', 'whole numbers have a point')
    call tap%same(iges_real(2.5_dp), '2.5', 'others have theirs')
    call tap%same(iges_real(1.0e-7_dp), '1.D-07', 'small ones have a point before the D')
    call tap%same(iges_real(-1.25e20_dp), '-1.25D+20', 'large ones too')
    do i = 1, size(samples)
        text = iges_real(samples(i))
        call tap%ok(index(text, '.') > 0 .and. index(text, 'E') + index(text, 'e') == 0, &
            'a real of double precision: '//trim(text))
        read (text, *) back
        call tap%ok(back == samples(i), 'reads back as the same number')
    end do

    call tap%same(hollerith('NOSE'), '4HNOSE', 'a text behind its count')
    call tap%same(hollerith(','), '1H,', 'also one that looks like a delimiter')
    call tap%same(hollerith('A;B,4HX'), '7HA;B,4HX', 'or like other texts')
    call tap%same(hollerith(''), '', 'an empty one is left out')
    call tap%same(hollerith('H'//char(195)//char(182)//'he'), '4HH?he', &
        'a letter in UTF-8 is one character that IGES has not')
    call tap%same(hollerith('a'//char(9)//'b'//char(200)//char(0)), '5Ha?b??', &
        'control characters and other bytes are one each')
    call tap%same(plain('~ !'), '~ !', 'ASCII stays')

    call record%whole(110)
    call record%reals([0.0_dp, 2.5_dp, -1.0e-7_dp])
    call record%default()
    call record%text('NOSE')
    call tap%same(record%content(), '110,0.,2.5,-1.D-07,,4HNOSE;', 'a record')
    call tap%finish()
end program test_iges_record
