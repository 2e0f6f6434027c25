!> The reference lines of a part: where the planes of stations, butt lines and waterlines cut its
!> plane. Of the three families two are drawn, those that vary most in the plane; at round
!> ordinates, from edge to edge of the part.
module export_pattern_grid
    use base_kinds, only: dp
    use base_order, only: ascending
    use cut_plane, only: plane_type
    use export_drawing, only: shape_kind
    use export_pattern_number, only: ordinate
    use export_pattern_part, only: part_type
    implicit none (type, external)
    private

    public :: family_type, families_of, axis_name, name_of, chords_of, round_step

    !> Which ordinate a family is of.
    integer, parameter :: sta = 1, bl = 2, wl = 3

    !> Parallel lines, each at one ordinate: gradient . (u, v) = ordinate - base.
    type :: family_type
        integer :: axis = 0                     !! 1: STA, 2: BL, 3: WL
        logical :: is_card = .false.            !! of a card of 1970: x and y
        real(dp) :: gradient(2) = 0.0_dp        !! ordinate along u and v
        real(dp) :: base = 0.0_dp               !! ordinate at u = v = 0, units of the drawing
        real(dp) :: step = 1.0_dp               !! from line to line, units of the drawing
        integer :: first = 0                    !! the first line is at first*step
        integer :: last = -1                    !! the last line is at last*step
    end type family_type

    !> How many steps the part has at least, and the shortest one on paper, in.
    real(dp), parameter :: least_steps = 3.5_dp, shortest_step = 0.25_dp
    !> By how much an ordinate must vary more than another to be taken before it.
    real(dp), parameter :: margin = 1.0e-6_dp
    !> A line less inclined to the upright, by its sine, runs upwards, any other to the right.
    real(dp), parameter :: leaning = 0.5_dp
    !> Gradients whose sine is less are parallel.
    real(dp), parameter :: parallel = 0.3_dp

