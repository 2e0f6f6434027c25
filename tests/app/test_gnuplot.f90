!> Running another program: words of a user on a line of shell.
program test_gnuplot
    use app_gnuplot, only: draw, folder_word, shell_word
    use base_error, only: cause, error_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(error_type), allocatable :: error
    character, parameter :: backslash = achar(92)
    character(*), parameter :: nasty = ' it''s "$(exit 9)" `exit 9`;'//backslash//'*'//''''''

    call tap%same(shell_word('out'), '''out''', 'a word stands in single quotes')
    call tap%same(shell_word('it''s'), '''it'''//backslash//'''''s''', &
        'an apostrophe stands between the quotes, escaped')
    call tap%same(shell_word(''), '''''', 'nothing is an empty word')
    call tap%ok(seen_by_shell(nasty), 'the shell sees quotes, blanks and commands as they are')
    call tap%same(folder_word('-x'), '''./-x''', 'a folder is no option of cd')
    call tap%same(folder_word('/tmp/a b'), '''/tmp/a b''', 'a path from the root stays')

    call draw('/no such folder', 'side', 'svg', error)
    call tap%ok(allocated(error), 'drawing where there is no folder fails')
    if (allocated(error)) call tap%ok(error%cause == cause%file_trouble .and. &
        index(error%message, '/no such folder/side.svg') == 1, 'and names the picture')
    call tap%finish()

contains

    !> True where the shell passes a word on byte for byte, seen as hexadecimal numbers.
    logical function seen_by_shell(text)
        character(*), intent(in) :: text !! no null
        character(2*len(text)) :: bytes
        integer :: i, seen, trouble

        do i = 1, len(text)
            write (bytes(2*i - 1:2*i), '(z2.2)') ichar(text(i:i))
        end do
        seen = 1
        call execute_command_line('test "$(printf %s '//shell_word(text)// &
            ' | od -An -v -tx1 | tr -d " \n" | tr a-f A-F)" = '//bytes, &
            exitstat=seen, cmdstat=trouble)
        seen_by_shell = seen == 0 .and. trouble == 0
    end function seen_by_shell

end program test_gnuplot
