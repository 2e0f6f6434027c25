!> A tally of checks in the Test Anything Protocol, read by `prove`.
!>
!>     type(tap_type) :: tap
!>     call tap%ok(is_round(x), 'a circle is round')
!>     call tap%near(area, pi, 1.0e-12_dp, 'unit circle has area pi')
!>     call tap%finish()
module support_tap
    use, intrinsic :: iso_fortran_env, only: output_unit
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: tap_type

    !> The count so far.
    type :: tap_type
        private
        integer :: run = 0
        integer :: failed = 0
    contains
        procedure :: ok
        procedure :: same
        procedure :: has
        procedure :: near
        procedure :: note
        procedure :: finish
    end type tap_type

contains

    !> Counts a check that must be true.
    subroutine ok(tap, passed, name)
        class(tap_type), intent(inout) :: tap !! the tally
        logical, intent(in) :: passed         !! what must be true
        character(*), intent(in) :: name      !! the check as a phrase
        tap%run = tap%run + 1
        if (.not. passed) tap%failed = tap%failed + 1
        write (output_unit, '(a,i0,2a)') trim(merge('ok    ', 'not ok', passed))//' ', tap%run, &
            ' - ', name
    end subroutine ok

    !> Counts a check that two texts are the same, and shows both where they are not.
    subroutine same(tap, actual, expected, name)
        class(tap_type), intent(inout) :: tap !! the tally
        character(*), intent(in) :: actual    !! text found
        character(*), intent(in) :: expected  !! text wanted
        character(*), intent(in) :: name      !! the check as a phrase
        logical :: equal
        equal = len(actual) == len(expected) .and. actual == expected
        call tap%ok(equal, name)
        if (equal) return
        call tap%note('     got: ['//actual//']')
        call tap%note('expected: ['//expected//']')
    end subroutine same

    !> Counts a check that a text has another in it, and shows it where it has not.
    subroutine has(tap, text, part, name)
        class(tap_type), intent(inout) :: tap !! the tally
        character(*), intent(in) :: text      !! where to look
        character(*), intent(in) :: part      !! what must stand there
        character(*), intent(in) :: name      !! the check as a phrase
        call tap%ok(index(text, part) > 0, name)
        if (index(text, part) > 0) return
        call tap%note('looked for: ['//part//'] in')
        call tap%note(text)
    end subroutine has

    !> Counts a check that a number is within a tolerance of another; NaN never is.
    subroutine near(tap, actual, expected, tolerance, name)
        class(tap_type), intent(inout) :: tap !! the tally
        real(dp), intent(in) :: actual        !! number found
        real(dp), intent(in) :: expected      !! number wanted
        real(dp), intent(in) :: tolerance     !! largest difference allowed
        character(*), intent(in) :: name      !! the check as a phrase
        character(120) :: text
        call tap%ok(abs(actual - expected) <= tolerance, name)
        if (abs(actual - expected) <= tolerance) return
        write (text, '(3(a,es24.16))') 'got', actual, ' expected', expected, ' within', tolerance
        call tap%note(trim(text))
    end subroutine near

    !> Prints a remark that is no check, one `#` line for each line of the text.
    subroutine note(tap, text)
        class(tap_type), intent(in) :: tap !! the tally
        character(*), intent(in) :: text   !! the remark
        integer :: i
        if (tap%run >= 0) write (output_unit, '(a)', advance='no') '# '
        do i = 1, len(text)
            write (output_unit, '(a)', advance='no') text(i:i)
            if (text(i:i) /= new_line('a') .or. i == len(text)) cycle
            write (output_unit, '(a)', advance='no') '# '
        end do
        write (output_unit, '(a)') ''
    end subroutine note

    !> Prints the plan and sets the exit status: 1 where any check failed or none was run.
    subroutine finish(tap)
        class(tap_type), intent(in) :: tap !! the tally
        write (output_unit, '(a,i0)') '1..', tap%run
        if (tap%failed > 0 .or. tap%run == 0) stop 1, quiet=.true.
    end subroutine finish

end module support_tap
