!> Bodies at random, and the same bodies in another guise: what a body is must not depend on where
!> its lines begin, on which side it lies, how far from the datum, in what unit, or in how many
!> pieces its lines are given.
module support_random_body
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type, finish_body
    use body_line, only: limit_line, line_type
    use body_section, only: section_type
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_arc_point, only: point, tangent
    use geom_chain, only: chain_type, new_chain
    use geom_place, only: at_shoulder, place_at
    use support_random, only: random_type
    implicit none (type, external)
    private

    public :: sketch_type, guise_type, random_sketch, body_of

    !> A conic as a card gives it: x and y of three points, directions at both ends.
    type :: conic_type
        type(end_type) :: start             !! first point
        real(dp) :: shoulder(2) = 0.0_dp    !! point between
        type(end_type) :: finish            !! last point
    end type conic_type

    !> The lines of a quarter body: side and plan of lower centre line, shoulder and side line, and
    !> the angle of the section at the side line.
    type :: sketch_type
        type(conic_type) :: side(2, 3)              !! WL over STA
        type(conic_type) :: plan(2, 3)              !! BL over STA
        type(conic_type) :: angle(2)                !! degrees over STA
        real(dp) :: keel(2) = [1.0_dp, 0.0_dp]      !! direction of the section at its start
    end type sketch_type

    !> Another guise of a body.
    type :: guise_type
        character(32) :: name = ''                  !! for the checks
        real(dp) :: mirror(3) = 1.0_dp              !! STA, BL, WL: -1 where mirrored
        real(dp) :: scale = 1.0_dp                  !! a unit over the other
        real(dp) :: shift(3) = 0.0_dp               !! STA, BL, WL, in the new unit
        logical :: has_lines_reversed = .false.     !! lines given from aft
        logical :: has_sections_reversed = .false.  !! sections given from the side line
        logical :: is_split = .false.               !! each conic in two
        logical :: is_port = .false.                !! by SIDE PORT
    end type guise_type

    !> Stations where the conics of a sketch begin and end, inches.
    real(dp), parameter :: knot(3) = [-20.0_dp, 15.0_dp, 70.0_dp]

