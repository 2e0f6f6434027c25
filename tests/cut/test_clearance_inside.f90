!> Points inside and outside of sections.
program test_clearance_inside
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use cut_clearance_inside, only: test_inside
    use support_random, only: random_type
    use support_solids, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: axes(3) = [10.0_dp, 3.0_dp, 2.0_dp]
    type(tap_type) :: tap
    type(body_type) :: body, half
    logical :: is_known, is_inside

    half = ellipsoid(axes)
    body = half
    call check_random('a symmetric ellipsoid')
    body = mirrored_body(half)
    call check_random('an ellipsoid of four quarters')
    body%sections = body%sections([3, 4])
    call test_inside(body, [0.0_dp, -1.0_dp, 0.5_dp], is_known, is_inside)
    call tap%ok(is_known .and. is_inside, 'in the port half alone')
    call test_inside(body, [0.0_dp, 1.0_dp, 0.5_dp], is_known, is_inside)
    call tap%ok(is_known .and. .not. is_inside, 'to starboard of the port half')
    call test_inside(body, [0.0_dp, -3.5_dp, 0.5_dp], is_known, is_inside)
    call tap%ok(is_known .and. .not. is_inside, 'to port of it')
    call test_inside(body, [10.5_dp, 0.0_dp, 0.0_dp], is_known, is_inside)
    call tap%ok(.not. (is_known .or. is_inside), 'behind the body nothing is known')
    body%sections = body%sections(:1)
    call test_inside(body, [0.0_dp, -1.0_dp, 0.5_dp], is_known, is_inside)
    call tap%ok(.not. (is_known .or. is_inside), 'nor of an open section')
    body = half
    body%sections(1)%line = [1, 1, 3]
    call test_inside(body, [0.0_dp, -1.0_dp, 0.5_dp], is_known, is_inside)
    call tap%ok(.not. (is_known .or. is_inside), 'nor of one that has no arc')
    call tap%finish()

contains

    !> Checks random points, and some on the axes, against the ellipsoid's equation.
    subroutine check_random(name)
        character(*), intent(in) :: name
        type(random_type) :: random
        real(dp) :: p(3)
        integer :: i, wrong
        wrong = 0
        do i = 1, 1000
            p = axes*[random%between(-0.9_dp, 0.9_dp), random%between(-1.2_dp, 1.2_dp), &
                random%between(-1.2_dp, 1.2_dp)]
            if (modulo(i, 7) == 0) p(2) = 0.0_dp
            if (modulo(i, 5) == 0) p(3) = 0.0_dp
            call test_inside(body, p, is_known, is_inside)
            if (.not. is_known .or. (is_inside .neqv. norm2(p/axes) < 1.0_dp)) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, '1000 points of '//name)
    end subroutine check_random

end program test_clearance_inside
