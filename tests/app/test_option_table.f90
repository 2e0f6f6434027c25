!> The table of options agrees with itself.
program test_option_table
    use app_option_table, only: is_one_of, known, option_layout_type, option_of, word_meant
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(option_layout_type) :: layout
    character(*), parameter :: kinds = 'flag words number positive path text paper'
    integer :: i, k
    logical :: is_sound

    is_sound = .true.
    do i = 1, size(known)
        is_sound = is_sound .and. index(known(i)%name, '-') == 1 .and. &
            is_one_of(trim(known(i)%kind), kinds) .and. known(i)%commands /= '' .and. &
            len_trim(known(i)%name) < len(known%name) .and. &
            len_trim(known(i)%words) < len(known%words) .and. &
            ((known(i)%words /= '') .eqv. &
            is_one_of(trim(known(i)%kind), 'words number positive paper'))
    end do
    call tap%ok(is_sound, 'each option has a name, a kind, commands, and words where it needs them')
    is_sound = .true.
    do i = 1, size(known)
        do k = 1, i - 1
            is_sound = is_sound .and. .not. (known(k)%name == known(i)%name .and. &
                shares(known(k)%commands, known(i)%commands))
        end do
    end do
    call tap%ok(is_sound, 'no command has two options of one name')
    layout = option_of('--format', 'plot')
    call tap%same(trim(layout%words), 'svg pdf png txt', 'an option is that of its command')
    layout = option_of('--shift', 'plot')
    call tap%same(trim(layout%name), '', 'others have none of that name')
    layout = option_of('--3', 'export')
    call tap%same(trim(layout%name), '', 'nor have they any of a part of a name')
    call tap%ok(is_one_of('a', 'a b') .and. is_one_of('b', 'a b') .and. is_one_of('a', 'a'), &
        'words of a list')
    call tap%ok(.not. (is_one_of('a b', 'a b') .or. is_one_of('c', 'a b') .or. is_one_of('', 'a') &
        .or. is_one_of('a', 'aa ba')), 'no words of it')
    call tap%same(word_meant('A4', 'a4 letter'), 'a4', 'a word in capitals')
    call tap%same(word_meant('Letter', 'a4 letter'), 'letter', 'a word with a capital')
    call tap%same(word_meant('A4 LETTER', 'a4 letter')//word_meant('b4', 'a4 letter')// &
        word_meant('', 'a4 letter'), '', 'no word of a list')
    call tap%finish()

contains

    !> True where two lists of commands have one in common.
    pure logical function shares(first, second)
        character(*), intent(in) :: first   !! commands
        character(*), intent(in) :: second  !! commands
        integer :: i
        character(6), parameter :: words(5) = ['run   ', 'check ', 'plot  ', 'export', 'help  ']
        shares = .false.
        do i = 1, size(words)
            shares = shares .or. (is_one_of(trim(words(i)), first) .and. &
                is_one_of(trim(words(i)), second))
        end do
    end function shares

end program test_option_table
