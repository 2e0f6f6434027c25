!> Random arcs for tests: of all kinds, either way round, near and far from the origin.
module support_random_arcs
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type
    use support_random, only: random_type
    implicit none (type, external)
    private

    public :: next_arc

contains

    !> The next random arc. Its coordinates have three decimals, as cards have them.
    subroutine next_arc(random, arc)
        type(random_type), intent(inout) :: random !! the stream
        type(arc_type), intent(out) :: arc         !! the arc
        type(error_type), allocatable :: error
        real(dp) :: start(2), corner(2), finish(2), shoulder(2), rho, far

        do
            far = 10.0_dp**random%between(0.0_dp, 3.0_dp)
            start = decimals([random%between(-far, far), random%between(-far, far)])
            corner = decimals(start + [random%between(-50.0_dp, 50.0_dp), &
                random%between(-50.0_dp, 50.0_dp)])
            finish = decimals(start + [random%between(-90.0_dp, 90.0_dp), &
                random%between(-90.0_dp, 90.0_dp)])
            if (random%one_in(8)) corner(1) = start(1)
            if (random%one_in(8)) finish(2) = corner(2)
            rho = random%between(0.02_dp, 0.98_dp)
            if (random%one_in(8)) rho = -random%between(0.1_dp, 3.0_dp)
            shoulder = 0.5_dp*(start + finish)
            shoulder = decimals(shoulder + rho*(corner - shoulder))
            call arc_through(end_type(start, corner - start), shoulder, &
                end_type(finish, finish - corner), arc, error)
            if (.not. allocated(error)) return
            deallocate (error)
        end do
    end subroutine next_arc

    !> Numbers rounded to three decimals.
    elemental real(dp) function decimals(x)
        real(dp), intent(in) :: x !! any number
        decimals = anint(1000.0_dp*x)/1000.0_dp
    end function decimals

end module support_random_arcs
