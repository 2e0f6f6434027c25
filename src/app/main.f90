!> LOFT, a batch program for conic lofting: reads the command line, does what it asks, prints what
!> went wrong and sets the exit status.
program loft
    use app_audit, only: audit_tables
    use app_check, only: check_decks
    use app_export, only: export_deck
    use app_files, only: hold_standard_files
    use app_help, only: print_help, print_version
    use app_options, only: argument_type, is_csv_by_name, options_type, read_options
    use app_plot, only: plot_deck
    use app_run, only: run_deck
    use app_signals, only: end_run, guard_run
    use app_status, only: status
    use app_sweep, only: sweep_deck
    use app_threads, only: prepare_threads
    use base_error, only: error_type
    use base_output, only: output_type
    use base_posix, only: standard_error, standard_output
    use base_text, only: printable
    implicit none (type, external)

    type(options_type) :: options
    type(output_type) :: messages, answer
    type(error_type), allocatable :: error, ignored
    integer :: exit_status

    call guard_run()
    call hold_standard_files()
    call messages%attach(standard_error)
    call answer%attach(standard_output)
    exit_status = status%done
    call prepare_threads(error)
    if (.not. allocated(error)) call read_options(command_line(), options, error)
    if (.not. allocated(error)) then
        if (is_csv_by_name(options)) call messages%line('loft: '//options%output// &
            ' gets a listing; --format csv gives comma-separated values')
        select case (options%command)
        case ('run')
            call run_deck(options, exit_status, messages, error)
        case ('check')
            call check_decks(options%operand, exit_status, messages)
        case ('plot')
            call plot_deck(options, exit_status, messages, error)
        case ('export')
            call export_deck(options, exit_status, messages, error)
        case ('audit')
            call audit_tables(options, exit_status, messages, error)
        case ('sweep')
            call sweep_deck(options, exit_status, messages, error)
        case ('help')
            call print_help(topic(options), answer, error)
        case ('version')
            call print_version(answer)
        end select
    end if
    if (.not. allocated(error)) call answer%flush(error)
    if (allocated(error)) then
        call messages%line('loft: '//trim(printable(error%message)))
        exit_status = status%unusable
    end if
    call messages%flush(ignored)
    call end_run()
    if (exit_status /= status%done) stop exit_status, quiet=.true.

contains

    !> The words of the command line, without the program's name.
    function command_line() result(argument)
        type(argument_type), allocatable :: argument(:)
        integer :: i, length
        allocate (argument(command_argument_count()))
        do i = 1, size(argument)
            call get_command_argument(i, length=length)
            allocate (character(length) :: argument(i)%text)
            call get_command_argument(i, argument(i)%text)
        end do
    end function command_line

    !> The topic of `loft help TOPIC`.
    pure function topic(options)
        type(options_type), intent(in) :: options !! the command line
        character(:), allocatable :: topic
        topic = ''
        if (size(options%operand) > 0) topic = options%operand(1)%text
    end function topic

end program loft
