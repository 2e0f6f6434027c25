!> What the axes of the true shape of a cut are called.
module export_axis
    use export_drawing, only: shape_kind
    implicit none (type, external)
    private

    public :: axis_names

contains

    !> The names of u, to the right, and v, upwards: STA, BL and WL where an axis is one of these; U
    !> and V are lengths from the origin of a plane that is none.
    pure function axis_names(kind) result(names)
        integer, intent(in) :: kind !! one of `shape_kind%...`
        character(3) :: names(2)

        select case (kind)
        case (shape_kind%station)
            names = ['BL ', 'WL ']
        case (shape_kind%buttock, shape_kind%line)
            names = ['STA', 'WL ']
        case (shape_kind%waterline)
            names = ['STA', 'BL ']
        case (shape_kind%oblique)
            names = ['BL ', 'V  ']
        case (shape_kind%card)
            names = ['X  ', 'Y  ']
        case default
            names = ['U  ', 'V  ']
        end select
    end function axis_names

end module export_axis
