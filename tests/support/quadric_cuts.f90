!> Cuts of the decks of closed forms against the equation of their surface: every point with its
!> true-shape coordinates, normal, bevel, slope and curvature.
module support_quadric_cuts
    use api_computed_body, only: computed_body_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use cut_outline, only: cut_point_type, cut_type, outline_type
    use cut_plane, only: flange_normal, in_space, true_shape
    use support_quadric, only: cut_curvature, cut_tangent, normal_of, off_surface, quadric_type
    use support_tap, only: tap_type
    implicit none (type, external)
    private

    public :: asked, take, prove_cuts, prove_outlines, prove_steps

    !> Largest errors of the points of a deck.
    type :: worst_type
        integer :: points = 0               !! how many were looked at
        real(dp) :: off_surface = 0.0_dp    !! deck units
        real(dp) :: off_plane = 0.0_dp      !! deck units
        real(dp) :: true_shape = 0.0_dp     !! deck units
        real(dp) :: slope = 0.0_dp          !! radians
        real(dp) :: curvature = 0.0_dp      !! relative
        real(dp) :: normal = 0.0_dp         !! radians
        real(dp) :: bevel = 0.0_dp          !! of its sine
        logical :: is_whole = .true.        !! every point has all its values
    end type worst_type

    !> What all is compared to, deck units, radians or relative: coordinates are some 100.
    real(dp), parameter :: asked = 1.0e-10_dp
    real(dp), parameter :: degree = acos(-1.0_dp)/180.0_dp

