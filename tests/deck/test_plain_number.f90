!> Plain numbers, by hand.
program test_plain_number
    use base_decimal, only: decimal_type
    use base_kinds, only: i64
    use deck_plain_number, only: most_figures, read_plain
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call reads('  -30.25', .false., -3025_i64, -2, 'blanks, a minus, figures and a point')
    call reads('+.5', .false., 5_i64, -1, 'a plus and no figure before the point')
    call reads('  12345.', .false., 12345_i64, 0, 'no figure behind the point')
    call reads('   -0.00', .false., 0_i64, 0, 'a zero has no sign and no power')
    call reads(' 1', .true., 1_i64, 0, 'a whole number')
    call reads('-7', .true., -7_i64, 0, 'a whole number below zero')
    call reads(repeat('9', most_figures - 1)//'.', .false., 10_i64**17_i64 - 1_i64, 0, &
        'all figures that a field of 18 columns holds')
    call leaves('30', .false., 'no point is not plain')
    call leaves('1.', .true., 'a point in a whole number is not')
    call leaves('-30.   ', .false., 'a blank behind the figures is not')
    call leaves('1 2.', .false., 'nor is one between them')
    call leaves('   .', .false., 'a point alone is not')
    call leaves('   -', .true., 'a sign alone is not')
    call leaves('1.2.', .false., 'nor two points')
    call leaves('--1.', .false., 'nor two signs')
    call leaves('1.E2', .false., 'nor an exponent')
    call leaves('1.O', .false., 'nor a letter')
    call leaves(repeat('1', most_figures)//'.', .false., 'nor what may have too many figures')
    call tap%finish()

contains

    !> A field is a plain number.
    subroutine reads(field, is_whole, digits, power, name)
        character(*), intent(in) :: field   !! the field
        logical, intent(in) :: is_whole     !! a whole number is asked for
        integer(i64), intent(in) :: digits  !! its figures
        integer, intent(in) :: power        !! and their power of ten
        character(*), intent(in) :: name    !! of the check
        type(decimal_type) :: value
        logical :: is_plain

        call read_plain(field, is_whole, value, is_plain)
        call tap%ok(is_plain .and. value%digits == digits .and. value%power == power, name)
    end subroutine reads

    !> A field is not a plain number.
    subroutine leaves(field, is_whole, name)
        character(*), intent(in) :: field   !! the field
        logical, intent(in) :: is_whole     !! a whole number is asked for
        character(*), intent(in) :: name    !! of the check
        type(decimal_type) :: value
        logical :: is_plain

        value = decimal_type(7, 7)
        call read_plain(field, is_whole, value, is_plain)
        call tap%ok(.not. is_plain .and. value%digits == 7 .and. value%power == 7, name)
    end subroutine leaves

end program test_plain_number
