!> The card of the 1970 program as numbers: exact decimals, before the machine cuts them.
!>
!>     columns  1-8   9-16  17-24  25-32  33-40  41-48  49-56  57-64  65-70  71-76  77-78
!>     field    X1    Y1    S1     X2     Y2     X3     Y3     S3     XI     YI     ITYP
!>
!> Source: SAE 700202, appendix A, statement 9.
module period_card
    use base_decimal, only: decimal_type
    implicit none (type, external)
    private

    !> One conic to be computed. Coordinates in deck units.
    type, public :: period_card_type
        type(decimal_type) :: x1  !! first point, X
        type(decimal_type) :: y1  !! first point, Y
        type(decimal_type) :: s1  !! slope dy/dx at the first point
        type(decimal_type) :: x2  !! shoulder point, X
        type(decimal_type) :: y2  !! shoulder point, Y
        type(decimal_type) :: x3  !! last point, X
        type(decimal_type) :: y3  !! last point, Y
        type(decimal_type) :: s3  !! slope dy/dx at the last point
        type(decimal_type) :: xi  !! increment of X
        type(decimal_type) :: yi  !! increment of Y
        integer :: ityp = 0       !! not zero: a Y table follows the X table
    end type period_card_type

end module period_card
