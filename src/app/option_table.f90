!> Every option of LOFT as a table: its name, what stands behind it, the commands that know it, and
!> of those of `loft export` the formats.
module app_option_table
    use base_text, only: upper
    implicit none (type, external)
    private

    public :: option_layout_type, known, option_of, is_one_of, word_meant

    !> One option.
    type :: option_layout_type
        character(14) :: name       !! as typed
        character(8) :: kind        !! `flag`; or what follows it: `words`, `number`, `positive`,
                                    !! `path`, `text`, `paper` (one of `words`; behind roll a width)
        character(48) :: words      !! what it may be, where its kind is `words` or `paper`; what a
                                    !! number is of
        character(40) :: commands   !! the commands that take it
        character(40) :: formats    !! the files of `export` it matters to; blank: all
    end type option_layout_type

    !> All of them.
    type(option_layout_type), parameter :: known(30) = [ &
        option_layout_type('--arithmetic', 'words', 'ieee s360', 'run', ''), &
        option_layout_type('--shift', 'number', 'in deck units', 'run', ''), &
        option_layout_type('--asa', 'flag', '', 'run', ''), &
        option_layout_type('--format', 'words', 'listing csv', 'run', ''), &
        option_layout_type('--format', 'words', 'svg pdf png txt', 'plot', ''), &
        option_layout_type('--format', 'words', 'listing csv deck', 'audit', ''), &
        option_layout_type('--format', 'words', 'svg pdf dxf iges step stl obj nc hrm wgs csv', &
            'export', ''), &
        option_layout_type('-o', 'path', '', 'run plot export audit sweep', ''), &
        option_layout_type('--help', 'flag', '', 'run check plot export audit sweep help', ''), &
        option_layout_type('--resume', 'flag', '', 'sweep', ''), &
        option_layout_type('--variant', 'positive', 'of a variant', 'sweep', ''), &
        option_layout_type('--plot', 'flag', '', 'sweep', ''), &
        option_layout_type('--tolerance', 'positive', 'in deck units', 'export', ''), &
        option_layout_type('--units', 'words', 'in mm ft m', 'export', &
            'svg pdf dxf iges step stl obj nc hrm wgs'), &
        option_layout_type('--cut', 'text', '', 'export', 'svg pdf dxf iges step nc'), &
        option_layout_type('--sheet', 'words', 'each all', 'export', 'svg pdf'), &
        option_layout_type('--paper', 'paper', 'a4 letter a3 tabloid roll', 'export', 'svg pdf'), &
        option_layout_type('--overlap', 'positive', 'in units of the file', 'export', &
            'svg pdf'), &
        option_layout_type('--half', 'flag', '', 'export', 'svg pdf dxf nc'), &
        option_layout_type('--bevel', 'positive', 'in deck units', 'export', 'svg pdf dxf'), &
        option_layout_type('--dxf-splines', 'flag', '', 'export', 'dxf'), &
        option_layout_type('--3d', 'flag', '', 'export', 'dxf'), &
        option_layout_type('--arcs', 'flag', '', 'export', 'dxf nc'), &
        option_layout_type('--iges-conics', 'flag', '', 'export', 'iges'), &
        option_layout_type('--angle', 'positive', 'of degrees', 'export', &
            'stl obj hrm wgs csv'), &
        option_layout_type('--binary', 'flag', '', 'export', 'stl'), &
        option_layout_type('--open', 'flag', '', 'export', 'iges step stl obj'), &
        option_layout_type('--feed', 'positive', 'of units of the file a minute', 'export', &
            'nc'), &
        option_layout_type('--depth', 'number', 'in units of the file', 'export', 'nc'), &
        option_layout_type('--safe', 'positive', 'in units of the file', 'export', 'nc')]

contains

    !> The option of a command with some name; one with a blank name where it has none.
    pure type(option_layout_type) function option_of(name, command) result(layout)
        character(*), intent(in) :: name    !! as typed
        character(*), intent(in) :: command !! the command
        integer :: i

        layout = option_layout_type('', '', '', '', '')
        do i = 1, size(known)
            if (known(i)%name == name .and. is_one_of(command, known(i)%commands)) layout = known(i)
        end do
    end function option_of

    !> True where a word stands in a list of words with blanks between them.
    pure logical function is_one_of(word, list)
        character(*), intent(in) :: word !! the word
        character(*), intent(in) :: list !! the words
        is_one_of = index(' '//trim(list)//' ', ' '//word//' ') > 0 .and. index(word, ' ') == 0
    end function is_one_of

    !> The word of a list that a text is, in capitals or not; nothing where it is none.
    pure function word_meant(text, list) result(word)
        character(*), intent(in) :: text !! as typed
        character(*), intent(in) :: list !! words with blanks between them, in small letters
        character(:), allocatable :: word
        integer :: first

        word = ''
        if (.not. is_one_of(upper(text), upper(list))) return
        first = index(' '//upper(trim(list))//' ', ' '//upper(text)//' ')
        word = list(first:first + len(text) - 1)
    end function word_meant

end module app_option_table
