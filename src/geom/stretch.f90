!> An arc divided where a stepped coordinate turns back, and the steps that each stretch passes,
!> counted before any row is made.
module geom_stretch
    use base_constants, only: largest_table
    use base_decimal, only: grid_type
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp, i64
    use base_text, only: compact, to_text
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_crossing, only: turning_places
    use geom_place, only: at_finish, place_type
    use geom_triangle, only: rounding
    implicit none (type, external)
    private

    public :: stretch_type, divide

    !> A stretch of an arc on which the stepped coordinate only increases or only decreases, and
    !> the steps strictly between its ends: `first, first + stride, ...`, `count` of them.
    type :: stretch_type
        type(place_type) :: finish       !! where it ends
        logical :: rising = .true.       !! the coordinate increases along it
        integer(i64) :: first = 0        !! the first step passed
        integer(i64) :: stride = 1       !! 1 or -1
        integer(i64) :: count = 0        !! steps passed
        logical :: touches = .false.     !! a step meets the extreme at its end
        integer(i64) :: touched = 0      !! that step
    end type stretch_type

    !> A conic turns back twice at most.
    integer, parameter :: most_stretches = 3
    !> Steps are counted from the grid's start; beyond this count the grid can't be meant.
    real(dp), parameter :: furthest_step = 1000.0_dp*largest_table

