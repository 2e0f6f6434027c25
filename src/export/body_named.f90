!> Curves that carry their name, as the lines of a chart do.
module export_body_named
    use base_kinds, only: dp
    use export_body_drawing, only: drawing_type, word_side
    implicit none (type, external)
    private

    public :: draw_named, along

    !> Parts of a curve where its name may stand, best first.
    real(dp), parameter :: name_places(15) = [0.5_dp, 0.4_dp, 0.6_dp, 0.3_dp, 0.7_dp, 0.2_dp, &
        0.8_dp, 0.45_dp, 0.55_dp, 0.35_dp, 0.65_dp, 0.25_dp, 0.75_dp, 0.15_dp, 0.85_dp]

contains

    !> Draws a curve with its name on it, where there is room for one.
    pure subroutine draw_named(style, at, name, drawing)
        character(*), intent(in) :: style               !! of the curve
        real(dp), intent(in) :: at(:, :)                !! its points by columns
        character(*), intent(in) :: name                !! or nothing
        type(drawing_type), intent(inout) :: drawing    !! gets it

        if (size(at, 2) < 2) return
        call drawing%draw(style, at)
        if (name == '') return
        call drawing%write_where_free(name, along(at, name_places), word_side%middle)
    end subroutine draw_named

    !> Points at parts of the length of a line of straight pieces.
    pure function along(at, parts) result(places)
        real(dp), intent(in) :: at(:, :)        !! two or more points by columns
        real(dp), intent(in) :: parts(:)        !! 0 to 1
        real(dp) :: places(2, size(parts)), length(size(at, 2)), wanted, part
        integer :: i, k

        length(1) = 0.0_dp
        do k = 2, size(at, 2)
            length(k) = length(k - 1) + norm2(at(:, k) - at(:, k - 1))
        end do
        do i = 1, size(parts)
            wanted = parts(i)*length(size(length))
            k = max(2, min(size(length), count(length < wanted) + 1))
            part = 0.0_dp
            if (length(k) > length(k - 1)) &
                part = (wanted - length(k - 1))/(length(k) - length(k - 1))
            places(:, i) = at(:, k - 1) + part*(at(:, k) - at(:, k - 1))
        end do
    end function along

end module export_body_named
