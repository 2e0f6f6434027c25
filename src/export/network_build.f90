!> Networks of a body: one for each section, or one for each ring of sections over the stations
!> where its sections are the same.
module export_network_build
    use base_digits, only: shortest
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_text, only: to_text
    use body_body, only: body_type
    use cut_measure_ring, only: link_type, rings_at
    use export_mesh_plan, only: plan_type
    use export_network, only: network_type, networks_type
    use export_network_layout, only: facing_left, lay_out, layout_type, network_along
    use export_settings, only: settings_type
    implicit none (type, external)
    private

    public :: build_networks

contains

    !> Builds the networks of a body, in deck units: rings around the body, both halves of a
    !> symmetric one, or sections of one half. Contours are at the stations given and where lines
    !> begin, join or end; without stations at those that keep the tolerance.
    !>
    !> Fails with `cause%usage` where tolerance or angle is not above zero, with
    !> `cause%no_convergence` where there is no skin, and as `lay_out`.
    pure subroutine build_networks(body, stations, settings, is_by_rings, networks, error)
        type(body_type), intent(in) :: body                 !! finished
        real(dp), intent(in) :: stations(:)                 !! deck units, in any order; may be none
        type(settings_type), intent(in) :: settings         !! angle, and tolerance in deck units
        logical, intent(in) :: is_by_rings                  !! rings, else sections
        type(networks_type), intent(out) :: networks        !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(layout_type) :: layout

        allocate (networks%list(0))
        if (.not. (settings%tolerance > 0.0_dp .and. settings%angle > 0.0_dp)) then
            call fail(error, cause%usage, 'tolerance and angle must be above zero')
            return
        end if
        networks%is_by_deck = size(stations) > 0
        call lay_out(body, stations, settings, layout, error)
        if (allocated(error)) return
        if (is_by_rings) then
            call add_rings(body, layout, networks%list, error)
        else
            call add_sections(body, layout, networks%list)
        end if
        if (size(networks%list) == 0 .and. .not. allocated(error)) &
            call fail(error, cause%no_convergence, 'the body has no skin to lay contours on')
    end subroutine build_networks

    !> Adds a network for each section.
    pure subroutine add_sections(body, layout, list)
        type(body_type), intent(in) :: body                         !! finished
        type(layout_type), intent(in) :: layout                     !! of it
        type(network_type), allocatable, intent(inout) :: list(:)   !! gets them
        type(network_type) :: network
        integer :: i, run, first, last

        do i = 1, size(body%sections)
            first = 0
            last = 0
            do run = 1, size(layout%plan%runs)
                if (all(layout%plan%runs(run)%stretch%sections /= i)) cycle
                if (first == 0) first = run
                last = run
            end do
            if (first == 0) cycle
            network = network_along(layout, facing_left(body, [i]), [first, last])
            network%name = trim(body%sections(i)%name)
            if (body%sections(i)%is_port) network%name = network%name//'_P'
            network%is_half = body%is_symmetric
            list = [list, network]
        end do
    end subroutine add_sections

    !> Adds a network for each ring of sections, for all runs with the same sections. Fails as
    !> `section_arc`.
    pure subroutine add_rings(body, layout, list, error)
        type(body_type), intent(in) :: body                         !! finished
        type(layout_type), intent(in) :: layout                     !! of it
        type(network_type), allocatable, intent(inout) :: list(:)   !! gets them
        type(error_type), allocatable, intent(out) :: error         !! see above
        type(link_type), allocatable :: links(:)
        type(network_type) :: network
        integer :: first, last, k

        first = 1
        do while (first <= size(layout%plan%runs))
            last = last_alike(layout%plan, first)
            associate (stretch => layout%plan%runs(first)%stretch)
                call rings_at(body, 0.5_dp*(stretch%from + stretch%to), links, error)
            end associate
            if (allocated(error)) return
            do k = 1, maxval([0, links%ring])
                network = network_along(layout, &
                    facing_left(body, path_of(pack(links, links%ring == k))), [first, last])
                network%name = ring_name(body, layout%plan, k, first, last)
                if (body%is_closed .and. .not. body%is_symmetric) &
                    call close_centre(network%points)
                call add_whole(body%is_symmetric, network, list)
            end do
            first = last + 1
        end do
    end subroutine add_rings

    !> The last run, from one on, with the same sections.
    pure integer function last_alike(plan, first) result(last)
        type(plan_type), intent(in) :: plan !! any
        integer, intent(in) :: first        !! number of a run
        last = first
        do while (last < size(plan%runs))
            associate (here => plan%runs(first)%stretch%sections, &
                next => plan%runs(last + 1)%stretch%sections)
                if (size(next) /= size(here)) return
                if (any(next /= here)) return
            end associate
            last = last + 1
        end do
    end function last_alike

    !> The sections of a ring in order, negative where run through against their own way.
    pure function path_of(ring) result(path)
        type(link_type), intent(in) :: ring(:)  !! in order
        integer :: path(size(ring))
        path = merge(-ring%section, ring%section, ring%is_turned)
    end function path_of

    !> The name of a ring: that of the body, its number, and where it is if it is not all.
    pure function ring_name(body, plan, number, first, last) result(name)
        type(body_type), intent(in) :: body !! finished
        type(plan_type), intent(in) :: plan !! its runs
        integer, intent(in) :: number       !! of the ring
        integer, intent(in) :: first        !! its first run
        integer, intent(in) :: last         !! its last run
        character(:), allocatable :: name
        integer :: i

        name = trim(body%name)
        if (len(name) == 0) name = 'BODY'
        if (number > 1) name = name//'_'//to_text(number)
        if (first > 1 .or. last < size(plan%runs)) name = name//'_STA_'// &
            shortest(plan%runs(first)%stretch%from)//'_TO_'// &
            shortest(plan%runs(last)%stretch%to)
        do i = 1, len(name)
            if (name(i:i) == ' ') name(i:i) = '_'
        end do
    end function ring_name

    !> Adds the first point again where contours begin and end in BL 0 and do not meet.
    pure subroutine close_centre(points)
        real(dp), allocatable, intent(inout) :: points(:, :, :) !! gets a point in each contour
        real(dp), allocatable :: closed(:, :, :)
        integer :: last

        last = size(points, 2)
        if (.not. all(is_zero(points(2, 1, :)) .and. is_zero(points(2, last, :)))) return
        if (all(is_zero(points(3, 1, :) - points(3, last, :)))) return
        call join(points, points(:, :1, :), closed)
        call move_alloc(closed, points)
    end subroutine close_centre

    !> Adds a network to a list; of a symmetric body with its mirror image: in one where it begins
    !> or ends at BL 0, else as two.
    pure subroutine add_whole(is_symmetric, network, list)
        logical, intent(in) :: is_symmetric                         !! there is a mirror image
        type(network_type), intent(in) :: network                   !! as its sections are
        type(network_type), allocatable, intent(inout) :: list(:)   !! gets it
        type(network_type) :: whole
        real(dp) :: image(3, size(network%points, 2), size(network%points, 3))
        integer :: last

        whole = network
        if (is_symmetric) then
            last = size(image, 2)
            image = network%points(:, last:1:-1, :)
            image(2, :, :) = 0.0_dp - image(2, :, :)
            if (all(is_zero(image(2, 1, :)))) then
                call join(network%points, image(:, 2:, :), whole%points)
            else if (all(is_zero(image(2, last, :)))) then
                call join(image(:, :last - 1, :), network%points, whole%points)
            else
                list = [list, whole]
                whole%name = whole%name//'_P'
                whole%points = image
            end if
        end if
        list = [list, whole]
    end subroutine add_whole

    !> Contours with those of another network behind them.
    pure subroutine join(first, second, joined)
        real(dp), intent(in) :: first(:, :, :)                  !! points
        real(dp), intent(in) :: second(:, :, :)                 !! points, in as many contours
        real(dp), allocatable, intent(out) :: joined(:, :, :)   !! both
        allocate (joined(3, size(first, 2) + size(second, 2), size(first, 3)))
        joined(:, :size(first, 2), :) = first
        joined(:, size(first, 2) + 1:, :) = second
    end subroutine join

end module export_network_build