contains

    !> Divides an arc at its extremes and counts the steps of each stretch. An extreme that rounding
    !> can't tell from an end of the arc, or from the extreme before it, is that.
    !>
    !> Fails with `cause%too_many` where there would be more than `largest_table` rows, and with
    !> `cause%increment` where the grid starts too many steps away from the arc.
    pure subroutine divide(arc, axis, grid, stretches, error)
        type(arc_type), intent(in) :: arc                             !! any arc
        integer, intent(in) :: axis                                   !! 1: step x, 2: step y
        type(grid_type), intent(in) :: grid                           !! the stepped ordinates
        type(stretch_type), allocatable, intent(out) :: stretches(:)  !! in order along the arc
        type(error_type), allocatable, intent(out) :: error           !! see above
        type(place_type), allocatable :: ends(:)
        type(stretch_type) :: found(most_stretches)
        real(dp) :: from, to, noise, last, span
        integer :: i, count

        count = 0
        allocate (ends(0))
        ends = [turning_places(arc, axis), at_finish]
        from = arc%start(axis)
        last = arc%finish(axis)
        noise = extent_noise(arc, ends)
        span = 0.0_dp
        do i = 1, size(ends)
            to = coordinate(arc, axis, ends(i))
            if (abs(to - from) <= noise) cycle
            if (i == size(ends) - 1 .and. abs(last - to) <= noise) ends(i) = at_finish
            count = count + 1
            associate (stretch => found(count))
                stretch%finish = ends(i)
                call count_steps(grid, from, to, noise, stretch, error)
                if (allocated(error)) return
                stretch%touches = stretch%touches .and. i < size(ends) .and. .not. at_end(ends(i))
            end associate
            span = span + abs(to - from)
            from = to
        end do
        allocate (stretches(count), source=found(:count))
        if (sum(stretches%count) + 2 > largest_table) call refuse(span, grid%step_length(), error)
    contains
        !> True for the last point of the arc.
        pure logical function at_end(place)
            type(place_type), intent(in) :: place !! any place
            at_end = .not. place%alpha%high > 0.0_dp
        end function at_end
    end subroutine divide

    !> One coordinate of a place, deck units.
    pure real(dp) function coordinate(arc, axis, place)
        type(arc_type), intent(in) :: arc     !! any arc
        integer, intent(in) :: axis           !! 1: x, 2: y
        type(place_type), intent(in) :: place !! where on the arc
        real(dp) :: at(2)
        at = point(arc, place)
        coordinate = at(axis)
    end function coordinate

    !> How far decimals meant to be equal may differ on an arc, deck units.
    pure real(dp) function extent_noise(arc, places) result(noise)
        type(arc_type), intent(in) :: arc         !! any arc
        type(place_type), intent(in) :: places(:) !! its extremes
        integer :: i
        noise = 0.0_dp
        do i = 1, size(places)
            noise = max(noise, rounding(arc%start, arc%finish, point(arc, places(i))))
        end do
    end function extent_noise

    !> Counts the steps strictly between two ordinates, and looks whether one meets the second.
    pure subroutine count_steps(grid, from, to, noise, stretch, error)
        type(grid_type), intent(in) :: grid                 !! the stepped ordinates
        real(dp), intent(in) :: from                        !! where the stretch starts, deck units
        real(dp), intent(in) :: to                          !! where it ends, further than `noise`
        real(dp), intent(in) :: noise                       !! within this, ordinates are equal
        type(stretch_type), intent(inout) :: stretch        !! counts are filled in
        type(error_type), allocatable, intent(out) :: error !! see `divide`
        integer(i64) :: last
        logical :: upward

        call check_steps(grid, from, to, error)
        if (allocated(error)) return
        stretch%rising = to > from
        upward = grid%ordinate(1_i64) > grid%ordinate(0_i64)
        stretch%stride = merge(1_i64, -1_i64, stretch%rising .eqv. upward)
        stretch%first = step_inside(grid, from, sign(noise, to - from), stretch%stride)
        last = step_inside(grid, to, sign(noise, from - to), -stretch%stride)
        stretch%count = max(0_i64, (last - stretch%first)*stretch%stride + 1_i64)
        stretch%touched = nint(grid%steps_to(to), i64)
        stretch%touches = abs(grid%ordinate(stretch%touched) - to) <= noise
    end subroutine count_steps

    !> The first step that is inside of an end of a stretch.
    pure integer(i64) function step_inside(grid, edge, margin, inwards) result(k)
        type(grid_type), intent(in) :: grid !! the stepped ordinates
        real(dp), intent(in) :: edge        !! ordinate of the end, deck units
        real(dp), intent(in) :: margin      !! how far inside it must be; its sign says which way
        integer(i64), intent(in) :: inwards !! 1 or -1: which way the steps go inwards

        k = nint(grid%steps_to(edge), i64) - inwards
        do while (.not. (grid%ordinate(k) - edge)*sign(1.0_dp, margin) > abs(margin))
            k = k + inwards
        end do
    end function step_inside

    !> The length of a step; zero where it is lost beside the first ordinate.
    pure real(dp) function step_of(grid)
        type(grid_type), intent(in) :: grid !! the stepped ordinates
        step_of = abs(grid%ordinate(1_i64) - grid%ordinate(0_i64))
    end function step_of

    !> Fails where the steps of a stretch are too many to make or to count.
    pure subroutine check_steps(grid, from, to, error)
        type(grid_type), intent(in) :: grid                 !! the stepped ordinates
        real(dp), intent(in) :: from                        !! where the stretch starts, deck units
        real(dp), intent(in) :: to                          !! where it ends, deck units
        type(error_type), allocatable, intent(out) :: error !! see `divide`
        real(dp) :: start, step

        start = grid%ordinate(0_i64)
        step = step_of(grid)
        if (abs(to - from) > largest_table*step) then
            call refuse(abs(to - from), grid%step_length(), error)
        else if (max(abs(from - start), abs(to - start)) > furthest_step*step) then
            call fail(error, cause%increment, 'the arc is more than '//compact(furthest_step)// &
                ' steps away from the first ordinate; start the steps nearer to it')
        end if
    end subroutine check_steps

    !> The error of a table that is too long.
    pure subroutine refuse(span, step, error)
        real(dp), intent(in) :: span                        !! length to step along, deck units
        real(dp), intent(in) :: step                        !! length of a step, deck units
        type(error_type), allocatable, intent(out) :: error !! allocated on return
        character(:), allocatable :: rows
        real(dp), parameter :: countable = 1.0e15_dp

        rows = 'more rows than can be counted'
        if (span < countable*step) rows = to_text(nint(span/step, i64) + 1_i64)//' rows'
        call fail(error, cause%too_many, 'an increment of '//compact(step)//' over '// &
            compact(span)//' makes '//rows//'; LOFT makes at most '//to_text(largest_table)// &
            ' in a table: take an increment of '//compact(2.0_dp*span/largest_table)//' or more')
    end subroutine refuse

end module geom_stretch
