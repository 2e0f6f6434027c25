!> What a table that was audited says at an ordinate, by its printed figure and by the line found:
!> another table of the same deck can be held against it.
module audit_value
    use audit_audit, only: piece_type
    use audit_curve, only: quantity_type
    use audit_figure, only: unit_of
    use audit_finding, only: verdict
    use audit_item, only: item_type
    use audit_parameter, only: bound_parameter, parameter_type
    use audit_reading, only: sort
    use base_exact, only: is_equal
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: value_type, value_at, row_at

    !> A value of a line.
    type :: value_type
        logical :: exists = .false.     !! the line found has it
        real(dp) :: value = 0.0_dp      !! by the line found, deck units
        real(dp) :: low = 0.0_dp        !! least value that its good figures allow
        real(dp) :: high = 0.0_dp       !! greatest value that they allow
        real(dp) :: unit = 1.0_dp       !! of the last place of its table, deck units
    end type value_type

    !> Ordinates closer than this, relative to the range of the table, are the same row.
    real(dp), parameter :: same_row = 1.0e-9_dp

contains

    !> The value at an ordinate; none outside of the rows and ends of the table.
    pure type(value_type) function value_at(item, sorts, along) result(found)
        type(item_type), intent(in) :: item !! a table that was audited
        integer, intent(in) :: sorts        !! `sort%ordinate` or `sort%abscissa`
        real(dp), intent(in) :: along       !! X, or Y of an abscissa, deck units
        type(parameter_type) :: parameter
        real(dp) :: reach(2), apart, nearest, near
        integer :: i

        if (.not. item%is_audited) return
        reach = [huge(along), -huge(along)]
        nearest = huge(along)
        near = 0.0_dp
        do i = 1, size(item%line%reading)
            associate (it => item%line%reading(i), finding => item%audit%finding(i))
                if (it%sort /= sorts .or. it%column /= 1 .or. .not. finding%is_reached) cycle
                reach = [min(reach(1), it%along), max(reach(2), it%along)]
                apart = abs(it%along - along)
                if (apart >= nearest .or. finding%verdict == verdict%none) cycle
                nearest = apart
                near = finding%computed
            end associate
        end do
        if (along < reach(1) - same_row*(reach(2) - reach(1)) .or. &
            along > reach(2) + same_row*(reach(2) - reach(1))) return
        associate (piece => item%audit%piece(piece_at(item%audit%piece, sorts, along)))
            parameter = bound_parameter(piece%fit, '', quantity_type(sort=sorts, along=along, &
                near=near))
        end associate
        found%exists = parameter%exists
        found%value = parameter%value
        found%low = parameter%low
        found%high = parameter%high
        found%unit = unit_of(item%audit%scale)
    end function value_at

    !> The row of a table at an ordinate, in its first column; 0 where nothing is printed there.
    pure integer function row_at(item, sorts, along) result(reading)
        type(item_type), intent(in) :: item !! a table that was audited
        integer, intent(in) :: sorts        !! `sort%ordinate` or `sort%abscissa`
        real(dp), intent(in) :: along       !! X, or Y of an abscissa, deck units
        do reading = 1, size(item%line%reading)
            associate (it => item%line%reading(reading))
                if (it%sort == sorts .and. is_equal(it%along, along) .and. it%column == 1 .and. &
                    item%entry(reading) > 0 .and. .not. it%figure%is_blank) return
            end associate
        end do
        reading = 0
    end function row_at

    !> The conic of a chain at an abscissa. (A table along Y has one conic, or the first is taken.)
    pure integer function piece_at(piece, sorts, along) result(at)
        type(piece_type), intent(in) :: piece(:)    !! the conics
        integer, intent(in) :: sorts                !! `sort%ordinate` or `sort%abscissa`
        real(dp), intent(in) :: along               !! deck units
        integer :: i
        at = 1
        if (sorts == sort%abscissa) return
        do i = 1, size(piece)
            if (along >= piece(i)%first) at = i
        end do
    end function piece_at

end module audit_value
