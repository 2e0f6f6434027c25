!> Bodies of decks with their skins as faces, and what is measured on these by other means than
!> those that made them: areas and volumes by Gauss's rule, distances by the implicit form of the
!> sections, loops and edges by counting.
module support_skins
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_build, only: build_body
    use body_ledger, only: joint_type
    use body_section, only: section_arc, section_type
    use body_surface, only: form_along, patch_at, patch_type
    use body_taylor, only: taylor_type
    use deck_job, only: job_type
    use export_shell, only: face_type, side_type, skin_model_type
    use export_shell_build, only: build_shell
    use export_shell_panels, only: panel_type, panels_of
    use export_shell_ribs, only: ribs_of, ribs_type
    use export_shell_rows, only: forms_of
    use export_shell_stretch, only: stretch_type, stretches_of
    use export_shell_surfaces, only: fit_stretch, fitted_type
    use geom_arc, only: arc_type
    use geom_bspline_basis, only: breaks_of
    use geom_bspline_surface, only: bspline_surface_type, surface_jet, surface_point
    use support_book, only: text_file
    use support_computed, only: job_of_text
    implicit none (type, external)
    private

    public :: deck_body, text_body, skin_of, take_panels, skin_area, skin_volume, furthest
    public :: form_distance
    public :: side_from, side_to, edge_uses, is_chained

    !> Gauss's rule of five points on -1..1 (M. Abramowitz and I. A. Stegun, "Handbook of
    !> Mathematical Functions", 1964, table 25.4).
    real(dp), parameter :: node(5) = [-0.906179845938664_dp, -0.538469310105683_dp, 0.0_dp, &
        0.538469310105683_dp, 0.906179845938664_dp]
    real(dp), parameter :: share(5) = [0.236926885056189_dp, 0.478628670499366_dp, &
        0.568888888888889_dp, 0.478628670499366_dp, 0.236926885056189_dp]
    !> Parts of a span.
    integer, parameter :: parts = 6

