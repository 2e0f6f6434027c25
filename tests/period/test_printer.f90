!> Carriage control on paper and kept.
program test_printer
    use base_output, only: output_type
    use period_printer, only: printer_type
    use support_tap, only: tap_type
    implicit none (type, external)

    character, parameter :: lf = new_line('a'), ff = achar(12)
    type(tap_type) :: tap

    call tap%same(printed(.false.), &
        ff//'NEW PAGE'//lf//'  NEXT'//lf//lf//'AFTER A BLANK LINE'//lf//lf, &
        'on paper control is a form feed or a blank line and its column is gone')
    call tap%same(printed(.true.), '1NEW PAGE'//lf//'   NEXT'//lf//'0AFTER A BLANK LINE'//lf//lf, &
        'with its control column a line stays as it is, less blanks at its end')
    call tap%finish()

contains

    !> Some lines printed.
    function printed(asa) result(text)
        logical, intent(in) :: asa
        character(:), allocatable :: text
        type(printer_type) :: printer
        type(output_type) :: out
        printer%asa = asa
        call printer%print('1NEW PAGE   ', out)
        call printer%print('   NEXT', out)
        call printer%print('0AFTER A BLANK LINE', out)
        call printer%print('  ', out)
        text = out%text()
    end function printed

end program test_printer
