!> Slips that turn one figure into another.
program test_slip
    use audit_figure, only: form, scale_type
    use audit_slip, only: chance_likelihood, slip, slip_likelihood, slip_name
    use base_kinds, only: dp, i64
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(scale_type), parameter :: three = scale_type(form%decimal, 3)
    type(scale_type), parameter :: eighths = scale_type(form%eighths, 0)
    integer(i64), parameter :: none(2) = huge(1_i64)
    integer :: i

    ! Of the scan of SAE 700202, and made up.
    call says('16.546', 16544_i64, slip%digit, 'a 4 read as 6 is one digit')
    call says('-2.2110', -2211_i64, slip%extra, 'a digit too many')
    call says('-6.43', -6438_i64, slip%missing, 'a digit missing')
    call says('-6.348', -6438_i64, slip%swapped, 'two digits in wrong order')
    call says('64.38', 6438_i64, slip%point, 'the point moved')
    call says('9.000', -9000_i64, slip%sign, 'the sign lost')
    call says('-9.000', 9000_i64, slip%sign, 'or put')
    call says('-6.438', -6358_i64, slip%digits, 'two digits taken for others')
    call says('-4.8159', -4810_i64, slip%both, 'a digit wrong and one more')
    call says('13.464', 14464_i64, slip%inch, 'an inch less')
    call says('4.625', 4500_i64, slip%eighth, 'an eighth more')
    call says('1.234', 5678_i64, slip%none, 'no slip')
    call says('-7.?99', -7099_i64, slip%unread, 'an unreadable character')
    call says('-7.?99', -7098_i64, slip%none, 'which is not just any character')
    call tap%ok(kind_of('4-8-3', 443_i64, eighths, none) == slip%inch, 'an inch, in eighths')
    call tap%ok(kind_of('4-11-0', 376_i64, eighths, none) == slip%foot, 'a foot, in eighths')
    call tap%same(slip_name(slip%foot), 'a slip of a foot', 'called so')
    call tap%ok(kind_of('4-7-4', 443_i64, eighths, none) == slip%eighth, 'an eighth, in eighths')
    call tap%ok(kind_of('5.123', 6438_i64, three, [5123_i64, 9000_i64]) == slip%row, &
        'the figure of the row before')
    call tap%ok(likelihood_of('13.344', 13844_i64) > 5.0_dp*likelihood_of('13.744', 13844_i64), &
        'a 3 is rather an 8 than a 7')
    call tap%ok(chance_likelihood('13.344') < likelihood_of('13.744', 13844_i64), &
        'chance is a worse explanation than any slip')
    do i = 1, 3
        if (len(slip_name(i)) == 0) exit
    end do
    call tap%ok(i == 4, 'slips have names')
    call tap%finish()

contains

    !> Checks which slip explains a figure to three decimals.
    subroutine says(text, units, kind, name)
        character(*), intent(in) :: text    !! as read
        integer(i64), intent(in) :: units   !! as it should be
        integer, intent(in) :: kind         !! one of `slip%...`
        character(*), intent(in) :: name    !! the check as a phrase
        call tap%ok(kind_of(text, units, three, none) == kind, name)
    end subroutine says

    !> The slip that explains a figure.
    integer function kind_of(text, units, scale, beside) result(kind)
        character(*), intent(in) :: text       !! as read
        integer(i64), intent(in) :: units      !! as it should be
        type(scale_type), intent(in) :: scale  !! its places
        integer(i64), intent(in) :: beside(2)  !! the rows beside
        real(dp) :: likelihood
        call slip_likelihood(text, units, beside, scale, likelihood, kind)
    end function kind_of

    !> How likely a figure to three decimals is read so.
    real(dp) function likelihood_of(text, units) result(likelihood)
        character(*), intent(in) :: text    !! as read
        integer(i64), intent(in) :: units   !! as it should be
        integer :: kind
        call slip_likelihood(text, units, none, three, likelihood, kind)
    end function likelihood_of

end program test_slip
