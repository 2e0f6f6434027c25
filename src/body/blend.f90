!> The spirals of a line: BLEND cards between straight lines and circular arcs, which are cut off,
!> or lengthened, where the spiral begins and ends.
module body_blend
    use base_constants, only: degrees
    use base_error, only: cause, error_type, fail
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_body_card, only: blame
    use deck_job, only: piece, piece_real, piece_type
    use geom_arc, only: arc_type, reversed
    use geom_chain, only: chain_type, new_chain
    use geom_spiral, only: spiral_between
    use geom_stroke, only: conic_stroke, cyclic_stroke, stroke_kind, stroke_type
    use geom_track, only: arc_to
    implicit none (type, external)
    private

    public :: blend_strokes

    !> ALPHA where the card does not say it, degrees.
    real(dp), parameter :: usual_alpha = 60.0_dp

contains

    !> Makes the strokes of the BLEND cards of a view and fits their neighbours to them. What is
    !> wrong is said of the BLEND card, as `spiral_between` and `arc_to` say it.
    pure subroutine blend_strokes(pieces, strokes, faults)
        type(piece_type), intent(in) :: pieces(:)           !! no BLEND first, last or side by side
        type(stroke_type), intent(inout) :: strokes(:)      !! of the other cards, in one direction
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added
        type(error_type), allocatable :: error
        integer :: i

        do i = 2, size(pieces) - 1
            if (pieces(i)%kind /= piece%blend) cycle
            call blend(pieces(i), strokes(i - 1), strokes(i), strokes(i + 1), error)
            if (allocated(error)) call blame(pieces(i)%card, 1, error%message, faults)
            if (allocated(error)) return
        end do
    end subroutine blend_strokes

    !> Makes one spiral. Fails as `spiral_between`, `arc_to` and `new_chain`.
    pure subroutine blend(item, before, stroke, after, error)
        type(piece_type), intent(in) :: item                !! its card
        type(stroke_type), intent(inout) :: before          !! the stroke before it
        type(stroke_type), intent(inout) :: stroke          !! the spiral
        type(stroke_type), intent(inout) :: after           !! the stroke behind it
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: pole(2, 4), angle(2)
        type(chain_type) :: alone

        angle = piece_real(item, [1, 2])/degrees
        if (.not. angle(1) > 0.0_dp) angle(1) = usual_alpha/degrees
        if (any([before%kind, after%kind] /= stroke_kind%conic)) then
            call fail(error, cause%no_arc, 'a spiral joins straight lines and circular arcs; a '// &
                'card beside this one is neither')
            return
        end if
        call spiral_between(before%arc, after%arc, angle(1), angle(2), pole, error)
        if (allocated(error)) return
        stroke = cyclic_stroke(pole, angle(1))
        call new_chain([stroke], 0.0_dp, alone, error)
        if (.not. allocated(error)) call fit(before, pole(:, 1), .true., error)
        if (.not. allocated(error)) call fit(after, pole(:, 4), .false., error)
    end subroutine blend

    !> Lets a neighbour end where the spiral begins, or begin where it ends. Fails as `arc_to`, in
    !> words that tell which neighbour.
    pure subroutine fit(neighbour, point, is_before, error)
        type(stroke_type), intent(inout) :: neighbour       !! a line or an arc of a circle
        real(dp), intent(in) :: point(2)                    !! where it meets the spiral
        logical, intent(in) :: is_before                    !! the spiral is at its end
        type(error_type), allocatable, intent(out) :: error !! see above
        type(arc_type) :: arc

        if (is_before) then
            call arc_to(neighbour%arc, point, arc, error)
        else
            call arc_to(reversed(neighbour%arc), point, arc, error)
            arc = reversed(arc)
        end if
        if (allocated(error)) then
            error%message = 'the blend leaves nothing of the card '// &
                trim(merge('before it', 'behind it', is_before))//': '//error%message
        else
            neighbour = conic_stroke(arc)
        end if
    end subroutine fit

end module body_blend
