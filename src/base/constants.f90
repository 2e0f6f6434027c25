!> Numbers of mathematics and of the trade, each said once.
module base_constants
    use base_kinds, only: dp
    implicit none (type, external)
    private

    !> The circle's half circumference over its radius.
    real(dp), parameter, public :: pi = acos(-1.0_dp)
    !> Degrees in a radian.
    real(dp), parameter, public :: degrees = 180.0_dp/pi
    !> A slope of this size or more means a vertical tangent; punched as 999.999, the largest that
    !> fits the field (SAE 700202, text before appendix A).
    real(dp), parameter, public :: vertical_slope = 999.99_dp
    !> Rows of the longest table LOFT makes: beyond it the increment was surely mistyped.
    integer, parameter, public :: largest_table = 100000
    !> The name and version of the program; everything that states a version takes it from here.
    character(*), parameter, public :: version = '0.1.0'

end module base_constants
