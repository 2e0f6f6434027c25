!> Shapes for pictures of a body: cuts with points as close as the eye can tell, panels with their
!> images.
module app_plot_shape
    use api_computed_body, only: computed_body_type
    use app_plan_cuts, only: closely
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_panel, only: mirrored_panel, panel_type
    use cut_outline, only: cut_type
    use cut_panel, only: cut_skin
    use cut_plane, only: plane_type
    use cut_request, only: request_type
    use export_body_lines, only: find_corners
    implicit none (type, external)
    private

    public :: add_images, shape_of, is_same

contains

    !> Adds the panels of a body, with their images where it is symmetric.
    pure subroutine add_images(computed, panels)
        type(computed_body_type), intent(in) :: computed            !! the body
        type(panel_type), allocatable, intent(inout) :: panels(:)   !! gets them
        type(panel_type) :: panel
        integer :: i

        do i = 1, size(computed%panels)
            panel = computed%panels(i)
            panels = [panels, panel]
            if (.not. (computed%body%is_symmetric .and. panel%has_image)) cycle
            panel = mirrored_panel(panel)
            panels = [panels, panel]
        end do
    end subroutine add_images

    !> A cut with points as close as the eye can tell; the cut itself where that can't be.
    pure type(cut_type) function shape_of(computed, request, cut) result(shape)
        type(computed_body_type), intent(in) :: computed    !! the body
        type(request_type), intent(in) :: request           !! what was asked
        type(cut_type), intent(in) :: cut                   !! what came out
        type(error_type), allocatable :: error
        type(cut_type) :: none(0)
        real(dp) :: low(3), high(3)

        if (size(computed%body%sections) > 0) then
            call find_corners([computed%body], none, low, high)
        else
            call find_hull(computed%panels, low, high)
        end if
        call cut_skin(computed%body, computed%panels, closely(request, maxval(high - low)), &
            shape, error)
        if (allocated(error)) shape = cut
    end function shape_of

    !> The corners of the room that panels take: that of their poles.
    pure subroutine find_hull(panels, low, high)
        type(panel_type), intent(in) :: panels(:)   !! one or more
        real(dp), intent(out) :: low(3)             !! least STA, BL and WL, deck units
        real(dp), intent(out) :: high(3)            !! greatest, deck units
        integer :: i, axis

        low = huge(1.0_dp)
        high = -huge(1.0_dp)
        do i = 1, size(panels)
            do axis = 1, 3
                low(axis) = min(low(axis), minval(panels(i)%surface%pole(axis, :, :)))
                high(axis) = max(high(axis), maxval(panels(i)%surface%pole(axis, :, :)))
            end do
        end do
    end subroutine find_hull

    !> True where two planes are one.
    pure logical function is_same(first, second)
        type(plane_type), intent(in) :: first   !! a plane
        type(plane_type), intent(in) :: second  !! another
        is_same = first%kind == second%kind .and. &
            all(abs(first%through - second%through) <= 0.0_dp) .and. &
            all(abs(first%normal - second%normal) <= 0.0_dp)
    end function is_same

end module app_plot_shape
