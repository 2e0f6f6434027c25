!> Bodies of closed form for the tests, made of control lines as a deck would give them.
module support_bodies
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type, finish_body
    use body_line, only: limit_line, line_type
    use body_section, only: end_slope_type, section_type
    use geom_arc, only: arc_through, arc_type, direction_of_slope, end_type, line_between
    use geom_chain, only: chain_type, constant_chain, new_chain
    implicit none (type, external)
    private

    public :: ellipsoid, tapered, nose_of_the_book, control_line, plain_section
    public :: half_ellipse, conic_view, straight_view, constant_view

    !> Directions of slope 0 and 999.999.
    real(dp), parameter, public :: level(2) = [1.0_dp, 0.0_dp], upright(2) = [0.0_dp, 1.0_dp]

contains

    !> The ellipsoid about (sta, 0, wl) with semi-axes along STA, BL, WL: upper and lower starboard
    !> quarters with shoulders at (.6, .8) of the way.
    function ellipsoid(axes, sta, wl) result(body)
        real(dp), intent(in) :: axes(3)
        real(dp), intent(in) :: sta, wl
        type(body_type) :: body
        type(chain_type) :: none
        allocate (body%lines(0), body%sections(0))
        associate (a => axes(1), b => axes(2), c => axes(3))
            body%lines = [ &
                control_line('LCL', half_ellipse(sta, a, wl, -c), none), &
                control_line('LSH', half_ellipse(sta, a, wl, -0.8_dp*c), &
                    half_ellipse(sta, a, 0.0_dp, 0.6_dp*b)), &
                control_line('MHB', constant_view(wl), half_ellipse(sta, a, 0.0_dp, b)), &
                control_line('USH', half_ellipse(sta, a, wl, 0.8_dp*c), &
                    half_ellipse(sta, a, 0.0_dp, 0.6_dp*b)), &
                control_line('UCL', half_ellipse(sta, a, wl, c), none)]
        end associate
        body%sections = [plain_section('LOWER', [1, 2, 3], level, upright), &
            plain_section('UPPER', [3, 4, 5], upright, level)]
        call finish_body(body)
    end function ellipsoid

    !> A body of round sections whose radius is given by a view: straight for a cone or cylinder, a
    !> parabola for a paraboloid. `scaled(k)` are views k times the radius, k = 1, .6, .8, -.8, -1.
    function tapered(radius, wide, high, low, bottom) result(body)
        type(chain_type), intent(in) :: radius, wide, high, low, bottom
        type(body_type) :: body
        type(chain_type) :: none
        allocate (body%lines(0), body%sections(0))
        body%lines = [control_line('LCL', bottom, none), control_line('LSH', low, wide), &
            control_line('MHB', constant_view(0.0_dp), radius), control_line('USH', high, wide), &
            control_line('UCL', radius, none)]
        body%sections = [plain_section('LOWER', [1, 2, 3], level, upright), &
            plain_section('UPPER', [3, 4, 5], upright, level)]
        call finish_body(body)
    end function tapered

    !> The nose of SAE 700202, table 1, with the slopes that were punched.
    function nose_of_the_book() result(body)
        type(body_type) :: body
        type(chain_type) :: none
        allocate (body%lines(0), body%sections(0))
        body%lines = [ &
            control_line('LCL', view(-10.0_dp, -0.384_dp, -18.0_dp, -24.1_dp, -0.0871_dp), none), &
            control_line('LSH', view(-10.0_dp, -0.268_dp, -16.0_dp, -21.2_dp, -0.0697_dp), &
                view(0.0_dp, 0.404_dp, 9.0_dp, 18.2_dp, 0.1316_dp)), &
            control_line('MHB', view(-10.0_dp, 0.114_dp, -7.1_dp, -4.0_dp, 0.0523_dp), &
                view(0.0_dp, 0.577_dp, 11.9_dp, 21.5_dp, 0.1405_dp))]
        body%sections = [plain_section('LOWER', [1, 2, 3], level, upright)]
        call finish_body(body)
    contains
        function view(y1, s1, y2, y3, s3)
            real(dp), intent(in) :: y1, s1, y2, y3, s3
            type(chain_type) :: view
            view = conic_view(end_type([-30.0_dp, y1], direction_of_slope(s1)), [0.0_dp, y2], &
                end_type([50.0_dp, y3], direction_of_slope(s3)))
        end function view
    end function nose_of_the_book

    !> A control line; a view that was never set up is not there.
    function control_line(name, side, plan) result(line)
        character(*), intent(in) :: name
        type(chain_type), intent(in) :: side, plan
        type(line_type) :: line
        line%name = name
        line%has_side = .true.
        line%side = side
        line%has_plan = plan%is_constant .or. allocated(plan%stroke)
        line%plan = plan
        call limit_line(line)
    end function control_line

    !> A section without limits of its own.
    function plain_section(name, lines, first, last) result(section)
        character(*), intent(in) :: name
        integer, intent(in) :: lines(3)
        real(dp), intent(in) :: first(2), last(2)
        type(section_type) :: section
        section%name = name
        section%line = lines
        section%slope = [end_slope_type(direction=first), end_slope_type(direction=last)]
        section%from = -huge(1.0_dp)
        section%to = huge(1.0_dp)
    end function plain_section

    !> Half an ellipse over 2 a, `rise` high in the middle.
    function half_ellipse(middle, a, base, rise) result(view)
        real(dp), intent(in) :: middle, a, base, rise
        type(chain_type) :: view
        view = conic_view(end_type([middle - a, base], upright), [middle, base + rise], &
            end_type([middle + a, base], upright))
    end function half_ellipse

    !> A view of one conic.
    function conic_view(first, shoulder, last) result(view)
        type(end_type), intent(in) :: first, last
        real(dp), intent(in) :: shoulder(2)
        type(chain_type) :: view
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        call arc_through(first, shoulder, last, arc, error)
        if (allocated(error)) error stop 'a view of a test is no arc'
        call new_chain([arc], view, error)
        if (allocated(error)) error stop 'a view of a test is no chain'
    end function conic_view

    !> A straight view.
    function straight_view(first, last) result(view)
        real(dp), intent(in) :: first(2), last(2)
        type(chain_type) :: view
        type(error_type), allocatable :: error
        call new_chain([line_between(first, last)], view, error)
        if (allocated(error)) error stop 'a view of a test is no chain'
    end function straight_view

    !> A view of one ordinate.
    function constant_view(value) result(view)
        real(dp), intent(in) :: value
        type(chain_type) :: view
        call constant_chain(value, view)
    end function constant_view

end module support_bodies
