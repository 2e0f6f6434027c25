!> Ducts for the tests: outlines whose vertices are given, so that they are known exactly; cuts.
module support_ducts
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_duct, only: duct_type, new_duct
    use body_outline, only: outline_type
    use body_panel, only: panel_type
    use cut_outline, only: cut_type
    use cut_panel, only: cut_panels
    use cut_plane, only: plane_type
    use cut_request, only: request_type
    use geom_fairing_system, only: spline_area
    implicit none (type, external)
    private

    public :: outline_of, duct_through, wheel, s_duct, cut_of, off_ring

contains

    !> The outline of some vertices.
    function outline_of(name, sta, vertex) result(outline)
        character(*), intent(in) :: name
        real(dp), intent(in) :: sta, vertex(:, :)
        type(outline_type) :: outline
        outline%name = name
        outline%sta = sta
        outline%fairing%is_closed = .true.
        allocate (outline%fairing%vertex, source=vertex)
        outline%fairing%area = spline_area(vertex, .true.)
    end function outline_of

    !> A duct that must be made.
    function duct_through(outlines) result(duct)
        type(outline_type), intent(in) :: outlines(:)
        type(duct_type) :: duct
        type(error_type), allocatable :: error
        integer :: number
        call new_duct('DUCT', outlines, duct, number, error)
        if (allocated(error)) error stop 'a duct of a test is none'
    end function duct_through

    !> Vertices on an ellipse, counter-clockwise from an angle: of a circle the ring is a circle of
    !> radius (2 + cos(2 pi/n))/3 times as large, but for a wave.
    function wheel(number, axes, centre, begin) result(vertex)
        integer, intent(in) :: number
        real(dp), intent(in) :: axes(2), centre(2), begin
        real(dp) :: vertex(2, number), angle(number)
        integer :: i
        angle = begin + [(2.0_dp*pi*real(i, dp)/real(number, dp), i = 0, number - 1)]
        vertex(1, :) = centre(1) + axes(1)*cos(angle)
        vertex(2, :) = centre(2) + axes(2)*sin(angle)
    end function wheel

    !> A duct that widens, rises and goes to starboard, through four outlines of 12 vertices.
    function s_duct() result(duct)
        type(duct_type) :: duct
        duct = duct_through([outline_of('A', 10.0_dp, wheel(12, [5.0_dp, 3.0_dp], [20.0_dp, &
            0.0_dp], 0.0_dp)), outline_of('B', 16.0_dp, wheel(12, [4.0_dp, 4.0_dp], [20.0_dp, &
            1.0_dp], 0.1_dp)), outline_of('C', 30.0_dp, wheel(12, [4.5_dp, 5.0_dp], [22.0_dp, &
            6.0_dp], 0.2_dp)), outline_of('D', 44.0_dp, wheel(12, [6.0_dp, 6.0_dp], [24.0_dp, &
            8.0_dp], 0.2_dp))])
    end function s_duct

    !> A cut of a duct; its outlines as listed.
    function cut_of(panel, plane, is_symmetric) result(cut)
        type(panel_type), intent(in) :: panel
        type(plane_type), intent(in) :: plane
        logical, intent(in) :: is_symmetric
        type(cut_type) :: cut
        type(request_type) :: request
        type(error_type), allocatable :: error
        request%plane = plane
        call cut_panels([panel], 0, is_symmetric, request, cut, error)
        if (allocated(error)) error stop 'a cut of a test failed'
    end function cut_of

    !> The distance of a point from a ring, by its powers: nearest of many, then Newton's steps.
    pure real(dp) function off_ring(ring, point) result(off)
        real(dp), intent(in) :: ring(:, :), point(2)
        real(dp) :: t, at(2, 0:2)
        integer :: i, n, best
        n = size(ring, 2)
        off = huge(1.0_dp)
        best = 0
        do i = 0, 20*n - 1
            at = ring_jet(ring, real(i, dp)/20.0_dp)
            if (norm2(at(:, 0) - point) >= off) cycle
            off = norm2(at(:, 0) - point)
            best = i
        end do
        t = real(best, dp)/20.0_dp
        do i = 1, 8
            at = ring_jet(ring, t)
            t = t - dot_product(at(:, 0) - point, at(:, 1))/(dot_product(at(:, 1), at(:, 1)) &
                + dot_product(at(:, 0) - point, at(:, 2)))
        end do
        at = ring_jet(ring, t)
        off = norm2(at(:, 0) - point)
    end function off_ring

    !> A point of a ring with its derivatives, by powers.
    pure function ring_jet(ring, t) result(jet)
        real(dp), intent(in) :: ring(:, :), t
        real(dp) :: jet(2, 0:2), u, share(4, 0:2)
        integer :: segment, k
        segment = floor(t)
        u = t - real(segment, dp)
        share(:, 0) = [(1.0_dp - u)**3, 3.0_dp*u**3 - 6.0_dp*u**2 + 4.0_dp, &
            -3.0_dp*u**3 + 3.0_dp*u**2 + 3.0_dp*u + 1.0_dp, u**3]/6.0_dp
        share(:, 1) = [-(1.0_dp - u)**2, 3.0_dp*u**2 - 4.0_dp*u, &
            -3.0_dp*u**2 + 2.0_dp*u + 1.0_dp, u**2]/2.0_dp
        share(:, 2) = [1.0_dp - u, 3.0_dp*u - 2.0_dp, -3.0_dp*u + 1.0_dp, u]
        jet = 0.0_dp
        do k = 1, 4
            jet = jet + spread(ring(:, 1 + modulo(segment + k - 1, size(ring, 2))), 2, 3)* &
                spread(share(k, :), 1, 2)
        end do
    end function ring_jet

end module support_ducts
