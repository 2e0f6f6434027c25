!> The skin of a body as surfaces that share their edges (`export_shell`), for IGES and STEP.
!>
!> Each section gives one face between two stations where anything of the body has a joint or an
!> end. Its surface is exact around the section and within the tolerance along the body. The sides
!> of such a face are four, in the order of its loop: its start line; then, where dS/du x dS/dv
!> points out of the body (`is_outward`), its aft end, its finish line and its fore end, else its
!> fore end, its finish line and its aft end. The edge of a line is the surface's own, with its
!> poles; so is that of an end, unless it is straight, then it is of degree 1. Where the section is
!> a point the side has no edge, and all poles of the surface there are that point.
!>
!> Skin of two sections is sewn where their ends are in one point all along (within `outline_gap`),
!> skin fore and aft of a station where both have the same arc there (within a quarter of the
!> tolerance), the halves of a symmetric body along BL 0. What begins in a point of other skin, as a
!> fairing does, hangs on its neighbours. An arc that goes on as two arcs is a step, not a seam.
!> What fits together nowhere is left open. Of a solid flat faces close the ends, also where the
!> skin steps: there the parts fore and aft are shells of their own. A body of one side that the
!> deck says to CLOSE gets walls along BL 0.
module export_shell_build
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_shell, only: skin_model_type
    use export_shell_caps, only: add_caps
    use export_shell_panels, only: mirrored_panel, panel_type, panels_of
    use export_shell_ribs, only: ribs_of, ribs_type, settle_forms
    use export_shell_rows, only: forms_of
    use export_shell_sew, only: sew
    use export_shell_stretch, only: stretch_type, stretches_of
    use export_shell_surfaces, only: fit_stretch, fitted_type
    implicit none (type, external)
    private

    public :: build_shell, scale_shell

contains

    !> Makes the skin of a body: both halves of a symmetric one.
    !>
    !> Fails with `cause%no_convergence` where the tolerance can't be kept (surfaces that are the
    !> skin itself keep any), and with `cause%no_arc` where a section nears no conic at an end.
    !> Parts of a body that have no conic are left out.
    pure subroutine build_shell(body, tolerance, wants_solid, model, error)
        type(body_type), intent(in) :: body                 !! finished
        real(dp), intent(in) :: tolerance                   !! of the skin, above zero, deck units
        logical, intent(in) :: wants_solid                  !! close what the deck says to close
        type(skin_model_type), intent(out) :: model         !! faces may be none
        type(error_type), allocatable, intent(out) :: error !! see above
        type(stretch_type), allocatable :: stretches(:)
        type(panel_type), allocatable :: panels(:), more(:)
        integer, allocatable :: forms(:)
        type(ribs_type) :: ribs
        type(fitted_type) :: fitted
        integer :: i

        call stretches_of(body, tolerance, &
            wants_solid .and. body%is_closed .and. .not. body%is_symmetric, stretches)
        call ribs_of(stretches, ribs, error)
        if (allocated(error)) return
        allocate (forms, source=forms_of(stretches, size(body%sections)))
        call settle_forms(stretches, ribs, forms)
        allocate (panels(0))
        do i = 1, size(stretches)
            call fit_stretch(stretches(i), ribs%ends(i), forms, tolerance, fitted, error)
            if (allocated(error)) return
            call panels_of(body, stretches(i), fitted, ribs, i, more)
            panels = [panels, more]
        end do
        if (body%is_symmetric) call add_port_half(panels)
        if (wants_solid) call add_caps(ribs%corner, body%is_closed, panels)
        call sew(ribs%corner, panels, model)
    end subroutine build_shell

    !> Adds the mirror images of all panels behind them, in the same order.
    pure subroutine add_port_half(panels)
        type(panel_type), allocatable, intent(inout) :: panels(:) !! of the starboard half
        type(panel_type), allocatable :: whole(:)
        integer :: i, n

        n = size(panels)
        allocate (whole(2*n))
        do i = 1, n
            whole(i) = panels(i)
            whole(n + i) = mirrored_panel(panels(i))
        end do
        call move_alloc(whole, panels)
    end subroutine add_port_half

    !> Brings a skin to another unit.
    pure subroutine scale_shell(model, factor)
        type(skin_model_type), intent(inout) :: model   !! of `build_shell`
        real(dp), intent(in) :: factor                  !! above zero
        integer :: i

        do i = 1, size(model%vertices)
            model%vertices(i)%at = factor*model%vertices(i)%at
        end do
        do i = 1, size(model%edges)
            model%edges(i)%curve%pole = factor*model%edges(i)%curve%pole
        end do
        do i = 1, size(model%faces)
            associate (face => model%faces(i))
                if (.not. face%is_flat) face%surface%pole = factor*face%surface%pole
                face%origin = factor*face%origin
                face%error = factor*face%error
                face%worst = factor*face%worst
            end associate
        end do
    end subroutine scale_shell

end module export_shell_build
