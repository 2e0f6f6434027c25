!> Tests of words in DXF files. Oracles: RFC 3629 and the Unicode code charts, formatting rules of
!> Autodesk's "DXF Reference", names of R12.
program test_dxf_text
    use export_dxf_text, only: dxf_text, layer_name, name_length
    use support_tap, only: tap_type
    implicit none (type, external)
    type(tap_type) :: tap

    call check_text()
    call check_bytes()
    call check_layers()
    call tap%finish()

contains

    subroutine check_text()
        call tap%same(dxf_text('FRAME 3, STA 20.5 (AFT)'), 'FRAME 3, STA 20.5 (AFT)', &
            'plain words stay')
        call tap%same(dxf_text('K'//char(195)//char(188)//'hn'), 'K\U+00FChn', &
            'u with two dots is U+00FC')
        call tap%same(dxf_text(char(226)//char(136)//char(133)//'9'), '\U+22059', &
            'the empty set is U+2205')
        call tap%same(dxf_text(char(240)//char(159)//char(155)//char(169)), '?', &
            'beyond U+FFFF there is no escape')
        call tap%same(dxf_text('a^b'), 'a^ b', 'a caret stands with a blank')
        call tap%same(dxf_text('50%'), '50%', 'one sign of per cent stays')
        call tap%same(dxf_text('90%%d'), '90%%%%%%d', 'two would begin a special character')
        call tap%same(dxf_text(''), '', 'no words are no words')
    end subroutine check_text

    subroutine check_bytes()
        character(:), allocatable :: long
        call tap%same(dxf_text('a'//char(10)//'b'//char(0)//char(127)), 'a?b??', &
            'control bytes can not break a line')
        call tap%same(dxf_text(char(255)//'A'), '\U+FFFDA', 'a byte that is no UTF-8')
        call tap%same(dxf_text(char(195)), '\U+FFFD', 'a character that is cut off')
        call tap%same(dxf_text(char(237)//char(160)//char(128)), '\U+FFFD\U+FFFD\U+FFFD', &
            'a surrogate is no character')
        long = dxf_text(repeat(char(195)//char(188), 300))
        call tap%ok(len(long) <= 255, 'no text is longer than R12 reads')
        call tap%ok(mod(len(long), len('\U+00FC')) == 0, 'and none is cut within a character')
    end subroutine check_bytes

    subroutine check_layers()
        character(name_length) :: none(0), two(2)

        two = [character(name_length) :: 'STA-20_5', 'STA-20_5_2']
        call tap%same(trim(layer_name('Sta-20.5', none)), 'STA-20_5', &
            'capitals; a point is no letter of a layer')
        call tap%same(trim(layer_name('sta-20.5', two)), 'STA-20_5_3', &
            'a name that is taken gets the next number')
        call tap%same(trim(layer_name('A$B-C_9', none)), 'A$B-C_9', 'what R12 allows stays')
        call tap%same(trim(layer_name('', none)), '_', 'there is no empty name')
        call tap%same(trim(layer_name('PLANE-THROUGH-A-VERY-LONG-NAME-12.5', none)), &
            'E-THROUGH-A-VERY-LONG-NAME-12_5', 'of a long name the last 31 characters are kept')
        call tap%same(trim(layer_name(repeat('X', 40), [repeat('X', 31)])), &
            repeat('X', 29)//'_2', 'the number takes the place of the last characters')
        call tap%ok(verify(trim(layer_name('B'//char(200)//'.*?<>|;', none)), &
            'ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789$-_') == 0, 'no other character gets through')
    end subroutine check_layers

end program test_dxf_text
