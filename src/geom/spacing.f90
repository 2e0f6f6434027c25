!> The parameter of a curve over its length, for points at given lengths along it. The speed is
!> known as a polynomial on panels that are halved until it is near enough; integrated it is the
!> length over the parameter, and turned round, once for each panel, the parameter over the length.
!> A point then costs the value of one polynomial.
!>
!> Source: C. W. Clenshaw, A. R. Curtis, "A method for numerical integration on an automatic
!> computer", Numer. Math. 2 (1960), pp. 197-205 (Chebyshev series, their integrals and sums).
module geom_spacing
    use base_constants, only: pi
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use geom_quadrature, only: integrand_type
    implicit none (type, external)
    private

    public :: scale_type, new_scale, parameters_at

    !> Nodes of a panel, and terms of its series.
    integer, parameter :: nodes = 16

    !> A panel.
    type :: panel_type
        real(dp) :: from = 0.0_dp               !! lower parameter
        real(dp) :: to = 0.0_dp                 !! upper parameter
        real(dp) :: length = 0.0_dp             !! of this panel
        logical :: is_good = .false.            !! it is near enough
        logical :: is_slow(2) = .false.         !! the speed is zero at its lower, its upper end
        real(dp) :: term(nodes) = 0.0_dp        !! of the parameter, -1 to 1, over `stretched`
    end type panel_type

    !> The parameter over the length.
    type :: scale_type
        real(dp) :: length = 0.0_dp                     !! of the whole curve
        type(panel_type), allocatable :: panels(:)      !! in order
    end type scale_type

    !> More panels than any curve with a corner or two needs.
    integer, parameter :: most_panels = 400
    !> As many as most curves need.
    integer, parameter :: usual_panels = 8
    !> Steps of Newton's that turn a series round, where this is smooth enough to be used.
    integer, parameter :: most_steps = 12
    !> A speed at an end of a panel, beside its largest term, that is zero.
    real(dp), parameter :: slow = 1.0e-4_dp
    !> Numbers that are worked on at a time: as many as a series is worked out at.
    integer, parameter :: block = nodes

    !> The numbers of the nodes.
    real(dp), parameter :: count_of(nodes) = [1.0_dp, 2.0_dp, 3.0_dp, 4.0_dp, 5.0_dp, 6.0_dp, &
        7.0_dp, 8.0_dp, 9.0_dp, 10.0_dp, 11.0_dp, 12.0_dp, 13.0_dp, 14.0_dp, 15.0_dp, 16.0_dp]
    !> Their angles; the nodes are the cosines, from 1 to -1.
    real(dp), parameter :: angle(nodes) = pi*(count_of - 0.5_dp)/real(nodes, dp)
    real(dp), parameter :: node(nodes) = cos(angle)
    !> What makes the terms of a series, but half of the first, from values at the nodes.
    real(dp), parameter :: transform(nodes, nodes) = 2.0_dp/real(nodes, dp) &
        *cos(spread(count_of - 1.0_dp, 2, nodes)*spread(angle, 1, nodes))

