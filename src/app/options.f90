!> The command line: which command, its options, its decks. Everything that is not understood is an
!> error that says what would be.
module app_options
    use app_option_table, only: is_one_of, option_layout_type, option_of, word_meant
    use base_decimal, only: decimal_type, to_real
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: upper
    use deck_number, only: number_type, read_number
    implicit none (type, external)
    private

    public :: options_type, argument_type, given_type, read_options, was_given, is_csv_by_name

    !> One word of the command line.
    type :: argument_type
        character(:), allocatable :: text !! the word as given
    end type argument_type

    !> An option of `loft export` or `loft sweep` that was given.
    type :: given_type
        character(:), allocatable :: name   !! of the option
        character(:), allocatable :: text   !! its value as typed; nothing: a flag
        real(dp) :: number = 0.0_dp         !! its value, or the number behind its word
    end type given_type

    !> What the command line asks for.
    type :: options_type
        character(:), allocatable :: command    !! run, check, plot, export, audit, sweep, help,
                                                !! version
        character(:), allocatable :: arithmetic !! ieee or s360
        character(:), allocatable :: format     !! of the result; empty: not said
        character(:), allocatable :: output     !! file or folder of `-o`, or nothing
        type(decimal_type) :: shift             !! shift of the 1970 program, deck units
        logical :: asa = .false.                !! the carriage control column is kept
        logical :: wants_help = .false.         !! --help stands behind the command
        type(argument_type), allocatable :: operand(:) !! decks, or the topic of help
        type(given_type), allocatable :: given(:) !! the options of export and sweep, as they stand
    end type options_type

    !> The commands.
    character(*), parameter :: commands = 'run check plot export audit sweep help'

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
        allocate (options%operand(0), options%given(0))
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
        type(option_layout_type) :: layout
        type(given_type) :: given
        character(:), allocatable :: name
        integer :: equals

        name = argument(i)%text
        equals = 0
        if (index(name, '--') == 1) equals = index(name, '=')
        if (equals > 0) name = name(:equals - 1)
        if (name == '-h') name = '--help'
        given%name = name
        given%text = ''
        layout = option_of(name, options%command)
        if (layout%name == '') then
            call fail(error, cause%usage, 'loft '//options%command//' has no option '// &
                name//' (try loft help '//options%command//')')
        else if (layout%kind == 'flag') then
            if (equals > 0) call fail(error, cause%usage, name//' takes no value')
        else if (equals > 0) then
            given%text = argument(i)%text(equals + 1:)
        else if (i < size(argument)) then
            i = i + 1
            given%text = argument(i)%text
        else
            call fail(error, cause%usage, name//' needs a value')
        end if
        if (.not. allocated(error)) call check_value(layout, given, error)
        if (name == '-o' .and. options%output /= '' .and. .not. allocated(error)) &
            call fail(error, cause%usage, '-o is given twice: '//options%output//' and '// &
            given%text//'; a run has one result')
        if (allocated(error)) return
        if (layout%kind == 'paper' .and. given%text == 'roll') then
            call read_width(argument, i, given, error)
        end if
        if (.not. allocated(error)) call keep(given, options)
    end subroutine read_option

    !> Looks whether the value of an option is one it takes; words may be typed in capitals. Reads
    !> it where it is a number.
    pure subroutine check_value(layout, given, error)
        type(option_layout_type), intent(in) :: layout      !! the option
        type(given_type), intent(inout) :: given            !! its value; gets the number
        type(error_type), allocatable, intent(out) :: error !! `cause%usage`
        character(:), allocatable :: said
        logical :: is_number

        said = given%name//' '''//given%text//''': it is '
        select case (layout%kind)
        case ('words', 'paper')
            given%text = word_meant(given%text, layout%words)
            if (given%text == '') &
                call fail(error, cause%usage, said//'one of: '//trim(layout%words))
        case ('number', 'positive')
            said = said//'a number '//trim(layout%words)
            call read_value(given%text, given%number, is_number)
            if (layout%kind == 'positive') then
                is_number = is_number .and. given%number > 0.0_dp
                said = said//' above 0'
            end if
            if (.not. is_number) call fail(error, cause%usage, said)
        case ('path')
            if (given%text == '') &
                call fail(error, cause%usage, given%name//' needs the name of a file')
        case ('text')
            if (given%text == '') call fail(error, cause%usage, given%name//' needs a value')
        end select
    end subroutine check_value

    !> The number that a text is.
    pure subroutine read_value(text, value, is_number)
        character(*), intent(in) :: text    !! any
        real(dp), intent(out) :: value      !! 0 where it is none
        logical, intent(out) :: is_number   !! it is one
        type(number_type) :: number
        number = read_number(text, 0)
        value = to_real(number%value)
        is_number = number%first == 0 .and. .not. number%is_blank
    end subroutine read_value

    !> Reads the width of a roll of paper: `--paper roll 36`.
    pure subroutine read_width(argument, i, given, error)
        type(argument_type), intent(in) :: argument(:)      !! the command line
        integer, intent(inout) :: i                         !! the word roll; moved to the width
        type(given_type), intent(inout) :: given            !! gets the number
        type(error_type), allocatable, intent(out) :: error !! `cause%usage`
        character(:), allocatable :: width
        logical :: is_number

        width = ''
        if (i < size(argument)) width = argument(i + 1)%text
        call read_value(width, given%number, is_number)
        if (is_number .and. given%number > 0.0_dp) then
            i = i + 1
        else
            call fail(error, cause%usage, given%name//' roll '''//width// &
                ''': behind roll stands its width, a number in units of the file above 0')
        end if
    end subroutine read_width

    !> Keeps what an option says.
    pure subroutine keep(given, options)
        type(given_type), intent(in) :: given           !! the option
        type(options_type), intent(inout) :: options    !! gets it
        type(number_type) :: number

        select case (given%name)
        case ('--arithmetic')
            options%arithmetic = given%text
        case ('--format')
            options%format = given%text
        case ('-o')
            options%output = given%text
        case ('--asa')
            options%asa = .true.
        case ('--help')
            options%wants_help = .true.
        case ('--shift')
            number = read_number(given%text, 0)
            options%shift = number%value
        case default
            options%given = [options%given, given]
        end select
    end subroutine keep

    !> True where an option was given.
    pure logical function was_given(options, name)
        type(options_type), intent(in) :: options   !! the command line
        character(*), intent(in) :: name            !! of an option of export or sweep
        integer :: i
        was_given = .false.
        do i = 1, size(options%given)
            was_given = was_given .or. options%given(i)%name == name
        end do
    end function was_given

    !> True where a listing goes into a file whose name says that it holds comma-separated values.
    pure logical function is_csv_by_name(options)
        type(options_type), intent(in) :: options   !! the command line
        integer :: point

        point = index(options%output, '.', back=.true.)
        is_csv_by_name = .false.
        if (point == 0 .or. .not. is_one_of(options%command, 'run audit')) return
        is_csv_by_name = upper(options%output(point:)) == '.CSV' .and. options%format /= 'csv'
    end function is_csv_by_name

    !> What can't stand together.
    pure subroutine check_options(options, error)
        type(options_type), intent(inout) :: options        !! all that was read
        type(error_type), allocatable, intent(out) :: error !! `cause%usage`

        select case (options%command)
        case ('run', 'plot', 'export', 'audit', 'sweep')
            if (size(options%operand) > 1) call fail(error, cause%usage, &
                'loft '//options%command//' takes one deck; '''// &
                options%operand(2)%text//''' is too much')
        case ('help')
            if (size(options%operand) > 1) call fail(error, cause%usage, &
                'loft help takes one topic; '''//options%operand(2)%text//''' is too much')
        case ('version')
            if (size(options%operand) > 0) call fail(error, cause%usage, '--version stands alone')
        end select
        if (size(options%operand) == 0 .and. &
            is_one_of(options%command, 'check plot export audit sweep')) then
            call fail(error, cause%usage, &
                'loft '//options%command//' needs a deck (- is standard input)')
        end if
        if (options%command == 'export' .and. options%output == '' .and. .not. allocated(error)) &
            call fail(error, cause%usage, 'loft export needs -o FILE; its ending says which '// &
            'format (try loft help export)')
        if (allocated(error) .or. options%command /= 'run') return
        if (options%arithmetic == 's360' .and. options%format == 'csv') then
            call fail(error, cause%usage, '--format csv goes with --arithmetic ieee; the 1970 '// &
                'program printed pages only')
        else if (options%asa .and. options%arithmetic /= 's360') then
            call fail(error, cause%usage, '--asa goes with --arithmetic s360')
        end if
    end subroutine check_options

end module app_options
