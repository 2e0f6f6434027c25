!> A slope as text, where it may be vertical.
module report_slope
    use base_kinds, only: i64
    use geom_arc_point, only: slope_type
    use base_digits, only: shortest
    use base_shortest, only: shortest_length
    implicit none (type, external)
    private

    public :: slope_text

contains

    !> A slope in the fewest figures that read back the same, or `inf`.
    pure function slope_text(slope) result(text)
        type(slope_type), intent(in) :: slope !! dy/dx
        character(int(merge(3, shortest_length(slope%value), slope%is_vertical), i64)) :: text
        text = 'inf'
        if (.not. slope%is_vertical) text = shortest(slope%value)
    end function slope_text

end module report_slope
