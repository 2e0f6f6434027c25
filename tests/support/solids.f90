!> Bodies with closed forms: a profile r over STA, taken so many times as half-breadth and as
!> height, with elliptic sections between, each in an upper and a lower quarter. The shoulder points
!> of the sections are at .6 of the half-breadth and .8 of the height, which are on the ellipse.
module support_solids
    use base_kinds, only: dp
    use base_error, only: error_type
    use body_body, only: body_type, finish_body
    use body_line, only: limit_line, line_type
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_chain, only: constant_chain, new_chain
    implicit none (type, external)
    private

    public :: conic_type, solid, ellipsoid, paraboloid, cone, cylinder, waist

    !> One arc of a profile.
    type :: conic_type
        real(dp) :: start(2) = 0.0_dp           !! STA and r
        real(dp) :: start_tangent(2) = 0.0_dp   !! there
        real(dp) :: shoulder(2) = 0.0_dp        !! STA and r
        real(dp) :: finish(2) = 0.0_dp          !! STA and r
        real(dp) :: finish_tangent(2) = 0.0_dp  !! there
    end type conic_type

    real(dp), parameter :: up(2) = [0.0_dp, 1.0_dp], level(2) = [1.0_dp, 0.0_dp]
    real(dp), parameter :: down(2) = [0.0_dp, -1.0_dp]

contains

    !> The body of a profile, symmetric and closed.
    type(body_type) function solid(profile, breadth, height, datum) result(body)
        type(conic_type), intent(in) :: profile(:)  !! arcs from fore to aft
        real(dp), intent(in) :: breadth             !! half-breadth over r
        real(dp), intent(in) :: height              !! half-height over r
        real(dp), intent(in) :: datum               !! WL of the axis

        allocate (body%lines(5), body%sections(2))
        body%lines(1) = line('TOP', 0.0_dp, height)
        body%lines(2) = line('USH', 0.6_dp*breadth, 0.8_dp*height)
        body%lines(3) = line('MHB', breadth, 0.0_dp)
        body%lines(4) = line('LSH', 0.6_dp*breadth, -0.8_dp*height)
        body%lines(5) = line('KEEL', 0.0_dp, -height)
        body%sections%name = ['UPPER   ', 'LOWER   ']
        body%sections(1)%line = [1, 2, 3]
        body%sections(2)%line = [3, 4, 5]
        body%sections(1)%slope(2)%direction = up
        body%sections(2)%slope(1)%direction = up
        body%sections%from = -huge(1.0_dp)
        body%sections%to = huge(1.0_dp)
        body%is_closed = .true.
        call finish_body(body)
    contains
        !> A line at so many times the profile.
        type(line_type) function line(name, bl, wl)
            character(*), intent(in) :: name
            real(dp), intent(in) :: bl, wl
            type(error_type), allocatable :: error
            line%name = name
            line%has_side = .true.
            line%has_plan = abs(bl) > 0.0_dp
            if (abs(wl) > 0.0_dp) then
                call new_chain(scaled(profile, wl, datum), line%side, error)
                if (allocated(error)) error stop 'no side'
            else
                call constant_chain(datum, line%side)
            end if
            if (line%has_plan) call new_chain(scaled(profile, bl, 0.0_dp), line%plan, error)
            if (allocated(error)) error stop 'no plan'
            call limit_line(line)
        end function line
    end function solid

    !> The arcs of a profile, r taken so many times and shifted.
    function scaled(profile, factor, shift) result(arcs)
        type(conic_type), intent(in) :: profile(:)
        real(dp), intent(in) :: factor, shift
        type(arc_type) :: arcs(size(profile))
        type(error_type), allocatable :: error
        real(dp) :: by(2), off(2)
        integer :: i
        by = [1.0_dp, factor]
        off = [0.0_dp, shift]
        do i = 1, size(profile)
            associate (p => profile(i))
                call arc_through(end_type(by*p%start + off, by*p%start_tangent), &
                    by*p%shoulder + off, end_type(by*p%finish + off, by*p%finish_tangent), &
                    arcs(i), error)
            end associate
            if (allocated(error)) error stop 'no arc'
        end do
    end function scaled

    !> An ellipsoid about station 0, waterline 0, in two halves.
    type(body_type) function ellipsoid(axes) result(body)
        real(dp), intent(in) :: axes(3) !! along STA, BL, WL
        real(dp) :: a
        a = axes(1)
        body = solid([conic_type([-a, 0.0_dp], up, [-0.6_dp*a, 0.8_dp], [0.0_dp, 1.0_dp], level), &
            conic_type([0.0_dp, 1.0_dp], level, [0.6_dp*a, 0.8_dp], [a, 0.0_dp], down)], &
            axes(2), axes(3), 0.0_dp)
    end function ellipsoid

    !> A paraboloid of revolution, r**2 = 2 R STA, from station 0.
    type(body_type) function paraboloid(radius, length) result(body)
        real(dp), intent(in) :: radius !! R at its nose
        real(dp), intent(in) :: length !! of the body
        real(dp) :: r
        r = sqrt(2.0_dp*radius*length)
        body = solid([conic_type([0.0_dp, 0.0_dp], up, [0.25_dp*length, 0.5_dp*r], [length, r], &
            [r, radius])], 1.0_dp, 1.0_dp, 0.0_dp)
    end function paraboloid

    !> A cone of revolution with its apex at station 0.
    type(body_type) function cone(radius, length, datum) result(body)
        real(dp), intent(in) :: radius !! of its base
        real(dp), intent(in) :: length !! from apex to base
        real(dp), intent(in) :: datum  !! WL of the axis
        body = solid([conic_type([0.0_dp, 0.0_dp], [length, radius], &
            [0.5_dp*length, 0.5_dp*radius], [length, radius], [length, radius])], 1.0_dp, 1.0_dp, &
            datum)
    end function cone

    !> A cylinder from station 0, open at both ends.
    type(body_type) function cylinder(radius, length) result(body)
        real(dp), intent(in) :: radius !! of its sections
        real(dp), intent(in) :: length !! along STA
        body = solid([conic_type([0.0_dp, radius], level, [0.5_dp*length, radius], &
            [length, radius], level)], 1.0_dp, 1.0_dp, 0.0_dp)
    end function cylinder

    !> A hyperboloid of revolution with its waist of radius 1 at station 0: r**2 = 1 + STA**2, from
    !> -3/4 to 3/4, where r is 5/4.
    type(body_type) function waist() result(body)
        body = solid([conic_type([-0.75_dp, 1.25_dp], [-1.25_dp, 0.75_dp], [0.0_dp, 1.0_dp], &
            [0.75_dp, 1.25_dp], [1.25_dp, 0.75_dp])], 1.0_dp, 1.0_dp, 0.0_dp)
    end function waist

end module support_solids
