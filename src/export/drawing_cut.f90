!> The shape of a cut: its outlines and the inside of its skin as curves.
!>
!> The arcs of a station, and whatever else is one arc of a conic, are exact; other curves are
!> fitted within a tolerance. The curves of a contour run as the outline does, each of them smooth,
!> and meet in the same numbers.
module export_drawing_cut
    use base_error, only: error_type
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_tolerances, only: agreement_tolerance
    use body_body, only: body_type, mirrored_body
    use cut_outline, only: cut_type, outline_type
    use cut_plane, only: cut_kind, plane_type
    use export_drawing, only: contour_type, shape_type
    use export_drawing_fit, only: arc_curve, flat_curve
    use export_drawing_inside, only: draw_inside
    use export_drawing_join, only: join, last_point, put_in_space, seat_ends
    use export_drawing_marks, only: add_marks
    use export_drawing_name, only: cut_name, cut_title
    use export_drawing_outside, only: way_round, way_round_type
    implicit none (type, external)
    private

    public :: draw_cut

contains

    !> The shape of a cut: each of its outlines, followed by the inside opposite to it. The `number`
    !> is left to the caller, and so is that its name is unlike others (`make_unique`).
    !>
    !> Fails with `cause%no_convergence` where a curve can't be fitted or measured.
    pure subroutine draw_cut(body, cut, tolerance, bevel_step, shape, error)
        type(body_type), intent(in) :: body                 !! finished
        type(cut_type), intent(in) :: cut                   !! of it, by `make_cut`
        real(dp), intent(in) :: tolerance                   !! of fitted curves, deck units
        real(dp), intent(in) :: bevel_step                  !! from mark to mark; 0: no marks
        type(shape_type), intent(out) :: shape              !! see above
        type(error_type), allocatable, intent(out) :: error !! see above
        type(body_type) :: whole
        type(contour_type), allocatable :: inside(:)
        type(way_round_type) :: round
        type(contour_type) :: contour
        logical :: meets(2)
        integer :: i, k

        call describe(body, cut, shape)
        whole = mirrored_body(body)
        do i = 1, size(cut%outlines)
            call way_round(whole, cut%plane, cut%outlines(i), round)
            round%is_half = shape%is_half
            call draw_outline(cut, round, cut%outlines(i), tolerance, contour, error)
            if (allocated(error)) return
            if (shape%is_half) call seat_ends(cut%plane, contour, meets)
            if (bevel_step > 0.0_dp) call add_marks(whole, cut, round, bevel_step, contour, error)
            if (allocated(error)) return
            call append(shape%contours, contour)
            if (size(cut%inside) == 0) cycle
            call draw_inside(whole, cut, round, tolerance, inside, error)
            if (allocated(error)) return
            do k = 1, size(inside)
                if (shape%is_half) call seat_ends(cut%plane, inside(k), meets)
                call append(shape%contours, inside(k))
            end do
        end do
        if (allocated(cut%patched)) call draw_patched(cut, shape)
        if (size(shape%contours) > 0) shape%is_half = shape%is_half .and. &
            any(shape%contours%has_image)
    end subroutine draw_cut

    !> Draws the outlines on patches; each is one curve. The bevels of patches are not marked.
    pure subroutine draw_patched(cut, shape)
        type(cut_type), intent(in) :: cut           !! of a body with patches
        type(shape_type), intent(inout) :: shape    !! gets a contour for each
        type(contour_type) :: contour
        integer :: i

        do i = 1, size(cut%patched)
            contour%is_closed = cut%patched(i)%is_closed
            contour%has_image = cut%curves(i)%has_image
            if (allocated(contour%curves)) deallocate (contour%curves, contour%marks)
            allocate (contour%curves(1), contour%marks(0))
            contour%curves(1)%spline = cut%curves(i)%spline
            contour%curves(1)%is_exact = cut%curves(i)%is_exact
            contour%curves(1)%error = cut%curves(i)%error
            contour%curves(1)%worst = cut%curves(i)%worst
            contour%curves(1)%section = ''
            call append(shape%contours, contour)
        end do
    end subroutine draw_patched

    !> What is said of a shape, all but its contours.
    pure subroutine describe(body, cut, shape)
        type(body_type), intent(in) :: body         !! finished
        type(cut_type), intent(in) :: cut           !! of it
        type(shape_type), intent(inout) :: shape    !! gets it; and no contours

        shape%name = trim(cut_name(cut))
        shape%title = trim(cut_title(cut))
        shape%kind = cut%plane%kind
        shape%plane = cut%plane
        shape%skin = cut%skin
        shape%arcs = cut%arcs
        shape%is_flange_forward = cut%is_flange_forward
        shape%is_half = body%is_symmetric .and. is_zero(cut%plane%normal(2))
        shape%quantity = 1
        if (body%is_symmetric .and. .not. is_own_image(cut%plane)) shape%quantity = 2
        allocate (shape%contours(0))
    end subroutine describe

    !> True for a plane that is its own mirror image in BL 0: one across it, or BL 0 itself.
    pure logical function is_own_image(plane)
        type(plane_type), intent(in) :: plane !! any
        is_own_image = is_zero(plane%normal(2)) .or. (is_zero(plane%normal(1)) &
            .and. is_zero(plane%normal(3)) .and. is_zero(plane%through(2)))
    end function is_own_image

    !> The curves of an outline, end to end. Fails as `flat_curve`.
    pure subroutine draw_outline(cut, round, outline, tolerance, contour, error)
        type(cut_type), intent(in) :: cut                   !! the plane
        type(way_round_type), intent(in) :: round           !! the outline as paths
        type(outline_type), intent(in) :: outline           !! the same with its points
        real(dp), intent(in) :: tolerance                   !! of fitted curves, deck units
        type(contour_type), intent(out) :: contour          !! in space
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i, count

        count = size(round%path)
        contour%is_closed = round%is_closed
        allocate (contour%curves(count), contour%marks(0))
        if (count == 0 .and. size(outline%points) > 0) contour%at = outline%points(1)%at
        do i = 1, count
            associate (path => round%path(i), curve => contour%curves(i))
                if (path%is_arc) then
                    curve = arc_curve(path%arc)
                else
                    call flat_curve(path, round%noise, tolerance, curve, error)
                    if (allocated(error)) return
                end if
                curve%section = path%name
            end associate
        end do
        do i = 1, count
            if (i == count .and. .not. round%is_closed) cycle
            call join(last_point(contour%curves(i)), max(round%noise, agreement_tolerance), &
                contour%curves(mod(i, count) + 1))
        end do
        do i = 1, count
            call put_in_space(cut%plane, contour%curves(i))
        end do
    end subroutine draw_outline

    !> Puts a contour behind others.
    pure subroutine append(contours, contour)
        type(contour_type), allocatable, intent(inout) :: contours(:)   !! get it
        type(contour_type), intent(in) :: contour                       !! another
        type(contour_type), allocatable :: more(:)

        allocate (more(size(contours) + 1))
        more(:size(contours)) = contours
        more(size(more)) = contour
        call move_alloc(more, contours)
    end subroutine append

end module export_drawing_cut
