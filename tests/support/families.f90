!> Families of functions whose integrals are known, for sets of integrals.
module support_families
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use geom_integral_set, only: integrand_set_type
    implicit none (type, external)
    private

    !> Powers of t from 0 on.
    type, public, extends(integrand_set_type) :: powers_type
    contains
        procedure :: at => powers_at
    end type powers_type

    !> The sine, the root of |t - 1/3|, and 1/(1 + 25 t**2).
    type, public, extends(integrand_set_type) :: rough_type
    contains
        procedure :: at => rough_at
    end type rough_type

    !> 1/t; it fails at t above 1.
    type, public, extends(integrand_set_type) :: pole_type
    contains
        procedure :: at => pole_at
    end type pole_type

contains

    pure subroutine powers_at(f, t, value, error)
        class(powers_type), intent(in) :: f
        real(dp), intent(in) :: t
        real(dp), intent(out) :: value(:)
        type(error_type), allocatable, intent(out) :: error
        integer :: i
        value = [(t**i, i=0, f%number - 1)]
        if (allocated(error)) deallocate (error)
    end subroutine powers_at

    pure subroutine rough_at(f, t, value, error)
        class(rough_type), intent(in) :: f
        real(dp), intent(in) :: t
        real(dp), intent(out) :: value(:)
        type(error_type), allocatable, intent(out) :: error
        value(:f%number) = [sin(t), sqrt(abs(t - 1.0_dp/3.0_dp)), 1.0_dp/(1.0_dp + 25.0_dp*t**2)]
        if (allocated(error)) deallocate (error)
    end subroutine rough_at

    pure subroutine pole_at(f, t, value, error)
        class(pole_type), intent(in) :: f
        real(dp), intent(in) :: t
        real(dp), intent(out) :: value(:)
        type(error_type), allocatable, intent(out) :: error
        value(:f%number) = 1.0_dp/t
        if (t > 1.0_dp) call fail(error, cause%no_arc, 'beyond 1')
    end subroutine pole_at

end module support_families
