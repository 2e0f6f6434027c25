!> Vectors in space.
module geom_space
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: across, angle_between

contains

    !> The vector product a x b.
    pure function across(a, b) result(c)
        real(dp), intent(in) :: a(3) !! any vector
        real(dp), intent(in) :: b(3) !! any vector
        real(dp) :: c(3)
        c = cshift(a, 1)*cshift(b, 2) - cshift(a, 2)*cshift(b, 1)
    end function across

    !> The angle between two normals, radians; 0 where one is none.
    pure real(dp) function angle_between(first, second) result(angle)
        real(dp), intent(in) :: first(3)    !! of unit length, or zero
        real(dp), intent(in) :: second(3)   !! of unit length, or zero
        angle = 0.0_dp
        if (.not. (norm2(first) > 0.0_dp .and. norm2(second) > 0.0_dp)) return
        angle = 2.0_dp*asin(min(1.0_dp, 0.5_dp*norm2(first - second)))
    end function angle_between

end module geom_space
