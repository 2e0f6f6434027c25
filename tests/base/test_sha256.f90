!> SHA-256 against the examples of its standard and what `sha256sum` prints: empty, short, at the
!> edges of blocks, a million bytes, all byte values, in pieces of any length.
program test_sha256
    use base_sha256, only: sha256_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_standard()
    call check_edges()
    call check_pieces()
    call check_bytes()
    call tap%finish()

contains

    !> FIPS 180-2, appendix B, and the NIST file of short and long messages.
    subroutine check_standard()
        call tap%same(sum_of(''), &
            'e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855', 'nothing at all')
        call tap%same(sum_of('abc'), &
            'ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad', 'one block (B.1)')
        call tap%same(sum_of('abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq'), &
            '248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1', 'two blocks (B.2)')
        call tap%same(sum_of(repeat('a', 1000000)), &
            'cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0', &
            'a million letters (B.3)')
        call tap%same(sum_of(char(189)), &
            '68325720aabd7c82f30f554b313d0570c95accbb7dc4b5aae11204c08ffe732b', 'one byte, 0xbd')
        call tap%same(sum_of(char(201)//char(140)//char(142)//char(85)), &
            '7abc22c0ae5af26ce93dbb94433a0e0b2e119d014f8e7f65bd56c61ccccd9504', 'four bytes')
    end subroutine check_standard

    !> Lengths about a block and about the room for the length, of the letter a (by `sha256sum`).
    subroutine check_edges()
        call tap%same(sum_of(repeat('a', 55)), &
            '9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318', '55 bytes')
        call tap%same(sum_of(repeat('a', 56)), &
            'b35439a4ac6f0948b6d6f9e3c6af0f5f590ce20f1bde7090ef7970686ec6738a', '56 bytes')
        call tap%same(sum_of(repeat('a', 63)), &
            '7d3e74a05d7db15bce4ad9ec0658ea98e3f06eeecf16b4c6fff2da457ddc2f34', '63 bytes')
        call tap%same(sum_of(repeat('a', 64)), &
            'ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb', '64 bytes')
        call tap%same(sum_of(repeat('a', 65)), &
            '635361c48bb9eab14198e76ea8ab7f1a41685d6ad62aa9146d301d4f17eb0ae0', '65 bytes')
        call tap%same(sum_of(repeat('a', 119)), &
            '31eba51c313a5c08226adf18d4a359cfdfd8d2e816b13f4af952f7ea6584dcfb', '119 bytes')
        call tap%same(sum_of(repeat('a', 120)), &
            '2f3d335432c70b580af0e8e1b3674a7c020d683aa5f73aaaedfdc55af904c21c', '120 bytes')
    end subroutine check_edges

    !> The same bytes, taken in pieces of every length up to beyond a block; asked for on the way.
    subroutine check_pieces()
        type(sha256_type) :: sum
        character(1000) :: message
        character(64) :: whole
        integer :: i, length
        logical :: all_alike

        do i = 1, len(message)
            message(i:i) = char(mod(7*i*i + 3*i, 256))
        end do
        whole = sum_of(message)
        all_alike = .true.
        do length = 1, 130
            sum = sha256_type()
            do i = 1, len(message), length
                call sum%take(message(i:min(len(message), i + length - 1)))
                if (mod(i, 3) == 0) all_alike = all_alike .and. sum%hex() /= whole &
                    .or. i + length > len(message)
            end do
            all_alike = all_alike .and. sum%hex() == whole
        end do
        call tap%ok(all_alike, 'pieces of 1 to 130 bytes give the sum of the whole')
        call sum%take('')
        call tap%same(sum%hex(), whole, 'no bytes change nothing')
    end subroutine check_pieces

    !> Every value of a byte, by `sha256sum`.
    subroutine check_bytes()
        character(256) :: message
        integer :: i
        do i = 0, 255
            message(i + 1:i + 1) = char(i)
        end do
        call tap%same(sum_of(message), &
            '40aff2e9d2d8922e47afd4648e6967497158785fbd1da870e7110266bf944880', 'bytes 0 to 255')
    end subroutine check_bytes

    !> The checksum of a message.
    pure function sum_of(message) result(text)
        character(*), intent(in) :: message !! any bytes
        character(64) :: text
        type(sha256_type) :: sum
        call sum%take(message)
        text = sum%hex()
    end function sum_of

end program test_sha256
