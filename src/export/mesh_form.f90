!> The two fundamental forms of the skin at a point of a sheet (`cut_measure_sheet`), and with them
!> how far a point beside it is from the skin and how fast the skin turns.
!>
!>     E = Su.Su, F = Su.St, G = St.St,   L = Suu.n, M = Sut.n, N = Stt.n
!>
!> Source: D. J. Struik, "Lectures on Classical Differential Geometry", 2nd ed. 1961, 2-5 to 2-7.
module export_mesh_form
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use cut_measure_sheet, only: spot_type
    implicit none (type, external)
    private

    public :: form_type, form_at, distance_from, distance_in_plane, turn_along

    !> The forms at a point.
    type :: form_type
        logical :: is_there = .false.       !! the skin has a tangent plane that u and t span
        real(dp) :: normal(3) = 0.0_dp      !! along Su x St, of unit length
        real(dp) :: first(2, 2) = 0.0_dp    !! E F, F G
        real(dp) :: second(2, 2) = 0.0_dp   !! L M, M N
    end type form_type

contains

    !> The forms at a point.
    pure type(form_type) function form_at(spot) result(form)
        type(spot_type), intent(in) :: spot !! a point of a sheet
        real(dp) :: across(3)

        across = [spot%u(2)*spot%t(3) - spot%u(3)*spot%t(2), -spot%u(1)*spot%t(3), &
            spot%u(1)*spot%t(2)]
        form%is_there = norm2(across) > ulp*norm2(spot%u)*norm2(spot%t)
        if (.not. form%is_there) return
        form%normal = across/norm2(across)
        form%first(:, 1) = [dot_product(spot%u, spot%u), dot_product(spot%u, spot%t)]
        form%first(:, 2) = [form%first(2, 1), dot_product(spot%t, spot%t)]
        form%second(:, 1) = [dot_product(spot%uu, form%normal), dot_product(spot%ut, form%normal)]
        form%second(:, 2) = [form%second(2, 1), dot_product(spot%tt, form%normal)]
    end function form_at

    !> How far a point is from the skin, to second order about a point near it; no further than that
    !> point is.
    pure real(dp) function distance_from(spot, at) result(distance)
        type(spot_type), intent(in) :: spot !! a point of a sheet
        real(dp), intent(in) :: at(3)       !! a point near it: STA, BL, WL
        type(form_type) :: form
        real(dp) :: way(3), along(2), step(2)

        form = form_at(spot)
        way = at - spot%at
        distance = norm2(way)
        if (.not. form%is_there) return
        along = [dot_product(way, spot%u), dot_product(way, spot%t)]
        step = solved(form%first, along)
        distance = min(distance, abs(dot_product(way, form%normal) &
            - 0.5_dp*dot_product(step, matmul(form%second, step))))
    end function distance_from

    !> How far a point of the plane of a section is from its outline, to second order about a point
    !> near it; no further than that point is.
    pure real(dp) function distance_in_plane(spot, at) result(distance)
        type(spot_type), intent(in) :: spot !! a point of a sheet
        real(dp), intent(in) :: at(3)       !! a point near it, at the same station
        real(dp) :: way(2), normal(2), pace, step

        way = at(2:) - spot%at(2:)
        distance = norm2(way)
        pace = norm2(spot%t(2:))
        if (.not. pace > 0.0_dp) return
        normal = [-spot%t(3), spot%t(2)]/pace
        step = dot_product(way, spot%t(2:))/pace**2
        distance = min(distance, abs(dot_product(way, normal) &
            - 0.5_dp*step**2*dot_product(spot%tt(2:), normal)))
    end function distance_in_plane

    !> How fast the normal turns along a way on the skin, radians for one of the way: by the
    !> equations of Weingarten it changes along a way w by a vector of length sqrt(v I**-1 v),
    !> v = II w.
    pure real(dp) function turn_along(form, way) result(turn)
        type(form_type), intent(in) :: form !! there
        real(dp), intent(in) :: way(2)      !! along u and t
        real(dp) :: bend(2)
        bend = matmul(form%second, way)
        turn = sqrt(max(0.0_dp, dot_product(bend, solved(form%first, bend))))
    end function turn_along

    !> The solution of two equations with a positive matrix.
    pure function solved(matrix, right)
        real(dp), intent(in) :: matrix(2, 2)    !! symmetric, positive
        real(dp), intent(in) :: right(2)        !! the right side
        real(dp) :: solved(2), determinant

        determinant = matrix(1, 1)*matrix(2, 2) - matrix(1, 2)**2
        solved = 0.0_dp
        if (.not. determinant > tiny(1.0_dp)) return
        solved = [matrix(2, 2)*right(1) - matrix(1, 2)*right(2), &
            matrix(1, 1)*right(2) - matrix(1, 2)*right(1)]/determinant
    end function solved

end module export_mesh_form
