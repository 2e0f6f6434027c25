!> Bodies of two elliptic cylinders end to end, for meshes of runs whose sections differ: the fore
!> one from station 0 to 50, the aft one to 100.
module support_cylinders
    use base_kinds, only: dp
    use body_body, only: body_type, finish_body
    use body_line, only: line_type
    use body_section, only: end_slope_type, section_type
    use geom_chain, only: chain_type
    use support_bodies, only: constant_view, control_line, level, plain_section, upright
    implicit none (type, external)
    private

    public :: cylinders, split_cylinder, add_quarters

contains

    !> Two cylinders about BL 0 (starboard quarters), or about another butt line (all quarters).
    function cylinders(fore, aft, centre) result(body)
        real(dp), intent(in) :: fore(2), aft(2) !! half breadth and half height
        real(dp), intent(in) :: centre          !! BL
        type(body_type) :: body
        allocate (body%lines(0), body%sections(0))
        body%is_closed = .true.
        call add_quarters(body, 'F', fore, centre, [0.0_dp, 50.0_dp])
        call add_quarters(body, 'A', aft, centre, [50.0_dp, 100.0_dp])
        call finish_body(body)
    end function cylinders

    !> A circular cylinder of radius 50 whose upper quarter goes on as two sections.
    function split_cylinder() result(body)
        type(body_type) :: body
        real(dp), parameter :: radius = 50.0_dp
        integer :: n
        allocate (body%lines(0), body%sections(0))
        body%is_closed = .true.
        call add_quarters(body, 'F', [radius, radius], 0.0_dp, [0.0_dp, 50.0_dp])
        body%sections(1)%to = 100.0_dp
        n = size(body%lines)
        body%lines = [body%lines, &
            control_line('MID', constant_view(40.0_dp), constant_view(30.0_dp)), &
            control_line('SHA', constant_view(radius*3.0_dp/sqrt(10.0_dp)), &
            constant_view(radius/sqrt(10.0_dp))), &
            control_line('SHB', constant_view(radius/sqrt(5.0_dp)), &
            constant_view(radius*2.0_dp/sqrt(5.0_dp)))]
        body%sections = [body%sections, &
            quarter('UPA', [2, n + 2, n + 1], level, [1.0_dp, -0.75_dp], [50.0_dp, 100.0_dp]), &
            quarter('UPB', [n + 1, n + 3, 3], [1.0_dp, -0.75_dp], upright, [50.0_dp, 100.0_dp])]
        call finish_body(body)
    end function split_cylinder

    !> Adds the lower and the upper starboard quarter of a cylinder, and where its centre is not BL
    !> 0 the inner ones. The lines are lower, upper; side, lower shoulder, upper shoulder.
    subroutine add_quarters(body, letter, axes, centre, range)
        type(body_type), intent(inout) :: body
        character, intent(in) :: letter
        real(dp), intent(in) :: axes(2), centre, range(2)
        integer :: n, side
        real(dp) :: shoulder(2), breadth
        shoulder = [0.6_dp, 0.8_dp]*axes
        n = size(body%lines)
        body%lines = [body%lines, line('L', -axes(2), centre), line('U', axes(2), centre)]
        do side = 0, merge(1, 0, abs(centre) > 0.0_dp)
            breadth = 1.0_dp - 2.0_dp*real(side, dp)
            body%lines = [body%lines, line('S', 0.0_dp, centre + breadth*axes(1)), &
                line('M', -shoulder(2), centre + breadth*shoulder(1)), &
                line('N', shoulder(2), centre + breadth*shoulder(1))]
            body%sections = [body%sections, quarter('LO'//letter, &
                n + [1, 4 + 3*side, 3 + 3*side], level, upright, range), &
                quarter('UP'//letter, n + [2, 5 + 3*side, 3 + 3*side], level, upright, range)]
        end do
    end subroutine add_quarters

    !> A line at one WL and BL.
    function line(name, wl, bl)
        character(*), intent(in) :: name
        real(dp), intent(in) :: wl, bl
        type(line_type) :: line
        type(chain_type) :: side, plan
        side = constant_view(wl)
        plan = constant_view(bl)
        line = control_line(name, side, plan)
    end function line

    !> A section with a range.
    function quarter(name, lines, first, last, range) result(section)
        character(*), intent(in) :: name
        integer, intent(in) :: lines(3)
        real(dp), intent(in) :: first(2), last(2), range(2)
        type(section_type) :: section
        section = plain_section(name, lines, first, last)
        section%slope = [end_slope_type(direction=first), end_slope_type(direction=last)]
        section%from = range(1)
        section%to = range(2)
    end function quarter

end module support_cylinders