contains

    !> A body at random. Its shoulder is .7 to .78 of the way from the corner opposite.
    subroutine random_sketch(random, sketch)
        type(random_type), intent(inout) :: random  !! the stream
        type(sketch_type), intent(out) :: sketch    !! the lines
        real(dp) :: keel(4), side(4), beam(4), angle(4), corner(2), full(2)

        corner = [random%between(0.35_dp, 0.65_dp), random%between(0.35_dp, 0.65_dp)]
        full = [random%between(0.70_dp, 0.78_dp), random%between(0.70_dp, 0.78_dp)]
        keel = bent(random, -12.0_dp, -0.35_dp, 0.05_dp)
        side = bent(random, 2.0_dp, 0.08_dp, -0.04_dp)
        beam = bent(random, 9.0_dp, 0.45_dp, -0.05_dp)
        angle = bent(random, random%between(84.0_dp, 96.0_dp), 0.05_dp, -0.05_dp)
        sketch%side(:, 1) = pieces(random, keel, corner)
        sketch%side(:, 2) = pieces(random, full(1)*keel + (1.0_dp - full(1))*side, corner)
        sketch%side(:, 3) = pieces(random, side, corner)
        sketch%plan(:, 2) = pieces(random, full(2)*beam, corner)
        sketch%plan(:, 3) = pieces(random, beam, corner)
        sketch%angle = pieces(random, angle, corner)
        sketch%keel = [1.0_dp, random%between(-0.1_dp, 0.1_dp)]
    end subroutine random_sketch

    !> An ordinate and three slopes that fall or rise from first to last.
    function bent(random, ordinate, first, last) result(numbers)
        type(random_type), intent(inout) :: random  !! the stream
        real(dp), intent(in) :: ordinate            !! at the first knot
        real(dp), intent(in) :: first, last         !! slopes
        real(dp) :: numbers(4), share
        share = random%between(0.3_dp, 0.7_dp)
        numbers = [ordinate*random%between(0.8_dp, 1.2_dp), first, &
            first + share*(last - first), last]
    end function bent

    !> Two conics with equal slopes where they meet; rho at random.
    function pieces(random, numbers, corner) result(conics)
        type(random_type), intent(inout) :: random  !! the stream
        real(dp), intent(in) :: numbers(4)          !! first ordinate, slopes at the knots
        real(dp), intent(in) :: corner(2)           !! where the tangents meet, share of the way
        type(conic_type) :: conics(2)
        real(dp) :: p1(2), p2(2), p3(2), rho
        integer :: i

        p1 = [knot(1), numbers(1)]
        do i = 1, 2
            p2 = p1 + corner(i)*(knot(i + 1) - knot(i))*[1.0_dp, numbers(i + 1)]
            p3 = p2 + (1.0_dp - corner(i))*(knot(i + 1) - knot(i))*[1.0_dp, numbers(i + 2)]
            rho = random%between(0.35_dp, 0.65_dp)
            conics(i) = conic_type(end_type(p1, p2 - p1), &
                rho*p2 + (1.0_dp - rho)*0.5_dp*(p1 + p3), end_type(p3, p3 - p2))
            p1 = p3
        end do
    end function pieces

    !> The body of a sketch in a guise.
    subroutine body_of(sketch, guise, body)
        type(sketch_type), intent(in) :: sketch !! its lines
        type(guise_type), intent(in) :: guise   !! how they are given
        type(body_type), intent(out) :: body    !! finished
        real(dp) :: of_axis(2, 3)
        integer :: i

        ! Factor and shift of each axis. SIDE PORT mirrors, so that the lines are not.
        of_axis = reshape([(guise%mirror(i)*guise%scale, guise%shift(i), i=1, 3)], [2, 3])
        if (guise%is_port) of_axis(1, 2) = abs(of_axis(1, 2))
        allocate (body%lines(4), body%sections(1))
        do i = 1, 3
            call set_view(guise, sketch%side(:, i), of_axis(:, [1, 3]), body%lines(i)%side)
            body%lines(i)%has_side = .true.
            if (i == 1) cycle
            call set_view(guise, sketch%plan(:, i), of_axis(:, [1, 2]), body%lines(i)%plan)
            body%lines(i)%has_plan = .true.
        end do
        of_axis(:, 3) = [product(sign(1.0_dp, of_axis(1, 2:))), 0.0_dp]
        call set_view(guise, sketch%angle, of_axis(:, [1, 3]), body%lines(4)%angle)
        body%lines(4)%has_angle = .true.
        do i = 1, 4
            call limit_line(body%lines(i))
        end do
        call set_section(sketch, guise, sign(1.0_dp, product(of_axis(1, 2:2)))* &
            guise%mirror(3), body%sections(1))
        call finish_body(body)
    end subroutine body_of

    !> The section of a sketch in a guise. Its shifted centre line has its own plan.
    subroutine set_section(sketch, guise, turned, section)
        type(sketch_type), intent(in) :: sketch         !! its lines
        type(guise_type), intent(in) :: guise           !! how they are given
        real(dp), intent(in) :: turned                  !! -1 where slopes change their sign
        type(section_type), intent(out) :: section      !! from -huge to huge

        section%line = [1, 2, 3]
        section%slope(1)%direction = sketch%keel*[1.0_dp, turned]
        section%slope(2)%is_angle = .true.
        section%slope(2)%line = 4
        section%from = -huge(1.0_dp)
        section%to = huge(1.0_dp)
        section%is_port = guise%is_port
        if (.not. guise%has_sections_reversed) return
        section%line = section%line([3, 2, 1])
        section%slope = section%slope([2, 1])
    end subroutine set_section

    !> One view of a line in a guise.
    subroutine set_view(guise, conics, of_axis, chain)
        type(guise_type), intent(in) :: guise           !! how it is given
        type(conic_type), intent(in) :: conics(2)       !! as sketched
        real(dp), intent(in) :: of_axis(2, 2)           !! factor and shift of x and of y
        type(chain_type), intent(out) :: chain          !! the view
        type(arc_type), allocatable :: arcs(:)
        type(error_type), allocatable :: error
        integer :: i

        allocate (arcs(0))
        do i = 1, 2
            if (guise%is_split) then
                arcs = [arcs, arc_of(half(conics(i), 1), of_axis, guise%has_lines_reversed), &
                    arc_of(half(conics(i), 2), of_axis, guise%has_lines_reversed)]
            else
                arcs = [arcs, arc_of(conics(i), of_axis, guise%has_lines_reversed)]
            end if
        end do
        if (guise%has_lines_reversed) arcs = arcs(size(arcs):1:-1)
        call new_chain(arcs, chain, error)
        if (allocated(error)) error stop 'the lines of a random body make no chain'
    end subroutine set_view

    !> The arc of a conic, moved, and from last to first if asked.
    function arc_of(conic, of_axis, is_reversed) result(arc)
        type(conic_type), intent(in) :: conic       !! as sketched
        real(dp), intent(in) :: of_axis(2, 2)       !! factor and shift of x and of y
        logical, intent(in) :: is_reversed          !! from last to first
        type(arc_type) :: arc
        type(conic_type) :: moved
        type(error_type), allocatable :: error

        moved%start = end_type(of_axis(1, :)*conic%start%point + of_axis(2, :), &
            of_axis(1, :)*conic%start%tangent)
        moved%shoulder = of_axis(1, :)*conic%shoulder + of_axis(2, :)
        moved%finish = end_type(of_axis(1, :)*conic%finish%point + of_axis(2, :), &
            of_axis(1, :)*conic%finish%tangent)
        if (is_reversed) then
            call arc_through(moved%finish, moved%shoulder, moved%start, arc, error)
        else
            call arc_through(moved%start, moved%shoulder, moved%finish, arc, error)
        end if
        if (allocated(error)) error stop 'a conic of a random body is none'
    end function arc_of

    !> A half of a conic, divided at its shoulder, as a conic of its own.
    function half(conic, number) result(part)
        type(conic_type), intent(in) :: conic   !! as sketched
        integer, intent(in) :: number           !! 1 or 2
        type(conic_type) :: part
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        type(end_type) :: middle

        call arc_through(conic%start, conic%shoulder, conic%finish, arc, error)
        if (allocated(error)) error stop 'a conic of a random body is none'
        middle = end_type(point(arc, at_shoulder), tangent(arc, at_shoulder))
        if (number == 1) then
            part = conic_type(conic%start, point(arc, place_at(0.27_dp)), middle)
        else
            part = conic_type(middle, point(arc, place_at(0.71_dp)), conic%finish)
        end if
    end function half

end module support_random_body
