!> The checksum SHA-256 of a stream of bytes, as `sha256sum` prints it: by it a receipt names the
!> deck an export was made from.
!>
!>     call sum%take(bytes)        ! as often as bytes come
!>     text = sum%hex()            ! 64 figures
!>
!> Source: FIPS PUB 180-4, Secure Hash Standard, sections 4.1.2, 4.2.2, 5.1.1, 5.3.3, 6.2.2. Its
!> words of 32 bits are kept in whole numbers of 64, so that no sum overflows; the upper half is cut
!> off after each.
module base_sha256
    use base_kinds, only: i64
    use base_text, only: row_of
    implicit none (type, external)
    private

    public :: sha256_type

    !> Bytes of a block (512 bits).
    integer, parameter :: block_bytes = 64
    !> A word with all of its 32 bits set.
    integer(i64), parameter :: all_bits = int(z'ffffffff', i64)

    !> The kind of a word.
    integer, parameter :: w = i64

    !> The first values: of the square roots of the first eight primes the first 32 bits behind the
    !> point (5.3.3).
    integer(i64), parameter :: first_words(8) = [ &
        int(z'6a09e667', w), int(z'bb67ae85', w), int(z'3c6ef372', w), int(z'a54ff53a', w), &
        int(z'510e527f', w), int(z'9b05688c', w), int(z'1f83d9ab', w), int(z'5be0cd19', w)]

    !> The round constants: the same of the cube roots of the first 64 primes (4.2.2).
    integer(i64), parameter :: constants(64) = [ &
        int(z'428a2f98', w), int(z'71374491', w), int(z'b5c0fbcf', w), int(z'e9b5dba5', w), &
        int(z'3956c25b', w), int(z'59f111f1', w), int(z'923f82a4', w), int(z'ab1c5ed5', w), &
        int(z'd807aa98', w), int(z'12835b01', w), int(z'243185be', w), int(z'550c7dc3', w), &
        int(z'72be5d74', w), int(z'80deb1fe', w), int(z'9bdc06a7', w), int(z'c19bf174', w), &
        int(z'e49b69c1', w), int(z'efbe4786', w), int(z'0fc19dc6', w), int(z'240ca1cc', w), &
        int(z'2de92c6f', w), int(z'4a7484aa', w), int(z'5cb0a9dc', w), int(z'76f988da', w), &
        int(z'983e5152', w), int(z'a831c66d', w), int(z'b00327c8', w), int(z'bf597fc7', w), &
        int(z'c6e00bf3', w), int(z'd5a79147', w), int(z'06ca6351', w), int(z'14292967', w), &
        int(z'27b70a85', w), int(z'2e1b2138', w), int(z'4d2c6dfc', w), int(z'53380d13', w), &
        int(z'650a7354', w), int(z'766a0abb', w), int(z'81c2c92e', w), int(z'92722c85', w), &
        int(z'a2bfe8a1', w), int(z'a81a664b', w), int(z'c24b8b70', w), int(z'c76c51a3', w), &
        int(z'd192e819', w), int(z'd6990624', w), int(z'f40e3585', w), int(z'106aa070', w), &
        int(z'19a4c116', w), int(z'1e376c08', w), int(z'2748774c', w), int(z'34b0bcb5', w), &
        int(z'391c0cb3', w), int(z'4ed8aa4a', w), int(z'5b9cca4f', w), int(z'682e6ff3', w), &
        int(z'748f82ee', w), int(z'78a5636f', w), int(z'84c87814', w), int(z'8cc70208', w), &
        int(z'90befffa', w), int(z'a4506ceb', w), int(z'bef9a3f7', w), int(z'c67178f2', w)]

    !> A checksum on its way.
    type :: sha256_type
        private
        integer(i64) :: words(8) = first_words  !! the hash of all whole blocks
        character(block_bytes) :: open = ''     !! what has come of the next block
        integer(i64) :: bytes = 0               !! how many have come in all
    contains
        procedure :: take
        procedure :: hex
    end type sha256_type

