!> Numbers in order: short lists as worked by hand, and a long one.
program test_order
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_order, only: ascending, each_once, order_of, rising
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), parameter :: mixed(7) = [3.0_dp, -1.0_dp, 3.0_dp, 0.0_dp, -1.0_dp, 9.0_dp, 0.5_dp]
    real(dp), parameter :: none(0) = [real(dp) :: ]
    real(dp), allocatable :: many(:), sorted(:)
    integer, allocatable :: order(:)
    integer :: i

    call tap%ok(all(order_of(mixed) == [2, 5, 4, 7, 1, 3, 6]), 'equal numbers keep their order')
    call tap%ok(all(is_equal(ascending(mixed), [-1.0_dp, -1.0_dp, 0.0_dp, 0.5_dp, 3.0_dp, 3.0_dp, &
        9.0_dp])), 'numbers are put in ascending order')
    call tap%ok(all(is_equal(rising(mixed), [-1.0_dp, 0.0_dp, 0.5_dp, 3.0_dp, 9.0_dp])), &
        'each number is once in a rising list')
    call tap%ok(all(is_equal(each_once(mixed), [3.0_dp, -1.0_dp, 0.0_dp, 9.0_dp, 0.5_dp])), &
        'what is kept once keeps its place')
    call tap%ok(size(each_once([0.0_dp, -0.0_dp, 0.0_dp])) == 1, 'zeros of either sign are one')
    call tap%ok(size(order_of(none)) + size(ascending(none)) + size(rising(none)) &
        + size(each_once(none)) == 0, 'nothing stays nothing')
    call tap%ok(all(order_of([5.0_dp]) == [1]), 'one number is in order')

    ! 48271 generates all numbers below the prime 2**31 - 1 (Park and Miller): all differ here.
    allocate (many(300000), sorted(300000), order(300000))
    many(1) = 1.0_dp
    do i = 2, size(many)
        many(i) = modulo(48271.0_dp*many(i - 1), 2147483647.0_dp)
    end do
    order = order_of(many)
    sorted = many(order)
    call tap%ok(all(sorted(2:) > sorted(:size(sorted) - 1)), '300000 numbers come out in order')
    call tap%ok(size(rising(real(order, dp))) == size(many) .and. minval(order) == 1 &
        .and. maxval(order) == size(many), 'every place is there once')
    call tap%ok(size(each_once([many, many])) == size(many), 'a list said twice is kept once')
    call tap%ok(all(order_of(reshape([2.0_dp, 1.0_dp, 1.0_dp, 9.0_dp, 2.0_dp, 1.0_dp, 1.0_dp, &
        3.0_dp], [2, 4])) == [4, 2, 1, 3]), &
        'columns are in the order of a dictionary, equal ones as they were')
    call tap%finish()
end program test_order
