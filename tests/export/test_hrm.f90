!> Tests of .hrm files, by the statements that OpenVSP reads them with.
program test_hrm
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_hrm, only: write_hrm
    use export_receipt, only: receipt_type
    use support_nets, only: two_nets
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(output_type) :: out
    type(receipt_type) :: receipt
    character(*), parameter :: feed = new_line('a')
    real(dp) :: at(3)

    call write_hrm(two_nets(), out, receipt)
    call tap%ok(index(out%text(), ' HERMITE INPUT FILE'//feed//feed// &
        ' NUMBER OF COMPONENTS = 2'//feed//feed//'UPPER '//feed// &
        ' GROUP NUMBER      = 0 '//feed//' TYPE              = 1  '//feed// &
        ' CROSS SECTIONS    = 3 '//feed//' PTS/CROSS SECTION = 2 '//feed) == 1, &
        'the head of file and component, as OpenVSP writes them')
    call tap%has(out%text(), feed//feed//'LOWER '//feed//' GROUP NUMBER      = 1 '//feed, &
        'the next component')
    call tap%has(out%text(), feed//'   1.0000000000000000E+01     0.0000000000000000E+00  '// &
        '   2.5000000000000000E+00'//feed, 'points in all their figures')
    call tap%ok(lines_of(out%text()) == 3 + 6 + 6 + 6 + 4, 'a line for each point')
    at = last_point(out%text())
    call tap%near(norm2(at - [20.0_dp, 0.1_dp, -1.0_dp]), 0.0_dp, 0.0_dp, 'read back exactly')
    call tap%has(receipt%notes, 'no place for units: lengths are in MM', &
        'the receipt has the units')
    call tap%ok(receipt%count == 2, 'and an entity for each')
    call tap%finish()

contains

    !> How many lines a text has.
    integer function lines_of(text)
        character(*), intent(in) :: text
        integer :: i
        lines_of = count([(text(i:i) == feed, i=1, len(text))])
    end function lines_of

    !> The numbers of the last line.
    function last_point(text) result(at)
        character(*), intent(in) :: text
        real(dp) :: at(3)
        read (text(index(text(:len(text) - 1), feed, back=.true.) + 1:), *) at
    end function last_point

end program test_hrm
