!> The deck of a variant: the cards as they were typed, with other numbers in the fields that vary.
!> Nothing else is touched: comments, blanks and line ends stay, a field keeps its columns.
module sweep_image
    use base_decimal, only: to_real
    use base_kinds, only: dp, i64
    use base_text, only: row_of
    use deck_body_card, only: field_type
    use deck_sweep, only: target_type
    use sweep_figure, only: field_figure
    implicit none (type, external)
    private

    public :: image_type, new_image, write_variant

    !> A deck as text, and where its lines are.
    type :: image_type
        character(:), allocatable :: text       !! all bytes of the file
        integer, allocatable :: first(:)        !! first byte of each line
        integer, allocatable :: last(:)         !! last byte of each line, before its line end
        type(target_type), allocatable :: target(:) !! fields that vary, the last in the deck first
    end type image_type

    !> What an editor may leave at the very start of a file.
    character(3), parameter :: mark = char(239)//char(187)//char(191)

contains

    !> A deck with the fields that vary.
    pure type(image_type) function new_image(text, targets) result(image)
        character(*), intent(in) :: text            !! all bytes of the file
        type(target_type), intent(in) :: targets(:) !! fields that vary
        integer :: line, first, length

        image%text = text
        allocate (image%first(count_lines(text)), image%last(count_lines(text)))
        first = 1
        if (index(text, mark) == 1) first = len(mark) + 1
        do line = 1, size(image%first)
            length = index(text(first:), new_line('a')) - 1
            if (length < 0) length = len(text) - first + 1
            image%first(line) = first
            image%last(line) = first + length - 1
            if (length > 0) then
                if (text(first + length - 1:first + length - 1) == achar(13)) &
                    image%last(line) = first + length - 2
            end if
            first = first + length + 1
        end do
        allocate (image%target, source=in_order(targets))
    end function new_image

    !> The lines of a text; what stands behind the last line feed is one, too.
    pure integer function count_lines(text) result(lines)
        character(*), intent(in) :: text !! all bytes of the file
        integer :: i
        lines = 0
        do i = 1, len(text)
            if (text(i:i) == new_line('a') .or. i == len(text)) lines = lines + 1
        end do
    end function count_lines

    !> Fields in the order of the deck, the last first, so that a change moves none still to come.
    pure function in_order(targets) result(ordered)
        type(target_type), intent(in) :: targets(:) !! in any order
        type(target_type), allocatable :: ordered(:)
        logical :: is_left(size(targets))
        integer(i64) :: key(size(targets))
        integer :: i, k

        do i = 1, size(targets)
            associate (place => targets(i)%of%field(targets(i)%field))
                key(i) = targets(i)%of%sheet(place%sheet)%line*1000_i64 + int(place%first, i64)
            end associate
        end do
        is_left = .true.
        allocate (ordered(size(targets)))
        do i = 1, size(targets)
            k = maxloc(key, 1, is_left)
            is_left(k) = .false.
            ordered(i) = targets(k)
        end do
    end function in_order

    !> Writes the deck with the values of a variant.
    pure subroutine write_variant(image, value, text)
        type(image_type), intent(in) :: image           !! the deck
        real(dp), intent(in) :: value(:)                !! of the variables
        character(:), allocatable, intent(out) :: text  !! the deck of the variant
        real(dp) :: wanted
        integer :: i

        text = image%text
        do i = 1, size(image%target)
            associate (target => image%target(i))
                wanted = value(target%variable)
                if (target%is_tied) wanted = to_real(target%factor)*wanted + to_real(target%add)
                call put_figure(image, target, trim(field_figure(wanted)), text)
            end associate
        end do
    end subroutine write_variant

    !> Puts a number into a field. By columns it fills its eight columns, between commas it takes
    !> the room it needs.
    pure subroutine put_figure(image, target, figure, text)
        type(image_type), intent(in) :: image               !! the deck as it was
        type(target_type), intent(in) :: target             !! the field
        character(*), intent(in) :: figure                  !! the number
        character(:), allocatable, intent(inout) :: text    !! the deck so far
        type(field_type) :: place
        integer :: line, begin, finish

        place = target%of%field(target%field)
        line = int(target%of%sheet(place%sheet)%line)
        begin = image%first(line) + place%first - 1
        finish = image%first(line) + place%last - 1
        if (has_comma(target%of%sheet(place%sheet)%image)) then
            text = text(:begin - 1)//figure//text(finish + 1:)
            return
        end if
        finish = min(finish, image%last(line))
        text = text(:begin - 1)//figure//row_of(' ', finish - begin + 1 - len(figure))// &
            text(finish + 1:)
    end subroutine put_figure

    !> True for a card with commas between its fields.
    pure logical function has_comma(card)
        character(*), intent(in) :: card !! a line of a card
        has_comma = index(card, ',') > 0
    end function has_comma

end module sweep_image
