!> Text on paper: bytes of a deck as characters, their bytes in the encodings of SVG and PDF, and
!> how wide they are in Helvetica.
!>
!> Sources: RFC 3629 (UTF-8); PDF Reference, 3rd ed. (1.4), appendix D (WinAnsiEncoding); widths:
!> Adobe Core 14 AFM files, Helvetica and Helvetica-Bold, in thousandths of the height of the type.
module export_pattern_letters
    use base_kinds, only: dp
    use base_utf8, only: character_length, code_point
    implicit none (type, external)
    private

    public :: codes_of, utf8, win_ansi, text_width, shortened, unknown

    !> The character that stands for bytes that are none, and for control characters.
    integer, parameter :: unknown = 65533
    !> The characters that WinAnsiEncoding has from 128 to 159; 0: none.
    integer, parameter :: windows(128:159) = [8364, 0, 8218, 402, 8222, 8230, 8224, 8225, 710, &
        8240, 352, 8249, 338, 0, 381, 0, 0, 8216, 8217, 8220, 8221, 8226, 8211, 8212, 732, 8482, &
        353, 8250, 339, 0, 382, 376]
    !> Widths from blank to tilde, then from the fixed blank (160) on.
    integer, parameter :: plain_ascii(32:126) = [278, 278, 355, 556, 556, 889, 667, 191, 333, 333, &
        389, 584, 278, 333, 278, 278, 556, 556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, &
        584, 584, 584, 556, 1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, &
        722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556, &
        333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556, 556, 556, &
        333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584]
    integer, parameter :: bold_ascii(32:126) = [278, 333, 474, 556, 556, 889, 722, 238, 333, 333, &
        389, 584, 278, 333, 278, 278, 556, 556, 556, 556, 556, 556, 556, 556, 556, 556, 333, 333, &
        584, 584, 584, 611, 975, 722, 722, 722, 722, 667, 611, 778, 722, 278, 556, 722, 611, 833, &
        722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 333, 278, 333, 584, 556, &
        333, 556, 611, 556, 611, 556, 333, 611, 611, 278, 278, 556, 278, 889, 611, 611, 611, 611, &
        389, 556, 333, 611, 556, 778, 556, 556, 500, 389, 280, 389, 584]
    integer, parameter :: plain_latin(160:255) = [278, 333, 556, 556, 556, 556, 260, 556, 333, &
        737, 370, 556, 584, 333, 737, 333, 400, 584, 333, 333, 333, 556, 537, 278, 333, 333, 365, &
        556, 834, 834, 834, 611, 667, 667, 667, 667, 667, 667, 1000, 722, 667, 667, 667, 667, 278, &
        278, 278, 278, 722, 722, 778, 778, 778, 778, 778, 584, 778, 722, 722, 722, 722, 667, 667, &
        611, 556, 556, 556, 556, 556, 556, 889, 500, 556, 556, 556, 556, 278, 278, 278, 278, 556, &
        556, 556, 556, 556, 556, 556, 584, 611, 556, 556, 556, 556, 500, 556, 500]
    integer, parameter :: bold_latin(160:255) = [278, 333, 556, 556, 556, 556, 280, 556, 333, 737, &
        370, 556, 584, 333, 737, 333, 400, 584, 333, 333, 333, 611, 556, 278, 333, 333, 365, 556, &
        834, 834, 834, 611, 722, 722, 722, 722, 722, 722, 1000, 722, 667, 667, 667, 667, 278, 278, &
        278, 278, 722, 722, 778, 778, 778, 778, 778, 584, 778, 722, 722, 722, 722, 667, 667, 611, &
        556, 556, 556, 556, 556, 556, 889, 556, 556, 556, 556, 556, 278, 278, 278, 278, 611, 611, &
        611, 611, 611, 611, 611, 584, 611, 611, 611, 611, 611, 556, 611, 556]
    !> Of any other character.
    integer, parameter :: other_width = 1000

