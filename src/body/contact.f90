!> Where two curves in space come together: the pairs of parameters at which they are nearer to each
!> other than anywhere around.
!>
!> Both are sampled; from each pair of samples that is nearer than all its neighbours Gauss and
!> Newton's method goes down to the nearest points. Two meetings closer together than the samples
!> are found as one.
module body_contact
    use base_kinds, only: dp
    use geom_curve_fit, only: curve_function_type
    implicit none (type, external)
    private

    public :: contact_type, contacts_of, nearest_contact

    !> A pair of points.
    type :: contact_type
        real(dp) :: t(2) = 0.0_dp       !! parameters on the first and the second curve, 0 to 1
        real(dp) :: at(3) = 0.0_dp      !! the point of the first, deck units
        real(dp) :: gap = huge(1.0_dp)  !! how far that of the second is from it, deck units
    end type contact_type

    !> Samples of a curve, less one; steps of a search; step of a difference, of the parameter.
    integer, parameter :: samples = 96, most_steps = 60
    real(dp), parameter :: small_step = 1.0e-6_dp
    !> A parameter nearer than this to an end is the end; steps less than it end the search.
    real(dp), parameter :: end_noise = 1.0e-11_dp, last_step = 1.0e-15_dp
    !> Contacts this near to each other are one, deck units, however small the gap.
    real(dp), parameter :: one_contact = 1.0e-6_dp
    !> Sine of the angle of two curves below which they run side by side.
    real(dp), parameter :: alongside = 1.0e-7_dp

contains

    !> The contacts within a gap, each once, in order of the first curve.
    pure function contacts_of(first, second, gap) result(contacts)
        class(curve_function_type), intent(in) :: first     !! a curve
        class(curve_function_type), intent(in) :: second    !! another
        real(dp), intent(in) :: gap                         !! deck units
        type(contact_type), allocatable :: contacts(:), all(:)
        integer :: i, k

        allocate (contacts(0), all(0))
        all = minima_of(first, second)
        do i = 1, size(all)
            if (all(i)%gap > gap) cycle
            do k = 1, size(contacts)
                if (norm2(contacts(k)%at - all(i)%at) <= max(gap, one_contact)) exit
            end do
            if (k > size(contacts)) then
                contacts = [contacts, all(i)]
            else if (all(i)%gap < contacts(k)%gap) then
                contacts(k) = all(i)
            end if
        end do
    end function contacts_of

    !> The contact with the least gap.
    pure type(contact_type) function nearest_contact(first, second) result(nearest)
        class(curve_function_type), intent(in) :: first     !! a curve
        class(curve_function_type), intent(in) :: second    !! another
        type(contact_type), allocatable :: all(:)

        allocate (all(0))
        all = minima_of(first, second)
        nearest = all(minloc(all%gap, dim=1))
    end function nearest_contact

    !> All pairs of points that are nearer to each other than those around them.
    pure function minima_of(first, second) result(minima)
        class(curve_function_type), intent(in) :: first     !! a curve
        class(curve_function_type), intent(in) :: second    !! another
        type(contact_type), allocatable :: minima(:)
        type(contact_type) :: contact
        real(dp) :: one(3, 0:samples), other(3, 0:samples)
        real(dp), allocatable :: far(:, :)
        integer :: i, k

        do i = 0, samples
            one(:, i) = first%at(real(i, dp)/real(samples, dp))
            other(:, i) = second%at(real(i, dp)/real(samples, dp))
        end do
        allocate (minima(0), far(-1:samples + 1, -1:samples + 1))
        far = huge(1.0_dp)
        do k = 0, samples
            do i = 0, samples
                far(i, k) = norm2(one(:, i) - other(:, k))
            end do
        end do
        do k = 0, samples
            do i = 0, samples
                if (.not. far(i, k) <= minval(far(i - 1:i + 1, k - 1:k + 1))) cycle
                contact = settled(first, second, real([i, k], dp)/real(samples, dp))
                minima = [minima, contact]
            end do
        end do
    end function minima_of

    !> The nearest points next to a pair. A parameter at an end stays there as long as the way down
    !> leads beyond it.
    pure type(contact_type) function settled(first, second, from) result(contact)
        class(curve_function_type), intent(in) :: first     !! a curve
        class(curve_function_type), intent(in) :: second    !! another
        real(dp), intent(in) :: from(2)                     !! parameters
        real(dp) :: t(2), next(2), way(3), u(3), v(3)
        integer :: i

        t = from
        do i = 1, most_steps
            way = second%at(t(2)) - first%at(t(1))
            u = slope_of(first, t(1))
            v = slope_of(second, t(2))
            next = min(max(t + step_of(u, v, way, t), 0.0_dp), 1.0_dp)
            if (gap_at(next) > norm2(way)) next = 0.5_dp*(t + next)
            if (all(abs(next - t) <= last_step)) exit
            if (gap_at(next) > norm2(way)) exit
            t = next
        end do
        where (t <= end_noise) t = 0.0_dp
        where (1.0_dp - t <= end_noise) t = 1.0_dp
        contact%t = t
        contact%at = first%at(t(1))
        contact%gap = gap_at(t)
    contains
        !> The distance of the points of two parameters.
        pure real(dp) function gap_at(t)
            real(dp), intent(in) :: t(2) !! 0 to 1
            gap_at = norm2(second%at(t(2)) - first%at(t(1)))
        end function gap_at
    end function settled

    !> The step that makes two straight curves meet as nearly as they can; a parameter at an end
    !> that it would lead beyond is kept, and the other one moved alone.
    pure function step_of(u, v, way, t) result(step)
        real(dp), intent(in) :: u(3)    !! slope of the first curve
        real(dp), intent(in) :: v(3)    !! slope of the second curve
        real(dp), intent(in) :: way(3)  !! from the first to the second point
        real(dp), intent(in) :: t(2)    !! parameters
        real(dp) :: step(2), a, b, c, alone(2)
        logical :: is_stuck(2)

        a = max(dot_product(u, u), tiny(1.0_dp))
        b = dot_product(u, v)
        c = max(dot_product(v, v), tiny(1.0_dp))
        alone = [dot_product(u, way)/a, -dot_product(v, way)/c]
        step = alone*[1.0_dp, 0.0_dp]
        if (a*c - b**2 > alongside**2*a*c) step = [c*dot_product(u, way) - b*dot_product(v, way), &
            b*dot_product(u, way) - a*dot_product(v, way)]/(a*c - b**2)
        is_stuck = (t <= 0.0_dp .and. step < 0.0_dp) .or. (t >= 1.0_dp .and. step > 0.0_dp)
        if (is_stuck(1)) step = [0.0_dp, alone(2)]
        if (is_stuck(2)) step = [alone(1), 0.0_dp]
        if (all(is_stuck)) step = 0.0_dp
    end function step_of

    !> The slope of a curve, by differences.
    pure function slope_of(curve, t) result(slope)
        class(curve_function_type), intent(in) :: curve !! any
        real(dp), intent(in) :: t                       !! 0 to 1
        real(dp) :: slope(3), ends(2)
        ends = [max(t - small_step, 0.0_dp), min(t + small_step, 1.0_dp)]
        slope = (curve%at(ends(2)) - curve%at(ends(1)))/(ends(2) - ends(1))
    end function slope_of

end module body_contact
