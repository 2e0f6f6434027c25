!> Characters in UTF-8 (RFC 3629). Text of a deck may be any bytes; what is no UTF-8 has length 0.
module base_utf8
    implicit none (type, external)
    private

    public :: character_length, code_point

contains

    !> Bytes of the character in front of a text; 0 where it is no UTF-8 (RFC 3629, section 4).
    pure integer function character_length(text) result(length)
        character(*), intent(in) :: text !! at least one byte
        integer :: first, second, i

        first = ichar(text(1:1))
        length = 0
        if (first < 128) length = 1
        if (first >= 194 .and. first < 224) length = 2
        if (first >= 224 .and. first < 240) length = 3
        if (first >= 240 .and. first < 245) length = 4
        if (length > len(text)) length = 0
        if (length < 2) return
        second = ichar(text(2:2))
        if (first == 224 .and. second < 160 .or. first == 237 .and. second >= 160 .or. &
            first == 240 .and. second < 144 .or. first == 244 .and. second >= 144) length = 0
        do i = length, 2, -1
            if (iand(ichar(text(i:i)), 192) /= 128) length = 0
        end do
    end function character_length

    !> The number of a character in Unicode (RFC 3629, section 3).
    pure integer function code_point(letter) result(code)
        character(*), intent(in) :: letter !! one character, as long as `character_length` says
        integer :: i

        code = ichar(letter(1:1))
        if (len(letter) == 1) return
        code = iand(code, shiftr(127, len(letter)))
        do i = 2, len(letter)
            code = 64*code + iand(ichar(letter(i:i)), 63)
        end do
    end function code_point

end module base_utf8
