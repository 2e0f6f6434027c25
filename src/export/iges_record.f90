!> A record of an IGES file in free format: values with commas between them and a semicolon behind
!> (IGES 5.3, 2.2.2).
!>
!>     call record%whole(110)
!>     call record%reals([0.0_dp, 2.5_dp, -1.0e-7_dp])     ->  110,0.,2.5,-1.D-07,4HNOSE;
!>     call record%text('NOSE')
module export_iges_record
    use base_digits, only: shortest
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: printable, to_text
    use base_utf8, only: character_length
    implicit none (type, external)
    private

    public :: record_type, iges_real, hollerith, plain

    !> A record, as far as it is written.
    type :: record_type
        private
        type(output_type) :: words      !! in memory
        logical :: is_begun = .false.   !! there is a value
    contains
        procedure :: whole
        procedure :: reals
        procedure :: text => add_text
        procedure :: default
        procedure :: content
        procedure, private :: put
    end type record_type

contains

    !> Adds a value as it is to be written.
    subroutine put(record, word)
        class(record_type), intent(inout) :: record !! the record
        character(*), intent(in) :: word            !! the value
        if (record%is_begun) call record%words%put(',')
        call record%words%put(word)
        record%is_begun = .true.
    end subroutine put

    !> Adds a whole number: a count, a flag or a pointer.
    subroutine whole(record, value)
        class(record_type), intent(inout) :: record !! the record
        integer, intent(in) :: value                !! the number
        call record%put(to_text(value))
    end subroutine whole

    !> Adds reals.
    subroutine reals(record, values)
        class(record_type), intent(inout) :: record !! the record
        real(dp), intent(in) :: values(:)           !! finite numbers
        integer :: i
        do i = 1, size(values)
            call record%put(iges_real(values(i)))
        end do
    end subroutine reals

    !> Adds a text.
    subroutine add_text(record, string)
        class(record_type), intent(inout) :: record !! the record
        character(*), intent(in) :: string          !! any bytes
        call record%put(hollerith(string))
    end subroutine add_text

    !> Leaves a value out: it has its default.
    subroutine default(record)
        class(record_type), intent(inout) :: record !! the record
        call record%put('')
    end subroutine default

    !> The record and its end.
    pure function content(record)
        class(record_type), intent(in) :: record    !! the record
        character(:), allocatable :: content
        content = record%words%text()//';'
    end function content

    !> A real as the fewest figures that read back as it, with a point; powers of ten behind a D,
    !> which says that the number is of double precision (2.2.2.2).
    pure function iges_real(value) result(text)
        real(dp), intent(in) :: value !! a finite number
        character(:), allocatable :: text
        integer :: power

        text = shortest(value)
        power = index(text, 'e')
        if (power > 0) text(power:power) = 'D'
        if (index(text, '.') > 0) return
        if (power == 0) power = len(text) + 1
        text = text(:power - 1)//'.'//text(power:)
    end function iges_real

    !> A text behind the count of its characters: `4HNOSE` (2.2.2.4). One without characters is left
    !> out, which is how IGES has it.
    pure function hollerith(text) result(word)
        character(*), intent(in) :: text !! any bytes
        character(:), allocatable :: word
        character(:), allocatable :: letters

        letters = plain(text)
        word = ''
        if (len(letters) > 0) word = to_text(len(letters))//'H'//letters
    end function hollerith

    !> A text in the characters IGES knows, those of ASCII: `?` for every other one, and for bytes
    !> that are none.
    pure function plain(text) result(letters)
        character(*), intent(in) :: text !! any bytes
        character(:), allocatable :: letters
        integer :: first, count

        letters = ''
        first = 1
        do while (first <= len(text))
            count = character_length(text(first:))
            if (count == 1) then
                letters = letters//printable(text(first:first))
            else
                letters = letters//'?'
            end if
            first = first + max(count, 1)
        end do
    end function plain

end module export_iges_record
