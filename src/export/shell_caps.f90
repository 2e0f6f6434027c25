!> Flat caps: where the skin of a closed body begins, ends, or is other fore of a station than aft
!> of it, a plane face closes each side.
!>
!> The ribs at a station that hang together are looked at together. Where each belongs to two faces
!> they are sewn as they are. Else each side on which what is left over makes loops gets a cap in
!> each loop, and fore and aft get edges of their own; where it does not, nothing is capped.
module export_shell_caps
    use base_kinds, only: dp
    use base_exact, only: is_zero
    use export_shell_panels, only: bond_type, operator(==), panel_type, station_words
    use geom_bspline, only: spline_from, spline_point, spline_to
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: add_caps, bond_corners

    !> A rib where a face has it.
    type :: use_type
        integer :: panel = 0            !! of which panel
        integer :: bond = 0             !! which of its bonds
        integer :: corner(2) = 0        !! the loop runs from here to there; see `bond_corners`
        integer :: cluster = 0          !! those that hang together have one number
    end type use_type

    !> Points of a rib for the area of a loop.
    integer, parameter :: points = 16

contains

    !> Adds caps to the panels of a body, and parts the ribs where they stand.
    pure subroutine add_caps(corners, is_closed, panels)
        real(dp), intent(in) :: corners(:, :)                       !! of `ribs_type`
        logical, intent(in) :: is_closed                            !! loops may lead over BL 0 from
                                                                    !! one half to the other
        type(panel_type), allocatable, intent(inout) :: panels(:)   !! of both halves
        type(use_type), allocatable :: uses(:), cluster(:)
        type(panel_type), allocatable :: caps(:), more(:)
        integer :: i, end

        allocate (uses(0))
        uses = uses_of(corners, panels)
        call find_clusters(uses)
        do i = 1, maxval([0, uses%cluster])
            cluster = pack(uses, uses%cluster == i)
            if (all(partners(panels, cluster) == 1)) cycle
            if (leads_over(panels, cluster) .and. .not. is_closed) cycle
            allocate (caps(0))
            do end = 1, 2
                call caps_of(corners, panels, cluster, end, more)
                caps = [caps, more]
            end do
            if (size(caps) > 0) call part_ribs(cluster, panels)
            panels = [panels, caps]
            deallocate (caps)
        end do
    end subroutine add_caps

    !> All ribs of all panels.
    pure function uses_of(corners, panels) result(uses)
        real(dp), intent(in) :: corners(:, :)       !! of `ribs_type`
        type(panel_type), intent(in) :: panels(:)   !! of both halves
        type(use_type), allocatable :: uses(:)
        integer :: i, k

        allocate (uses(0))
        do i = 1, size(panels)
            do k = 1, size(panels(i)%bonds)
                associate (bond => panels(i)%bonds(k))
                    if (bond%end == 0 .or. .not. allocated(bond%curve%pole)) cycle
                    uses = [uses, use_type(i, k, bond_corners(bond, corners))]
                end associate
            end do
        end do
    end function uses_of

    !> The corners that a loop runs from and to along a bond; those of the port half, but for those
    !> at BL 0, have the sign changed.
    pure function bond_corners(bond, corners) result(ends)
        type(bond_type), intent(in) :: bond     !! of a panel
        real(dp), intent(in) :: corners(:, :)   !! of `ribs_type`
        integer :: ends(2)
        ends = bond%corner
        if (.not. bond%is_forward) ends = ends([2, 1])
        if (bond%is_port) ends = merge(ends, -ends, is_zero(corners(2, ends)))
    end function bond_corners

    !> Gives ribs that share corners one number.
    pure subroutine find_clusters(uses)
        type(use_type), intent(inout) :: uses(:) !! all
        integer :: i, k, old, number

        uses%cluster = [(i, i=1, size(uses))]
        do i = 1, size(uses)
            do k = 1, i - 1
                if (uses(k)%cluster == uses(i)%cluster) cycle
                if (.not. shares(uses(i)%corner, uses(k)%corner)) cycle
                old = uses(i)%cluster
                number = uses(k)%cluster
                where (uses%cluster == old) uses%cluster = number
            end do
        end do
        number = 0
        do i = 1, size(uses)
            if (.not. any(uses%cluster == i)) cycle
            number = number + 1
            where (uses%cluster == i) uses%cluster = number
        end do
    contains
        !> True where two pairs have a corner in common.
        pure logical function shares(first, second)
            integer, intent(in) :: first(2)     !! corners
            integer, intent(in) :: second(2)    !! corners
            shares = any(first == second(1)) .or. any(first == second(2))
        end function shares
    end subroutine find_clusters

    !> True where some ribs are of both halves.
    pure logical function leads_over(panels, uses)
        type(panel_type), intent(in) :: panels(:)   !! of both halves
        type(use_type), intent(in) :: uses(:)       !! some of their ribs
        leads_over = any(panels(uses%panel)%face%is_port) .and. &
            .not. all(panels(uses%panel)%face%is_port)
    end function leads_over

    !> With how many of some ribs each can be sewn: the same curve, run through the other way. A
    !> curve that is there a third time has no partner.
    pure function partners(panels, uses) result(number)
        type(panel_type), intent(in) :: panels(:)   !! of both halves
        type(use_type), intent(in) :: uses(:)       !! some of their ribs
        integer :: number(size(uses))
        integer :: i, k

        number = 0
        do i = 1, size(uses)
            associate (one => panels(uses(i)%panel)%bonds(uses(i)%bond))
                do k = 1, size(uses)
                    associate (other => panels(uses(k)%panel)%bonds(uses(k)%bond))
                        if (i == k .or. .not. one%key == other%key) cycle
                        number(i) = number(i) + merge(1, 2, one%is_forward .neqv. other%is_forward)
                    end associate
                end do
            end associate
        end do
    end function partners

    !> The caps of one side of ribs that hang together; none where not all of them are in loops.
    pure subroutine caps_of(corners, panels, cluster, end, caps)
        real(dp), intent(in) :: corners(:, :)                   !! of `ribs_type`
        type(panel_type), intent(in) :: panels(:)               !! of both halves
        type(use_type), intent(in) :: cluster(:)                !! the ribs
        integer, intent(in) :: end                              !! of faces that begin there (1) or
                                                                !! end there (2)
        type(panel_type), allocatable, intent(out) :: caps(:)   !! theirs
        type(use_type), allocatable :: rest(:)
        integer, allocatable :: loop(:)
        type(panel_type) :: cap
        integer :: i

        allocate (caps(0))
        rest = pack(cluster, [(panels(cluster(i)%panel)%bonds(cluster(i)%bond)%end == end, &
            i=1, size(cluster))])
        rest = pack(rest, partners(panels, rest) /= 1)
        do while (size(rest) > 0)
            call find_loop(rest, loop)
            if (size(loop) == 0) exit
            cap = cap_of(panels, rest(loop), corners)
            if (.not. faces_out(cap, end)) exit
            caps = [caps, cap]
            rest = pack(rest, [(all(loop /= i), i=1, size(rest))])
        end do
        if (size(rest) > 0) caps = caps(:0)
    end subroutine caps_of

    !> The first rib with those that follow, against the way of their faces, till it is reached
    !> again; none where this is not so, or where the way parts.
    pure subroutine find_loop(rest, loop)
        type(use_type), intent(in) :: rest(:)               !! one or more
        integer, allocatable, intent(out) :: loop(:)        !! places in it
        integer :: next, i, last

        loop = [1]
        do
            last = loop(size(loop))
            if (rest(last)%corner(1) == rest(1)%corner(2)) return
            next = findloc(rest%corner(2), rest(last)%corner(1), dim=1)
            i = count(rest%corner(2) == rest(last)%corner(1))
            if (i /= 1 .or. any(loop == next)) exit
            loop = [loop, next]
        end do
        loop = [integer :: ]
    end subroutine find_loop

    !> The cap in a loop of ribs.
    pure type(panel_type) function cap_of(panels, loop, corners) result(cap)
        type(panel_type), intent(in) :: panels(:)   !! of both halves
        type(use_type), intent(in) :: loop(:)       !! ribs, in order
        real(dp), intent(in) :: corners(:, :)       !! of `ribs_type`
        integer :: i

        allocate (cap%bonds(size(loop)))
        do i = 1, size(loop)
            cap%bonds(i) = panels(loop(i)%panel)%bonds(loop(i)%bond)
            cap%bonds(i)%is_forward = .not. cap%bonds(i)%is_forward
            cap%bonds(i)%key%side = cap%bonds(i)%end
        end do
        cap%face%origin = corners(:, abs(loop(1)%corner(1)))
        if (loop(1)%corner(1) < 0) cap%face%origin(2) = 0.0_dp - cap%face%origin(2)
        cap%face%normal = [merge(-1.0_dp, 1.0_dp, cap%bonds(1)%end == 1), 0.0_dp, 0.0_dp]
        cap%face%name = 'CAP STA '//station_words(cap%face%origin(1))
        cap%face%section = ''
        cap%face%is_flat = .true.
        cap%face%is_exact = .true.
    end function cap_of

    !> True where the loop of a cap runs counter-clockwise, seen from outside.
    pure logical function faces_out(cap, end)
        type(panel_type), intent(in) :: cap !! with its bonds
        integer, intent(in) :: end          !! 1: forward is outside, 2: aft
        real(dp) :: area, here(3), next(3), t
        integer :: i, k

        area = 0.0_dp
        do i = 1, size(cap%bonds)
            associate (bond => cap%bonds(i))
                do k = 0, points
                    t = real(merge(k, points - k, bond%is_forward), dp)/real(points, dp)
                    next = spline_point(bond%curve, spline_from(bond%curve) + t* &
                        (spline_to(bond%curve) - spline_from(bond%curve)))
                    if (k > 0) area = area + cross(here(2:) - cap%face%origin(2:), &
                        next(2:) - cap%face%origin(2:))
                    here = next
                end do
            end associate
        end do
        faces_out = merge(-area, area, end == 1) > 0.0_dp
    end function faces_out

    !> Gives ribs that hang together a curve fore and one aft.
    pure subroutine part_ribs(cluster, panels)
        type(use_type), intent(in) :: cluster(:)            !! the ribs
        type(panel_type), intent(inout) :: panels(:)        !! of both halves
        integer :: i
        do i = 1, size(cluster)
            associate (bond => panels(cluster(i)%panel)%bonds(cluster(i)%bond))
                bond%key%side = bond%end
            end associate
        end do
    end subroutine part_ribs

end module export_shell_caps
