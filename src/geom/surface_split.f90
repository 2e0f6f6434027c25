!> A B-spline surface split across u, exactly.
!>
!> Source: W. Boehm, "Inserting new knots into B-spline curves", Computer-Aided Design 12 (1980),
!> pp. 199-201: until the knot stands as often as the degree says; the pole there is a point of the
!> surface, and both parts end in it.
module geom_surface_split
    use base_kinds, only: dp
    use base_exact, only: is_equal
    use geom_bspline_basis, only: span_of
    use geom_bspline_surface, only: bspline_surface_type
    implicit none (type, external)
    private

    public :: split_surface

contains

    !> The parts of a surface before and behind a parameter; both have its pole rows in common.
    pure subroutine split_surface(whole, at, before, behind)
        type(bspline_surface_type), intent(in) :: whole     !! all its weights are 1
        real(dp), intent(in) :: at                          !! u, between its start and its end
        type(bspline_surface_type), intent(out) :: before   !! ends there
        type(bspline_surface_type), intent(out) :: behind   !! begins there
        type(bspline_surface_type) :: split
        integer :: degree, first, i

        degree = whole%degree(1)
        split = whole
        do i = count(is_equal(whole%u_knot, at)) + 1, degree
            call insert_knot(split, at)
        end do
        first = findloc(is_equal(split%u_knot, at), .true., dim=1)
        before = part(split, [split%u_knot(:first + degree - 1), at], 1)
        behind = part(split, [at, split%u_knot(first:)], first - 1)
    end subroutine split_surface

    !> Inserts a knot along u.
    pure subroutine insert_knot(surface, at)
        type(bspline_surface_type), intent(inout) :: surface    !! gets a row of poles
        real(dp), intent(in) :: at                              !! u, a knot fewer times than the
                                                                !! degree says
        real(dp), allocatable :: pole(:, :, :)
        real(dp) :: share
        integer :: degree, span, i, n

        degree = surface%degree(1)
        span = span_of(surface%u_knot, degree, at)
        n = size(surface%pole, 2)
        allocate (pole(3, n + 1, size(surface%pole, 3)))
        associate (knot => surface%u_knot, old => surface%pole)
            pole(:, :span - degree, :) = old(:, :span - degree, :)
            do i = span - degree + 1, span
                share = (at - knot(i))/(knot(i + degree) - knot(i))
                pole(:, i, :) = (1.0_dp - share)*old(:, i - 1, :) + share*old(:, i, :)
            end do
            pole(:, span + 1:, :) = old(:, span:, :)
        end associate
        surface%u_knot = [surface%u_knot(:span), at, surface%u_knot(span + 1:)]
        call move_alloc(pole, surface%pole)
        surface%weight = reshape([1.0_dp], [n + 1, size(surface%pole, 3)], pad=[1.0_dp])
    end subroutine insert_knot

    !> The part of a surface of some of its rows.
    pure type(bspline_surface_type) function part(whole, knot, first)
        type(bspline_surface_type), intent(in) :: whole     !! any
        real(dp), intent(in) :: knot(:)                     !! along u of the part
        integer, intent(in) :: first                        !! its first row of poles
        integer :: last

        last = first + size(knot) - whole%degree(1) - 2
        part = whole
        part%u_knot = knot
        part%pole = whole%pole(:, first:last, :)
        part%weight = whole%weight(first:last, :)
    end function part

end module geom_surface_split
