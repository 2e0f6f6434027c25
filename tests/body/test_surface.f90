!> F of a section against the surface it belongs to: its gradient along the normal of an ellipsoid,
!> its second derivatives by differences.
program test_surface
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: section_arc
    use body_surface, only: form_along, gradient_at, patch_at, patch_type
    use body_taylor, only: taylor_type
    use geom_arc, only: arc_type
    use support_bodies, only: ellipsoid, nose_of_the_book
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    real(dp) :: g(3), n(3)
    type(taylor_type) :: f

    body = ellipsoid([5.0_dp, 2.0_dp, 1.0_dp], 100.0_dp, 7.0_dp)
    f = form_along(patch(1, 103.0_dp), [0.96_dp, 7.0_dp - 0.64_dp], [0.0_dp, 0.0_dp, 1.0_dp])
    call tap%near(f%value, 0.0_dp, 1.0e-15_dp, 'F is zero on the ellipsoid')
    g = gradient_at(patch(1, 103.0_dp), [0.96_dp, 7.0_dp - 0.64_dp])
    n = [3.0_dp/25.0_dp, 0.96_dp/4.0_dp, -0.64_dp]
    call tap%near(norm2(g/norm2(g) - sign(1.0_dp, g(1))*n/norm2(n)), 0.0_dp, 2.0e-14_dp, &
        'its gradient is along the normal')
    body = nose_of_the_book()
    call check_differences([1.0_dp, 0.0_dp, 0.0_dp], 'STA')
    call check_differences([0.0_dp, 1.0_dp, 0.0_dp], 'BL')
    call check_differences([0.6_dp, 0.0_dp, 0.8_dp], 'a slant in a buttock')
    call check_differences([0.48_dp, 0.6_dp, 0.64_dp], 'a slant in space')
    call tap%finish()

contains

    !> A section about a station.
    function patch(section, sta)
        integer, intent(in) :: section
        real(dp), intent(in) :: sta
        type(patch_type) :: patch
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        call section_arc(body%lines, body%sections(section), sta, arc, error)
        patch = patch_at(body%lines, body%sections(section), sta, arc)
    end function patch

    !> Derivatives along a way against central differences of values, which are of other patches.
    subroutine check_differences(way, name)
        real(dp), intent(in) :: way(3)
        character(*), intent(in) :: name
        real(dp), parameter :: at(3) = [10.0_dp, 11.0_dp, -17.0_dp], h = 1.0e-3_dp
        type(taylor_type) :: here
        real(dp) :: value(-1:1)
        integer :: i
        here = form_along(patch(1, at(1)), at(2:), way)
        do i = -1, 1
            value(i) = value_at(at + real(i, dp)*h*way)
        end do
        call tap%near((value(1) - value(-1))/(2.0_dp*h*here%first), 1.0_dp, 1.0e-5_dp, &
            'the slope of F along '//name)
        call tap%near((value(1) - 2.0_dp*value(0) + value(-1))/(h**2*here%second), 1.0_dp, &
            1.0e-4_dp, &
            'the second derivative of F along '//name)
    end subroutine check_differences

    !> F at a point, to the scale of the section at station 10.
    real(dp) function value_at(p) result(value)
        real(dp), intent(in) :: p(3)
        type(patch_type) :: here, there
        type(taylor_type) :: form
        here = patch(1, 10.0_dp)
        there = patch(1, p(1))
        there%size = here%size
        form = form_along(there, p(2:), [0.0_dp, 0.0_dp, 0.0_dp])
        value = form%value
    end function value_at

end program test_surface
