!> What a body deck says of its design sweep: which fields of which cards vary, how their values are
!> chosen, and which measures of the body are looked at. Plain data, a part of the job.
!>
!>     SWEEP   LATIN   200.    7.                      how variants are made
!>     -30.    -10.    .114    0.      -7.1    50.     -4.     .0523
!>     VARY    Y2      HIGH    -8.     -6.     5       a field of the card before
!>     OBJECT  VOLUME  MAX                             what is wanted
!>     LIMIT   WIDTH   28.             20.     -16.    what must be kept
module deck_sweep
    use base_decimal, only: decimal_type
    use deck_body_card, only: card_type
    implicit none (type, external)
    private

    public :: sweep_type, variable_type, target_type, wanted_type, has_aim

    !> Characters of a name.
    integer, parameter :: name_length = 8

    !> How the values of variants are chosen.
    type, public :: method_list
        integer :: grid = 1     !! every value of each variable with every one of the others
        integer :: latin = 2    !! a Latin hypercube
        integer :: list = 3     !! variant k has the k-th value of every variable
    end type method_list
    type(method_list), parameter, public :: method = method_list()

    !> The measures, in the order of `measure_words` of `deck_body_layout`.
    type, public :: measure_list
        integer :: volume = 1   !! deck units**3
        integer :: wetted = 2   !! area of the skin, deck units**2
        integer :: centroid = 3 !! station of the centroid of the volume
        integer :: area = 4     !! of the section at a station, deck units**2
        integer :: girth = 5    !! of the section at a station
        integer :: width = 6    !! of the section at a station, on a waterline
        integer :: height = 7   !! of the section at a station, on a butt line
        integer :: clear = 8    !! least clearance of the components, or that of one
        integer :: jump = 9     !! greatest jump of curvature at joints of lines, 1/deck unit
        integer :: break = 10   !! greatest break of slope there, degrees
    end type measure_list
    type(measure_list), parameter, public :: measure = measure_list()

    !> What is wanted of a measure.
    type, public :: goal_list
        integer :: least = 1    !! as small as may be
        integer :: most = 2     !! as great as may be
        integer :: near = 3     !! as near to a value as may be
        integer :: show = 4     !! nothing; it is shown
        integer :: range = 5    !! that it is within a range
    end type goal_list
    type(goal_list), parameter, public :: goal = goal_list()

    !> A variable: its first VARY card.
    type :: variable_type
        character(name_length) :: name = ''         !! its name
        logical :: is_list = .false.                !! its values are listed
        type(decimal_type), allocatable :: value(:) !! FROM and TO, or the list
        integer :: count = 0                        !! values from FROM to TO; 0: not said
        type(card_type) :: card                     !! its card
    end type variable_type

    !> A field that varies.
    type :: target_type
        integer :: variable = 0             !! with which variable
        logical :: is_tied = .false.        !! it holds `factor` times the variable and `add`
        type(decimal_type) :: factor        !! see above
        type(decimal_type) :: add           !! see above
        type(card_type) :: of               !! the card that is varied
        integer :: field = 0                !! which field of it
        type(card_type) :: card             !! the VARY card
    end type target_type

    !> A measure that is looked at.
    type :: wanted_type
        character(name_length) :: name = ''     !! of its column
        integer :: body = 1                     !! of which body of the job
        integer :: measure = 0                  !! one of `measure%...`
        integer :: goal = 0                     !! one of `goal%...`
        type(decimal_type) :: value             !! `goal%near`: that value
        logical :: has_from = .false.           !! `goal%range`: it has a least value
        logical :: has_to = .false.             !! and a greatest
        type(decimal_type) :: from              !! the least
        type(decimal_type) :: to                !! the greatest
        character(name_length) :: of = ''       !! component or line, or blank: all
        type(decimal_type) :: sta               !! station
        type(decimal_type) :: at                !! waterline or butt line
        type(card_type) :: card                 !! its card
    end type wanted_type

    !> All of it. Without VARY cards there is no sweep.
    type :: sweep_type
        integer :: method = 1                           !! one of `method%...`
        integer :: count = 0                            !! variants of a Latin hypercube
        integer :: seed = 1                             !! of its chance
        type(card_type) :: card                         !! the SWEEP card, where there is one
        type(variable_type), allocatable :: variable(:) !! in the order of their cards
        type(target_type), allocatable :: target(:)     !! in the order of their cards
        type(wanted_type), allocatable :: wanted(:)     !! in the order of their cards
    end type sweep_type

contains

    !> True for an objective: a measure that is to be small, great or near a value.
    elemental logical function has_aim(wanted)
        type(wanted_type), intent(in) :: wanted !! a measure that is looked at
        has_aim = any(wanted%goal == [goal%least, goal%most, goal%near])
    end function has_aim

end module deck_sweep
