!> Which readings are of which conic of a chain, its joints anywhere.
module audit_chain
    use audit_figure, only: scale_type
    use audit_fit, only: fit_readings, fit_type
    use audit_reading, only: line_type
    implicit none (type, external)
    private

    public :: split_line

contains

    !> Deals out the readings of a line to its conics: `chosen(:, i)` are those of the i-th.
    pure subroutine split_line(line, scale, chosen, way, met_by)
        type(line_type), intent(in) :: line                !! the line
        type(scale_type), intent(in) :: scale              !! of its table
        logical, allocatable, intent(out) :: chosen(:, :)  !! see above
        integer, intent(out) :: way                        !! how it was printed: the best
        integer, intent(out) :: met_by(4)                  !! readings met by each way
        type(fit_type) :: fit

        allocate (chosen(size(line%reading), 1))
        chosen = .true.
        call fit_readings(line, scale, chosen(:, 1), fit)
        way = fit%printing
        met_by = fit%met_by
    end subroutine split_line

end module audit_chain
