!> How a value became a printed figure, and what a printed figure tells of the value.
!>
!> | way        | a figure f of unit u allows                               |
!> |------------|-----------------------------------------------------------|
!> | rounded    | f - u/2 to f + u/2, halves away from zero                 |
!> | half even  | the same, halves to the even figure                       |
!> | truncated  | f to f + u for a positive one, f - u to f for a negative  |
!> | of 1970    | .0005 was added to the value and the sum was rounded      |
!>
!> Source of the last: SAE 700202, appendix A, where .0005 is added to every ordinate before it is
!> written in F9.3, which rounds by itself.
module audit_printing
    use audit_figure, only: form, scale_type, unit_of, value_of
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: allowed, printed_units, printing_name

    !> Ways of printing.
    type, public :: printing_list
        integer :: unknown = 0   !! to be found out
        integer :: rounded = 1   !! halves away from zero
        integer :: truncated = 2 !! further figures cut off
        integer :: of_1970 = 3   !! .0005 added, then rounded
        integer :: half_even = 4 !! rounded, halves to the even figure
    end type printing_list
    !> The ways by name: `printing%rounded`.
    type(printing_list), parameter, public :: printing = printing_list()

    !> What the 1970 program adds to every ordinate, deck units.
    real(dp), parameter :: added_1970 = 0.0005_dp

contains

    !> The least and the largest value that a figure of so many units may stand for.
    pure function allowed(units, scale, way) result(between)
        integer(i64), intent(in) :: units     !! of the last place
        type(scale_type), intent(in) :: scale !! form and decimals
        integer, intent(in) :: way            !! one of `printing%...`; unknown counts as rounded
        real(dp) :: between(2)
        real(dp) :: u

        u = unit_of(scale)
        between = value_of(units, scale)
        if (way == printing%truncated) then
            if (units >= 0) between(2) = between(2) + u
            if (units <= 0) between(1) = between(1) - u
        else
            between = between + [-0.5_dp, 0.5_dp]*u
            if (way == printing%of_1970) between = between - added_1970
        end if
    end function allowed

    !> The figure that a value is printed as, in units of the last place. A value within rounding of
    !> a half counts as a half.
    elemental integer(i64) function printed_units(value, scale, way) result(units)
        real(dp), intent(in) :: value         !! deck units, inches for eighths
        type(scale_type), intent(in) :: scale !! form and decimals
        integer, intent(in) :: way            !! one of `printing%...`; unknown counts as rounded
        real(dp), parameter :: noise = 1.0e-9_dp, most = 1.0e17_dp
        real(dp) :: written, size, whole

        written = value
        if (way == printing%of_1970) written = written + added_1970
        size = abs(written)*8.0_dp
        if (scale%form == form%decimal) size = abs(written)*10.0_dp**scale%decimals
        size = min(size, most)
        whole = aint(size + noise)
        if (way /= printing%truncated .and. size - whole >= 0.5_dp - noise) then
            if (way /= printing%half_even .or. size - whole > 0.5_dp + noise .or. &
                modulo(whole, 2.0_dp) > 0.5_dp) whole = whole + 1.0_dp
        end if
        units = int(sign(whole, written), i64)
    end function printed_units

    !> A way of printing in words.
    pure function printing_name(way) result(name)
        integer, intent(in) :: way !! one of `printing%...`
        character(24), parameter :: names(0:4) = [character(24) :: 'unknown', 'rounded', &
            'truncated', '.0005 added and rounded', 'rounded, halves to even']
        character(len_trim(names(way), i64)) :: name
        name = names(way)
    end function printing_name

end module audit_printing
