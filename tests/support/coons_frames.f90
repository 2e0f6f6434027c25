!> Frames cut out of surfaces that are known in closed form.
module support_coons_frames
    use base_kinds, only: dp
    use geom_coons, only: frame_type
    implicit none (type, external)
    private

    public :: seed_frame_type, seed_surface, power_frame_type, power_jet, broken_frame_type

    !> The sides of Q = (u + .1 v (1 - v), v, exp(u) sin(2 v) + u**6 v**5).
    type, extends(frame_type) :: seed_frame_type
    contains
        procedure :: side_u => seed_side_u
        procedure :: side_v => seed_side_v
    end type seed_frame_type

    !> The sides of a polynomial surface, sum of c(:, k, l) u**k v**l.
    type, extends(frame_type) :: power_frame_type
        real(dp), allocatable :: c(:, :, :)     !! (3, 0:m, 0:n) numbered from 1
        logical :: is_swapped = .false.         !! u and v are exchanged
    contains
        procedure :: side_u => power_side_u
        procedure :: side_v => power_side_v
    end type power_frame_type

    !> The sides of a plane square, of which one is moved and one has another cross slope.
    type, extends(frame_type) :: broken_frame_type
        real(dp) :: gap = 0.0_dp                !! of the end of side v = 1 at u = 1, along WL
        real(dp) :: twist = 0.0_dp              !! of the side u = 0, along WL
    contains
        procedure :: side_u => broken_side_u
        procedure :: side_v => broken_side_v
    end type broken_frame_type