contains

    !> The first body of a deck of cards/.
    function deck_body(name) result(body)
        character(*), intent(in) :: name !! without its ending
        type(body_type) :: body
        body = text_body(text_file('cards/'//name//'.crd'))
    end function deck_body

    !> The first body of a deck.
    function text_body(text) result(body)
        character(*), intent(in) :: text !! a body deck
        type(body_type) :: body
        type(job_type) :: job
        type(fault_list_type) :: faults
        type(joint_type), allocatable :: joints(:)
        call job_of_text(text, job, faults)
        call build_body(job, 1, body, joints, faults)
    end function text_body

    !> The skin of a body, which must come out.
    function skin_of(body, tolerance, wants_solid) result(model)
        type(body_type), intent(in) :: body
        real(dp), intent(in) :: tolerance
        logical, intent(in) :: wants_solid
        type(skin_model_type) :: model
        type(error_type), allocatable :: error
        call build_shell(body, tolerance, wants_solid, model, error)
        if (allocated(error)) error stop 'a skin of a test failed'
    end function skin_of

    !> The panels of a body's sections, starboard, with the corners that they lead between.
    subroutine take_panels(body, panels, corners)
        type(body_type), intent(in) :: body
        type(panel_type), allocatable, intent(out) :: panels(:)
        real(dp), allocatable, intent(out) :: corners(:, :)
        type(stretch_type), allocatable :: stretches(:)
        type(panel_type), allocatable :: more(:)
        type(error_type), allocatable :: error
        type(fitted_type) :: fitted
        type(ribs_type) :: ribs
        integer :: i
        allocate (stretches(0), panels(0))
        call stretches_of(body, 1.0e-3_dp, .false., stretches)
        call ribs_of(stretches, ribs, error)
        do i = 1, size(stretches)
            call fit_stretch(stretches(i), ribs%ends(i), forms_of(stretches, &
                size(body%sections)), 1.0e-3_dp, fitted, error)
            if (allocated(error)) error stop 'a stretch of a test failed'
            call panels_of(body, stretches(i), fitted, ribs, i, more)
            panels = [panels, more]
        end do
        corners = ribs%corner
    end subroutine take_panels

    !> The area of all faces that are not flat.
    real(dp) function skin_area(model)
        type(skin_model_type), intent(in) :: model
        real(dp) :: sums(2)
        sums = sums_of(model)
        skin_area = sums(1)
    end function skin_area

    !> The volume within closed shells whose flat faces are across STA or in BL 0: there the field
    !> (0, BL, 0) does not pass.
    real(dp) function skin_volume(model)
        type(skin_model_type), intent(in) :: model
        real(dp) :: sums(2)
        sums = sums_of(model)
        skin_volume = sums(2)
    end function skin_volume

    !> Integrals of 1 and of BL times the outward normal's BL over all surfaces.
    function sums_of(model) result(sums)
        type(skin_model_type), intent(in) :: model
        real(dp) :: sums(2)
        integer :: i
        sums = 0.0_dp
        do i = 1, size(model%faces)
            if (model%faces(i)%is_flat) cycle
            sums = sums + merge([1.0_dp, 1.0_dp], [1.0_dp, -1.0_dp], model%faces(i)%is_outward)* &
                sums_over(model%faces(i)%surface)
        end do
    end function sums_of

    !> The same over one surface, its own normal taken as outward.
    function sums_over(surface) result(sums)
        type(bspline_surface_type), intent(in) :: surface
        real(dp) :: sums(2), p(3), du(3), dv(3), n(3), scale
        real(dp), allocatable :: u(:), v(:), u_share(:), v_share(:)
        integer :: i, k
        call rule(breaks_of(surface%u_knot), u, u_share)
        call rule(breaks_of(surface%v_knot), v, v_share)
        sums = 0.0_dp
        do k = 1, size(v)
            do i = 1, size(u)
                call surface_jet(surface, u(i), v(k), p, du, dv)
                n = cshift(du, 1)*cshift(dv, 2) - cshift(du, 2)*cshift(dv, 1)
                scale = u_share(i)*v_share(k)
                sums = sums + scale*[norm2(n), p(2)*n(2)]
            end do
        end do
    end function sums_over

    !> The places and shares of the rule over some spans.
    subroutine rule(breaks, at, shares)
        real(dp), intent(in) :: breaks(:)
        real(dp), allocatable, intent(out) :: at(:), shares(:)
        real(dp) :: half, middle
        integer :: i, k
        allocate (at(0), shares(0))
        do i = 2, size(breaks)
            half = 0.5_dp*(breaks(i) - breaks(i - 1))/real(parts, dp)
            do k = 1, parts
                middle = breaks(i - 1) + half*real(2*k - 1, dp)
                at = [at, middle + half*node]
                shares = [shares, half*share]
            end do
        end do
    end subroutine rule

    !> The largest distance of the starboard surfaces from the skin, at places of their own.
    real(dp) function furthest(body, model, places) result(distance)
        type(body_type), intent(in) :: body
        type(skin_model_type), intent(in) :: model
        integer, intent(in) :: places !! of a span, and around
        real(dp), allocatable :: breaks(:)
        real(dp) :: u, v
        integer :: i, j, k, m
        distance = 0.0_dp
        do i = 1, size(model%faces)
            associate (face => model%faces(i))
                if (face%is_flat .or. face%is_port) cycle
                if (allocated(breaks)) deallocate (breaks)
                allocate (breaks, source=breaks_of(face%surface%u_knot))
                do j = 2, size(breaks)
                    do k = 1, places
                        u = breaks(j - 1) + (breaks(j) - breaks(j - 1))*real(k, dp)/ &
                            real(places + 1, dp)
                        do m = 1, places
                            v = real(m, dp)/real(places + 1, dp)
                            distance = max(distance, form_distance(body, section_of(body, face), &
                                surface_point(face%surface, u, v)))
                        end do
                    end do
                end do
            end associate
        end do
    end function furthest

    !> The section of a face.
    function section_of(body, face) result(section)
        type(body_type), intent(in) :: body
        type(face_type), intent(in) :: face
        type(section_type) :: section
        section = body%sections(findloc(body%sections%name == face%section, .true., dim=1))
    end function section_of

    !> The distance of a point from the surface of a section, to first order: F/|grad F|.
    real(dp) function form_distance(body, section, p) result(distance)
        type(body_type), intent(in) :: body
        type(section_type), intent(in) :: section
        real(dp), intent(in) :: p(3)
        type(error_type), allocatable :: error
        type(patch_type) :: patch
        type(taylor_type) :: form
        type(arc_type) :: arc
        real(dp) :: gradient(3), way(3)
        integer :: axis
        call section_arc(body%lines, section, p(1), arc, error)
        if (allocated(error)) error stop 'a section of a test has no arc'
        patch = patch_at(body%lines, section, p(1), arc)
        do axis = 1, 3
            way = 0.0_dp
            way(axis) = 1.0_dp
            form = form_along(patch, p(2:), way)
            gradient(axis) = form%first
        end do
        distance = abs(form%value)/norm2(gradient)
    end function form_distance

    !> The vertex where a side begins, as the loop runs.
    integer function side_from(model, side) result(vertex)
        type(skin_model_type), intent(in) :: model
        type(side_type), intent(in) :: side
        vertex = side%vertex
        if (side%edge == 0) return
        vertex = model%edges(side%edge)%from
        if (.not. side%is_forward) vertex = model%edges(side%edge)%to
    end function side_from

    !> The vertex where it ends.
    integer function side_to(model, side) result(vertex)
        type(skin_model_type), intent(in) :: model
        type(side_type), intent(in) :: side
        type(side_type) :: back
        back = side
        back%is_forward = .not. side%is_forward
        vertex = side_from(model, back)
    end function side_to

    !> How often each edge is used backwards and forwards: shape (2, edges).
    function edge_uses(model) result(uses)
        type(skin_model_type), intent(in) :: model
        integer :: uses(2, size(model%edges))
        integer :: i, k
        uses = 0
        do i = 1, size(model%faces)
            do k = 1, size(model%faces(i)%sides)
                associate (side => model%faces(i)%sides(k))
                    if (side%edge == 0) cycle
                    uses(merge(2, 1, side%is_forward), side%edge) = 1 + &
                        uses(merge(2, 1, side%is_forward), side%edge)
                end associate
            end do
        end do
    end function edge_uses

    !> True where each side of each face begins where the one before ends.
    logical function is_chained(model)
        type(skin_model_type), intent(in) :: model
        integer :: i, k, n
        is_chained = .true.
        do i = 1, size(model%faces)
            n = size(model%faces(i)%sides)
            do k = 1, n
                is_chained = is_chained .and. side_to(model, model%faces(i)%sides(k)) == &
                    side_from(model, model%faces(i)%sides(mod(k, n) + 1))
            end do
        end do
    end function is_chained

end module support_skins
