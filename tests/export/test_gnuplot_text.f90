!> Text of a deck on its way into gnuplot. That gnuplot reads it back as it was is proved in plot.t.
program test_gnuplot_text
    use base_kinds, only: dp
    use export_gnuplot_text, only: number_text, plain, quoted
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(*), parameter :: e_acute = char(195)//char(169), &
        euro = char(226)//char(130)//char(172)
    character, parameter :: backslash = achar(92)
    character(24) :: back
    real(dp) :: value
    integer :: i
    character(256) :: every

    call tap%same(quoted('NOSE, STA 0 (a=b)'), '"NOSE, STA 0 (a=b)"', 'plain words stay readable')
    call tap%same(quoted(''), '""', 'nothing is an empty string')
    call tap%same(quoted('it''s'), '"it'//backslash//'047s"', 'an apostrophe goes by its number')
    call tap%same(quoted('"'), '"'//backslash//'042"', 'so does a quotation mark')
    call tap%same(quoted(backslash), '"'//backslash//'134"', 'so does a backslash')
    call tap%same(quoted('`@$'), '"'//backslash//'140'//backslash//'100'//backslash//'044"', &
        'so do backquote, macro and dollar')
    do i = 1, 256
        every(i:i) = char(i - 1)
    end do
    call tap%ok(scan(inside(quoted(every)), '"''`@$#{}%'//achar(10)//achar(0)) == 0, &
        'of all bytes none that gnuplot obeys is left')

    call tap%same(plain('a'//achar(10)//achar(9)//achar(27)//'b'//achar(127)), 'a   b ', &
        'control bytes become blanks')
    call tap%same(plain(e_acute//euro), e_acute//euro, 'letters beyond ASCII stay')
    call tap%same(plain(char(195)), '?', 'half a letter is a question mark')
    call tap%same(plain(char(130)//'x'), '?x', 'a continuation without its letter too')
    call tap%same(plain(char(192)//char(175)), '??', 'and a letter written too long')
    call tap%same(plain(char(237)//char(160)//char(128)), '???', 'and half a surrogate pair')
    call tap%same(plain(char(244)//char(144)//char(128)//char(128)), '????', &
        'and what is beyond Unicode')
    call tap%same(plain(char(240)//char(159)//char(155)//char(169)), &
        char(240)//char(159)//char(155)//char(169), 'four bytes are a letter')
    call tap%same(plain('x'//char(194)//char(155)//'y'), 'x  y', &
        'a control character of Latin-1 becomes blank')
    call tap%same(plain(''), '', 'nothing stays nothing')

    back = number_text(0.1_dp)
    read (back, *) value
    call tap%ok(value == 0.1_dp, 'a number keeps all its figures')
    back = number_text(-90000.123456789_dp)
    read (back, *) value
    call tap%ok(value == -90000.123456789_dp, 'also far from zero')
    back = number_text(-1.2345678901234567e-280_dp)
    read (back, *) value
    call tap%ok(value == -1.2345678901234567e-280_dp, 'and very near to it')
    call tap%finish()

contains

    !> A string without its quotation marks.
    pure function inside(text)
        character(*), intent(in) :: text !! in quotation marks
        character(:), allocatable :: inside
        inside = text(2:len(text) - 1)
    end function inside

end program test_gnuplot_text
