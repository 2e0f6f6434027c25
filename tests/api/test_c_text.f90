!> Texts into the room of C and back: whole letters, a null behind them, nothing beyond.
program test_c_text
    use, intrinsic :: iso_c_binding, only: c_char, c_null_char, c_size_t
    use api_c_text, only: copied, text_of_bytes, text_of_c
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(*), parameter :: word = 'aé€z'   ! letters of 1, 2, 3 and 1 bytes
    integer, parameter :: whole(0:7) = [0, 1, 1, 3, 3, 3, 6, 7]
    character(kind=c_char) :: room(12)
    integer(c_size_t) :: length
    integer :: i, k

    do i = 0, 7
        room = '#'
        length = copied(word, room, int(i + 1, c_size_t))
        call tap%ok(length == 7_c_size_t, 'the length of all of it is returned')
        call tap%ok(room(whole(i) + 1) == c_null_char .and. &
            all([(room(k) == word(k:k), k=1, whole(i))]), 'with room whole letters are copied')
        call tap%ok(all(room(whole(i) + 2:) == '#'), 'and nothing behind their null')
    end do
    room = '#'
    call tap%ok(copied(word, bytes=5_c_size_t) == 7_c_size_t, 'no room at all: the length')
    call tap%ok(copied(word, room, 0_c_size_t) == 7_c_size_t .and. all(room == '#'), &
        'room of no bytes is left alone')
    call tap%ok(copied('', room, 9_c_size_t) == 0_c_size_t .and. room(1) == c_null_char, &
        'no text is a null')
    room = '#'
    length = copied(char(255)//char(191)//char(191)//char(191)//char(191), room, 4_c_size_t)
    call tap%ok(room(4) == c_null_char, 'bytes that are no UTF-8 are cut anywhere')
    length = copied(word, room, 12_c_size_t)
    call tap%same(text_of_c(room), word, 'a text of C is read to its null')
    call tap%same(text_of_bytes(room, 3_c_size_t), 'aé', 'or as many bytes as asked')
    call tap%same(text_of_bytes(room, 0_c_size_t), '', 'or none')
    call tap%finish()

end program test_c_text
