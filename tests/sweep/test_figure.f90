!> Numbers in fields: eight columns at most, the nearest such text, the shortest of those.
program test_figure
    use base_kinds, only: dp
    use sweep_figure, only: field_figure, figure_value
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(random_type) :: random
    real(dp) :: value, off
    integer :: i, far, unlike
    character(:), allocatable :: text

    call same(0.0_dp, '0.')
    call same(-7.1_dp, '-7.1')
    call same(0.5_dp, '.5')
    call same(-0.5_dp, '-.5')
    call same(12.0_dp, '12.')
    call same(1.0_dp/3.0_dp, '.3333333')
    call same(-1.0_dp/3.0_dp, '-.333333')
    call same(200.0_dp/3.0_dp, '66.66667')
    call same(-123456.789_dp, '-123457.')
    call same(9999999.6_dp, '1.E7')
    call same(1234567.8_dp, '1234568.')
    call same(1.23456789e10_dp, '1.235E10')
    call same(0.00001_dp, '.00001')
    call same(1.236e-7_dp, '1.236E-7')
    call same(-2.5e-40_dp, '-2.5E-40')
    far = 0
    unlike = 0
    do i = 1, 20000
        value = random%sign()*10.0_dp**random%between(-12.0_dp, 12.0_dp)
        text = field_figure(value)
        off = abs(figure_value(text)/value - 1.0_dp)
        if (off > 6.0e-2_dp) far = far + 1
        if (abs(value) > 1.0e-3_dp .and. abs(value) < 1.0e6_dp .and. off > 1.0e-3_dp) far = far + 1
        if (abs(value) > 1.0_dp .and. abs(value) < 1.0e6_dp .and. off > 1.0e-5_dp) far = far + 1
        if (field_figure(figure_value(text)) /= text) unlike = unlike + 1
    end do
    call tap%ok(far == 0, 'none is far from its number')
    call tap%ok(unlike == 0, 'what was read is written the same')
    call tap%finish()

contains

    !> A number is written so, and reads as what is written.
    subroutine same(value, text)
        real(dp), intent(in) :: value
        character(*), intent(in) :: text
        call tap%same(trim(field_figure(value)), text, 'a field has '//text)
    end subroutine same

end program test_figure
