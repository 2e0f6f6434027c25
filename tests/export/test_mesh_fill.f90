!> Tests of flat faces: every triangle has its corners counter-clockwise, and together they have the
!> area of the polygon.
program test_mesh_fill
    use base_constants, only: pi
    use base_kinds, only: dp
    use export_mesh_fill, only: area_of, bridged, fill_polygon, is_within
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), allocatable :: at(:, :)
    integer, allocatable :: loop(:)
    integer :: i

    at = reshape([0.0_dp, 0.0_dp, 2.0_dp, 0.0_dp, 2.0_dp, 1.0_dp, 0.0_dp, 1.0_dp], [2, 4])
    call tap%near(area_of(at), 4.0_dp, 0.0_dp, 'area_of is twice the area')
    call tap%near(area_of(at(:, 4:1:-1)), -4.0_dp, 0.0_dp, 'negative where it runs clockwise')
    call tap%ok(is_within([1.0_dp, 0.5_dp], at) .and. .not. is_within([2.5_dp, 0.5_dp], at) &
        .and. .not. is_within([1.0_dp, -0.5_dp], at), 'inside and outside')
    call check(at, 'a rectangle')
    at = reshape([(0.0_dp, 0.0_dp, i=1, 202)], [2, 202])
    do i = 1, 202
        at(:, i) = (1.0_dp + 0.9_dp*real(mod(i, 2), dp))*[cos(real(i, dp)*pi/101.0_dp), &
            sin(real(i, dp)*pi/101.0_dp)]
    end do
    call check(at, 'a star of 101 points')
    at = comb(40)
    call check(at, 'a comb of 40 teeth')
    at = spiral(60)
    call check(at, 'a spiral')
    ! A square with 25 points on each side, and a half circle on its diameter.
    at = square(25)
    call check(at, 'a square with many points in line')
    at = reshape([(0.0_dp, 0.0_dp, i=1, 60)], [2, 60])
    do i = 1, 40
        at(:, i) = 50.0_dp*[sin(real(i - 1, dp)*pi/39.0_dp), -cos(real(i - 1, dp)*pi/39.0_dp)]
    end do
    at(1, [1, 40]) = 0.0_dp
    do i = 41, 60
        at(:, i) = [0.0_dp, 50.0_dp - 100.0_dp*real(i - 40, dp)/21.0_dp]
    end do
    call check(at, 'a half section with points in BL 0')
    ! A ring: 24 corners outside, 16 inside, the hole clockwise.
    at = reshape([(0.0_dp, 0.0_dp, i=1, 40)], [2, 40])
    do i = 1, 24
        at(:, i) = 10.0_dp*[cos(real(i, dp)*pi/12.0_dp), sin(real(i, dp)*pi/12.0_dp)]
    end do
    do i = 1, 16
        at(:, 24 + i) = [3.0_dp, 1.0_dp] + 5.0_dp*[cos(real(i, dp)*pi/8.0_dp), &
            -sin(real(i, dp)*pi/8.0_dp)]
    end do
    allocate (loop(0))
    loop = bridged(at, [(i, i=1, 24)], [(i, i=25, 40)])
    call tap%ok(size(loop) == 42, 'a bridge adds two corners')
    call check(at(:, loop), 'a ring')
    ! A hole behind a notch: the nearest corner of the outer loop cannot be seen from it.
    at = reshape([0.0_dp, 0.0_dp, 10.0_dp, 0.0_dp, 10.0_dp, 10.0_dp, 6.2_dp, 10.0_dp, 6.2_dp, &
        1.0_dp, 6.1_dp, 10.0_dp, 0.0_dp, 10.0_dp, 4.0_dp, 4.0_dp, 4.0_dp, 6.0_dp, 6.0_dp, &
        5.0_dp], [2, 10])
    loop = bridged(at, [(i, i=1, 7)], [8, 9, 10])
    call check(at(:, loop), 'a hole beside a notch')
    at = at(:, :2)
    call tap%ok(size(fill_polygon(at), 2) == 0, 'two corners make no triangle')
    at = reshape([0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 2.0_dp, 0.0_dp, 3.0_dp, 0.0_dp], [2, 4])
    call tap%ok(size(fill_polygon(at), 2) == 2, 'a polygon without area still gets triangles')
    call tap%finish()

contains

    !> A polygon is filled: all corners used, all triangles counter-clockwise, areas add up.
    subroutine check(at, name)
        real(dp), intent(in) :: at(:, :)
        character(*), intent(in) :: name
        integer :: triangles(3, size(at, 2) - 2), i
        real(dp) :: area, least, part
        triangles = fill_polygon(at)
        area = 0.0_dp
        least = huge(least)
        do i = 1, size(triangles, 2)
            part = area_of(at(:, triangles(:, i)))
            area = area + part
            least = min(least, part)
        end do
        call tap%near(area, area_of(at), 1.0e-12_dp*area_of(at), name//': areas add up')
        call tap%ok(least > 0.0_dp, name//': no triangle is turned over or flat')
        call tap%ok(all([(any(triangles == i), i=1, size(at, 2))]), name//': no corner is lost')
    end subroutine check

    !> A comb with its teeth upwards.
    function comb(teeth) result(at)
        integer, intent(in) :: teeth
        real(dp) :: at(2, 2*teeth + 2)
        integer :: i
        at(:, 1) = [0.0_dp, -1.0_dp]
        at(:, 2) = [real(2*teeth, dp), -1.0_dp]
        do i = 1, 2*teeth
            at(:, i + 2) = [real(2*teeth - i, dp), real(10*mod(i, 2), dp)]
        end do
    end function comb

    !> A band wound up.
    function spiral(steps) result(at)
        integer, intent(in) :: steps
        real(dp) :: at(2, 2*steps), angle
        integer :: i
        do i = 1, steps
            angle = 0.2_dp*real(i, dp)
            at(:, i) = (1.0_dp + angle)*[cos(angle), sin(angle)]
            at(:, 2*steps + 1 - i) = (0.3_dp + angle)*[cos(angle), sin(angle)]
        end do
    end function spiral

    !> A square with a count of points on each side.
    function square(count) result(at)
        integer, intent(in) :: count
        real(dp) :: at(2, 4*count), way
        integer :: i
        do i = 1, count
            way = real(i - 1, dp)/real(count, dp)
            at(:, i) = [way, 0.0_dp]
            at(:, count + i) = [1.0_dp, way]
            at(:, 2*count + i) = [1.0_dp - way, 1.0_dp]
            at(:, 3*count + i) = [0.0_dp, 1.0_dp - way]
        end do
    end function square

end program test_mesh_fill
