!> Words of a body deck: lists of them, the one that was likely meant, names.
module deck_body_word
    use base_kinds, only: i64
    use base_text, only: to_text
    implicit none (type, external)
    private

    public :: words_in, place_of, nearest_word, crowded_word, suggestion, in_words, name_trouble
    public :: begins_as_word

    !> Characters of a word or name.
    integer, parameter, public :: word_length = 8
    !> Slips of the fingers that are seen through: letters wrong, missing, too many or exchanged.
    integer, parameter :: most_slips = 2

    character(*), parameter :: letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ', &
        name_characters = letters//'0123456789-_./'

contains

    !> The words of a text with blanks between them.
    pure function words_in(text) result(word)
        character(*), intent(in) :: text !! the words
        character(word_length) :: word(word_count(text))
        integer :: i, begin

        begin = 1
        do i = 1, size(word)
            begin = begin - 1 + verify(text(begin:), ' ')
            word(i) = text(begin:begin - 2 + scan(text(begin:)//' ', ' '))
            begin = begin + len_trim(word(i))
        end do
    end function words_in

    !> How many words a text has.
    pure integer function word_count(text)
        character(*), intent(in) :: text !! words with blanks between them
        integer :: i
        word_count = 0
        do i = 1, len(text)
            if (text(i:i) == ' ') cycle
            if (i == 1 .or. text(max(i - 1, 1):max(i - 1, 1)) == ' ') word_count = word_count + 1
        end do
    end function word_count

    !> Which word of a list a text is, from 1; 0 where it is none.
    pure integer function place_of(text, word) result(place)
        character(*), intent(in) :: text    !! what was read
        character(*), intent(in) :: word(:) !! the list
        do place = size(word), 1, -1
            if (word(place) == text) return
        end do
    end function place_of

    !> The word of a list that a text was likely meant to be, or nothing.
    pure function nearest_word(text, word) result(nearest)
        character(*), intent(in) :: text    !! what was read
        character(*), intent(in) :: word(:) !! what may be read
        character(len(word, i64)) :: nearest
        integer :: i, fewest, number

        nearest = ''
        fewest = min(most_slips, len_trim(text) - 1) + 1
        do i = 1, size(word)
            if (word(i) == '') cycle
            number = slips(trim(text), trim(word(i)))
            if (number >= fewest) cycle
            fewest = number
            nearest = word(i)
        end do
    end function nearest_word

    !> The word of a list that a text begins with where more stands behind it in the same field,
    !> `LINE TOP`, `STRAIGHT30.`; or nothing.
    pure function crowded_word(text, word) result(crowded)
        character(*), intent(in) :: text    !! what was read
        character(*), intent(in) :: word(:) !! what may be read
        character(len(word, i64)) :: crowded
        integer :: i

        crowded = ''
        do i = 1, size(word)
            if (word(i) == '' .or. word(i) == text) cycle
            if (text(:verify(text//' ', letters) - 1) == word(i)) crowded = word(i)
        end do
    end function crowded_word

    !> The end of a sentence that asks whether another word was meant, or nothing.
    pure function suggestion(text, word) result(words)
        character(*), intent(in) :: text    !! what was read
        character(*), intent(in) :: word(:) !! what may be read
        character(len_trim(nearest_word(text, word), i64) + &
            merge(0_i64, len('; did you mean ?', i64), nearest_word(text, word) == '')) :: words
        words = '; did you mean '//trim(nearest_word(text, word))//'?'
    end function suggestion

    !> Slips that lead from one word to the other: letters changed, left out, put in, or two
    !> neighbours exchanged (the optimal string alignment distance).
    pure integer function slips(a, b)
        character(*), intent(in) :: a !! a word
        character(*), intent(in) :: b !! another
        integer :: table(0:len(a), 0:len(b)), i, j

        table(:, 0) = [(i, i = 0, len(a))]
        table(0, :) = [(j, j = 0, len(b))]
        do j = 1, len(b)
            do i = 1, len(a)
                table(i, j) = min(table(i - 1, j) + 1, table(i, j - 1) + 1, &
                    table(i - 1, j - 1) + merge(0, 1, a(i:i) == b(j:j)))
                if (are_exchanged(a(:i), b(:j))) then
                    table(i, j) = min(table(i, j), table(max(i - 2, 0), max(j - 2, 0)) + 1)
                end if
            end do
        end do
        slips = table(len(a), len(b))
    end function slips

    !> True where the last two letters of one word are those of the other, exchanged.
    pure logical function are_exchanged(a, b)
        character(*), intent(in) :: a !! a word
        character(*), intent(in) :: b !! another
        are_exchanged = .false.
        if (len(a) < 2 .or. len(b) < 2) return
        are_exchanged = a(len(a):)//a(len(a) - 1:len(a) - 1) == b(len(b) - 1:)
    end function are_exchanged

    !> A list of words for a sentence: `SIDE, PLAN or ANGLE`.
    pure function in_words(word) result(list)
        character(*), intent(in) :: word(:) !! the words
        character(sum(len_trim(word, i64)) + merge(2_i64*size(word, kind=i64), 0_i64, &
            size(word) > 1)) :: list
        integer :: i

        list = ''
        do i = 1, size(word)
            if (i == 1) then
                list = word(1)
            else if (i < size(word)) then
                list = trim(list)//', '//word(i)
            else
                list = trim(list)//' or '//word(i)
            end if
        end do
    end function in_words

    !> True where two letters begin a text. (`O.5` is a number with a slip in it.)
    pure logical function begins_as_word(text)
        character(*), intent(in) :: text !! in capitals
        begins_as_word = .false.
        if (len(text) > 1) begins_as_word = verify(text(1:2), letters) == 0
    end function begins_as_word

    !> What keeps a text from being a name, or nothing.
    pure function name_trouble(text) result(trouble)
        character(*), intent(in) :: text !! in capitals, not blank
        character(80) :: trouble

        trouble = ''
        if (index(letters, text(1:1)) == 0) then
            trouble = 'a name begins with a letter'
        else if (index(text, ' ') > 0) then
            trouble = 'a blank in a name; a name ends with the columns of its field'
        else if (verify(text, name_characters) > 0) then
            trouble = 'a name has letters, figures and the signs - _ . /'
        else if (len(text) > word_length) then
            trouble = 'a name has at most '//to_text(word_length)//' characters'
        end if
    end function name_trouble

end module deck_body_word
