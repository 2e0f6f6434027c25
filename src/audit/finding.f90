!> What an audit finds of one figure.
module audit_finding
    use audit_figure, only: figure_length
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: finding_type, verdict_name

    !> What is said of a figure.
    type, public :: verdict_list
        integer :: none = 0       !! nothing: no line was found
        integer :: agrees = 1     !! the line goes through all that it may stand for
        integer :: rounding = 2   !! one unit of the last place off, as rounding differently does
        integer :: suspect = 3    !! more than that off, or not to the places of its table
        integer :: unreadable = 4 !! characters of it can't be read
        integer :: blank = 5      !! nothing is printed
    end type verdict_list
    !> The verdicts by name: `verdict%suspect`.
    type(verdict_list), parameter, public :: verdict = verdict_list()

    !> What an audit finds of one figure.
    type :: finding_type
        integer :: verdict = 0                      !! one of `verdict%...`
        integer :: piece = 0                        !! the conic of the chain it belongs to
        logical :: is_reached = .false.             !! that conic has a value there
        real(dp) :: computed = 0.0_dp               !! the value by the best line, deck units
        real(dp) :: low = 0.0_dp                    !! least value that all good figures allow
        real(dp) :: high = 0.0_dp                   !! greatest value that they allow
        real(dp) :: residual = 0.0_dp               !! printed less computed, in units
        character(figure_length) :: computed_figure = '' !! as the computed value would be printed
        character(figure_length) :: likely = ''     !! the likely true figure
        integer :: slip = 0                         !! how it was made, one of `slip%...`
        real(dp) :: sure = 1.0_dp                   !! how sure the likely figure is, 0 to 1
        real(dp) :: evidence = 1.0_dp               !! how likely it is read so, whatever is true
        integer :: rival = 0                        !! a reading that is bad if this one is good
    end type finding_type

contains

    !> A verdict in a word.
    pure function verdict_name(which) result(name)
        integer, intent(in) :: which !! one of `verdict%...`
        character(10), parameter :: names(0:5) = [character(10) :: 'not judged', 'agrees', &
            'rounding', 'suspect', 'unreadable', 'blank']
        character(len_trim(names(which), i64)) :: name
        name = names(which)
    end function verdict_name

end module audit_finding
