!> Curves of closed form in a plane, as paths of a drawing.
module support_paths
    use base_kinds, only: dp
    use export_drawing_path, only: path_type
    implicit none (type, external)
    private

    public :: plane_path_type

    !> Which curve.
    type, public :: form_list
        integer :: ellipse = 1      !! about the origin, from one angle to another
        integer :: hyperbola = 2    !! x = a cosh t, y = b sinh t
        integer :: parabola = 3     !! y = b (x/a)**2
        integer :: cubic = 4        !! y = b (x/a)**3
        integer :: line = 5         !! unevenly run along
        integer :: step = 6         !! a parabola that jumps by b in the middle
        integer :: blunt = 7        !! an ellipse with still stands of its parameter at both ends
    end type form_list

    !> The curves by name.
    type(form_list), parameter, public :: form = form_list()

    !> A curve.
    type, extends(path_type) :: plane_path_type
        integer :: form = 1                     !! one of `form%...`
        real(dp) :: axes(2) = 1.0_dp            !! a and b
        real(dp) :: ends(2) = [0.0_dp, 1.0_dp]  !! of its parameter
        logical :: is_mute = .false.            !! gives no direction
    contains
        procedure :: at => path_at
        procedure :: way => path_way
    end type plane_path_type

contains

    !> A point.
    pure function path_at(f, t) result(point)
        class(plane_path_type), intent(in) :: f
        real(dp), intent(in) :: t
        real(dp) :: point(3), s
        s = f%ends(1) + (f%ends(2) - f%ends(1))*t
        point = 0.0_dp
        select case (f%form)
        case (form%ellipse)
            point(:2) = f%axes*[cos(s), sin(s)]
        case (form%hyperbola)
            point(:2) = f%axes*[cosh(s), sinh(s)]
        case (form%parabola)
            point(:2) = f%axes*[s, s**2]
        case (form%cubic)
            point(:2) = f%axes*[s, s**3]
        case (form%line)
            point(:2) = f%axes*(s + 0.3_dp*s**2)
        case (form%step)
            point(:2) = f%axes*[s, s**2 + merge(1.0_dp, 0.0_dp, t > 0.5_dp)]
        case default
            s = f%ends(1) + (f%ends(2) - f%ends(1))*t*t*(3.0_dp - 2.0_dp*t)
            point(:2) = f%axes*[cos(s), sin(s)]
        end select
    end function path_at

    !> A direction.
    pure function path_way(f, t) result(way)
        class(plane_path_type), intent(in) :: f
        real(dp), intent(in) :: t
        real(dp) :: way(3), s
        s = f%ends(1) + (f%ends(2) - f%ends(1))*t
        way = 0.0_dp
        if (f%is_mute) return
        select case (f%form)
        case (form%ellipse, form%blunt)
            if (f%form == form%blunt) &
                s = f%ends(1) + (f%ends(2) - f%ends(1))*t*t*(3.0_dp - 2.0_dp*t)
            way(:2) = f%axes*[-sin(s), cos(s)]
        case (form%hyperbola)
            way(:2) = f%axes*[sinh(s), cosh(s)]
        case (form%cubic)
            way(:2) = f%axes*[1.0_dp, 3.0_dp*s**2]
        case (form%line)
            way(:2) = f%axes
        case default
            way(:2) = f%axes*[1.0_dp, 2.0_dp*s]
        end select
        way = way*(f%ends(2) - f%ends(1))
    end function path_way

end module support_paths
