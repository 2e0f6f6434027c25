!> The command line: which command, its options, its decks. Everything that is not understood is an
!> error that says what would be.
module app_options
    use base_decimal, only: decimal_type
    use base_error, only: cause, error_type, fail
    use deck_number, only: number_type, read_number
    implicit none (type, external)
    private

    public :: options_type, argument_type, read_options

    !> One word of the command line.
    type :: argument_type
        character(:), allocatable :: text !! the word as given
    end type argument_type

    !> What the command line asks for.
    type :: options_type
        character(:), allocatable :: command    !! run, check, plot, help or version
        character(:), allocatable :: arithmetic !! ieee or s360
        character(:), allocatable :: format     !! listing, csv; svg, pdf, png, txt
        character(:), allocatable :: output     !! file or folder of `-o`, or nothing
        type(decimal_type) :: shift             !! shift of the 1970 program, deck units
        logical :: asa = .false.                !! the carriage control column is kept
        logical :: wants_help = .false.         !! --help stands behind the command
        type(argument_type), allocatable :: operand(:) !! decks, or the topic of help
    end type options_type

    !> One option: its name, the words it takes, the commands that know it.
    type :: option_layout_type
        character(12) :: name      !! as typed
        character(8) :: kind       !! `flag`, `words`, `number`, `path`
        character(24) :: words     !! what it may be, where its kind is `words`
        character(20) :: commands  !! the commands that take it
    end type option_layout_type

    !> Every option of LOFT.
    type(option_layout_type), parameter :: known(7) = [ &
        option_layout_type('--arithmetic', 'words', 'ieee s360', 'run'), &
        option_layout_type('--shift', 'number', '', 'run'), &
        option_layout_type('--asa', 'flag', '', 'run'), &
        option_layout_type('--format', 'words', 'listing csv', 'run'), &
        option_layout_type('--format', 'words', 'svg pdf png txt', 'plot'), &
        option_layout_type('-o', 'path', '', 'run plot'), &
        option_layout_type('--help', 'flag', '', 'run check plot help')]

    !> The commands.
    character(*), parameter :: commands = 'run check plot help'

