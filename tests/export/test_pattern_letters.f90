!> Tests of text on paper. Bytes and numbers are those of RFC 3629, of the table of WinAnsiEncoding
!> and of the AFM files of Helvetica.
program test_pattern_letters
    use base_kinds, only: dp
    use export_pattern_letters, only: codes_of, shortened, text_width, unknown, utf8, win_ansi
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    integer, allocatable :: codes(:)
    integer :: i

    allocate (codes(0))
    codes = codes_of('A'//char(195)//char(169)//char(226)//char(130)//char(172))
    call tap%ok(size(codes) == 3 .and. all(codes == [65, 233, 8364]), &
        'letters of one, two and three bytes')
    codes = codes_of('a'//char(255)//'b'//char(195))
    call tap%ok(size(codes) == 4 .and. all(codes == [97, unknown, 98, unknown]), &
        'a byte that is no letter stands for itself alone')
    codes = codes_of(char(10)//char(0)//char(127)//char(194)//char(133)//char(239)//char(191)// &
        char(190))
    call tap%ok(size(codes) == 5 .and. all(codes == unknown), &
        'controls and what is no character of XML are unknown')
    codes = codes_of('')
    call tap%ok(size(codes) == 0, 'no text, no letters')
    codes = [32, 126, 160, 2047, 2048, 65533, 65536, 1114109]
    do i = 1, size(codes)
        call tap%ok(all(codes_of(utf8(codes(i))) == codes(i)), 'a letter comes back from its bytes')
    end do
    call tap%ok(win_ansi(65) == 'A' .and. ichar(win_ansi(233)) == 233, &
        'Latin letters are their own')
    call tap%ok(ichar(win_ansi(8364)) == 128 .and. ichar(win_ansi(8211)) == 150 .and. &
        ichar(win_ansi(376)) == 159, 'euro, dash and Y diaeresis are Windows'' own')
    call tap%ok(win_ansi(1046) == '?' .and. win_ansi(0) == '?' .and. win_ansi(133) == '?', &
        'what the type has not is a question mark')
    call tap%near(text_width('STA 20', 1.0_dp, .false.), 3.335_dp, 1.0e-12_dp, &
        'S T A, blank, 2 0 of Helvetica: 667 611 667 278 556 556')
    call tap%near(text_width('STA 20', 2.0_dp, .true.), 6.78_dp, 1.0e-12_dp, &
        'of Helvetica-Bold: 667 611 722 278 556 556')
    call tap%near(text_width(char(194)//char(176), 1.0_dp, .false.), 0.4_dp, 1.0e-12_dp, &
        'the sign of degrees')
    call tap%same(shortened('STA 20', 1.0_dp, 3.4_dp), 'STA 20', 'what has room is not shortened')
    call tap%same(shortened('STA 20', 1.0_dp, 3.2_dp), 'STA...', 'what has none ends in points')
    call tap%same(shortened('STA 20', 1.0_dp, 0.1_dp), '...', 'however short')
    call tap%finish()
end program test_pattern_letters