contains

    !> The derivative of the seed's surface by u (a times) and v (b times).
    pure function seed_surface(u, v, a, b) result(q)
        real(dp), intent(in) :: u   !! parameter
        real(dp), intent(in) :: v   !! parameter
        integer, intent(in) :: a    !! 0 to 2
        integer, intent(in) :: b    !! 0 to 2
        real(dp) :: q(3), bow(0:2), sine(0:2), sixth(0:2), fifth(0:2)

        bow = [0.1_dp*v*(1.0_dp - v), 0.1_dp*(1.0_dp - 2.0_dp*v), -0.2_dp]
        sine = [sin(2.0_dp*v), 2.0_dp*cos(2.0_dp*v), -4.0_dp*sin(2.0_dp*v)]
        sixth = [u**6, 6.0_dp*u**5, 30.0_dp*u**4]
        fifth = [v**5, 5.0_dp*v**4, 20.0_dp*v**3]
        q = 0.0_dp
        if (a == 0) q(1) = bow(b)
        if (a == 0 .and. b == 0) q(1:2) = [u + bow(0), v]
        if (a == 1 .and. b == 0) q(1) = 1.0_dp
        if (a == 0 .and. b == 1) q(2) = 1.0_dp
        q(3) = exp(u)*sine(b) + sixth(a)*fifth(b)
    end function seed_surface

    !> A side u = 0 or 1 of the seed's surface.
    pure function seed_side_u(f, side, t) result(jet)
        class(seed_frame_type), intent(in) :: f !! the frame
        integer, intent(in) :: side             !! 0 or 1
        real(dp), intent(in) :: t               !! v
        real(dp) :: jet(3, 0:2, 0:2)
        integer :: a, b
        if (.false.) jet = merge(1.0_dp, 0.0_dp, same_type_as(f, f))
        do b = 0, 2
            do a = 0, 2
                jet(:, a, b) = seed_surface(real(side, dp), t, a, b)
            end do
        end do
    end function seed_side_u

    !> A side v = 0 or 1 of the seed's surface.
    pure function seed_side_v(f, side, t) result(jet)
        class(seed_frame_type), intent(in) :: f !! the frame
        integer, intent(in) :: side             !! 0 or 1
        real(dp), intent(in) :: t               !! u
        real(dp) :: jet(3, 0:2, 0:2)
        integer :: a, b
        if (.false.) jet = merge(1.0_dp, 0.0_dp, same_type_as(f, f))
        do b = 0, 2
            do a = 0, 2
                jet(:, b, a) = seed_surface(t, real(side, dp), a, b)
            end do
        end do
    end function seed_side_v

    !> The derivative of a polynomial surface by u (a times) and v (b times).
    pure function power_jet(c, u, v, a, b) result(q)
        real(dp), intent(in) :: c(:, :, :)  !! coefficients
        real(dp), intent(in) :: u           !! parameter
        real(dp), intent(in) :: v           !! parameter
        integer, intent(in) :: a            !! 0 to 2
        integer, intent(in) :: b            !! 0 to 2
        real(dp) :: q(3)
        integer :: k, l

        q = 0.0_dp
        do l = b, size(c, 3) - 1
            do k = a, size(c, 2) - 1
                q = q + c(:, k + 1, l + 1)*fallen(k, a)*fallen(l, b)*u**(k - a)*v**(l - b)
            end do
        end do
    end function power_jet

    !> k (k - 1) ... of some factors.
    pure real(dp) function fallen(k, factors)
        integer, intent(in) :: k        !! the first
        integer, intent(in) :: factors  !! how many
        integer :: i
        fallen = product([(real(k - i, dp), i = 0, factors - 1)])
    end function fallen

    !> A side u = 0 or 1 of a polynomial surface.
    pure function power_side_u(f, side, t) result(jet)
        class(power_frame_type), intent(in) :: f    !! the frame
        integer, intent(in) :: side                 !! 0 or 1
        real(dp), intent(in) :: t                   !! v
        real(dp) :: jet(3, 0:2, 0:2)
        integer :: a, b
        do b = 0, 2
            do a = 0, 2
                if (f%is_swapped) then
                    jet(:, a, b) = power_jet(f%c, t, real(side, dp), b, a)
                else
                    jet(:, a, b) = power_jet(f%c, real(side, dp), t, a, b)
                end if
            end do
        end do
    end function power_side_u

    !> A side v = 0 or 1 of a polynomial surface.
    pure function power_side_v(f, side, t) result(jet)
        class(power_frame_type), intent(in) :: f    !! the frame
        integer, intent(in) :: side                 !! 0 or 1
        real(dp), intent(in) :: t                   !! u
        real(dp) :: jet(3, 0:2, 0:2)
        integer :: a, b
        do b = 0, 2
            do a = 0, 2
                if (f%is_swapped) then
                    jet(:, a, b) = power_jet(f%c, real(side, dp), t, a, b)
                else
                    jet(:, a, b) = power_jet(f%c, t, real(side, dp), b, a)
                end if
            end do
        end do
    end function power_side_v

    !> A side u = 0 or 1 of the broken square.
    pure function broken_side_u(f, side, t) result(jet)
        class(broken_frame_type), intent(in) :: f   !! the frame
        integer, intent(in) :: side                 !! 0 or 1
        real(dp), intent(in) :: t                   !! v
        real(dp) :: jet(3, 0:2, 0:2)
        jet = 0.0_dp
        jet(:, 0, 0) = [real(side, dp), t, 0.0_dp]
        jet(:, 0, 1) = [0.0_dp, 1.0_dp, 0.0_dp]
        jet(:, 1, 0) = [1.0_dp, 0.0_dp, 0.0_dp]
        if (side == 0) jet(3, 1, 0) = f%twist*t*(1.0_dp - t)
        if (side == 0) jet(3, 1, 1) = f%twist*(1.0_dp - 2.0_dp*t)
    end function broken_side_u

    !> A side v = 0 or 1 of the broken square.
    pure function broken_side_v(f, side, t) result(jet)
        class(broken_frame_type), intent(in) :: f   !! the frame
        integer, intent(in) :: side                 !! 0 or 1
        real(dp), intent(in) :: t                   !! u
        real(dp) :: jet(3, 0:2, 0:2)
        jet = 0.0_dp
        jet(:, 0, 0) = [t, real(side, dp), real(side, dp)*f%gap*t]
        jet(:, 0, 1) = [1.0_dp, 0.0_dp, real(side, dp)*f%gap]
        jet(:, 1, 0) = [0.0_dp, 1.0_dp, 0.0_dp]
    end function broken_side_v

end module support_coons_frames
