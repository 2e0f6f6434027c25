!> Which figures are of which conic of a chain.
program test_chain
    use audit_chain, only: split_line
    use audit_printing, only: printing
    use audit_reading, only: line_type
    use support_audited_lines, only: parabola_line
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line
    logical, allocatable :: chosen(:, :)
    integer :: way, met_by(4)

    line = parabola_line()
    call split_line(line, line%scale, chosen, way, met_by)
    call tap%ok(size(chosen, 2) == 1 .and. all(chosen), 'a line of one conic is not split')
    call tap%ok(met_by(printing%rounded) == 20, 'its figures are met')
    call tap%finish()
end program test_chain
