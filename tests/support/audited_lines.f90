!> Lines with known conics, for tests of the parts of an audit: a parabola and a circle, whose
!> figures need no other program than a pocket calculator.
module support_audited_lines
    use audit_figure, only: form, print_figure, scale_type
    use audit_reading, only: add, line_type, new_reading, sort
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: parabola_line, circle_line, spoil, whole

contains

    !> y = x**2/100 at x = 0, 5, ... 95, to three decimals: 20 readings.
    pure type(line_type) function parabola_line() result(line)
        integer :: i
        line%name = 'parabola'
        line%scale = scale_type(form%decimal, 3)
        do i = 0, 19
            call add(line, new_reading(sort%ordinate, 5.0_dp*real(i, dp), &
                print_figure(int(250*i*i, i64), line%scale)))
        end do
    end function parabola_line

    !> The upper half of x**2 + y**2 = 100**2 at x = -95, -90, ... 95: 39 readings, and its left
    !> half at y = 30 and 60.
    pure type(line_type) function circle_line() result(line)
        real(dp) :: x
        integer :: i
        line%name = 'circle'
        line%scale = scale_type(form%decimal, 3)
        do i = -19, 19
            x = 5.0_dp*real(i, dp)
            call add(line, new_reading(sort%ordinate, x, &
                print_figure(nint(1000.0_dp*sqrt(1.0e4_dp - x*x), i64), line%scale)))
        end do
        call add(line, new_reading(sort%abscissa, 30.0_dp, '-95.394'))
        call add(line, new_reading(sort%abscissa, 60.0_dp, '-80.000'))
    end function circle_line

    !> Puts another figure in the place of one.
    pure subroutine spoil(line, which, text)
        type(line_type), intent(inout) :: line !! any line
        integer, intent(in) :: which           !! which reading
        character(*), intent(in) :: text       !! what is read instead
        line%reading(which) = new_reading(line%reading(which)%sort, line%reading(which)%along, &
            text, line%reading(which)%meaning)
    end subroutine spoil

    !> All readings of a line.
    pure function whole(line) result(chosen)
        type(line_type), intent(in) :: line !! any line
        logical, allocatable :: chosen(:)
        allocate (chosen(size(line%reading)))
        chosen = .true.
    end function whole

end module support_audited_lines
