!> The inside of the skin of a cut as contours: parted where it has corners or gaps.
module export_drawing_inside
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_tolerances, only: agreement_ulps, ulp
    use body_body, only: body_type
    use cut_outline, only: cut_type
    use export_drawing, only: contour_type, curve_type
    use export_drawing_fit, only: flat_curve
    use export_drawing_join, only: gap_between, join, last_point, put_in_space
    use export_drawing_mitre, only: mitre, mitre_image, side_type
    use export_drawing_opposite, only: is_patch_opposite, new_opposite, nowhere, opposite_type, &
        patch_opposite
    use export_drawing_outside, only: way_round_type
    implicit none (type, external)
    private

    public :: draw_inside

    !> Curves as they come.
    type :: list_type
        type(curve_type), allocatable :: curve(:)   !! in u and v
        integer :: count = 0                        !! how many there are
    end type list_type

    !> Stretches of a path between which it is looked where the inside is.
    integer, parameter :: steps = 24
    !> Halvings that find where a patch ends.
    integer, parameter :: halvings = 40
    !> More patches than one path has: what goes on so is noise.
    integer, parameter :: most_patches = 100
    !> How far on both sides of the end of a patch it is looked for a corner, in parts of the path;
    !> and the angle that is one, radians.
    real(dp), parameter :: beside = 1.0e-9_dp, corner = 1.0e-6_dp
    !> The gap between two curves of the inside that is closed, in parts of the tolerance: their own
    !> errors leave so much of it.
    real(dp), parameter :: closed_gap = 0.04_dp

