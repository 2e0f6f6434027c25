!> Lists that grow.
program test_list
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_list, only: list_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(list_type) :: list, long
    integer :: i, grown, room

    call tap%ok(size(list%all()) == 0, 'a new list is empty')
    call list%add(3.0_dp)
    call list%add([1.0_dp, 2.0_dp])
    call list%add([real(dp) :: ])
    call list%add(3.0_dp)
    call tap%ok(size(list%all()) == 4, 'as many as were added are held')
    call tap%ok(all(is_equal(list%all(), [3.0_dp, 1.0_dp, 2.0_dp, 3.0_dp])), 'in their order')
    call list%add([(real(i, dp), i=1, 100)])
    call tap%ok(list%count == 104, 'many are added at once')
    call tap%ok(all(is_equal(list%item(5:104), [(real(i, dp), i=1, 100)])), 'in their order, too')

    grown = 0
    room = 0
    do i = 1, 100000
        call long%add(real(i, dp))
        if (size(long%item) /= room) grown = grown + 1
        room = size(long%item)
    end do
    call tap%ok(all(is_equal(long%all(), [(real(i, dp), i=1, 100000)])), 'one hundred thousand')
    call tap%ok(grown <= 20, 'they were moved a few times only')
    call tap%finish()
end program test_list