contains

    !> The characters of a text in UTF-8 by their numbers in Unicode; `unknown` for each byte that
    !> is part of none, for control characters and for numbers that no file may have.
    pure function codes_of(text) result(codes)
        character(*), intent(in) :: text !! any bytes
        integer, allocatable :: codes(:)
        integer :: found(len(text)), at, count, length, code

        at = 1
        count = 0
        do while (at <= len(text))
            length = character_length(text(at:))
            code = unknown
            if (length > 0) code = code_point(text(at:at + length - 1))
            if (.not. is_character(code)) code = unknown
            count = count + 1
            found(count) = code
            at = at + max(1, length)
        end do
        codes = found(:count)
    end function codes_of

    !> True for a number that a character of text may have (XML 1.0, section 2.2, less controls).
    pure logical function is_character(code)
        integer, intent(in) :: code !! a number
        is_character = (code >= 32 .and. code < 127) .or. (code >= 160 .and. code < 55296) .or. &
            (code >= 57344 .and. code < 65534) .or. (code >= 65536 .and. code < 1114112)
    end function is_character

    !> A character in UTF-8.
    pure function utf8(code) result(bytes)
        integer, intent(in) :: code !! number in Unicode
        character(:), allocatable :: bytes

        if (code < 128) then
            bytes = char(code)
        else if (code < 2048) then
            bytes = char(192 + code/64)//tail(code)
        else if (code < 65536) then
            bytes = char(224 + code/4096)//tail(code/64)//tail(code)
        else
            bytes = char(240 + code/262144)//tail(code/4096)//tail(code/64)//tail(code)
        end if
    end function utf8

    !> A byte with the last six bits of a number.
    pure character function tail(code)
        integer, intent(in) :: code !! a number
        tail = char(128 + mod(code, 64))
    end function tail

    !> The byte of a character in WinAnsiEncoding; `?` where it has none.
    pure character function win_ansi(code) result(byte)
        integer, intent(in) :: code !! number in Unicode
        integer :: place

        byte = '?'
        if ((code >= 32 .and. code < 127) .or. (code >= 160 .and. code < 256)) byte = char(code)
        place = findloc(windows, code, dim=1)
        if (place > 0 .and. code > 0) byte = char(place + lbound(windows, 1) - 1)
    end function win_ansi

    !> The width of a text, in the unit of its height.
    pure real(dp) function text_width(text, height, is_bold) result(width)
        character(*), intent(in) :: text    !! any bytes
        real(dp), intent(in) :: height      !! of the type (its em)
        logical, intent(in) :: is_bold      !! Helvetica-Bold
        integer, allocatable :: codes(:)
        integer :: i, thousandths

        allocate (codes(0))
        codes = codes_of(text)
        thousandths = 0
        do i = 1, size(codes)
            thousandths = thousandths + letter_width(codes(i), is_bold)
        end do
        width = height*real(thousandths, dp)/1000.0_dp
    end function text_width

    !> As much of a text as there is room for, with three points where something is left out.
    pure function shortened(text, height, width) result(short)
        character(*), intent(in) :: text    !! any bytes
        real(dp), intent(in) :: height      !! of the type
        real(dp), intent(in) :: width       !! of the room
        character(:), allocatable :: short
        integer, allocatable :: codes(:)
        integer :: count, i

        short = text
        if (text_width(text, height, .false.) <= width) return
        allocate (codes(0))
        codes = codes_of(text)
        do count = size(codes) - 1, 0, -1
            short = ''
            do i = 1, count
                short = short//utf8(codes(i))
            end do
            short = trim(short)//'...'
            if (text_width(short, height, .false.) <= width) return
        end do
    end function shortened

    !> The width of a character, thousandths of its height.
    pure integer function letter_width(code, is_bold) result(width)
        integer, intent(in) :: code     !! number in Unicode
        logical, intent(in) :: is_bold  !! Helvetica-Bold

        select case (code)
        case (32:126)
            width = merge(bold_ascii(code), plain_ascii(code), is_bold)
        case (160:255)
            width = merge(bold_latin(code), plain_latin(code), is_bold)
        case default
            width = other_width
        end select
    end function letter_width

end module export_pattern_letters
