!> Planes that cut a body, `normal . p = offset` with p = (STA, BL, WL), and the axes in which the
!> cut is seen in its true shape.
!>
!> The axes follow one rule. u is level, to starboard; where the plane has no level line but one
!> along the stations, u is aft. v is across u in the plane, upwards. In a level plane u is aft and
!> v to starboard. So a station is seen as WL over BL, a buttock as WL over STA, a waterline as BL
!> over STA, as the trade draws them.
module cut_plane
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_zero
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: plane_type, station_plane, buttock_plane, waterline_plane, oblique_plane
    public :: plane_through
    public :: height_over, true_shape, in_space, in_view, flange_normal

    !> The kinds of cut, numbered as on the cards.
    type, public :: kind_list
        integer :: station = 1   !! STA is constant
        integer :: buttock = 2   !! BL is constant
        integer :: waterline = 3 !! WL is constant
        integer :: oblique = 4   !! through two (STA, WL) points, every BL
        integer :: plane = 5     !! through a point, across a normal
    end type kind_list

    !> The kinds by name: `case (cut_kind%buttock)`.
    type(kind_list), parameter, public :: cut_kind = kind_list()

    !> A plane with its kind and its true-shape axes.
    type :: plane_type
        integer :: kind = 0                !! one of `cut_kind%...`
        real(dp) :: normal(3) = 0.0_dp     !! as given, not of unit length
        real(dp) :: through(3) = 0.0_dp    !! a point of the plane as given, deck units
        real(dp) :: origin(3) = 0.0_dp     !! where u = v = 0: deck units
        real(dp) :: u(3) = 0.0_dp          !! unit vector to the right in the true shape
        real(dp) :: v(3) = 0.0_dp          !! unit vector upwards in the true shape
    end type plane_type

contains

    !> The plane of a station; u is BL, v is WL.
    pure type(plane_type) function station_plane(sta) result(plane)
        real(dp), intent(in) :: sta !! deck units
        plane = framed(cut_kind%station, [1.0_dp, 0.0_dp, 0.0_dp], [sta, 0.0_dp, 0.0_dp])
    end function station_plane

    !> The plane of a buttock; u is STA, v is WL.
    pure type(plane_type) function buttock_plane(bl) result(plane)
        real(dp), intent(in) :: bl !! deck units
        plane = framed(cut_kind%buttock, [0.0_dp, 1.0_dp, 0.0_dp], [0.0_dp, bl, 0.0_dp])
    end function buttock_plane

    !> The plane of a waterline; u is STA, v is BL.
    pure type(plane_type) function waterline_plane(wl) result(plane)
        real(dp), intent(in) :: wl !! deck units
        plane = framed(cut_kind%waterline, [0.0_dp, 0.0_dp, 1.0_dp], [0.0_dp, 0.0_dp, wl])
    end function waterline_plane

    !> The plane through two points of a side view, across it; u is BL, v goes up along the line.
    !> The origin is the first point, at BL 0. Fails with `cause%points_coincide`.
    pure subroutine oblique_plane(first, second, plane, error)
        real(dp), intent(in) :: first(2)                    !! STA and WL, deck units
        real(dp), intent(in) :: second(2)                   !! STA and WL, deck units
        type(plane_type), intent(out) :: plane              !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above

        call plane_through([first(1), 0.0_dp, first(2)], &
            [first(2) - second(2), 0.0_dp, second(1) - first(1)], plane, error)
        plane%kind = cut_kind%oblique
        if (allocated(error)) error%message = &
            'both points of the oblique plane are one; it takes two different (STA, WL) points'
    end subroutine oblique_plane

    !> The plane through a point across a normal. The origin is the point.
    !> Fails with `cause%points_coincide` where the normal is zero.
    pure subroutine plane_through(point, normal, plane, error)
        real(dp), intent(in) :: point(3)                    !! STA, BL, WL, deck units
        real(dp), intent(in) :: normal(3)                   !! any length, not zero
        type(plane_type), intent(out) :: plane              !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above

        if (all(is_zero(normal))) then
            call fail(error, cause%points_coincide, &
                'the normal of the plane is zero; it takes a direction')
            return
        end if
        plane = framed(cut_kind%plane, normal, point)
    end subroutine plane_through

    !> A plane with its axes.
    pure type(plane_type) function framed(kind, normal, point) result(plane)
        integer, intent(in) :: kind         !! one of `cut_kind%...`
        real(dp), intent(in) :: normal(3)   !! not zero
        real(dp), intent(in) :: point(3)    !! STA, BL, WL, deck units
        real(dp) :: unit(3)

        plane%kind = kind
        plane%normal = normal
        plane%through = point
        plane%origin = point
        unit = normal/maxval(abs(normal))
        if (is_zero(unit(1)) .and. is_zero(unit(2))) then
            plane%u = [1.0_dp, 0.0_dp, 0.0_dp]
            plane%v = [0.0_dp, 1.0_dp, 0.0_dp]
            return
        end if
        unit = unit/norm2(unit)
        plane%u = [-unit(2), unit(1), 0.0_dp]/norm2(unit(:2))
        if (plane%u(2) < 0.0_dp .or. (is_zero(plane%u(2)) .and. plane%u(1) < 0.0_dp)) then
            plane%u = -plane%u
        end if
        plane%v = [-unit(1)*unit(3), -unit(2)*unit(3), unit(1)**2 + unit(2)**2]/norm2(unit(:2))
    end function framed

    !> The distance of a point from a plane, positive on the side of its normal, deck units.
    pure real(dp) function height_over(plane, point) result(height)
        type(plane_type), intent(in) :: plane !! any plane
        real(dp), intent(in) :: point(3)      !! STA, BL, WL, deck units
        height = dot_product(plane%normal, point - plane%through)/norm2(plane%normal)
    end function height_over

    !> The true-shape coordinates u and v of a point of a plane, deck units.
    pure function true_shape(plane, point) result(uv)
        type(plane_type), intent(in) :: plane !! any plane
        real(dp), intent(in) :: point(3)      !! STA, BL, WL, deck units
        real(dp) :: uv(2)
        uv = in_view(plane, point - plane%origin)
    end function true_shape

    !> The parts along u and v of a vector.
    pure function in_view(plane, vector) result(uv)
        type(plane_type), intent(in) :: plane !! any plane
        real(dp), intent(in) :: vector(3)     !! along STA, BL, WL
        real(dp) :: uv(2)
        uv = [dot_product(plane%u, vector), dot_product(plane%v, vector)]
    end function in_view

    !> The point of a plane that has true-shape coordinates u and v: STA, BL, WL, deck units.
    pure function in_space(plane, uv) result(point)
        type(plane_type), intent(in) :: plane !! any plane
        real(dp), intent(in) :: uv(2)         !! deck units
        real(dp) :: point(3)
        point = plane%origin + uv(1)*plane%u + uv(2)*plane%v
    end function in_space

    !> The unit normal f of a frame on the side of its flange. Aft of a plane along the stations is,
    !> by convention, outboard to starboard, and above a level one.
    pure function flange_normal(plane, is_forward) result(f)
        type(plane_type), intent(in) :: plane   !! any plane
        logical, intent(in) :: is_forward       !! the flange is on the forward side
        real(dp) :: f(3)
        integer :: axis

        f = plane%normal/norm2(plane%normal)
        axis = findloc(.not. is_zero(f), .true., dim=1)
        if (f(axis) < 0.0_dp) f = -f
        if (is_forward) f = -f
    end function flange_normal

end module cut_plane
