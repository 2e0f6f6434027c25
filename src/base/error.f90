!> The one way a procedure of LOFT says that it could not do what it was asked: an allocatable
!> `error_type` as last argument, left unallocated when all went well. Only `app` prints it.
!>
!>     call some_deed(..., error)
!>     if (allocated(error)) return
module base_error
    implicit none (type, external)
    private

    public :: error_type, fail

    !> What went wrong, in a form a program can ask about. The comment names who says so.
    type, public :: cause_list
        integer :: file_trouble = 1        !! a file can't be opened, read, written or renamed
        integer :: usage = 2               !! the command line is wrong
        integer :: points_coincide = 10    !! two of the three points of a conic are one
        integer :: shoulder_on_chord = 11  !! shoulder point in line with 1 and 3, tangents not
        integer :: shoulder_outside = 12   !! shoulder point on the wrong side of chord or tangent
        integer :: inflection = 13         !! end slopes that only an S-shaped curve could have
        integer :: other_branch = 14       !! shoulder point on the other branch of the conic
        integer :: tangent_on_chord = 15   !! an end tangent runs along the chord of a curved arc
        integer :: not_single_valued = 16  !! an arc of a line that turns past the vertical
        integer :: joint_gap = 17          !! arcs that should meet and do not
        integer :: no_arc = 18             !! points, slopes, rho or radius that fix no arc
        integer :: no_match = 19           !! no conic between two ends has the curvature wanted
        integer :: singular = 20           !! a linear system has no unique solution
        integer :: no_convergence = 21     !! an iteration did not reach its tolerance
        integer :: checks_off = 22         !! solved, but its solution misses the conditions
        integer :: too_few = 23            !! fewer points than the curve takes
        integer :: bad_weight = 24         !! a weight below zero, or a share not from 0 to 1
        integer :: no_area = 25            !! an area that a faired curve can't enclose
        integer :: overflow = 30           !! exponent overflow of a System/360 number
        integer :: underflow = 31          !! exponent underflow of a System/360 number
        integer :: divide = 32             !! division by zero in System/360 arithmetic
        integer :: increment = 40          !! an increment that can't step a table
        integer :: too_many = 41           !! a table longer than LOFT makes
        integer :: beyond_lines = 42       !! a cut where the body's lines are not
    end type cause_list

    !> The causes by name: `case (cause%inflection)`.
    type(cause_list), parameter, public :: cause = cause_list()

    !> One failure: what kind, and the sentence that says what is wrong and what would be right.
    type :: error_type
        integer :: cause = 0                    !! one of `cause%...`
        character(:), allocatable :: message    !! plain words, no final point, no position
    end type error_type

contains

    !> Makes an error.
    pure subroutine fail(error, why, message)
        type(error_type), allocatable, intent(out) :: error !! allocated on return
        integer, intent(in) :: why                          !! one of `cause%...`
        character(*), intent(in) :: message                 !! what is wrong and what would be right
        allocate (error)
        error%cause = why
        error%message = message
    end subroutine fail

end module base_error
