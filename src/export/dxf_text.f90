!> Words in a DXF file: any text in the characters that R12 and R2000 read, and names of layers.
module export_dxf_text
    use base_text, only: limited, to_text, upper
    use base_utf8, only: character_length, code_point
    implicit none (type, external)
    private

    public :: dxf_text, layer_name, name_length

    !> The longest name of R12.
    integer, parameter :: name_length = 31
    !> The longest text, a little below that of R12.
    integer, parameter :: longest_text = 250

contains

    !> A text as a DXF file has it: what is not ASCII as `\U+XXXX`, control bytes as `?`. A caret
    !> would make a control character of what follows it and stands with a blank; two signs of per
    !> cent would begin a special character and are written as `%%%` each. It is cut off at 250
    !> bytes.
    !>
    !> Source: Autodesk, "DXF Reference" for AutoCAD 2000, formatting conventions.
    pure function dxf_text(words) result(text)
        character(*), intent(in) :: words   !! any bytes, UTF-8
        character(:), allocatable :: text
        character(:), allocatable :: piece
        integer :: i, length
        logical :: has_special

        text = ''
        has_special = index(words, '%%') > 0
        i = 1
        do while (i <= len(words))
            call take(words(i:), piece, length)
            if (piece == '%' .and. has_special) piece = '%%%'
            if (len(text) + len(piece) > longest_text) exit
            text = text//piece
            i = i + length
        end do
    end function dxf_text

    !> Takes the first character of a text; a byte that is no UTF-8 is U+FFFD.
    pure subroutine take(words, piece, length)
        character(*), intent(in) :: words               !! not empty
        character(:), allocatable, intent(out) :: piece !! as DXF has it
        integer, intent(out) :: length                  !! bytes it takes of the text
        integer, parameter :: unknown = 65533

        length = character_length(words)
        select case (ichar(words(1:1)))
        case (:31, 127)
            piece = '?'
        case (iachar('^'))
            piece = '^ '
        case (128:)
            if (length > 0) piece = escaped(code_point(words(:length)))
            if (length == 0) piece = escaped(unknown)
            length = max(length, 1)
        case default
            piece = words(1:1)
        end select
    end subroutine take

    !> `\U+XXXX`; beyond the first 65536 characters, which have no such form, `?`.
    pure function escaped(code) result(text)
        integer, intent(in) :: code !! of Unicode
        character(:), allocatable :: text
        character(4) :: field
        text = '?'
        if (code > 65535) return
        write (field, '(z4.4)') code
        text = '\U+'//field
    end function escaped

    !> A name for a layer: letters are capitals, what is no letter, figure, `$`, `-` or `_` is `_`,
    !> and it is at most 31 characters. Where there is such a name already, a number goes behind it.
    pure function layer_name(name, taken) result(layer)
        character(*), intent(in) :: name                !! any bytes
        character(name_length), intent(in) :: taken(:)  !! names of other layers
        character(name_length) :: layer
        character(:), allocatable :: plain, suffix
        integer :: number

        plain = plain_name(name)
        layer = plain
        number = 1
        do while (any(taken == layer))
            number = number + 1
            suffix = '_'//to_text(number)
            layer = plain(:min(len(plain), name_length - len(suffix)))//suffix
        end do
    end function layer_name

    !> A name in the characters of R12, its end kept where it is too long: numbers stand there.
    pure function plain_name(name) result(plain)
        character(*), intent(in) :: name    !! any bytes
        character(:), allocatable :: plain
        character(*), parameter :: good = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789$-_'

        plain = limited(upper(name), good, '_')
        if (len(plain) > name_length) plain = plain(len(plain) - name_length + 1:)
        if (len(plain) == 0) plain = '_'
    end function plain_name

end module export_dxf_text