contains

    !> Reads the command line.
    !>
    !> Fails with `cause%usage` where a word of it is not understood.
    pure subroutine read_options(argument, options, error)
        type(argument_type), intent(in) :: argument(:)      !! its words, without the program's
        type(options_type), intent(out) :: options          !! what it asks for
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i
        logical :: only_operands

        call set_defaults(options)
        if (size(argument) == 0) then
            call fail(error, cause%usage, 'no command; one of: '//commands//' (try loft help)')
            return
        end if
        call read_command(argument(1)%text, options, error)
        only_operands = .false.
        i = 2
        do while (i <= size(argument) .and. .not. allocated(error) .and. .not. options%wants_help)
            if (argument(i)%text == '--' .and. .not. only_operands) then
                only_operands = .true.
            else if (index(argument(i)%text, '-') == 1 .and. argument(i)%text /= '-' &
                .and. .not. only_operands) then
                call read_option(argument, i, options, error)
            else
                options%operand = [options%operand, argument(i)]
            end if
            i = i + 1
        end do
        if (allocated(error)) return
        if (options%wants_help) then
            deallocate (options%operand)
            allocate (options%operand(1))
            options%operand(1)%text = options%command
            options%command = 'help'
        end if
        call check_options(options, error)
    end subroutine read_options

    !> What is done where nothing is said.
    pure subroutine set_defaults(options)
        type(options_type), intent(inout) :: options !! gets the defaults
        options%arithmetic = 'ieee'
        options%format = ''
        options%output = ''
        options%shift = decimal_type(100, 0)
        allocate (options%operand(0))
    end subroutine set_defaults

    !> Reads the first word.
    pure subroutine read_command(word, options, error)
        character(*), intent(in) :: word                    !! the word
        type(options_type), intent(inout) :: options        !! gets the command
        type(error_type), allocatable, intent(out) :: error !! `cause%usage`
        select case (word)
        case ('--help', '-h')
            options%command = 'help'
        case ('--version')
            options%command = 'version'
        case default
            if (is_one_of(word, commands)) then
                options%command = word
            else
                call fail(error, cause%usage, ''''//word//''' is no command; one of: '//commands)
            end if
        end select
    end subroutine read_command

    !> Reads an option and the word behind it, if it takes one: `--shift 200` or `--shift=200`.
    pure subroutine read_option(argument, i, options, error)
        type(argument_type), intent(in) :: argument(:)      !! the command line
        integer, intent(inout) :: i                         !! the option; moved to its last word
        type(options_type), intent(inout) :: options        !! gets what it says
        type(error_type), allocatable, intent(out) :: error !! `cause%usage`
        character(:), allocatable :: name, value
        integer :: equals, k

        name = argument(i)%text
        equals = index(name, '=')
        if (equals > 0 .and. index(name, '--') == 1) name = name(:equals - 1)
        if (name == '-h') name = '--help'
        k = which(name, options%command)
        if (k == 0) then
            call fail(error, cause%usage, 'loft '//options%command//' has no option '//name// &
                ' (try loft help '//options%command//')')
        else if (known(k)%kind == 'flag') then
            if (equals > 0) call fail(error, cause%usage, name//' takes no value')
            if (name == '--asa') options%asa = .true.
            if (name == '--help') options%wants_help = .true.
        else if (equals > 0 .and. index(name, '--') == 1) then
            value = argument(i)%text(equals + 1:)
            call set_value(known(k), value, options, error)
        else if (i < size(argument)) then
            i = i + 1
            call set_value(known(k), argument(i)%text, options, error)
        else
            call fail(error, cause%usage, name//' needs a value')
        end if
    end subroutine read_option

    !> Stores the value of an option after a look at it.
    pure subroutine set_value(layout, value, options, error)
        type(option_layout_type), intent(in) :: layout      !! the option
        character(*), intent(in) :: value                   !! its value
        type(options_type), intent(inout) :: options        !! gets it
        type(error_type), allocatable, intent(out) :: error !! `cause%usage`
        type(number_type) :: number

        if (layout%kind == 'words' .and. .not. is_one_of(value, layout%words)) then
            call fail(error, cause%usage, trim(layout%name)//' '''//value//''': it is one of: '// &
                trim(layout%words))
            return
        end if
        select case (layout%name)
        case ('--arithmetic')
            options%arithmetic = value
        case ('--format')
            options%format = value
        case ('-o')
            options%output = value
            if (value == '') call fail(error, cause%usage, '-o needs the name of a file')
        case ('--shift')
            number = read_number(value, 0)
            options%shift = number%value
            if (number%first > 0 .or. number%is_blank) call fail(error, cause%usage, &
                '--shift '''//value//''': it is a number in deck units')
        end select
    end subroutine set_value

    !> What can't stand together.
    pure subroutine check_options(options, error)
        type(options_type), intent(inout) :: options        !! all that was read
        type(error_type), allocatable, intent(out) :: error !! `cause%usage`

        select case (options%command)
        case ('run', 'plot')
            if (size(options%operand) > 1) call fail(error, cause%usage, &
                'loft '//options%command//' takes one deck; '''// &
                options%operand(2)%text//''' is too much')
        case ('help')
            if (size(options%operand) > 1) call fail(error, cause%usage, &
                'loft help takes one topic; '''//options%operand(2)%text//''' is too much')
        case ('version')
            if (size(options%operand) > 0) call fail(error, cause%usage, '--version stands alone')
        end select
        if (size(options%operand) == 0 .and. is_one_of(options%command, 'check plot')) then
            call fail(error, cause%usage, &
                'loft '//options%command//' needs a deck (- is standard input)')
        end if
        if (allocated(error) .or. options%command /= 'run') return
        if (options%arithmetic == 's360' .and. options%format == 'csv') then
            call fail(error, cause%usage, '--format csv goes with --arithmetic ieee; the 1970 '// &
                'program printed pages only')
        else if (options%asa .and. options%arithmetic /= 's360') then
            call fail(error, cause%usage, '--asa goes with --arithmetic s360')
        end if
    end subroutine check_options

    !> Where in the table an option of a command stands; 0 where it has none of that name.
    pure integer function which(name, command)
        character(*), intent(in) :: name    !! the option
        character(*), intent(in) :: command !! the command
        do which = size(known), 1, -1
            if (known(which)%name == name .and. is_one_of(command, known(which)%commands)) return
        end do
    end function which

    !> True where a word stands in a list of words with blanks between them.
    pure logical function is_one_of(word, list)
        character(*), intent(in) :: word !! the word
        character(*), intent(in) :: list !! the words
        is_one_of = index(' '//trim(list)//' ', ' '//word//' ') > 0 .and. index(word, ' ') == 0
    end function is_one_of

end module app_options
