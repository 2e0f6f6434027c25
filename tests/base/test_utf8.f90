!> Characters in UTF-8. The bytes are those of the examples and of the table of RFC 3629.
program test_utf8
    use base_kinds, only: i64
    use base_utf8, only: character_length, code_point
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    integer :: i

    call tap%ok(all([(character_length(char(i)//'xyz'), i=0, 127)] == 1), 'ASCII is one byte')
    call tap%ok(all([(code_point(char(i)), i=0, 127)] == [(i, i=0, 127)]), 'of its own number')
    call tap%ok(all([(character_length(char(i)//char(128)//char(128)//char(128)), i=128, 193)] &
        == 0), 'no character begins with a continuation, nor with C0 or C1')
    call tap%ok(all([(character_length(char(i)//char(144)//char(128)//char(128)), i=245, 255)] &
        == 0), 'nor with F5 to FF')
    call compare([195, 169], int(z'E9'), 'e acute')
    call compare([226, 137, 162], int(z'2262'), 'not identical to (RFC 3629, section 7)')
    call compare([237, 149, 156], int(z'D55C'), 'a Korean letter (section 7)')
    call compare([240, 163, 142, 180], int(z'233B4'), 'a letter beyond 16 bits (section 7)')
    call compare([194, 128], int(z'80'), 'the least of two bytes')
    call compare([223, 191], int(z'7FF'), 'the last of two bytes')
    call compare([224, 160, 128], int(z'800'), 'the least of three bytes')
    call compare([239, 191, 191], int(z'FFFF'), 'the last of three bytes')
    call compare([240, 144, 128, 128], int(z'10000'), 'the least of four bytes')
    call compare([244, 143, 191, 191], int(z'10FFFF'), 'the last of all')
    call refuse([192, 175], 'a letter written too long')
    call refuse([224, 159, 191], 'three bytes for what two can hold')
    call refuse([237, 160, 128], 'half a surrogate pair')
    call refuse([240, 143, 191, 191], 'four bytes for what three can hold')
    call refuse([244, 144, 128, 128], 'what is beyond Unicode')
    call refuse([195], 'half a letter')
    call refuse([226, 137, 65], 'a letter broken by ASCII')
    call tap%finish()

contains

    !> Checks the length and the number of a character, alone and with more behind it.
    subroutine compare(bytes, code, name)
        integer, intent(in) :: bytes(:)     !! its bytes
        integer, intent(in) :: code         !! its number
        character(*), intent(in) :: name    !! which

        call tap%ok(character_length(text_of(bytes)) == size(bytes) .and. &
            character_length(text_of(bytes)//'a') == size(bytes) .and. &
            code_point(text_of(bytes)) == code, name)
    end subroutine compare

    !> Checks that bytes are no character.
    subroutine refuse(bytes, name)
        integer, intent(in) :: bytes(:)     !! its bytes
        character(*), intent(in) :: name    !! which
        call tap%ok(character_length(text_of(bytes)) == 0, 'refused: '//name)
    end subroutine refuse

    !> Bytes as text.
    pure function text_of(bytes) result(text)
        integer, intent(in) :: bytes(:) !! 0 to 255
        character(size(bytes, kind=i64)) :: text
        integer :: k
        do k = 1, size(bytes)
            text(k:k) = char(bytes(k))
        end do
    end function text_of

end program test_utf8
