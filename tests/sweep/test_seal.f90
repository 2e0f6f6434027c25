!> Seals of rows: the figures of FIPS 180-4, and that no damage fits them.
program test_seal
    use support_tap, only: tap_type
    use sweep_seal, only: sealed, unseal
    implicit none (type, external)

    character(*), parameter :: row = '12,-7.5,0.45,8013.2,,fault,,"line 9, columns 57-64: none"'
    type(tap_type) :: tap
    character(:), allocatable :: line, back
    logical :: fits
    integer :: i, k, missed

    ! Examples of the standard: of 'abc', and of nothing.
    call tap%same(sealed('abc'), 'abc,ba7816bf', 'the seal is of the SHA-256 of the row')
    call tap%same(sealed(''), ',e3b0c442', 'of an empty row, too')
    line = sealed(row)
    call unseal(line, back, fits)
    call tap%ok(fits, 'a row fits its seal')
    call tap%same(back, row, 'which is taken off')
    missed = 0
    do i = 1, len(line)
        do k = 0, 7
            line = sealed(row)
            line(i:i) = achar(ieor(iachar(line(i:i)), 2**k))
            call unseal(line, back, fits)
            if (fits) missed = missed + 1
        end do
        call unseal(line(:i - 1), back, fits)
        if (fits) missed = missed + 1
    end do
    call tap%ok(missed == 0, 'a row with a bit changed, or cut short, does not')
    call tap%finish()
end program test_seal
