!> The options of `loft export`: words, numbers, names, a roll of paper, and every way to get them
!> wrong.
program test_export_options
    use app_options, only: options_type, read_options
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use support_command_line, only: decks, given, options_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_export()
    call check_bad_export()
    call tap%finish()

contains

    !> Options of export: kept with their values in the order given.
    subroutine check_export()
        type(options_type) :: options
        options = options_of('export|a|-o|b.dxf|--3d|--units|mm|--tolerance=.01'// &
            '|--cut|FLOOR|--cut=4', tap)
        call tap%same(given(options), '--3d||--units|mm|--tolerance|.01|--cut|FLOOR|--cut|4|', &
            'flags, words, numbers and names')
        call tap%near(options%given(3)%number, 0.01_dp, 0.0_dp, 'numbers are read')
        options = options_of('export|--paper|roll|36.5|a|-o|b.pdf', tap)
        call tap%same(given(options)//decks(options), '--paper|roll|a|', 'a roll takes two words')
        call tap%near(options%given(1)%number, 36.5_dp, 0.0_dp, 'the second is its width')
        options = options_of('export|--paper=roll|900|a|-o|b.pdf', tap)
        call tap%near(options%given(1)%number, 900.0_dp, 0.0_dp, 'also behind an equals sign')
        options = options_of('export|--paper|a4|900|-o|b.pdf', tap)
        call tap%same(given(options)//decks(options), '--paper|a4|900|', 'a4 takes one')
        options = options_of('export|a|-o|-|--format|wgs', tap)
        call tap%same(options%format//options%output, 'wgs-', 'a format for standard output')
        options = options_of('export|a|-o|b.nc|--depth|-.5|--safe|.1|--feed|20', tap)
        call tap%same(given(options), '--depth|-.5|--safe|.1|--feed|20|', &
            'a depth may be negative, a height is a number')
    end subroutine check_export

    !> What export does not take.
    subroutine check_bad_export()
        call refused('export|a', 'loft export needs -o FILE; its ending says which format '// &
            '(try loft help export)', 'no result')
        call refused('export|-o|a.svg', 'loft export needs a deck (- is standard input)', 'no deck')
        call refused('export|a|b|-o|c.svg', 'loft export takes one deck; ''b'' is too much', &
            'two decks')
        call refused('export|a|-o|b.svg|--tolerance|0', &
            '--tolerance ''0'': it is a number in deck units above 0', 'no tolerance')
        call refused('export|a|-o|b.svg|--tolerance|-1', &
            '--tolerance ''-1'': it is a number in deck units above 0', 'a negative tolerance')
        call refused('export|a|-o|b.svg|--tolerance=', &
            '--tolerance '''': it is a number in deck units above 0', 'an empty tolerance')
        call refused('export|a|-o|b.nc|--depth|deep', &
            '--depth ''deep'': it is a number in units of the file', 'a depth in words')
        call refused('export|a|-o|b.pdf|--paper|a5', &
            '--paper ''a5'': it is one of: a4 letter a3 tabloid roll', 'another paper')
        call refused('export|a|-o|b.pdf|--paper|roll', '--paper roll '''': behind roll stands '// &
            'its width, a number in units of the file above 0', 'a roll without width')
        call refused('export|a|-o|b.pdf|--paper|roll|wide', '--paper roll ''wide'': behind '// &
            'roll stands its width, a number in units of the file above 0', 'a width in words')
        call refused('export|a|-o|b.pdf|--paper|roll|0', '--paper roll ''0'': behind roll '// &
            'stands its width, a number in units of the file above 0', 'no width')
        call refused('export|a|-o|b.svg|--units|inches', &
            '--units ''inches'': it is one of: in mm ft m', 'a unit in full')
        call refused('export|a|-o|b.svg|--half=yes', '--half takes no value', 'a flag with a value')
        call refused('export|a|-o|b.svg|--cut|', '--cut needs a value', 'a cut without name')
        call refused('run|a|--3d', 'loft run has no option --3d (try loft help run)', &
            'its options elsewhere')
    end subroutine check_bad_export

    !> A command line that is refused, and what is said.
    subroutine refused(line, expected, name)
        character(*), intent(in) :: line     !! see `words_of`
        character(*), intent(in) :: expected !! the message
        character(*), intent(in) :: name     !! what is wrong
        type(options_type) :: options
        type(error_type), allocatable :: error
        call read_options(words_of(line), options, error)
        call tap%ok(allocated(error), 'refused: '//name)
        if (.not. allocated(error)) return
        call tap%same(error%message, expected, 'and it is said: '//name)
        call tap%ok(error%cause == cause%usage, 'as a fault of the command line: '//name)
    end subroutine refused

end program test_export_options
