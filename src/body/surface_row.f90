!> Sections about stations in a row: F of `body_surface` and its derivatives at a point of each.
module body_surface_row
    use base_kinds, only: dp
    use body_surface, only: patch_type
    use body_taylor_row, only: cross, operator(*), operator(-), taylor_row_type
    use geom_chain_row, only: jet_row_type
    use geom_jet, only: jet_type
    use geom_twofold_short, only: width
    implicit none (type, external)
    private

    public :: patch_row_type, repeated_patch, row_forms, row_gradients

    !> Sections, each as a `patch_type` keeps it.
    type :: patch_row_type
        type(jet_row_type) :: point(2, 3)   !! BL, WL of the three points, deck units
        type(jet_row_type) :: tangent(2, 2) !! BL, WL of start and finish tangent
        real(dp) :: size(width)             !! powers of two near their lengths, deck units
        logical :: is_straight(width)       !! straight lines
    end type patch_row_type

    !> Numbers and how they change along STA.
    type :: dual_row_type
        real(dp) :: value(width)    !! the numbers
        real(dp) :: first(width)    !! their first derivatives
    end type dual_row_type

contains

    !> One section about its station, as often as a row has room.
    pure subroutine repeated_patch(patch, row)
        type(patch_type), intent(in) :: patch       !! any
        type(patch_row_type), intent(out) :: row    !! gets it
        integer :: axis, k

        do axis = 1, 2
            do k = 1, 3
                row%point(axis, k) = repeated(patch%point(axis, k))
            end do
            do k = 1, 2
                row%tangent(axis, k) = repeated(patch%tangent(axis, k))
            end do
        end do
        row%size = patch%size
        row%is_straight = patch%is_straight
    end subroutine repeated_patch

    !> One ordinate, as often as a row has room.
    pure type(jet_row_type) function repeated(jet) result(row)
        type(jet_type), intent(in) :: jet !! any
        row%value = jet%value
        row%first = jet%first
        row%second = jet%second
    end function repeated

    !> F along the ways `at + s*way`, s in deck units, each to a scale of its own.
    pure subroutine row_forms(patch, at, way, form)
        type(patch_row_type), intent(in) :: patch   !! the sections about the stations of `at`
        real(dp), intent(in) :: at(width, 2)        !! BL, WL, deck units
        real(dp), intent(in) :: way(width, 3)       !! along STA, BL, WL
        type(taylor_row_type), intent(out) :: form  !! F
        type(taylor_row_type), dimension(2) :: chord, start, finish, shoulder, first, last
        type(taylor_row_type) :: chord_of_p, chord_of_s, curved
        integer :: axis, i

        do axis = 1, 2
            start(axis)%value = at(:, axis)
            start(axis)%first = way(:, axis + 1)
            start(axis)%second = 0.0_dp
            start(axis) = from_start(start(axis), axis)
            shoulder(axis) = from_start(along(patch%point(axis, 2)), axis)
            chord(axis) = from_start(along(patch%point(axis, 3)), axis)
            finish(axis) = start(axis) - chord(axis)
            first(axis) = along(patch%tangent(axis, 1))
            last(axis) = along(patch%tangent(axis, 2))
        end do
        chord_of_p = cross(start, chord)
        chord_of_s = cross(shoulder, chord)
        form = chord_of_p*chord_of_p*cross(shoulder, first)
        do axis = 1, 2
            shoulder(axis) = shoulder(axis) - chord(axis)
        end do
        curved = form*cross(shoulder, last) &
            - cross(start, first)*cross(finish, last)*chord_of_s*chord_of_s
        do i = 1, width
            form%value(i) = merge(chord_of_p%value(i), curved%value(i), patch%is_straight(i))
            form%first(i) = merge(chord_of_p%first(i), curved%first(i), patch%is_straight(i))
            form%second(i) = merge(chord_of_p%second(i), curved%second(i), patch%is_straight(i))
        end do
    contains
        !> A jet over STA as one along the way.
        pure type(taylor_row_type) function along(jet)
            type(jet_row_type), intent(in) :: jet !! over STA
            along%value = jet%value
            along%first = jet%first*way(:, 1)
            along%second = jet%second*way(:, 1)**2
        end function along

        !> An ordinate as seen from the start of the section, in `size`.
        pure type(taylor_row_type) function from_start(ordinate, axis) result(seen)
            type(taylor_row_type), intent(in) :: ordinate   !! BL or WL, deck units
            integer, intent(in) :: axis                     !! 1: BL, 2: WL
            real(dp) :: unit(width)
            unit = 1.0_dp/patch%size
            seen = ordinate - along(patch%point(axis, 1))
            seen%value = unit*seen%value
            seen%first = unit*seen%first
            seen%second = unit*seen%second
        end function from_start
    end subroutine row_forms

    !> The gradients of F, along STA, BL and WL, each to a scale of its own. Their STA parts do not
    !> exist where a line has an infinite slope.
    !>
    !> F is Lc**2 A B - L1 L3 C**2, with A, B and C the products at the shoulder point; these
    !> change along STA alone, and L along BL and WL as its vector has it.
    pure subroutine row_gradients(patch, at, gradient)
        type(patch_row_type), intent(in) :: patch   !! the sections about the stations of `at`
        real(dp), intent(in) :: at(width, 2)        !! BL, WL, deck units
        real(dp), intent(out) :: gradient(width, 3) !! see above
        type(dual_row_type), dimension(2) :: start, finish, chord, shoulder, beyond, first, last
        type(dual_row_type) :: a, b, c, lc, l1, l3
        real(dp), dimension(width) :: unit, square, ends, across, along_first, along_last, largest
        integer :: axis

        unit = 1.0_dp/patch%size
        do axis = 1, 2
            associate (p1 => patch%point(axis, 1), p2 => patch%point(axis, 2), &
                    p3 => patch%point(axis, 3))
                start(axis)%value = unit*(at(:, axis) - p1%value)
                start(axis)%first = -unit*p1%first
                shoulder(axis)%value = unit*(p2%value - p1%value)
                shoulder(axis)%first = unit*(p2%first - p1%first)
                chord(axis)%value = unit*(p3%value - p1%value)
                chord(axis)%first = unit*(p3%first - p1%first)
            end associate
            first(axis)%value = patch%tangent(axis, 1)%value
            first(axis)%first = patch%tangent(axis, 1)%first
            last(axis)%value = patch%tangent(axis, 2)%value
            last(axis)%first = patch%tangent(axis, 2)%first
            finish(axis)%value = start(axis)%value - chord(axis)%value
            finish(axis)%first = start(axis)%first - chord(axis)%first
            beyond(axis)%value = shoulder(axis)%value - chord(axis)%value
            beyond(axis)%first = shoulder(axis)%first - chord(axis)%first
        end do
        call multiply(shoulder, first, a)
        call multiply(beyond, last, b)
        call multiply(shoulder, chord, c)
        call multiply(start, chord, lc)
        call multiply(start, first, l1)
        call multiply(finish, last, l3)
        square = lc%value*lc%value
        ends = l1%value*l3%value
        gradient(:, 1) = square*a%value*b%first &
            + (square*a%first + (2.0_dp*lc%value*lc%first)*a%value)*b%value &
            - (ends*c%value*c%first + (ends*c%first &
            + (l1%value*l3%first + l1%first*l3%value)*c%value)*c%value)
        do axis = 1, 2
            ! Along BL a product with v changes by the WL part of v, along WL by less its BL part.
            across = merge(unit, -unit, axis == 1)*chord(3 - axis)%value
            along_first = merge(unit, -unit, axis == 1)*first(3 - axis)%value
            along_last = merge(unit, -unit, axis == 1)*last(3 - axis)%value
            gradient(:, axis + 1) = 2.0_dp*lc%value*across*a%value*b%value &
                - (l1%value*along_last + along_first*l3%value)*c%value*c%value
            gradient(:, axis + 1) = merge(across, gradient(:, axis + 1), patch%is_straight)
        end do
        gradient(:, 1) = merge(lc%first, gradient(:, 1), patch%is_straight)
        largest = max(abs(gradient(:, 1)), abs(gradient(:, 2)), abs(gradient(:, 3)))
        largest = merge(largest, 1.0_dp, largest > 0.0_dp)
        do axis = 1, 3
            gradient(:, axis) = gradient(:, axis)/largest
        end do
    end subroutine row_gradients

    !> Products u x v and how they change along STA.
    pure subroutine multiply(u, v, product)
        type(dual_row_type), intent(in) :: u(2)         !! vectors
        type(dual_row_type), intent(in) :: v(2)         !! others
        type(dual_row_type), intent(out) :: product     !! see above
        product%value = u(1)%value*v(2)%value - u(2)%value*v(1)%value
        product%first = (u(1)%value*v(2)%first + u(1)%first*v(2)%value) &
            - (u(2)%value*v(1)%first + u(2)%first*v(1)%value)
    end subroutine multiply

end module body_surface_row
