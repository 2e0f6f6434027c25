!> The command line: every option in both forms, and every way to get one wrong.
program test_options
    use app_options, only: options_type, read_options
    use base_decimal, only: to_real
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use support_command_line, only: decks, options_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_commands()
    call check_defaults()
    call check_values()
    call check_shift()
    call check_operands()
    call check_help()
    call check_unknown()
    call check_bad_values()
    call check_combinations()
    call tap%finish()

contains

    !> The commands.
    subroutine check_commands()
        call tap%same(command('run')//command('check|a')//command('plot|a')//command('help') &
            //command('export|a|-o|b.svg'), 'runcheckplothelpexport', &
            'the commands are known by name')
        call tap%same(command('--help')//command('-h')//command('--version'), 'helphelpversion', &
            'help and version are options too')
        call refused('', 'no command; one of: run check plot export audit sweep help (try '// &
            'loft help)', &
            'no command')
        call refused('fly', '''fly'' is no command; one of: run check plot export audit sweep '// &
            'help', &
            'another command')
        call refused('RUN', '''RUN'' is no command; one of: run check plot export audit sweep '// &
            'help', &
            'a command in capitals')
        call refused('run check', '''run check'' is no command; one of: '// &
            'run check plot export audit sweep help', 'two commands in one word')
        call refused('ru', '''ru'' is no command; one of: run check plot export audit sweep help', &
            'part of a command')
        call refused('-o', '''-o'' is no command; one of: run check plot export audit sweep help', &
            'an option before the command')
    end subroutine check_commands

    !> What is not said.
    subroutine check_defaults()
        type(options_type) :: options
        options = options_of('run', tap)
        call tap%same(options%arithmetic//'/'//options%format//'/'//options%output, 'ieee//', &
            'IEEE arithmetic, no format, no file')
        call tap%near(to_real(options%shift), 100.0_dp, 0.0_dp, 'a shift of 100')
        call tap%ok(.not. options%asa .and. .not. options%wants_help &
            .and. size(options%operand) == 0, &
            'no flags and no deck')
    end subroutine check_defaults

    !> Options with a value, as `--x v` and `--x=v`.
    subroutine check_values()
        type(options_type) :: options
        integer :: i
        character(1), parameter :: link(2) = ['|', '=']

        do i = 1, 2
            options = options_of('run|--arithmetic'//link(i)//'s360|--format'//link(i)// &
                'listing|a', tap)
            call tap%same(options%arithmetic//' '//options%format//' '//decks(options), &
                's360 listing a|', &
                'arithmetic and format, linked by '//link(i))
            options = options_of('run|--arithmetic'//link(i)//'ieee|--format'//link(i)//'csv', tap)
            call tap%same(options%arithmetic//' '//options%format, 'ieee csv', &
                'the other ones, by '//link(i))
            options = options_of('run|--shift'//link(i)//'-250.5|a', tap)
            call tap%near(to_real(options%shift), -250.5_dp, 0.0_dp, &
                'a negative shift, by '//link(i))
            options = options_of('plot|--format'//link(i)//'txt|a|-o|pictures', tap)
            call tap%same(options%format//' '//options%output, 'txt pictures', &
                'a picture''s format, by '//link(i))
        end do
        do i = 1, 3
            call tap%same(command('plot|--format='//trim(word(i, 'svg pdf png'))//'|a'), 'plot', &
                'pictures as '//word(i, 'svg pdf png'))
        end do
        options = options_of('run|-o|out.lst|a', tap)
        call tap%same(options%output, 'out.lst', 'a file for the result')
        options = options_of('run|-o|-|-', tap)
        call tap%same(options%output//decks(options), '--|', 'standard output and input')
        options = options_of('run|-o|a=b|a', tap)
        call tap%same(options%output, 'a=b', 'a file with an equals sign')
        options = options_of('run|--asa|--arithmetic|s360', tap)
        call tap%ok(options%asa, 'a flag')
        options = options_of('run|--shift|1|--shift|2', tap)
        call tap%near(to_real(options%shift), 2.0_dp, 0.0_dp, 'of two the last counts')
    end subroutine check_values

    !> Numbers.
    subroutine check_shift()
        type(options_type) :: options
        options = options_of('run|--shift=1.5e3', tap)
        call tap%near(to_real(options%shift), 1500.0_dp, 0.0_dp, 'a shift with an exponent')
        options = options_of('run|--shift|0', tap)
        call tap%near(to_real(options%shift), 0.0_dp, 0.0_dp, 'no shift')
        call refused('run|--shift|lots', '--shift ''lots'': it is a number in deck units', &
            'a shift in words')
        call refused('run|--shift=', '--shift '''': it is a number in deck units', 'an empty shift')
        call refused('run|--shift|1,5', '--shift ''1,5'': it is a number in deck units', &
            'a shift with a comma')
        call refused('run|--shift|1e99', '--shift ''1e99'': it is a number in deck units', &
            'a shift out of range')
    end subroutine check_shift

    !> Decks.
    subroutine check_operands()
        call tap%same(decks(options_of('check|a|b|-|c', tap)), 'a|b|-|c|', &
            'decks stay in their order')
        call tap%same(decks(options_of('run|--|-o', tap)), '-o|', &
            'after -- a name may begin with -')
        call tap%same(decks(options_of('run|a|-o|b', tap)), 'a|', &
            'options may stand behind the deck')
        call tap%same(decks(options_of('check|--|--|a', tap)), '--|a|', 'a second -- is a name')
        call refused('run|a|b', 'loft run takes one deck; ''b'' is too much', 'run with two decks')
        call refused('plot|a|b|c', 'loft plot takes one deck; ''b'' is too much', 'plot with three')
        call refused('check', 'loft check needs a deck (- is standard input)', 'check without one')
        call refused('plot|-o|x', 'loft plot needs a deck (- is standard input)', &
            'plot without one')
    end subroutine check_operands

    !> Help.
    subroutine check_help()
        call tap%same(command('run|--help')//decks(options_of('run|--help', tap)), 'helprun|', &
            'a command''s --help is the help on it')
        call tap%same(command('check|-h')//decks(options_of('check|-h', tap)), 'helpcheck|', &
            '-h too')
        call tap%same(decks(options_of('plot|--help|--wrong|a|b', tap)), 'plot|', &
            'nothing behind it is looked at')
        call tap%same(decks(options_of('help|cards', tap)), 'cards|', 'a topic of help')
        call tap%same(decks(options_of('--help|run', tap)), 'run|', 'also behind the option')
        call tap%same(command('help|--help'), 'help', 'help on help')
        call refused('help|run|cards', 'loft help takes one topic; ''cards'' is too much', &
            'two topics')
        call refused('--version|a', '--version stands alone', 'a version with a word behind it')
        call refused('run|--help=yes', '--help takes no value', 'help with a value')
    end subroutine check_help

    !> Options that a command does not have.
    subroutine check_unknown()
        call refused('run|--wrong', 'loft run has no option --wrong (try loft help run)', &
            'an option that is none')
        call refused('run|--wrong=5', 'loft run has no option --wrong (try loft help run)', &
            'with a value')
        call refused('check|-o|x|a', 'loft check has no option -o (try loft help check)', &
            'an option of others')
        call refused('plot|--asa|a', 'loft plot has no option --asa (try loft help plot)', &
            'a flag of others')
        call refused('run|-ofile', 'loft run has no option -ofile (try loft help run)', &
            'a name without a blank')
        call refused('run|-o=file', 'loft run has no option -o=file (try loft help run)', &
            'or behind an equals sign')
        call refused('run|--arith|ieee', 'loft run has no option --arith (try loft help run)', &
            'a shortened option')
        call refused('run|--ASA', 'loft run has no option --ASA (try loft help run)', &
            'an option in capitals')
    end subroutine check_unknown

    !> Values that an option does not take.
    subroutine check_bad_values()
        call refused('run|--arithmetic|vax', '--arithmetic ''vax'': it is one of: ieee s360', &
            'another arithmetic')
        call refused('run|--format=svg', '--format ''svg'': it is one of: listing csv', &
            'a picture of run')
        call refused('plot|--format=csv|a', '--format ''csv'': it is one of: svg pdf png txt', &
            'a table of plot')
        call refused('run|--format=', '--format '''': it is one of: listing csv', 'an empty format')
        call refused('run|--format|listing csv', &
            '--format ''listing csv'': it is one of: listing csv', &
            'two formats in one word')
        call refused('run|--asa=yes', '--asa takes no value', 'a flag with a value')
        call refused('run|-o', '-o needs a value', 'no file behind -o')
        call refused('run|--shift', '--shift needs a value', 'no number behind --shift')
        call refused('run|--format', '--format needs a value', 'no word behind --format')
        call refused('run|-o|', '-o needs the name of a file', 'an empty file name')
    end subroutine check_bad_values

    !> What can't stand together.
    subroutine check_combinations()
        call refused('run|--arithmetic|s360|--format|csv', &
            '--format csv goes with --arithmetic ieee; the 1970 '// &
            'program printed pages only', 'CSV of the 1970 program')
        call refused('run|--asa', '--asa goes with --arithmetic s360', 'carriage control of IEEE')
        call tap%same(command('run|-|-o|-'), 'run', 'standard input and output are two')
        call tap%same(command('export|a|-o|b.pdf|--paper|A4|--units=MM'), 'export', &
            'words of options in capitals')
    end subroutine check_combinations

    !> The command of a command line that is in order.
    function command(line)
        character(*), intent(in) :: line !! see `words_of`
        character(:), allocatable :: command
        type(options_type) :: options
        options = options_of(line, tap)
        command = options%command
    end function command

    !> A command line that is refused, and what is said.
    subroutine refused(line, expected, name)
        character(*), intent(in) :: line     !! see `words_of`
        character(*), intent(in) :: expected !! the message
        character(*), intent(in) :: name     !! what is wrong
        type(options_type) :: options
        type(error_type), allocatable :: error
        call read_options(words_of(line), options, error)
        if (.not. allocated(error)) then
            call tap%ok(.false., 'refused: '//name)
            return
        end if
        call tap%same(error%message, expected, 'refused: '//name)
        call tap%ok(error%cause == cause%usage, 'as a fault of the command line: '//name)
    end subroutine refused

    !> One of some words.
    function word(which, words)
        integer, intent(in) :: which      !! its place, from 1
        character(*), intent(in) :: words !! three letters each, a blank between two
        character(3) :: word
        word = words(4*which - 3:4*which - 1)
    end function word

end program test_options
