!> Numbers and cards as they are punched, for tests that start from card images.
module support_punched
    use base_decimal, only: decimal_type
    use period_card, only: period_card_type
    implicit none (type, external)
    private

    public :: card_of, decimal

contains

    !> A card image as numbers, all punched with their points.
    function card_of(image) result(card)
        character(*), intent(in) :: image
        type(period_card_type) :: card
        character(80) :: columns
        columns = image
        card%x1 = decimal(columns(1:8))
        card%y1 = decimal(columns(9:16))
        card%s1 = decimal(columns(17:24))
        card%x2 = decimal(columns(25:32))
        card%y2 = decimal(columns(33:40))
        card%x3 = decimal(columns(41:48))
        card%y3 = decimal(columns(49:56))
        card%s3 = decimal(columns(57:64))
        card%xi = decimal(columns(65:70))
        card%yi = decimal(columns(71:76))
        if (columns(77:78) /= '') read (columns(77:78), *) card%ityp
    end function card_of

    !> A number with a point, `-7.1`, or with an exponent, `1.E-50`; blank is zero.
    function decimal(field) result(d)
        character(*), intent(in) :: field
        type(decimal_type) :: d
        character(len(field)) :: digits
        integer :: point, power

        if (field == '') return
        digits = adjustl(field)
        power = 0
        if (index(digits, 'E') > 0) then
            read (digits(index(digits, 'E') + 1:), *) power
            digits = digits(:index(digits, 'E') - 1)
        end if
        point = index(digits, '.')
        power = power - (len_trim(digits) - point)
        digits = digits(:point - 1)//digits(point + 1:)
        read (digits, *) d%digits
        d%power = power
    end function decimal

end module support_punched
