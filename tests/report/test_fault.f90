!> Faults as the user reads them.
program test_fault
    use base_fault, only: fault_list_type, fault_type, new_fault, severity
    use base_kinds, only: i64
    use base_output, only: output_type
    use report_fault, only: print_faults
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(*), parameter :: feed = new_line('a')
    character(*), &
        parameter :: card = '-30.    -10.    .114    -30.    -10.    50.     -4.     .0523   5.'

    call check_whole_text()
    call check_severities()
    call check_places()
    call check_bytes()
    call check_long_cards()
    call tap%finish()

contains

    !> The text of a fault, to the last character.
    subroutine check_whole_text()
        call tap%same(printed(severity%error, 7_i64, [25, 40], card), &
            'nose.crd:7:25-40: error: wrong'//feed//'    '//card//feed// &
            '                            ^^^^^^^^^^^^^^^^'//feed, &
            'carets stand under the columns at fault')
        call tap%same(printed(severity%error, 12345678901_i64, [1, 1], 'x'), &
            'nose.crd:12345678901:1-1: error: wrong'//feed//'    x'//feed//'    ^'//feed, &
            'one column, on a line far down')
        call tap%same(printed(severity%error, 1_i64, [9, 16], 'UNITS'), &
            'nose.crd:1:9-16: error: wrong'//feed//'    UNITS'//feed//'            ^^^^^^^^'// &
            feed, &
            'columns behind the end of the card')
        call tap%same(printed(severity%error, 1_i64, [1, 4], 'LINE   '), &
            'nose.crd:1:1-4: error: wrong'//feed//'    LINE'//feed//'    ^^^^'//feed, &
            'blanks at the end of a card are not printed')
    end subroutine check_whole_text

    !> Errors, warnings, and remarks where they are asked for.
    subroutine check_severities()
        type(fault_list_type) :: faults
        type(output_type) :: with, without, none

        call faults%add(new_fault(severity%remark, 0, 0, 'a remark'))
        call faults%add(new_fault(severity%warning, 0, 0, 'a warning'))
        call faults%add(new_fault(severity%error, 0, 0, 'an error'))
        call print_faults(faults, '-', .true., with)
        call tap%same(with%text(), '-: warning: a remark'//feed//'-: warning: a warning'//feed// &
            '-: error: an error'//feed, 'remarks are printed as warnings, all in their order')
        call print_faults(faults, '-', .false., without)
        call tap%same(without%text(), '-: warning: a warning'//feed//'-: error: an error'//feed, &
            'remarks are left out where they are not asked for')
        call faults%clear()
        call print_faults(faults, '-', .true., none)
        call tap%same(none%text(), '', 'no faults, no text')
    end subroutine check_severities

    !> Faults of a whole card or a whole file.
    subroutine check_places()
        call tap%same(printed(severity%warning, 3_i64, [0, 0], card), &
            'nose.crd:3: warning: wrong'//feed// &
            '    '//card//feed, 'a fault of a whole card shows it without carets')
        call tap%same(printed(severity%error, 3_i64, [0, 0], ''), &
            'nose.crd:3: error: wrong'//feed, &
            'without card only its line is named')
        call tap%same(printed(severity%error, 0_i64, [0, 0], ''), 'nose.crd: error: wrong'//feed, &
            'a fault of the file names the file')
        call tap%same(printed(severity%error, 3_i64, [3, 3], ''), &
            'nose.crd:3:3-3: error: wrong'//feed, &
            'columns of a card that is not shown have no carets')
    end subroutine check_places

    !> What is not plain ASCII takes one column a byte.
    subroutine check_bytes()
        call tap%same(printed(severity%error, 1_i64, [5, 5], &
            'a'//char(195)//char(188)//achar(9)//'b'), &
            'nose.crd:1:5-5: error: wrong'//feed//'    a???b'//feed//'        ^'//feed, &
            'two bytes of a letter and a tab are three columns')
        call tap%same(printed(severity%error, 1_i64, [1, 4], ' ~'//achar(127)//achar(27)), &
            'nose.crd:1:1-4: error: wrong'//feed//'     ~??'//feed//'    ^^^^'//feed, &
            'control bytes do not reach the terminal')
    end subroutine check_bytes

    !> Columns that are not shown.
    subroutine check_long_cards()
        character(*), parameter :: long = repeat('x', 500)

        call tap%same(printed(severity%error, 1_i64, [81, 500], long), &
            'nose.crd:1:81-500: error: wrong'//feed// &
            '    '//long(:132)//feed//'    '//repeat(' ', 80)//repeat('^', 52)//feed, &
            '132 columns are shown, and carets as far')
        call tap%same(printed(severity%error, 1_i64, [200, 300], long), &
            'nose.crd:1:200-300: error: wrong'//feed//'    '//long(:132)//feed, &
            'columns behind those have no carets')
        call tap%same(printed(severity%error, 1_i64, [132, 133], long), &
            'nose.crd:1:132-133: error: wrong'//feed// &
            '    '//long(:132)//feed//'    '//repeat(' ', 131)//'^'//feed, &
            'the last column shown has one')
    end subroutine check_long_cards

    !> The text of one fault.
    function printed(grade, line, columns, image) result(text)
        integer, intent(in) :: grade      !! one of `severity%...`
        integer(i64), intent(in) :: line  !! line of the file
        integer, intent(in) :: columns(2) !! first and last
        character(*), intent(in) :: image !! the card
        character(:), allocatable :: text
        type(fault_list_type) :: faults
        type(fault_type) :: fault
        type(output_type) :: out
        fault = new_fault(grade, columns(1), columns(2), 'wrong')
        call faults%add(fault)
        call faults%place(0, line, image)
        call print_faults(faults, 'nose.crd', .false., out)
        text = out%text()
    end function printed

end program test_fault
