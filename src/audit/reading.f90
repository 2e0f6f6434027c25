!> What is known of a line: readings, each a printed figure and what it stands for, and how the
!> line was made and printed.
!>
!>     line%name = 'MHB side'
!>     line%scale = scale_type(form%decimal, 3)
!>     call add(line, new_reading(sort%ordinate, 5.0_dp, '-6.717'))            a row of the table
!>     call add(line, new_reading(sort%ordinate, -30.0_dp, '-10.0', meaning%exact))   an end point
!>     call add(line, new_reading(sort%slope, -30.0_dp, '.114', meaning%exact))
!>     call add(line, new_reading(sort%slope, 50.0_dp, '.052', meaning%rounded))
module audit_reading
    use audit_figure, only: figure_length, figure_type, form, read_figure, scale_type
    use audit_printing, only: printing
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: reading_type, line_type, new_reading, add, common_decimals, decimals_met

    !> What a figure is of the line.
    type, public :: sort_list
        integer :: ordinate = 1    !! y at an abscissa x
        integer :: abscissa = 2    !! x at an ordinate y
        integer :: slope = 3       !! dy/dx at an abscissa x
        integer :: coefficient = 4 !! A to E of A xx + B xy + C yy + D x + E y = -1
    end type sort_list
    !> The sorts by name: `sort%ordinate`.
    type(sort_list), parameter, public :: sort = sort_list()

    !> What a figure says of its value.
    type, public :: meaning_list
        integer :: printed = 1 !! a figure of the table: printed as the line's figures are
        integer :: exact = 2   !! the very number, as it was punched
        integer :: rounded = 3 !! rounded to the decimals it has, however the table was printed
        integer :: between = 4 !! from `low` to `high`
    end type meaning_list
    !> The meanings by name: `meaning%exact`.
    type(meaning_list), parameter, public :: meaning = meaning_list()

    !> One figure and what it stands for.
    type :: reading_type
        integer :: sort = 1            !! one of `sort%...`
        integer :: meaning = 1         !! one of `meaning%...`
        integer :: column = 1          !! which root of the conic: rows of a column are on one side
        integer :: letter = 0          !! of a coefficient: 1 to 5 for A to E
        real(dp) :: along = 0.0_dp     !! x, or y of an abscissa, deck units
        real(dp) :: low = 0.0_dp       !! least value, where `between`
        real(dp) :: high = 0.0_dp      !! greatest value, where `between`
        logical :: is_sure = .false.   !! beyond doubt: is never suspected
        type(figure_type) :: figure    !! as printed
    end type reading_type

    !> A line to be audited.
    type :: line_type
        character(figure_length) :: name = ''            !! for messages
        type(scale_type) :: scale = scale_type(1, -1)    !! of its figures; decimals -1: most have
        integer :: printing = printing%unknown           !! one of `printing%...`
        integer :: conics = 1                            !! how many, joined end to end
        real(dp) :: shift = 100.0_dp                     !! that the 1970 program added to x and y
        type(reading_type), allocatable :: reading(:)    !! rows in order along the line, then ends
    end type line_type

contains

    !> A reading.
    pure type(reading_type) function new_reading(sort_of, along, text, meaning_of, form_of) &
            result(reading)
        integer, intent(in) :: sort_of               !! one of `sort%...`
        real(dp), intent(in) :: along                !! abscissa, or ordinate of an abscissa
        character(*), intent(in) :: text             !! the figure as printed
        integer, intent(in), optional :: meaning_of  !! one of `meaning%...`, else printed
        integer, intent(in), optional :: form_of     !! one of `form%...`, else decimal
        integer :: written

        written = form%decimal
        if (present(form_of)) written = form_of
        reading%sort = sort_of
        reading%along = along
        if (present(meaning_of)) reading%meaning = meaning_of
        reading%figure = read_figure(text, written)
    end function new_reading

    !> Puts a reading behind the others of a line.
    pure subroutine add(line, reading)
        type(line_type), intent(inout) :: line     !! the line
        type(reading_type), intent(in) :: reading  !! one more
        type(reading_type), allocatable :: longer(:)
        integer :: n

        n = 0
        if (allocated(line%reading)) n = size(line%reading)
        allocate (longer(n + 1))
        if (n > 0) longer(:n) = line%reading
        longer(n + 1) = reading
        call move_alloc(longer, line%reading)
    end subroutine add

    !> The decimals that most figures of a table have, the fewer where two are as frequent.
    pure integer function common_decimals(reading) result(decimals)
        type(reading_type), intent(in) :: reading(:) !! of a line
        decimals = maxloc(decimals_met(reading), dim=1) - 1
    end function common_decimals

    !> How many figures of a table have how many decimals.
    pure function decimals_met(reading) result(met)
        type(reading_type), intent(in) :: reading(:) !! of a line
        integer :: met(0:figure_length)
        integer :: i

        met = 0
        do i = 1, size(reading)
            if (reading(i)%meaning /= meaning%printed) cycle
            if (.not. reading(i)%figure%is_sound .or. reading(i)%sort > sort%abscissa) cycle
            associate (n => met(reading(i)%figure%scale%decimals))
                n = n + 1
            end associate
        end do
    end function decimals_met

end module audit_reading
