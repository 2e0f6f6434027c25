!> Rows of variants: what is written is read back the same; what is no row is refused.
program test_record
    use base_kinds, only: dp
    use base_text, only: columns
    use support_ellipsoid, only: ellipsoid_study, ellipsoid_text
    use support_random, only: random_type
    use support_tap, only: tap_type
    use sweep_record, only: header_of, read_row, record_type, row_of_record, state
    use sweep_study, only: study_type
    implicit none (type, external)

    character(*), parameter :: quotes = '","","'
    type(tap_type) :: tap
    type(random_type) :: random
    type(study_type) :: study
    type(record_type) :: record, back
    logical :: is_sound
    integer :: i, wrong, taken
    character(:), allocatable :: row, text

    study = ellipsoid_study(ellipsoid_text('1.,2.,2', '1.,2.,2', &
        'OBJECT,VOLUME,MAX|OBJECT,WETTED,MIN|LIMIT,VOLUME,1.'), tap)
    call tap%same(header_of(study, 'abc'), '# loft 0.1.0 sweep of 4 variants, deck abc'// &
        new_line('a')//'variant,B,C,VOLUME,WETTED,state,front,why'//new_line('a'), &
        'two lines before the rows; one column a measure')
    record = record_type(3, [1.5_dp, -2.0_dp], [0.1_dp, 0.0_dp], [.true., .false.], state%fault, &
        .true., 'no "sound" line, at all')
    call tap%same(row_of_record(record, .true.), &
        '3,1.5,-2,0.1,,fault,1,"no ""sound"" line, at all"', 'a row')
    call tap%same(row_of_record(record, .false.), &
        '3,1.5,-2,0.1,,fault,,"no ""sound"" line, at all"', 'before the front is known')
    record%why = ''
    record%state = state%ok
    record%is_front = .false.
    call tap%same(row_of_record(record, .true.), '3,1.5,-2,0.1,,ok,0,', 'nothing to say')
    record%why = 'a'//achar(10)//'b'//achar(27)
    call tap%same(row_of_record(record, .true.), '3,1.5,-2,0.1,,ok,0,"a?b?"', &
        'a row is one line, whatever was on the cards')
    wrong = 0
    do i = 1, 2000
        text = columns(quotes, 1, 3*mod(i, 3))
        record = record_type(1 + mod(i, 4), [any_number(), any_number()], &
            [any_number(), any_number()], [.true., mod(i, 3) > 0], 1 + mod(i + 2, 3), &
            mod(i, 5) == 0, text)
        if (.not. record%has(2)) record%measure(2) = 0.0_dp
        row = row_of_record(record, .true.)
        call read_row(row, study, back, is_sound)
        if (.not. is_sound .or. back%number /= record%number .or. back%state /= record%state &
            .or. (back%is_front .neqv. record%is_front) .or. back%why /= record%why &
            .or. any(back%has .neqv. record%has)) wrong = wrong + 1
        if (.not. all(abs([back%value - record%value, back%measure - record%measure]) <= 0.0_dp)) &
            wrong = wrong + 1
    end do
    call tap%ok(wrong == 0, 'two thousand rows read back the same, bit for bit')
    record%why = 'a line, a word'
    row = row_of_record(record, .true.)
    taken = 0
    do i = 0, len(row) - 1
        call read_row(row(:i), study, back, is_sound)
        if (is_sound .and. i > index(row, '"')) taken = taken + 1
        if (is_sound .and. i < index(row, '"') - 1) taken = taken + 1
    end do
    call tap%ok(taken == 0, 'a row that was torn is none')
    call refused('0,1,2,3,4,ok,0,')
    call refused('5,1,2,3,4,ok,0,')
    call refused('1e99,1,2,3,4,ok,0,')
    call refused('x,1,2,3,4,ok,0,')
    call refused('1,1,2,3,4,good,0,')
    call refused('1,1,2,3,4,,0,')
    call refused('1,1,2,3,4,ok,0,open')
    call refused('1,1,2,3,4,ok,0,"open')
    call refused('1,1,2,3,,ok,0,')
    call refused('1,1,2,,4,limit,0,"B is below 9."')
    call refused('1,1,2,3*4,4,ok,0,')
    call refused('1,1,2,1e999999999999,4,ok,0,')
    call refused('')
    call tap%finish()

contains

    !> A number of any size.
    real(dp) function any_number()
        any_number = random%sign()*10.0_dp**random%between(-250.0_dp, 250.0_dp)
    end function any_number

    !> A text is no row.
    subroutine refused(text)
        character(*), intent(in) :: text
        call read_row(text, study, back, is_sound)
        call tap%ok(.not. is_sound, 'no row: '//text)
    end subroutine refused

end program test_record