contains

    !> Takes the next bytes.
    pure subroutine take(sum, bytes)
        class(sha256_type), intent(inout) :: sum !! the checksum
        character(*), intent(in) :: bytes        !! any
        integer(i64) :: done, room, part

        done = 0
        do while (done < len(bytes, i64))
            room = block_bytes - mod(sum%bytes, int(block_bytes, i64))
            part = min(room, len(bytes, i64) - done)
            sum%open(block_bytes - room + 1:block_bytes - room + part) = bytes(done + 1:done + part)
            sum%bytes = sum%bytes + part
            done = done + part
            if (part == room) call add_block(sum%words, sum%open)
        end do
    end subroutine take

    !> The checksum of all bytes taken, as 64 figures in base 16, small letters. More may be taken.
    pure function hex(sum) result(text)
        class(sha256_type), intent(in) :: sum !! the checksum
        character(64) :: text
        type(sha256_type) :: ended
        integer :: zeros

        ended = sum
        zeros = int(modulo(int(block_bytes - 9, i64) - sum%bytes, int(block_bytes, i64)))
        call ended%take(char(128)//row_of(achar(0), zeros)//length_field(sum%bytes))
        write (text, '(8z8.8)') ended%words
        text = lower_hex(text)
    end function hex

    !> The length of a message in bits, as its last eight bytes (5.1.1).
    pure function length_field(bytes) result(field)
        integer(i64), intent(in) :: bytes !! length of the message
        character(8) :: field
        integer :: i
        do i = 1, 8
            field(i:i) = char(int(ibits(8*bytes, 64 - 8*i, 8)))
        end do
    end function length_field

    !> Figures in base 16 with small letters.
    pure function lower_hex(figures) result(small)
        character(*), intent(in) :: figures !! 0-9, A-F
        character(len(figures)) :: small
        integer :: i
        do i = 1, len(figures)
            small(i:i) = figures(i:i)
            if (figures(i:i) >= 'A') small(i:i) = achar(iachar(figures(i:i)) + 32)
        end do
    end function lower_hex

    !> Adds a block to a hash (6.2.2).
    pure subroutine add_block(words, block)
        integer(i64), intent(inout) :: words(8)         !! the hash
        character(block_bytes), intent(in) :: block     !! the block
        integer(i64) :: schedule(64), v(8), t1, t2
        integer :: t

        schedule = schedule_of(block)
        v = words
        associate (a => v(1), b => v(2), c => v(3), e => v(5), f => v(6), g => v(7), h => v(8))
            do t = 1, 64
                t1 = h + turned(e, [6, 11, 25]) + ieor(iand(e, f), iand(ieor(e, all_bits), g)) &
                    + constants(t) + schedule(t)
                t2 = turned(a, [2, 13, 22]) + ieor(ieor(iand(a, b), iand(a, c)), iand(b, c))
                v = [iand(t1 + t2, all_bits), v(1:3), iand(v(4) + t1, all_bits), v(5:7)]
            end do
        end associate
        words = iand(words + v, all_bits)
    end subroutine add_block

    !> The message schedule of a block: its 16 words and 48 more.
    pure function schedule_of(block) result(schedule)
        character(block_bytes), intent(in) :: block !! the block
        integer(i64) :: schedule(64)
        integer :: i, t

        do t = 1, 16
            schedule(t) = 0
            do i = 4*t - 3, 4*t
                schedule(t) = ior(shiftl(schedule(t), 8), int(ichar(block(i:i)), i64))
            end do
        end do
        do t = 17, 64
            schedule(t) = iand(all_bits, schedule(t - 16) + schedule(t - 7) &
                + ieor(turned(schedule(t - 15), [7, 18]), shiftr(schedule(t - 15), 3)) &
                + ieor(turned(schedule(t - 2), [17, 19]), shiftr(schedule(t - 2), 10)))
        end do
    end function schedule_of

    !> The exclusive or of a word turned to the right by several counts of bits.
    pure integer(i64) function turned(word, counts)
        integer(i64), intent(in) :: word    !! 32 bits
        integer, intent(in) :: counts(:)    !! 1 to 31
        integer :: i
        turned = 0
        do i = 1, size(counts)
            turned = ieor(turned, ior(shiftr(word, counts(i)), shiftl(word, 32 - counts(i))))
        end do
        turned = iand(turned, all_bits)
    end function turned

end module base_sha256