contains

    !> The two families of lines to draw on a part.
    pure function families_of(plane, kind, part) result(families)
        type(plane_type), intent(in) :: plane   !! of the shape
        integer, intent(in) :: kind             !! of the shape: one of `shape_kind%...`
        type(part_type), intent(in) :: part     !! with its outlines
        type(family_type) :: families(2)
        real(dp) :: gradient(2, 3), size(3)
        integer :: k, axis(2)

        do k = 1, 3
            gradient(:, k) = [plane%u(k), plane%v(k)]
            size(k) = norm2(gradient(:, k))
        end do
        axis(1) = steepest(size)
        do k = 1, 3
            if (sine(gradient(:, axis(1)), gradient(:, k)) < parallel) size(k) = 0.0_dp
        end do
        axis(2) = steepest(size)
        do k = 1, 2
            families(k)%axis = axis(k)
            families(k)%is_card = kind == shape_kind%card
            families(k)%gradient = gradient(:, axis(k))
            families(k)%base = plane%origin(axis(k))
            call choose_step(part, families(k))
        end do
    end function families_of

    !> The axis of the largest gradient; of equal ones BL first, then WL, then STA.
    pure integer function steepest(size) result(axis)
        real(dp), intent(in) :: size(3) !! of the gradients

        axis = bl
        if (size(wl) > size(axis) + margin) axis = wl
        if (size(sta) > size(axis) + margin) axis = sta
    end function steepest

    !> The sine of the angle between two gradients; 0 where one of them is zero.
    pure real(dp) function sine(first, second)
        real(dp), intent(in) :: first(2)    !! not zero
        real(dp), intent(in) :: second(2)   !! any
        sine = 0.0_dp
        if (norm2(second) < margin) return
        sine = abs(first(1)*second(2) - first(2)*second(1))/(norm2(first)*norm2(second))
    end function sine

    !> Chooses the step of a family, and its lines within the part, but for its very edges; of a
    !> half the fold is among them.
    pure subroutine choose_step(part, family)
        type(part_type), intent(in) :: part         !! with its outlines
        type(family_type), intent(inout) :: family  !! gets them
        real(dp) :: corners(4), low, high
        real(dp), parameter :: at_edge = 1.0e-6_dp

        associate (box => part%box, g => family%gradient/part%inch)
            corners = [g(1)*box(1) + g(2)*box(2), g(1)*box(3) + g(2)*box(2), &
                g(1)*box(1) + g(2)*box(4), g(1)*box(3) + g(2)*box(4)]
        end associate
        low = family%base + minval(corners)
        high = family%base + maxval(corners)
        family%step = round_step(max((high - low)/least_steps, &
            shortest_step*norm2(family%gradient)/part%inch))
        family%first = ceiling(low/family%step + at_edge)
        family%last = max(family%first - 1, floor(high/family%step - at_edge))
        if (part%fold > 0 .and. family%axis == bl) then
            family%first = min(family%first, 0)
            family%last = max(family%last, 0)
        end if
    end subroutine choose_step

    !> The largest of 1, 2 and 5 with a power of ten that is not above a length.
    pure real(dp) function round_step(length) result(step)
        real(dp), intent(in) :: length !! above zero
        integer :: power
        real(dp) :: whole
        real(dp), parameter :: nearly = 1.0e-9_dp

        power = floor(log10(length) + nearly)
        whole = (1.0_dp + nearly)*length/10.0_dp**power
        step = 1.0_dp
        if (whole >= 2.0_dp) step = 2.0_dp
        if (whole >= 5.0_dp) step = 5.0_dp
        if (power < 0) then
            step = step/10.0_dp**(-power)
        else
            step = step*10.0_dp**power
        end if
    end function round_step

    !> What the ordinate of a family is called: `STA`, `BL`, `WL`; of a card `X` or `Y`.
    pure function axis_name(family) result(name)
        type(family_type), intent(in) :: family !! any
        character(:), allocatable :: name
        character(3), parameter :: names(3) = ['STA', 'BL ', 'WL ']
        name = trim(names(family%axis))
        if (family%is_card) name = merge('X', 'Y', family%axis == sta)
    end function axis_name

    !> What a line is called: `WL 12.5`, `BL 5 STBD`, `X 20`.
    pure function name_of(family, number) result(name)
        type(family_type), intent(in) :: family     !! the line is one of these
        integer, intent(in) :: number               !! at number*step
        character(:), allocatable :: name
        real(dp) :: value

        value = real(number, dp)*family%step
        if (family%axis == bl) value = abs(value)
        name = axis_name(family)//' '//ordinate(value)
        if (family%axis /= bl) return
        if (number > 0) name = name//' STBD'
        if (number < 0) name = name//' PORT'
    end function name_of

    !> The stretches of a line that lie on the part, from edge to edge. The line runs to the right,
    !> or upwards; distances are measured along it from its point nearest to u = v = 0.
    !>
    !> Of a part whose outlines do not close it is the stretch from its first crossing to its last;
    !> to the open side of the part, or across all of it, where there are fewer than two.
    pure subroutine chords_of(part, family, number, along, foot, chords)
        type(part_type), intent(in) :: part                 !! with its outlines
        type(family_type), intent(in) :: family             !! the line is one of these
        integer, intent(in) :: number                       !! at number*step
        real(dp), intent(out) :: along(2)                   !! unit vector
        real(dp), intent(out) :: foot(2)                    !! its nearest point, in
        real(dp), allocatable, intent(out) :: chords(:, :)  !! from and to by columns, in
        real(dp), allocatable :: at(:)
        real(dp) :: across(2), ends(2)
        integer :: i

        associate (g => family%gradient)
            across = g/norm2(g)
            foot = across*part%inch*(real(number, dp)*family%step - family%base)/norm2(g)
        end associate
        along = [across(2), -across(1)]
        if (along(merge(2, 1, abs(along(1)) < leaning)) < 0.0_dp) along = -along
        call find_crossings(part, along, foot, part%is_region, at)
        if (part%is_region) then
            chords = reshape(at(:size(at)/2*2), [2, size(at)/2])
            return
        end if
        ends = [minval([(reach(part, along, foot, i), i=1, 4)]), &
            maxval([(reach(part, along, foot, i), i=1, 4)])]
        if (size(at) > 1) ends = [at(1), at(size(at))]
        if (size(at) == 1) &
            ends(merge(1, 2, is_open_ahead(part, along, foot, at(1)))) = at(1)
        chords = reshape(ends, [2, 1])
    end subroutine chords_of

    !> True where the open side of a part is ahead of the only crossing of a line: where the line
    !> crosses the chord from an end of the outline to the other.
    pure logical function is_open_ahead(part, along, foot, crossing) result(is_ahead)
        type(part_type), intent(in) :: part     !! its outlines do not close
        real(dp), intent(in) :: along(2)        !! of the line
        real(dp), intent(in) :: foot(2)         !! of the line
        real(dp), intent(in) :: crossing        !! distance along it
        real(dp), allocatable :: at(:)

        call find_crossings(part, along, foot, .true., at)
        is_ahead = .true.
        if (size(at) > 1) is_ahead = 0.5_dp*(at(1) + at(size(at))) > crossing
    end function is_open_ahead

    !> Where along a line a corner of the part's box is.
    pure real(dp) function reach(part, along, foot, corner)
        type(part_type), intent(in) :: part     !! with its outlines
        real(dp), intent(in) :: along(2)        !! of the line
        real(dp), intent(in) :: foot(2)         !! of the line
        integer, intent(in) :: corner           !! 1 to 4
        reach = dot_product(along, [part%box(merge(1, 3, corner <= 2)), &
            part%box(merge(2, 4, mod(corner, 2) == 0))] - foot)
    end function reach

    !> Where a line crosses the outlines, and the fold where they do not close along it; in order.
    pure subroutine find_crossings(part, along, foot, has_chords, at)
        type(part_type), intent(in) :: part             !! with its outlines
        real(dp), intent(in) :: along(2)                !! of the line
        real(dp), intent(in) :: foot(2)                 !! of the line
        logical, intent(in) :: has_chords               !! outlines are closed by their chords
        real(dp), allocatable, intent(out) :: at(:)     !! distances along it
        real(dp) :: across(2), before, after, s
        integer :: i, k, next, last

        across = [-along(2), along(1)]
        allocate (at(0))
        do i = 1, size(part%traces)
            if (part%traces(i)%is_inside) cycle
            associate (p => part%traces(i)%flat)
                last = size(p, 2)
                if (.not. has_chords) last = last - 1
                do k = 1, last
                    next = mod(k, size(p, 2)) + 1
                    before = dot_product(across, p(:, k) - foot)
                    after = dot_product(across, p(:, next) - foot)
                    if (before >= 0.0_dp .eqv. after >= 0.0_dp) cycle
                    s = before/(before - after)
                    at = [at, dot_product(along, p(:, k) + s*(p(:, next) - p(:, k)) - foot)]
                end do
            end associate
        end do
        if (part%fold > 0 .and. .not. part%is_region) then
            if (abs(along(part%fold)) > leaning) &
                at = [at, (part%fold_at - foot(part%fold))/along(part%fold)]
        end if
        at = ascending(at)
    end subroutine find_crossings

end module export_pattern_grid