contains

    !> Compares every point of every cut.
    subroutine prove_cuts(tap, name, it, surface)
        type(tap_type), intent(inout) :: tap            !! the tally
        character(*), intent(in) :: name                !! of the deck
        type(computed_body_type), intent(in) :: it      !! the deck computed
        type(quadric_type), intent(in) :: surface       !! what it must be
        type(worst_type) :: worst
        integer :: i, k

        do i = 1, size(it%cuts)
            do k = 1, size(it%cuts(i)%outlines)
                call compare_outline(it%cuts(i), it%cuts(i)%outlines(k), surface, worst)
            end do
        end do
        call tap%ok(worst%points > 400, name//': the cuts have '//to_text(worst%points)//' points')
        call tap%ok(worst%is_whole, name//': all with normal, bevel, slope and curvature')
        call tap%near(worst%off_surface, 0.0_dp, asked, name//': points on the surface')
        call tap%near(worst%off_plane, 0.0_dp, asked, name//': points in the plane')
        call tap%near(worst%true_shape, 0.0_dp, asked, name//': true-shape coordinates')
        call tap%near(worst%normal, 0.0_dp, asked, name//': outward normals')
        call tap%near(worst%bevel, 0.0_dp, asked, name//': bevels')
        call tap%near(worst%slope, 0.0_dp, asked, name//': slopes')
        call tap%near(worst%curvature, 0.0_dp, asked, name//': curvatures and their signs')
        call tap%near(maxval(it%cuts%disagreement), 0.0_dp, asked, name//': both ways agree')
    end subroutine prove_cuts

    !> Compares the points of an outline.
    subroutine compare_outline(cut, outline, surface, worst)
        type(cut_type), intent(in) :: cut               !! the cut it is of
        type(outline_type), intent(in) :: outline       !! the outline
        type(quadric_type), intent(in) :: surface       !! what it must lie on
        type(worst_type), intent(inout) :: worst        !! gets its errors
        integer :: k

        do k = 1, size(outline%points)
            call compare_point(cut, outline%points(k), onward(outline%points, k), surface, worst)
        end do
    end subroutine compare_outline

    !> The way to the next point that is another, or from the one before.
    function onward(points, k) result(way)
        type(cut_point_type), intent(in) :: points(:)   !! of an outline
        integer, intent(in) :: k                        !! which
        real(dp) :: way(3)
        integer :: i

        do i = k + 1, size(points)
            way = points(i)%at - points(k)%at
            if (norm2(way) > asked) return
        end do
        do i = k - 1, 1, -1
            way = points(k)%at - points(i)%at
            if (norm2(way) > asked) return
        end do
    end function onward

    !> Compares one point.
    subroutine compare_point(cut, point, way, surface, worst)
        type(cut_type), intent(in) :: cut               !! the cut it is of
        type(cut_point_type), intent(in) :: point       !! the point
        real(dp), intent(in) :: way(3)                  !! where the outline goes on
        type(quadric_type), intent(in) :: surface       !! what it must lie on
        type(worst_type), intent(inout) :: worst        !! gets its errors
        real(dp) :: across(3), along(3), normal(3), uv(2), curvature, error

        associate (plane => cut%plane)
            across = plane%normal/norm2(plane%normal)
            normal = normal_of(surface, point%at)
            along = cut_tangent(surface, point%at, across)
            along = sign(1.0_dp, dot_product(along, way))*along
            uv = [dot_product(along, plane%u), dot_product(along, plane%v)]
            curvature = cut_curvature(surface, point%at, along, uv(1)*plane%v - uv(2)*plane%u)

            worst%points = worst%points + 1
            worst%is_whole = worst%is_whole .and. point%has_normal .and. point%has_slope &
                .and. point%has_curvature
            call take(worst%off_surface, off_surface(surface, point%at))
            call take(worst%off_plane, dot_product(across, point%at - plane%through))
            call take(worst%true_shape, norm2(point%uv - true_shape(plane, point%at)))
            call take(worst%true_shape, norm2(in_space(plane, point%uv) - point%at))
            call take(worst%normal, norm2(point%normal - normal))
            call take(worst%bevel, sin(point%bevel*degree) &
                + dot_product(normal, flange_normal(plane, cut%is_flange_forward)))
            error = uv(1)
            if (.not. point%slope%is_vertical) error = (point%slope%value*uv(1) - uv(2)) &
                /sqrt(1.0_dp + point%slope%value**2)
            call take(worst%slope, error)
            call take(worst%curvature, (point%curvature - curvature)/max(abs(curvature), 1.0e-3_dp))
        end associate
    end subroutine compare_point

    !> Keeps the largest of errors. One that is no number counts as huge.
    subroutine take(worst, error)
        real(dp), intent(inout) :: worst    !! the largest so far
        real(dp), intent(in) :: error       !! another
        if (.not. abs(error) <= worst) worst = abs(error)
    end subroutine take

    !> Each cut has as many outlines as it must, and those are closed that must be.
    subroutine prove_outlines(tap, name, it, count, closed)
        type(tap_type), intent(inout) :: tap            !! the tally
        character(*), intent(in) :: name                !! of the deck
        type(computed_body_type), intent(in) :: it      !! the deck computed
        integer, intent(in) :: count(:)                 !! outlines of each cut
        integer, intent(in) :: closed(:)                !! cuts whose outlines are closed
        logical :: is_right
        integer :: i

        call tap%ok(size(it%cuts) == size(count), name//': as many cuts as asked for')
        do i = 1, min(size(it%cuts), size(count))
            is_right = size(it%cuts(i)%outlines) == count(i)
            if (is_right) is_right = all(it%cuts(i)%outlines%is_closed .eqv. any(closed == i))
            call tap%ok(is_right, name//': outlines of cut '//to_text(i)//', open or closed')
        end do
    end subroutine prove_outlines

    !> Every outline of a cut has the stepped stations, figure for figure, and no others but where
    !> sections meet and where it ends on the centre line.
    subroutine prove_steps(tap, name, cut, steps)
        type(tap_type), intent(inout) :: tap    !! the tally
        character(*), intent(in) :: name        !! of the deck
        type(cut_type), intent(in) :: cut       !! stepped along STA
        integer, intent(in) :: steps(3)         !! first, last, step
        real(dp) :: sta((steps(2) - steps(1))/steps(3) + 1)
        logical :: is_right
        integer :: i, k

        sta = [(real(steps(1) + k*steps(3), dp), k=0, size(sta) - 1)]
        is_right = size(cut%outlines) > 0
        do i = 1, size(cut%outlines)
            associate (points => cut%outlines(i)%points)
                do k = 1, size(sta)
                    is_right = is_right .and. any(is_same(points%at(1), sta(k)))
                end do
                do k = 1, size(points)
                    is_right = is_right .and. (any(is_same(points(k)%at(1), sta)) .or. &
                        abs(points(k)%at(2)) < asked .or. &
                        any(points%section /= points(k)%section .and. &
                        is_same(points%at(1), points(k)%at(1))))
                end do
            end associate
        end do
        call tap%ok(is_right, name//': stations of '//trim(cut%name))
    end subroutine prove_steps

    !> True for two numbers that are the same to the last bit.
    elemental logical function is_same(a, b)
        real(dp), intent(in) :: a !! a number
        real(dp), intent(in) :: b !! another
        is_same = abs(a - b) <= 0.0_dp
    end function is_same

end module support_quadric_cuts
