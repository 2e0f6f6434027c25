!> Receipts as text: fixed columns, long names, errors and places, notes, nothing to print.
program test_receipt_text
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: row_of
    use export_receipt, only: entity_type, receipt_type
    use export_receipt_text, only: heading_type, print_receipt
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character, parameter :: feed = new_line('a')
    character(*), parameter :: sum = &
        '0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef'

    call check_whole()
    call check_long_names()
    call check_numbers()
    call check_nothing()
    call check_notes()
    call check_width()
    call tap%finish()

contains

    !> A receipt as a user sees it.
    subroutine check_whole()
        type(receipt_type) :: receipt
        call receipt%add(entity('LCL', '126 B-SPLINE CURVE', .true., 0.0_dp, 0))
        call receipt%add(entity('UPPER', '128 SURFACE', .false., 2.345e-4_dp, 7))
        call receipt%say('NO CAPS')
        call tap%same(text_of(receipt), &
            'LOFT 0.1.0 EXPORT RECEIPT'//feed// &
            'FILE       a.igs'//feed// &
            'DECK       nose.crd'//feed// &
            'SHA-256    '//sum//feed// &
            'UNITS      INCHES'//feed// &
            'TOLERANCE  0.001'//feed//feed// &
            'ENTITY          KIND                             POINTS SPANS    ERROR       STA'// &
            '        BL        WL'//feed// &
            'LCL             126 B-SPLINE CURVE         EXACT      9             0.'//feed// &
            'UPPER           128 SURFACE                APPROX     9     7 2.35E-04     12.35'// &
            '     -0.50   1000.00'//feed//feed// &
            '2 ENTITIES: 1 EXACT, 1 APPROXIMATE'//feed// &
            'LARGEST ERROR 2.35E-04 IN UPPER AT STA 12.35 BL -0.50 WL 1000.00'//feed//feed// &
            'NO CAPS'//feed, 'a receipt')
    end subroutine check_whole

    !> Names and kinds that need more than their columns.
    subroutine check_long_names()
        character(*), parameter :: numbers = 'EXACT      9             0.'
        call tap%has(line_of(entity('A23456789012345', '1234567890123456789012345+', .true., &
            0.0_dp, 0)), feed//'A23456789012345 1234567890123456789012345+ '//numbers//feed, &
            'a name of 15 characters and a kind of 26 just fit')
        call tap%has(line_of(entity('A234567890123456', 'KIND', .true., 0.0_dp, 0)), &
            feed//'A234567890123456'//feed//row_of(' ', 16)//'KIND'//row_of(' ', 23)// &
            numbers//feed, 'a longer name has a line of its own')
        call tap%has(line_of(entity('A', '123456789012345678901234567', .true., 0.0_dp, 0)), &
            feed//'A'//feed//row_of(' ', 16)//'123456789012345678901234567'//feed// &
            row_of(' ', 43)//numbers//feed, 'so has a longer kind')
        call tap%has(line_of(entity('A'//achar(10)//'B', 'K', .true., 0.0_dp, 0)), 'A?B  ', &
            'control bytes of names are not printed')
    end subroutine check_long_names

    !> Errors and places of any size.
    subroutine check_numbers()
        type(entity_type) :: far
        call tap%has(line_of(entity('A', 'K', .false., 9.996e-5_dp, 0)), '  1.00E-04 ', &
            'an error rounded up')
        call tap%has(line_of(entity('A', 'K', .false., 12345.0_dp, 0)), '  1.23E+04 ', &
            'a large error')
        far = entity('A', 'K', .false., 1.0_dp, 123456)
        far%points = 7654321
        far%worst = [-12345.678_dp, 123456789.0_dp, -0.001_dp]
        call tap%has(line_of(far), ' APPROX7654321123456 1.00E+00 -12345.68    1.E+08      0.00', &
            'large numbers move nothing out of its columns but counts; no -0.00')
        call tap%has(line_of(entity('A', 'K', .true., 1.0e-14_dp, 0)), &
            feed//'1 EXACT, 0 APPROXIMATE'//feed//'LARGEST ERROR 1.00E-14 IN A', &
            'one entity is not counted')
    end subroutine check_numbers

    !> A receipt without entities.
    subroutine check_nothing()
        type(receipt_type) :: receipt
        call tap%has(text_of(receipt), feed//feed//'NO ENTITIES'//feed, 'nothing is said so')
    end subroutine check_nothing

    !> Notes that are longer than a line, with and without blanks.
    subroutine check_notes()
        type(receipt_type) :: receipt
        character(:), allocatable :: text
        call receipt%add(entity('A', 'K', .true., 0.0_dp, 0))
        call receipt%say(repeat('word ', 19)//'12345')
        call receipt%say(repeat('word ', 19)//'123456')
        call receipt%say(repeat('x', 101))
        text = text_of(receipt)
        call tap%has(text, feed//repeat('word ', 19)//'12345'//feed, '100 columns are a line')
        call tap%has(text, feed//repeat('word ', 18)//'word'//feed//'    123456'//feed, &
            'a longer note goes on below')
        call tap%has(text, feed//repeat('x', 100)//feed//'    x'//feed, &
            'a word that is too long is broken')
    end subroutine check_notes

    !> Several files; nothing is wider than 100 columns.
    subroutine check_width()
        type(receipt_type) :: receipt
        type(heading_type) :: heading
        type(output_type) :: out
        character(:), allocatable :: text
        integer :: i, first, widest

        do i = 1, 30
            call receipt%add(entity(row_of('N', i), row_of('K', 31 - i), mod(i, 2) == 0, &
                10.0_dp**(i - 25), 10**mod(i, 5)))
        end do
        heading = heading_type('a-1.svg'//feed//'a-2.svg'//feed, 'd', sum, 'MM', 0.0_dp)
        call print_receipt(heading, receipt, out)
        text = out%text()
        call tap%has(text, feed//'FILE       a-1.svg'//feed//'           a-2.svg'//feed//'DECK', &
            'several files stand below each other')
        call tap%has(text, feed//'TOLERANCE  NONE'//feed, 'where no tolerance was asked it is said')
        widest = 0
        first = 1
        do while (first <= len(text))
            i = index(text(first:), feed)
            widest = max(widest, i - 1)
            first = first + i
        end do
        call tap%ok(widest <= 100 .and. widest > 95, 'no line is wider than 100 columns')
    end subroutine check_width

    !> An entity with nine points.
    pure type(entity_type) function entity(name, kind, is_exact, error, spans)
        character(*), intent(in) :: name    !! of it
        character(*), intent(in) :: kind    !! of it
        logical, intent(in) :: is_exact     !! or approximate
        real(dp), intent(in) :: error       !! the largest
        integer, intent(in) :: spans        !! 0: none
        entity%name = name
        entity%kind = kind
        entity%is_exact = is_exact
        entity%points = 9
        entity%spans = spans
        entity%error = error
        entity%has_place = .not. is_exact
        entity%worst = [12.345678_dp, -0.5_dp, 1000.0_dp]
    end function entity

    !> The receipt of one entity.
    function line_of(one) result(text)
        type(entity_type), intent(in) :: one !! the entity
        character(:), allocatable :: text
        type(receipt_type) :: receipt
        call receipt%add(one)
        text = text_of(receipt)
    end function line_of

    !> A receipt as text.
    function text_of(receipt) result(text)
        type(receipt_type), intent(in) :: receipt !! the receipt
        character(:), allocatable :: text
        type(output_type) :: out
        call print_receipt(heading_type('a.igs'//feed, 'nose.crd', sum, 'INCHES', 1.0e-3_dp), &
            receipt, out)
        text = out%text()
    end function text_of

end program test_receipt_text
