!> Command lines for tests, written with bars between their words: `run|--asa|deck`.
module support_command_line
    use app_options, only: argument_type, options_type, read_options
    use base_error, only: error_type
    use support_tap, only: tap_type
    implicit none (type, external)
    private

    public :: words_of, options_of, decks, given

contains

    !> Words of a command line written with bars between them.
    function words_of(line) result(argument)
        character(*), intent(in) :: line !! `run|--asa|deck`
        type(argument_type), allocatable :: argument(:)
        integer :: i, first, last

        allocate (argument(count([(line(i:i) == '|', i = 1, len(line))]) + merge(1, 0, line /= '')))
        first = 1
        do i = 1, size(argument)
            last = first + index(line(first:)//'|', '|') - 2
            argument(i)%text = line(first:last)
            first = last + 2
        end do
    end function words_of

    !> The options of a command line that is in order.
    function options_of(line, tap) result(options)
        character(*), intent(in) :: line            !! see `words_of`
        type(tap_type), intent(inout) :: tap        !! counts a failure where it is not
        type(options_type) :: options
        type(error_type), allocatable :: error
        call read_options(words_of(line), options, error)
        if (allocated(error)) call tap%ok(.false., line//': '//error%message)
    end function options_of

    !> The decks, a bar behind each.
    function decks(options) result(text)
        type(options_type), intent(in) :: options !! what was read
        character(:), allocatable :: text
        integer :: i
        text = ''
        do i = 1, size(options%operand)
            text = text//options%operand(i)%text//'|'
        end do
    end function decks

    !> The options of export with their values, a bar behind each.
    function given(options) result(text)
        type(options_type), intent(in) :: options !! what was read
        character(:), allocatable :: text
        integer :: i
        text = ''
        do i = 1, size(options%given)
            text = text//options%given(i)%name//'|'//options%given(i)%text//'|'
        end do
    end function given

end module support_command_line
