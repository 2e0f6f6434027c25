!> Texts between C and Fortran: C's read, ours copied into the room of the caller.
module api_c_text
    use, intrinsic :: iso_c_binding, only: c_char, c_null_char, c_size_t
    use base_utf8, only: character_length
    implicit none (type, external)
    private

    public :: copied, text_of_c, text_of_bytes

    interface
        !> Bytes before the null.
        pure integer(c_size_t) function c_strlen(text) bind(c, name='strlen')
            import :: c_char, c_size_t
            character(kind=c_char), intent(in) :: text(*) !! ends with a null
        end function c_strlen
    end interface

contains

    !> Copies a text into the room of a caller, a null behind it; of a text that is too long as many
    !> whole characters as there is room for. Returns the bytes of the whole text.
    integer(c_size_t) function copied(text, room, bytes) result(length)
        character(*), intent(in) :: text                            !! what to copy
        character(kind=c_char), intent(inout), optional :: room(*)  !! where to, if it is wanted
        integer(c_size_t), intent(in) :: bytes                      !! there, the null included
        integer :: i, last

        length = len(text, c_size_t)
        if (.not. present(room) .or. bytes < 1_c_size_t) return
        last = whole_characters(text, int(min(length, bytes - 1_c_size_t)))
        do i = 1, last
            room(i) = text(i:i)
        end do
        room(last + 1) = c_null_char
    end function copied

    !> The most bytes of a text, up to a limit, that cut no character in two.
    pure integer function whole_characters(text, limit) result(last)
        character(*), intent(in) :: text    !! any text
        integer, intent(in) :: limit        !! not above its length
        integer :: back

        last = limit
        if (limit == len(text)) return
        do back = 0, min(3, limit - 1)
            if (character_length(text(limit - back:)) > back + 1) last = limit - back - 1
        end do
    end function whole_characters

    !> A text of C.
    pure function text_of_c(text) result(copy)
        character(kind=c_char), intent(in) :: text(*) !! ends with a null
        character(c_strlen(text)) :: copy
        copy = text_of_bytes(text, c_strlen(text))
    end function text_of_c

    !> Bytes of C as a text.
    pure function text_of_bytes(bytes, length) result(copy)
        character(kind=c_char), intent(in) :: bytes(*)  !! any
        integer(c_size_t), intent(in) :: length         !! how many there are
        character(length) :: copy
        integer(c_size_t) :: i

        do i = 1, length
            copy(i:i) = bytes(i)
        end do
    end function text_of_bytes

end module api_c_text