contains

    !> The parameter of a curve over its length, smooth between given parameters. At a corner the
    !> panels are halved until they are shorter than the tolerance has it.
    !> Fails with `cause%no_convergence` where `most_panels` do not reach the tolerance.
    pure subroutine new_scale(f, stops, tolerance, scale, error)
        class(integrand_type), intent(in) :: f              !! its speed, not negative
        real(dp), intent(in) :: stops(:)                    !! parameters, the ends included
        real(dp), intent(in) :: tolerance                   !! relative error asked of each panel
        type(scale_type), intent(out) :: scale              !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(panel_type), allocatable :: panels(:)
        real(dp) :: ahead(most_panels), from, longest
        integer :: count, left

        allocate (panels(usual_panels))
        count = 0
        longest = 0.0_dp
        from = stops(1)
        left = size(stops) - 1
        ahead(:left) = stops(size(stops):2:-1)
        do while (left > 0)
            if (count + left == most_panels) then
                call fail(error, cause%no_convergence, 'the length of a curve is uncertain '// &
                    'after '//to_text(most_panels)//' panels, at parameter '//compact(from))
                return
            end if
            count = count + 1
            if (count > size(panels)) call make_room(panels)
            panels(count) = panel_type(from=from, to=ahead(left))
            call measure(f, tolerance, longest, panels(count))
            if (panels(count)%is_good .or. &
                ahead(left) - from <= tolerance*(stops(size(stops)) - stops(1))) then
                from = ahead(left)
                left = left - 1
            else
                count = count - 1
                ahead(left + 1) = 0.5_dp*(from + ahead(left))
                left = left + 1
            end if
        end do
        scale%panels = panels(:count)
        scale%length = sum(panels(:count)%length)
    end subroutine new_scale

    !> Makes room for as many panels again.
    pure subroutine make_room(panels)
        type(panel_type), allocatable, intent(inout) :: panels(:) !! keeps those it has
        type(panel_type), allocatable :: grown(:)
        allocate (grown(2*size(panels)))
        grown(:size(panels)) = panels
        call move_alloc(grown, panels)
    end subroutine make_room

    !> A panel, and whether it is near enough. One that is not is as if the speed were constant.
    pure subroutine measure(f, tolerance, longest, panel)
        class(integrand_type), intent(in) :: f      !! the speed
        real(dp), intent(in) :: tolerance           !! relative error asked
        real(dp), intent(inout) :: longest          !! length of the longest panel so far
        type(panel_type), intent(inout) :: panel    !! has its ends
        real(dp) :: pace(nodes), speed(nodes), way(nodes), x(nodes), off(nodes), allowed
        integer :: i

        panel%term(2) = 1.0_dp
        call f%values(0.5_dp*(panel%from + panel%to) + 0.5_dp*(panel%to - panel%from)*node, pace)
        speed = series(pace)
        panel%length = (panel%to - panel%from)*sum(pace)/real(nodes, dp)
        longest = max(longest, panel%length)
        panel%is_good = .not. panel%length > tolerance*longest
        if (panel%is_good) return
        allowed = tolerance*longest/panel%length
        if (.not. is_settled(speed, allowed)) return
        way = integral(speed)
        panel%length = 0.5_dp*(panel%to - panel%from)*sum(way)
        x = values(speed, [-1.0_dp, 1.0_dp, (0.0_dp, i=3, nodes)])
        panel%is_slow = x(:2) <= slow*maxval(abs(speed))
        x = node
        do i = 1, most_steps
            off = (values(way, x) - share(panel, node)*sum(way)) &
                /max(values(speed, x), tolerance*maxval(abs(speed)))
            x = min(max(x - off, -1.0_dp), 1.0_dp)
            if (maxval(abs(off)) <= allowed) exit
        end do
        x = series(x)
        panel%is_good = i <= most_steps .and. is_settled(x, allowed)
        if (panel%is_good) panel%term = x
    end subroutine measure

    !> The share of the length of a panel that a number from -1 to 1 stands for. Where the speed is
    !> zero the length begins with a square, over which the parameter would be a root.
    elemental real(dp) function share(panel, y)
        type(panel_type), intent(in) :: panel   !! any
        real(dp), intent(in) :: y               !! -1 to 1
        share = 0.5_dp*(1.0_dp + y)
        if (all(panel%is_slow)) then
            share = sin(0.5_dp*pi*share)**2
        else if (panel%is_slow(1)) then
            share = share**2
        else if (panel%is_slow(2)) then
            share = 1.0_dp - (1.0_dp - share)**2
        end if
    end function share

    !> The number from -1 to 1 that stands for a share of the length of a panel.
    elemental real(dp) function stretched(panel, share) result(y)
        type(panel_type), intent(in) :: panel   !! any
        real(dp), intent(in) :: share           !! 0 to 1
        y = share
        if (all(panel%is_slow)) then
            y = 2.0_dp/pi*asin(sqrt(share))
        else if (panel%is_slow(1)) then
            y = sqrt(share)
        else if (panel%is_slow(2)) then
            y = 1.0_dp - sqrt(1.0_dp - share)
        end if
        y = 2.0_dp*y - 1.0_dp
    end function stretched

    !> The terms of a function by its values at the nodes.
    pure function series(value) result(term)
        real(dp), intent(in) :: value(nodes) !! at the nodes
        real(dp) :: term(nodes)
        integer :: k

        term = 0.0_dp
        do k = 1, nodes
            term = term + transform(:, k)*value(k)
        end do
        term(1) = 0.5_dp*term(1)
    end function series

    !> True where the last terms of a series are nothing beside the first; all terms of a curve that
    !> stands still are nothing.
    pure logical function is_settled(term, tolerance)
        real(dp), intent(in) :: term(nodes) !! of a series
        real(dp), intent(in) :: tolerance   !! relative
        is_settled = maxval(abs(term(nodes - 2:))) <= tolerance*maxval(abs(term))
    end function is_settled

    !> The integral of a series from -1 on. Its last term, which is as small as those left out, is
    !> left out.
    pure function integral(term) result(way)
        real(dp), intent(in) :: term(nodes) !! of the function
        real(dp) :: way(nodes)
        integer :: k

        way(2) = term(1) - 0.5_dp*term(3)
        do k = 2, nodes - 2
            way(k + 1) = (term(k) - term(k + 2))/real(2*k, dp)
        end do
        way(nodes) = term(nodes - 1)/real(2*(nodes - 1), dp)
        way(1) = sum(way(2::2)) - sum(way(3::2))
    end function integral

    !> A series at some numbers from -1 to 1 (Clenshaw), two terms at a time.
    pure function values(term, x) result(value)
        real(dp), intent(in) :: term(nodes) !! of the series
        real(dp), intent(in) :: x(nodes)    !! where
        real(dp) :: value(nodes), next(nodes), after(nodes)
        integer :: k

        next = term(nodes)
        after = 0.0_dp
        do k = nodes - 1, 3, -2
            after = term(k) + 2.0_dp*x*next - after
            next = term(k - 1) + 2.0_dp*x*after - next
        end do
        value = term(1) + x*next - after
    end function values

    !> The parameters at lengths along a curve.
    pure subroutine parameters_at(scale, lengths, t)
        type(scale_type), intent(in) :: scale       !! of the curve
        real(dp), intent(in) :: lengths(:)          !! in ascending order
        real(dp), intent(out) :: t(:)               !! one for each
        real(dp) :: done
        integer :: i, first, last, panel

        done = 0.0_dp
        first = 1
        do panel = 1, size(scale%panels)
            last = first - 1
            do while (last < size(lengths))
                if (lengths(last + 1) > done + scale%panels(panel)%length &
                    .and. panel < size(scale%panels)) exit
                last = last + 1
            end do
            do i = first, last, block
                call place_block(scale%panels(panel), lengths(i:min(i + block - 1, last)) - done, &
                    t(i:min(i + block - 1, last)))
            end do
            first = last + 1
            done = done + scale%panels(panel)%length
        end do
    end subroutine parameters_at

    !> The parameters at some lengths along a panel.
    pure subroutine place_block(panel, length, t)
        type(panel_type), intent(in) :: panel   !! the panel
        real(dp), intent(in) :: length(:)       !! from its beginning, a block of them or less
        real(dp), intent(out) :: t(:)           !! one for each
        real(dp) :: x(block), value(block)

        x = 0.0_dp
        x(:size(length)) = min(max(length, 0.0_dp)/max(panel%length, tiny(1.0_dp)), 1.0_dp)
        x = 2.0_dp*x - 1.0_dp
        if (any(panel%is_slow)) x = stretched(panel, 0.5_dp*(1.0_dp + x))
        value = 0.5_dp*(panel%from + panel%to) &
            + 0.5_dp*(panel%to - panel%from)*values(panel%term, x)
        t = min(max(value(:size(t)), panel%from), panel%to)
    end subroutine place_block

end module geom_spacing
