!> The kinds LOFT computes with, named once.
module base_kinds
    use, intrinsic :: iso_fortran_env, only: int64, real64
    implicit none (type, external)
    private

    !> Working precision of all geometry: IEEE binary64.
    integer, parameter, public :: dp = real64
    !> Counters that may pass two thousand million: cards, lines, bytes.
    integer, parameter, public :: i64 = int64
    !> Whole numbers of 38 digits: exact decimals, products of hexadecimal fractions.
    integer, parameter, public :: i128 = selected_int_kind(38)

end module base_kinds
