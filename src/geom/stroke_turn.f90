!> Whether a stroke turns back on its way to greater x.
module geom_stroke_turn
    use base_kinds, only: dp
    use base_tolerances, only: decimal_noise, ulp
    use geom_arc_point, only: arc_point => point
    use geom_bezier, only: bezier_derivative, bezier_part
    use geom_crossing, only: turning_places
    use geom_place, only: place_at, place_type
    use geom_stroke, only: stroke_jet, stroke_kind, stroke_point, stroke_type
    implicit none (type, external)
    private

    public :: stroke_turn

    !> Halvings in the search for a turn, and the stretch of the parameter that is halved no more.
    integer, parameter :: deepest = 50
    real(dp), parameter :: shortest = 1.0e-12_dp

contains

    !> Whether a stroke on its way to greater x turns back, and where. A turn within decimal noise
    !> of an end is that end.
    pure subroutine stroke_turn(stroke, turns, at)
        type(stroke_type), intent(in) :: stroke     !! finish not before start
        logical, intent(out) :: turns               !! it does
        real(dp), intent(out) :: at(2)              !! where: a point; zero where it does not
        type(place_type), allocatable :: places(:)
        real(dp) :: noise
        integer :: i

        noise = decimal_noise*ulp*max(abs(stroke%start(1)), abs(stroke%finish(1)))
        turns = .false.
        at = 0.0_dp
        allocate (places(0))
        if (stroke%kind == stroke_kind%bezier) then
            call find_fall(bezier_derivative(stroke%pole(1:1, :)), noise, turns, at(1))
        else if (stroke%kind == stroke_kind%cyclic) then
            call find_least(stroke, noise, turns, at(1))
        end if
        if (turns) at = stroke_point(stroke, place_at(at(1)))
        if (stroke%kind /= stroke_kind%conic) return
        places = turning_places(stroke%arc, 1)
        do i = 1, size(places)
            at = arc_point(stroke%arc, places(i))
            turns = at(1) < stroke%start(1) - noise .or. at(1) > stroke%finish(1) + noise
            if (turns) return
        end do
        at = 0.0_dp
    end subroutine stroke_turn

    !> Whether a polynomial is anywhere below zero, and where: it is not where none of its poles is.
    !> Elsewhere its halves are looked at, and theirs, first come first.
    pure subroutine find_fall(pole, noise, falls, t)
        real(dp), intent(in) :: pole(:, :)  !! shape (1, degree + 1)
        real(dp), intent(in) :: noise       !! what counts as zero
        logical, intent(out) :: falls       !! it is
        real(dp), intent(out) :: t          !! where; zero where it is not
        real(dp) :: ahead(deepest), part(1, size(pole, 2))
        integer :: left

        falls = .false.
        t = 0.0_dp
        ahead(:2) = [1.0_dp, 0.5_dp]
        left = 2
        do while (left > 0)
            part = bezier_part(pole, t, ahead(left))
            falls = part(1, 1) < -noise
            if (falls) return
            if (any(part < -noise) .and. ahead(left) - t > shortest) then
                ahead(left + 1) = 0.5_dp*(t + ahead(left))
                left = left + 1
            else
                t = ahead(left)
                left = left - 1
            end if
        end do
        falls = pole(1, size(pole, 2)) < -noise
        if (.not. falls) t = 0.0_dp
    end subroutine find_fall

    !> Whether dx/ds of a C-Bezier curve is anywhere below zero, and where: it is a + b cos + c sin
    !> of the angle from the middle, so that it has one least value.
    pure subroutine find_least(stroke, noise, falls, s)
        type(stroke_type), intent(in) :: stroke     !! a C-Bezier curve
        real(dp), intent(in) :: noise               !! what counts as zero
        logical, intent(out) :: falls               !! it is
        real(dp), intent(out) :: s                  !! where; zero where it is not
        real(dp) :: pace(3), at(2), first(2), second(2), half, b, c, tau
        integer :: i

        do i = 1, 3
            call stroke_jet(stroke, 0.5_dp*real(i - 1, dp), at, first, second)
            pace(i) = first(1)
        end do
        half = 0.5_dp*stroke%alpha
        b = (pace(2) - 0.5_dp*(pace(1) + pace(3)))/(2.0_dp*sin(0.5_dp*half)**2)
        c = (pace(3) - pace(1))/(2.0_dp*sin(half))
        s = merge(0.0_dp, 1.0_dp, pace(1) < pace(3))
        tau = 0.0_dp
        if (abs(b) + abs(c) > 0.0_dp) tau = atan2(-c, -b)
        if (abs(tau) < half) s = 0.5_dp + 0.5_dp*tau/half
        call stroke_jet(stroke, s, at, first, second)
        falls = first(1) < -noise
        if (.not. falls) s = 0.0_dp
    end subroutine find_least

end module geom_stroke_turn
