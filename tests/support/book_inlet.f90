!> The inlet of seed 002 as printed there and as faired by LOFT, in lines of text.
!>
!> Source of the printed figures: Jiang Da-wei, Li An-ping, Cai Yuan-hu, "Fairing B-spline curves
!> with fixed area constraints", section 4.
module support_book_inlet
    use base_digits, only: fixed, shortest
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_text, only: right
    use geom_fairing, only: fair, fair_to_area, faired_energy, fairing_type
    use geom_fairing_system, only: fairing_data_type, fairing_end
    use support_inlet, only: inlet
    implicit none (type, external)
    private

    public :: inlet_lines

    !> What the paper prints of a curve.
    type :: printed_type
        real(dp) :: weight      !! of all points
        real(dp) :: energy      !! E
        real(dp) :: area        !! S
        real(dp) :: multiplier  !! lambda
        real(dp) :: asked       !! the area asked for; 0: none
    end type printed_type
    type(printed_type), parameter :: printed(3) = [ &
        printed_type(1.0e6_dp, 10.1366_dp, 1.2291_dp, 0.0_dp, 0.0_dp), &
        printed_type(100.0_dp, 10.0593_dp, 1.1702_dp, 0.0_dp, 0.0_dp), &
        printed_type(100.0_dp, 10.0434_dp, 1.1802_dp, -3.0_dp, 1.18_dp)]

    !> The same curve of LOFT's, closed as FAIRED makes it and open as in the paper.
    type :: inlet_row_type
        type(fairing_type) :: closed    !! a ring through 14 points
        type(fairing_type) :: open      !! with free ends, through 15
    end type inlet_row_type

    !> Columns of a figure, its decimals; columns of a multiplier.
    integer, parameter :: width = 10, decimals = 4, lambda_width = 8
    !> Lines of the table.
    integer, parameter, public :: inlet_count = 16

contains

    !> The table, and what can be said of the difference.
    function inlet_lines() result(lines)
        character(80) :: lines(inlet_count)
        type(inlet_row_type) :: rows(3)
        real(dp) :: drop
        integer :: i

        rows = inlet_rows()
        drop = printed(1)%energy - printed(2)%energy
        lines = ''
        lines(2) = 'The inlet of Jiang, Li and Cai (1996), section 4: energy E and area S as'
        lines(3) = 'printed there, of cards/inlet.crd (closed) and of the open curve of the paper'
        lines(4) = right('printed', 2*width + 18)//right('closed', 2*width)//right('open', 2*width)
        lines(5) = '    weight  lambda'//repeated_heads(3)
        do i = 1, 3
            lines(5 + i) = row_text(printed(i), rows(i))
        end do
        lines(9) = 'In the last S = 1.18 is asked. LOFT''s S is larger without that, so its lambda'
        lines(10) = 'is above zero: '//said(rows(3)%closed%lambda)//' closed, '// &
            said(rows(3)%open%lambda)//' open. The lambda printed'
        lines(11) = 'gives S = '//said(area_at(printed(3), .true.))//' and '// &
            said(area_at(printed(3), .false.))//'.'
        lines(12) = 'The printed figures are not least values of what the paper says: of two least'
        lines(13) = 'curves, weights 1E6 and 100, E(1E6) - E(100) = 200 sum |p - q|**2 + E of the'
        lines(14) = 'difference. The printed '//said(drop)//' then allows areas about '// &
            said(largest_step(drop))//' apart;'
        lines(15) = 'printed they are '//said(printed(1)%area - printed(2)%area)//', LOFT''s '// &
            said(rows(1)%closed%area - rows(2)%closed%area)//' (closed). What else was tried:'
        lines(16) = 'doc/theory-fairing.md.'
    end function inlet_lines

    !> The heads of so many curves.
    pure function repeated_heads(count) result(heads)
        integer, intent(in) :: count !! curves
        character(:), allocatable :: heads
        integer :: i
        heads = ''
        do i = 1, count
            heads = heads//right('E', width)//right('S', width)
        end do
    end function repeated_heads

    !> The area of LOFT's curve at the multiplier printed.
    real(dp) function area_at(given, is_closed) result(area)
        type(printed_type), intent(in) :: given     !! weight and multiplier
        logical, intent(in) :: is_closed            !! a ring
        type(fairing_type) :: curve
        type(error_type), allocatable :: error
        call fair(points_of(given%weight, is_closed), given%multiplier, curve, error)
        area = curve%area
    end function area_at

    !> The row of a curve.
    function row_text(given, row) result(text)
        type(printed_type), intent(in) :: given     !! as printed
        type(inlet_row_type), intent(in) :: row     !! LOFT's
        character(80) :: text
        text = right(shortest(given%weight), width)//fixed(given%multiplier, lambda_width, 1)// &
            figure(given%energy)//figure(given%area)//figure(faired_energy(row%closed))// &
            figure(row%closed%area)//figure(faired_energy(row%open))//figure(row%open%area)
    end function row_text

    !> A figure in a sentence.
    pure function said(value) result(text)
        real(dp), intent(in) :: value !! any
        character(:), allocatable :: text
        text = trim(adjustl(figure(value)))
    end function said

    !> A figure in its columns.
    pure function figure(value) result(text)
        real(dp), intent(in) :: value !! any
        character(:), allocatable :: text
        text = fixed(value, width, decimals)
    end function figure

    !> LOFT's curves.
    function inlet_rows() result(rows)
        type(inlet_row_type) :: rows(3)
        integer :: i
        do i = 1, 3
            rows(i)%closed = curve_of(printed(i), .true.)
            rows(i)%open = curve_of(printed(i), .false.)
        end do
    end function inlet_rows

    !> A curve of LOFT's.
    type(fairing_type) function curve_of(given, is_closed) result(curve)
        type(printed_type), intent(in) :: given     !! weight and area
        logical, intent(in) :: is_closed            !! a ring
        type(error_type), allocatable :: error
        if (given%asked > 0.0_dp) then
            call fair_to_area(points_of(given%weight, is_closed), given%asked, curve, error)
        else
            call fair(points_of(given%weight, is_closed), 0.0_dp, curve, error)
        end if
        if (allocated(error)) error stop 'the inlet can''t be faired'
    end function curve_of

    !> The points of the inlet with a weight.
    type(fairing_data_type) function points_of(weight, is_closed) result(given)
        real(dp), intent(in) :: weight      !! of each
        logical, intent(in) :: is_closed    !! a ring; the last point is not given again
        integer :: count
        count = merge(14, 15, is_closed)
        allocate (given%point, source=inlet(:, :count))
        given%beta = 0.5_dp
        given%ends = merge(fairing_end%closed, fairing_end%free, is_closed)
        allocate (given%weight(count), source=weight)
    end function points_of

    !> By how much the areas of two least curves, of weights 1E6 and 100, can differ where their
    !> energies differ by a drop, about: the difference d of their vertices has
    !> drop = 200 sum |p(d)|**2 + E(d), the least of which for a change of S is that of curves of
    !> weight 200, drop = dS**2/(2 |dS/dlambda|).
    real(dp) function largest_step(drop) result(step)
        real(dp), intent(in) :: drop    !! of E
        type(fairing_type) :: curve
        type(error_type), allocatable :: error
        call fair(points_of(200.0_dp, .false.), 0.0_dp, curve, error)
        step = sqrt(2.0_dp*drop*abs(curve%area_slope))
    end function largest_step

end module support_book_inlet