contains

    !> The inside opposite to an outline, as one contour or, where it has gaps, more.
    !>
    !> Fails as `flat_curve`.
    pure subroutine draw_inside(whole, cut, round, tolerance, contours, error)
        type(body_type), intent(in) :: whole                            !! finished, both halves
        type(cut_type), intent(in) :: cut                               !! plane and thickness
        type(way_round_type), intent(in) :: round                       !! the outline
        real(dp), intent(in) :: tolerance                               !! deck units
        type(contour_type), allocatable, intent(out) :: contours(:)     !! of the inside
        type(error_type), allocatable, intent(out) :: error             !! see above
        type(side_type) :: side(size(round%path))
        type(list_type) :: list
        integer :: i, next

        allocate (list%curve(8))
        do i = 1, size(side)
            call new_opposite(whole, cut%plane, cut%skin, round%path(i), side(i)%path)
            call find_patches(side(i)%path, side(i)%from)
        end do
        do i = 1, size(side)
            next = mod(i, size(side)) + 1
            if (next == i .or. (next == 1 .and. .not. round%is_closed)) cycle
            call mitre(side(i), side(next), round%noise)
        end do
        if (round%is_half .and. .not. round%is_closed) then
            call mitre_image(side(1), .false., round%noise)
            call mitre_image(side(size(side)), .true., round%noise)
        end if
        do i = 1, size(side)
            call draw_patches(side(i)%path, side(i)%from, [round%noise, tolerance], list, error)
            if (allocated(error)) return
        end do
        call make_contours(cut, list, max(round%noise, closed_gap*tolerance), round, contours)
    end subroutine draw_inside

    !> Draws the inside of a path: patches that go on smoothly as one curve, unless only curves of
    !> each can be fitted. Fails as `flat_curve`.
    pure subroutine draw_patches(inside, from, limits, list, error)
        type(opposite_type), intent(in) :: inside           !! with patches
        real(dp), intent(in) :: from(:)                     !! where each patch begins
        real(dp), intent(in) :: limits(2)                   !! noise and tolerance, deck units
        type(list_type), intent(inout) :: list              !! gets the curves
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: first, last, i

        first = 1
        do while (first <= size(from))
            last = first
            if (inside%patch(first) /= nowhere) then
                do while (goes_on(inside, last, limits(1)))
                    last = last + 1
                end do
                call draw_part(inside, from(first), [first, last], limits, list, error)
                if (allocated(error) .and. last > first) then
                    do i = first, last
                        call draw_part(inside, from(i), [i, i], limits, list, error)
                        if (allocated(error)) return
                    end do
                end if
                if (allocated(error)) return
            end if
            first = last + 1
        end do
    end subroutine draw_patches

    !> Draws a part of the inside of a path, unless it is nothing. Fails as `flat_curve`.
    pure subroutine draw_part(inside, from, patches, limits, list, error)
        type(opposite_type), intent(in) :: inside           !! with patches
        real(dp), intent(in) :: from                        !! parameter of the outside
        integer, intent(in) :: patches(2)                   !! first and last of the part
        real(dp), intent(in) :: limits(2)                   !! noise and tolerance, deck units
        type(list_type), intent(inout) :: list              !! gets the curve
        type(error_type), allocatable, intent(out) :: error !! see above
        type(opposite_type) :: part
        type(curve_type) :: curve

        if (inside%until(patches(2)) - from <= 2.0_dp*beside) return
        part = inside
        part%from = from
        part%to = inside%until(patches(2))
        part%patch = inside%patch(patches(1):patches(2))
        part%until = inside%until(patches(1):patches(2))
        call flat_curve(part, limits(1), limits(2), curve, error)
        if (allocated(error)) then
            error%message = 'inside of the skin: '//error%message
            return
        end if
        curve%section = inside%outside%name
        call add(list, curve)
    end subroutine draw_part

    !> True where a patch goes on smoothly as the next.
    pure logical function goes_on(inside, i, noise)
        type(opposite_type), intent(in) :: inside   !! with patches
        integer, intent(in) :: i                    !! a patch
        real(dp), intent(in) :: noise               !! distance that is but rounding, deck units
        real(dp) :: way(3, 2), apart(3), s

        goes_on = .false.
        if (i == size(inside%patch)) return
        if (inside%patch(i + 1) == nowhere) return
        s = inside%until(i)
        apart = inside%at(s + beside) - inside%at(s - beside)
        way(:, 1) = inside%way(s - beside)
        way(:, 2) = inside%way(s + beside)
        way(:, 1) = way(:, 1)/norm2(way(:, 1))
        way(:, 2) = way(:, 2)/norm2(way(:, 2))
        goes_on = norm2(way(:, 2) - way(:, 1)) <= corner &
            .and. abs(dot_product(apart, [-way(2, 1), way(1, 1), 0.0_dp])) <= noise
    end function goes_on

    !> Adds a curve behind others.
    pure subroutine add(list, curve)
        type(list_type), intent(inout) :: list  !! gets it
        type(curve_type), intent(in) :: curve   !! another
        type(curve_type), allocatable :: more(:)

        if (list%count == size(list%curve)) then
            allocate (more(2*list%count))
            more(:list%count) = list%curve
            call move_alloc(more, list%curve)
        end if
        list%count = list%count + 1
        list%curve(list%count) = curve
    end subroutine add

    !> Puts curves end to end where they meet. Where all of a closed outline do, the contour is
    !> closed; else the first contour begins where one does.
    pure subroutine make_contours(cut, list, reach, round, contours)
        type(cut_type), intent(in) :: cut                               !! the plane
        type(list_type), intent(inout) :: list                          !! in order along it
        real(dp), intent(in) :: reach                                   !! of ends that meet
        type(way_round_type), intent(in) :: round                       !! the outline
        type(contour_type), allocatable, intent(out) :: contours(:)     !! in space
        logical :: meets(list%count)
        integer :: i, k, next, first, many

        many = list%count
        do i = 1, many
            next = mod(i, many) + 1
            meets(i) = gap_between(list%curve(i), list%curve(next)) <= reach
            if (next == 1) meets(i) = meets(i) .and. round%is_closed
            if (meets(i)) call join(last_point(list%curve(i)), round%noise, list%curve(next))
        end do
        do i = 1, many
            call put_in_space(cut%plane, list%curve(i))
        end do
        allocate (contours(max(min(1, many), count(.not. meets))))
        first = 1 + findloc(meets, .false., dim=1)
        do i = 1, size(contours)
            next = 1
            do while (next < many .and. meets(mod(first + next - 2, many) + 1))
                next = next + 1
            end do
            contours(i)%is_inside = .true.
            contours(i)%is_closed = all(meets)
            allocate (contours(i)%marks(0), contours(i)%curves(next))
            do k = 1, next
                contours(i)%curves(k) = list%curve(mod(first + k - 2, many) + 1)
            end do
            first = first + next
        end do
    end subroutine make_contours

    !> Finds the patches of a path, and where each begins.
    pure subroutine find_patches(inside, from)
        type(opposite_type), intent(inout) :: inside    !! gets `patch` and `until`
        real(dp), allocatable, intent(out) :: from(:)   !! parameters of the outside
        real(dp) :: low, high, next
        integer :: patch, k

        low = 0.0_dp
        patch = patch_opposite(inside, low)
        from = [low]
        k = 1
        do while (k <= steps .and. size(from) < most_patches)
            next = sin(0.5_dp*pi*real(k, dp)/real(steps, dp))**2
            if (is_patch_opposite(inside, next, patch)) then
                low = next
                k = k + 1
                cycle
            end if
            high = next
            call narrow(inside, patch, low, high)
            inside%patch = [inside%patch, patch]
            inside%until = [inside%until, low]
            if (patch == nowhere) low = high
            from = [from, low]
            patch = patch_opposite(inside, high)
            low = high
            if (.not. high < next) k = k + 1
        end do
        inside%patch = [inside%patch, patch]
        inside%until = [inside%until, low]
    end subroutine find_patches

    !> Narrows where a patch ends.
    pure subroutine narrow(inside, patch, low, high)
        type(opposite_type), intent(in) :: inside   !! any
        integer, intent(in) :: patch                !! which
        real(dp), intent(inout) :: low              !! where it is, parameter of the outside
        real(dp), intent(inout) :: high             !! where it is not, further on
        real(dp) :: middle
        integer :: i

        do i = 1, halvings
            middle = 0.5_dp*(low + high)
            if (.not. (middle > low .and. middle < high)) exit
            if (is_patch_opposite(inside, middle, patch)) then
                low = middle
            else
                high = middle
            end if
        end do
    end subroutine narrow

end module export_drawing_inside
